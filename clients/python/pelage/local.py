"""A private server."""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import weakref
from typing import Callable, List, Optional, Sequence

from .errors import NotStarted
from .files import Path
from .server import Server

PROGRAM = "pelaged"
PROGRAM_VARIABLE = "PELAGE_SERVER_PROGRAM"
LOG_END = 2000  # characters at the end of the log that an exception quotes
STOP_SECONDS = 30.0


class LocalServer(Server):
    """A server of this process alone, on a free loopback port. It stops at `close`, at the end of a `with`, when nobody
    holds this object any more, and when Python ends.

    folder: Where it prints to `log`, and keeps its scenes unless they have a folder of their own.
    """

    def __init__(self, program: str, arguments: Sequence[str], data: Optional[Path], seconds: float) -> None:
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="pelage-"))
        try:
            process = self._start(program, arguments, data)
        except OSError as error:
            shutil.rmtree(self.folder, ignore_errors=True)
            raise NotStarted(f"{program} cannot be run: {error}") from error
        self._stop = weakref.finalize(self, stop, process, self.folder)
        try:
            super().__init__(f"http://127.0.0.1:{self._port(process, seconds)}")
            self._wait_until_ready(process, seconds)
        except BaseException:
            self._stop()
            raise

    def close(self) -> None:
        """Stops the server and removes its folder; scenes in a folder of their own stay."""
        super().close()
        self._stop()

    def log(self) -> str:
        """What the server has printed."""
        return (self.folder / "log").read_text(encoding="utf-8", errors="replace")

    def _start(self, program: str, arguments: Sequence[str], data: Optional[Path]) -> subprocess.Popen[bytes]:
        where = os.fspath(data) if data is not None else str(self.folder / "data")
        command: List[str] = [program, "--listen", "127.0.0.1:0", "--port-file", str(self.folder / "port")]
        with open(self.folder / "log", "wb") as log:
            return subprocess.Popen(
                [*command, "--data", where, *arguments],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def _port(self, process: subprocess.Popen[bytes], seconds: float) -> int:
        file = self.folder / "port"
        self._wait(process, file.exists, seconds)
        return int(file.read_text())

    def _wait_until_ready(self, process: subprocess.Popen[bytes], seconds: float) -> None:
        self._wait(process, self.is_ready, seconds)

    def _wait(self, process: subprocess.Popen[bytes], done: Callable[[], bool], seconds: float) -> None:
        deadline = time.monotonic() + seconds
        while not done():
            if process.poll() is not None:
                raise NotStarted(f"pelaged ended with {process.returncode}; it printed:\n{self.log()[-LOG_END:]}")
            if time.monotonic() > deadline:
                raise NotStarted(f"pelaged is not ready after {seconds:g} s; it printed:\n{self.log()[-LOG_END:]}")
            time.sleep(0.02)


def local(
    program: Optional[Path] = None,
    *,
    arguments: Sequence[str] = (),
    data: Optional[Path] = None,
    seconds: float = 60.0,
) -> LocalServer:
    """Starts a private `pelaged` and waits until it takes work.

    program: Its path; PELAGE_SERVER_PROGRAM, else the one on the PATH, unless given.
    arguments: More options for it, such as ["--threads", "4"]; `pelaged --help` lists them.
    data: Folder of its scenes, which stays; a temporary one unless given.
    seconds: How long it may take to start.
    Raises NotStarted.
    """
    wanted = os.fspath(program) if program is not None else os.environ.get(PROGRAM_VARIABLE, PROGRAM)
    found = shutil.which(wanted)
    if found is None:
        raise NotStarted(f"There is no program {wanted}; give its path, or set {PROGRAM_VARIABLE} or PATH")
    return LocalServer(found, arguments, data, seconds)


def stop(process: subprocess.Popen[bytes], folder: pathlib.Path) -> None:
    """Ends a process, at first gently, and removes its folder."""
    process.terminate()
    try:
        process.wait(STOP_SECONDS)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    shutil.rmtree(folder, ignore_errors=True)
