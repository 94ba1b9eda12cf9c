"""The tiers on six animals: how far each is from the same strands, traced (R2), near and far. Through HTTP, because
grooms are recipes. Light is mean linear luminance over alpha, coverage the sum of alpha, both over those of R2.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/tiers.py [--size 224] [--passes 32] [--only NAME...]
           [--pictures FOLDER]   a JPEG for each animal: R2 and the tiers, with error maps below
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

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "end_to_end"))
from support.exr import read_exr  # noqa: E402
from support.server import BIN, Server, shared_folder  # noqa: E402

TIERS = ("draft", "interactive", "detailed")
DISTANCES = {"near": 0.9, "whole": 1.6, "far": 4}  # sizes from the middle of the box
DIRECTION = numpy.array([0.5, 0.22, 0.84])


class Animal:
    def __init__(self, name, file=None, recipe=None, look=None, front="z", fur=""):
        self.name, self.file, self.recipe, self.look, self.front, self.fur = name, file, recipe, look, front, fur

    def on(self, server):
        scene = server.new_scene("creature", 20000, name=self.name)
        if self.file:
            content = (shared_folder() / "meshes" / self.file).read_bytes()
            kind = self.file.split(".")[-1]
            answer = server.call("PUT", f"{scene.path}/model?format={kind}&front={self.front}{self.fur}", content)
            assert answer.status == 200, answer
        if self.recipe:
            recipe = ROOT / "clients" / "recipes" / f"{self.recipe}.json"
            subprocess.run([BIN / "pelage", "--server", server.address, "run", scene.id, recipe], check=True,
                           stdout=subprocess.DEVNULL)
        if self.look:
            commands = json.loads((ROOT / "clients" / "looks" / f"{self.look}.json").read_text(encoding="utf-8"))
            answer = scene.post("commands", commands)
            assert answer.status == 200, answer
        answer = scene.run({"op": "set_ground", "ground": {"visible": False}})  # its shadow would count as coverage
        assert answer.status == 200, answer
        return scene


ANIMALS = [Animal("koala, plush", "koala_low.obj", "koala_plush"),
           Animal("cat as a fox", "cat.obj", "cat_fox", front="-x"),
           Animal("spot, sleek", "spot.obj", "spot_sleek", front="-z"),
           Animal("koala, white", "koala_low.obj", "koala_white"),
           Animal("creature", recipe="creature"),
           Animal("cat as a leopard", "cat.obj", look="leopard", front="-x", fur="&length=0.018&inclination=0.8")]


class Frame:
    def __init__(self, answer):
        self.content = answer.body
        channels = read_exr(self.content)
        self.light, self.alpha = numpy.dstack([channels[c] for c in "RGB"]), channels["A"]

    def luminance(self):
        return (self.light @ [.2126, .7152, .0722]).sum() / max(self.alpha.sum(), 1e-9)

    def shown(self):
        """8 bits over grey, through the filmic curve."""
        alpha = self.alpha.clip(1e-6, 1)[..., None]
        x = (self.light / alpha).clip(0, 1e4) * .72
        film = (x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14)).clip(0, 1)
        film = film * alpha + .35 * (1 - alpha)
        srgb = numpy.where(film < .0031308, 12.92 * film, 1.055 * numpy.maximum(film, 1e-9) ** (1 / 2.4) - .055)
        return Image.fromarray((255 * srgb.clip(0, 1) + .5).astype(numpy.uint8))


def draw(scene, distance, size, quality):
    info = scene.info()
    low, high = numpy.array(info["bounds"]["min"]), numpy.array(info["bounds"]["max"])
    target = (low + high) / 2
    eye = target + DIRECTION / numpy.linalg.norm(DIRECTION) * distance * info["size"]
    request = {"width": size, "height": size, "format": "exr", "exr_type": "float", "background": "transparent",
               "quality": quality, "max_seconds": 900,
               "camera": {"position": list(eye), "target": list(target), "up": [0, 1, 0], "fov_degrees": 35}}
    answer = scene.post("frames", request, timeout=900)
    assert answer.status == 200, answer
    return Frame(answer)


def compare(truth, test):
    """The figures of `pelage compare`, and its error map."""
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
    """Pictures in a row, their error maps below, a line of words between."""
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


def measure(server, animal, options):
    """Prints a row for each tier and keeps the picture."""
    scene = animal.on(server)
    traced = {"method": "strands", "eye_steps": 16, "trace": {"passes": options.passes, "filter": False}}
    truths = {name: draw(scene, distance, options.size, traced) for name, distance in DISTANCES.items()}
    cells = [("R2", truths["whole"], None)]
    for tier in TIERS:
        frames = {name: draw(scene, distance, options.size, tier) for name, distance in DISTANCES.items()}
        error, error_map = compare(truths["whole"], frames["whole"])
        light, coverage = zip(*(ratios_of(frames[name], truths[name]) for name in DISTANCES))
        print(f"| {animal.name} | {tier} | {error['flip']['mean']:.4f} | {silhouette_of(error)} | "
              f"{error['flip']['percentile_95']:.3f} | {three(light)} | {three(coverage)} |", flush=True)
        cells.append((f"{tier}, {error['flip']['mean']:.3f} from R2", frames["whole"], error_map))
    if options.pictures:
        name = animal.name.replace(", ", "-").replace(" ", "-")
        write_picture(pathlib.Path(options.pictures) / f"{name}.jpg", cells, options.size)
    server.call("DELETE", scene.path)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--size", type=int, default=224)
    parser.add_argument("--passes", type=int, default=32)
    parser.add_argument("--only", nargs="*", help="beginnings of names")
    parser.add_argument("--pictures", help="a folder")
    options = parser.parse_args()
    server = Server()
    try:
        print(f"{options.size} pixels, R2 of {options.passes} passes\n")
        print("| animal | tier | FLIP | silhouette | 95% | light over R2, near whole far | coverage over R2 |")
        print("|---|---|---|---|---|---|---|")
        for animal in ANIMALS:
            if not options.only or animal.name.startswith(tuple(options.only)):
                measure(server, animal, options)
    finally:
        server.close()


if __name__ == "__main__":
    main()
