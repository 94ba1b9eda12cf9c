"""Frames, what they cost, and how far they are from the truths."""

from __future__ import annotations

import json
import pathlib
import shutil
import subprocess
import tempfile
from typing import Any, Dict, NamedTuple, cast

from ..arrays import numpy_module
from ..errors import PelageError
from ..frame import Frame
from ..scene import Scene
from ..schemas import Knobs, Tracing
from .cases import INTERACTIVE, Vector, changed

CLIENT = "pelage"
PLAIN = "R1"  # with the shadows of the default knobs
LUMINANCE = [0.2126, 0.7152, 0.0722]
PAPER = [0.35, 0.35, 0.35]  # linear grey behind the pictures of the report
LONGEST_SECONDS = 86400  # of a frame: the truths take long


class Shot(NamedTuple):
    """A frame in linear light, and what it cost.

    scale: As it was drawn. non_finite: Pixels. luminance: Mean over alpha. coverage: Sum of alpha.
    draw_ms, cpu_ms: Of drawing, shadows included; cpu_ms of all threads, 0 where the server does not say.
    """

    exr: bytes
    scale: float
    non_finite: int
    luminance: float
    coverage: float
    draw_ms: float
    cpu_ms: float


class View:
    """Where frames of a scene are seen from."""

    def __init__(self, scene: Scene, towards: Vector, size: int) -> None:
        """towards: From the middle of the scene's box, in sizes. size: Pixels of a side."""
        info = scene.info()
        self.middle = [(low + high) / 2 for low, high in zip(info["bounds"]["min"], info["bounds"]["max"])]
        self.towards = [info["size"] * part for part in towards]
        self.scene, self.size = scene, size

    def exr(self, knobs: Knobs) -> bytes:
        return self._frame(knobs, format="exr", exr_type="float").bytes

    def jpeg(self, knobs: Knobs) -> bytes:
        """As it is shown, over grey."""
        return self._frame(knobs, format="jpeg", jpeg_quality=84, background=PAPER).bytes

    def shoot(self, knobs: Knobs, repeats: int = 1) -> Shot:
        """Each time is the least of so many frames."""
        numpy = numpy_module()
        exr = self.exr(knobs)  # first, so that what frames share, such as shadow maps, is in no time
        # The camera is moved a little each time: a server does not draw again what it has drawn.
        moves = [1 + 1e-5 * count for count in range(1, repeats + 1)]
        frames = [self._frame(knobs, move, format="npy_linear") for move in moves]
        pixels = frames[0].array()
        finite = numpy.isfinite(pixels).all(axis=2)
        light, alpha = (pixels[finite, :3] @ LUMINANCE).sum(), pixels[finite, 3].sum(dtype=float)
        return Shot(
            exr=exr,
            scale=cast(Knobs, frames[0].quality).get("scale", 1.0),
            non_finite=int((~finite).sum()),
            luminance=float(light / alpha) if alpha > 0 else 0.0,
            coverage=float(alpha),
            draw_ms=min(frame.timing.get("draw", 0.0) + frame.timing.get("shadow", 0.0) for frame in frames),
            cpu_ms=min(frame.timing.get("cpu", 0.0) for frame in frames),
        )

    def _frame(self, knobs: Knobs, move: float = 1.0, **request: Any) -> Frame:
        position = [at + move * part for at, part in zip(self.middle, self.towards)]
        return self.scene.frame(
            width=self.size, height=self.size, camera={"position": position, "target": self.middle}, quality=knobs,
            max_seconds=LONGEST_SECONDS, **request,
        )


class Difference(NamedTuple):
    """FLIP of a picture over the fur: mean and 95th percentile, the same in its silhouette, and a PNG of the errors."""

    flip: float
    flip_95: float
    silhouette: float
    silhouette_95: float
    map: bytes


BROKEN = Difference(1.0, 1.0, 1.0, 1.0, b"")  # of a picture that is not finite: as wrong as can be


def client_program() -> str:
    """Raises PelageError where it is not on the PATH."""
    found = shutil.which(CLIENT)
    if found is None:
        raise PelageError(f"There is no program {CLIENT} on the PATH; it compares pictures, and belongs beside pelage-trade.")
    return found


def difference(truth: bytes, picture: bytes) -> Difference:
    """As `pelage compare` measures two EXR."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "truth.exr").write_bytes(truth)
        (folder / "picture.exr").write_bytes(picture)
        command = [client_program(), "--json", "compare", "truth.exr", "picture.exr", "--map", "map.png"]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        if run.returncode:
            raise PelageError(f"{CLIENT} compare failed: {run.stderr}")
        figures, png = json.loads(run.stdout), (folder / "map.png").read_bytes()
    flip, edge = figures["flip"], figures["silhouette"] or {"mean": 0.0, "percentile_95": 0.0}
    return Difference(flip["mean"], flip["percentile_95"], edge["mean"], edge["percentile_95"], png)


class Truth(NamedTuple):
    """What pictures are measured against.

    name: "R1" with its shadows, or "R2". detail: Shells of R1, or passes of R2. floor: FLIP against half the shells.
    """

    name: str
    knobs: Knobs
    shot: Shot
    detail: int
    floor: float = 0.0

    def difference(self, shot: Shot) -> Difference:
        return BROKEN if shot.non_finite else difference(self.shot.exr, shot.exr)


class Truths:
    """Those of one view, drawn when they are first asked for."""

    def __init__(self, view: View, shells: int, passes: int) -> None:
        """shells: Of R1. passes: Of R2."""
        self._view, self._shells, self._passes = view, shells, passes
        self._drawn: Dict[str, Truth] = {}

    def shells(self, knobs: Knobs) -> Truth:
        """R1: many sorted shells with the shadows of these knobs, and their scale where it is above 1.

        Shadows are the same, so that shells are measured and not light; what light leaves out is seen against R2. More
        samples of a pixel make another picture.
        """
        name = name_of_shells(knobs)
        if name not in self._drawn:
            truth = self._draw(name, converged(knobs, self._shells), self._shells)
            self._drawn[name] = truth._replace(floor=self._floor(truth))
        return self._drawn[name]

    def strands(self) -> Truth:
        """R2: every strand traced, lit by the look's own model."""
        if "R2" not in self._drawn:
            trace: Tracing = {"passes": self._passes, "scattering": "look"}
            self._drawn["R2"] = self._draw("R2", {"method": "strands", "eye_steps": 16, "trace": trace}, self._passes)
        return self._drawn["R2"]

    def _draw(self, name: str, knobs: Knobs, detail: int) -> Truth:
        shot = self._view.shoot(knobs)
        if shot.non_finite:
            raise PelageError(f"{name} has pixels that are not finite: it is no truth.")
        return Truth(name, knobs, shot, detail)

    def _floor(self, truth: Truth) -> float:
        """Of the default knobs: shells are the same in any light."""
        if truth.name != PLAIN:
            return self.shells(INTERACTIVE).floor
        return difference(truth.shot.exr, self._view.exr(converged(INTERACTIVE, self._shells // 2))).flip


def converged(knobs: Knobs, shells: int) -> Knobs:
    """The knobs of R1 for these."""
    shadows = {name: knobs.get(name) for name in ("self_shadow", "shadow_maps", "shadow_resolution")}
    return changed(INTERACTIVE, shells=shells, scale=max(1.0, knobs["scale"]), order="sorted", **shadows)


def name_of_shells(knobs: Knobs) -> str:
    size = f"{PLAIN} at {knobs['scale']:g} times the size" if knobs["scale"] > 1 else PLAIN
    return f"{size} with maps of {knobs['shadow_resolution']}" if knobs["shadow_maps"] else size
