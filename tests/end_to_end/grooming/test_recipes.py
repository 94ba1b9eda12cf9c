"""Recipes through the client: what they fill in, what they refuse, and the grooms that come with it."""

import json

from support.nightly import nightly
from support.server import REPOSITORY, ServedTest, shared_folder

RECIPES = REPOSITORY / "clients" / "recipes"
EXAMPLES = REPOSITORY / "docs" / "tools" / "examples"


class Recipes(ServedTest):
    def new(self, *arguments):
        return self.pelage("new", *arguments).stdout.strip()

    def revision(self, scene):
        return json.loads(self.pelage("info", scene, "--json").stdout)["revision"]

    def file(self, name, tree):
        path = self.server.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(tree if isinstance(tree, str) else json.dumps(tree, indent=2))
        return path

    def test_variables_includes_and_places(self):
        scene = self.new("--builtin", "sphere", "--triangles", 2000)
        self.file("parts/dab.json", {"variables": {"place": [0.5, 1, 0.5], "value": 0.1}, "steps": [
            {"op": "length", "value": "${value}", "brush": {"radius": 0.2, "strength": 1, "falloff": "constant"},
             "stroke": {"samples": [{"position": {"at": "${place}"}}]}}]})
        recipe = self.file("main.json", {"variables": {"value": 0.2}, "include": ["parts/dab.json"], "steps": [
            {"comment": "on top and below"}, {"use": "dab", "with": {"value": "${value}"}},
            {"use": "dab", "with": {"value": 0.3, "place": [0.5, 0, 0.5]}}]})
        self.assertIn("revision 2", self.pelage("run", scene, recipe, "--set", "value=0.25").stdout)
        low, high = (json.loads(self.pelage("info", scene, "--json").stdout)["bounds"][k] for k in ("min", "max"))
        self.assertAlmostEqual(self.length_at(scene, [0, 4 * high[1], 0.001]), 0.25, places=5)
        self.assertAlmostEqual(self.length_at(scene, [0, 4 * low[1], 0.001]), 0.3, places=5)

    def picked(self, scene, eye, target=(0, 0, 0), up=(0, 1, 0)):
        view = {"camera": {"position": list(eye), "target": list(target), "up": list(up)}, "width": 64, "height": 64}
        answer = self.server.post(f"/v1/scenes/{scene}/pick", {"view": view, "pixel": [32, 32], "reach": "skin"})
        self.assertTrue(answer.status == 200 and answer.json["hit"], answer)
        return answer.json

    def length_at(self, scene, eye):
        return self.picked(scene, eye)["length"]

    def test_refusals_name_the_file_and_the_position(self):
        scene = self.new("--builtin", "sphere")
        self.file("ear.json", {"variables": {"size": 0.1}, "steps": [{"op": "lift", "flood": True, "brush": {"raduis": "${size}"}}]})
        recipe = self.file("head.json", {"include": ["ear.json"], "steps": [{"use": "ear"}]})
        run = self.pelage("run", scene, recipe, code=3)
        for word in ("/steps/0/brush/raduis", "nearest: radius", "ear.json", "next:"):
            self.assertIn(word, run.stderr)
        for tree, words in (({"steps": [{"op": "comb", "lean": "${laen}"}], "variables": {"lean": 1}}, ("/steps/0/lean", "nearest: lean")),
                            ({"include": ["self.json"], "steps": []}, ("circle", "self.json -> ", "/include/0")),
                            ({"include": ["gone.json"], "steps": []}, ("Cannot read", "gone.json", "/include/0")),
                            ('{"steps": [\n  {"op" "lift"}\n]}', ("line 2",))):
            run = self.pelage("run", scene, self.file("self.json", tree), code=3)
            for word in words:
                self.assertIn(word, run.stderr)
        self.assertIn("no recipe", self.pelage("run", scene, "-", "--set", "a=1", code=3, text='{"op": "mask"}').stderr)
        self.assertIn("nearest: fur", self.pelage("run", scene, RECIPES / "creature.json", "--set", "furr=1", code=3).stderr)
        self.assertEqual(self.revision(scene), 0)

    def test_a_server_refusal_points_into_the_recipe(self):
        scene = self.new("--builtin", "sphere")
        recipe = self.file("far.json", {"steps": [{"comment": "none"}, {"op": "attract", "point": {"at": [1e9, 0, 0]}}]})
        run = self.pelage("run", scene, recipe, code=3)
        for word in ("/steps/1/point", "far.json", "sizes"):
            self.assertIn(word, run.stderr)

    @nightly
    def test_a_dry_run_says_what_each_tool_of_the_pages_would_touch(self):
        names = sorted(path.stem for path in EXAMPLES.glob("*.json") if path.stem not in ("studio", "checkpoint", "retarget", "map"))  # these need more than a model
        self.assertGreaterEqual(len(names), 20)
        for name in names:
            scene = self.new("--builtin", "creature", "--triangles", 4000)
            path = EXAMPLES / f"{name}.json"
            tried = json.loads(self.pelage("run", scene, path, "--dry-run", "--json").stdout)["results"]
            self.assertEqual(self.revision(scene), 0, name)
            lines = self.pelage("run", scene, path, "--json").stdout.splitlines()
            done = [result for line in lines for result in json.loads(line)["results"]]
            for result in [*tried, *done]:
                del result["milliseconds"]
            self.assertEqual(tried, done, name)
            last = json.loads(lines[-1])["results"]
            self.assertGreater(max(result["touched"] for result in last), 50, name)
            self.assertTrue(any(result["fields"] for result in last), name)

    def test_a_dry_run_judges_each_step_after_those_before_it(self):
        scene = self.new("--builtin", "sphere", "--triangles", 500)
        recipe = self.file("twice.json", {"steps": 2 * [{"op": "length", "flood": True, "value": 0.2, "brush": {"strength": 1}}]})
        run = self.pelage("run", scene, recipe, "--dry-run").stdout
        self.assertIn("length: touched 0", run)
        self.assertNotIn("length: touched 0", run.split("step 2")[0])
        self.assertIn("nothing is changed, revision 0", run)

    def test_what_a_pick_finds_is_where_later_steps_work(self):
        scene = self.new("--builtin", "sphere", "--triangles", 2000)
        low, high = (json.loads(self.pelage("info", scene, "--json").stdout)["bounds"][k] for k in ("min", "max"))
        recipe = self.file("top.json", {"steps": [
            {"pick": {"farthest": {"direction": [0, 1, 0]}}, "as": "top"},
            {"pick": {"ray": {"origin": {"at": [0.5, -1, 0.5]}, "direction": [0, 1, 0]}}, "as": "below"},
            {"for": {"place": ["${top}", "${below}"], "value": ["${top.length * 2}", 0.2]}, "steps": [
                {"op": "length", "value": "${value}", "brush": {"radius": 0.2, "strength": 1, "falloff": "constant"},
                 "stroke": {"samples": [{"position": {"at": "${place}"}}]}, "assert": {"min_vertices": 5}}]}]})
        self.assertIn("touched", self.pelage("run", scene, recipe, "--dry-run").stdout)
        self.assertEqual(self.revision(scene), 0)
        self.assertIn("2 steps", self.pelage("run", scene, recipe).stdout)
        self.assertAlmostEqual(self.length_at(scene, [0, 4 * high[1], 0.001]), 0.06, places=5)
        self.assertAlmostEqual(self.length_at(scene, [0, 4 * low[1], 0.001]), 0.2, places=5)
        log = self.pelage("log", scene, "--lines").stdout
        self.assertNotIn("pick", log)
        again = self.new("--builtin", "sphere", "--triangles", 2000)
        self.pelage("run", again, "-", text=log)
        self.assertEqual(*(json.loads(self.pelage("info", each, "--json").stdout)["fields_hash"] for each in (scene, again)))

    def test_the_recipe_of_the_page_that_finds_the_ears(self):
        page = (REPOSITORY / "docs" / "recipes.md").read_text()
        recipe = self.file("ears.json", page.split("```json")[2].split("```")[0])
        scene = self.new("--builtin", "creature", "--triangles", 20000)
        run = self.pelage("run", scene, recipe).stdout
        self.assertRegex(run, r"^2 steps, \d+ vertices touched, \d")
        self.assertNotIn("warning", run)
        lines = [json.loads(line) for line in self.pelage("log", scene, "--lines").stdout.splitlines()]
        left, right = (line["stroke"]["samples"][0]["position"] for line in lines)
        for a, b, sign in zip(left, right, (-1, 1, 1)):
            self.assertAlmostEqual(a, sign * b, delta=0.02)
        self.assertGreater(left[0], 0.02)

    def test_a_pick_that_finds_nothing_stops_the_run_before_it_begins(self):
        scene = self.new("--builtin", "sphere")
        recipe = self.file("miss.json", {"steps": [
            {"op": "length", "flood": True, "value": 0.1},
            {"pick": {"ray": {"origin": [0, 9, 0], "direction": [0, 1, 0]}}, "as": "sky"}]})
        refused = self.pelage("run", scene, recipe, code=3).stderr
        for word in ("finds nothing", "miss.json", "/steps/1/pick"):
            self.assertIn(word, refused)
        self.assertEqual(self.revision(scene), 0)

    def test_an_assert_says_what_was_touched(self):
        scene = self.new("--builtin", "sphere", "--triangles", 2000)
        dab = {"op": "length", "value": 0.2, "brush": {"radius": 0.1}, "stroke": {"samples": [{"position": {"at": [0.5, 1, 0.5]}}]}}
        far = {**dab, "stroke": {"samples": [{"position": {"at": [9, 9, 9]}}]}, "assert": {"min_vertices": 1}}
        recipe = self.file("far.json", {"steps": [{"commands": [{**dab, "assert": {"max_vertices": 100000}}, dab]}, far, dab]})
        for line in ((), ("--dry-run",)):
            refused = self.pelage("run", scene, recipe, *line, code=3).stderr
            for word in ("length touched 0 vertices", "step 2 of 3", "far.json", "/steps/1/assert", "1 or more"):
                self.assertIn(word, refused)
            self.assertEqual(self.revision(scene), 0 if line else 1)
            scene = self.new("--builtin", "sphere", "--triangles", 2000)

    def test_places_are_picked_stored_and_used(self):
        scene = self.new("--builtin", "sphere", "--triangles", 2000)
        places = self.server.folder / "sphere.places.json"
        printed = self.pelage("pick", scene, "--farthest", "0,1,0", "--box", "0,0.5,0,1,1,1", "--as", "crown", "--places", places).stdout
        self.assertIn('"as": "crown"', printed)
        self.pelage("pick", scene, "--nearest", "0.5,-3,0.5", "--as", "base", "--places", places)
        stored = json.loads(places.read_text())
        for name, y in (("base", 0), ("crown", 1)):
            self.assertTrue(all(abs(a - b) < 0.02 for a, b in zip(stored[name], [0.5, y, 0.5])), stored)
        step = json.loads(printed.split("a step")[1])
        recipe = self.file("crown.json", {"variables": {"base": [0.5, 1, 0.5]}, "steps": [step, {
            "op": "length", "value": 0.2, "brush": {"radius": 0.1, "strength": 1, "falloff": "constant"},
            "stroke": {"samples": [{"position": {"at": "${base}"}}]}}]})
        self.pelage("run", scene, recipe, "--places", places)
        low = json.loads(self.pelage("info", scene, "--json").stdout)["bounds"]["min"]
        self.assertAlmostEqual(self.length_at(scene, [0, 4 * low[1], 0.001]), 0.2, places=5)

    def test_a_places_file_holds_sizes_too(self):
        scene = self.new("--builtin", "sphere", "--triangles", 2000)
        places = self.file("sizes.json", {"tall": 0.3})
        recipe = self.file("tall.json", {"variables": {"tall": 0.1}, "steps": [
            {"op": "length", "value": "${tall}", "flood": True, "brush": {"strength": 1}}]})
        self.pelage("run", scene, recipe, "--places", places)
        self.assertAlmostEqual(self.length_at(scene, [0, 9, 0.001]), 0.3, places=5)
        self.assertIn("broken.json", self.pelage("run", scene, recipe, "--places", self.file("broken.json", "{"), code=3).stderr)
        wrong = self.file("wrong.json", {"tall": [1, 2]})
        refused = self.pelage("run", scene, recipe, "--places", wrong, code=3).stderr
        self.assertIn("wrong.json", refused)
        self.assertIn("/tall", refused)

    def test_one_recipe_makes_a_siamese_of_a_cat_and_a_koala(self):
        folder = RECIPES / "siamese"
        for name, file, front in (("cat", "cat.obj", "-x"), ("koala", "koala_low.obj", "z")):
            scene = self.new("--file", shared_folder() / "meshes" / file, f"--front={front}")
            self.pelage("subdivide", scene)
            self.pelage("run", scene, folder / "siamese.json", "--places", folder / f"{name}.places.json")
            self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["undo_steps"], 22, name)

    def test_each_kind_of_pick(self):
        scene = self.new("--builtin", "sphere", "--triangles", 2000)
        world = json.loads(self.pelage("pick", scene, "--ray", "0,9,0,0,-1,0", "--world", "--json").stdout)
        shares = json.loads(self.pelage("pick", scene, "--ray=0.5,5,0.5,0,-1,0", "--json").stdout)
        self.assertTrue(all(abs(a - b) < 1e-6 for a, b in zip(world["position"], shares["position"])))
        for line, words in ((("--ray", "1,2"), "flag:    --ray"), (("--farthest", "0,0,0"), "flag:    --"),
                            (("--farthest", "0,1,0", "--box", "1,1,1,0,0,0"), "flag:    --box"), (("--nearest", "a,b,c"), "flag:    --nearest")):
            self.assertIn(words, self.pelage("pick", scene, *line, code=3).stderr)
        for line in ((), (5,), (5, 5, "--nearest", "0,0,0"), ("--box", "0,0,0,1,1,1"), (5, 5, "--places", "p.json")):
            self.pelage("pick", scene, *line, code=2)

    def check_groom(self, scene, name):
        """Short in the face, long on the chest, back combed to the tail and parted; wet and spotted somewhere."""
        info = json.loads(self.pelage("info", scene, "--json").stdout)
        low, high, size = info["bounds"]["min"], info["bounds"]["max"], info["size"]
        marks = json.loads((RECIPES / f"{name}.json").read_text())["steps"][0]["with"]

        def place(mark, by=(0, 0, 0)):
            return [l + (s + b) * (h - l) for s, b, l, h in zip(marks[mark], by, low, high)]

        def seen(mark, axis, by=(0, 0, 0), side=1):
            target = place(mark, by)
            eye = [t + (side * size if k == axis else 0) for k, t in enumerate(target)]
            return self.picked(scene, eye, target, (0, 0, -1) if axis == 1 else (0, 1, 0))

        lines = self.pelage("run", scene, RECIPES / f"{name}.json", "--json").stdout.splitlines()
        results = [result for line in lines for result in json.loads(line)["results"]]
        self.assertLessEqual(len(results), 60)
        changed = {field["field"] for result in results for field in result["fields"]}
        self.assertLessEqual({"wetness", "tip_colour", "root_colour", "clump", "curl", "mask", "stretch"}, changed)
        fur = 0.022  # of the body
        self.assertLess(seen("nose", 2)["length"], 0.6 * fur)
        self.assertGreater(seen("chest", 2)["length"], 1.8 * fur)
        middle = [(a + b) / 2 - r for a, b, r in zip(marks["withers"], marks["rump"], marks["rump"])]
        left, right = (seen("rump", 1, [side, *middle[1:]])["direction"] for side in (0.08, -0.08))
        self.assertGreater(left[0], 0.3)  # away from the parting, on both sides
        self.assertLess(right[0], -0.3)
        self.assertLess(seen("belly", 0, (0, 0.2, 0), side=-1)["direction"][2], -0.5)  # to the tail
        for result in results:
            if result["op"] == "paint":
                self.assertGreater(result["touched"], 0, results.index(result))

    def test_the_groom_of_the_creature(self):
        self.check_groom(self.new("--builtin", "creature", "--triangles", 20000), "creature")

    @nightly
    def test_the_groom_of_the_koala_and_on_another_model(self):
        meshes = shared_folder() / "meshes"
        for name, path, front in (("koala", meshes / "koala.ply", "z"), ("spot", meshes / "spot.obj", "-z")):
            scene = self.new("--builtin", "plane", "--triangles", 2)
            self.pelage("load", scene, path, f"--front={front}")
            self.check_groom(scene, name)

    def test_the_server_fills_in_what_every_client_sends(self):
        scene = self.server.new_scene("sphere", 2000)
        ear = {"variables": {"place": [0, 0, 0]}, "steps": [
            {"op": "length", "value": 0.2, "brush": {"radius": 0.1}, "stroke": {"samples": [{"position": {"at": "${place}"}}]}, "assert": {"min_vertices": 2}}]}
        body = {"file": "grooms/main.json", "files": {"grooms/parts/ear.json": ear}, "variables": {"up": [0, 2, 0]}, "recipe": {
            "variables": {"up": [1, 0, 0]}, "include": ["parts/ear.json"], "steps": [
                {"pick": {"farthest": {"direction": "${up}"}}, "as": "top"}, {"use": "ear", "with": {"place": "${top}"}}]}}
        filled = scene.post("recipe", body)
        self.assertEqual((filled.status, filled.json["revision"], scene.info()["revision"]), (200, 0, 0))
        (step,) = filled.json["steps"]
        self.assertEqual((step["file"], step["pointer"], step["asserts"]),
                         ("grooms/parts/ear.json", "/files/grooms~1parts~1ear.json/steps/0", [{"command": 0, "min_vertices": 2}]))
        (x, y, z) = step["commands"][0]["stroke"]["samples"][0]["position"]
        self.assertAlmostEqual(y, scene.info()["bounds"]["max"][1], places=6)
        self.assertGreater(scene.post("commands", {"commands": step["commands"]}).json["results"][0]["touched"], 2)
        for change, pointer in (({"variables": {"upp": 1}}, "/variables/upp"), ({"places": {"nose": [1, 2]}}, "/places/nose"), ({"files": {}}, "/recipe/include/0"),
                                ({"files": {"grooms/parts/ear.json": {"steps": [{"op": "comb", "leen": 1}]}}}, "/recipe/steps/1/with/place"),
                                ({"recipe": {"steps": [{"op": "lift", "flood": 1}]}, "variables": {}}, "/recipe/steps/0/flood")):
            refused = scene.post("recipe", {**body, **change})
            self.assertEqual((refused.status, refused.json["pointer"]), (422, pointer), refused)
        self.assertEqual(scene.post("recipe", {"recipe": {"description": "a" * (8 << 20), "steps": []}}).status, 413)
        self.assertEqual(scene.info()["revision"], 1)

    def test_a_recipe_replays_to_the_bit(self):
        hashes = []
        for _ in range(2):
            scene = self.new("--builtin", "creature", "--triangles", 3000)
            self.pelage("run", scene, RECIPES / "creature.json")
            hashes.append(json.loads(self.pelage("info", scene, "--json").stdout)["fields_hash"])
        self.assertEqual(hashes[0], hashes[1])
