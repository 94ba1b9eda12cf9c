"""Calls of ffmpeg."""

from __future__ import annotations

import os
import shutil
import subprocess
from typing import List, Sequence

from .errors import BAD_INPUT, FarmError

CODECS = {".png": "png", ".exr": "exr"}


def ffmpeg_program() -> str:
    """Raises FarmError."""
    found = shutil.which("ffmpeg")
    if found is None:
        raise FarmError("There is no program ffmpeg", "install it: apt-get install ffmpeg")
    return found


def ending_of(path: str) -> str:
    return os.path.splitext(path)[1].lower()


def input_arguments(path: str) -> List[str]:
    """What a decoder needs to know: EXR holds linear light, and is shown as sRGB."""
    return ["-apply_trc", "iec61966_2_1"] if ending_of(path) == ".exr" else []


def convert(files: Sequence[str], fps: float, arguments: Sequence[str], output: str) -> None:
    """Runs ffmpeg on pictures of one format, in their order; what it writes appears whole. Raises FarmError."""
    ending = ending_of(files[0])
    if ending not in CODECS:
        raise FarmError(f"{files[0]} is neither PNG nor EXR", "name frames of these formats", BAD_INPUT)
    part = os.path.join(os.path.dirname(os.path.abspath(output)), f".part-{os.getpid()}-{os.path.basename(output)}")
    command = [ffmpeg_program(), "-v", "error", "-xerror", "-y", *input_arguments(files[0])]
    command += ["-f", "image2pipe", "-framerate", f"{fps:g}", "-c:v", CODECS[ending], "-i", "-", *arguments, part]
    try:
        feed(command, files)
        os.replace(part, output)
    finally:
        if os.path.exists(part):
            os.unlink(part)


def feed(command: List[str], files: Sequence[str]) -> None:
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdin and process.stderr
    try:
        for file in files:
            with open(file, "rb") as source:
                shutil.copyfileobj(source, process.stdin)
        process.stdin.close()
    except BrokenPipeError:
        pass  # ffmpeg has ended, and says why
    said = process.stderr.read().decode("utf-8", "replace").strip()
    if process.wait():
        raise FarmError(f"ffmpeg: {said or process.returncode}", "look for bad frames with `pelage farm check`")
