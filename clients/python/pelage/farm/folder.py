"""The folder of a job on a farm: a copy of the job and its scene, the chunks, logs, and what was sent when.

    job.json, fox.pelage   copies, so that whoever edits the originals changes no frame of a running job
    chunks.txt             a frame range a line, and the number of a tile; task N draws line N + 1
    chunk.sh               what every engine runs: sh chunk.sh N
    plan.json              the frames, their files and fingerprints
    sent.json              engine, its job, the chunks that were sent
    lock                   held while `submit` works
    logs/                  a file for each chunk that an engine's own logs do not hold
"""

from __future__ import annotations

import contextlib
import fcntl
import glob
import json
import os
import pathlib
import re
import shutil
import tempfile
from typing import Any, Dict, Iterator, List, NamedTuple, Optional

from ..files import write_whole
from .errors import BAD_INPUT, FarmError
from .pack import fetch_scene, is_on_server
from .plan import FrameTile, Plan, plan_from
from .ranges import Chunk, chunk_from

JOB = "job.json"
MODELS = "models"  # subfolder for copies of the job's `motion` files
LOCK = "lock"  # held by `submit`; with the engine `local` until all chunks are drawn


class Sent(NamedTuple):
    """The last submission to an engine. job: Its id there; "" if it has none. chunks: Numbers from 0. at: Time in seconds
    since the epoch."""

    engine: str
    job: str
    chunks: List[int]
    at_once: int
    at: float


class FarmFolder:
    """A job's folder, as described above. path: Absolute."""

    def __init__(self, path: pathlib.Path) -> None:
        self.path = path.absolute()

    @property
    def job(self) -> pathlib.Path:
        return self.path / JOB

    @property
    def logs(self) -> pathlib.Path:
        return self.path / "logs"

    @property
    def name(self) -> str:
        """Name of the job, shown by engines."""
        return self.path.name.replace(".farm", "") or "frames"

    def exists(self) -> bool:
        return self.job.exists() and (self.path / "plan.json").exists()

    def plan(self) -> Plan:
        """Reads the plan. Raises FarmError if there is none."""
        try:
            document = json.loads((self.path / "plan.json").read_text(encoding="utf-8"))
        except OSError as error:
            step = "name a folder that `pelage farm submit` made"
            raise FarmError(f"{self.path} is no folder of a farm job: {error}", step, BAD_INPUT) from error
        return plan_from(document, str(self.path))

    def chunks(self) -> List[Chunk]:
        lines = (self.path / "chunks.txt").read_text(encoding="utf-8").splitlines()
        return [chunk_from(line) for line in lines if line]

    def planned_chunks(self) -> List[List[FrameTile]]:
        frames = {frame.frame: frame for frame in self.plan().frames}
        return [[FrameTile(frames[number], chunk.tile) for number in chunk.frames] for chunk in self.chunks()]

    def sent(self) -> Optional[Sent]:
        file = self.path / "sent.json"
        return Sent(**json.loads(file.read_text(encoding="utf-8"))) if file.exists() else None

    def write_sent(self, sent: Sent) -> None:
        self.write("sent.json", json.dumps(sent._asdict()))

    @contextlib.contextmanager
    def locked(self) -> Iterator[None]:
        """Creates the folder and locks it against other submits until the end of the block. Raises FarmError."""
        self.path.mkdir(parents=True, exist_ok=True)
        with open(self.path / LOCK, "ab") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError as error:
                step = f"follow it with `pelage farm status {self.path} --watch`"
                raise FarmError(f"Another `pelage farm submit` works in {self.path}", step) from error
            yield

    def is_locked(self) -> bool:
        try:
            with open(self.path / LOCK, "rb") as file:
                fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except OSError as error:
            return isinstance(error, BlockingIOError)
        return False

    def remove_leftovers(self) -> None:
        """Removes temporary files of tasks that were killed while writing. Call it only while no task runs."""
        planned = self.plan().frames
        for file in [frame.file for frame in planned] + [tile.file for frame in planned for tile in frame.tiles]:
            folder, name = os.path.split(file)
            for left in glob.glob(os.path.join(glob.escape(folder), f".{glob.escape(name)}.*.tmp")):
                os.unlink(left)

    def write_plan(self, plan: Plan) -> None:
        """Writes the plan; paths below this folder become relative, so that the folder can be moved."""
        document = plan.to_json()
        for frame in document["frames"]:
            for planned in (frame, *frame["tiles"]):
                if planned["file"].startswith(f"{self.path}{os.sep}"):
                    planned["file"] = os.path.relpath(planned["file"], self.path)
        self.write("plan.json", json.dumps(document, indent=1))

    def write_chunks(self, chunks: List[Chunk]) -> None:
        self.write("chunks.txt", "".join(chunk.to_text() + "\n" for chunk in chunks))

    def write(self, name: str, text: str) -> None:
        write_whole(self.path / name, text.encode())

    def copy_job(self, source: pathlib.Path) -> bool:
        """Copies a job, its scene and its motion files. Returns True if any of them changed. Raises FarmError."""
        document = read_job(source)
        self.logs.mkdir(parents=True, exist_ok=True)
        changed = False
        if isinstance(document.get("scene"), str):
            with tempfile.TemporaryDirectory() as fetched:
                on_server = is_on_server(document["scene"])
                scene = fetch_scene(document["scene"], pathlib.Path(fetched)) if on_server else source.parent / document["scene"]
                document["scene"] = scene.name
                changed = copy_changed(scene, self.path / scene.name, "scene")
        motion = document.get("motion")
        if isinstance(motion, dict) and isinstance(motion.get("model"), str):
            models = source.parent / motion["model"]
            motion["model"] = f"{MODELS}/{models.name}"
            for model in numbered_files(models):
                changed |= copy_changed(model, self.path / MODELS / model.name, "motion")
        text = json.dumps(document, indent=2) + "\n"
        changed |= not self.job.exists() or self.job.read_text(encoding="utf-8") != text
        self.write(JOB, text)
        return changed


