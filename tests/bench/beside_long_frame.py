"""Measures drafts of one scene while long frames of another are drawn, and the CPU time of a frame after its client
hung up.

usage: PELAGE_BIN=build/release/bin python3 tests/bench/beside_long_frame.py [detailed|reference|max_error] [SIZE] [FRAMES]
"""
import http.client
import json
import os
import pathlib
import socket
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from support.server import Server  # noqa: E402

DRAFT = {"quality": "draft", "width": 256, "height": 256}
VIEWS = ("three_quarter", "front", "left", "right", "back", "top")
LONG = {"detailed": {"quality": "detailed"}, "reference": {"quality": "reference", "max_seconds": 900},
        "max_error": {"max_error": 0.01}}


def long_frame(kind, size, i):
    """Returns a request with another view and size each time, so that nothing of it is cached."""
    return {**LONG[kind], "width": size, "height": size + i, "camera": {"auto": VIEWS[i % len(VIEWS)]}}


def frame_ms(server, scene, body):
    """Milliseconds from request to answer of a frame, as its client sees them."""
    connection = http.client.HTTPConnection("127.0.0.1", server.port)
    start = time.perf_counter()
    connection.request("POST", f"{scene.path}/frames", json.dumps(body))
    answer = connection.getresponse()
    answer.read()
    assert answer.status == 200, answer.status
    return 1e3 * (time.perf_counter() - start)


def cpu_seconds(server):
    fields = pathlib.Path(f"/proc/{server.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / 100


def drafts_beside(server, long_scene, scene, body):
    """Milliseconds of each of the drafts that are requested one after another while a long frame is drawn."""
    thread = threading.Thread(target=frame_ms, args=(server, long_scene, body))
    thread.start()
    drafts = []
    while thread.is_alive():
        drafts.append(frame_ms(server, scene, DRAFT))
        time.sleep(0.05)
    thread.join()
    return drafts


def cpu_after_hang_up(server, scene, body, wait):
    """CPU seconds that the server uses in the three seconds after the client of a frame hung up."""
    data = json.dumps(body).encode()
    client = socket.create_connection(("127.0.0.1", server.port))
    client.sendall(f"POST {scene.path}/frames HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
                   f"Content-Type: application/json\r\nContent-Length: {len(data)}\r\n\r\n".encode() + data)
    time.sleep(wait)
    before = cpu_seconds(server)
    client.close()
    time.sleep(3)
    return cpu_seconds(server) - before


def main():
    kind = sys.argv[1] if len(sys.argv) > 1 else "detailed"
    size = int(sys.argv[2]) if len(sys.argv) > 2 else 768
    frames = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    server = Server(gl="auto")
    try:
        long_scene, scene = server.new_scene("creature", 20000), server.new_scene("creature", 5000)
        frame_ms(server, scene, DRAFT)
        drafts, before, start = [], cpu_seconds(server), time.perf_counter()
        for i in range(frames):
            drafts += drafts_beside(server, long_scene, scene, long_frame(kind, size, i))
            print(f"{i + 1} of {frames} long frames, {len(drafts)} drafts", file=sys.stderr, flush=True)
        drafts.sort()
        print(f"draft beside {kind} frames of {size}: median {drafts[len(drafts) // 2]:.0f} ms, "
              f"95% {drafts[int(0.95 * len(drafts))]:.0f}, max {drafts[-1]:.0f}, of {len(drafts)}; "
              f"{cpu_seconds(server) - before:.1f} s of CPU in {time.perf_counter() - start:.1f} s, "
              f"load {os.getloadavg()[0]:.1f}", flush=True)
        for i, wait in enumerate((0.1, 0.3, 0.6, 1.0, 1.5, 2.5)):
            after = cpu_after_hang_up(server, long_scene, long_frame(kind, size, frames + i), wait)
            print(f"hung up after {wait} s: {after:.2f} s of CPU", flush=True)
    finally:
        if os.environ.get("KEEP"): open(os.environ["KEEP"], "w").write(server.printed())
        server.close()


main()
