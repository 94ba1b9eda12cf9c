"""How far a long request is."""

from __future__ import annotations

import sys
from typing import Callable, NamedTuple


class Progress(NamedTuple):
    """share: Fraction that is done, 0 to 1; 1 is reported once, at the end. text: The same in words."""

    share: float
    text: str


ReportProgress = Callable[[Progress], None]


def print_progress(progress: Progress) -> None:
    """Shows progress in one line on standard error and erases it at the end. Prints only on a terminal."""
    if not sys.stderr.isatty():
        return
    line = f"{progress.share:4.0%} {progress.text}" if progress.share < 1 else ""
    print(f"\r\033[K{line}", end="", file=sys.stderr, flush=True)
