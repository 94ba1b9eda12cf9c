"""Makes the small pictures of the commands: before and after, side by side.

usage: docs/reference/pictures.py [OP...]     (all commands, or the given ones)

Tools show the recipe of their page in docs/tools, settings show what the contract's example does to the built-in creature. Needs a build of build/release (or PELAGE_BIN) and Pillow.
"""

from __future__ import annotations

import io
import os
import pathlib
import sys
import tempfile
from typing import Any, Dict, List

from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BIN = pathlib.Path(os.environ.get("PELAGE_BIN", ROOT / "build" / "release" / "bin"))
sys.path[:0] = [str(HERE.parent), str(ROOT / "clients" / "python")]
os.environ["PELAGE_SERVER_PROGRAM"] = str(BIN / "pelaged")
import pelage  # noqa: E402

from contract import Contract  # noqa: E402

SIDE = 320  # pixels of each half
FACE = {"position": [-0.4, 0.95, 1.35], "target": [0, 0.83, 0.55], "fov_degrees": 22}
WHOLE = {"position": [-1.9, 1.1, 1.6], "target": [0, 0.52, -0.03], "fov_degrees": 36}
CAMERAS: Dict[str, Dict[str, Any]] = {"set_eyes": FACE, "set_curves": FACE, "set_skin": FACE}
# Commands that show the pictures of a page of docs/tools with another name.
PAGES = {"set_symmetry": "symmetry", "set_blowers": "named_winds", "set_attractors": "named_winds"}
WITHOUT = ("set_skin_texture",)
LIGHTS = [{"kind": "directional", "direction": [0.5, -1, -0.6], "intensity": 1.1, "cast_shadow": "soft"}]


def draw(scene: pelage.Scene, op: str) -> Image.Image:
    frame = scene.frame(camera=CAMERAS.get(op, WHOLE), width=SIDE, height=SIDE, quality="detailed", background="#e9e4dc")  # type: ignore[arg-type]
    return Image.open(io.BytesIO(frame.bytes)).convert("RGB")


def example_pair(server: pelage.Server, example: Dict[str, Any]) -> List[Image.Image]:
    op = example["op"]
    scene = server.create("fox", model={"builtin": "creature", "triangles": 20000}, fur={"length": 0.025, "form": "animal"})
    scene.set_ground(ground={"visible": op != "set_ground"})
    scene.set_lights(lights=LIGHTS)  # type: ignore[arg-type]
    before = draw(scene, op)
    scene.run(example)
    pair = [before, draw(scene, op)]
    scene.remove()
    return pair


def tool_pair(page: str) -> List[Image.Image]:
    return [Image.open(ROOT / "docs" / "tools" / f"{page}-{when}.jpg").convert("RGB").resize((SIDE, SIDE), Image.LANCZOS) for when in ("before", "after")]


def save(op: str, pair: List[Image.Image]) -> None:
    both = Image.new("RGB", (2 * SIDE + 4, SIDE), "white")
    for k, half in enumerate(pair):
        both.paste(half, (k * (SIDE + 4), 0))
    both.save(HERE / "pictures" / f"{op}.jpg", quality=76, optimize=True)


def main(wanted: List[str]) -> None:
    with tempfile.TemporaryDirectory() as folder, pelage.local(data=pathlib.Path(folder) / "data") as server:
        for command in Contract(BIN / "openapi.json").commands:
            if command.op in WITHOUT or wanted and command.op not in wanted:
                continue
            page = PAGES.get(command.op, command.op)
            of_tools = (ROOT / "docs" / "tools" / f"{page}-after.jpg").exists()
            save(command.op, tool_pair(page) if of_tools else example_pair(server, command.example))
            print(command.op)


if __name__ == "__main__":
    main(sys.argv[1:])
