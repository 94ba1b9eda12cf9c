"""The scenes to measure, and the quality settings to try on them."""

from __future__ import annotations

import json
import math
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, cast

from ..scene import Scene
from ..schemas import BuiltinModel, Knobs

Vector = Tuple[float, float, float]

NEAR, NEAR_PATCH, FAR = 1.35, 0.9, 4.0  # camera distances in sizes; the bounding sphere fills the picture at 1.7
COATS = {"white": "#efeae2", "dark": "#221c18"}


class Case(NamedTuple):
    """A scene seen from one side.

    towards: Vector from the middle of its box to the camera, in sizes.
    swept: True to measure all knobs and show pictures; False for tiers and strand counts only.
    scene: An existing scene; if None, `model` and `commands` create it.
    """

    name: str
    towards: Vector
    swept: bool
    scene: Optional[Scene] = None
    model: Optional[BuiltinModel] = None
    commands: Sequence[Dict[str, Any]] = ()


def direction(degrees_up: float, degrees_around: float) -> Vector:
    up, around = math.radians(degrees_up), math.radians(degrees_around)
    return (math.cos(up) * math.sin(around), math.sin(up), math.cos(up) * math.cos(around))


def times(vector: Vector, factor: float) -> Vector:
    return (vector[0] * factor, vector[1] * factor, vector[2] * factor)


def lights(lit_from: str, view: Vector) -> Dict[str, Any]:
    """Returns the command for a key light, from behind the camera or facing it, and a weak light from above."""
    x, y, z = view
    shines = [0.4 - x, -0.5 - y, -z] if lit_from == "the front" else [x, y - 0.6, z]
    directions = ((shines, 1.6), ([0, -1, 0.1], 0.3))
    return {
        "op": "set_lights",
        "lights": [{"direction": to, "intensity": bright, "cast_shadow": "penumbra"} for to, bright in directions],
    }


def built_in(
    builtin: str, coat: str, lit_from: str, distance: str, *, swept: bool = False, view: Vector = direction(25, 40),
    seen: str = "", triangles: int = 5000,
) -> Case:
    is_patch = builtin == "plane"
    near = NEAR_PATCH if is_patch else NEAR
    return Case(
        name=f"{'patch' if is_patch else builtin}{seen}, {coat} coat, lit from {lit_from}, {distance}",
        towards=times(view, near if distance == "near" else FAR),
        swept=swept,
        model=cast(BuiltinModel, {"builtin": builtin, "triangles": 800 if is_patch else triangles}),
        commands=[
            {"op": "set_coat", "coat": {"ramp": [{"at": 0, "colour": COATS[coat]}]}},
            {"op": "set_look", "look": {"colour_source": "coat"}},
            lights(lit_from, view),
        ],
    )


def built_in_cases(quick: bool) -> List[Case]:
    """Returns cases with white and dark fur, front-lit and back-lit, near and far. quick: One small sphere only."""
    if quick:
        return [built_in("sphere", "white", "the front", "near", swept=True, triangles=300)]
    return [
        built_in("creature", "white", "the front", "near", swept=True),
        built_in("creature", "dark", "the front", "near"),
        built_in("creature", "white", "behind", "near"),
        built_in("creature", "white", "the front", "far"),
        built_in("torus", "dark", "the front", "near", swept=True),
        built_in("torus", "white", "behind", "far"),
        built_in("sphere", "white", "the front", "near"),
        built_in("sphere", "dark", "behind", "near"),
        built_in("plane", "white", "the front", "near", view=direction(85, 20), seen=" seen from above"),
        built_in("plane", "white", "the front", "near", view=direction(40, 20), seen=" at 50 degrees"),
        built_in("plane", "white", "the front", "near", view=direction(12, 20), seen=" at 78 degrees", swept=True),
    ]


def cases_of(scene: Scene) -> List[Case]:
    """Returns the cases of a user's scene, unchanged, near and far."""
    side = direction(20, 35)
    return [
        Case(f"{scene.name}, near", times(side, NEAR), True, scene),
        Case(f"{scene.name}, far", times(side, FAR), False, scene),
    ]


def raster(strands: float = 1.4, light_of: int = 4, scale: float = 1.0, eye_steps: int = 8) -> Knobs:
    """Returns the knobs of the tier `interactive`, except for the given ones."""
    return {
        "method": "raster", "scale": scale, "eye_steps": eye_steps,
        "raster": {"strands": strands, "light_of": light_of},
    }


TIERS = {
    "draft": raster(strands=0.4, light_of=4, eye_steps=1),
    "interactive": raster(),
    "detailed": raster(strands=1000.0, light_of=3, scale=2.0, eye_steps=16),
}


class Setting(NamedTuple):
    """See `Row`."""

    series: str
    value: str
    knobs: Knobs

    @property
    def json(self) -> str:
        return json.dumps(self.knobs, separators=(",", ":"))


def strands_settings(quick: bool) -> List[Setting]:
    values = (0.2, 1.4, 1000.0) if quick else (0.1, 0.2, 0.4, 0.8, 1.4, 3.0, 6.0, 1000.0)
    return [Setting("strands", f"{value:g}", raster(strands=value)) for value in values]


def light_of_settings(quick: bool) -> List[Setting]:
    return [Setting("light_of", f"{value}", raster(light_of=value)) for value in ((1, 4) if quick else (1, 2, 4, 8))]


def scale_settings(quick: bool) -> List[Setting]:
    values = (0.5, 1.0) if quick else (0.5, 0.75, 1.0, 1.5, 2.0)
    return [Setting("scale", f"{value:g}", raster(scale=value)) for value in values]


def grid(quick: bool) -> List[Setting]:
    return [
        Setting("grid", f"{strands:g} x {light_of} x {scale:g}", raster(strands, light_of, scale))
        for strands in ((0.4, 1.4) if quick else (0.4, 1.4, 4.0, 1000.0))
        for light_of in ((1, 4) if quick else (1, 2, 4))
        for scale in ((0.5, 1.0) if quick else (0.5, 0.75, 1.0, 2.0))
    ]


def settings_for(swept: bool, quick: bool) -> List[Setting]:
    """Returns the tiers and strand counts; with `swept` also every knob of `interactive` and a grid. quick: Few values."""
    settings = [Setting("tier", name, knobs) for name, knobs in TIERS.items()] + strands_settings(quick)
    if swept:
        settings += light_of_settings(quick) + scale_settings(quick) + grid(quick)
    return settings
