"""Measures the CPU milliseconds of a frame by tier, of this build and of another one in turns, and the memory of the scene's strands.

Each frame has its own camera, turned by a tenth of a degree, so that no picture is cached; minima count. The time is that of the whole
frame, the server's `cpu`. Megabytes are what the renderer keeps of the scene: strands, whole and thinned,
the density grid with its lights, and the model.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/frame_cost.py [--beside BIN] [--group looks furs] [--only NAME...]
           [--size 512] [--frames 8]
"""
import argparse
import pathlib
import re
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from subjects import ANIMALS, FURS, LOOKS  # noqa: E402
from support.server import Server  # noqa: E402

TIERS = ("draft", "interactive", "detailed")
GROUPS = {"animals": ANIMALS, "looks": LOOKS, "furs": FURS}


def turned(camera, degrees):
    """Returns the camera rotated about the vertical axis through its target."""
    angle = numpy.radians(degrees)
    sine, cosine = numpy.sin(angle), numpy.cos(angle)
    x, y, z = numpy.subtract(camera["position"], camera["target"])
    position = numpy.add(camera["target"], [cosine * x + sine * z, y, cosine * z - sine * x])
    return {**camera, "position": [float(value) for value in position]}


def cost_of(scene, camera, size, tier):
    answer = scene.post("frames", {"width": size, "height": size, "camera": camera, "quality": tier}, timeout=900)
    assert answer.status == 200, answer
    return float(re.search(r"cpu;dur=([\d.]+)", answer.headers["server-timing"])[1])


def copied_megabytes(server):
    text = server.call("GET", "/metrics").body.decode()
    return float(re.search(r"^pelage_scene_copies_bytes (\d+)", text, re.MULTILINE)[1]) / 2**20


def measure(servers, subject, options):
    scenes = {title: subject.on(server) for title, server in servers.items()}
    camera = subject.seen_from(scenes[""], "whole")
    costs = {(title, tier): [] for title in servers for tier in TIERS}
    for i in range(options.frames + 1):  # the first frame fills the caches
        for (title, tier), of_tier in costs.items():
            cost = cost_of(scenes[title], turned(camera, 0.1 * i), options.size, tier)
            if i:
                of_tier.append(cost)
    megabytes = copied_megabytes(servers[""])
    print(f"| {subject.name} | {' | '.join(f'{min(of_tier):.0f}' for of_tier in costs.values())} | {megabytes:.0f} |", flush=True)
    for title, scene in scenes.items():
        servers[title].call("DELETE", scene.path)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--frames", type=int, default=8)
    parser.add_argument("--group", choices=GROUPS, nargs="*", default=["looks", "furs"])
    parser.add_argument("--only", nargs="*", help="beginnings of names")
    parser.add_argument("--beside", help="programs of another build", type=pathlib.Path)
    options = parser.parse_args()
    servers = {"": Server()}
    if options.beside:
        servers["old "] = Server(binaries=options.beside)
    try:
        titles = [title + tier for title in servers for tier in TIERS]
        print(f"CPU ms at {options.size} x {options.size}\n\n| subject | {' | '.join(titles)} | MB |\n|{'---|' * (len(titles) + 2)}")
        for group in options.group:
            for subject in GROUPS[group]:
                if not options.only or subject.name.startswith(tuple(options.only)):
                    measure(servers, subject, options)
    finally:
        for server in servers.values():
            server.close()


main()
