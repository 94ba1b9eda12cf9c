"""Helpers of the farm tests: the command line, jobs, and frames as pelage-render writes them."""

import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ.get("PELAGE_BIN", REPOSITORY / "build" / "release" / "bin"))
sys.path.insert(0, str(REPOSITORY / "clients" / "python"))


def nightly(test):
    """Marks a test that takes too long for each day: tests/nightly.sh runs it."""
    test.nightly = True
    return test


def needs(found, what):
    """Skips the test if something is missing, but fails it in CI."""
    if not found:
        if os.environ.get("CI") == "true":
            raise AssertionError(f"{what} is missing: deploy/packages.sh test installs it")
        raise unittest.SkipTest(f"{what} is missing")


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def png(width=16, height=8, colour=(200, 120, 40), fingerprint="f"):
    """A picture of one colour, with a fingerprint."""
    rows = (b"\0" + bytes(colour) * width) * height
    return b"".join((
        b"\x89PNG\r\n\x1a\n", chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)),
        chunk(b"tEXt", b"Software\0pelage-render"), chunk(b"tEXt", b"pelage/fingerprint\0" + fingerprint.encode()),
        chunk(b"IDAT", zlib.compress(rows)), chunk(b"IEND", b"")))


class FarmTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="pelage-farm-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def farm(self, *words, code=0, environment=None, timeout=120):
        """Runs `pelage farm` and returns what it prints. Checks the exit code unless `code` is None."""
        done = subprocess.run([str(BIN / "pelage"), "farm", *map(str, words)], capture_output=True, text=True, timeout=timeout,
                              stdin=subprocess.DEVNULL, env={**os.environ, **(environment or {})}, cwd=self.folder)
        if code is not None:
            self.assertEqual(done.returncode, code, f"{words}: {done.stdout}{done.stderr}")
        return done

    def status(self, folder, code=0, **more):
        return json.loads(self.farm("status", folder, "--json", code=code, **more).stdout)

    def write_job(self, frames="1-12", **more):
        """Writes a job of small frames of a built-in model. Returns its file."""
        thin_coat = {"op": "set_coat", "coat": {"count": 500}}  # so few strands that they grow at once
        job = {"builtin": {"builtin": "sphere", "triangles": 500}, "commands": [thin_coat], "frames": frames, "output": "out/ball.####.png",
               "frame": {"width": 64, "height": 48, "quality": "draft"}, "turntable": {"degrees": 360}, **more}
        file = self.folder / "ball.json"
        file.write_text(json.dumps({name: value for name, value in job.items() if value is not None}))
        return file
