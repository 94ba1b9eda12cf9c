"""Writes the demo's commands for one scene as JSON lines, one file per step, fitted to the model's box.

usage: demo_groom.py INFO.json FOLDER   (INFO.json is what `pelage --json info` prints)
"""
import json
import pathlib
import sys

VIEW = {"camera": {"auto": "three_quarter"}, "width": 512, "height": 512}


def stroke(points):
    """A stroke over pixels of the picture that `pelage frame` draws by default; pixels that miss the model have no effect."""
    samples = [{"screen": list(p), "time": 0.02 * i} for i, p in enumerate(points)]
    return {"view": VIEW, "samples": samples}


def line(start, end, steps=24):
    return [[start[k] + (end[k] - start[k]) * i / steps for k in (0, 1)] for i in range(steps + 1)]


def comb():
    """Combs the whole side against the grain, from tail to nose and up."""
    brush = {"radius": 0.12, "strength": 0.9}
    for y in (170, 225, 280, 335):
        yield {"op": "comb", "brush": brush, "lean": 0.8, "stroke": stroke(line((430, y - 60), (90, y + 40)))}


def blow(low, high):
    """A strong wind from above the nose on the right."""
    size = sum((h - l) ** 2 for l, h in zip(low, high)) ** 0.5
    middle = [(l + h) / 2 for l, h in zip(low, high)]
    source = [middle[0] + 0.6 * size, middle[1] + 0.5 * size, middle[2] + 0.6 * size]
    yield {"op": "blow", "source": source, "direction": [m - s for m, s in zip(middle, source)], "cone_degrees": 35,
           "strength": 0.95, "lean": 0.9}


def attract(low, high):
    """A stick above the back pulls the fur up and stretches it."""
    point = [(low[0] + high[0]) / 2, high[1] + 0.05 * (high[1] - low[1]), (low[2] + high[2]) / 2]
    yield {"op": "attract", "point": point, "radius": 0.45, "strength": 0.9, "duration": 1.5, "threshold": 0.1,
           "max_stretch": 2.5}


def main():
    info = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    low, high = info["bounds"]["min"], info["bounds"]["max"]
    steps = {"1-comb": comb(), "2-blow": blow(low, high), "3-attract": attract(low, high)}
    for name, commands in steps.items():
        path = pathlib.Path(sys.argv[2]) / f"{name}.jsonl"
        path.write_text("".join(json.dumps(c) + "\n" for c in commands), encoding="utf-8")


main()
