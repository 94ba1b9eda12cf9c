"""Turns the fur so that its strands run on the picture as those of a reference picture do.

    python3 clients/python/examples/match_direction.py --output matched
    python3 clients/python/examples/match_direction.py --model koala.obj --reference koala.png --turn 90 --output matched
    python3 clients/python/examples/match_direction.py --patch --reference photo.jpg --crop 130 0 85 --output matched

Without --reference the program draws one itself, of the same model with a groom that the optimiser does not know. Prints
after each round the mean angle between the strands of both pictures, and ends with 1 unless it falls to under half. Of a
reference of its own it also prints the mean angle between the two fields, which the optimiser never sees. Writes
reference.png, before.png, after.png, sheet.png with lines along the strands, and direction.npy, which
`scene.set_field("direction", numpy.load("direction.npy"))` puts on a scene of that model.

With --patch the reference is a close-up of fur, such as a photo of an animal's flank: it is matched on a flat patch seen
from straight above. All fur is first laid along the lines of the photo, to that end of each which points away from
--away-from, such as a whorl; then the rounds begin. sheet.png then has a drawing of the reference's lines in its place.

How: a structure tensor reads along which line strands run at each pixel of both pictures. Where they differ, each vertex
that the camera sees turns its fur about its normal by part of the difference. The frame is drawn again and compared again,
for what a picture shows is bent, lit and overlapping fur, and not the field. A round that does not help is taken back, and
the next one turns less.

What it can do: lay the fur as it lies on a picture of the same model from the same camera, with fur of about the same
length. What it cannot: see the back of the model, tell a direction from its opposite (a picture shows lines, not where
they begin: fur turns to the nearer of both), read fur too fine or too blurred for the picture, or find camera, length and
colour. A whole animal needs a model and camera fitted to its photo first; a close-up does not. Needs Pillow and NumPy.
"""

from __future__ import annotations

import argparse
import json
import math
import pathlib
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageOps

import common
import pelage
from pelage.arrays import encoded
from pelage.files import write_whole
from pelage.schemas import PinholeCamera

Array = NDArray[numpy.float64]
WINDOW = 13  # side of the window that averages the structure tensor, in pixels
PATCH_WINDOW = 25  # the same for --patch: wider, because strands in a photo cross each other
EDGE = 6  # width of the margin inside the silhouette, in pixels, whose edge would be read as strands
GRAZING = 0.35  # minimum cosine between normal and view direction; vertices below it are not changed
WORTH = 0.1  # minimum gain, as a fraction of the difference; a round that turns less is not worth its frame
CELL = 16  # distance between two lines on the sheet, in pixels

# Fur whose strands are visible in a small picture: few, wide, of many colours, nearly flat.
READABLE: List[Dict[str, Any]] = [
    {"op": "set_coat", "coat": {
        "count": 1500, "width_root": 0.003, "width_tip": 0.0012, "bend": 0.1, "clump": 0, "colour_spread": 0.5,
        "root_share": 0.7, "length_spread": 0.2, "ticking": {"share": 0.3, "colour": [0.9, 0.85, 0.75]}}},
    {"op": "length", "flood": True, "value": 0.04},
    {"op": "unify", "flood": True, "inclination": 0.9, "weight": 1},
]

# The same for a patch, which is seen from close up: long strands, grey with dark roots.
PATCH: List[Dict[str, Any]] = [
    {"op": "set_coat", "coat": {
        "count": 1500, "width_root": 0.0025, "width_tip": 0.0006, "bend": 0.1, "clump": 0, "colour_spread": 0.7,
        "length_spread": 0.6, "root_share": 0.5,
        "ramp": [{"at": 0, "colour": "#3a3230"}, {"at": 0.5, "colour": "#8a8284"}, {"at": 1, "colour": "#d8d4d8"}]}},
    {"op": "length", "flood": True, "value": 0.12},
    {"op": "unify", "flood": True, "inclination": 0.9, "weight": 1},
]
SHOWN = 0.8  # fraction of a patch's side that is in the picture; its rims are outside


