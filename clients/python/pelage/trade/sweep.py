"""Draws a scene with all settings and measures them."""

from __future__ import annotations

import contextlib
import functools
from typing import Callable, Dict, Iterator, List, NamedTuple

from ..scene import Scene
from ..server import Server
from .cases import Case, Setting, settings_for
from .measure import Truth, View, trace_truth
from .table import Row, milliseconds


class Options(NamedTuple):
    """size: Width and height in pixels. passes: Passes of the truth. repeats: Timed frames; the fastest counts."""

    quick: bool
    size: int
    passes: int
    repeats: int


class Shown(NamedTuple):
    """A picture of the report. image: JPEG. map: PNG of its errors; empty for none."""

    scene: str
    name: str
    caption: str
    image: bytes
    map: bytes = b""


class Report(NamedTuple):
    """renderer: Name of the renderer, as the server reports it."""

    renderer: str
    options: Options
    rows: List[Row]
    pictures: List[Shown]


@contextlib.contextmanager
def staged(server: Server, case: Case) -> Iterator[Scene]:
    """Yields the scene of a case. A scene created for it is removed afterwards, also after an error."""
    if case.scene is not None:
        yield case.scene
        return
    scene = server.create("trade", model=case.model, fur={"length": 0.035})
    try:
        scene.run(*case.commands)
        yield scene
    finally:
        scene.remove()


def sweep(server: Server, case: Case, report: Report, done: Callable[[], None]) -> None:
    """Adds the rows and pictures of a scene to the report, and calls `done` after each setting.

    Rows of the same scene, size, passes and knobs are reused, not drawn again. Rows of other sizes are dropped.
    """
    options, rows = report.options, report.rows
    others = [row for row in rows if row.scene != case.name and row.size == options.size]
    before = [row for row in rows if row.scene == case.name and (row.size, row.passes) == (options.size, options.passes)]
    rows[:] = others + before  # keeps this scene's earlier rows until the end, in case the run is stopped
    known = {row.knobs: row for row in before}
    with staged(server, case) as scene:
        sweeper = Sweeper(case, View(scene, case.towards, options.size), report)
        if case.swept:
            sweeper.show_truth()
        for setting in settings_for(case.swept, options.quick):
            rows.append(sweeper.row_of(setting, known))
            done()
    del rows[len(others) : len(others) + len(before)]


class Sweeper:
    """Measures settings on one view."""

    def __init__(self, case: Case, view: View, report: Report) -> None:
        self.case, self.view, self.report = case, view, report

    @functools.cached_property
    def truth(self) -> Truth:
        """The truth; traced on first use, because a resumed report may not need it."""
        return trace_truth(self.view, self.report.options.passes)

    def show_truth(self) -> None:
        caption = f"every strand traced, {self.report.options.passes} passes"
        self._show("truth", caption, self.view.jpeg(self.truth.knobs))

    def row_of(self, setting: Setting, known: Dict[str, Row]) -> Row:
        """Measures a setting, or reuses the known row of its knobs. Tiers whose pictures are shown are drawn in any case,
        but keep a known row.
        """
        is_shown = self.case.swept and setting.series == "tier"
        if is_shown or setting.json not in known:
            known.setdefault(setting.json, self._measure(setting, is_shown))
        return known[setting.json]._replace(series=setting.series, value=setting.value)

    def _measure(self, setting: Setting, is_shown: bool) -> Row:
        shot, knobs = self.view.shoot(setting.knobs, self.report.options.repeats), setting.knobs
        error = self.truth.difference(shot)
        row = Row(
            scene=self.case.name, size=self.report.options.size, passes=self.report.options.passes,
            series=setting.series, value=setting.value,
            strands=knobs["raster"]["strands"], light_of=knobs["raster"]["light_of"], scale=knobs["scale"],
            flip=error.flip, flip_95=error.flip_95, silhouette=error.silhouette, silhouette_95=error.silhouette_95,
            luminance=ratio(shot.luminance, self.truth.luminance), coverage=ratio(shot.coverage, self.truth.coverage),
            floor=self.truth.floor, non_finite=shot.non_finite, draw_ms=shot.draw_ms, cpu_ms=shot.cpu_ms,
            knobs=setting.json,
        )
        if is_shown:
            caption = f"error {row.flip:.4f}, silhouette {row.silhouette:.4f}, {milliseconds(row.cost)} ms"
            self._show(setting.value, caption, self.view.jpeg(knobs), error.map)
        return row

    def _show(self, name: str, caption: str, image: bytes, map: bytes = b"") -> None:
        self.report.pictures.append(Shown(self.case.name, name, caption, image, map))


def ratio(value: float, truth: float) -> float:
    return value / truth if truth > 0 else 1.0
