"""The frames that a job will draw, as `pelage-render --check` reports them."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Set, Tuple, Union

from .errors import BAD_INPUT, FAILED, FarmError
from .frame_files import ShortFile, inspect

RENDERER = "pelage-render"
RENDERER_VARIABLE = "PELAGE_RENDER"
MEASURED_FRAMES = 3
REFUSED_CODES = (2, 3)  # exit codes of pelage-render: wrong use, bad job or scene


class PlannedTile(NamedTuple):
    """A tile of a frame; members as in PlannedFrame."""

    file: str
    fingerprint: str
    width: int
    height: int


class PlannedFrame(NamedTuple):
    """file: Path. fingerprint: Identifies files that were drawn for this job. width, height: Pixels. tiles: The tiles that
    it is drawn in, empty if drawn at once; the task that draws the last tile combines and removes them."""

    frame: int
    file: str
    fingerprint: str
    width: int
    height: int
    tiles: Tuple[PlannedTile, ...] = ()


class FrameTile(NamedTuple):
    """The part of a frame that a chunk draws. tile: From 1; 0 for the whole frame."""

    frame: PlannedFrame
    tile: int

    @property
    def files(self) -> List[str]:
        """The files any of which shows that the part is done."""
        return [self.frame.file] + ([self.frame.tiles[self.tile - 1].file] if self.tile else [])


def done_parts(frames: Sequence[PlannedFrame], running: bool) -> Set[Tuple[int, int]]:
    """Returns pairs of frame and tile (0: whole frame) whose files are complete and of this job.

    running: True if a task may still combine tiles. If False, and all tiles of a frame exist but not the frame, the task
    that should have combined them was killed: none of them counts, so that they are sent again.
    """
    done: Set[Tuple[int, int]] = set()
    for frame in frames:
        if is_whole(frame):
            done.update((frame.frame, tile) for tile in range(len(frame.tiles) + 1))
            continue
        whole = [number for number, tile in enumerate(frame.tiles, 1) if is_whole(tile)]
        if running or len(whole) < len(frame.tiles):
            done.update((frame.frame, number) for number in whole)
    return done


def is_whole(planned: Union[PlannedFrame, PlannedTile]) -> bool:
    """Returns True if the file is complete and of this job."""
    try:
        return inspect(planned.file) == (planned.width, planned.height, planned.fingerprint)
    except (OSError, ShortFile):
        return False


class Plan(NamedTuple):
    """frames: In ascending order. frame_seconds: Time of a frame, measured on this machine; None if not measured."""

    frames: List[PlannedFrame]
    fps: float
    frame_seconds: Optional[float]

    @property
    def tile_count(self) -> int:
        """Number of tiles of each frame; 0 if frames are drawn at once."""
        return len(self.frames[0].tiles) if self.frames else 0

    @property
    def unit(self) -> str:
        """The unit in which progress is counted."""
        return "tiles" if self.tile_count else "frames"

    def to_json(self) -> Dict[str, Any]:
        frames = [{**frame._asdict(), "tiles": [tile._asdict() for tile in frame.tiles]} for frame in self.frames]
        return {"frames": frames, "fps": self.fps, "seconds_per_frame": self.frame_seconds}


def plan_from(document: Dict[str, Any], folder: str) -> Plan:
    """Reads a plan. folder: Base of relative paths."""
    def tile(one: Dict[str, Any]) -> PlannedTile:
        return PlannedTile(os.path.join(folder, one["file"]), one["fingerprint"], one["width"], one["height"])

    def planned(one: Dict[str, Any]) -> PlannedFrame:
        tiles = tuple(map(tile, one.get("tiles", ())))
        return PlannedFrame(one["frame"], *tile(one), tiles)

    frames = sorted(planned(one) for one in document["frames"])
    return Plan(frames, document["fps"], document.get("seconds_per_frame"))


def renderer_program() -> str:
    """Returns the path of pelage-render: PELAGE_RENDER, else the one on the PATH. Raises FarmError."""
    wanted = os.environ.get(RENDERER_VARIABLE, RENDERER)
    found = shutil.which(wanted)
    if found is None:
        raise FarmError(f"There is no program {wanted}", f"set {RENDERER_VARIABLE} or PATH so that it is found")
    return os.path.abspath(found)


def plan_of(job: str, measured_frames: int = 0) -> Plan:
    """Checks a job's file with pelage-render. measured_frames: Number of frames to draw to measure their time.

    Raises FarmError with what pelage-render says about the job.
    """
    path = os.path.abspath(job)
    command = [renderer_program(), path, "--check"]
    if measured_frames:
        command += ["--measure", str(measured_frames)]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode:
        text = done.stderr.strip() or f"{RENDERER} ended with {done.returncode}"
        code = BAD_INPUT if done.returncode in REFUSED_CODES else FAILED
        message, _, step = text.partition("\n  next:")
        raise FarmError(message.replace(f"{RENDERER}: ", "", 1), step.strip() or f"see `{RENDERER} {job} --check`", code)
    return plan_from(json.loads(done.stdout), os.path.dirname(path))
