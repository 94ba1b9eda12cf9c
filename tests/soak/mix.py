"""Lets clients groom, trace, upload, export and hang up for an hour, and watches the server's memory, temporary files and data folder.

usage: PELAGE_BIN=build/tests/bin python3 tests/soak/mix.py [MINUTES] [CSV]

Six times the clients stop, and memory is read at rest: what they made is gone, and the server's caches are in a defined state. Prints a line a minute, and
writes all readings to CSV if given. Exits with 1 if memory still grows by more than a tenth in the second half of the work or at rest after the second time,
if temporary files are left, or if a request fails.
"""
import http.client
import os
import pathlib
import random
import sys
import tempfile
import threading
import time

import numpy

import bodies
from support.server import Server, comb

READING_SECONDS = 10
RESTS = 6
REST_SECONDS = 35  # a progressive picture that nobody requests is kept for 30 s
MAX_GROWTH = 0.1  # largest relative growth of memory: of its mean from the third quarter to the last, and at rest from the second time to any later one
BINARY = {"Content-Type": "application/octet-stream"}


class Client:
    """One kind of user, which repeats `work`, each time on a new scene."""

    def __init__(self, server, work, seed):
        self.server, self.work, self.random = server, work, random.Random(f"{work} {seed}")
        self.done, self.failures = 0, []

    def run(self, ends):
        while not ends():
            try:
                scene = self.server.new_scene("creature", 3000)
                getattr(self, self.work)(scene)
                self.server.call("DELETE", scene.path)
                self.done += 1
            except (AssertionError, OSError, http.client.HTTPException) as error:
                self.failures.append(f"{self.work}: {error!r}")

    def expect(self, answer, *statuses):
        assert answer.status in (statuses or (200, 201)), answer

    def groom(self, scene):
        for _ in range(30):
            end = [self.random.uniform(-0.3, 0.3), self.random.uniform(0, 0.8), self.random.uniform(-0.5, 0.5)]
            self.expect(scene.run(comb([0, 0.5, 0.3], end, radius=0.15)))
            self.expect(scene.post("frames", {"width": 256, "height": 256, "quality": "draft"}))
        self.expect(scene.post("undo", {"steps": 5}))

    def trace(self, scene):
        request = {"width": 96, "height": 96, "progressive": {"passes": 4}}
        for passes in (0, 1):
            self.expect(scene.post(f"frames?after=0&after_pass={passes}&wait=5", request), 200, 304)

    def upload(self, scene):
        for name, content in bodies.MODELS.items():
            self.expect(self.server.call("PUT", f"{scene.path}/model?format={name}&discard=1", content, headers=BINARY), 200, 503)
        self.expect(self.server.call("PUT", f"{scene.path}/skin_texture", bodies.PICTURES[0], headers=BINARY), 200, 422, 503)  # refused if the model has no UVs
        self.expect(self.server.call("PUT", f"{scene.path}/model?format=ply&discard=1", b"ply\nbroken", headers=BINARY), 422, 503)

    def export(self, scene):
        saved = self.server.get(f"{scene.path}/export/pelage")
        self.expect(saved)
        opened = self.server.call("POST", "/v1/open", saved.body, headers=BINARY)
        self.expect(opened, 201, 503)
        if opened.status == 201:
            self.server.call("DELETE", f"/v1/scenes/{opened.json['id']}")
        self.expect(self.server.get(f"{scene.path}/export/cards"))

    def hang_up(self, scene):
        """Makes requests that take long, and hangs up."""
        for path in ("frame.png?width=2048&height=2048&quality=detailed", "export/usda", "events", "maps/length?size=2048"):
            connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=5)
            connection.request("GET", f"{scene.path}/{path}")
            time.sleep(self.random.uniform(0.02, 0.5))
            connection.close()


