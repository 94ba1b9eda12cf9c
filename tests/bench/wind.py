"""Checks fur in the wind over many frames for popping and swimming, and measures what a moment costs.

Draws a meadow (long thin grass on a sheet) and the creature at 24 frames a second, at steps of 1, 1/2, 1/4 and 1/8 of a frame. Between
two moments it takes the mean and the 99.9th percentile of the pixels' differences, in 1/255. With smooth motion the difference
shrinks with the step, down to half for half the step; with popping it stays the same however short the step is. A jump of one frame
stands out from its neighbours: `peak` is the largest difference over the median of the seven around it. The groom is hashed before and
after.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/wind.py [--frames 250] [--size 384] [--quality interactive] [--pictures FOLDER]
           [--only meadow|creature]   --pictures keeps every frame as PNG and every 40th with its differences
"""
import argparse
import io
import pathlib
import sys
import time

import numpy
from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "end_to_end"))
from support.server import Server  # noqa: E402

FRAME = 1 / 24  # seconds
GRASS = {"count": 5000, "width_root": 0.0011, "width_tip": 0.0002, "length_spread": 0.35, "bend": 0.25, "clump": 0.25, "lodge": 0.2, "colour_spread": 0.25,
         "root_share": 0.1, "mess": 0.3,
         "ramp": [{"at": 0, "colour": "#1d2a0c"}, {"at": 0.6, "colour": "#587a26"}, {"at": 1, "colour": "#a8b860"}]}
SUN = [{"kind": "directional", "direction": [-0.6, -0.8, -0.35], "colour": "#fff1d8", "intensity": 1.3}]
WINDS = {"meadow": {"speed": 0.3, "direction": [1, 0, 0.35], "gusts": 0.7, "turbulence": 0.3, "turbulence_scale": 0.12, "frequency": 1.6},
         "creature": {"speed": 0.7, "direction": [-1, 0, 0.4], "gusts": 0.6, "turbulence": 0.4, "turbulence_scale": 0.2}}
CAMERAS = {"meadow": {"position": [0, 0.62, 0.95], "target": [0, -0.03, -0.02], "fov_degrees": 36},
           "creature": {"auto": "three_quarter"}}


def meadow(server):
    scene = server.new_scene("plane", 8000, fur={"length": 0.07, "inclination": 0.25})
    run(scene, {"op": "comb", "flood": True, "direction": [0.3, 0, 1], "lean": 0.25}, {"op": "noise", "flood": True, "seed": 3, "amount": 0.25,
        "feature_size": 0.05, "fields": ["direction", "length"]}, {"op": "set_coat", "coat": GRASS}, {"op": "set_lights", "lights": SUN},
        {"op": "set_look", "look": {"colour_source": "coat", "skin": "#1c2410"}})
    return scene


def creature(server):
    scene = server.new_scene("creature", 20000, fur={"length": 0.035, "form": "animal"})
    run(scene, {"op": "set_coat", "coat": {}})
    return scene


def run(scene, *commands):
    answer = scene.run(*commands)
    assert answer.status == 200, answer


class Film:
    def __init__(self, scene, name, options):
        self.scene, self.options = scene, options
        self.request = {"width": options.size, "height": options.size, "camera": CAMERAS[name], "quality": options.quality, "background": "studio",
                        "format": "npy"}
        self.seconds = []

    def at(self, moment):
        began = time.perf_counter()
        answer = self.scene.frame(**self.request, time=moment)
        self.seconds.append(time.perf_counter() - began)
        return numpy.load(io.BytesIO(answer.body))[..., :3].astype(float)


def differences(film, moments, step):
    """Mean and 99.9th percentile of the difference between each moment and one step later."""
    rows = []
    for moment in moments:
        change = numpy.abs(film.at(moment + step) - film.at(moment)).max(axis=-1)
        rows.append((change.mean(), numpy.percentile(change, 99.9)))
    return numpy.array(rows)


def peak(series):
    """The largest ratio of a value to the median of the seven values around it."""
    return max(series[i] / numpy.median(series[max(0, i - 3):i + 4]) for i in range(len(series)))


def measure(name, server, options):
    scene = {"meadow": meadow, "creature": creature}[name](server)
    before = scene.info()["fields_hash"]
    run(scene, {"op": "set_wind", "wind": WINDS[name]})
    film = Film(scene, name, options)
    last, series = None, []
    for i in range(options.frames):
        picture = film.at(i * FRAME)
        if last is not None:
            change = numpy.abs(picture - last).max(axis=-1)
            series.append((change.mean(), numpy.percentile(change, 99.9)))
        if options.pictures:
            keep(options.pictures, name, i, picture, last)
        last = picture
    series = numpy.array(series)
    print(f"{name}: {options.frames} frames, {1e3 * numpy.median(film.seconds):.0f} ms each; a frame to the next: mean {series[:, 0].mean():.2f} "
          f"(most {series[:, 0].max():.2f}), 99.9% {series[:, 1].mean():.0f} (most {series[:, 1].max():.0f}); peak {peak(series[:, 0]):.2f}", flush=True)
    moments = [i * options.frames * FRAME / 20 for i in range(20)]
    rows = [differences(film, moments, FRAME / part) for part in (1, 2, 4, 8, 16)]
    for part, row in zip((1, 2, 4, 8, 16), rows):
        print(f"  a step of 1/{24 * part} s: mean {row[:, 0].mean():.3f}, 99.9% {row[:, 1].mean():.1f}, most {row[:, 1].max():.1f}", flush=True)
    assert scene.info()["fields_hash"] == before, "the groom changed"


def keep(folder, name, i, picture, last):
    folder.mkdir(parents=True, exist_ok=True)
    Image.fromarray(picture.astype(numpy.uint8)).save(folder / f"{name}-{i:03}.png")
    if last is not None and i % 40 == 0:
        change = numpy.clip(128 + 2 * (picture - last), 0, 255)
        Image.fromarray(change.astype(numpy.uint8)).save(folder / f"{name}-{i:03}-difference.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--frames", type=int, default=250)
    parser.add_argument("--size", type=int, default=384)
    parser.add_argument("--quality", default="interactive")
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("--only", choices=WINDS)
    options = parser.parse_args()
    server = Server()
    try:
        for name in [options.only] if options.only else WINDS:
            measure(name, server, options)
    finally:
        server.close()


if __name__ == "__main__":
    main()
