#!/usr/bin/env python3
"""Small pictures of the looks of clients/looks for the studio, from those of docs/gallery.

usage: looks.py        writes look-NAME.jpg beside this file
"""
import pathlib

from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
GALLERY = HERE.parents[2] / "docs" / "gallery"
SIDE = 112  # pixels
SHARE = 0.66  # fraction of the picture's side that is kept, around its middle
# Looks in the order of the gallery's figure.
LOOKS = ["shorthair_cat", "rabbit", "fox", "sheep", "wet_dog", "bear", "zebra", "leopard", "toy_plush"]

for k, look in enumerate(LOOKS):
    picture = Image.open(GALLERY / f"looks-{k}.jpg").convert("RGB")
    edge = picture.width * (1 - SHARE) / 2
    small = picture.resize((SIDE, SIDE), Image.LANCZOS, (edge, edge, picture.width - edge, picture.height - edge))
    small.save(HERE / f"look-{look}.jpg", quality=80, optimize=True)
