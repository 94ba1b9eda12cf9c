"""Measures the peak memory of a server, and how long a polite client waits, while many clients request frames of coats
that are not baked yet.

usage: PELAGE_BIN=build/release/bin python3 tests/bench/cold_herd.py [CLIENTS] [COATS] [SECONDS]

CLIENTS of one scene request frame after frame, each from its own direction. Every SECONDS / COATS the scene gets a new coat,
seen closely enough to need all its levels. The polite client requests a draft of another scene ten times a second.
"""
import math
import pathlib
import re
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from support.server import Server  # noqa: E402

MEMORY = 4 << 30


def peak_bytes(server):
    return 1024 * int(re.search(r"VmHWM:\s+(\d+)", pathlib.Path(f"/proc/{server.process.pid}/status").read_text())[1])


def view_of(client):
    turn = 2 * math.pi * client / 64
    return {"width": 256, "height": 256, "camera": {"position": [0.7 * math.sin(turn), 0.1, 0.7 * math.cos(turn)],
                                                    "target": [0, 0, 0]}}


def percentile(seconds, share):
    ordered = sorted(seconds)
    return 1e3 * ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else math.nan


def ask_again_and_again(scene, request, until, waits, pause=0.0):
    """Requests frames until the deadline, and appends (time of the answer, waiting time) of each, in seconds."""
    while (start := time.monotonic()) < until:
        answer = scene.post("frames", request, timeout=600)
        assert answer.status == 200, answer
        waits.append((time.monotonic(), time.monotonic() - start))
        time.sleep(pause)


def main():
    clients, coats, seconds = (int(value) for value in (sys.argv[1:] + ["64", "3", "60"][len(sys.argv) - 1:]))
    server = Server(arguments=["--memory", str(MEMORY)])
    try:
        herd_scene, polite_scene = server.new_scene("creature", 5000), server.new_scene("sphere", 2000)
        draft = {"quality": "draft", "width": 256, "height": 256}
        polite_scene.post("frames", draft)
        idle, herd, polite = peak_bytes(server), [], []
        until = time.monotonic() + seconds
        threads = [threading.Thread(target=ask_again_and_again, args=(herd_scene, view_of(client), until, herd))
                   for client in range(clients)]
        threads.append(threading.Thread(target=ask_again_and_again, args=(polite_scene, draft, until, polite, 0.1)))
        for thread in threads:
            thread.start()
        for coat in range(1, coats):
            time.sleep(seconds / coats)
            assert herd_scene.run({"op": "set_coat", "coat": {"seed": coat}}).status == 200
        for thread in threads:
            thread.join()
        first = min(when for when, _ in herd)
        after = [wait for when, wait in polite if when - wait > first]
        baked = re.search(r"^pelage_coats_baked_total (\d+)", server.get("/metrics").body.decode(), re.M)
        print(f"{clients} clients, {coats} coats in {seconds} s: {len(herd)} frames of the herd, {baked[1] if baked else '?'} "
              f"bakes; peak memory {peak_bytes(server) / 1e6:.0f} MB, {idle / 1e6:.0f} before, --memory {MEMORY / 1e6:.0f}")
        for name, waits in (("herd", [wait for _, wait in herd]), ("polite, all", [wait for _, wait in polite]),
                            ("polite, after the first bake", after)):
            print(f"{name}: {len(waits)} frames, median {percentile(waits, 0.5):.0f} ms, 95% {percentile(waits, 0.95):.0f}, "
                  f"max {percentile(waits, 1):.0f}")
    finally:
        server.close()


main()
