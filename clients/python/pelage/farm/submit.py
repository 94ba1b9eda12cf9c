"""Submits a job to an engine: all chunks at first, later those with missing frames."""

from __future__ import annotations

import os
import pathlib
import shlex
import shutil
import sys
import time
from typing import Dict, List, NamedTuple

from ..progress import Progress, print_progress
from . import kubernetes, openjd, slurm
from .chunk_script import chunk_script
from .errors import FarmError
from .folder import FarmFolder, Sent, default_folder, read_job
from .local_tasks import LocalTasks
from .plan import MEASURED_FRAMES, RENDERER, Plan, plan_of, renderer_program
from .ranges import tiled_chunks_of
from .status import NO_TASKS, Tasks, bar, status_of, table, tasks_of
from .yaml import to_yaml

ENGINES = ("slurm", "local", "openjd", "kubernetes")
FLAGS = {
    "engine": "--engine",
    "chunk_seconds": "--chunk-seconds",
    "at_once": "--max-parallel",
    "threads": "--threads",
    "image": "--image",
    "claim": "--claim",
}
LOCAL_AT_ONCE = 2
LOOKED_EVERY = 1.0  # seconds


class Options(NamedTuple):
    """job: A job file, or a folder made from one. folder: "" for the default. at_once: 0 for the engine's default.
    threads: 0 for all cores of a task. image, claim: For Kubernetes."""

    job: str
    engine: str = "slurm"
    folder: str = ""
    chunk_seconds: float = 120.0
    at_once: int = 0
    threads: int = 0
    image: str = "pelage"
    claim: str = "farm"
    dry_run: bool = False

    def line(self, folder: FarmFolder) -> str:
        """Returns the command line that submits the folder with the same options."""
        words = ["pelage", "farm", "submit", str(folder.path)]
        for name, flag in FLAGS.items():
            value = getattr(self, name)
            if value != self._field_defaults[name]:
                words += [flag, f"{value:g}" if isinstance(value, float) else str(value)]
        return shlex.join(words)


def submit(options: Options) -> bool:
    """Submits the job. Returns False if it waited for frames and some are missing. Raises FarmError."""
    given = pathlib.Path(options.job)
    if given.is_dir():
        folder = FarmFolder(given)
        folder.plan()  # raises if it is not a folder of a farm job
    else:
        read_job(given)
        folder = FarmFolder(pathlib.Path(options.folder or default_folder(given)))
    with folder.locked():
        return submit_in(folder, given, options)


def submit_in(folder: FarmFolder, given: pathlib.Path, options: Options) -> bool:
    refuse_while_running(folder)
    prepare(folder, given, options)
    folder.remove_leftovers()
    status = status_of(folder, NO_TASKS)
    chunks = [chunk.chunk for chunk in status.chunks if chunk.missing]
    if not chunks:
        print(f"All {status.total} {status.unit} are there: {folder.path}")
        return True
    left = f"{status.total - status.done} of {status.total} {status.unit}"
    print(f"{len(chunks)} of {len(status.chunks)} chunks to draw, {left}")
    write_engine_files(folder, chunks, options)
    if options.dry_run:
        print(f"Nothing is submitted. Submit it with: {options.line(folder)}")
        return True
    return send(folder, chunks, options)


def refuse_while_running(folder: FarmFolder) -> None:
    sent = folder.sent() if folder.exists() else None
    if sent and sent.engine == "slurm" and tasks_of(folder, sent).live:
        step = f"wait with `pelage farm status {folder.path} --watch`, or end it with `scancel {sent.job}`"
        raise FarmError(f"Job {sent.job} still draws in {folder.path}", step)


