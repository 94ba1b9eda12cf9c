"""The Python package as a package: it follows the contract, is typed, documented, and installs."""

import ast
import inspect
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from support.server import BIN, REPOSITORY

SOURCE = REPOSITORY / "clients" / "python"
sys.path.insert(0, str(SOURCE))
import pelage  # noqa: E402
import wheel_backend  # noqa: E402
from pelage.commands import Commands  # noqa: E402

CONTRACT = json.loads((BIN / "openapi.json").read_text())
# How each operation of the contract is reached.
OPERATIONS = {
    "listScenes": "Server.scenes", "createScene": "Server.create", "describeScene": "Scene.info", "removeScene": "Scene.remove",
    "uploadModel": "Scene.load", "getMesh": "Scene.mesh", "getVertices": "Scene.positions", "subdivide": "Scene.subdivide", "turn": "Scene.turn", "rename": "Scene.rename", "exportScene": "Scene.export", "openScene": "Server.open_file",
    "uploadEnvironment": "Scene.upload_environment", "uploadSkinTexture": "Scene.upload_skin_texture",
    "uploadPicture": "Scene.upload_picture", "getMap": "Scene.download_map", "uploadMap": "Scene.upload_map", "uploadGuides": "Scene.upload_guides",
    "runCommands": "Scene.run", "undo": "Scene.undo", "redo": "Scene.redo", "revert": "Scene.revert", "amend": "Scene.amend",
    "branch": "Scene.branch", "readLog": "Scene.log", "events": "Scene.follow", "readSettings": "Scene.settings",
    "listFrames": "Scene.frames_under_way", "drawFrame": "Scene.frame", "getFrame": "Scene.frame_address",
    "compare": "Scene.compare", "pick": "Scene.pick", "expandRecipe": "Scene.recipe_steps", "live": "Server.is_alive", "ready": "Server.is_ready",
    "metrics": "Server.metrics", "contract": "Server.contract", "home": "Server.studio_file", "studioFile": "Server.studio_file",
    "docs": "Server.docs_file", "docsFile": "Server.docs_file",
}


