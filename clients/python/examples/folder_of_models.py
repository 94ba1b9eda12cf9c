"""Grooms every model in a folder with the same recipe or commands, and makes a picture of each and a contact sheet.

    python3 clients/python/examples/folder_of_models.py MODELS clients/recipes/tint.json --output groomed

Prints a line for each model: its picture, or what is wrong with it. A model that fails does not stop the others; the
program then ends with 1. The groom is run by the client `pelage`, so that recipes with variables and positions as shares
of a model's box fit each model. Needs Pillow.
"""

from __future__ import annotations

import argparse
import pathlib
from typing import List, Tuple

from PIL import Image

import common
import pelage


def arguments() -> argparse.Namespace:
    parser = common.options(__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="of the models")
    parser.add_argument("groom", type=pathlib.Path, help="a recipe or commands, as `pelage run` takes them")
    parser.add_argument(
        "--output", type=pathlib.Path, default=pathlib.Path("groomed"),
        help="folder of the pictures (default: groomed)",
    )
    parser.add_argument("--front", help="the axis of the files that the models face, such as -z")
    parser.add_argument(
        "--turn", type=float, default=35,
        help="degrees of the camera around the model, 90 at its left (default: 35)",
    )
    parser.add_argument("--size", type=int, default=320, help="pixels along a picture's side (default: 320)")
    return parser.parse_args()


def draw(running: pelage.Server, model: pathlib.Path, args: argparse.Namespace) -> Image.Image:
    with common.empty_scene(running, model.name) as scene:
        scene.load(model, front=args.front)
        common.run_groom(running, scene, args.groom)
        frame = scene.save_frame(
            args.output / f"{model.name}.png", camera=common.orbit(scene, args.turn, 0.25), quality=args.quality, width=args.size, height=args.size
        )
        return common.picture(frame)


def main() -> int:
    args = arguments()
    models = common.files_in(args.folder, common.MODELS)
    args.output.mkdir(parents=True, exist_ok=True)
    pictures: List[Tuple[str, Image.Image]] = []
    with common.server(args) as running:
        for done, model in enumerate(models):
            common.report(done, len(models), model.name)
            try:
                pictures.append((model.name, draw(running, model, args)))
                print(args.output / f"{model.name}.png", flush=True)
            except pelage.Refused as problem:
                print(f"{model.name} failed: {problem}", flush=True)
    if pictures:
        common.save_image(args.output / "sheet.png", common.sheet(pictures))
        print(args.output / "sheet.png")
    return 0 if len(pictures) == len(models) else 1


if __name__ == "__main__":
    common.run(main)
