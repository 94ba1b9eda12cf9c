"""Measures the time from stroke to PNG through HTTP from another process: a new stroke and a frame each time; median and 95th
percentile over the strokes that touch fur.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/stroke_latency.py [STROKES] [MODEL] [TRIANGLES] [QUALITY] [DABS] [SCENES]

QUALITY is a tier, or raster. With several scenes, strokes alternate between them, as if so many artists groomed at once.
"""
import http.client
import json
import pathlib
import re
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from support.server import Server  # noqa: E402


def stroke(i, dabs):
    view = {"camera": {"auto": "three_quarter"}, "width": 512, "height": 512}
    x, y = 180 + (i * 37) % 160, 190 + (i * 53) % 130
    samples = [{"screen": [x + 8 * k, y + 4 * k], "time": 0.02 * k} for k in range(dabs)]
    return {"op": "comb", "brush": {"radius": 0.06}, "stroke": {"view": view, "samples": samples}}


def milliseconds(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    model = sys.argv[2] if len(sys.argv) > 2 else "creature"
    triangles = int(sys.argv[3]) if len(sys.argv) > 3 else 5000
    quality = sys.argv[4] if len(sys.argv) > 4 else "interactive"
    dabs = int(sys.argv[5]) if len(sys.argv) > 5 else 6
    groomers = int(sys.argv[6]) if len(sys.argv) > 6 else 1
    server = Server(gl="auto")
    try:
        scenes = [server.new_scene(model, triangles) for _ in range(groomers)]
        connection = http.client.HTTPConnection("127.0.0.1", server.port)
        totals, stages, commands, shares = [], {}, [], []
        for i in range(count + 3 * groomers):
            scene = scenes[i % groomers]
            start = time.perf_counter()
            connection.request("POST", f"{scene.path}/commands", json.dumps(stroke(i, dabs)))
            touched = json.loads(connection.getresponse().read())["results"][0]["touched"]
            grown = time.perf_counter()
            connection.request("POST", f"{scene.path}/frames", json.dumps({"quality": {"method": "raster"} if quality == "raster" else quality}))
            answer = connection.getresponse()
            answer.read()
            if i < 3 * groomers or not touched:
                continue  # the first frames create textures and programs
            totals.append(1e3 * (time.perf_counter() - start))
            commands.append(1e3 * (grown - start))
            shares.append(json.loads(answer.headers["Pelage-Counters"])["redrawn"])
            for name, value in re.findall(r"(\w+);dur=([\d.]+)", answer.headers["Server-Timing"]):
                stages.setdefault(name, []).append(float(value))
        print(f"{model} {triangles} {quality}, {len(totals)} strokes, 512 x 512: "
              f"median {milliseconds(totals, .5):.1f} ms, 95th percentile {milliseconds(totals, .95):.1f} ms")
        print(f"  command median {milliseconds(commands, .5):.2f} ms, " +
              ", ".join(f"{name} {milliseconds(values, .5):.2f}" for name, values in stages.items()) +
              f"; redrawn {milliseconds(shares, .5):.3f} of the picture (medians)")
    finally:
        server.close()


main()
