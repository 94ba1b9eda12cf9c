"""Makes what docs/trade shows, with the programs of build/release or $PELAGE_BIN: the report of `pelage trade`, six
animals with error maps, and the tables of tests/bench/tiers.py and tests/bench/flicker.py.

usage: docs/trade/make.py [report] [animals] [flicker]     (all of them when none is named)
"""
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "trade"
sys.path.insert(0, str(ROOT / "tests" / "end_to_end"))
from support.server import BIN, Server  # noqa: E402


def report():
    server = Server()
    try:
        subprocess.run([BIN / "pelage", "--server", server.address, "trade", "-o", FOLDER, "--size", "128"], check=True)
    finally:
        server.close()


def table(script, name, *arguments):
    run = subprocess.run([sys.executable, ROOT / "tests" / "bench" / script, *arguments], check=True,
                         stdout=subprocess.PIPE, text=True, env={**os.environ, "PELAGE_BIN": str(BIN)})
    (FOLDER / name).write_text(run.stdout, encoding="utf-8")
    print(run.stdout)


def animals():
    table("tiers.py", "tiers.md", "--size", "160", "--passes", "64", "--pictures", str(FOLDER))


STEPS = {"report": report,
         "animals": animals,
         "flicker": lambda: table("flicker.py", "flicker.md", "--size", "160", "--frames", "5")}


def main():
    for name in sys.argv[1:] or STEPS:
        start = time.monotonic()
        STEPS[name]()
        print(f"{name}: {time.monotonic() - start:.0f} s", flush=True)


main()
