"""Frame ranges as text, such as `1-10,20-30x5`, and their division into chunks."""

from __future__ import annotations

import math
import re
from typing import List, NamedTuple, Sequence

PART = re.compile(r"(-?\d+)(?:-(-?\d+)(?:[x:](\d+))?)?")
# Slurm's default limit (MaxArraySize) is 1,000 tasks in an array; Open Job Description allows a list of 1,024.
MAX_CHUNKS = 1000


def frames_of(text: str) -> List[int]:
    """Parses a range and returns its frames in order. Raises ValueError if it is invalid."""
    frames: List[int] = []
    for part in text.strip().split(","):
        match = PART.fullmatch(part.strip())
        if not match:
            raise ValueError(f"{part!r} is no frame range; write it as 1-10, 1-10x3 or 7")
        first, last, step = int(match[1]), int(match[2] or match[1]), int(match[3] or 1)
        if step < 1:
            raise ValueError(f"{part!r} has a step below 1")
        frames.extend(range(first, last + 1, step))
    return frames


def range_of(frames: Sequence[int]) -> str:
    """Returns the shortest range text with runs of even steps. frames: Ascending."""
    parts: List[str] = []
    start = 0
    while start < len(frames):
        end = end_of_run(frames, start)
        step = frames[start + 1] - frames[start] if end > start else 1
        if end == start:
            parts.append(str(frames[start]))
        elif end == start + 1 and step > 1:  # two frames do not make a run
            parts.append(str(frames[start]))
            end = start
        else:
            parts.append(f"{frames[start]}-{frames[end]}" + (f"x{step}" if step > 1 else ""))
        start = end + 1
    return ",".join(parts)


def end_of_run(frames: Sequence[int], start: int) -> int:
    """Returns the index of the last frame that continues the step of the first two."""
    end = min(start + 1, len(frames) - 1)
    while end + 1 < len(frames) and frames[end + 1] - frames[end] == frames[start + 1] - frames[start]:
        end += 1
    return end


class Chunk(NamedTuple):
    """The frames of one task. tile: The tile of each frame to draw, from 1; 0 for whole frames."""

    frames: List[int]
    tile: int

    def to_text(self) -> str:
        """Returns the chunk's line in chunks.txt."""
        return range_of(self.frames) + (f" {self.tile}" if self.tile else "")


def chunk_from(line: str) -> Chunk:
    """Parses a line that Chunk.to_text wrote."""
    frames, _, tile = line.partition(" ")
    return Chunk(frames_of(frames), int(tile or 0))


def tiled_chunks_of(
    frames: Sequence[int], tile_count: int, frame_seconds: float, chunk_seconds: float, at_once: int
) -> List[Chunk]:
    """Like chunks_of, for frames in tiles: each chunk of frames becomes one chunk per tile. tile_count: 0 for whole
    frames; at most MAX_CHUNKS."""
    tiles = list(range(1, tile_count + 1)) or [0]
    min_chunks = math.ceil(at_once / len(tiles))
    parts = chunks_of(frames, frame_seconds / len(tiles), chunk_seconds, min_chunks, MAX_CHUNKS // len(tiles))
    return [Chunk(part, tile) for part in parts for tile in tiles]


def chunks_of(
    frames: Sequence[int], frame_seconds: float, chunk_seconds: float, at_once: int = 1, max_chunks: int = MAX_CHUNKS
) -> List[List[int]]:
    """Divides frames into contiguous chunks whose sizes differ by at most one.

    A chunk takes about chunk_seconds. There are at least `at_once` chunks, so that no node is idle, and at most
    `max_chunks`.
    """
    in_one = max(1, int(chunk_seconds / max(frame_seconds, 1e-6)))
    count = max(math.ceil(len(frames) / in_one), at_once)
    count = max(1, min(count, len(frames), max_chunks))
    bounds = [len(frames) * index // count for index in range(count + 1)]
    return [list(frames[first:last]) for first, last in zip(bounds, bounds[1:])]
