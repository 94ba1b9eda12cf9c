"""Jobs of pelage-render in a folder of their own."""

import hashlib
import json
import math
import subprocess
import tempfile
import unittest
from pathlib import Path

from support.server import BIN, THIN_COAT

JOB = {"builtin": {"builtin": "sphere", "triangles": 500}, "frames": "1-6", "fps": 24, "output": "out/ball.###.png",
       "frame": {"width": 48, "height": 40, "quality": "draft"}, "turntable": {"degrees": 360}}


class JobTest(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(lambda: subprocess.run(["rm", "-rf", self.folder], check=True))

    def job(self, **more):
        path = self.folder / "job.json"
        path.write_text(json.dumps({**JOB, **more, "commands": [THIN_COAT, *more.get("commands", [])]}))
        return path

    def render(self, *arguments, code=0):
        run = subprocess.run([BIN / "pelage-render", *map(str, arguments)], capture_output=True, text=True, timeout=120)
        self.assertEqual(run.returncode, code, run)
        return run

    def frames(self):
        return sorted((self.folder / "out").glob("*"))

    def hashes(self):
        return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in self.frames()}

    def write_ball(self, name, stretch=0.0, sides=12):
        """A ball of quads and triangles as an OBJ, bent to the side by the height."""
        lines, rings = [], sides // 2
        for ring in range(rings + 1):
            for side in range(sides):
                up, round = math.pi * ring / rings, 2 * math.pi * side / sides
                y = -math.cos(up)
                lines.append(f"v {math.sin(up) * math.sin(round) + stretch * (y + 1) ** 2:.6f} {y:.6f} {math.sin(up) * math.cos(round):.6f}")
        for ring in range(rings):
            for side in range(sides):
                a, b = ring * sides + side + 1, ring * sides + (side + 1) % sides + 1
                lines.append(f"f {a} {b} {b + sides} {a + sides}")
        (self.folder / name).write_text("\n".join(lines) + "\n")

    def moving(self, **more):
        still = {"turntable": {"degrees": 0, "turns": "camera"}, "frames": "1-3", "builtin": None, "scene": "ball.obj",
                 "options": {"format": "obj"}, **more}
        path = self.job(**still)
        path.write_text(json.dumps({name: value for name, value in json.loads(path.read_text()).items() if value is not None}))
        return path
