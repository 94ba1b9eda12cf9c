"""Plots how the error of traced pictures falls, from the output of bench_strands --converge.

usage: bench_strands --converge 1024 --passes 256 > fast.txt; bench_strands --paths --converge 1024 --passes 256 > paths.txt
       convergence_plot.py PICTURE.svg transmittance=fast.txt paths=paths.txt
"""
import math
import pathlib
import re
import sys

import log_plot


def points_of(file):
    found = re.findall(r"(\d+) passes: RMSE ([\d.]+)", pathlib.Path(file).read_text(encoding="utf-8"))
    return [(int(passes), float(error)) for passes, error in found]


def slope(points):
    xs, ys = [math.log2(p) for p, _ in points], [math.log2(e) for _, e in points]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


def main():
    named = [(name, points_of(file)) for name, file in (argument.split("=") for argument in sys.argv[2:])]
    series = [(f"{name}: passes^{slope(points):.2f}", points, True) for name, points in named]
    passes = max((points for _, points in named), key=len)
    start = max(points[0][1] for _, points in named)
    series.append(("passes^-0.5", [(count, start / math.sqrt(count)) for count, _ in passes], True))
    log_plot.write(sys.argv[1], series, "passes", "RMSE, linear light", [count for count, _ in passes])


main()
