"""pelage compare: local pictures, no server."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy
from PIL import Image

from support.server import BIN


class Compare(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        x, y = numpy.meshgrid(numpy.arange(96), numpy.arange(80))
        fur = numpy.stack([120 + 60 * numpy.sin(x), 90 + 50 * numpy.sin(x + 0.05 * y), 60 + y / 2], axis=-1)
        alpha = 255 * ((x - 48) ** 2 + (y - 40) ** 2 < 30 ** 2)
        self.fur = numpy.dstack([fur, alpha]).astype(numpy.uint8)

    def picture(self, name, pixels):
        path = self.folder / name
        Image.fromarray(pixels).save(path)
        return path

    def compare(self, *arguments, code=0):
        # No server listens here: none is needed.
        run = subprocess.run([BIN / "pelage", "compare", *map(str, arguments)], capture_output=True, text=True, timeout=120,
                             env={**os.environ, "PELAGE_SERVER": "http://127.0.0.1:1"})
        self.assertEqual(run.returncode, code, run)
        return run

    def figures(self, *arguments):
        return json.loads(self.compare("--json", *arguments).stdout)

    def darker(self, factor=0.9):
        return (self.fur * [factor, factor, factor, 1]).astype(numpy.uint8)

    def test_a_picture_equals_itself(self):
        a = self.picture("a.png", self.fur)
        figures = self.figures(a, a)
        self.assertEqual((figures["flip"], figures["silhouette"]["mean"], figures["rmse"], figures["bias"]),
                         ({"mean": 0, "percentile_95": 0}, 0, 0, 0))
        share = (self.fur[..., 3] > 0).mean()
        self.assertAlmostEqual(figures["coverage"], share, places=6)
        self.assertIn("FLIP        mean 0.0000", self.compare(a, a).stdout)

    def test_worse_is_worse_and_darker_is_a_negative_bias(self):
        a = self.picture("a.png", self.fur)
        near = self.figures(a, self.picture("near.png", self.darker(0.95)))
        far = self.figures(a, self.picture("far.png", self.darker(0.7)))
        self.assertLess(0, near["flip"]["mean"])
        self.assertLess(near["flip"]["mean"], far["flip"]["mean"])
        self.assertLess(far["bias"], near["bias"])
        self.assertLess(near["bias"], 0)

    def test_map_shows_where(self):
        spoilt = self.fur.copy()
        spoilt[38:42, 46:50, :3] = 255
        path = self.folder / "map.png"
        self.compare(self.picture("a.png", self.fur), self.picture("b.png", spoilt), "--map", path)
        with Image.open(path) as image:
            light = numpy.asarray(image.convert("L")).astype(int)
        self.assertEqual(light.shape, (80, 96))
        self.assertGreater(light[40, 48], light[5, 5] + 100)

    def test_masks(self):
        spoilt = self.fur.copy()
        spoilt[:, :40, :3] = 0
        a, b = self.picture("a.png", self.fur), self.picture("b.png", spoilt)
        right = numpy.zeros((80, 96), numpy.uint8)
        right[:, 60:] = 255
        figures = self.figures(a, b, "--mask", self.picture("mask.png", right))
        self.assertEqual(figures["flip"]["mean"], 0)
        self.assertAlmostEqual(figures["coverage"], 36 / 96, places=6)
        self.assertGreater(self.figures(a, b)["flip"]["mean"], 0.05)
        opaque = self.picture("opaque.png", self.fur[..., :3])
        whole = self.figures(opaque, opaque)
        self.assertEqual((whole["coverage"], whole["silhouette"]), (1, None))
        self.assertIn("none in the mask", self.compare(opaque, opaque).stdout)

    def test_other_formats(self):
        a, exr = self.picture("a.png", self.fur[..., :3]), self.folder / "a.exr"
        subprocess.run(["oiiotool", a, "--colorconvert", "sRGB", "linear", "-d", "float", "-o", exr], check=True)
        self.assertEqual(self.figures(exr, exr)["flip"]["mean"], 0)
        self.assertLess(self.figures(a, exr, "--tone-map", "none")["flip"]["mean"], 0.01)
        self.assertGreater(self.figures(a, exr)["flip"]["mean"], 0.01)
        jpeg = self.folder / "a.jpg"
        Image.fromarray(self.fur[..., :3]).save(jpeg, quality=90)
        self.assertLess(self.figures(a, jpeg)["flip"]["mean"], 0.2)

    def test_not_a_number_is_refused(self):
        a, broken = self.folder / "a.exr", self.folder / "nan.exr"
        subprocess.run(["oiiotool", "--pattern", "constant:color=0.5,0.5,0.5", "8x8", "3", "-d", "float", "-o", a,
                        "--addc", "nan,0,0", "-o", broken], check=True)
        run = self.compare(a, broken, code=3)
        self.assertIn("64 pixels are NaN or infinite", run.stderr)

    def test_a_client_without_the_library_of_pictures_says_so(self):
        alone = shutil.copy(BIN / "pelage", self.folder)
        picture = self.picture("a.png", self.fur)
        run = subprocess.run([alone, "compare", picture, picture], capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"pelage-pictures\.so.*\n  next:    build or install all programs in one folder")

    def test_refusals(self):
        a, small = self.picture("a.png", self.fur), self.picture("small.png", self.fur[:40])
        self.assertIn("96 x 80 and 96 x 40", self.compare(a, small, code=3).stderr)
        self.assertIn("another size", self.compare(a, a, "--mask", small, code=3).stderr)
        self.assertIn("nothing.png", self.compare(a, self.folder / "nothing.png", code=3).stderr)
        text = self.folder / "text.png"
        text.write_text("no picture")
        self.assertIn("text.png", self.compare(a, text, code=3).stderr)
        self.compare(a, code=2)
        self.compare(a, a, "--tone-map", "aces", code=2)
        clear = self.picture("clear.png", self.fur * numpy.array([1, 1, 1, 0], numpy.uint8))
        self.assertIn("mask is empty", self.compare(clear, clear, code=3).stderr)
        self.compare(a, a, "--map", self.folder / "no" / "map.png", code=1)


if __name__ == "__main__":
    unittest.main()
