"""Measures shells on a farm node with a GPU: how fast one device draws for several processes, and how its pictures differ from a software GL's.

`speed` draws a turntable of the creature with 1, 2, 4 and 8 processes that share the device, and with one on OSMesa on all
cores. Seconds per frame are counted after the first file, so the start does not count; it is listed separately.
`draw` draws some frames of each kind of shells into a folder. `compare` compares two such folders from different drivers:
mean and 99.9th percentile of the pixels' differences in 1/255, and the share of pixels that differ by more than 16.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/gpu_node.py speed [--gl egl] [--device 0] [--frames 100] [--width 1920] [--height 1080]
       ... draw FOLDER [--gl egl] [--width 480] [--height 480]
       python3 tests/bench/gpu_node.py compare FOLDER OTHER
"""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile
import time

SHELLS = {"four_pass": {}, "shadow_maps": {"shadow_maps": True}, "sorted": {"order": "sorted"}}


def program():
    return pathlib.Path(os.environ["PELAGE_BIN"]).resolve() / "pelage-render"


def write_job(folder, options, shells, frames):
    path = folder / f"{shells}.json"
    path.write_text(json.dumps({
        "builtin": {"builtin": "creature", "triangles": 20000}, "frames": f"1-{frames}", "output": f"{shells}.####.png", "turntable": {},
        "frame": {"width": options.width, "height": options.height, "camera": {"auto": "three_quarter"},
                  "quality": {"method": "shells", "shells": SHELLS[shells]}}}))
    return path


def start(path, options, *arguments):
    device = [] if options.device is None or "osmesa" in arguments else ["--device", str(options.device)]
    return subprocess.Popen([program(), path, *device, *arguments], stdout=subprocess.PIPE, text=True)


def saved(process):
    """Waits for the next file. Returns False if the process has ended."""
    for line in process.stdout:
        if line.startswith("Saved: "):
            return True
    return False


def timed(path, options, frames, processes, gl, threads):
    """Returns the seconds to the first file of the slowest process, and the seconds per frame after that."""
    began = time.perf_counter()
    parts = [start(path, options, "--frames", f"{k + 1}-{frames}x{processes}", "--gl", gl, "--threads", str(threads)) for k in range(processes)]
    assert all([saved(part) for part in parts]), "no first frame"
    first = time.perf_counter()
    for part in parts:
        part.communicate()
        assert part.returncode == 0, part.returncode
    return first - began, (time.perf_counter() - first) / max(1, frames - processes)


def speed(options):
    cores = os.cpu_count()
    setups = [(f"{n} processes, {options.gl}", n, options.gl, max(1, cores // n)) for n in (1, 2, 4, 8) if n <= cores]
    if options.gl != "osmesa":
        setups.append((f"1 process, OSMesa, {cores} threads", 1, "osmesa", cores))
    for shells in SHELLS:
        with tempfile.TemporaryDirectory() as folder:
            path = write_job(pathlib.Path(folder), options, shells, options.frames)
            base = None
            for name, processes, gl, threads in setups:
                first, frame = timed(path, options, options.frames, processes, gl, threads)
                base = base or frame
                print(f"{shells:12} {name:28} first {first:5.2f} s, then {frame * 1e3:7.1f} ms a frame, {base / frame:5.2f} times the first row", flush=True)


def draw(options):
    folder = pathlib.Path(options.folders[0])
    folder.mkdir(parents=True, exist_ok=True)
    for shells in SHELLS:
        process = start(write_job(folder, options, shells, 3), options, "--gl", options.gl)
        process.communicate()
        assert process.returncode == 0, (shells, process.returncode)


def compare(options):
    import numpy
    from PIL import Image

    one, other = (pathlib.Path(folder) for folder in options.folders)
    for path in sorted(one.glob("*.png")):
        first, second = (numpy.asarray(Image.open(folder / path.name).convert("RGB"), float) for folder in (one, other))
        apart = numpy.abs(first - second).max(axis=2)
        print(f"{path.name}: mean {apart.mean():.3f}, 99.9% {numpy.percentile(apart, 99.9):.0f}, over 16: {(apart > 16).mean() * 100:.3f}%")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("speed", "draw", "compare"))
    parser.add_argument("folders", nargs="*")
    parser.add_argument("--gl", default="egl")
    parser.add_argument("--device", type=int)
    parser.add_argument("--frames", type=int, default=100)
    parser.add_argument("--width", type=int)
    parser.add_argument("--height", type=int)
    options = parser.parse_args()
    options.width = options.width or (1920 if options.what == "speed" else 480)
    options.height = options.height or (1080 if options.what == "speed" else 480)
    {"speed": speed, "draw": draw, "compare": compare}[options.what](options)


main()