class Lines(NamedTuple):
    """Line directions of strands: twice is cosine and sine of twice the angle [height, width, 2]; clarity is 0 to 1."""

    twice: Array
    clarity: Array


class View(NamedTuple):
    """pixels: Column and row of each vertex. seen: True for vertices whose fur the camera sees well."""

    pixels: NDArray[numpy.int64]
    seen: NDArray[numpy.bool_]
    normals: Array


def arguments() -> argparse.Namespace:
    parser = common.options(__doc__)
    common.model_options(parser)
    parser.add_argument("--reference", type=pathlib.Path, help="a picture of the same model, or of fur; of a wide one its middle counts")
    parser.add_argument("--patch", action="store_true", help="match a close-up on a flat patch instead of a model")
    parser.add_argument("--crop", type=int, nargs=3, metavar=("LEFT", "TOP", "SIDE"), help="take this square of the reference, in pixels")
    parser.add_argument(
        "--away-from", type=float, nargs=2, default=(0.5, -10), metavar=("X", "Y"),
        help="where fur of a patch grows away from, in shares of the picture from its left and top; may lie outside of it "
        "(default: .5 -10, far above: fur hangs down)",
    )
    parser.add_argument(
        "--turn", type=float, default=90,
        help="degrees of its camera around the model (default: 90, its left)",
    )
    parser.add_argument("--rounds", type=int, default=8, help="at most so many (default: 8)")
    parser.add_argument("--size", type=int, default=512, help="pixels along the side of the pictures (default: 512)")
    parser.add_argument(
        "--output", type=pathlib.Path, default=pathlib.Path("matched"),
        help="folder (default: matched)",
    )
    args = parser.parse_args()
    args.window = WINDOW
    if args.patch:
        args.model, args.window = "plane", PATCH_WINDOW
    return args


