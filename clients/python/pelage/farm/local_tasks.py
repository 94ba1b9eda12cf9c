"""The engine `local`: runs several pelage-render processes on this machine until all chunks were tried."""

from __future__ import annotations

import signal
import subprocess
import threading
from typing import Callable, Dict, List, Sequence

from .folder import FarmFolder

STOP_SECONDS = 30.0


class LocalTasks:
    """Runs chunks, `at_once` in parallel, each with a log in logs/N.log. Leaving the `with` block ends running ones."""

    def __init__(self, folder: FarmFolder, chunks: Sequence[int], at_once: int) -> None:
        self._folder = folder
        self._left: List[int] = list(chunks)  # chunks that wait or run
        self._waiting: List[int] = list(reversed(chunks))
        self._running: Dict[int, "subprocess.Popen[bytes]"] = {}
        self._lock = threading.Lock()
        self._stopped = False
        self._ended = threading.Event()  # set once all chunks were tried
        self._threads = [
            threading.Thread(target=self._work, daemon=True) for _ in range(min(at_once, len(chunks)))
        ]

    def __enter__(self) -> LocalTasks:
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        with self._lock:
            self._stopped = True
            running = list(self._running.values())
        for process in running:
            process.send_signal(signal.SIGTERM)
        for process in running:
            try:
                process.wait(STOP_SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()

    def live(self) -> Dict[int, str]:
        """Returns the chunks that wait or run, in the form that `status_of` takes."""
        with self._lock:
            return {chunk: "running" if chunk in self._running else "waiting" for chunk in self._left}

    def follow(self, every: float, report: Callable[[], None]) -> None:
        """Calls `report` at once, then every `every` seconds, and when all chunks were tried."""
        report()
        while self.live():
            self._ended.wait(every)  # not join(): if Ctrl-C interrupts it, Python takes the thread for ended
            report()

    def _work(self) -> None:
        while True:
            with self._lock:
                if self._stopped or not self._waiting:
                    return
                chunk = self._waiting.pop()
                process = self._running[chunk] = self._start(chunk)
            process.wait()
            with self._lock:
                del self._running[chunk]
                self._left.remove(chunk)
                if not self._left:
                    self._ended.set()

    def _start(self, chunk: int) -> "subprocess.Popen[bytes]":
        command = ["sh", str(self._folder.path / "chunk.sh"), str(chunk)]
        with open(self._folder.logs / f"{chunk}.log", "ab") as log:
            return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
