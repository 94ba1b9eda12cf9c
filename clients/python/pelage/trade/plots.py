"""The plots of the report, each an svg."""

from __future__ import annotations

import math
from typing import Dict, List, NamedTuple, Sequence

from .choices import Point, pareto_front
from .markup import Element, tag
from .table import Row, milliseconds, scenes_of

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#555555")  # Okabe and Ito 2008
TIER_COLOURS = {"draft": COLOURS[0], "interactive": COLOURS[1], "detailed": COLOURS[2]}
GREY = "#888"
ERROR = "error (masked FLIP)"


class Axis(NamedTuple):
    """A logarithmic scale: `low` to `high` lie from pixel `start` to `end`."""

    low: float
    high: float
    start: float
    end: float

    def __call__(self, value: float) -> float:
        """Returns the pixel of a value, clamped to the axis."""
        held = min(max(value, self.low), self.high)
        return self.start + math.log(held / self.low) / math.log(self.high / self.low) * (self.end - self.start)

    def ticks(self, room: float) -> List[float]:
        """Returns ticks at 1, 2 and 5 of every decade, or at 1 only if labels `room` pixels wide would not fit."""
        first, last = math.floor(math.log10(self.low)), math.ceil(math.log10(self.high))
        is_dense = abs(self.end - self.start) / math.log10(self.high / self.low) > 3 * room
        ticks = [step * 10.0**power for power in range(first, last + 1) for step in ((1, 2, 5) if is_dense else (1,))]
        return [tick for tick in ticks if self.low <= tick * 1.001 and tick <= self.high * 1.001]


def axis_for(values: Sequence[float], start: float, end: float) -> Axis:
    """Returns an axis a little wider than the values, at least a factor of 2. Ignores values that are not positive."""
    shown = [value for value in values if 0 < value < math.inf] or [0.3]
    low, high = min(shown), max(shown)
    middle = math.sqrt(low * high)
    return Axis(min(low / 1.15, middle / 1.5), max(high * 1.15, middle * 1.5), start, end)


def label(x: float, y: float, text: str, anchor: str = "start", fill: str = "#333") -> Element:
    """anchor: start, middle or end."""
    return tag("text", text, x=x, y=y, text_anchor=anchor, fill=fill)


def dot(x: float, y: float, radius: float, colour: str, hint: str = "", hollow: bool = False) -> Element:
    """hint: Tooltip text."""
    fill, stroke = ("#fff", colour) if hollow else (colour, "none")
    return tag("circle", tag("title", hint), cx=x, cy=y, r=radius, fill=fill, stroke=stroke, stroke_width=1.5)


def line(points: Sequence[Point], colour: str, width: float = 1.0, dashes: str = "none") -> Element:
    text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return tag("polyline", points=text, fill="none", stroke=colour, stroke_width=width, stroke_dasharray=dashes)


def x_axis(x: Axis, top: float, bottom: float, title: str) -> List[Element]:
    middle = (x.start + x.end) / 2
    parts = [line([(x.start, bottom), (x.end, bottom)], GREY), label(middle, bottom + 36, title, "middle")]
    for tick in x.ticks(30):
        parts += [line([(x(tick), top), (x(tick), bottom)], "#e8e4de"),
                  label(x(tick), bottom + 16, f"{tick:.4g}", "middle", "#666")]
    return parts


def y_axis(y: Axis, left: float, right: float, title: str) -> List[Element]:
    turned = f"translate({left - 46} {(y.start + y.end) / 2}) rotate(-90)"
    parts = [line([(left, y.start), (left, y.end)], GREY), tag("text", title, transform=turned, text_anchor="middle")]
    for tick in y.ticks(14):
        parts += [line([(left, y(tick)), (right, y(tick))], "#e8e4de"),
                  label(left - 6, y(tick) + 4, f"{tick:.4g}", "end", "#666")]
    return parts


def axes(x: Axis, y: Axis, x_title: str, y_title: str) -> List[Element]:
    return x_axis(x, y.end, y.start, x_title) + y_axis(y, x.start, x.end, y_title)


def svg(width: float, height: float, title: str, parts: Sequence[Element]) -> Element:
    """title: Text for screen readers."""
    return tag("svg", tag("title", title), *parts, width=width, height=height, viewBox=f"0 0 {width:g} {height:g}",
               role="img", font_size="12", font_family="sans-serif")


def hint_of(row: Row) -> str:
    return f"{row.name}: {milliseconds(row.cost)} ms, FLIP {row.flip:.4f}, silhouette {row.silhouette:.4f}"