def reading(server, temporary):
    """Returns the megabytes of memory and of data, and the numbers of temporary and of open files."""
    process = pathlib.Path(f"/proc/{server.process.pid}")
    resident = int((process / "statm").read_text().split()[1]) * os.sysconf("SC_PAGESIZE")
    data = sum(file.stat().st_size for file in server.data.rglob("*") if file.is_file())
    return resident / 1e6, data / 1e6, sum(1 for _ in temporary.iterdir()), len(list((process / "fd").iterdir()))


def watch(server, temporary, clients, began, ends):
    readings, said = [], -1
    while time.monotonic() < ends and server.process.poll() is None:
        gone = (time.monotonic() - began) / 60
        readings.append((gone, *reading(server, temporary)))
        if int(gone) > said:
            said = int(gone)
            done = ", ".join(f"{client.work} {client.done}" for client in clients)
            print("{:5.1f} min: {:.0f} MB, data {:.1f} MB, {} temporary files, {} open files".format(*readings[-1]), f"({done})", flush=True)
        time.sleep(READING_SECONDS)
    return readings


def keep_busy(server, temporary, clients, began, minutes):
    """Runs all clients for this time, lets them finish their last rounds, and takes readings meanwhile."""
    ends = time.monotonic() + 60 * minutes
    threads = [threading.Thread(target=client.run, args=(lambda: time.monotonic() > ends,)) for client in clients]
    for thread in threads:
        thread.start()
    readings = watch(server, temporary, clients, began, ends)
    for thread in threads:
        thread.join()
    return readings


def rest(server, temporary):
    """Fills the server's caches (coats, the last traced picture) the same way each time, waits until everything else is dropped, and takes a reading."""
    scene = server.new_scene("creature", 3000)
    for quality in ("detailed", {"method": "strands", "trace": {"passes": 1}}):
        answer = scene.post("frames", {"width": 128, "height": 128, "quality": quality})
        assert answer.status == 200, answer
    server.call("DELETE", scene.path)
    time.sleep(REST_SECONDS)
    return reading(server, temporary)


def faults_of(server, temporary, readings, at_rest, clients):
    faults = [failure for client in clients for failure in client.failures]
    if server.process.poll() is not None:
        return [*faults, f"the server is gone: {server.printed()[-2000:]}"]
    third, last = numpy.array_split(numpy.array(readings)[:, 1], 4)[2:]
    if last.mean() > (1 + MAX_GROWTH) * third.mean():
        faults.append(f"memory grew from {third.mean():.0f} to {last.mean():.0f} MB in the second half")
    memory = [megabytes for megabytes, *_ in at_rest]
    if max(memory[1:]) > (1 + MAX_GROWTH) * memory[1]:
        faults.append(f"memory at rest grew from {memory[1]:.0f} to {max(memory[1:]):.0f} MB")
    if left := [file.name for file in temporary.iterdir()]:
        faults.append(f"temporary files are left: {left[:10]}")
    return faults


def main():
    minutes = float(sys.argv[1]) if len(sys.argv) > 1 else 60
    temporary = pathlib.Path(tempfile.mkdtemp(prefix="pelage-mix-"))
    os.environ["TMPDIR"] = str(temporary)  # for the server
    server = Server(arguments=["--memory", "512M"])
    del os.environ["TMPDIR"]
    try:
        clients = [Client(server, work, seed) for seed, work in enumerate(["groom", "groom", "trace", "upload", "export", "hang_up"])]
        began, readings, at_rest = time.monotonic(), [], []
        for _ in range(RESTS):
            readings += keep_busy(server, temporary, clients, began, minutes / RESTS)
            at_rest.append(rest(server, temporary))
            print("at rest: {:.0f} MB, data {:.1f} MB, {} temporary files, {} open files".format(*at_rest[-1]), flush=True)
        if len(sys.argv) > 2:
            numpy.savetxt(sys.argv[2], readings, "%.3f", ",", header="minutes,memory_mb,data_mb,temporary_files,open_files", comments="")
        faults = faults_of(server, temporary, readings, at_rest, clients)
        print("\n".join(faults) or "no faults")
        return 1 if faults else 0
    finally:
        server.close()
        temporary.rmdir()


if __name__ == "__main__":
    sys.exit(main())
