"""Guide curves of other programs: a groom goes out as curves and comes back as keys."""

import io
import json
import unittest

import numpy

from support.server import ServedTest


class Guides(ServedTest):
    def put(self, scene, format, content, query=""):
        return self.server.call("PUT", f"{scene.path}/guides?format={format}{query}", content,
                                headers={"Content-Type": "application/octet-stream"})

    def field(self, scene, name):
        answer = self.server.get(f"{scene.path}/maps/{name}?encoding=vertices&format=npy")
        return numpy.load(io.BytesIO(answer.body))

    def plain(self, builtin, inclination=0.0):
        scene = self.server.new_scene(builtin, 1200, fur={"length": 0.05, "inclination": inclination})
        coat = {"bend": 0, "clump": 0, "length_spread": 0, "count": 300}
        self.assertEqual(scene.run({"op": "set_coat", "coat": coat}).status, 200)
        return scene

    def test_a_groom_comes_back(self):
        """Strands without bows and clumps say where they lean; between them fields are smooth."""
        groomed = self.plain("torus")
        answer = groomed.run({"op": "comb", "flood": True, "direction": [1, 0.4, 0.2], "brush": {"strength": 0.7}},
                             {"op": "length", "flood": True, "mode": "set", "value": 0.035, "brush": {"strength": 1}})
        self.assertEqual(answer.status, 200, answer)
        for format in ("usda", "hair"):
            curves = self.server.get(f"{groomed.path}/export/{format}?every=4").body
            with self.subTest(format):
                bald = self.plain("torus")
                answer = self.put(bald, format, curves, "&keys=1000")
                self.assertEqual(answer.status, 200, answer)
                self.assertIn("of", "".join(answer.json["results"][0]["warnings"]))
                lengths = self.field(bald, "length")
                # Strands between vertices that lean apart are shorter than their fields say.
                self.assertLess(abs(lengths - 0.035).max(), 0.004)
                self.assertLess(abs(lengths - 0.035).mean(), 0.0015)
                apart = numpy.linalg.norm(self.field(bald, "direction") - self.field(groomed, "direction"), axis=1)
                self.assertLess(apart.mean(), 0.06)
                self.assertLess(numpy.quantile(apart, 0.95), 0.2)
                entry = self.server.get(f"{bald.path}/log").json["entries"][-1]
                self.assertEqual(entry["commands"]["op"] if "op" in entry["commands"] else entry["commands"][0]["op"], "interpolate")

    def test_curves_as_json(self):
        ball = self.plain("sphere")
        size = ball.info()["size"]
        curve = [[0, 0, 1], [0, 0.04 * size, 1.02]]
        self.assertEqual(self.put(ball, "json", json.dumps({"curves": [curve]}).encode(), "&sigma=0.5").status, 200)
        hit = ball.post("pick", {"nearest": [0, 0, 1]}).json
        self.assertGreater(hit["direction"][1], 0.9)
        self.assertGreater(hit["inclination"], 0.5)

    def test_curves_of_one_point_are_left_out(self):
        ball = self.plain("sphere")
        curves = [[[0, 0, 1]], [[0, 0, 1], [0, 0.04 * ball.info()["size"], 1.02]]]
        answer = self.put(ball, "json", json.dumps({"curves": curves}).encode())
        self.assertEqual(answer.status, 200, answer)
        self.assertIn("1 of 2 curves are left out: they have fewer than two points", answer.json["results"][0]["warnings"])

    def test_refusals(self):
        ball = self.plain("sphere")
        before = ball.info()["revision"]
        for format, content, said in (("usda", b"PXR-USDC", "usdcat"), ("hair", b"HAIR", "HAIR"), ("json", b"{", "JSON"),
                                      ("json", b'{"curves": [[[50, 50, 50], [51, 50, 50]]]}', "skin")):
            answer = self.put(ball, format, content)
            self.assertEqual(answer.status, 422, answer)
            self.assertIn(said, answer.json["detail"])
        self.assertEqual(self.put(ball, "abc", b"").json["pointer"], "/format")
        self.assertEqual(ball.info()["revision"], before)


