"""Measures grooming beside a progressive picture, and a progressive picture as a client sees it.

Time from stroke to PNG through HTTP (512 x 512, creature of 5,000 triangles, interactive): alone, while a client follows
another view of the scene with rasterized pictures, and while it follows that view with a progressive picture; in blocks
of strokes of each kind in turn, in one run. Then time against error: for each version of a progressive picture the
seconds since the request, and its FLIP over the fur against the last version.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/progressive_latency.py [BLOCKS] [STROKES] [LAST_PASS]
"""
import http.client
import json
import pathlib
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from support.server import BIN, Server  # noqa: E402

PAUSE = 0.6  # seconds between strokes: a progressive picture begins a tenth of a second after the last stroke


class Client:
    def __init__(self, server, scene):
        self.port, self.path = server.port, scene.path

    def post(self, name, body):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        try:
            connection.request("POST", f"{self.path}/{name}", json.dumps(body))
            answer = connection.getresponse()
            return answer, answer.read()
        finally:
            connection.close()

    def picture(self, request, seen=None, wait=1):
        """Returns bytes and report of the next picture; nothing if no better one came."""
        passes = f"&after_pass={seen[1]}" if seen and request["progressive"] else ""
        query = f"?after={seen[0]}{passes}&wait={wait}" if seen else ""
        answer, content = self.post(f"frames{query}", request)
        if answer.status == 304:
            return None, None
        if answer.status != 200:
            raise RuntimeError(f"{answer.status} {content[:300]}")
        report = json.loads(answer.headers.get("Pelage-Trace", '{"passes": 0}'))
        return content, {**report, "revision": int(answer.headers["Pelage-Revision"])}


class Follower(threading.Thread):
    """Another artist's client, which fetches every new picture of its view."""

    def __init__(self, server, scene, progressive):
        super().__init__(daemon=True)
        self.client, self.stopping, self.pictures = Client(server, scene), threading.Event(), 0
        self.request = {"width": 512, "height": 512, "view": "follower", "camera": {"auto": "left"},
                        "progressive": {"passes": 4096} if progressive else False}

    def run(self):
        seen = None
        while not self.stopping.is_set():
            content, report = self.client.picture(self.request, seen)
            if content:
                seen = (report["revision"], report["passes"])
                self.pictures += report["passes"] > 0

    def stop(self):
        self.stopping.set()
        self.join()


def stroke(i):
    view = {"camera": {"auto": "three_quarter"}, "width": 512, "height": 512}
    x, y = 180 + (i * 37) % 160, 190 + (i * 53) % 130
    samples = [{"screen": [x + 8 * k, y + 4 * k], "time": 0.02 * k} for k in range(6)]
    return {"op": "comb", "brush": {"radius": 0.06}, "stroke": {"view": view, "samples": samples}}


def share(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))]


def strokes(client, first, count):
    """Makes strokes. Returns the milliseconds from each stroke to its picture."""
    times = []
    for i in range(first, first + count):
        time.sleep(PAUSE)
        start = time.perf_counter()
        client.post("commands", stroke(i))
        answer, _ = client.post("frames", {"quality": "interactive", "view": "artist"})
        assert answer.status == 200
        times.append(1e3 * (time.perf_counter() - start))
    return times


def latency(server, blocks, count):
    scene = server.new_scene("creature", 5000)
    client = Client(server, scene)
    strokes(client, 0, 3)  # the first frames create textures and programs
    times, pictures = {"alone": [], "rasterized": [], "progressive": []}, 0
    for block in range(blocks):
        for kind, taken in times.items():
            follower = Follower(server, scene, progressive=kind == "progressive")
            if kind != "alone":
                follower.start()
                time.sleep(1)
            taken += strokes(client, 3 + block * count, count)
            if kind != "alone":
                follower.stop()
                pictures += follower.pictures
    print(f"creature 5000 interactive, {blocks * count} strokes of each kind in turn, 512 x 512; "
          f"{pictures} traced pictures went to the other view meanwhile")
    for name, values in times.items():
        print(f"  {name}: median {share(values, .5):.1f} ms, 95th percentile {share(values, .95):.1f} ms")
    for one, other in (("progressive", "alone"), ("rasterized", "alone"), ("progressive", "rasterized")):
        ratios = [share(times[one], part) / share(times[other], part) for part in (0.5, 0.95)]
        print(f"  {one} / {other}: median {ratios[0]:.3f}, 95th percentile {ratios[1]:.3f}")


def flip(folder, truth, picture, mask):
    for name, content in (("truth", truth), ("picture", picture)):
        (folder / f"{name}.png").write_bytes(content)
    run = subprocess.run([BIN / "pelage", "--json", "compare", folder / "truth.png", folder / "picture.png",
                          "--mask", mask], check=True, capture_output=True, text=True)
    return json.loads(run.stdout)


def time_against_error(server, last_pass):
    scene = server.new_scene("creature", 5000)
    client = Client(server, scene)
    request = {"width": 512, "height": 512, "view": "artist", "progressive": {"passes": last_pass}}
    start = time.perf_counter()
    content, report = client.picture(request)
    pictures = [(time.perf_counter() - start, content, report)]
    while report["end"] == "none":
        content, better = client.picture(request, (report["revision"], report["passes"]), wait=20)
        if content:
            report = better
            pictures.append((time.perf_counter() - start, content, report))
    mask = server.folder / "mask.png"
    answer, content = client.post("frames", {"width": 512, "height": 512, "background": "transparent"})
    mask.write_bytes(content)
    print(f"a progressive picture of the creature, 512 x 512, {report['strands']} strands, "
          f"against its picture of {report['passes']} passes")
    print("| passes | s | FLIP | RMSE | noise |\n|---|---|---|---|---|")
    shown = 0
    for seconds, content, report in pictures:
        if report["passes"] < 1.4 * shown and report["end"] == "none":
            continue
        shown = report["passes"]
        error = flip(server.folder, pictures[-1][1], content, mask)
        passes = report["passes"] or "rasterized"
        print(f"| {passes} | {seconds:.2f} | {error['flip']['mean']:.4f} | {error['rmse']:.4f} | {report['noise']:.4f} |")


def main():
    blocks = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    last_pass = int(sys.argv[3]) if len(sys.argv) > 3 else 256
    server = Server(gl="auto")
    try:
        latency(server, blocks, count)
        time_against_error(server, last_pass)
    finally:
        server.close()


main()
