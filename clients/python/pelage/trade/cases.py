"""The scenes that are measured, and the knobs that are tried on them."""

from __future__ import annotations

import json
import math
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, cast

from ..scene import Scene
from ..schemas import BuiltinModel, Knobs

Vector = Tuple[float, float, float]

NEAR, NEAR_PATCH, FAR = 1.35, 0.9, 4.0  # sizes from the middle; the model's ball fills the picture at 1.7
COATS = {"white": "#efeae2", "dark": "#221c18"}


class Case(NamedTuple):
    """A scene seen from one side.

    towards: From the middle of its box to the camera, in sizes.
    swept: Whether all knobs, pictures and R2 are wanted, and not tiers and shells alone.
    scene: One that is there already; else `model` and `commands` make it.
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
    """A light from behind the camera or one that shines at it, and a weak one from above."""
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
    """White and dark, lit from the front and from behind, near and far. quick: One small sphere."""
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
    """A scene of the user's as it is, near and far."""
    side = direction(20, 35)
    return [
        Case(f"{scene.name}, near", times(side, NEAR), True, scene),
        Case(f"{scene.name}, far", times(side, FAR), False, scene),
    ]


INTERACTIVE: Knobs = {
    "method": "shells", "shells": 16, "steps": 2, "scale": 1.0, "min_radius": 0, "self_shadow": True,
    "shadow_maps": False, "shadow_resolution": 512, "shell_policy": "uniform", "order": "shells", "eye_steps": 8,
    "guard_hairs": 0,
}


def changed(base: Knobs, **knobs: Any) -> Knobs:
    return cast(Knobs, {**base, **knobs})


TIERS = {
    "draft": changed(INTERACTIVE, shells=8, steps=4, scale=0.6, min_radius=120, eye_steps=1),
    "interactive": INTERACTIVE,
    "detailed": changed(
        INTERACTIVE, shells=32, scale=2.0, shadow_maps=True, shadow_resolution=1024, order="sorted", eye_steps=16
    ),
}
# Tiers that single knobs are turned around; draft with its scale of large pictures, as the report's are small.
BASES = {"draft": changed(TIERS["draft"], min_radius=0), "interactive": INTERACTIVE}


class Setting(NamedTuple):
    """See `Row`."""

    series: str
    base: str
    value: str
    knobs: Knobs

    @property
    def json(self) -> str:
        return json.dumps(self.knobs, separators=(",", ":"))


def turned(base: str, knob: str, values: Sequence[Any]) -> List[Setting]:
    return [
        Setting(knob.replace("_", " "), base, value if isinstance(value, str) else f"{value:g}",
                changed(BASES[base], **{knob: value}))
        for value in values
    ]


def grid(quick: bool) -> List[Setting]:
    return [
        Setting("grid", "", f"{shells} x {steps} x {scale:g}",
                changed(INTERACTIVE, shells=shells, steps=steps, scale=scale))
        for shells in ((4, 8) if quick else (2, 4, 8, 16, 32))
        for steps in ((2,) if quick else (1, 3, 6))
        for scale in (0.5, 0.75, 1.0)
    ]


def settings_for(swept: bool, quick: bool) -> List[Setting]:
    """Tiers and shells; `swept`: every knob around the tiers and a grid as well. quick: Few values."""
    shells = (4, 16) if quick else (2, 4, 8, 16, 32, 64)
    settings = [Setting("tier", "", name, knobs) for name, knobs in TIERS.items()]
    settings += turned("interactive", "shells", shells)
    if not swept:
        return settings
    settings += turned("draft", "shells", shells)
    for base in BASES:
        settings += turned(base, "steps", (1, 4) if quick else (1, 2, 4, 8))
        settings += turned(base, "scale", (0.5, 1.0) if quick else (0.5, 0.67, 0.75, 1.0, 1.5))
    if not quick:
        settings += turned("interactive", "shell_policy", ("uniform", "adaptive"))
        settings += turned("interactive", "order", ("shells", "sorted"))
        settings += turned("interactive", "guard_hairs", (0, 5000, 20000))
    return settings + grid(quick)
