"""Compares a furry torus rendered by us and by Blender Cycles: how alike the pictures are, and CPU seconds at equal noise.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/peers/compare_cycles.py FOLDER [SIZE [MAX_SAMPLES [TRUTH_SAMPLES]]]

Writes scene, pictures (ours_*.exr, cycles_*.exr, both truths as JPEG) and times to FOLDER. Exits with 77 if there is no
blender.
"""
import os
import pathlib
import shutil
import subprocess
import sys


def main(arguments):
    blender = shutil.which("blender")
    if not blender:
        print("skipped: there is no blender here")
        return 77
    folder = pathlib.Path(arguments[0])
    size, maximum, truth = (arguments[1:] + ["160", "16", "256"][len(arguments) - 1:])[:3]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "cycles.txt").unlink(missing_ok=True)
    bench = [str(pathlib.Path(os.environ.get("PELAGE_BIN", "build/tests/bin")) / "bench_peer_scene")]
    script = str(pathlib.Path(__file__).with_name("cycles.py"))
    cycles = [blender, "--background", "--factory-startup", "--python-exit-code", "1", "--python", script, "--", str(folder)]
    counts = [str(4 ** i) for i in range(16) if 4 ** i <= int(maximum)]
    # The Python inside blender finds its library by the first python3 in PATH, which has to be the one beside blender.
    path = os.pathsep.join([str(pathlib.Path(blender).parent), os.environ["PATH"]])
    quiet = {"check": True, "stdout": subprocess.DEVNULL, "env": {**os.environ, "PATH": path}}
    subprocess.run(bench + ["write", str(folder), "--size", size, "--passes", maximum, "--truth", truth], check=True)
    subprocess.run(cycles + [",".join(counts)], **quiet)
    subprocess.run(cycles + [truth, "7", "truth"], **quiet)
    subprocess.run(bench + ["compare", str(folder), "cycles"], check=True)
    return 0


sys.exit(main(sys.argv[1:]))
