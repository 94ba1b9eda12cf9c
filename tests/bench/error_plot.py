"""Draws error over time of all three drawers from what bench_marched prints: the mean over its views of each way to
draw a frame. Naive shells and the GL are held to sorted shells, the marcher to its own limit.

usage: bench_marched > marched.txt; error_plot.py PICTURE.svg marched.txt
"""
import collections
import math
import pathlib
import re
import sys

import log_plot

LINE = re.compile(r"^  (\S.*?)\s+cpu\s+([\d.]+) wall\s+[\d.]+ \| sorted ([\d.]+) .*\| limit ([\d.]+) ", re.M)


def drawer_of(name):
    return "naive shells" if name.startswith("naive") else "marched" if "/" in name else "GL, " + name


def mean(values):
    """Geometric, since views differ by factors."""
    return math.exp(sum(map(math.log, values)) / len(values))


def main():
    ways = collections.defaultdict(list)
    for name, cpu, to_sorted, to_limit in LINE.findall(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")):
        ways[name].append((float(cpu), float(to_limit if drawer_of(name) == "marched" else to_sorted)))
    drawers = collections.defaultdict(list)
    for name, points in ways.items():
        drawers[drawer_of(name)].append(tuple(mean(values) for values in zip(*points)))
    views = max(len(points) for points in ways.values())
    series = [(drawer, sorted(points), len(points) > 1) for drawer, points in drawers.items()]
    log_plot.write(sys.argv[1], series, f"CPU ms, mean of {views} views at 512 x 512", "masked FLIP to the limit")


main()
