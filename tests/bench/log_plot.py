"""Writes a plot with logarithmic axes as SVG: lines, or crosses for series of unordered points, with names at the right."""
import math
import pathlib

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 680, 420, 64, 20, 190, 50
COLOURS = ("#20639b", "#c8553d", "#3c8d40", "#8757a8", "#b8860b", "#2a9d8f", "#555555", "#c2378b")


def ticks(low, high):
    """1, 2 and 5 times the powers of ten within the range."""
    return [step * 10.0 ** power for power in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
            for step in (1, 2, 5) if low * .999 <= step * 10.0 ** power <= high * 1.001]


class Axis:
    """Maps values to coordinates between two ends of the picture, logarithmically."""

    def __init__(self, values, start, end):
        self.low, self.high, self.start, self.end = min(values) * .9, max(values) * 1.1, start, end

    def __call__(self, value):
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.start + share * (self.end - self.start)


def grid(x, y, x_title, y_title, x_ticks):
    lines = []
    for value in x_ticks or ticks(x.low, x.high):
        lines += [f'<path d="M{x(value):.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>',
                  f'<text x="{x(value):.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{value:g}</text>']
    for value in ticks(y.low, y.high):
        lines += [f'<path d="M{LEFT} {y(value):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>',
                  f'<text x="{LEFT - 8}" y="{y(value) + 4:.1f}" text-anchor="end">{value:g}</text>']
    lines += [f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" text-anchor="middle">{x_title}</text>',
              f'<text transform="translate(16 {HEIGHT / 2}) rotate(-90)" text-anchor="middle">{y_title}</text>']
    return lines


def drawn(points, colour, joined, x, y):
    pixels = [(x(a), y(b)) for a, b in points]
    if joined:
        line = " ".join(f"{a:.1f},{b:.1f}" for a, b in pixels)
        return [f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>']
    return [f'<path d="M{a - 4:.1f} {b - 4:.1f}l8 8m0 -8l-8 8" stroke="{colour}" stroke-width="2"/>' for a, b in pixels]


def write(file, series, x_title, y_title, x_ticks=None):
    """Writes the plot. `series` has a tuple (name, points, joined) for each; points are (x, y), all above 0."""
    every = [point for _, points, _ in series for point in points]
    x = Axis([a for a, _ in every], LEFT, WIDTH - RIGHT)
    y = Axis([b for _, b in every], HEIGHT - BOTTOM, TOP)
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#faf8f4"/>', *grid(x, y, x_title, y_title, x_ticks)]
    for i, (name, points, joined) in enumerate(series):
        colour = COLOURS[i % len(COLOURS)]
        lines += drawn(points, colour, joined, x, y)
        lines.append(f'<text x="{WIDTH - RIGHT + 10}" y="{TOP + 14 + 18 * i}" fill="{colour}">{name}</text>')
    pathlib.Path(file).write_text("\n".join([*lines, "</svg>"]) + "\n", encoding="utf-8")
