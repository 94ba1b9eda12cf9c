"""pelage trade: a table and a page through the real server."""

import csv
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from support.nightly import nightly
from support.server import BIN, REPOSITORY, ServedTest

sys.path.insert(0, str(REPOSITORY / "clients" / "python"))
import pelage  # noqa: E402
from pelage.trade.cases import TIERS  # noqa: E402


class Trade(ServedTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name) / "report"

    def trade(self, *arguments, size=32, code=0):
        return self.pelage("trade", "--quick", "--size", size, "--passes", "2", "-o", self.folder, *arguments, code=code)

    def rows(self):
        with open(self.folder / "results.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    @nightly
    def test_report(self):
        run = self.trade()
        self.assertIn("index.html", run.stdout)
        rows = self.rows()
        self.assertGreater(len(rows), 15)
        self.assertEqual({row["value"] for row in rows if row["series"] == "tier"}, {"draft", "interactive", "detailed"})
        self.assertEqual({row["passes"] for row in rows}, {"2"})
        for row in rows:
            self.assertEqual(row["non_finite"], "0", row)
            self.assertGreater(float(row["draw_ms"]), 0, row)
            self.assertTrue(0 <= float(row["flip"]) <= 1 and math.isfinite(float(row["luminance"])), row)
            knobs = json.loads(row["knobs"])
            columns = {"strands": float(row["strands"]), "light_of": int(row["light_of"])}
            self.assertEqual((knobs["raster"], knobs["scale"]), (columns, float(row["scale"])))
        self.check_page()
        self.assertEqual(self.server.get("/v1/scenes").json["scenes"], [], "the scene that it made is gone")

    def check_page(self):
        text = (self.folder / "index.html").read_text(encoding="utf-8")
        page = ElementTree.fromstring(text.split("\n", 1)[1])  # without the doctype
        self.assertNotIn("http", text)  # nothing from elsewhere
        self.assertNotIn(str(self.folder), text)
        sources = [image.get("src") for image in page.iter("img")]
        self.assertEqual([source[:30] for source in sources if not source.startswith("data:image/")], [])
        self.assertEqual(len(sources), 7)  # the truth, three tiers and their errors
        self.assertGreaterEqual(len(list(page.iter("svg"))), 5)
        headings = [heading.text for heading in page.iter("h2")]
        self.assertIn("What to choose when", headings)

    @nightly
    def test_resume_and_a_scene_of_the_users(self):
        scene = self.server.new_scene("torus", 200, name="mine")
        self.addCleanup(self.server.call, "DELETE", scene.path)
        revision = scene.info()["revision"]
        self.trade("--scene", "mine")
        first = self.rows()
        self.assertEqual({row["scene"] for row in first}, {"mine, near"})
        self.trade("--scene", scene.id, "--resume")
        kept = {row["value"]: row["draw_ms"] for row in first if row["series"] == "grid"}
        again = {row["value"]: row["draw_ms"] for row in self.rows() if row["series"] == "grid"}
        self.assertEqual(kept, again)
        self.assertEqual(len(self.rows()), len(first))
        self.trade("--scene", scene.id, "--resume", size=24)
        self.assertEqual({row["size"] for row in self.rows()}, {"24"}, "sizes are not mixed")
        self.assertEqual(scene.info()["revision"], revision, "only looked at")

    def test_refusals(self):
        self.trade("--scene", "nobody", code=3)
        self.trade("--passes", "0", code=2)
        self.folder.mkdir()
        (self.folder / "results.csv").write_text("a,b\r\n1,2\r\n")
        self.assertIn("other columns", self.trade("--resume", code=3).stderr)

    def test_what_is_missing_is_named(self):
        without_numpy = self.folder / "without"
        without_numpy.mkdir(parents=True)
        (without_numpy / "numpy.py").write_text("raise ImportError")
        alone = shutil.copy(BIN / "pelage-trade", self.folder)
        for path, name in (("", "no program pelage on"), (without_numpy, "NumPy")):
            run = subprocess.run([alone, "-o", self.folder], capture_output=True, text=True, timeout=60,
                                 env={**os.environ, "PATH": "/nowhere", "PYTHONPATH": str(path)})
            self.assertEqual(run.returncode, 1, run)
            self.assertRegex(run.stderr, f"pelage: .*{name}.*\n  next:    mend")

    def test_the_tiers_are_those_of_the_server(self):
        with pelage.Server(self.server.address) as server:
            scene = server.create(model={"builtin": "sphere", "triangles": 200})
            for tier, knobs in TIERS.items():
                self.assertEqual(scene.frame(quality=tier, width=32, height=32).quality, knobs)
            scene.remove()


if __name__ == "__main__":
    unittest.main()
