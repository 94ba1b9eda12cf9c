"""Measures how drawing a job's frames scales over processes, and how soon the first frame is there.

48 frames of the creature, packed as for a farm, are drawn by one process on one core, by two on a core each, and by one on both, in
turns; the minimum of each counts. A process is pinned to its cores, as by a farm. Then follow the seconds from the start of pelage-render
to its first file, for a packed scene of 5,000 triangles.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/farm.py [--rounds 3] [--size 640]
"""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile
import time

BIN = pathlib.Path(os.environ["PELAGE_BIN"]).resolve()
SETUPS = {"one process, one core": [("1-48", {0})], "two processes, a core each": [("1-47x2", {0}), ("2-48x2", {1})],
        "one process, both cores": [("1-48", {0, 1})]}


def job(folder, size):
    path = folder / "job.json"
    subprocess.run([BIN / "pelage", "farm", "pack", "--builtin", "creature", "--triangles", "5000", "-o", folder / "creature.pelage"],
                   check=True, stdout=subprocess.DEVNULL, env={**os.environ, "PATH": f"{BIN}:{os.environ['PATH']}"})
    path.write_text(json.dumps({
        "scene": "creature.pelage", "frames": "1-48", "output": "out/f.####.png", "turntable": {},
        "frame": {"width": size, "height": size, "camera": {"auto": "three_quarter"}, "quality": "interactive"}}))
    return path


def seconds(path, parts):
    began = time.perf_counter()
    processes = [subprocess.Popen([BIN / "pelage-render", path, "--frames", frames, "--threads", str(len(cores))],
                                  stdout=subprocess.DEVNULL, preexec_fn=lambda cores=cores: os.sched_setaffinity(0, cores))
                 for frames, cores in parts]
    assert all(process.wait() == 0 for process in processes)
    return time.perf_counter() - began


def first_frame(path):
    began = time.perf_counter()
    process = subprocess.Popen([BIN / "pelage-render", path], stdout=subprocess.PIPE, text=True)
    while not process.stdout.readline().startswith("Saved: "):
        pass
    passed = time.perf_counter() - began
    process.kill()
    process.communicate()
    return passed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--size", type=int, default=640)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = job(pathlib.Path(folder), options.size)
        seconds_of = {setup: float("inf") for setup in SETUPS}
        for _ in range(options.rounds):
            for setup, parts in SETUPS.items():
                seconds_of[setup] = min(seconds_of[setup], seconds(path, parts))
                print(f"{setup}: {seconds_of[setup]:.1f} s, {seconds_of[next(iter(SETUPS))] / seconds_of[setup]:.2f} times as fast", flush=True)
        print(f"start to first frame: {min(first_frame(path) for _ in range(5)):.2f} s")


main()
