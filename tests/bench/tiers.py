"""The tiers on six animals: how far each is from sorted shells (R1) and from traced strands (R2), near and far; and
how the error falls with shells. Through HTTP, because grooms are recipes.

R1 has many uniform shells, sorted where a GL draws them, 32-bit float, and the shadows of the tier; R2 is the look's own
scattering, traced. Light is mean linear luminance over alpha, coverage the sum of alpha, both over the reference's.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/tiers.py [--size 224] [--truth 256] [--passes 32] [--only NAME...]
           [--pictures FOLDER]   a JPEG for each animal: R1, R2 and the tiers, with error maps below
"""
import argparse
import io
import json
import math
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
SHELLS = (2, 4, 8, 16, 32)  # marched frames have at most 64, which is then R1


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
        self.content, self.knobs = answer.body, json.loads(answer.headers["pelage-quality"])
        channels = read_exr(self.content)
        self.light, self.alpha = numpy.dstack([channels[c] for c in "RGB"]), channels["A"]

    def luminance(self):
        return (self.light @ [.2126, .7152, .0722]).sum() / max(self.alpha.sum(), 1e-9)

    def shown(self):
        """8 bits over grey, through the filmic curve of the resolve pass."""
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
               "quality": quality,
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


class Truths:
    """R1 with each kind of shadow and R2, drawn when first asked for."""

    def __init__(self, scene, distance, options, base):
        self.scene, self.distance, self.options, self.base, self.drawn = scene, distance, options, base, {}

    def frame(self, key, quality):
        if key not in self.drawn:
            self.drawn[key] = draw(self.scene, self.distance, self.options.size, quality)
        return self.drawn[key]

    def r1(self, knobs, shells=None):
        """With the shadows of these knobs, and their scale where it is above 1: more samples make another picture."""
        shells = shells or self.options.truth
        shadows = {name: knobs[name] for name in ("self_shadow", "shadow_maps", "shadow_resolution")}
        quality = {**self.base, "shells": shells, "shell_policy": "uniform", "order": "sorted",
                   "scale": max(1, knobs["scale"]), "guard_hairs": 0, **shadows}
        return self.frame((shells, quality["scale"], *shadows.values()), quality)

    def r2(self):
        strands = {"method": "strands", "trace": {"passes": self.options.passes, "scattering": "look"}}
        return self.frame("R2", strands)


def tier_rows(scene, options, animal):
    """Prints a row for each tier and gives what the picture shows: names, frames and error maps."""
    cells = []
    whole = {tier: draw(scene, DISTANCES["whole"], options.size, tier) for tier in TIERS}
    base = whole["interactive"].knobs
    truths = {name: Truths(scene, distance, options, base) for name, distance in DISTANCES.items()}
    at = truths["whole"]
    r1, r2 = at.r1(whole["detailed"].knobs), at.r2()  # strands have the shadows of `detailed`
    between, between_map = compare(r1, r2)
    floor = compare(at.r1(at.base), at.r1(at.base, options.truth // 2))[0]["flip"]["mean"]
    print(f"| {animal.name} | R2 | {between['flip']['mean']:.4f} | {silhouette_of(between)} | | | | "
          f"(R1 is known to {floor:.4f}) |")
    cells += [("R1", r1, None), (f"R2, {between['flip']['mean']:.3f} from R1", r2, between_map)]
    for tier in TIERS:
        error, error_map = compare(at.r1(whole[tier].knobs), whole[tier])
        strands = compare(r2, whole[tier])[0]
        frames = {name: whole[tier] if name == "whole" else draw(scene, distance, options.size, tier)
                  for name, distance in DISTANCES.items()}
        light, coverage = zip(*(ratios_of(frame, truths[name].r2()) for name, frame in frames.items()))
        print(f"| {animal.name} | {tier} | {error['flip']['mean']:.4f} | {silhouette_of(error)} | "
              f"{error['flip']['percentile_95']:.3f} | {strands['flip']['mean']:.3f} | {three(light)} | "
              f"{three(coverage)} |", flush=True)
        cells.append((f"{tier}, {error['flip']['mean']:.3f} from R1", whole[tier], error_map))
    return cells, at, base


def silhouette_of(error):
    return f"{error['silhouette']['mean']:.4f}" if error["silhouette"] else ""


def three(values):
    return " ".join(f"{value:.3f}" for value in values)


def ratios_of(test, truth):
    return test.luminance() / truth.luminance(), test.alpha.sum() / truth.alpha.sum()


def fitted_order(errors):
    """Of errors that belong to SHELLS: the slope of a line through their logarithms, falling."""
    return -numpy.polyfit([math.log(n) for n in SHELLS], [math.log(max(e, 1e-6)) for e in errors], 1)[0]


def convergence_row(scene, options, animal, truths, knobs):
    """Errors of uniform shells at once the size, 4 steps, and the fitted order of FLIP."""
    flip = [compare(truths.r1(knobs), draw(scene, DISTANCES["whole"], options.size, {**knobs, "steps": 4, "shells": shells}))[0]["flip"]["mean"]
            for shells in SHELLS]
    return f"| {animal.name} | {' | '.join(f'{e:.4f}' for e in flip)} | {fitted_order(flip):.2f} |"


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
    scene = animal.on(server)
    cells, truths, knobs = tier_rows(scene, options, animal)
    if options.pictures:
        name = animal.name.replace(", ", "-").replace(" ", "-")
        write_picture(pathlib.Path(options.pictures) / f"{name}.jpg", cells, options.size)
    row = convergence_row(scene, options, animal, truths, {**knobs, "order": "sorted"})
    server.call("DELETE", scene.path)
    return row


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--size", type=int, default=224)
    parser.add_argument("--truth", type=int, default=256)
    parser.add_argument("--passes", type=int, default=32)
    parser.add_argument("--only", nargs="*", help="beginnings of names")
    parser.add_argument("--pictures", help="a folder")
    options = parser.parse_args()
    server = Server()
    try:
        print(f"{options.size} pixels, R1 of {options.truth} sorted shells, R2 of {options.passes} passes\n")
        print("| animal | tier | FLIP to R1 | silhouette | 95% | FLIP to R2 | light over R2, near whole far | "
              "coverage over R2 |")
        print("|---|---|---|---|---|---|---|---|")
        rows = [measure(server, animal, options) for animal in ANIMALS
                if not options.only or animal.name.startswith(tuple(options.only))]
        print("\nFLIP to R1 by shells, 4 steps, once the size, and the fitted order of FLIP\n")
        print("| animal | " + " | ".join(map(str, SHELLS)) + " | order |\n|" + "---|" * (len(SHELLS) + 2))
        print("\n".join(rows))
    finally:
        server.close()


if __name__ == "__main__":
    main()
