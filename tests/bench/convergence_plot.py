"""Draws how the error of traced pictures falls, from what bench_strands --converge prints.

usage: bench_strands --converge 1024 --passes 256 > fast.txt; bench_strands --paths --converge 1024 --passes 256 > paths.txt
       convergence_plot.py PICTURE.svg transmittance=fast.txt paths=paths.txt
"""
import math
import pathlib
import re
import sys

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 560, 380, 70, 20, 20, 50
COLOURS = ("#20639b", "#c8553d", "#3c8d40")


def points_of(file):
    found = re.findall(r"(\d+) passes: RMSE ([\d.]+)", pathlib.Path(file).read_text(encoding="utf-8"))
    return [(int(passes), float(error)) for passes, error in found]


def slope(points):
    xs, ys = [math.log2(p) for p, _ in points], [math.log2(e) for _, e in points]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


def main():
    series = [(name, points_of(file)) for name, file in (argument.split("=") for argument in sys.argv[2:])]
    every = [point for _, points in series for point in points]
    maximum = max(p for p, _ in every)
    low, high = math.floor(math.log10(min(e for _, e in every)) * 2) / 2, math.ceil(math.log10(max(e for _, e in every)) * 2) / 2

    def place(passes, error):
        x = LEFT + (WIDTH - LEFT - RIGHT) * math.log2(passes) / math.log2(maximum)
        y = TOP + (HEIGHT - TOP - BOTTOM) * (high - math.log10(error)) / (high - low)
        return f"{x:.1f},{y:.1f}"

    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="13">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for k in range(int(math.log2(maximum)) + 1):
        x, y = place(2 ** k, 10 ** low).split(",")
        lines += [f'<path d="M{x},{TOP}V{y}" stroke="#ddd"/>', f'<text x="{x}" y="{float(y) + 18}" text-anchor="middle">{2 ** k}</text>']
    for k in range(round(2 * low), round(2 * high) + 1):
        x, y = place(1, 10 ** (k / 2)).split(",")
        lines += [f'<path d="M{x},{y}H{WIDTH - RIGHT}" stroke="#ddd"/>',
                  f'<text x="{LEFT - 8}" y="{float(y) + 4}" text-anchor="end">{10 ** (k / 2):.3g}</text>']
    start = max(points[0][1] for _, points in series)
    lines.append(f'<path d="M{place(1, start)}L{place(most, max(start / math.sqrt(most), 10 ** low))}" stroke="#999" stroke-dasharray="5 4"/>')
    for i, (name, points) in enumerate(series):
        lines.append(f'<path d="M{"L".join(place(*p) for p in points)}" fill="none" stroke="{COLOURS[i]}" stroke-width="2"/>')
        lines.append(f'<text x="{WIDTH - RIGHT - 10}" y="{TOP + 20 + 20 * i}" text-anchor="end" fill="{COLOURS[i]}">'
                     f'{name}: passes^{slope(points):.2f}</text>')
    lines.append(f'<text x="{WIDTH - RIGHT - 10}" y="{TOP + 20 + 20 * len(series)}" text-anchor="end" fill="#777">dashed: passes^-0.5</text>')
    lines.append(f'<text x="{(LEFT + WIDTH) / 2}" y="{HEIGHT - 10}" text-anchor="middle">passes</text>')
    lines.append(f'<text transform="translate(18 {HEIGHT / 2}) rotate(-90)" text-anchor="middle">RMSE, linear light</text></svg>')
    pathlib.Path(sys.argv[1]).write_text("\n".join(lines) + "\n", encoding="utf-8")


main()