def scatter_plot(rows: Sequence[Row], scene: str) -> Element:
    """Plots error against cost for every setting on one scene, with the Pareto front and the tiers."""
    ours = [row for row in rows if row.scene == scene]
    tiers = [row for row in ours if row.series == "tier"]
    others: Dict[str, Row] = {row.knobs: row for row in ours if row.series != "tier"}
    x = axis_for([row.cost for row in ours], 64, 504)
    y = axis_for([row.flip for row in ours], 328, 28)
    front = pareto_front([(row.cost, row.flip) for row in ours])
    parts = axes(x, y, "drawing, milliseconds", ERROR)
    parts.append(line([(x(cost), y(flip)) for cost, flip in front], "#b08d57", 2))
    parts += [dot(x(row.cost), y(row.flip), 3.2, "#9a948a", hint_of(row)) for row in others.values()]
    for row in tiers:  # last, so that nothing hides them
        colour = TIER_COLOURS[row.value]
        parts += [dot(x(row.cost), y(row.flip), 7, colour, hint_of(row)),
                  label(x(row.cost), y(row.flip) - 12, row.value, "middle", colour)]
    return svg(540, 380, f"Error against cost: {scene}", parts)


def knob_plots(rows: Sequence[Row], scene: str) -> Element:
    """Returns a small plot for each knob: the curve of error against cost as the knob varies, on one scene."""
    ours = [row for row in rows if row.scene == scene]
    knobs = dict.fromkeys(row.series for row in ours if row.series not in ("tier", "grid"))
    return tag("div", *(knob_plot(ours, knob) for knob in knobs), class_="panels")


def knob_plot(rows: Sequence[Row], knob: str) -> Element:
    colour = TIER_COLOURS["interactive"]
    x = axis_for([row.cost for row in rows], 56, 272)
    y = axis_for([row.flip for row in rows], 174, 24)
    parts = [label(56, 14, knob, "start", "#222"), *axes(x, y, "ms", "error")]
    parts += [dot(x(row.cost), y(row.flip), 1.6, "#d6d0c6") for row in rows]
    turned = [row for row in rows if row.series == knob]
    points = [(x(row.cost), y(row.flip)) for row in turned]
    parts.append(line(points, colour, 2))
    parts += [dot(*point, 4, colour, hint_of(row)) for point, row in zip(points, turned)]
    parts += [label(a + 6, b + (15 if n % 2 else -5), row.value, "start", colour)  # alternates above and below
              for n, ((a, b), row) in enumerate(zip(points, turned))]
    return svg(300, 220, f"What {knob} buys", parts)


def tier_plot(rows: Sequence[Row]) -> Element:
    """Plots the tiers' errors on every scene, over the fur and at its silhouette."""
    scenes = scenes_of(rows)
    tiers = [row for row in rows if row.series == "tier"]
    left, top, step = 390.0, 34.0, 26.0
    bottom = top + step * len(scenes)
    x = axis_for([error for row in tiers for error in (row.flip, row.silhouette)], left, 930)
    parts = [*tier_key(16), *x_axis(x, top, bottom, "error (masked FLIP), less is better")]
    parts += [label(left - 12, top + step * (n + 0.5) + 4, scene, "end") for n, scene in enumerate(scenes)]
    for row in tiers:
        y = top + step * (scenes.index(row.scene) + 0.5)
        hint, colour = f"{row.scene}, {hint_of(row)}", TIER_COLOURS[row.value]
        if row.silhouette > 0:
            parts.append(dot(x(row.silhouette), y, 5, colour, hint, hollow=True))
        parts.append(dot(x(row.flip), y, 6, colour, hint))
    return svg(960, bottom + 50, "Where the tiers lie", parts)


def tier_key(y: float) -> List[Element]:
    parts = [dot(730, y - 4, 5, "#555", hollow=True), label(741, y, "hollow: in the silhouette")]
    for n, (tier, colour) in enumerate(TIER_COLOURS.items()):
        parts += [dot(400 + 110 * n, y - 4, 6, colour), label(411 + 110 * n, y, tier, "start", colour)]
    return parts


def strands_plot(rows: Sequence[Row]) -> Element:
    """Plots error against strands per pixel on every scene."""
    turned = [row for row in rows if row.series == "strands"]
    x, y = axis_for([row.strands for row in turned], 64, 544), axis_for([row.flip for row in turned], 346, 16)
    parts = axes(x, y, "strands a pixel; 1000 keeps all", ERROR)
    for n, scene in enumerate(scenes_of(turned)):
        colour, points = COLOURS[n % len(COLOURS)], [(row.strands, row.flip) for row in turned if row.scene == scene]
        parts.append(line([(x(a), y(b)) for a, b in points], colour, 1.8, "5 4" if n >= len(COLOURS) else "none"))
        parts += [dot(x(a), y(b), 3.5, colour, f"{scene}: {a:g} strands a pixel, FLIP {b:.4f}") for a, b in points]
        parts += [dot(562, 26 + 18 * n, 4, colour), label(572, 30 + 18 * n, scene)]
    return svg(1000, 400, "Error against strands", parts)
