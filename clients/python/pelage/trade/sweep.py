"""Draws a scene with all settings and measures them."""

from __future__ import annotations

import contextlib
from typing import Callable, Dict, Iterator, List, NamedTuple

from ..scene import Scene
from ..server import Server
from .cases import INTERACTIVE, Case, Setting, settings_for
from .measure import Difference, Shot, Truth, Truths, View
from .table import Row, milliseconds


class Options(NamedTuple):
    """size: Pixels of a side. truth: Shells of R1. passes: Of R2. repeats: Timed frames, of which the least counts."""

    quick: bool
    size: int
    truth: int
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
    """renderer: What drew, as the server says."""

    renderer: str
    options: Options
    rows: List[Row]
    pictures: List[Shown]


@contextlib.contextmanager
def staged(server: Server, case: Case) -> Iterator[Scene]:
    """The scene of a case. One that is made for it is removed again, also when something fails."""
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

    What the report has of the same scene, size, truth and knobs is not drawn again. Rows of other sizes go.
    """
    options, rows = report.options, report.rows
    others = [row for row in rows if row.scene != case.name and row.size == options.size]
    before = [row for row in rows if row.scene == case.name and (row.size, row.truth) == (options.size, options.truth)]
    rows[:] = others + before  # all of them until the end, for a run that is stopped
    known = {row.knobs: row for row in before if row.is_of_shells}
    with staged(server, case) as scene:
        sweeper = Sweeper(case, View(scene, case.towards, options.size), report)
        if case.swept:
            sweeper.show_truths()
        for setting in settings_for(case.swept, options.quick):
            rows += sweeper.rows_of(setting, known)
            done()
    del rows[len(others) : len(others) + len(before)]


class Sweeper:
    """Measures settings on one view."""

    def __init__(self, case: Case, view: View, report: Report) -> None:
        self.case, self.view, self.report = case, view, report
        self.truths = Truths(view, report.options.truth, report.options.passes)

    def show_truths(self) -> None:
        shells, strands = self.truths.shells(INTERACTIVE), self.truths.strands()
        error = shells.difference(strands.shot).flip
        self._show("R1", "the truth of shells", self.view.jpeg(shells.knobs))
        self._show("R2", f"every strand traced, {error:.3f} from R1", self.view.jpeg(strands.knobs))

    def rows_of(self, setting: Setting, known: Dict[str, Row]) -> List[Row]:
        """Measures a setting, or copies what is known of its knobs. Tiers are drawn where their pictures are shown."""
        is_shown = self.case.swept and setting.series == "tier"
        if setting.json in known and not is_shown:
            return [known[setting.json]._replace(series=setting.series, base=setting.base, value=setting.value)]
        rows = self._measure(setting, is_shown)
        known[setting.json] = rows[0]
        return rows

    def _measure(self, setting: Setting, is_shown: bool) -> List[Row]:
        """A row against R1; where the setting is shown, one against R2 as well."""
        shot = self.view.shoot(setting.knobs, self.report.options.repeats)
        shells = self.truths.shells(setting.knobs)
        error = shells.difference(shot)
        row = self._row(setting, shells, shot, error)
        if not is_shown:
            return [row]
        caption = f"error {row.flip:.4f}, silhouette {row.silhouette:.4f}, {milliseconds(row.cost)} ms"
        self._show(setting.value, caption, self.view.jpeg(setting.knobs), error.map)
        strands = self.truths.strands()
        return [row, self._row(setting, strands, shot, strands.difference(shot))]

    def _row(self, setting: Setting, truth: Truth, shot: Shot, error: Difference) -> Row:
        return Row(
            scene=self.case.name, size=self.report.options.size,
            series=setting.series, base=setting.base, value=setting.value,
            reference=truth.name, truth=truth.detail,
            shells=setting.knobs["shells"], steps=setting.knobs["steps"], scale=shot.scale,
            flip=error.flip, flip_95=error.flip_95, silhouette=error.silhouette, silhouette_95=error.silhouette_95,
            luminance=ratio(shot.luminance, truth.shot.luminance), coverage=ratio(shot.coverage, truth.shot.coverage),
            floor=truth.floor, non_finite=shot.non_finite, draw_ms=shot.draw_ms, cpu_ms=shot.cpu_ms, knobs=setting.json,
        )

    def _show(self, name: str, caption: str, image: bytes, map: bytes = b"") -> None:
        self.report.pictures.append(Shown(self.case.name, name, caption, image, map))


def ratio(value: float, truth: float) -> float:
    return value / truth if truth > 0 else 1.0
