"""Finer triangles, and grooms of one scene on another, over HTTP and with the client."""

import json
import tempfile
import unittest
from pathlib import Path

from support.nightly import nightly
from support.server import REPOSITORY, ServedTest, comb, flood


class Retarget(ServedTest):
    def flip(self, one, other):
        with tempfile.TemporaryDirectory() as folder:
            a, b = Path(folder) / "a.png", Path(folder) / "b.png"
            a.write_bytes(one), b.write_bytes(other)
            return json.loads(self.pelage("compare", a, b, "--json").stdout)["flip"]["mean"]

    def picture(self, scene, **quality):
        return scene.frame(width=256, height=256, camera={"auto": "three_quarter"}, background="transparent", **quality).body

    @nightly
    def test_no_root_moves(self):
        # On a plane hardly more than rounding differs. On a body the new vertices have unit normals, where they were
        # interpolated before, which silhouettes show. Other roots differ by more. All strands are compared, because
        # a frame with fewer strands selects them by how the surface is divided.
        traced = {"quality": {"method": "strands", "trace": {"passes": 16}}}
        for builtin, maximum in (("plane", 0.005), ("creature", 0.065)):
            scene = self.server.new_scene(builtin, 5000)
            before = self.picture(scene, **traced)
            self.assertEqual(scene.post("subdivide", {}).status, 200)
            after = self.picture(scene, **traced)
            scene.run({"op": "set_coat", "coat": {"seed": 2}})
            self.assertLess(self.flip(before, after), maximum, builtin)
            self.assertGreater(self.flip(before, self.picture(scene, **traced)), 0.04, builtin)

    def test_subdividing_survives_a_restart(self):
        scene = self.server.new_scene("sphere", 2000)
        scene.run(comb([-0.5, 0, 0.8], [0.5, 0, 0.8], radius=0.2))
        scene.run({"op": "set_coat", "coat": {"count": 500, "seed": 5}})
        before = scene.info()
        printed = self.pelage("subdivide", scene.id).stdout
        self.assertIn(f"triangles   {4 * before['triangles']}", printed)
        finer = scene.info()
        self.assertEqual((finer["revision"], finer["undo_steps"]), (before["revision"] + 1, 0))
        self.assert_problem(scene.post("undo", {}), 422, "/steps")
        scene.run(flood([0, -1, 0], lean=0.3))
        groomed, picture = scene.info(), self.picture(scene)
        self.server.terminate()
        self.server.start()
        self.assertEqual(scene.info(), groomed)
        self.assertEqual(self.picture(scene), picture)

    def test_masked_subdivision_and_refusals(self):
        scene = self.server.new_scene("sphere", 2000)
        scene.run({"op": "mask", "sphere": {"centre": [0, 1, 0], "radius": 0.2}})
        before = scene.info()["triangles"]
        answer = scene.post("subdivide", {"levels": 2, "masked": True})
        self.assertEqual(answer.status, 200, answer)
        self.assertTrue(before < answer.json["triangles"] < 8 * before)
        self.assert_problem(scene.post("subdivide", {"levels": 8}), 422, "/levels")
        self.assert_problem(scene.post("subdivide", {"levels": 9}), 422, "/levels")
        self.assert_problem(scene.post("subdivide", {"level": 1}), 422, "/level")
        self.assert_problem(scene.post("subdivide", {}, headers={"If-Match": '"0"'}), 412)
        self.pelage("subdivide", scene.id, "--levels", 0, code=3)

    def test_a_model_is_turned_with_its_fur(self):
        scene = self.server.new_scene("creature", 3000)
        scene.run({"op": "set_coat", "coat": {"count": 500}}, flood([0, 0, -1], lean=0.8))
        before = scene.info()
        printed = self.pelage("turn", scene.id, "--up", "z", "--front", "-y").stdout
        self.assertIn("revision", printed)
        after = scene.info()
        self.assertEqual((after["revision"], after["undo_steps"]), (before["revision"] + 1, 0))
        for axis, along in (("y", 2), ("z", 1)):  # what pointed forward points up
            turned = after["bounds"]["max"]["xyz".index(axis)] - after["bounds"]["min"]["xyz".index(axis)]
            self.assertAlmostEqual(turned, before["bounds"]["max"][along] - before["bounds"]["min"][along], 5)
        self.assert_problem(scene.post("turn", {"up": "x", "front": "-x"}), 422, "/front")
        self.assert_problem(scene.post("turn", {}, headers={"If-Match": '"0"'}), 412)
        self.pelage("turn", scene.id, "--up", "w", code=3)
        picture = self.picture(scene)
        self.server.terminate()
        self.server.start()
        self.assertEqual(scene.info(), after)
        self.assertEqual(self.picture(scene), picture)
        version = self.server.call("PUT", f"{scene.path}/model?format=obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertIn("carried", version.json, "the scene is groomed, though its log is empty")

    def test_fields_of_another_scene(self):
        source = self.server.new_scene("sphere", 3000, name="source")
        source.run(flood([0, 1, 0.2]))
        target = self.server.new_scene("sphere", 2000, name="target")
        dry = target.run({"op": "retarget", "scene": source.id}, query="?dry_run=1").json
        done = target.run({"op": "retarget", "scene": source.id}).json
        self.assertEqual(dry["results"][0]["touched"], done["results"][0]["touched"])
        self.assertGreater(done["results"][0]["touched"], 0.9 * target.info()["vertices"])
        line = self.server.get(f"{target.path}/log?format=jsonl").body.decode()
        self.assertEqual(json.loads(line)["revision"], 1)
        self.assert_problem(target.run({"op": "retarget", "scene": "none"}), 422, "/scene")
        self.assert_problem(target.run({"op": "retarget", "scene": source.id, "revision": 9}), 422, "/revision")
        again = self.server.new_scene("sphere", 2000)
        self.pelage("run", again.id, "-", text=line)
        self.assertEqual(again.info()["fields_hash"], target.info()["fields_hash"])

    def test_the_client_takes_names(self):
        self.server.new_scene("sphere", 3000, name="groomed fox").run(flood([0, 1, 0.2]))
        command = {"op": "retarget", "scene": "groomed fox"}
        scene = self.server.new_scene("sphere", 2000)
        answer = scene.run(command)
        self.assert_problem(answer, 422, "/scene")
        self.assertEqual(answer.json["limit"], "the id of a scene of this server, not its name")
        self.assertNotIn("touched 0", self.pelage("run", scene.id, "-", "--verbose", text=json.dumps(command)).stdout)
        self.assertEqual(scene.info()["revision"], 1)
        batch = {"commands": [{"op": "mask"}, command]}
        self.pelage("run", scene.id, "-", "--dry-run", text=json.dumps(batch))
        for wrong, pointer in (({**command, "scene": "groomed fix"}, " /scene"),
                               ({"commands": [{"op": "mask"}, {**command, "scene": "groomed fix"}]}, " /commands/1/scene")):
            refused = self.pelage("run", scene.id, "-", text=json.dumps(wrong), code=3).stderr
            self.assertIn(f"field:  {pointer}\n", refused)
            self.assertIn("nearest: groomed fox\n", refused)

    def test_the_example_of_the_page(self):
        source = self.server.new_scene("sphere", 3000)
        source.run(flood([0, 1, 0.2]))
        scene = self.server.new_scene("sphere", 2000)
        example = REPOSITORY / "docs" / "tools" / "examples" / "retarget.json"
        printed = self.pelage("run", scene.id, example, "--verbose", "--set", f"source={source.id}").stdout
        self.assertIn("retarget: touched ", printed)
        self.assertIn("/scene", self.pelage("run", scene.id, example, code=3).stderr)

    def test_the_log_of_one_scene_on_another(self):
        source = self.server.new_scene("creature", 3000, name="animal")
        view = {"camera": {"auto": "left"}, "width": 200, "height": 200}
        samples = [{"screen": [70 + 8 * i, 100]} for i in range(8)]
        source.run({"op": "comb", "stroke": {"view": view, "samples": samples}, "brush": {"radius": 20, "units": "pixels"}})
        source.run({"op": "mask", "box": {"min": [-1, 0, -1], "max": [1, 0.4, 1]}}, flood([0, -1, 0]), {"op": "mask"})
        target = self.server.new_scene("sphere", 3000, name="ball")
        lines = self.pelage("log", "animal", "--lines", "--for", "ball").stdout
        self.assertEqual(len(lines.splitlines()), 2)
        self.assertNotIn("view", lines)
        printed = self.pelage("run", target.id, "-", "--verbose", text=lines).stdout
        self.assertNotIn("touched 0", printed.splitlines()[0])
        source.run({"op": "mask", "vertices": [1, 2]})
        refused = self.server.get(f"{source.path}/log?format=jsonl&for={target.id}")
        self.assert_problem(refused, 422, "/vertices")
        self.assertIn("step 3", refused.json["detail"])
        self.assert_problem(self.server.get(f"{source.path}/log?format=jsonl&for=none"), 422, "/for")
        self.assert_problem(self.server.get(f"{source.path}/log?for={target.id}"), 422, "/for")
        self.pelage("log", "animal", "--for", "ball", code=2)


if __name__ == "__main__":
    unittest.main()
