"""The program pelage-farm, which `pelage farm` becomes."""

from __future__ import annotations

import argparse
import json
import signal
import sys
import time
from typing import Callable, Dict, List, Optional, Sequence

from ..errors import PelageError, Problem, Unreachable
from ..server import Server
from .check import BLACK, faults_of, frames_in, plan_for
from .errors import BAD_INPUT, FAILED, FarmError
from .folder import farm_folder
from .movie import clip_of, make_movie, make_sheet
from .pack import pack_model, pack_scene
from .ranges import range_of
from .status import Status, bar, status_of, summary, table
from .submit import ENGINES, Options, submit

WATCHED_EVERY = 2.0  # seconds


def parser() -> argparse.ArgumentParser:
    """Returns a parser for the whole command line, which `pelage` has checked already; `pelage farm --help` explains it."""
    made = argparse.ArgumentParser("pelage-farm", description=__doc__, allow_abbrev=False)
    made.add_argument("farm", choices=["farm"])
    actions = made.add_subparsers(dest="action", required=True)
    for name, add in ADDERS.items():
        add(actions.add_parser(name, allow_abbrev=False))
    return made


def add_pack(action: argparse.ArgumentParser) -> None:
    action.add_argument("scene", nargs="?")
    action.add_argument("-o", "--output", required=True)
    for name in ("--file", "--builtin", "--triangles", "--recipe"):
        action.add_argument(name)
    action.add_argument("--set", nargs="+", action="extend", default=[])


def add_submit(action: argparse.ArgumentParser) -> None:
    action.add_argument("job")
    given = action.add_argument
    given("--engine", choices=ENGINES)
    given("--chunk-seconds", type=float)
    given("--max-parallel", type=int, dest="at_once")
    given("--threads", type=int)
    for name in ("--folder", "--image", "--claim"):
        given(name)
    given("--dry-run", action="store_true")
    action.set_defaults(**Options._field_defaults)


def add_status(action: argparse.ArgumentParser) -> None:
    action.add_argument("folder")
    action.add_argument("--watch", action="store_true")


def add_check(action: argparse.ArgumentParser) -> None:
    action.add_argument("job")
    action.add_argument("--black", type=float, default=BLACK)


def add_movie(action: argparse.ArgumentParser) -> None:
    action.add_argument("frames")
    action.add_argument("-o", "--output", required=True)
    action.add_argument("--fps", type=float, default=0.0)
    action.add_argument("--width", type=int, default=0)


def add_sheet(action: argparse.ArgumentParser) -> None:
    action.add_argument("frames")
    action.add_argument("-o", "--output", required=True)
    for name, default in (("--count", 24), ("--columns", 6), ("--width", 240)):
        action.add_argument(name, type=int, default=default)


ADDERS: Dict[str, Callable[[argparse.ArgumentParser], None]] = {
    "pack": add_pack,
    "submit": add_submit,
    "status": add_status,
    "check": add_check,
    "movie": add_movie,
    "sheet": add_sheet,
}


def run_pack(line: argparse.Namespace) -> int:
    model: List[str] = []
    for name in ("file", "builtin", "triangles"):
        if getattr(line, name) is not None:
            model += [f"--{name}", getattr(line, name)]
    if bool(line.scene) == bool(model):
        step = "name a scene of the server, or --file or --builtin"
        raise FarmError("A scene is packed either from a server or from a model", step, 2)
    if line.scene:
        with Server(line.server, line.token) as server:
            size = pack_scene(server, line.scene, line.output)
    else:
        size = pack_model(model, line.recipe, line.set, line.output)
    print(f"{line.output}, {size / 1e6:.1f} MB")
    return 0


def run_submit(line: argparse.Namespace) -> int:
    return 0 if submit(Options(*(getattr(line, name) for name in Options._fields))) else FAILED


def run_status(line: argparse.Namespace) -> int:
    folder = farm_folder(line.folder)
    status = status_of(folder)
    while line.watch and not status.is_over:
        show(status)
        time.sleep(WATCHED_EVERY)
        status = status_of(folder)
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr, flush=True)
    print(json.dumps(status.to_json()) if line.json else table(folder, status))
    return FAILED if status.failed else 0


def show(status: Status) -> None:
    """Shows a progress bar that is redrawn in place on a terminal, else prints a line each time."""
    if sys.stderr.isatty():
        print(f"\r\033[K{bar(status)}", end="", file=sys.stderr, flush=True)
    else:
        print(summary(status), flush=True)


def run_check(line: argparse.Namespace) -> int:
    plan = plan_for(line.job)
    faults = faults_of(plan, line.black)
    if line.json:
        print(json.dumps({"frames": len(plan.frames), "faults": [fault.to_json() for fault in faults]}))
    else:
        for fault in faults:
            print(f"{fault.file}: {fault.kind}: {fault.words}")
        bad = frames_in(faults)
        print(f"{len(plan.frames)} frames, {len(bad)} with faults" + (f": {range_of(bad)}" if bad else ""))
    return FAILED if faults else 0


def run_movie(line: argparse.Namespace) -> int:
    clip = clip_of(line.frames)
    if clip.missing:
        step = "submit the job again; a clip of what is there takes a pattern, as out/fox.####.png"
        raise FarmError(f"Frames are missing: {range_of(clip.missing)}", step)
    make_movie(clip, line.output, line.fps, line.width)
    print(f"{line.output}, {len(clip.files)} frames")
    return 0


def run_sheet(line: argparse.Namespace) -> int:
    clip = clip_of(line.frames)
    shown = make_sheet(clip, line.output, line.count, line.columns, line.width)
    print(f"{line.output}, frames {range_of(shown)}" + (f"; missing: {range_of(clip.missing)}" if clip.missing else ""))
    return 0


RUNNERS: Dict[str, Callable[[argparse.Namespace], int]] = {
    "pack": run_pack,
    "submit": run_submit,
    "status": run_status,
    "check": run_check,
    "movie": run_movie,
    "sheet": run_sheet,
}


def advice(error: Exception) -> "tuple[int, str]":
    if isinstance(error, FarmError):
        return error.code, error.step
    if isinstance(error, Unreachable):
        return FAILED, "start a server with `pelaged`, or name it with --server or PELAGE_SERVER"
    if isinstance(error, Problem):
        return BAD_INPUT, "see what there is with `pelage list`"
    if isinstance(error, OSError):
        return FAILED, "name a folder in which you may write"
    return FAILED, "mend what it names and try again"


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Returns the exit code: 0 done, 1 failed or frames with faults, 2 wrong use, 3 the input was refused."""
    everywhere = argparse.ArgumentParser(add_help=False, allow_abbrev=False)  # options that are valid anywhere
    for name in ("--server", "--token", "--author"):
        everywhere.add_argument(name)
    everywhere.add_argument("--json", action="store_true")
    line, rest = everywhere.parse_known_args(arguments)
    line = parser().parse_args(rest, line)
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # so that SIGTERM, too, ends the tasks
    try:
        return RUNNERS[line.action](line)
    except KeyboardInterrupt:
        return 130
    except (PelageError, OSError, ValueError) as error:
        code, step = advice(error)
        print(f"pelage: {error}\n  next:    {step}", file=sys.stderr)
        return code


if __name__ == "__main__":
    sys.exit(main())
