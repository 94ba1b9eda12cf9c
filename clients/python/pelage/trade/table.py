"""One row for each measured setting, and their table as CSV."""

from __future__ import annotations

import csv
import io
from typing import List, NamedTuple, Sequence, get_type_hints


class Row(NamedTuple):
    """A setting of the knobs on a scene, measured against its traced truth. FLIP is in [0, 1], over the fur.

    size: Width and height in pixels.
    passes: Passes of the truth.
    series, value: What is varied ("tier", "grid" or a knob of `interactive`), and its value.
    strands, light_of, scale: The knobs.
    silhouette: FLIP in the band around the fur's edge; 0 where there is no edge.
    luminance, coverage: Mean luminance of the fur and sum of alpha, relative to the truth.
    floor: Estimated FLIP error of the truth itself.
    non_finite: Number of pixels with NaN or infinity.
    draw_ms, cpu_ms: Minimum of the repeats; cpu_ms is the sum of all threads, 0 if the server does not report it.
    knobs: JSON, as a request's `quality`.
    """

    scene: str
    size: int
    passes: int
    series: str
    value: str
    strands: float
    light_of: int
    scale: float
    flip: float
    flip_95: float
    silhouette: float
    silhouette_95: float
    luminance: float
    coverage: float
    floor: float
    non_finite: int
    draw_ms: float
    cpu_ms: float
    knobs: str

    @property
    def name(self) -> str:
        """The setting in words."""
        if self.series == "tier":
            return self.value
        if self.series == "grid":
            return f"{self.strands:g} strands a pixel, light of {self.light_of}, scale {self.scale:g}"
        return f"interactive with {self.series} {self.value}"

    @property
    def cost(self) -> float:
        """CPU milliseconds if the server reports them, else elapsed ones."""
        return self.cpu_ms if self.cpu_ms > 0 else self.draw_ms


KINDS = get_type_hints(Row)


def to_csv(rows: Sequence[Row]) -> str:
    text = io.StringIO(newline="")
    csv.writer(text).writerows([Row._fields, *rows])
    return text.getvalue()


def from_csv(text: str) -> List[Row]:
    """Parses the CSV table. Raises ValueError for wrong columns or an invalid line."""
    lines = csv.reader(io.StringIO(text, newline=""))
    if tuple(next(lines, ())) != Row._fields:
        raise ValueError("The table has other columns.")
    return [row_of(line, number) for number, line in enumerate(lines, 1)]


def row_of(line: Sequence[str], number: int) -> Row:
    try:
        return Row(**{name: KINDS[name](field) for name, field in zip(Row._fields, line)})
    except (TypeError, ValueError):
        raise ValueError(f"Row {number} of the table is broken.") from None


def scenes_of(rows: Sequence[Row]) -> List[str]:
    """All scenes, in the order of the rows."""
    return list(dict.fromkeys(row.scene for row in rows))


def swept_scenes(rows: Sequence[Row]) -> List[str]:
    """Returns the scenes that have a grid of settings."""
    return scenes_of([row for row in rows if row.series == "grid"])


def milliseconds(value: float) -> str:
    """Formats with three significant digits, without an exponent."""
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"
