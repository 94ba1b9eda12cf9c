"""Compares the tiers with the same strands traced (R2), from three distances: on six animals, nine looks, and furs that are
hard to draw. Works through HTTP, because grooms are recipes. Light is mean linear luminance over alpha, coverage is the sum
of alpha, both relative to R2; errors and pictures are those of the last distance.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/tiers.py [--group animals looks furs] [--only NAME...]
           [--size 224] [--passes 32] [--distances near far whole]
           [--pictures FOLDER]                    a JPEG for each: R2 and the tiers, with error maps below
           [--sheet FILE]                         a JPEG of all of them: a row for each, cut to what is seen
           [--beside BIN] [--beside-tiers ...]    another build draws the same scenes
"""
import argparse
import io
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image, ImageDraw

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from subjects import ANIMALS, DISTANCES, FURS, LOOKS  # noqa: E402
from support.exr import read_exr  # noqa: E402
from support.server import BIN, Server  # noqa: E402

TIERS = ("draft", "interactive", "detailed")
GROUPS = {"animals": ANIMALS, "looks": LOOKS, "furs": FURS}


class Frame:
    def __init__(self, answer):
        self.content = answer.body
        channels = read_exr(self.content)
        self.light, self.alpha = numpy.dstack([channels[c] for c in "RGB"]), channels["A"]

    def luminance(self):
        return (self.light @ [.2126, .7152, .0722]).sum() / max(self.alpha.sum(), 1e-9)

    def shown(self):
        """Returns the 8-bit picture over grey, with the filmic curve."""
        alpha = self.alpha.clip(1e-6, 1)[..., None]
        x = (self.light / alpha).clip(0, 1e4) * .72
        film = (x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14)).clip(0, 1)
        film = film * alpha + .35 * (1 - alpha)
        srgb = numpy.where(film < .0031308, 12.92 * film, 1.055 * numpy.maximum(film, 1e-9) ** (1 / 2.4) - .055)
        return Image.fromarray((255 * srgb.clip(0, 1) + .5).astype(numpy.uint8))


def draw(scene, camera, size, quality):
    request = {"width": size, "height": size, "format": "exr", "exr_type": "float", "background": "transparent",
               "quality": quality, "max_seconds": 900, "camera": camera}
    answer = scene.post("frames", request, timeout=900)
    assert answer.status == 200, answer
    return Frame(answer)


def compare(truth, test):
    """Returns the figures and the error map of `pelage compare`."""
    with tempfile.TemporaryDirectory() as folder:
        a, b, error_map = (pathlib.Path(folder) / name for name in ("a.exr", "b.exr", "map.png"))
        a.write_bytes(truth.content)
        b.write_bytes(test.content)
        run = subprocess.run([BIN / "pelage", "--json", "compare", a, b, "--map", error_map], check=True,
                             capture_output=True, text=True)
        return json.loads(run.stdout), Image.open(io.BytesIO(error_map.read_bytes())).convert("RGB")


def silhouette_of(error):
    return f"{error['silhouette']['mean']:.4f}" if error["silhouette"] else ""


def three(values):
    return " ".join(f"{value:.3f}" for value in values)


def ratios_of(test, truth):
    return test.luminance() / truth.luminance(), test.alpha.sum() / truth.alpha.sum()


def write_picture(path, cells, size):
    """Writes pictures in a row with their error maps below and a line of text between."""
    words = 16
    sheet = Image.new("RGB", (len(cells) * (size + 4) - 4, 2 * size + words), "#faf8f4")
    pen = ImageDraw.Draw(sheet)
    for i, (title, frame, error_map) in enumerate(cells):
        x = i * (size + 4)
        sheet.paste(frame.shown(), (x, 0))
        pen.text((x + 3, size + 2), title, fill="#333")
        if error_map:
            sheet.paste(error_map, (x, size + words))
    sheet.save(path, quality=86)


def cut_to_fur(cells):
    """Crops the pictures of a row to the part where the first one shows something, with a margin."""
    alpha = cells[0][1].alpha
    seen = numpy.argwhere(alpha > 0.02)
    top, left = numpy.maximum(seen.min(axis=0) - 8, 0) if len(seen) else (0, 0)
    bottom, right = numpy.minimum(seen.max(axis=0) + 9, alpha.shape) if len(seen) else alpha.shape
    return [(title, frame.shown().crop((left, top, right, bottom))) for title, frame, _ in cells]


