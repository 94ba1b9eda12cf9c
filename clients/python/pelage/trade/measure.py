"""Frames, what they cost, and how far they are from the truth."""

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
LONGEST_SECONDS = 86400  # of a frame: the truth takes long


class Shot(NamedTuple):
    """A frame in linear light, and what it cost.

    non_finite: Pixels. luminance: Mean over alpha. coverage: Sum of alpha.
    draw_ms, cpu_ms: Of drawing; cpu_ms of all threads, 0 where the server does not say.
    """

    exr: bytes
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
        return self._frame(knobs, format="jpeg", lossy_quality=84, background=PAPER).bytes

    def shoot(self, knobs: Knobs, repeats: int = 1) -> Shot:
        """Each time is the least of so many frames."""
        numpy = numpy_module()
        exr = self.exr(knobs)  # first, so that what frames share, such as grown strands, is in no time
        # The camera is moved a little each time: a server does not draw again what it has drawn.
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
    """What pictures are measured against: every strand traced.

    luminance, coverage: As of a `Shot`, from half the passes, which are enough for means.
    floor: FLIP against half the passes. It is about what all passes differ from endless ones.
    """

    knobs: Knobs
    exr: bytes
    luminance: float
    coverage: float
    floor: float

    def difference(self, shot: Shot) -> Difference:
        return BROKEN if shot.non_finite else difference(self.exr, shot.exr)


def traced(passes: int) -> Knobs:
    """The tier `reference`, without its filter: noise that a truth has left is to be seen as such."""
    return {"method": "strands", "eye_steps": 16, "trace": {"passes": passes, "filter": False}}


def trace_truth(view: View, passes: int) -> Truth:
    half = view.shoot(traced(passes // 2))
    if half.non_finite:
        raise PelageError("The traced picture has pixels that are not finite: it is no truth.")
    exr = view.exr(traced(passes))
    return Truth(traced(passes), exr, half.luminance, half.coverage, difference(exr, half.exr).flip)
