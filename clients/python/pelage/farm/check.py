"""Finds frames that are missing, truncated, of a wrong size, black, or not of this job."""

from __future__ import annotations

import concurrent.futures
import os
import pathlib
import subprocess
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

from .ffmpeg import ffmpeg_program, input_of
from .folder import FarmFolder
from .frame_files import FrameFile, ShortFile, inspect
from .plan import Plan, PlannedFrame, plan_of

BLACK = 0.02  # a frame counts as black if no pixel is brighter than this, [0, 1]
KINDS = ("missing", "short", "size", "black", "stale")


class Fault(NamedTuple):
    """kind: One of KINDS. words: What is wrong with the file."""

    frame: int
    file: str
    kind: str
    words: str

    def to_json(self) -> Dict[str, Any]:
        return dict(self._asdict())


def plan_for(path: str) -> Plan:
    """Returns the plan of a folder made by `submit`, or of a job file. Raises FarmError."""
    given = pathlib.Path(path)
    return FarmFolder(given).plan() if given.is_dir() else plan_of(path)


def faults_of(plan: Plan, black: float = BLACK) -> List[Fault]:
    """Returns the faults by frame. black: Brightness, 0 to 1, that a pixel must exceed. Raises FarmError without ffmpeg."""
    ffmpeg_program()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        looks = list(pool.map(look_at, plan.frames))
    return [fault for look in looks for fault in faults_in(look, black)]


class Look(NamedTuple):
    """file: None if missing or truncated. brightest: Maximum over all pixels, 0 to 1. fault: Kind and text, or None."""

    planned: PlannedFrame
    file: Optional[FrameFile]
    brightest: float
    fault: Optional[Tuple[str, str]]


def look_at(planned: PlannedFrame) -> Look:
    try:
        file = inspect(planned.file)
        return Look(planned, file, brightest_of(planned.file), None)
    except FileNotFoundError:
        return Look(planned, None, 0, ("missing", "there is no file"))
    except (OSError, ShortFile) as error:
        return Look(planned, None, 0, ("short", str(error)))


def brightest_of(path: str) -> float:
    """Returns the maximum brightness of all decoded pixels, 0 to 1. Raises ShortFile if decoding fails."""
    with input_of([path], 1) as given:
        command = [ffmpeg_program(), "-v", "error", "-xerror", "-err_detect", "crccheck+explode", *given]
        command += ["-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "gray", "-"]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True)
    if done.returncode or not done.stdout:
        lines = done.stderr.decode("utf-8", "replace").strip().splitlines() or ["no picture in it"]
        raise ShortFile(f"it cannot be decoded: {lines[0]}")
    return max(done.stdout) / 255


def faults_in(look: Look, black: float) -> List[Fault]:
    def fault(kind: str, words: str) -> Fault:
        return Fault(look.planned.frame, look.planned.file, kind, words)

    if look.fault or not look.file:
        return [fault(*look.fault)] if look.fault else []
    found: List[Fault] = []
    wanted = look.planned
    if (look.file.width, look.file.height) != (wanted.width, wanted.height):
        sizes = f"{look.file.width} x {look.file.height} pixels, not {wanted.width} x {wanted.height}"
        found.append(fault("size", f"it has {sizes}"))
    if look.brightest <= black:
        found.append(fault("black", f"no pixel is brighter than {look.brightest:.3f}"))
    if look.file.fingerprint != wanted.fingerprint:
        found.append(fault("stale", "it was drawn of another scene, job or version"))
    return found


def frames_in(faults: Sequence[Fault]) -> List[int]:
    return sorted({fault.frame for fault in faults})
