"""Draws every look and recipe in every tier side by side, and prints the light of each tier relative to the reference.

Light is mean linear luminance over alpha, as in tiers.py. It should not change when tracing takes over.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/judge.py SHEET.jpg [--size 300] [--passes 16] [--only NAME...]
"""
import argparse
import contextlib

from PIL import Image, ImageDraw

from tiers import DISTANCES, ROOT, TIERS, Animal, draw
from support.server import Server

RECIPES = [Animal("creature", recipe="creature"), Animal("koala", "koala_low.obj", "koala"),
           Animal("koala_plush", "koala_low.obj", "koala_plush"), Animal("koala_white", "koala_low.obj", "koala_white"),
           Animal("spot", "spot.obj", "spot", front="-z"), Animal("spot_sleek", "spot.obj", "spot_sleek", front="-z"),
           Animal("cat_fox", "cat.obj", "cat_fox", front="-x")]
LOOKS = [Animal(f"look {file.stem}", look=file.stem) for file in sorted((ROOT / "clients" / "looks").glob("*.json"))]


def judged(animal, options):
    """Returns a row of the sheet, one frame for each tier, and each tier's light relative to the reference."""
    with contextlib.closing(Server()) as server:
        scene = animal.on(server)
        strands = {"method": "strands", "trace": {"passes": options.passes}}
        frames = [draw(scene, DISTANCES["whole"], options.size, quality) for quality in (*TIERS, strands)]
    light = [frame.luminance() for frame in frames]
    return frames, [one / light[-1] for one in light]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sheet")
    parser.add_argument("--size", type=int, default=300)
    parser.add_argument("--passes", type=int, default=16)
    parser.add_argument("--only", nargs="*")
    options = parser.parse_args()
    animals = [Animal("default")] + LOOKS + RECIPES
    rows = [animal for animal in animals if not options.only or animal.name in options.only]
    sheet = Image.new("RGB", (options.size * (len(TIERS) + 1), options.size * len(rows)))
    print("| look or recipe | " + " | ".join(TIERS) + " |\n|---|" + "---|" * len(TIERS))
    for row, animal in enumerate(rows):
        frames, shares = judged(animal, options)
        for column, frame in enumerate(frames):
            sheet.paste(frame.shown(), (column * options.size, row * options.size))
        ImageDraw.Draw(sheet).text((6, row * options.size + 4), animal.name, fill="white")
        print(f"| {animal.name} | " + " | ".join(f"{share:.2f}" for share in shares[:-1]) + " |", flush=True)
        sheet.save(options.sheet, quality=88)


if __name__ == "__main__":
    main()
