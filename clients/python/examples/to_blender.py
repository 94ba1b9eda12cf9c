"""Takes a groom to Blender: strands as HAIR, the skin as glTF, camera and light as JSON, and a frame to compare with.

    python3 clients/python/examples/to_blender.py --output blender --blender blender
    blender -b -P clients/python/examples/blender_import_hair.py -- blender --save fur.blend

Prints how many strands are written, and with --blender also renders blender/cycles.png by Cycles on the CPU and lays it
beside ours in blender/sheet.png. One strand of --every is written, so much wider that they cover as much. Eyes and the
model's textures stay behind, and light and fibres are Blender's own: colours are alike, not equal. Needs Pillow; the import
was tested with Blender 3.4.
"""

from __future__ import annotations

import argparse
import json
import pathlib
import subprocess
from typing import Any, Dict

import common
import pelage
from pelage.files import write_whole
from pelage.schemas import PinholeCamera

IMPORTER = pathlib.Path(__file__).with_name("blender_import_hair.py")


def arguments() -> argparse.Namespace:
    parser = common.options(__doc__)
    common.model_options(parser)
    parser.add_argument(
        "--output", type=pathlib.Path, default=pathlib.Path("blender"),
        help="folder (default: blender)",
    )
    parser.add_argument("--every", type=int, default=4, help="one strand of so many (default: 4)")
    parser.add_argument("--size", type=int, default=320, help="pixels along the side of the pictures (default: 320)")
    parser.add_argument(
        "--turn", type=float, default=35,
        help="degrees of the camera around the model, 90 at its left (default: 35)",
    )
    parser.add_argument("--blender", help="the program, to render at once")
    parser.add_argument("--samples", type=int, default=64, help="of Cycles for each pixel (default: 64)")
    return parser.parse_args()


def write_scene(scene: pelage.Scene, camera: PinholeCamera, args: argparse.Namespace) -> None:
    """Writes camera, lights and skin colour, in the model's coordinates and linear light."""
    settings = scene.settings()
    about: Dict[str, Any] = {
        "camera": camera,
        "lights": [light for light in settings["lights"] if light["kind"] == "directional"],
        "ambient": settings["look"]["ambient"] * settings["environment"]["intensity"],
        "skin": settings["look"]["skin"],
        "size": args.size,
    }
    write_whole(args.output / "scene.json", json.dumps(about, indent=2).encode())


def export(scene: pelage.Scene, camera: PinholeCamera, args: argparse.Namespace) -> None:
    about = scene.export(args.output / "fur.hair", every=args.every, widen=args.every > 1)
    print(f"{args.output / 'fur.hair'}: {about['strands']} strands of {about['points']} points", flush=True)
    write_whole(args.output / "skin.glb", scene.mesh(triangles=200000))
    write_scene(scene, camera, args)
    scene.save_frame(
        args.output / "pelage.png", camera=camera, quality=args.quality, width=args.size, height=args.size,
        tone_map="none", progress=pelage.print_progress,
    )


def render(args: argparse.Namespace) -> None:
    command = [args.blender, "-b", "--python-exit-code", "1", "-P", str(IMPORTER), "--", str(args.output)]
    done = subprocess.run([*command, "--samples", str(args.samples)], capture_output=True, text=True)
    if done.returncode:
        raise OSError(f"Blender failed:\n{(done.stdout + done.stderr)[-2000:]}")
    pictures = [(label, common.load_image(args.output / name)) for label, name in
                (("Pelage", "pelage.png"), ("Blender, Cycles", "cycles.png"))]
    common.save_image(args.output / "sheet.png", common.sheet(pictures, 2))
    print(args.output / "sheet.png")


def main() -> int:
    args = arguments()
    args.output.mkdir(parents=True, exist_ok=True)
    with common.server(args) as running, common.new_scene(running, args) as scene:
        export(scene, common.orbit(scene, args.turn, 0.25), args)
    if args.blender:
        render(args)
    return 0


if __name__ == "__main__":
    common.run(main)
