"""The example programs of the Python package, in small, as a user runs them."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy
from PIL import Image

from support.nightly import nightly
from support.server import BIN, REPOSITORY, THIN_COAT, Server

EXAMPLES = REPOSITORY / "clients" / "python" / "examples"
WEB_PACKAGES = REPOSITORY / "clients" / "web" / "node_modules"
SMALL = ("--quality", "draft", "--size", "64")
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
RECIPE = {"variables": {"fur": 0.02}, "steps": [THIN_COAT, {"op": "length", "flood": True, "value": "${fur}"}]}
LONG = {"op": "length", "flood": True, "mode": "scale", "value": 2}


def program_or_skip(found, name):
    """Skips a test whose program is missing; fails it in CI."""
    if found:
        return found
    if os.environ.get("CI") == "true":
        raise AssertionError(f"{name} is missing")
    raise unittest.SkipTest(f"{name} is missing")


class ExampleTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def example(self, name, *arguments, code=0):
        """Runs an example with a private server, which has to end with `code`; what it prints."""
        environment = {**os.environ, "PELAGE_SERVER_PROGRAM": str(BIN / "pelaged")}
        done = subprocess.run([sys.executable, EXAMPLES / name, *map(str, arguments)], capture_output=True, text=True,
                              timeout=400, cwd=self.folder, env=environment)
        self.assertEqual(done.returncode, code, done)
        self.assertNotIn("Traceback", done.stderr)
        return done.stdout + done.stderr

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def picture(self, name):
        with Image.open(self.folder / name) as image:
            return numpy.asarray(image.convert("RGB")).astype(int)


class Pictures(ExampleTest):
    def test_folder_of_models(self):
        self.write("models/a.obj", TETRAHEDRON)
        self.write("models/broken.obj", "")
        self.write("models/c.obj", TETRAHEDRON)
        self.write("models/readme.txt", "no model")
        printed = self.example("folder_of_models.py", "models", self.write("fur.json", RECIPE), "--output", "out", *SMALL, code=1)
        self.assertRegex(printed, "broken.obj failed: 422 .*empty")
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()), ["a.obj.png", "c.obj.png", "sheet.png"])
        self.assertGreater(self.picture("out/c.obj.png").std(), 5)

    def test_folder_of_models_says_what_is_wrong(self):
        self.write("empty/readme.txt", "")
        printed = self.example("folder_of_models.py", "empty", "fur.json", code=1)
        self.assertIn("has no file that ends with one of .obj", printed)
        self.write("models/a.obj", TETRAHEDRON)
        self.assertIn("there is no groom fur.json", self.example("folder_of_models.py", "models", "fur.json", code=1))
        printed = self.example("folder_of_models.py", "models", self.write("bad.json", {"op": "lenght"}), *SMALL, code=1)
        self.assertIn("nearest: length", printed)

    def test_contact_sheet(self):
        for name in ("fox", "zebra"):
            look = (REPOSITORY / "clients" / "looks" / f"{name}.json").read_text()
            self.write(f"looks/{name}.json", re.sub('"count": [0-9]+', '"count": 500', look))
        self.example("contact_sheet.py", "--looks", "looks", "--model", "sphere", "--triangles", 500, "--output", "looks.png", *SMALL)
        sheet = self.picture("looks.png")
        self.assertEqual(sheet.shape[1], 128)
        self.assertGreater(numpy.abs(sheet[:64, :64] - sheet[:64, 64:]).max(), 50)  # two looks

    def test_turntable(self):
        groom = self.write("fur.json", RECIPE)
        self.example("turntable.py", "--frames", 3, "--groom", groom, "--model", "torus", "--triangles", 500,
                     "--output", "turn/fox", *SMALL)
        self.assertEqual(sorted(p.name for p in (self.folder / "turn").iterdir()),
                         ["fox.0001.png", "fox.0002.png", "fox.0003.png", "fox.webp"])
        with Image.open(self.folder / "turn" / "fox.webp") as animation:
            self.assertEqual(animation.n_frames, 3)
        self.assertGreater(numpy.abs(self.picture("turn/fox.0001.png") - self.picture("turn/fox.0002.png")).max(), 50)

    def test_a_running_server_keeps_nothing(self):
        server = Server()
        self.addCleanup(server.close)
        self.example("turntable.py", "--server", server.address, "--frames", 1, "--model", "plane", "--triangles", 2,
                     "--output", "fox", *SMALL)
        self.assertEqual(server.get("/v1/scenes").json["scenes"], [])

    def test_no_server(self):
        self.assertIn("turntable.py: ", self.example("turntable.py", "--server", "http://127.0.0.1:1", "--frames", 1, code=1))


class Checks(ExampleTest):
    @nightly
    def test_check_groom(self):
        stored = ("check_groom.py", "stored", "--triangles", 1000, *SMALL)
        self.assertIn("store it with --update", self.example(*stored, code=1))
        self.example(*stored, "--update")
        self.assertEqual(self.example(*stored).count("agrees"), 4)
        printed = self.example(*stored, "--groom", self.write("long.json", LONG), code=1)
        self.assertEqual(printed.count("DIFFERS"), 4)
        self.assertTrue((self.folder / "stored" / "left.difference.png").exists())
        self.assertIn("take its --size", self.example(*stored[:2], "--size", 32, "--quality", "draft", code=1))
        self.example(*stored)
        self.assertEqual(sorted(p.name for p in (self.folder / "stored").iterdir()), ["back.png", "front.png", "left.png", "right.png"])

    def test_match_direction(self):
        printed = self.example("match_direction.py", "--size", 256, "--rounds", 2, "--triangles", 1500, "--output", "matched")
        for what in ("pictures", "fields"):  # the picture's lines, and what the optimiser never sees
            before, after = map(float, re.search(rf"{what}: (\S+) degrees before, (\S+) after", printed).groups())
            self.assertLess(after, 0.6 * before, printed)
        self.assertEqual(numpy.load(self.folder / "matched" / "direction.npy").shape[1], 3)

    @nightly
    def test_match_direction_of_a_patch(self):
        """Returns a picture of a fan around a position below its lower edge. The program does not know how it was made."""
        across = numpy.arange(256)
        x, y = across[None, :] - 128, 380 - across[:, None]
        rays = 128 + 100 * numpy.sin(60 * numpy.arctan2(x, y))  # light and dark from one point
        Image.fromarray(rays.astype(numpy.uint8)).save(self.folder / "fan.png")
        patch = ("match_direction.py", "--patch", "--reference", "fan.png", "--size", 256, "--triangles", 3000)
        printed = self.example(*patch, "--away-from", 0.5, 1.5, "--rounds", 3, "--output", "fan")
        before, after = map(float, re.search(r"pictures: (\S+) degrees before, (\S+) after", printed).groups())
        self.assertLess(after, 8, printed)
        self.assertLess(after, before / 2, printed)
        field = numpy.load(self.folder / "fan" / "direction.npy").astype(float)
        self.assertGreater(field[:, 2].min(), 0)  # away from that point: up the picture, which is +z of the patch
        self.assertIn("beyond the reference, which has 256 x 256", self.example(*patch, "--crop", 200, 0, 80, code=1))


class OtherPrograms(ExampleTest):
    @nightly
    def test_to_blender(self):
        printed = self.example("to_blender.py", "--every", 64, "--triangles", 1000, "--output", "blender", *SMALL)
        strands = int(re.search(r"(\d+) strands", printed)[1])
        self.assertEqual(int.from_bytes((self.folder / "blender" / "fur.hair").read_bytes()[4:8], "little"), strands)
        about = json.loads((self.folder / "blender" / "scene.json").read_text())
        self.assertEqual((len(about["lights"]), about["size"]), (3, 64))
        printed = self.example("to_blender.py", "--blender", "false", "--every", 64, "--triangles", 1000, *SMALL, code=1)
        self.assertIn("Blender failed", printed)

    def test_the_import_into_blender_compiles(self):
        source = (EXAMPLES / "blender_import_hair.py").read_text()
        compile(source, "blender_import_hair.py", "exec")

    def test_to_unreal(self):
        model = ("--model", "torus", "--triangles", 500)
        printed = self.example("to_unreal.py", *model, "--every", 64, "--guides", 512, "--output", "unreal", "--quality", "draft")
        self.assertIn("primvars:groom_root_uv", printed)
        self.assertIn('apiSchemas = ["GroomAPI"]', (self.folder / "unreal" / "groom.usda").read_text())
        for name, guides in (("strands", 0), ("guides", 1)):
            text = (self.folder / "unreal" / f"{name}.usda").read_text()
            self.assertIn(f"int[] primvars:groom_guide = [{guides}]", text)
            self.assertIn("float3[] primvars:groom_color = [(", text)
        self.assertEqual(len(list((self.folder / "unreal").iterdir())), 3)

    @nightly
    def test_to_threejs(self):
        chromium = program_or_skip(shutil.which("chromium"), "chromium")
        program_or_skip(shutil.which("node") and (WEB_PACKAGES / "three").is_dir(), "node, or the studio's packages")
        self.example("to_threejs/to_threejs.py", "--triangles", 1000, "--output", "page", "--chromium", chromium,
                     "--quality", "draft", "--size", 200)
        for name in ("pelage", "shells", "cards", "shader"):
            with self.subTest(name):
                pixels = self.picture(f"page/{name}.png")
                fur = (pixels[..., 0] - pixels[..., 2] > 30).mean()  # brown, over a background of bluish grey
                self.assertTrue(0.03 < fur < 0.6, fur)


if __name__ == "__main__":
    unittest.main()
