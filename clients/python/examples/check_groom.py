"""A regression test of a groom: draws fixed views and compares them with stored pictures.

    python3 clients/python/examples/check_groom.py STORED --groom clients/recipes/creature.json --update
    python3 clients/python/examples/check_groom.py STORED --groom clients/recipes/creature.json

The first stores the pictures, the second is for CI. Prints a line for each view with two differences, in shares of white:
the mean of all pixels, and the largest of any square of 8 x 8 pixels. (One pixel says nothing: a strand that moves by a
pixel changes it wholly.) Ends with 0 where all views agree. Otherwise it ends with 1, and beside each stored picture that
does not agree are VIEW.now.png and VIEW.difference.png, 4 times as strong.

Pictures of another kind of processor or of a GPU differ by little; store them where they are compared, or raise the
limits. Needs Pillow and NumPy.
"""

from __future__ import annotations

import argparse
import pathlib
from typing import NamedTuple

import numpy
from numpy.typing import NDArray
from PIL import Image

import common

VIEWS = {"front": 0, "left": 90, "back": 180, "right": 270}  # degrees around the model
SQUARE = 8  # pixels


class Difference(NamedTuple):
    mean: float
    largest: float


def arguments() -> argparse.Namespace:
    parser = common.options(__doc__)
    common.model_options(parser)
    parser.add_argument("stored", type=pathlib.Path, help="folder of the pictures")
    parser.add_argument("--update", action="store_true", help="store what is drawn now")
    parser.add_argument("--mean", type=float, default=0.002, help="largest mean difference (default: 0.002)")
    parser.add_argument("--largest", type=float, default=0.02, help="largest difference of a square (default: 0.02)")
    parser.add_argument("--size", type=int, default=256, help="pixels along a picture's side (default: 256)")
    return parser.parse_args()


def difference(first: NDArray[numpy.uint8], second: NDArray[numpy.uint8]) -> Difference:
    """Compares two pictures [height, width, channels]. Raises ValueError if their sizes differ."""
    if first.shape != second.shape:
        raise ValueError(f"the stored picture is {second.shape[1]} x {second.shape[0]}; take its --size, or --update")
    change = numpy.abs(first.astype(float) - second).mean(axis=2) / 255
    rows, columns = (length // SQUARE * SQUARE for length in change.shape)
    squares = change[:rows, :columns].reshape(rows // SQUARE, SQUARE, columns // SQUARE, SQUARE).mean(axis=(1, 3))
    return Difference(float(change.mean()), float(squares.max()) if squares.size else float(change.max()))


def check(name: str, now: NDArray[numpy.uint8], args: argparse.Namespace) -> bool:
    """Returns True if the view agrees with the stored one."""
    path = args.stored / f"{name}.png"
    if not path.is_file():
        raise FileNotFoundError(f"there is no {path}; store it with --update")
    before = numpy.asarray(Image.open(path).convert("RGB"))
    found = difference(now, before)
    agrees = bool(found.mean <= args.mean and found.largest <= args.largest)
    print(f"{name}: mean {found.mean:.4f}, largest {found.largest:.4f}, {'agrees' if agrees else 'DIFFERS'}")
    shown = [args.stored / f"{name}.{what}.png" for what in ("now", "difference")]
    for old in shown:
        old.unlink(missing_ok=True)
    if not agrees:
        strong = numpy.clip(4 * numpy.abs(now.astype(int) - before), 0, 255).astype(numpy.uint8)
        for path, pixels in zip(shown, (now, strong)):
            common.save_image(path, Image.fromarray(pixels))
    return agrees


def main() -> int:
    args = arguments()
    agree = True
    with common.server(args) as running, common.new_scene(running, args) as scene:
        for done, (name, degrees) in enumerate(VIEWS.items()):
            common.report(done, len(VIEWS), name)
            camera = common.orbit(scene, degrees)
            now = scene.frame_array(camera=camera, quality=args.quality, width=args.size, height=args.size)[..., :3]
            if args.update:
                common.save_image(args.stored / f"{name}.png", Image.fromarray(now))
                print(args.stored / f"{name}.png")
            else:
                agree = check(name, now, args) and agree
    return 0 if agree else 1


if __name__ == "__main__":
    common.run(main)
