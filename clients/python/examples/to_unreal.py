"""Takes a groom to Unreal Engine: strands and guides as USD, and one file that names both as a groom.

    python3 clients/python/examples/to_unreal.py --output unreal

Writes unreal/strands.usda, unreal/guides.usda and unreal/groom.usda, reads them again, and prints what they hold and what to
do in Unreal. Ends with 1 where an attribute that Unreal reads is missing or does not fit the strands. With --every 1 all
strands are written, some hundred MB.

Only the files are checked here, not the import: there is no Unreal on the machines that test this project.
"""

from __future__ import annotations

import argparse
import pathlib
import re
from typing import Dict, NamedTuple

import common
import pelage
from pelage.files import write_whole

# Unreal imports each prim with GroomAPI as one groom with all curves below it. Only the root has it, so that both files
# together become one groom.
GROOM = """#usda 1.0
(
    defaultPrim = "groom"
    metersPerUnit = {metres:g}
    upAxis = "Y"
)

def Xform "groom" (
    prepend apiSchemas = ["GroomAPI"]
)
{{
    def "guides" (
        delete apiSchemas = ["GroomAPI"]
        prepend references = @./guides.usda@
    )
    {{
    }}

    def "strands" (
        delete apiSchemas = ["GroomAPI"]
        prepend references = @./strands.usda@
    )
    {{
    }}
}}
"""
STEPS = """In Unreal (5.1 or newer), with the plugins Groom, USD Importer and Alembic Groom Importer on:
  1. Window > Virtual Production > USD Stage, and there File > Open > {file}
  2. Actions > Import, with Groom Assets on. (The open stage shows the groom already.)
  3. Import the same model as a mesh, and make a groom binding of the two.
  4. Give it a material of the shading model Hair, which reads groom_color by the node Hair Attributes.
Unreal reads: points and curveVertexCounts (strands), widths, groom_guide (1: a guide for simulation), groom_group_id (0 fur,
1 whiskers), groom_id, groom_color, and groom_root_uv where the model has texture coordinates."""

VECTORS = ("3f", "2f", "t2", "t3")  # suffixes of USD type names whose values are tuples


class Attributes(NamedTuple):
    """counts: Number of values of each array in a file. points: Sum of the strands' point counts."""

    counts: Dict[str, int]
    points: int


def arguments() -> argparse.Namespace:
    parser = common.options(__doc__)
    common.model_options(parser)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("unreal"), help="folder (default: unreal)")
    parser.add_argument("--every", type=int, default=16, help="one strand of so many (default: 16)")
    parser.add_argument("--guides", type=int, default=256, help="one guide of so many strands (default: 256)")
    parser.add_argument(
        "--metres", type=float, default=1.0,
        help="of one unit of the model; 0.01 where it is in centimetres (default: 1)",
    )
    return parser.parse_args()


def read(path: pathlib.Path) -> Attributes:
    """Reads a USD text file as Pelage writes it, with each array in one line."""
    counts: Dict[str, int] = {}
    points = 0
    with path.open(encoding="utf-8") as lines:
        for line in lines:
            if found := re.match(r" *(\w+)\[\] ([\w:]+) = \[(.*)\]", line):
                kind, name, values = found.groups()
                counts[name] = values.count("(") if kind[-2:] in VECTORS else len(values.split(",")) if values else 0
                if name == "curveVertexCounts" and values:
                    points = sum(map(int, values.split(",")))
    return Attributes(counts, points)


def check(path: pathlib.Path, about: pelage.schemas.ExportAbout) -> None:
    """Raises ValueError if an attribute is missing or its length does not fit the strands or points."""
    counts, points = read(path)
    strands = counts.get("curveVertexCounts", 0)
    wanted = {
        "points": points, "widths": points, "primvars:groom_color": points, "primvars:groom_id": strands,
        "primvars:groom_group_id": strands, "primvars:groom_guide": 1,
    }
    if "primvars:groom_root_uv" in counts:  # where the model has texture coordinates
        wanted["primvars:groom_root_uv"] = strands
    wrong = [name for name, count in wanted.items() if counts.get(name) != count]
    if wrong or (strands, points) != (about["strands"], about["points"]):
        raise ValueError(f"{path} does not hold together: {', '.join(wrong) or 'strands are missing'}")
    print(f"{path}: {strands} curves, {points} points, {', '.join(wanted)}", flush=True)


def write(scene: pelage.Scene, name: str, every: int, args: argparse.Namespace) -> None:
    path, guides = args.output / f"{name}.usda", name == "guides"
    check(path, scene.export(path, every=every, widen=every > 1 and not guides, curves=not guides))


def main() -> int:
    args = arguments()
    args.output.mkdir(parents=True, exist_ok=True)
    with common.server(args) as running, common.new_scene(running, args) as scene:
        for done, (name, every) in enumerate((("strands", args.every), ("guides", args.guides))):
            common.report(done, 2, name)
            write(scene, name, every, args)
    write_whole(args.output / "groom.usda", GROOM.format(metres=args.metres).encode())
    print(STEPS.format(file=args.output / "groom.usda"))
    return 0


if __name__ == "__main__":
    common.run(main)
