"""Draws frames and measures their cost and their error against the truth, a traced reference picture."""

from __future__ import annotations

import json
import pathlib
import shutil
import subprocess
import tempfile
from typing import Any, NamedTuple

from ..arrays import numpy_module
from ..errors import PelageError
from ..frame import Frame
from ..scene import Scene
from ..schemas import Knobs
from .cases import Vector

CLIENT = "pelage"
LUMINANCE = [0.2126, 0.7152, 0.0722]
PAPER = [0.35, 0.35, 0.35]  # linear grey behind the pictures of the report
LONGEST_SECONDS = 86400  # timeout of a frame; the reference picture takes long


class Shot(NamedTuple):
    """A frame in linear light, and what it cost.

    non_finite: Number of pixels. luminance: Mean weighted by alpha. coverage: Sum of alpha.
    draw_ms, cpu_ms: Time of drawing; cpu_ms is the sum of all threads, 0 if the server does not report it.
    """

    exr: bytes
    non_finite: int
    luminance: float
    coverage: float
    draw_ms: float
    cpu_ms: float


class View:
    """A scene and the viewpoint from which its frames are drawn."""

    def __init__(self, scene: Scene, towards: Vector, size: int) -> None:
        """towards: Vector from the middle of the scene's box to the camera, in sizes. size: Width and height in pixels."""
        info = scene.info()
        self.middle = [(low + high) / 2 for low, high in zip(info["bounds"]["min"], info["bounds"]["max"])]
        self.towards = [info["size"] * part for part in towards]
        self.scene, self.size = scene, size

    def exr(self, knobs: Knobs) -> bytes:
        return self._frame(knobs, format="exr", exr_type="float").bytes

    def jpeg(self, knobs: Knobs) -> bytes:
        """Draws a tone-mapped JPEG over grey."""
        return self._frame(knobs, format="jpeg", lossy_quality=84, background=PAPER).bytes

    def shoot(self, knobs: Knobs, repeats: int = 1) -> Shot:
        """Draws a frame; its times are the minimum of `repeats` frames."""
        numpy = numpy_module()
        exr = self.exr(knobs)  # first, so that work that frames share, such as growing strands, is not timed
        # The camera moves a little each time, because the server caches frames.
        moves = [1 + 1e-5 * count for count in range(1, repeats + 1)]
        frames = [self._frame(knobs, move, format="npy_linear") for move in moves]
        pixels = frames[0].array()
        finite = numpy.isfinite(pixels).all(axis=2)
        light, alpha = (pixels[finite, :3] @ LUMINANCE).sum(), pixels[finite, 3].sum(dtype=float)
        return Shot(
            exr=exr,
            non_finite=int((~finite).sum()),
            luminance=float(light / alpha) if alpha > 0 else 0.0,
            coverage=float(alpha),
            draw_ms=min(frame.timing.get("draw", 0.0) for frame in frames),
            cpu_ms=min(frame.timing.get("cpu", 0.0) for frame in frames),
        )

    def _frame(self, knobs: Knobs, move: float = 1.0, **request: Any) -> Frame:
        position = [at + move * part for at, part in zip(self.middle, self.towards)]
        return self.scene.frame(
            width=self.size, height=self.size, camera={"position": position, "target": self.middle}, quality=knobs,
            max_seconds=LONGEST_SECONDS, **request,
        )


class Difference(NamedTuple):
    """FLIP over the fur: mean and 95th percentile; the same at the silhouette; and a PNG map of the errors."""

    flip: float
    flip_95: float
    silhouette: float
    silhouette_95: float
    map: bytes


BROKEN = Difference(1.0, 1.0, 1.0, 1.0, b"")  # for a picture with NaN or infinity: the largest error


def client_program() -> str:
    """Returns the path of `pelage`. Raises PelageError if it is not on the PATH."""
    found = shutil.which(CLIENT)
    if found is None:
        raise PelageError(f"There is no program {CLIENT} on the PATH; it compares pictures, and belongs beside pelage-trade.")
    return found


def difference(truth: bytes, picture: bytes) -> Difference:
    """Compares two EXR files with `pelage compare`."""
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
    """The picture that others are measured against: every strand traced.

    luminance, coverage: As in `Shot`, from half the passes, which are enough for means.
    floor: FLIP against half the passes; it estimates the error of all passes against infinitely many.
    """

    knobs: Knobs
    exr: bytes
    luminance: float
    coverage: float
    floor: float

    def difference(self, shot: Shot) -> Difference:
        return BROKEN if shot.non_finite else difference(self.exr, shot.exr)


def traced(passes: int) -> Knobs:
    """Returns the tier `reference` without its filter, so that remaining noise stays visible."""
    return {"method": "strands", "eye_steps": 16, "trace": {"passes": passes, "filter": False}}


def trace_truth(view: View, passes: int) -> Truth:
    half = view.shoot(traced(passes // 2))
    if half.non_finite:
        raise PelageError("The traced picture has pixels that are not finite: it is no truth.")
    exr = view.exr(traced(passes))
    return Truth(traced(passes), exr, half.luminance, half.coverage, difference(exr, half.exr).flip)
