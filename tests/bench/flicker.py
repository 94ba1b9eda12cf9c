"""Measures flicker: how much fur changes between frames of a slow orbit beyond what the motion itself explains.

Each frame is reprojected to the previous one: the AOV `position` gives every pixel's position on the model, and the
previous camera gives its pixel there. Pixels that are hidden there, or whose depth differs by over a hundredth of the
size, are left out. The change is the root mean square of linear light, and the mean of |difference| after the sRGB curve
in grey levels of 255. Bilinear reprojection blurs, so no setting gives 0; what counts is how much more it is than that
of `every strand`.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/flicker.py [--frames 6] [--step .25] [--size 256]
           [--model creature] [--triangles 5000]
"""
import argparse
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from support.exr import read_exr  # noqa: E402
from support.server import Server  # noqa: E402

FOV = 35
SETTINGS = {**{tier: tier for tier in ("draft", "interactive", "detailed")},
            "every strand, at twice the size": {"scale": 2, "raster": {"strands": 1000, "light_of": 1}}}


def camera_at(degrees, centre, distance):
    turn = numpy.radians(degrees)
    return numpy.array(centre) + distance * numpy.array([numpy.sin(turn) * .94, .34, numpy.cos(turn) * .94])


def seen_from(camera, target, position, size):
    """Pixel coordinates and depth of positions (rows x columns x 3) in a picture of this camera."""
    forward = (target - camera) / numpy.linalg.norm(target - camera)
    right = numpy.cross(forward, [0, 1, 0])
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, forward)
    offset = position - camera
    depth = offset @ forward
    scale = size / 2 / numpy.tan(numpy.radians(FOV / 2)) / numpy.where(depth > 0, depth, 1)
    return size / 2 + (offset @ right) * scale, size / 2 - (offset @ up) * scale, depth


def sample(picture, x, y):
    """Samples bilinearly; x and y are in pixels, whose centres are at .5."""
    rows, columns = picture.shape[:2]
    x, y = numpy.clip(x - .5, 0, columns - 1.001), numpy.clip(y - .5, 0, rows - 1.001)
    i, j = y.astype(int), x.astype(int)
    u, v = (x - j)[..., None], (y - i)[..., None]
    return ((1 - v) * ((1 - u) * picture[i, j] + u * picture[i, j + 1]) +
            v * ((1 - u) * picture[i + 1, j] + u * picture[i + 1, j + 1]))


def draw(scene, camera, target, size, quality):
    request = {"width": size, "height": size, "format": "exr", "exr_type": "float", "background": "transparent",
               "aovs": ["beauty", "position", "depth"], "quality": quality,
               "camera": {"position": list(camera), "target": list(target), "up": [0, 1, 0], "fov_degrees": FOV}}
    answer = scene.post("frames", request, timeout=600)
    assert answer.status == 200, answer
    channels = read_exr(answer.body)
    return {"light": numpy.dstack([channels[c] for c in "RGB"]), "alpha": channels["A"], "depth": channels["Z"],
            "position": numpy.dstack([channels[f"position.{c}"] for c in "XYZ"])}


def shown(light):
    curve = 1.055 * numpy.maximum(light, 1e-9) ** (1 / 2.4) - .055
    return numpy.where(light < .0031308, 12.92 * light, curve).clip(0, 1)


def change(before, camera, target, after, size, scale_of_model):
    """Returns the RMS change of linear light, the mean change in grey levels, and the reprojected share of the fur."""
    opaque = after["alpha"] > .95
    x, y, depth = seen_from(camera, target, numpy.where(opaque[..., None], after["position"], target), size)
    inside = (x > 1) & (x < size - 1) & (y > 1) & (y < size - 1)
    there = sample(numpy.where(numpy.isfinite(before["depth"]), before["depth"], 1e9)[..., None], x, y)[..., 0]
    covered = sample(before["alpha"][..., None], x, y)[..., 0] > .95
    good = opaque & inside & covered & (numpy.abs(there - depth) < .01 * scale_of_model)
    reprojected = sample(before["light"], x, y)[good]
    now = after["light"][good]
    rms = numpy.sqrt(((now - reprojected) ** 2).mean())
    levels = 255 * numpy.abs(shown(now) - shown(reprojected)).mean()
    return rms, levels, good.sum() / max(opaque.sum(), 1)


def orbit(scene, info, quality, options):
    low, high = numpy.array(info["bounds"]["min"]), numpy.array(info["bounds"]["max"])
    target, changes, before = (low + high) / 2, [], None
    for i in range(options.frames):
        camera = camera_at(30 + i * options.step, target, 1.5 * info["size"])
        frame = draw(scene, camera, target, options.size, quality)
        if before is not None:
            changes.append(change(before[1], before[0], target, frame, options.size, info["size"]))
        before = (camera, frame)
    return numpy.mean(changes, axis=0)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--frames", type=int, default=6)
    parser.add_argument("--step", type=float, default=.25, help="degrees")
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--model", default="creature")
    parser.add_argument("--triangles", type=int, default=5000)
    options = parser.parse_args()
    server = Server()
    try:
        scene = server.new_scene(options.model, options.triangles)
        info = scene.info()
        print(f"{options.model}, {options.frames} frames, {options.step} degrees apart, {options.size} pixels\n")
        print("| quality | RMS, linear | grey levels | reprojected, % |\n|---|---|---|---|")
        for name, quality in SETTINGS.items():
            rms, levels, share = orbit(scene, info, quality, options)
            print(f"| {name} | {rms:.4f} | {levels:.2f} | {100 * share:.0f} |", flush=True)
    finally:
        server.close()


main()
