"""Draws how the error of shells falls with their number, from the second table of tiers.md.

usage: docs/trade/convergence.py        (writes convergence.svg beside tiers.md)
"""
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parents[1] / "tests" / "bench"))
import log_plot  # noqa: E402


def rows():
    """Shells, and animal, errors and the fitted order of each line."""
    table = (FOLDER / "tiers.md").read_text(encoding="utf-8").split("FLIP to R1 by shells")[1]
    lines = [[cell.strip() for cell in line.strip("| ").split("|")] for line in table.splitlines() if line.startswith("| ")]
    shells = [int(cell) for cell in lines[0][1:-1]]
    return shells, [(line[0], [float(cell) for cell in line[1:-1]], line[-1]) for line in lines[1:]]


def main():
    shells, lines = rows()
    series = [(f"{animal}: {order}", list(zip(shells, errors)), True) for animal, errors, order in lines]
    log_plot.write(FOLDER / "convergence.svg", series, "shells, 4 steps; beside the names the fitted order",
                   "masked FLIP to R1", shells)


main()
