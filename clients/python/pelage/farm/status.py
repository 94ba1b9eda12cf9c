"""The status of a job on a farm, from the frames on disk, the engine's task states and the tasks' logs."""

from __future__ import annotations

import os
import re
import time
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Set, Tuple

from . import slurm
from .folder import FarmFolder, Sent
from .plan import FrameTile, done_parts
from .ranges import range_of

BAR_CELLS = 20
LOG_END = 20_000  # bytes at the end of a log that are read
REASON = re.compile(r"^(?:openjd_fail|pelage-render|sh): (?!heartbeat|done)(.*)$", re.M)
PROGRESS = re.compile(r"^openjd_progress: ([\d.]+)$", re.M)


class ChunkState(NamedTuple):
    """state: done, running, waiting or failed; sent if the engine reports nothing, unsent if no engine has it.

    missing: Frames whose file or tile is missing. reason: The last error in the log of a failed chunk.
    """

    chunk: int
    state: str
    frames: List[int]
    missing: List[int]
    reason: str

    def to_json(self) -> Dict[str, Any]:
        return {**self._asdict(), "frames": range_of(self.frames), "missing": range_of(self.missing)}


class Status(NamedTuple):
    """total, done, failed: Counts of the unit, frames or tiles. seconds_left: Estimate; None while nothing runs."""

    unit: str
    total: int
    done: int
    failed: int
    running_tasks: int
    seconds_left: Optional[float]
    chunks: List[ChunkState]

    @property
    def is_over(self) -> bool:
        return not any(chunk.state in ("running", "waiting", "sent") for chunk in self.chunks)

    def to_json(self) -> Dict[str, Any]:
        return {**self._asdict(), "chunks": [chunk.to_json() for chunk in self.chunks]}


class Tasks(NamedTuple):
    """Task states by chunk. live: waiting, running, or sent (unknown). ended: The engine's state of finished tasks."""

    live: Dict[int, str]
    ended: Dict[int, str]


NO_TASKS = Tasks({}, {})


def status_of(folder: FarmFolder, tasks: Optional[Tasks] = None) -> Status:
    """Returns the status. tasks: Queried from the engine by default. Raises FarmError."""
    sent = folder.sent()
    if tasks is None:
        tasks = tasks_of(folder, sent) if sent else NO_TASKS
    planned = folder.planned_chunks()
    plan = folder.plan()
    done = done_parts(plan.frames, bool(tasks.live))
    chunks = [chunk_state(folder, sent, tasks, number, parts, done) for number, parts in enumerate(planned)]
    missing = sum(len(chunk.missing) for chunk in chunks)
    total = sum(len(parts) for parts in planned)
    running = sum(chunk.state == "running" for chunk in chunks)
    failed = sum(len(chunk.missing) for chunk in chunks if chunk.state == "failed")
    waited_for = missing - failed - sum(len(chunk.missing) for chunk in chunks if chunk.state == "unsent")
    left = seconds_left(folder, sent, planned, waited_for, running)
    return Status(plan.unit, total, total - missing, failed, running, left, chunks)


def tasks_of(folder: FarmFolder, sent: Sent) -> Tasks:
    """Queries the engine for its task states. Raises FarmError."""
    if sent.engine == "slurm":
        states = slurm.task_states(sent.job)
        live = {chunk: slurm.LIVE[state] for chunk, state in states.items() if state in slurm.LIVE}
        return Tasks(live, {chunk: state for chunk, state in states.items() if chunk not in live})
    if sent.engine != "local":
        return Tasks({chunk: "sent" for chunk in sent.chunks}, {})
    if not folder.is_locked():
        return NO_TASKS
    begun = {chunk for chunk in sent.chunks if time_of(str(folder.logs / f"{chunk}.log")) > sent.at}
    return Tasks({chunk: "running" if chunk in begun else "waiting" for chunk in sent.chunks}, {})


def chunk_state(
    folder: FarmFolder, sent: Optional[Sent], tasks: Tasks, chunk: int, parts: Sequence[FrameTile], done: Set[Tuple[int, int]]
) -> ChunkState:
    """Returns a chunk's state. Files decide, not the engine: a chunk is done if all its files exist, and failed if it was
    sent, its task is over, and a file is missing."""
    missing = [part.frame.frame for part in parts if (part.frame.frame, part.tile) not in done]
    state = tasks.live.get(chunk, "done")
    if not missing and sent and sent.engine != "slurm":  # only Slurm reports when a task is over
        state = "done"
    if missing and chunk not in tasks.live:
        state = "failed" if sent and chunk in sent.chunks else "unsent"
    reason = reason_of(folder, chunk, tasks.ended.get(chunk, "")) if state == "failed" else ""
    return ChunkState(chunk, state, [part.frame.frame for part in parts], missing, reason)


def log_end(folder: FarmFolder, chunk: int) -> str:
    try:
        with open(folder.logs / f"{chunk}.log", "rb") as file:
            file.seek(max(0, os.fstat(file.fileno()).st_size - LOG_END))
            return file.read().decode("utf-8", "replace")
    except OSError:
        return ""


def reason_of(folder: FarmFolder, chunk: int, ended: str) -> str:
    """Returns the last error in the log, with the engine's state, such as OUT_OF_MEMORY."""
    text = log_end(folder, chunk)
    reasons: List[str] = REASON.findall(text)
    reason = reasons[-1] if reasons else "its log ends without an error: it was killed" if text else "it has no log"
    return f"{ended}: {reason}" if ended else reason


def seconds_left(
    folder: FarmFolder, sent: Optional[Sent], planned: Sequence[Sequence[FrameTile]], waited_for: int, running: int
) -> Optional[float]:
    """Estimates the seconds left from the files made since submission, or from the measured cost while there are few."""
    if not sent or not running or not waited_for:
        return None
    times = sorted(max(map(time_of, part.files)) for parts in planned for part in parts)
    times = [moment for moment in times if moment > sent.at]
    if len(times) > 2 * running:
        return waited_for * (time.time() - sent.at) / len(times)
    plan = folder.plan()
    measured = (plan.frame_seconds or 0) / max(1, plan.tile_count)
    return waited_for * measured / running if measured else None


def time_of(file: str) -> float:
    try:
        return os.stat(file).st_mtime
    except OSError:
        return 0.0


def bar(status: Status) -> str:
    """Returns a progress bar in one line."""
    share = status.done / max(1, status.total)
    full = int(share * BAR_CELLS)
    return f"[{'#' * full}{'.' * (BAR_CELLS - full)}] {share:4.0%}, {summary(status)}"


def summary(status: Status) -> str:
    unit = status.unit
    words = f"{status.done} of {status.total} {unit}, {status.running_tasks} tasks running, {status.failed} {unit} failed"
    return words + (f", about {status.seconds_left:.0f} s left" if status.seconds_left is not None else "")


def table(folder: FarmFolder, status: Status) -> str:
    """Returns a summary and a line for each chunk that is not done."""
    lines = [summary(status)]
    for chunk in status.chunks:
        if chunk.state == "done":
            continue
        words = chunk.reason
        if chunk.state == "running":
            shares = PROGRESS.findall(log_end(folder, chunk.chunk))
            words = f"{float(shares[-1]):.0f} %" if shares else "starting"
        lines.append(f"{chunk.chunk:5}  {chunk.state:8} {range_of(chunk.missing) or 'all drawn':24} {words}".rstrip())
    return "\n".join(lines)