class Steps(ServedTest):
    def log(self, scene):
        return self.server.get(f"{scene.path}/log").json["entries"]

    def test_an_amend_keeps_the_numbers_of_steps(self):
        scene = self.server.new_scene("sphere", 300)
        for value in (0.02, 0.03, 0.04):
            scene.run({"op": "length", "flood": True, "mode": "add", "value": value, "brush": {"strength": 1}})
        steps = [entry["step"] for entry in self.log(scene)]
        self.assertEqual(len(set(steps)), 3)
        for value in (0.05, 0.06):  # twice by the same number
            amended = scene.post("amend", {"revision": steps[1], "commands": [{"op": "length", "flood": True, "mode": "add", "value": value, "brush": {"strength": 1}}]})
            self.assertEqual(amended.status, 200, amended)
            now = [entry for entry in self.log(scene) if entry["in_effect"]]
            self.assertEqual([entry["step"] for entry in now], steps)
        self.assertAlmostEqual(scene.post("pick", {"nearest": [0, 0, 1]}).json["length"], 0.03 + 0.02 + 0.06 + 0.04, 4)
        scene.post("amend", {"revision": steps[0], "commands": []})
        now = [entry["step"] for entry in self.log(scene) if entry["in_effect"]]
        self.assertEqual(now, steps[1:])
        self.server.kill()
        self.server.start()
        self.assertEqual([entry["step"] for entry in self.log(scene) if entry["in_effect"]], steps[1:])


class Tiles(ServedTest):
    # Two squares side by side; the second lies in the second UDIM tile.
    OBJ = b"""v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nv 3 1 0\nv 2 1 0
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 1 0\nvt 2 0\nvt 2 1\nvt 1 1
f 1/1 2/2 3/3 4/4\nf 5/5 6/6 7/7 8/8\n"""

    def test_each_tile_is_a_picture_of_its_own(self):
        scene = self.server.new_scene("sphere", 100)
        loaded = self.server.call("PUT", f"{scene.path}/model?format=obj&form=even", self.OBJ, headers={"Content-Type": "application/octet-stream"})
        self.assertEqual(loaded.status, 200, loaded)
        right = {"op": "length", "flood": True, "mode": "set", "value": 0.05, "brush": {"strength": 1}}
        scene.run({"op": "mask", "box": {"min": [1.5, -1, -1], "max": [4, 2, 1]}}, right, {"op": "mask"})

        def tile(number):
            answer = self.server.get(f"{scene.path}/maps/length?format=npy&size=16&tile={number}")
            return numpy.load(io.BytesIO(answer.body)), json.loads(answer.headers["pelage-map"])

        first, about = tile(1001)
        second, _ = tile(1002)
        self.assertEqual(about["tiles"], [1001, 1002])
        self.assertLess(abs(first - 0.03).max(), 1e-4)
        self.assertLess(abs(second - 0.05).max(), 1e-4)
        content = self.server.get(f"{scene.path}/maps/length?format=exr&size=16&tile=1002").body
        self.assertEqual(self.server.call("PUT", f"{scene.path}/maps/length?tile=1001&scale=2", content).status, 200)
        self.assertLess(abs(tile(1001)[0] - 0.1).max(), 1e-3)
        self.assertLess(abs(tile(1002)[0] - 0.05).max(), 1e-4)
        nowhere = self.server.call("PUT", f"{scene.path}/maps/length?tile=1005&scale=2", content).json["results"][0]["warnings"]
        self.assertIn("the model has nothing in tile 1005; its tiles are 1001 1002", nowhere)
        self.assertEqual(self.server.get(f"{scene.path}/maps/length?tile=7").json["pointer"], "/tile")


if __name__ == "__main__":
    unittest.main()