def blurred(values: Array, size: int) -> Array:
    """Applies a box filter of size x size pixels twice."""
    for axis in (0, 1, 0, 1):
        pad = [(size // 2 + 1, size // 2) if k == axis else (0, 0) for k in range(values.ndim)]
        sums = numpy.cumsum(numpy.pad(values, pad, mode="edge"), axis=axis)
        count = values.shape[axis]
        values = (numpy.take(sums, range(size, size + count), axis) - numpy.take(sums, range(count), axis)) / size
    return values


def lines_of(picture: Array, window: int) -> Lines:
    """Estimates line directions from a picture's brightness, after removing its low frequencies (light and shadow)."""
    bright = picture[..., :3].mean(axis=2)
    detail = bright - blurred(bright, WINDOW)
    detail /= numpy.sqrt(blurred(detail**2, 2 * WINDOW + 1)) + 1.0
    down, right = numpy.gradient(detail)
    # The gradient's doubled angle as a vector with y up. Lines are perpendicular to the gradient, hence the minus.
    tensor = blurred(numpy.stack([right**2 - down**2, -2 * right * down, right**2 + down**2], axis=-1), window)
    strength = numpy.hypot(tensor[..., 0], tensor[..., 1])
    return Lines(-tensor[..., :2] / (strength[..., None] + 1e-9), strength / (tensor[..., 2] + 1e-9))


def turn_between(now: Array, wanted: Array) -> Array:
    """Returns the angles between lines, -pi/2 to pi/2."""
    sine = now[..., 0] * wanted[..., 1] - now[..., 1] * wanted[..., 0]
    return numpy.arctan2(sine, (now * wanted).sum(axis=-1)) / 2


def smooth(values: Array, weight: Array, window: int) -> Array:
    """Returns the weighted mean in a window around each pixel."""
    each = weight[..., None] if values.ndim > weight.ndim else weight
    mean: Array = blurred(each * values, window) / (blurred(each, window) + 1e-6)
    return mean


def smooth_turns(now: Lines, wanted: Lines, inside: Array, window: int) -> Array:
    """Returns the angle by which to turn the lines at each pixel: a mean around it, weighted by clarity."""
    return smooth(turn_between(now.twice, wanted.twice), now.clarity * wanted.clarity * inside, window)


def camera_axes(camera: PinholeCamera) -> Array:
    """Returns the camera's unit vectors right, up and forward, in model coordinates."""
    away = numpy.subtract(camera["target"], camera["position"])
    right = numpy.cross(away, camera["up"])
    up = numpy.cross(right, away)
    return numpy.stack([axis / numpy.linalg.norm(axis) for axis in (right, up, away)])


def from_above(scene: pelage.Scene) -> PinholeCamera:
    """Returns a narrow camera above the flat patch, whose fur initially points down in the picture."""
    side = SHOWN * scene.info()["bounds"]["max"][0] * 2
    fov = 10.0
    height = side / 2 / math.tan(math.radians(fov / 2))
    return {"position": [0, height, 0], "target": [0, 0, 0], "up": [0, 0, 1], "fov_degrees": fov}


def shape_of(scene: pelage.Scene) -> Tuple[Array, Array]:
    """Returns positions and normals of the vertices, in the order of `scene.field`."""
    content = scene.mesh(triangles=200000)
    length = int.from_bytes(content[12:16], "little")
    about = json.loads(content[20 : 20 + length])
    count = about["accessors"][0]["count"]
    if count != scene.info()["vertices"]:
        raise ValueError("the model has more triangles than the server gives; take one of at most 200000")
    numbers = numpy.frombuffer(content, "<f4", 6 * count, 28 + length).reshape(2, count, 3).astype(float)
    return numbers[0] + about["nodes"][0]["translation"], numbers[1]


def view_of(scene: pelage.Scene, camera: PinholeCamera, args: argparse.Namespace) -> Tuple[View, Array]:
    """Returns what the camera sees, and a mask of the pixels to compare: fur, without a margin at its silhouette."""
    positions, normals = shape_of(scene)
    pixels = scene.frame_array(
        linear=True, aovs=["alpha", "depth"], camera=camera, quality=args.quality, width=args.size, height=args.size
    ).astype(float)
    inside = (blurred(pixels[..., 0], 2 * EDGE + 1) > 0.999).astype(float)
    offset = positions - camera["position"]
    right, up, away = (offset @ axis for axis in camera_axes(camera))
    scale = args.size / 2 / math.tan(math.radians(camera["fov_degrees"] / 2)) / away
    at = numpy.stack([args.size / 2 + scale * right, args.size / 2 - scale * up], axis=1).astype(int)
    at = at.clip(0, args.size - 1)
    facing = -(normals * offset).sum(axis=1) / numpy.linalg.norm(offset, axis=1)
    # Fur is a little nearer than the skin below it; if the depth is much nearer, another part of the body occludes it.
    behind = away - pixels[at[:, 1], at[:, 0], 1]
    seen = (facing > GRAZING) & (behind < 0.06 * scene.info()["size"]) & (inside[at[:, 1], at[:, 0]] > 0)
    seen |= args.patch  # vertices outside the picture take the value at its border
    return View(at, seen, normals), inside


def turned(directions: Array, normals: Array, angles: Array) -> NDArray[numpy.float32]:
    """Turns directions about the normals, counter-clockwise seen from outside."""
    cosine, sine = numpy.cos(angles)[:, None], numpy.sin(angles)[:, None]
    result: Array = cosine * directions + sine * numpy.cross(normals, directions)
    return result.astype(numpy.float32)


def own_reference(scene: pelage.Scene, camera: PinholeCamera, args: argparse.Namespace) -> Tuple[Array, Array]:
    """Draws the model with fur turned in waves by up to 65 degrees. Returns the picture and the direction field."""
    positions, normals = shape_of(scene)
    waves = numpy.sin(6 * math.pi * positions[:, 2] / scene.info()["size"])
    wanted = turned(scene.field("direction").astype(float), normals, math.radians(65) * waves)
    other = scene.branch("reference")
    try:
        other.set_field("direction", wanted)
        return draw(other, camera, args), wanted.astype(float)
    finally:
        other.remove()


def draw(scene: pelage.Scene, camera: PinholeCamera, args: argparse.Namespace) -> Array:
    array = scene.frame_array(camera=camera, quality=args.quality, width=args.size, height=args.size)
    return array[..., :3].astype(float)


def degrees_between(now: Lines, wanted: Lines, inside: Array) -> float:
    """Returns the mean angle between lines, weighted by the clarity of the reference."""
    weight = wanted.clarity * inside
    return float(numpy.degrees((weight * numpy.abs(turn_between(now.twice, wanted.twice))).sum() / weight.sum()))


def lay_along(scene: pelage.Scene, view: View, camera: PinholeCamera, lines: Lines, args: argparse.Namespace) -> None:
    """Lays all fur along the lines, in the direction that points away from `args.away_from`."""
    column, row = view.pixels.T
    twice = smooth(lines.twice, lines.clarity, args.window)[row, column]
    angles = numpy.arctan2(twice[:, 1], twice[:, 0]) / 2
    away = numpy.stack([column, -row], axis=1) / args.size - numpy.multiply(args.away_from, [1, -1])
    angles += math.pi * (away[:, 0] * numpy.cos(angles) + away[:, 1] * numpy.sin(angles) < 0)
    right, up, _ = camera_axes(camera)
    leans = numpy.linalg.norm(scene.field("direction"), axis=1)[:, None]
    laid = leans * (numpy.cos(angles)[:, None] * right + numpy.sin(angles)[:, None] * up)
    scene.set_field("direction", laid.astype(numpy.float32))


def match(scene: pelage.Scene, camera: PinholeCamera, wanted: Lines, args: argparse.Namespace) -> Tuple[float, float]:
    """Turns the fur until no round improves it. Returns the mean angles before and after."""
    view, inside = view_of(scene, camera, args)
    column, row = view.pixels.T
    now, gain = lines_of(draw(scene, camera, args), args.window), 0.8
    first = error = degrees_between(now, wanted, inside)
    print(f"before: {error:.1f} degrees", flush=True)
    if args.patch:
        lay_along(scene, view, camera, wanted, args)
        now = lines_of(draw(scene, camera, args), args.window)
        error = degrees_between(now, wanted, inside)
        print(f"laid along the lines: {error:.1f} degrees", flush=True)
    for done in range(args.rounds):
        common.report(done, args.rounds, "round")
        angles = gain * smooth_turns(now, wanted, inside, args.window)[row, column]
        scene.set_field("direction", turned(scene.field("direction").astype(float), view.normals, angles * view.seen))
        tried = lines_of(draw(scene, camera, args), args.window)
        found = degrees_between(tried, wanted, inside)
        print(f"round {done + 1}: {found:.1f} degrees{'' if found < error else ', taken back'}", flush=True)
        if found < error:
            now, error = tried, found
        else:
            scene.undo()
            gain /= 2
            if gain < WORTH:
                break
    return first, error


def with_lines(pixels: Array, lines: Lines, inside: Array) -> Image.Image:
    """Draws a short line along the strands of each cell over the picture."""
    image = Image.fromarray(pixels.astype(numpy.uint8))
    pen = ImageDraw.Draw(image)
    for y in range(CELL // 2, image.height, CELL):
        for x in range(CELL // 2, image.width, CELL):
            if inside[y, x]:
                angle = math.atan2(lines.twice[y, x, 1], lines.twice[y, x, 0]) / 2
                step_x, step_y = 0.4 * CELL * math.cos(angle), -0.4 * CELL * math.sin(angle)
                pen.line((x - step_x, y - step_y, x + step_x, y + step_y), fill=(20, 40, 160), width=2)
    return image


def cropped(picture: Image.Image, left: int, top: int, side: int) -> Image.Image:
    width, height = picture.size
    if side < 1 or left < 0 or top < 0 or left + side > width or top + side > height:
        raise ValueError(f"--crop {left} {top} {side} reaches beyond the reference, which has {width} x {height} pixels")
    return picture.crop((left, top, left + side, top + side))


def reference_of(scene: pelage.Scene, camera: PinholeCamera, args: argparse.Namespace) -> Tuple[Array, Optional[Array]]:
    """Returns the picture to match, and its direction field if the program drew it, else None."""
    if args.reference:
        picture = Image.open(args.reference).convert("RGB")
        if args.crop:
            picture = cropped(picture, *args.crop)
        return numpy.asarray(ImageOps.fit(picture, (args.size, args.size), Image.Resampling.LANCZOS), float), None
    return own_reference(scene, camera, args)


def degrees_off(directions: NDArray[numpy.float32], wanted: Array, seen: NDArray[numpy.bool_]) -> float:
    """Returns the mean angle between two direction fields at the seen vertices."""
    first, second = directions[seen].astype(float), wanted[seen]
    lengths = numpy.linalg.norm(first, axis=1) * numpy.linalg.norm(second, axis=1)
    cosines = (first * second).sum(axis=1) / numpy.maximum(lengths, 1e-9)
    return float(numpy.degrees(numpy.arccos(cosines.clip(-1, 1))).mean())


def sheet_of(pictures: Dict[str, Array], inside: Array, args: argparse.Namespace) -> Image.Image:
    """Returns a sheet of the pictures with lines along the strands. For a patch: the reference's lines, and plain pictures."""
    labelled = [(name, with_lines(one, lines_of(one, args.window), inside)) for name, one in pictures.items()]
    if args.patch:
        paper = numpy.full_like(pictures["reference"], 240)
        plain = [(name, Image.fromarray(pictures[name].astype(numpy.uint8))) for name in ("before", "after")]
        labelled = [("lines of the reference", with_lines(paper, lines_of(pictures["reference"], args.window), inside)), *plain]
    return common.sheet(labelled, len(labelled))


def save(scene: pelage.Scene, pictures: Dict[str, Array], inside: Array, args: argparse.Namespace) -> None:
    for name, one in pictures.items():
        common.save_image(args.output / f"{name}.png", Image.fromarray(one.astype(numpy.uint8)))
    common.save_image(args.output / "sheet.png", sheet_of(pictures, inside, args))
    write_whole(args.output / "direction.npy", encoded(scene.field("direction")))
    print(args.output / "sheet.png")


def main() -> int:
    args = arguments()
    with common.server(args) as running, common.new_scene(running, args) as scene:
        if not args.groom:
            scene.run(*(PATCH if args.patch else READABLE))
        camera = from_above(scene) if args.patch else common.orbit(scene, args.turn)
        reference, hidden = reference_of(scene, camera, args)
        start = scene.field("direction")
        view, inside = view_of(scene, camera, args)
        pictures = {"reference": reference, "before": draw(scene, camera, args)}
        before, after = match(scene, camera, lines_of(reference, args.window), args)
        pictures["after"] = draw(scene, camera, args)
        save(scene, pictures, inside, args)
        if hidden is not None:
            fields = [degrees_off(one, hidden, view.seen) for one in (start, scene.field("direction"))]
            print(f"fields: {fields[0]:.1f} degrees before, {fields[1]:.1f} after")
    print(f"pictures: {before:.1f} degrees before, {after:.1f} after")
    return 0 if after < before / 2 else 1


if __name__ == "__main__":
    common.run(main)