def read_job(path: pathlib.Path) -> Dict[str, Any]:
    """Reads a job file. Raises FarmError if it cannot be read or is not a JSON object."""
    try:
        document = json.loads(bytes_of(path))
    except (OSError, ValueError) as error:
        step = "name a job's file, as docs/farm.md shows one"
        raise FarmError(f"{path} cannot be read: {error}", step, BAD_INPUT) from error
    if not isinstance(document, dict):
        raise FarmError(f"{path} is no job", "write an object with scene, frames and output", BAD_INPUT)
    return document


def numbered_files(pattern: pathlib.Path) -> List[pathlib.Path]:
    """Returns the files that match a name with a run of #, in order; without #, the file itself. Raises FarmError."""
    if "#" not in pattern.name:
        return [pattern]
    number = re.compile(re.sub(r"(\\#)+", r"-?\\d+", re.escape(pattern.name)))
    found = sorted(path for path in pattern.parent.glob("*") if number.fullmatch(path.name))
    if not found:
        raise FarmError(f"The job moves by {pattern}, and there is none", "correct the job's `motion`", BAD_INPUT)
    return found


def bytes_of(path: pathlib.Path) -> bytes:
    """Reads a file. Raises OSError if it cannot be read, also for pipes and devices, which could block."""
    if path.exists() and not path.is_file():
        raise OSError(f"{path} is a folder, a pipe or a device")
    return path.read_bytes()


def copy_changed(source: pathlib.Path, target: pathlib.Path, member: str) -> bool:
    """Copies a file that a member of the job names unless the target has the same bytes. Raises FarmError."""
    try:
        content = bytes_of(source)
    except OSError as error:
        step = f"correct the job's `{member}`" + (", or export one with `pelage farm pack`" if member == "scene" else "")
        raise FarmError(f"The job's {member} cannot be read: {error}", step, BAD_INPUT) from error
    if target.exists() and target.read_bytes() == content:
        return False
    target.parent.mkdir(exist_ok=True)
    write_whole(target, content)
    shutil.copymode(source, target)
    return True


def farm_folder(path: str) -> FarmFolder:
    """Returns the FarmFolder at a path: a folder made by `submit`, or the job file that it was made from."""
    given = pathlib.Path(path)
    return FarmFolder(given if given.is_dir() else default_folder(given))


def default_folder(job: pathlib.Path) -> pathlib.Path:
    """Returns the default folder of a job, beside it: fox.farm for fox.json."""
    return job.with_suffix(".farm")