def run(*command, **more):
    """Runs a program, which has to succeed, and gives what it prints."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, **more)
    assert done.returncode == 0, (command, done.stdout, done.stderr)
    return done.stdout


def methods(kind):
    return {name: one for name, one in inspect.getmembers(kind, inspect.isfunction) if not name.startswith("_")}


def members(schema):
    return set(CONTRACT["components"]["schemas"][schema]["properties"])


class Contract(unittest.TestCase):
    def test_every_operation_is_reached(self):
        operations = {one["operationId"] for path in CONTRACT["paths"].values() for one in path.values() if "operationId" in one}
        self.assertEqual(operations, set(OPERATIONS))
        for name in OPERATIONS.values():
            kind, method = name.split(".")
            self.assertIn(method, methods(getattr(pelage, kind)), name)

    def test_every_command_has_all_members(self):
        mapping = CONTRACT["components"]["schemas"]["Command"]["discriminator"]["mapping"]
        self.assertEqual(set(methods(Commands)), set(mapping))
        for op, reference in mapping.items():
            with self.subTest(op):
                parameters = set(inspect.signature(getattr(Commands, op)).parameters)
                self.assertEqual(parameters - {"self", "author", "dry_run", "if_match"}, members(reference.split("/")[-1]) - {"op"})

    def test_requests_have_all_members(self):
        for name, schema, without in (("better_frames", "FrameRequest", {"revision"}), ("frame", "FrameRequest", {"progressive"}),
                                      ("load", "ImportOptions", set()), ("upload_map", "MapUpload", set()), ("upload_guides", "GuideUpload", set()),
                                      ("download_map", "MapRequest", set()), ("upload_environment", "EnvironmentUpload", set()),
                                      ("mesh", "MeshRequest", set()), ("subdivide", "Subdivide", set()), ("turn", "TurnModel", set()), ("pick", "View", set())):
            with self.subTest(name):
                self.assertLessEqual(members(schema) - without, set(inspect.signature(getattr(pelage.Scene, name)).parameters))
        self.assertEqual(members("NewScene"), set(inspect.signature(pelage.Server.create).parameters) - {"self"})

    def test_a_new_member_and_command_come_with_the_contract(self):
        """The generator writes their classes and methods."""
        contract = json.loads(json.dumps(CONTRACT))
        schemas = contract["components"]["schemas"]
        schemas["Lift"]["properties"]["how_far"] = {"type": "number", "minimum": 0, "maximum": 2, "default": 1, "description": "Sizes"}
        schemas["Lower"] = {"type": "object", "properties": {"op": {"const": "lower"}}, "required": ["op"], "description": "Lowers"}
        schemas["Command"]["discriminator"]["mapping"]["lower"] = "#/components/schemas/Lower"
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "c.json").write_text(json.dumps(contract))
            run(sys.executable, SOURCE / "generate.py", f"{folder}/c.json", folder)
            text = pathlib.Path(folder, "commands.py").read_text()
        self.assertIn("how_far: Optional[float] = None,", text)
        self.assertIn("how_far: Sizes. 0 to 2. Default 1.", text)
        self.assertIn('"""Lowers."""', text)


class Typing(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cache = cls.enterClassContext(tempfile.TemporaryDirectory())

    def mypy(self, *arguments, **more):
        """The exit code and the lines of mypy for the oldest Python; skips without it, but fails in CI."""
        command = [sys.executable, "-m", "mypy", "--strict", "--python-version", "3.9", "--cache-dir", self.cache, *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300, **more)
        if "No module named mypy" in done.stderr:
            if os.environ.get("CI") == "true":
                raise AssertionError("mypy is missing")
            self.skipTest("mypy is missing")
        return done.returncode, done.stdout + done.stderr

    def test_mypy_strict(self):
        code, printed = self.mypy(SOURCE / "pelage", cwd=SOURCE)
        self.assertEqual(code, 0, printed)

    def test_wrong_programs_are_found(self):
        right = "import pelage\nscene = pelage.Server().open('fox')\nscene.length(flood=True, value=0.1)\n" \
                "scene.comb(stroke=pelage.stroke([[0, 0, 0]]), brush={'radius': 0.1, 'falloff': 'smooth'})\n" \
                "frame = scene.frame(camera='front', quality={'scale': 0.5})\nprint(frame.bytes[:3], scene.settings()['coats'])\n"
        wrong = ("scene.length(valu=0.1)", "scene.length(value='0.1')", "scene.comb(brush={'radus': 0.1})", "scene.part()",
                 "scene.frame(camera='font')", "scene.set_lights(lights=[{'kind': 'lantern'}])", "scene.info()['nam']",
                 "scene.comb(brush={'falloff': 'soft'})", "scene.load('fox.obj', up='w')")
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder, "program.py")
            program.write_text(right + "".join(f"{line}\n" for line in wrong))
            code, printed = self.mypy(program, env={**os.environ, "MYPYPATH": str(SOURCE)})
        lines = {int(number) for number in re.findall(r"program.py:(\d+): error", printed)}
        first = right.count("\n") + 1
        self.assertEqual((code, lines), (1, set(range(first, first + len(wrong)))), printed)

    def test_syntax_of_python_3_9(self):
        for file in (*(SOURCE / "pelage").rglob("*.py"), *SOURCE.glob("*.py"), *(SOURCE / "generator").glob("*.py")):
            ast.parse(file.read_text(), feature_version=(3, 9))


class Words(unittest.TestCase):
    def test_everything_public_is_documented(self):
        page = (REPOSITORY / "docs" / "python.md").read_text()
        for name in pelage.__all__:
            one = getattr(pelage, name)
            self.assertTrue(name == "News" or one.__doc__, name)
            self.assertIn(name, page)
        for kind in (pelage.Server, pelage.Scene, pelage.Frame):
            for name, method in methods(kind).items():
                if name in methods(Commands):
                    continue  # docs/grooming.md has their pages
                self.assertTrue(method.__doc__, f"{kind.__name__}.{name}")
                self.assertTrue(re.search(rf"`[^`\n]*\b{name}\b[^`\n]*`", page), f"{kind.__name__}.{name} is not in docs/python.md")

    def test_examples_print_what_they_say(self):
        for page in (SOURCE / "README.md", REPOSITORY / "docs" / "python.md"):
            text = page.read_text()
            for program, printed in re.findall(r"```python\n(.*?)```\n+prints\n+```text\n(.*?)```", text, re.S):
                with self.subTest(page.name), tempfile.TemporaryDirectory() as folder:
                    environment = {**os.environ, "PELAGE_SERVER_PROGRAM": str(BIN / "pelaged"), "PYTHONPATH": str(SOURCE)}
                    small = program.replace('"triangles": 5000', '"triangles": 500')  # prints the same, sooner
                    self.assertEqual(run(sys.executable, "-c", small, cwd=folder, env=environment), printed)
            self.assertIn("```text", text, "an example that prints something")


class Installing(unittest.TestCase):
    """Into an empty environment, without a registry, as docs/python.md says it."""

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        environment = self.folder / "environment"
        run(sys.executable, "-m", "venv", "--without-pip", environment)
        self.python = environment / "bin" / "python"

    def pip(self, *arguments):
        return run(sys.executable, "-m", "pip", "--no-input", "--disable-pip-version-check", *arguments, cwd=REPOSITORY,
                   env={**os.environ, "PIP_NO_INDEX": "1", "PIP_ROOT_USER_ACTION": "ignore", "PYTHONDONTWRITEBYTECODE": "1"})

    def assert_it_works(self):
        program = (f"import pelage, sys\nassert {str(self.folder)!r} in pelage.__file__, pelage.__file__\n"
                   "try:\n    import numpy\n    sys.exit('NumPy is here')\nexcept ImportError:\n    pass\n"
                   "with pelage.local() as server:\n    scene = server.create(model={'builtin': 'plane', 'triangles': 2})\n"
                   "    frame = scene.frame(width=32, height=32, quality='draft')\n"
                   "assert frame.bytes.startswith(b'\\x89PNG')\n"
                   "try:\n    frame.array()\nexcept pelage.PelageError as error:\n    print(error)\n"
                   "try:\n    pelage.arrays.encoded([1])\nexcept pelage.PelageError as error:\n    print(error)\n")
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        environment["PELAGE_SERVER_PROGRAM"] = str(BIN / "pelaged")
        printed = run(self.python, "-c", program, cwd=self.folder, env=environment)
        self.assertRegex(printed, "png has no array; .*npy.*\nArrays need NumPy: pip install numpy")

    def test_a_wheel(self):
        self.assertIn("pip wheel --no-deps clients/python ", (REPOSITORY / "docs" / "python.md").read_text())
        self.pip("wheel", "--no-deps", "-w", self.folder, "clients/python")
        wheel = self.folder / f"pelage-{pelage.__version__}-py3-none-any.whl"
        self.pip("--python", self.python, "install", "--no-deps", wheel)
        self.assert_it_works()
        installed = run(self.python, "-c", "import pelage, os; print(*sorted(os.listdir(os.path.dirname(pelage.__file__))))").split()
        self.assertEqual(set(installed) - {"__pycache__"}, {path.name for path in (SOURCE / "pelage").iterdir()} - {"__pycache__"})
        self.assertIn("py.typed", installed)

    def test_a_checkout(self):
        for page in (SOURCE / "README.md", REPOSITORY / "docs" / "python.md"):
            self.assertIn("    pip install clients/python\n", re.sub(" +#.*", "", page.read_text()))
        before = sorted(SOURCE.rglob("*"))
        self.pip("--python", self.python, "install", "clients/python")
        self.assert_it_works()
        self.assertEqual(sorted(SOURCE.rglob("*")), before, "it leaves nothing beside the sources")

    def test_a_checkout_that_is_edited(self):
        self.pip("--python", self.python, "install", "--editable", "clients/python")
        self.assertEqual(run(self.python, "-c", "import pelage; print(pelage.__file__)", cwd=self.folder).strip(),
                         str(SOURCE / "pelage" / "__init__.py"))

    def test_a_source_archive_makes_the_same_wheel(self):
        archive = wheel_backend.build_sdist(self.folder)
        self.pip("wheel", "--no-deps", "-w", self.folder / "second", self.folder / archive)
        wheel = wheel_backend.build_wheel(self.folder)
        self.assertEqual((self.folder / "second" / wheel).read_bytes(), (self.folder / wheel).read_bytes())