def write_sheet(path, rows):
    """Writes rows of pictures one below the other, with text above each picture."""
    words, gap = 16, 6
    heights = [row[0][1].height + words + gap for row in rows]
    sheet = Image.new("RGB", (max(sum(picture.width + gap for _, picture in row) for row in rows), sum(heights)), "#faf8f4")
    pen = ImageDraw.Draw(sheet)
    for row, y in zip(rows, numpy.cumsum([0, *heights])):
        x = 0
        for title, picture in row:
            pen.text((x + 3, y + 2), title, fill="#333")
            sheet.paste(picture, (x, int(y) + words))
            x += picture.width + gap
    sheet.save(path, quality=82)


def traced(passes):
    return {"method": "strands", "eye_steps": 16, "trace": {"passes": passes, "filter": False}}


class Table:
    """Rows of tiers for one subject, seen from each distance, and the cells of its picture, which shows the last distance."""

    def __init__(self, subject, scene, options):
        self.subject, self.size = subject, options.size
        self.cameras = [subject.seen_from(scene, distance) for distance in options.distances]
        self.truths = self.drawn(scene, traced(options.passes))
        self.cells = [("R2", self.truths[-1], None)]

    def drawn(self, scene, quality):
        return [draw(scene, camera, self.size, quality) for camera in self.cameras]

    def add(self, scene, tier, title):
        frames = self.drawn(scene, tier)
        error, error_map = compare(self.truths[-1], frames[-1])
        light, coverage = zip(*map(ratios_of, frames, self.truths))
        print(f"| {self.subject.name} | {title} | {error['flip']['mean']:.4f} | {silhouette_of(error)} | "
              f"{error['flip']['percentile_95']:.3f} | {three(light)} | {three(coverage)} |", flush=True)
        self.cells.append((f"{title}, {error['flip']['mean']:.3f} from R2", frames[-1], error_map))


def measure(servers, subject, options):
    """Prints a row for each tier of each server, and writes the picture. Returns the subject's row of the sheet."""
    scenes = {title: subject.on(server) for title, server in servers.items()}
    table = Table(subject, scenes[""], options)
    for title, scene in scenes.items():
        for tier in TIERS if not title else options.beside_tiers:
            table.add(scene, tier, title + tier)
    if options.pictures:
        name = subject.name.replace(", ", "-").replace(" ", "-")
        write_picture(pathlib.Path(options.pictures) / f"{name}.jpg", table.cells, options.size)
    for title, scene in scenes.items():
        servers[title].call("DELETE", scene.path)
    first, *rest = table.cells
    return cut_to_fur([(f"{subject.name}, R2", *first[1:]), *rest])


def options_of_line():
    parser = argparse.ArgumentParser()
    parser.add_argument("--size", type=int, default=224)
    parser.add_argument("--passes", type=int, default=32)
    parser.add_argument("--group", choices=GROUPS, nargs="*", default=["animals"])
    parser.add_argument("--distances", choices=DISTANCES, nargs="*", default=["near", "far", "whole"])
    parser.add_argument("--only", nargs="*", help="beginnings of names")
    parser.add_argument("--pictures", help="a folder")
    parser.add_argument("--sheet", help="a file")
    parser.add_argument("--beside", help="programs of another build, whose tiers are drawn too", type=pathlib.Path)
    parser.add_argument("--beside-tiers", nargs="*", default=["interactive", "detailed"])
    return parser.parse_args()


def main():
    options = options_of_line()
    servers = {"": Server()}
    if options.beside:
        servers["old "] = Server(binaries=options.beside)
    try:
        print(f"{options.size} pixels, R2 of {options.passes} passes\n")
        print(f"| subject | tier | FLIP | silhouette | 95% | light over R2, {' '.join(options.distances)} | coverage over R2 |")
        print("|---|---|---|---|---|---|---|")
        subjects = [subject for group in options.group for subject in GROUPS[group]]
        rows = [measure(servers, subject, options) for subject in subjects
                if not options.only or subject.name.startswith(tuple(options.only))]
        if options.sheet:
            write_sheet(options.sheet, rows)
    finally:
        for server in servers.values():
            server.close()


if __name__ == "__main__":
    main()
