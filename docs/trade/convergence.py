"""Draws how the error of shells falls with their number, from the second table of tiers.md.

usage: docs/trade/convergence.py        (writes convergence.svg beside tiers.md)
"""
import math
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent
WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 640, 400, 60, 30, 150, 45
COLOURS = {"aovs": "#c8553d", "sorted": "#20639b"}
LOW, HIGH = 0.001, 0.2


def rows():
    """Shells, and animal, order of fragments, errors and slopes (FLIP, RMS) of each line."""
    table = (FOLDER / "tiers.md").read_text(encoding="utf-8").split("FLIP to R1 by shells")[1]
    lines = [[cell.strip() for cell in line.strip("| ").split("|")] for line in table.splitlines() if line.startswith("| ")]
    shells = [int(cell) for cell in lines[0][2:-2]]
    return shells, [(line[0], line[1], [float(cell) for cell in line[2:-2]], line[-2:]) for line in lines[1:]]


def main():
    shells, lines = rows()

    def x(count):
        share = math.log2(count / shells[0]) / math.log2(shells[-1] / shells[0])
        return LEFT + share * (WIDTH - LEFT - RIGHT)

    def y(error):
        return TOP + math.log(HIGH / error) / math.log(HIGH / LOW) * (HEIGHT - TOP - BOTTOM)

    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#faf8f4"/>']
    for error in (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2):
        svg.append(f'<path d="M{LEFT} {y(error):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>'
                   f'<text x="{LEFT - 6}" y="{y(error) + 4:.1f}" text-anchor="end">{error:g}</text>')
    for count in shells:
        svg.append(f'<text x="{x(count):.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{count}</text>')
    svg.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" text-anchor="middle">shells, 4 steps</text>'
               f'<text x="{LEFT}" y="{TOP - 12}">masked FLIP to 256 sorted shells; fitted order</text>')
    ends = {name: [] for name in COLOURS}
    for animal, order, errors, slopes in lines:
        points = " ".join(f"{x(count):.1f},{y(error):.1f}" for count, error in zip(shells, errors))
        svg.append(f'<polyline points="{points}" fill="none" stroke="{COLOURS[order]}" stroke-width="1.5" opacity=".8">'
                   f"<title>{animal}, {order}: {' '.join(slopes)}</title></polyline>")
        ends[order].append((errors[-1], [float(slope) for slope in slopes]))
    for order, values in ends.items():
        flip, rms = ([slopes[k] for _, slopes in values] for k in (0, 1))
        middle = sum(math.log(error) for error, _ in values) / len(values)
        for line, words in enumerate((f"{order}: {min(flip):.2f} to {max(flip):.2f}", f"RMS: {min(rms):.2f} to {max(rms):.2f}")):
            svg.append(f'<text x="{WIDTH - RIGHT + 8}" y="{y(math.exp(middle)) + 4 + 16 * line:.1f}" fill="{COLOURS[order]}">'
                       f"{words}</text>")
    (FOLDER / "convergence.svg").write_text("\n".join(svg) + "\n</svg>\n", encoding="utf-8")


main()
