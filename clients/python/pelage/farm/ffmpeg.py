"""Runs ffmpeg."""

from __future__ import annotations

import contextlib
import os
import pathlib
import shutil
import subprocess
import tempfile
from typing import Iterator, List, Sequence

from .errors import BAD_INPUT, FarmError
from .exr import without_extras

ENDINGS = (".png", ".exr")


def ffmpeg_program() -> str:
    """Returns the path of ffmpeg. Raises FarmError if there is none."""
    found = shutil.which("ffmpeg")
    if found is None:
        raise FarmError("There is no program ffmpeg", "install it: apt-get install ffmpeg")
    return found


def ending_of(path: str) -> str:
    return os.path.splitext(path)[1].lower()


@contextlib.contextmanager
def input_of(files: Sequence[str], fps: float) -> Iterator[List[str]]:
    """Yields ffmpeg's arguments for a sequence of pictures of one format as input. Raises FarmError."""
    ending = ending_of(files[0])
    if ending not in ENDINGS:
        raise FarmError(f"{files[0]} is neither PNG nor EXR", "name frames of these formats", BAD_INPUT)
    with tempfile.TemporaryDirectory(prefix="pelage-farm-") as folder:
        for number, file in enumerate(files):
            path = pathlib.Path(folder, f"{number:08}{ending}")
            if ending == ".exr":
                path.write_bytes(without_extras(pathlib.Path(file).read_bytes()))
            else:
                path.symlink_to(os.path.abspath(file))
        shown = ["-apply_trc", "iec61966_2_1"] if ending == ".exr" else []  # EXR is linear
        yield [*shown, "-f", "image2", "-framerate", f"{fps:g}", "-i", os.path.join(folder, f"%08d{ending}")]


def convert(files: Sequence[str], fps: float, arguments: Sequence[str], output: str) -> None:
    """Converts pictures to one file, which is written atomically. Raises FarmError."""
    part = os.path.join(os.path.dirname(os.path.abspath(output)), f".part-{os.getpid()}-{os.path.basename(output)}")
    try:
        with input_of(files, fps) as given:
            command = [ffmpeg_program(), "-v", "error", "-xerror", "-y", *given, *arguments, part]
            done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True)
        if done.returncode:
            said = done.stderr.decode("utf-8", "replace").strip()
            raise FarmError(f"ffmpeg: {said or done.returncode}", "look for bad frames with `pelage farm check`")
        os.replace(part, output)
    finally:
        if os.path.exists(part):
            os.unlink(part)
