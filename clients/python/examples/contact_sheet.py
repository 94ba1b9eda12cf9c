"""Draws every look of clients/looks on one model, in one labelled picture.

    python3 clients/python/examples/contact_sheet.py --output looks.jpg
    python3 clients/python/examples/contact_sheet.py --model koala.obj --quality detailed --size 480

Prints where the picture is. A look is coat and shading: length and lean of the fur are those of the model's groom, the
same in all pictures. Needs Pillow.
"""

from __future__ import annotations

import argparse
import json
import pathlib

from PIL import Image

import common
import pelage


def arguments() -> argparse.Namespace:
    parser = common.options(__doc__)
    common.model_options(parser)
    parser.add_argument(
        "--looks", type=pathlib.Path, default=common.LOOKS,
        help="folder of files with commands (default: clients/looks)",
    )
    parser.add_argument(
        "--output", type=pathlib.Path, default=pathlib.Path("looks.jpg"),
        help="the picture (default: looks.jpg)",
    )
    parser.add_argument(
        "--turn", type=float, default=35,
        help="degrees of the camera around the model, 90 at its left (default: 35)",
    )
    parser.add_argument("--size", type=int, default=256, help="pixels along the side of each look (default: 256)")
    return parser.parse_args()


def draw(scene: pelage.Scene, look: pathlib.Path, args: argparse.Namespace) -> Image.Image:
    """Draws a look on a branch, so that looks do not affect each other."""
    branch = scene.branch(look.stem)
    try:
        branch.run(json.loads(look.read_text(encoding="utf-8")))
        return common.picture(branch.frame(camera=common.orbit(scene, args.turn, 0.25), quality=args.quality, width=args.size, height=args.size))
    finally:
        branch.remove()


def main() -> int:
    args = arguments()
    looks = common.files_in(args.looks, (".json",))
    pictures = []
    with common.server(args) as running, common.new_scene(running, args) as scene:
        for done, look in enumerate(looks):
            common.report(done, len(looks), look.stem)
            pictures.append((look.stem.replace("_", " "), draw(scene, look, args)))
    common.save_image(args.output, common.sheet(pictures))
    print(args.output)
    return 0


if __name__ == "__main__":
    common.run(main)
