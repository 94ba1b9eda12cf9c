#!/usr/bin/env python3
"""Small pictures of the tools for the studio, before and after side by side, from those of docs/tools.

usage: tools.py        writes tool-NAME.jpg beside this file
"""
import pathlib

from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
PAGES = HERE.parents[2] / "docs" / "tools"
SIDE = (144, 120)  # pixels of each half
TOOLS = ["comb", "blow", "attract", "interpolate", "flow", "smooth", "noise", "unify", "part", "whorl", "length", "trim", "lift", "erase", "clump",
         "curl", "paint"]


def half(path):
    """The middle of a picture in the form of a half."""
    picture = Image.open(path).convert("RGB")
    width, height = picture.size
    wanted = min(width, height * SIDE[0] / SIDE[1])
    left, top = (width - wanted) / 2, (height - wanted * SIDE[1] / SIDE[0]) / 2
    return picture.resize(SIDE, Image.LANCZOS, (left, top, width - left, height - top))


for tool in TOOLS:
    pair = Image.new("RGB", (2 * SIDE[0], SIDE[1]))
    for k, when in enumerate(("before", "after")):
        pair.paste(half(PAGES / f"{tool}-{when}.jpg"), (k * SIDE[0], 0))
    pair.save(HERE / f"tool-{tool}.jpg", quality=80, optimize=True)