def prepare(folder: FarmFolder, given: pathlib.Path, options: Options) -> None:
    """Writes the copies, the plan and the chunks. Keeps the chunks of an unchanged job, so that tasks keep their numbers."""
    changed = not given.is_dir() and folder.copy_job(given)
    known = folder.sent() is not None and not changed
    plan = checked_plan(folder, 0 if known else MEASURED_FRAMES)
    frames = [frame.frame for frame in plan.frames]
    if known and sorted({frame for chunk in folder.chunks() for frame in chunk.frames}) == frames:
        folder.write_plan(plan._replace(frame_seconds=folder.plan().frame_seconds))
        return
    folder.write_plan(plan)
    cost = plan.frame_seconds or options.chunk_seconds
    chunks = tiled_chunks_of(frames, plan.tile_count, cost, options.chunk_seconds, at_once_of(options))
    largest = max(len(chunk.frames) for chunk in chunks)
    tiles = f" in {plan.tile_count} tiles" if plan.tile_count else ""
    print(f"{len(frames)} frames{tiles}, about {cost:.2g} s each: {len(chunks)} chunks of up to {largest} {plan.unit}")
    folder.write_chunks(chunks)
    (folder.path / "sent.json").unlink(missing_ok=True)
    shutil.rmtree(folder.logs, ignore_errors=True)
    folder.logs.mkdir()


def checked_plan(folder: FarmFolder, measured_frames: int) -> Plan:
    if measured_frames:
        print_progress(Progress(0.0, f"drawing {measured_frames} frames to learn what one costs"))
    plan = plan_of(str(folder.job), measured_frames)
    print_progress(Progress(1.0, ""))
    return plan


def write_engine_files(folder: FarmFolder, chunks: List[int], options: Options) -> None:
    """Writes chunk.sh and the engine's files, and prints what was written."""
    renderer = RENDERER if options.engine == "kubernetes" else renderer_program()
    threads = options.threads
    if options.engine == "local" and not threads:
        threads = max(1, (os.cpu_count() or 1) // at_once_of(options))
    folder.write("chunk.sh", chunk_script(renderer, threads))
    texts: Dict[str, str] = {}
    if options.engine == "slurm":
        texts["submit.sbatch"] = slurm.script(folder, chunks, options.at_once, threads)
    elif options.engine == "openjd":
        texts["template.yaml"] = to_yaml(openjd.template(folder, chunks, threads))
    elif options.engine == "kubernetes":
        made = kubernetes.manifest(folder, chunks, options.at_once, threads, options.image, options.claim)
        texts["kubernetes.yaml"] = to_yaml(made)
    for name, text in texts.items():
        folder.write(name, text)
        print(folder.path / name)


def at_once_of(options: Options) -> int:
    return options.at_once or (LOCAL_AT_ONCE if options.engine == "local" else 0)


def send(folder: FarmFolder, chunks: List[int], options: Options) -> bool:
    if options.engine == "local":
        return run_here(folder, chunks, at_once_of(options))
    job = slurm.submit(folder) if options.engine == "slurm" else ""
    folder.write_sent(Sent(options.engine, job, chunks, options.at_once, time.time()))
    if options.engine == "slurm":
        print(f"Slurm job {job}; follow it with: pelage farm status {folder.path} --watch")
    elif options.engine == "openjd":
        print(f"Give it to a farm, or try it here: openjd run {folder.path}/template.yaml --step Draw")
    else:
        print(f"Copy the folder to the volume of {options.claim}, then: kubectl create -f {folder.path}/kubernetes.yaml")
    return True


def run_here(folder: FarmFolder, chunks: List[int], at_once: int) -> bool:
    """Runs all chunks on this machine and waits for them, with a bar on a terminal."""
    folder.write_sent(Sent("local", "", chunks, at_once, time.time()))
    with LocalTasks(folder, chunks, at_once) as tasks:
        tasks.follow(LOOKED_EVERY, lambda: show_bar(folder, tasks.live()))
    folder.remove_leftovers()
    status = status_of(folder, NO_TASKS)
    print(table(folder, status))
    return status.done == status.total


def show_bar(folder: FarmFolder, live: Dict[int, str]) -> None:
    if sys.stderr.isatty():
        line = bar(status_of(folder, Tasks(live, {}))) if live else ""
        print(f"\r\033[K{line}", end="", file=sys.stderr, flush=True)
