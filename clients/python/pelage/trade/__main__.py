"""The program pelage-trade, which `pelage trade` becomes: results.csv and index.html in a folder."""

from __future__ import annotations

import argparse
import os
import re
import sys
import time
from typing import List, Optional, Sequence, Tuple, Type

from ..arrays import numpy_module
from ..errors import Busy, NotFound, PelageError, Refused, Unreachable
from ..files import write_whole
from ..progress import Progress, print_progress
from ..server import Server
from .cases import Case, built_in_cases, cases_of, settings_for
from .measure import LONGEST_SECONDS, client_program
from .page import page
from .sweep import Options, Report, sweep
from .table import Row, from_csv, to_csv

WRONG_USE = 2
# Exit code (same as those of `pelage`) and advice for an exception; the first class that matches counts.
ADVICE: List[Tuple[Type[Exception], int, str]] = [
    (Unreachable, 1, "start a server with `pelaged`, or name it with --server or PELAGE_SERVER"),
    (Busy, 1, "try again in a moment; the server has other work"),
    (NotFound, 3, "see what there is with `pelage list`"),
    (Refused, 3, "correct the value and try again; nothing was changed by it"),
    (PelageError, 1, "mend what it names and try again; the server's own output may say more"),
    (OSError, 1, "name a folder in which you may write"),
    (ValueError, 3, "start without --resume, or name another folder"),
]


def advice(error: Exception) -> Tuple[int, str]:
    if isinstance(error, Refused) and error.status == 401:
        return 1, "give the server's token with --token or PELAGE_TOKEN"
    return next((code, step) for kind, code, step in ADVICE if isinstance(error, kind))


def parser() -> argparse.ArgumentParser:
    """Returns a parser for the whole command line, which `pelage` has checked already; `pelage trade --help` explains it."""
    made = argparse.ArgumentParser("pelage-trade", description=__doc__, allow_abbrev=False)
    made.add_argument("action", nargs="?", choices=["trade"])
    for name in ("--server", "--token", "--author"):
        made.add_argument(name)
    for name in ("--json", "--quick", "--resume"):
        made.add_argument(name, action="store_true")
    made.add_argument("-o", "--output", required=True)
    made.add_argument("--scene", nargs="+", action="extend", default=[])
    for name, default in (("--size", 256), ("--passes", 64), ("--repeats", 2)):
        made.add_argument(name, type=int, default=default)
    return made


def options_of(line: argparse.Namespace) -> Options:
    passes = max(line.passes, 2)  # half of the passes must be a picture, too
    if line.quick:
        return Options(True, min(line.size, 96), min(passes, 16), 1)
    return Options(False, line.size, passes, line.repeats)


def cases_for(server: Server, names: Sequence[str], quick: bool) -> List[Case]:
    """Returns the cases of the scenes that the user names, else the built-in ones."""
    if not names:
        return built_in_cases(quick)
    return [case for name in names for case in cases_of(server.open(name)) if case.swept or not quick]


def renderer_of(server: Server) -> str:
    names = (re.fullmatch(r'pelage_renderer_info\{renderer="(.*)"\}', name) for name in server.metrics())
    return next((name[1] for name in names if name), "a renderer that the server does not name")


def rows_before(path: str) -> List[Row]:
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return from_csv(file.read())


def measure(server: Server, cases: Sequence[Case], table: str, report: Report) -> None:
    """Measures all cases, and writes the table after each setting."""
    start, done = time.monotonic(), 0
    work = sum(len(settings_for(case.swept, report.options.quick)) for case in cases)

    def settled() -> None:
        nonlocal done
        done += 1
        write_whole(table, to_csv(report.rows).encode())
        left = (time.monotonic() - start) / done * (work - done)
        print_progress(Progress(done / work, f"about {left:.0f} s left: {case.name}"))

    for case in cases:
        sweep(server, case, report, settled)


def write_report(server: Server, line: argparse.Namespace) -> None:
    numpy_module()  # fails before anything is drawn, as the next line does
    client_program()
    cases = cases_for(server, line.scene, line.quick)
    os.makedirs(line.output, exist_ok=True)
    table = os.path.join(line.output, "results.csv")
    rows = rows_before(table) if line.resume else []
    report = Report(renderer_of(server), options_of(line), rows, [])
    measure(server, cases, table, report)
    write_whole(table, to_csv(report.rows).encode())
    write_whole(os.path.join(line.output, "index.html"), page(report).encode())
    print(f"{line.output}/index.html\n{table}")


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Returns the exit code: 0 done, 1 failed, 2 wrong use, 3 the input was refused."""
    line = parser().parse_intermixed_args(arguments)
    try:
        server = Server(line.server, line.token, timeout=LONGEST_SECONDS)
    except ValueError as error:
        print(f"pelage: {error}", file=sys.stderr)
        return WRONG_USE
    try:
        with server:
            write_report(server, line)
    except (PelageError, OSError, ValueError) as error:
        code, step = advice(error)
        print(f"pelage: {error}\n  next:    {step}", file=sys.stderr)
        return code
    return 0


if __name__ == "__main__":
    sys.exit(main())
