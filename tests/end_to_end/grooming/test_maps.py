"""Maps and masks from pictures: from the field to the file and back, over undo, replay, restart and the client."""

import io
import json
import tempfile
import unittest
from pathlib import Path

import numpy
from PIL import Image

from support.nightly import nightly
from support.pictures import exr, png
from support.server import ServedTest, comb, shared_folder


def png16(numbers):
    """Grey, 16 bits."""
    file = io.BytesIO()
    Image.fromarray(numpy.asarray(numbers, dtype=numpy.uint16)).save(file, "PNG")
    return file.getvalue()


class Maps(ServedTest):
    def groomed(self, builtin="torus"):
        scene = self.server.new_scene(builtin, 1200)
        answer = scene.run({"op": "noise", "flood": True, "fields": ["direction", "length", "density"], "amount": 0.3, "seed": 3},
                           {"op": "length", "flood": True, "mode": "jitter", "value": 0.5})
        self.assertEqual(answer.status, 200, answer)
        return scene

    def get(self, scene, field, query=""):
        answer = self.server.get(f"{scene.path}/maps/{field}{query}")
        self.assertEqual(answer.status, 200, answer)
        return answer

    def put(self, scene, field, content, query=""):
        return self.server.call("PUT", f"{scene.path}/maps/{field}{query}", content)

    def changes(self, answer):
        self.assertEqual(answer.status, 200, answer)
        return {field["field"]: field["max_change"] for field in answer.json["results"][0]["fields"]}

    def test_what_is_written_is_read_again(self):
        scene = self.groomed()
        bits = {"exr": 5e4, "png16": 65535, "png": 255}
        for field, format in (("direction", "exr"), ("direction", "png16"), ("direction", "png"), ("length", "png16"), ("density", "png")):
            answer = self.get(scene, field, f"?format={format}&size=512")
            about = json.loads(answer.headers["pelage-map"])
            self.assertEqual((about["field"], about["outside"]), (field, 0))
            change = self.changes(self.put(scene, field, answer.body)).get(field, 0)
            steps = 3 if field == "direction" else 1
            self.assertLessEqual(change, steps * max(about["scale"], 1e-3) / bits[format], (field, format))
            self.assertEqual(scene.post("undo").status if change else 200, 200)

    def test_files_say_their_scale_and_hold_what_they_say(self):
        scene = self.groomed("plane")
        answer = self.get(scene, "length", "?format=png&size=64")
        image = Image.open(io.BytesIO(answer.body))
        about = json.loads(answer.headers["pelage-map"])
        self.assertEqual(image.text["pelage:field"], "length")
        self.assertAlmostEqual(float(image.text["pelage:scale"]), about["scale"])
        self.assertNotIn("srgb", image.info)
        self.assertGreater(numpy.asarray(image).max(), 250)
        world = self.get(scene, "length", "?format=png&size=64&units=world&scale=2")
        size = scene.info()["size"]
        self.assertAlmostEqual(float(Image.open(io.BytesIO(world.body)).text["pelage:scale"]), 2 / size)
        floats = self.get(scene, "length", f"?format=exr&size=64&units=world&scale={size}")
        back = self.changes(self.put(scene, "length", floats.body, "?units=world"))
        self.assertLess(back.get("length", 0), 1e-5, "the file's own scale is in sizes, whatever units are asked for")
        colour = self.get(scene, "root_colour", "?format=png&size=16")
        self.assertIn("srgb", Image.open(io.BytesIO(colour.body)).info)

    def test_a_list_has_more_vertices_than_a_picture_has_rows(self):
        scene = self.server.new_scene("plane", 12000)
        scene.run({"op": "length", "flood": True, "mode": "jitter", "value": 0.5})
        answer = self.get(scene, "length", "?format=npy&encoding=vertices")
        self.assertGreater(numpy.load(io.BytesIO(answer.body)).size, 4096)
        self.assertEqual(self.changes(self.put(scene, "length", answer.body, "?encoding=vertices")), {})

    def test_a_picture_of_another_program(self):
        scene = self.server.new_scene("plane", 800)
        left_long = numpy.zeros((8, 8))
        left_long[:, :4] = 65535
        self.assertEqual(self.put(scene, "length", png16(left_long), "?scale=0.2").status, 200)
        size = scene.info()["size"]
        for x, wanted in ((-0.4, 0.2), (0.4, 0.0)):
            view = {"camera": {"position": [x, 2, 0], "target": [x, 0, 0], "up": [0, 0, -1]}, "width": 65, "height": 65}
            found = scene.post("pick", {"view": view, "pixel": [32, 32], "reach": "skin"}).json
            self.assertAlmostEqual(found["length"], wanted, 5)
        self.assertEqual(self.changes(self.put(scene, "length", png16(left_long), f"?units=world&scale={0.2 * size}")), {})

    def test_undo_replay_and_restart(self):
        scene, other = self.groomed(), self.groomed()
        before = scene.info()["fields_hash"]
        ramp = numpy.tile(numpy.linspace(0, 65535, 32), (32, 1))
        answer = self.put(scene, "length", png16(ramp), "?scale=0.1")
        self.assertEqual(answer.json["results"][0]["op"], "map")
        after = answer.json["fields_hash"]
        self.assertNotEqual(after, before)
        self.assertEqual(scene.post("undo").json["fields_hash"], before)
        self.assertEqual(scene.post("redo").json["fields_hash"], after)
        lines = self.server.get(f"{scene.path}/log?format=jsonl").body.decode().splitlines()
        self.server.terminate()
        self.server.start()
        self.assertEqual(scene.info()["fields_hash"], after)
        self.assertEqual(other.run(json.loads(lines[-1])).json["fields_hash"], after, "the picture lives as long as the log")
        fresh = self.server.new_scene("torus", 1200)
        for line in lines:
            self.assertEqual(fresh.run(json.loads(line)).status, 200)
        self.assertEqual(fresh.info()["fields_hash"], after)

    def test_pictures_that_no_log_names_are_gone_after_a_restart(self):
        scene = self.server.new_scene("torus", 600)
        stored = self.server.call("PUT", f"{scene.path}/pictures", png(numpy.full((4, 4, 3), 77))).json
        self.assertEqual((stored["width"], stored["height"], stored["bits"]), (4, 4, 8))
        self.assertEqual(scene.info()["revision"], 0)
        self.server.terminate()
        self.server.start()
        self.assert_problem(scene.run({"op": "map", "picture": stored["picture"]}), 422, "/picture")

    def test_a_mask_from_a_picture(self):
        scene = self.server.new_scene("plane", 800)
        half = numpy.zeros((16, 16, 3))
        half[:, 8:, 1] = 255
        name = self.server.call("PUT", f"{scene.path}/pictures", png(half)).json["picture"]
        chosen = scene.run({"op": "mask", "picture": {"name": name, "channel": "green"}})
        self.assertEqual(chosen.status, 200, chosen)
        self.assertEqual(scene.run({"op": "length", "flood": True, "mode": "set", "value": 0.2, "brush": {"strength": 1}}).status, 200)
        for x, wanted in ((-0.4, 0.03), (0.4, 0.2)):
            view = {"camera": {"position": [x, 2, 0], "target": [x, 0, 0], "up": [0, 0, -1]}, "width": 65, "height": 65}
            self.assertAlmostEqual(scene.post("pick", {"view": view, "pixel": [32, 32], "reach": "skin"}).json["length"], wanted, 5)
        self.assert_problem(scene.run({"op": "mask", "picture": {"name": "0" * 32}}), 422, "/picture/name")
        self.assert_problem(scene.run({"op": "mask", "picture": {"name": name}, "all": {}}), 422)
        self.assert_problem(scene.run({"op": "set_skin_texture", "picture": name}), 422, "/picture")
        through = self.put(scene, "mask", png(numpy.full((2, 2, 3), 255)))
        self.assertEqual(self.changes(through), {"mask": 1.0}, "a map of the mask looks past the mask")

    def test_a_brush_prints_an_alpha(self):
        scene = self.server.new_scene("plane", 800)
        half = numpy.zeros((16, 16, 3))
        half[:, 8:] = 255
        name = self.server.call("PUT", f"{scene.path}/pictures", png(half)).json["picture"]
        stroke = {"samples": [{"position": [0, 0, 0.05]}, {"position": [0, 0, -0.05]}]}  # to -z, so that +x is right
        brush = {"radius": 0.3, "strength": 1, "falloff": "constant", "alpha": name}
        paint = {"op": "paint", "field": "density", "value": 0, "stroke": stroke, "brush": brush}
        self.assertEqual(scene.run(paint).status, 200)

        def pick(x):
            return scene.post("pick", {"nearest": [x, 0, 0]}).json

        scene.run({"op": "comb", "flood": True, "direction": [1, 0, 0], "brush": {"strength": 1}})
        before = pick(-0.2)["direction"]
        self.assertEqual(scene.run({"op": "comb", "stroke": stroke, "brush": brush}).status, 200)
        for x, density in ((-0.2, 1), (0.2, 0)):
            self.assertAlmostEqual(pick(x)["painted"]["density"], density, 5)
        self.assertEqual(pick(-0.2)["direction"], before)
        self.assertLess(pick(0.2)["direction"][2], -0.99)
        again = self.server.new_scene("plane", 800)
        for line in self.server.get(f"{scene.path}/log?format=jsonl").body.decode().splitlines():
            self.assertEqual(again.run(json.loads(line)).status, 200)
        self.assertEqual(again.info()["fields_hash"], scene.info()["fields_hash"])
        self.assert_problem(scene.run(paint | {"brush": brush | {"alpha": "0" * 32}}), 422, "/brush/alpha")

    def test_a_batch_reads_few_pictures(self):
        scene = self.server.new_scene("torus", 600)
        names = [self.server.call("PUT", f"{scene.path}/pictures", png(numpy.full((1, 1, 3), k))).json["picture"] for k in range(9)]
        maps = [{"op": "map", "picture": name, "field": "density"} for name in names]
        self.assertEqual(scene.run(*maps[:8], *maps[:8]).status, 200)
        self.assert_problem(scene.run(*maps), 422, "/commands/8/picture")

    def test_refusals(self):
        scene = self.server.new_scene("torus", 600)
        revision = scene.info()["revision"]
        good = exr(numpy.ones((4, 4, 3)))
        broken = numpy.ones((4, 4, 3))
        broken[1, 2, 0], broken[2, 2, 1] = numpy.nan, numpy.inf
        answer = self.put(scene, "length", exr(broken))
        self.assert_problem(answer, 422)
        self.assertIn(" 2 of its numbers", answer.json["detail"])
        self.assert_problem(self.put(scene, "length", good[:-9]), 422)
        self.assert_problem(self.put(scene, "length", png(numpy.ones((8, 8, 3)))[:-20]), 422)
        self.assert_problem(self.put(scene, "length", b"no picture"), 422)
        self.assert_problem(self.put(scene, "length", png(numpy.zeros((1, 4097, 3)))), 422)
        self.assert_problem(self.put(scene, "furriness", good), 404, "/field")
        self.assert_problem(self.put(scene, "length", good, "?encoding=vector"), 422, "/encoding")
        self.assert_problem(self.put(scene, "direction", good, "?encoding=value"), 422, "/encoding")
        self.assert_problem(self.put(scene, "direction", png(numpy.ones((4, 4, 3))), "?encoding=vector"), 422, "/encoding")
        self.assert_problem(self.put(scene, "length", good, "?scale=0"), 422, "/scale")
        self.assert_problem(self.put(scene, "length", good, "?strength=2"), 422, "/strength")
        for query, pointer in (("size=0", "/size"), ("size=8193", "/size"), ("dilate=65", "/dilate"), ("format=jpeg", "/format"),
                               ("encoding=vector", "/encoding"), ("sise=4", "/sise")):
            self.assert_problem(self.server.get(f"{scene.path}/maps/length?{query}"), 422, pointer)
        self.assert_problem(self.server.get(f"{scene.path}/maps/direction?encoding=vector"), 422, "/format")
        ball = self.server.new_scene("sphere", 600)
        self.assert_problem(self.server.get(f"{ball.path}/maps/length"), 422)
        self.assert_problem(self.put(ball, "length", good), 422, "/picture")
        self.assertEqual(self.server.call("POST", f"{scene.path}/maps/length", b"{}").status, 405)
        self.assertEqual(scene.info()["revision"], revision)

    def test_values_beyond_the_range_are_held_and_counted(self):
        scene = self.server.new_scene("torus", 600)
        answer = self.put(scene, "density", exr(numpy.full((4, 4, 3), 7.0)))
        self.assertEqual(answer.json["results"][0]["clamped"], scene.info()["vertices"])

    def test_the_client(self):
        scene = self.groomed()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "length.exr"
            said = self.pelage("map", "get", scene.id, "length", "-o", path, "--size", 256).stdout
            self.assertIn('"field":"length"', said)
            self.assertEqual(path.read_bytes()[:4], b"\x76\x2f\x31\x01")
            self.pelage("map", "put", scene.id, "length", path)
            self.pelage("map", "get", scene.id, "direction", "-o", Path(folder) / "d.png", "--encoding", "fast_fur")
            self.pelage("map", "put", scene.id, "direction", Path(folder) / "d.png", "--encoding", "fast_fur")
            name = self.pelage("map", "upload", scene.id, path).stdout.strip()
            self.assertRegex(name, "^[0-9a-f]{32}$")
            self.pelage("map", "get", scene.id, "length", "-o", path, "--size", 0, code=3)

    @nightly
    def test_spot(self):
        scene = self.server.new_scene("plane", 2)
        content = (shared_folder() / "meshes" / "spot.obj").read_bytes()
        answer = self.server.call("PUT", f"{scene.path}/model?format=obj", content)
        self.assertEqual(answer.status, 200, answer)
        scene.run({"op": "noise", "flood": True, "fields": ["direction", "length", "density"], "amount": 0.3, "seed": 3})
        for field in ("direction", "length", "density"):
            for format, limit in (("exr", 1e-5), ("png16", 2 / 65535), ("png", 2 / 255)):
                answer = self.get(scene, field, f"?format={format}&size=1024")
                about = json.loads(answer.headers["pelage-map"])
                self.assertEqual(about["outside"], 10)
                result = self.put(scene, field, answer.body).json["results"][0]
                for change in result["fields"]:
                    worst = change["max_change"]
                    # Pixels, clamped to [0, 1], cannot fit all of several vertices that are a fifth of a pixel apart.
                    if field == "density":
                        worst = change["mean_change"] * change["changed"] / scene.info()["vertices"] / 10
                    self.assertLessEqual(worst, limit * max(about["scale"], 0.05), (field, format, change))
                    self.assertEqual(scene.post("undo").status, 200)


if __name__ == "__main__":
    unittest.main()
