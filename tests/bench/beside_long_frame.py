"""Drafts of one scene while long frames of another are drawn, and the CPU that a frame takes after its client hung up.

usage: PELAGE_BIN=build/release/bin python3 tests/bench/beside_long_frame.py [SIZE] [FRAMES]
"""
import http.client
import json
import pathlib
import socket
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from support.server import Server  # noqa: E402

DRAFT = {"quality": "draft", "width": 256, "height": 256}
VIEWS = ("three_quarter", "front", "left")


def long_frame(size, i):
    return {"quality": "detailed", "width": size, "height": size + i, "camera": {"auto": VIEWS[i % len(VIEWS)]}}


def frame_ms(server, scene, body):
    """Milliseconds of a frame, as its client sees them."""
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
    """Milliseconds of each draft that was asked for, one after another, while a long frame was drawn."""
    thread = threading.Thread(target=frame_ms, args=(server, long_scene, body))
    thread.start()
    drafts = []
    while thread.is_alive():
        drafts.append(frame_ms(server, scene, DRAFT))
        time.sleep(0.05)
    thread.join()
    return drafts


def cpu_after_hang_up(server, scene, body, wait):
    """CPU seconds of the server in the three seconds after the client of a frame hung up."""
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
    size = int(sys.argv[1]) if len(sys.argv) > 1 else 768
    frames = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    server = Server(gl="auto")
    try:
        long_scene, scene = server.new_scene("creature", 20000), server.new_scene("creature", 5000)
        frame_ms(server, long_scene, {**long_frame(256, 0), "quality": "draft"})
        frame_ms(server, scene, DRAFT)
        drafts = []
        for i in range(frames):
            drafts += drafts_beside(server, long_scene, scene, long_frame(size, i))
            print(f"{i + 1} of {frames} long frames, {len(drafts)} drafts", file=sys.stderr, flush=True)
        drafts.sort()
        print(f"draft beside a detailed frame of {size}: median {drafts[len(drafts) // 2]:.0f} ms, "
              f"95% {drafts[int(0.95 * len(drafts))]:.0f}, max {drafts[-1]:.0f}, of {len(drafts)}")
        for i, wait in enumerate((0.1, 0.3, 0.6, 1.0, 1.5, 2.5)):
            after = cpu_after_hang_up(server, long_scene, long_frame(size, frames + i), wait)
            print(f"hung up after {wait} s: {after:.2f} s of CPU", flush=True)
    finally:
        server.close()


main()
