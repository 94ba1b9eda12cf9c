"""A walk through the command-line client."""

import json
import unittest

from PIL import Image

from support.server import ServedTest, comb, flood, shared_folder


class Client(ServedTest):
    def new(self, *arguments):
        return self.pelage("new", *arguments).stdout.strip()

    def file(self, name, text):
        path = self.server.folder / name
        path.write_text(text)
        return path

    def test_from_new_to_rm(self):
        scene = self.new("--name", "walk", "--builtin", "creature", "--triangles", 3000)
        self.assertIn("walk", self.pelage("list").stdout)
        self.assertIn("revision    0", self.pelage("info", scene).stdout)

        steps = self.file("groom.jsonl", "\n".join(json.dumps(c) for c in (
            comb([0, 0.3, 0.4], [0, 0.3, -0.4], radius=0.3), {"op": "blow", "source": [0, 1, 1]},
            {"op": "attract", "point": [0, 0.5, 0.5], "radius": 0.4})))
        self.assertIn("revision 3", self.pelage("run", scene, steps).stdout)

        picture = self.server.folder / "out.png"
        self.pelage("frame", "walk", "-o", picture, "--camera", "left", "--width", 96, "--height", 64, "--quality", "draft",
                    "--background", "transparent", "--exposure", 0.5)
        with Image.open(picture) as image:
            self.assertEqual((image.size, image.mode), ((96, 64), "RGBA"))

        self.assertIn("position", self.pelage("pick", scene, 256, 256).stdout)
        self.assertIn("nothing there", self.pelage("pick", scene, 0, 0).stdout)
        self.assertIn("revision 4", self.pelage("undo", scene, 2).stdout)
        self.assertIn("revision 5", self.pelage("redo", scene).stdout)
        self.assertIn("revision 6", self.pelage("revert", scene, 0).stdout)
        self.assertEqual(len(self.pelage("log", scene).stdout.splitlines()), 6)
        self.assertEqual(self.pelage("log", scene, "--lines").stdout, "")
        self.pelage("rm", scene)
        self.assertIn("There is no scene", self.pelage("info", scene, code=3).stderr)

    def test_a_scene_from_a_file_is_whole_or_not_there(self):
        self.assertRegex(self.pelage("--version").stdout, r"^pelage \d+\.\d+\.\d+$")
        self.pelage("wait", "--seconds", 20)
        model = self.file("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        scene = self.new("--name", "square", "--file", model)
        self.assertIn("triangles   2", self.pelage("info", scene).stdout)
        before = self.pelage("list").stdout
        self.pelage("new", "--file", self.file("bad.obj", "f 1 2 3\n"), code=3)
        self.assertEqual(self.pelage("list").stdout, before)

    def test_places_and_steps_are_said_in_the_words_of_recipes(self):
        scene = self.new("--builtin", "sphere")
        self.assertRegex(self.pelage("pick", scene, 256, 256, "--camera", "front").stdout, r'in a recipe \{"at": \[0\.5\d\d, 0\.5\d\d, 1\.0')
        far = self.pelage("run", scene, "-", text=json.dumps(comb([9, 9, 9], [9, 9, 8], radius=0.1))).stdout
        self.assertIn("warning: it changed nothing", far)
        near = self.pelage("run", scene, "-", text=json.dumps(flood([0, 1, 0], lean=0.9))).stdout
        self.assertNotIn("warning", near)
        self.assertRegex(self.pelage("log", scene).stdout, r"comb everywhere, \d+ vertices")

    def test_json_answers(self):
        scene = json.loads(self.pelage("--json", "new", "--builtin", "torus").stdout)["id"]
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 0)
        run = self.pelage("run", scene, "-", "--json", text=json.dumps(flood([0, 1, 0], lean=0.9)))
        self.assertEqual(json.loads(run.stdout)["revision"], 1)
        self.assertEqual(len(json.loads(self.pelage("log", scene, "--json").stdout)["entries"]), 1)
        self.assertIn("scenes", json.loads(self.pelage("list", "--json").stdout))
        frame = json.loads(self.pelage("frame", scene, "-o", self.server.folder / "j.png", "--json").stdout)
        self.assertEqual(frame["revision"], 1)
        self.assertIn("shells", frame["quality"])
        self.assertIn("hit", json.loads(self.pelage("pick", scene, 1, 1, "--json").stdout))

    def test_every_form_of_a_file(self):
        scene = self.new("--builtin", "sphere")
        one, two = flood([0, 1, 0], lean=0.9), flood([1, 0, 0], lean=0.8)
        self.pelage("run", scene, self.file("one.json", json.dumps(one, indent=2)))
        self.pelage("run", scene, self.file("array.json", json.dumps([one, two], indent=2)))
        self.pelage("run", scene, self.file("batch.json", json.dumps({"commands": [two, one]})))
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 4)

    def test_a_bad_step_stops_the_run_before_it_begins(self):
        scene = self.new("--builtin", "sphere")
        steps = self.file("bad.jsonl", json.dumps(flood([0, 1, 0], lean=0.9)) + "\n" + '{"op": "comb", "flod": true}\n')
        run = self.pelage("run", scene, steps, code=3)
        for word in ("step 2 of 2", "bad.jsonl", "/stroke", "next:"):
            self.assertIn(word, run.stderr)
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 0)

    def test_errors_help(self):
        scene = self.new("--builtin", "sphere")
        misspelt = {**flood([0, 1, 0]), "brush": {"raduis": 1}}
        run = self.pelage("run", scene, "-", code=3, text=json.dumps(misspelt))
        for word in ("/brush/raduis", "nearest: radius", "next:"):
            self.assertIn(word, run.stderr)
        run = self.pelage("frame", scene, "--width", 0, code=3)
        self.assertIn("[1, 8192]", run.stderr)
        self.assertIn("nearest: torus", self.pelage("new", "--builtin", "torsu", code=3).stderr)
        self.assertIn("Line 2", self.pelage("run", scene, "-", code=3, text='{"op": "comb"}\n{\n').stderr)
        self.assertIn("Cannot read", self.pelage("run", scene, "/nonexistent", code=3).stderr)
        self.assertIn("Cannot read", self.pelage("run", scene, "/", code=3).stderr)
        self.assertIn("Cannot write", self.pelage("frame", scene, "-o", "/nonexistent/x.png", code=1).stderr)
        late = self.pelage("run", scene, "-", "--if-match", 7, code=3, text=json.dumps(flood([0, 1, 0])))
        self.assertIn("revision", late.stderr)

    def test_help_says_the_default_of_form(self):
        for action in ("new", "load"):
            words = " ".join(self.pelage(action, "--help").stdout.split())
            self.assertIn("[animal for files, even for built-in models]", words)

    def test_exit_codes(self):
        self.pelage("--help")
        self.pelage(code=2)
        self.pelage("nonsense", code=2)
        self.pelage("frame", code=2)
        self.pelage("list", "--server", "ftp://x", code=2)
        gone = self.pelage("list", "--server", "http://127.0.0.1:1", code=1)
        self.assertIn("PELAGE_SERVER", gone.stderr)
        self.assertIn("http://127.0.0.1:1", gone.stderr)

    def test_dry_runs(self):
        scene = self.new("--builtin", "sphere")
        self.pelage("run", scene, "-", "--dry-run", text=json.dumps(flood([0, 1, 0], lean=0.9)))
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 0)

    def test_long_runs_show_progress(self):
        scene = self.new("--builtin", "plane", "--triangles", 100)
        steps = [flood([1, 0, k / 10], lean=0.5) for k in range(30)]
        run = self.pelage("run", scene, "-", text="\n".join(map(json.dumps, steps)))
        self.assertIn("step 30 of 30", run.stderr)
        self.assertIn("30 steps", run.stdout)

    def test_load(self):
        scene = self.new("--builtin", "plane", "--triangles", 2)
        cube = "\n".join(f"v {x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)) + """
f 1 2 4 3
f 5 7 8 6
f 1 5 6 2
f 3 4 8 7
f 1 3 7 5
f 2 6 8 4
"""
        self.assertIn("triangles   12", self.pelage("load", scene, self.file("cube.OBJ", cube)).stdout)
        self.assertIn("nearest", self.pelage("load", scene, self.file("cube.objj", cube), code=3).stderr)
        self.pelage("load", scene, "-", "--format", "obj", text="v 0 0 0\n", code=3)
        self.assertIn("up z, front -y", self.pelage("load", scene, self.file("c.obj", cube), "--up", "z").stdout)
        self.assertIn("/front", self.pelage("load", scene, self.file("c.obj", cube), "--up", "z", "--front", "-z", code=3).stderr)
        self.assertIn("part 9", self.pelage("load", scene, self.file("c.obj", cube), "--flip", 9, code=3).stderr)
        self.file("fox.mtl", "newmtl red\nKd 1 0 0\n")
        with_material = self.pelage("load", scene, self.file("c.obj", "mtllib fox.mtl\nmtllib gone.mtl\nusemtl red\n" + cube)).stdout
        self.assertIn("missing_material_files: 1 (gone.mtl)", with_material)
        self.assertNotIn("missing_materials", with_material)
        self.assertIn("put fox.bin beside", self.pelage("load", scene, self.file(
            "c.gltf", '{"asset": {"version": "2.0"}, "buffers": [{"uri": "fox.bin"}]}'), code=3).stderr)

    def test_what_a_frame_takes_is_known_before(self):
        scene = self.new("--builtin", "sphere", "--triangles", 500)
        self.assertRegex(self.pelage("frame", scene, "--dry-run").stdout, r"^about [0-9.e-]+ s, up to ")
        picture = self.file("none.png", "")
        refused = self.pelage("frame", scene, "-o", picture, "--width", 8000, "--height", 8000, "--knob", "shells=64", "--knob",
                              "steps=16", "--max-seconds", 1, code=3).stderr
        self.assertIn("/max_seconds", refused)
        self.assertIn("--max-seconds", refused)

    def test_a_real_model(self):
        fox = shared_folder() / "meshes" / "Fox.glb"
        scene = self.new("--builtin", "plane", "--triangles", 2)
        self.assertIn("triangles   576", self.pelage("load", scene, fox).stdout)
        posed = self.pelage("load", scene, fox, "--pose", "Run@0.3").stdout
        self.assertIn("pose        Run@0.3", posed)
        self.assertIn("animations  Survey, Walk, Run", posed)
        self.assertIn("--pose", self.pelage("load", scene, fox, "--pose", "Fly", code=3).stderr)


if __name__ == "__main__":
    unittest.main()
