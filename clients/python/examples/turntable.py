"""Turns a groomed model once around: numbered frames and an animation.

    python3 clients/python/examples/turntable.py --groom clients/recipes/creature.json --output turn/fox
    python3 clients/python/examples/turntable.py --model koala.obj --frames 120 --quality detailed --animation turn.gif

Writes turn/fox.0001.png and so on, and turn/fox.webp unless --animation names another file (.webp, .gif), and prints
their names. The camera goes around, the light stays with the model. Needs Pillow for the animation.
"""

from __future__ import annotations

import argparse
import pathlib
from typing import List

from PIL import Image

import common
import pelage


def arguments() -> argparse.Namespace:
    parser = common.options(__doc__)
    common.model_options(parser)
    parser.add_argument(
        "--output", type=pathlib.Path, default=pathlib.Path("turntable/fox"),
        help="begin of the frames' names (default: turntable/fox)",
    )
    parser.add_argument("--animation", type=pathlib.Path, help="a .webp or .gif (default: OUTPUT.webp)")
    parser.add_argument("--frames", type=int, default=24, help="of the whole turn (default: 24)")
    parser.add_argument("--seconds", type=float, default=2.0, help="of the whole turn (default: 2)")
    parser.add_argument("--size", type=int, default=320, help="pixels along a frame's side (default: 320)")
    args = parser.parse_args()
    if args.frames < 1:
        parser.error("--frames must be 1 or more")
    return args


def draw(scene: pelage.Scene, number: int, args: argparse.Namespace) -> Image.Image:
    camera = common.orbit(scene, 360 * number / args.frames)
    path = f"{args.output}.{number + 1:04}.png"
    frame = scene.save_frame(path, camera=camera, quality=args.quality, width=args.size, height=args.size)
    return common.picture(frame)


def main() -> int:
    args = arguments()
    animation = args.animation or pathlib.Path(f"{args.output}.webp")
    args.output.parent.mkdir(parents=True, exist_ok=True)
    pictures: List[Image.Image] = []
    with common.server(args) as running, common.new_scene(running, args) as scene:
        for number in range(args.frames):
            common.report(number, args.frames, "frame")
            pictures.append(draw(scene, number, args))
    common.save_image(animation, pictures[0], pictures[1:], round(1000 * args.seconds / args.frames))
    print(f"{args.output}.0001.png to {args.output}.{args.frames:04}.png")
    print(animation)
    return 0


if __name__ == "__main__":
    common.run(main)
