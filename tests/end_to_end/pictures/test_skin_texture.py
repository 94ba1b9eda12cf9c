"""Pictures on models, and how fur is laid: from the upload to the frame, over undo, restart and replay."""

import io
import tempfile
import unittest
from pathlib import Path

import numpy
from PIL import Image

from support.pictures import hdr, png
from support.server import THIN_COAT, ServedTest

RED_AND_BLUE = numpy.zeros((8, 16, 3))
RED_AND_BLUE[:, :8, 0] = RED_AND_BLUE[:, 8:, 2] = 255


def sheet(cells=6, with_uvs=True):
    """An upright sheet that faces +z, with texture coordinates from corner to corner."""
    steps = [(i / cells, j / cells) for j in range(cells + 1) for i in range(cells + 1)]
    lines = [f"v {u - 0.5} {v - 0.5} 0" for u, v in steps] + [f"vt {u} {v}" for u, v in steps if with_uvs]
    for j in range(cells):
        for i in range(cells):
            a = j * (cells + 1) + i + 1
            corners = (a, a + 1, a + cells + 2, a + cells + 1)
            lines.append("f " + " ".join(f"{k}/{k}" if with_uvs else str(k) for k in corners))
    return "\n".join(lines).encode()


class Backplate(ServedTest):
    def scene(self, query="", with_uvs=True):
        scene = self.server.new_scene("plane", 2)
        scene.run(THIN_COAT)
        answer = self.server.call("PUT", f"{scene.path}/model?format=obj&inclination=0{query}", sheet(with_uvs=with_uvs))
        self.assertEqual(answer.status, 200, answer)
        return scene

    def put(self, scene, content, **more):
        return self.server.call("PUT", f"{scene.path}/skin_texture", content, **more)

    def halves(self, scene):
        """Mean colours of the left and the right of the sheet."""
        image = scene.frame(width=96, height=96, camera={"auto": "front"}, tone_map="none").image.astype(float)
        return image[30:66, 28:40, :3].mean(axis=(0, 1)), image[30:66, 56:68, :3].mean(axis=(0, 1))

    def assert_red_and_blue(self, scene):
        left, right = self.halves(scene)
        self.assertGreater(left[0], left[2] + 40)
        self.assertGreater(right[2], right[0] + 40)

    def test_png_and_jpeg_lie_on_the_model_and_undo_takes_them_off(self):
        jpeg = io.BytesIO()
        Image.fromarray(RED_AND_BLUE.astype(numpy.uint8)).save(jpeg, "JPEG")
        scene = self.scene()
        plain = scene.frame().body
        for content in (png(RED_AND_BLUE), jpeg.getvalue()):
            answer = self.put(scene, content)
            self.assertEqual(answer.status, 200, answer)
            self.assertEqual(answer.json["results"][0]["op"], "set_skin_texture")
            self.assert_red_and_blue(scene)
            self.assertEqual(scene.post("undo").status, 200)
            self.assertEqual(scene.frame().body, plain)
        self.assertEqual(scene.post("redo").status, 200)
        self.assert_red_and_blue(scene)
        self.assertEqual(scene.run({"op": "set_skin_texture", "picture": "own"}).status, 200)
        self.assertEqual(scene.frame().body, plain)

    def test_a_restart_keeps_it_and_the_log_replays(self):
        scene, other = self.scene(), self.scene()
        self.assertEqual(self.put(scene, png(RED_AND_BLUE)).status, 200)
        frame = scene.frame().body
        lines = self.server.get(f"{scene.path}/log?format=jsonl").body.decode().splitlines()
        self.server.terminate()
        self.server.start()
        self.assertEqual(scene.frame().body, frame)
        for line in lines:
            self.assertEqual(self.server.call("POST", f"{other.path}/commands", line.encode()).status, 200)
        self.assertEqual(other.frame().body, frame)

    def test_refusals(self):
        scene = self.scene()
        for content in (b"", b"x" * 100, png(RED_AND_BLUE)[:-20], hdr([[[1, 1, 1]]]), png(numpy.zeros((1, 4097, 3)))):
            answer = self.put(scene, content)
            self.assert_problem(answer, 422)
            self.assertIn("picture cannot be read", answer.json["detail"])
        self.assert_problem(scene.run({"op": "set_skin_texture", "picture": "0" * 32}), 422, "/picture")
        self.assertEqual(self.put(scene, png(RED_AND_BLUE), headers={"If-Match": '"7"'}).status, 412)
        self.assertEqual(scene.info()["revision"], 2)
        for bare in (self.scene(with_uvs=False), self.server.new_scene("sphere", 200)):
            answer = self.put(bare, png(RED_AND_BLUE))
            self.assert_problem(answer, 422, "/picture")
            self.assertIn("no texture coordinates", answer.json["detail"])

    def test_the_client_sends_it(self):
        scene = self.scene()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "zebra.png"
            path.write_bytes(png(RED_AND_BLUE))
            self.assertIn("revision 3", self.pelage("skin-texture", scene.id, path).stdout)
            path.write_bytes(b"x")
            self.assertIn("cannot be read", self.pelage("skin-texture", scene.id, path, code=3).stderr)
        self.assert_red_and_blue(scene)


class FurPatches(ServedTest):
    def load(self, scene, how, with_uvs=True):
        return self.server.call("PUT", f"{scene.path}/model?format=obj&fur_patches={how}", sheet(with_uvs=with_uvs))

    def test_each_fur_layout_is_drawn_and_stored(self):
        frames = {}
        for how in ("overlapping", "hard", "own_uvs"):
            scene = self.server.new_scene("plane", 2)
            scene.run(THIN_COAT)
            self.assertEqual(self.load(scene, how).json["fur_patches"], how)
            frames[how] = (scene, scene.frame().body)
        self.assertNotEqual(frames["overlapping"][1], frames["own_uvs"][1])
        self.server.terminate()
        self.server.start()
        for scene, frame in frames.values():
            self.assertEqual(scene.frame().body, frame)

    def test_builtin_models_take_hard_borders(self):
        answer = self.server.post("/v1/scenes", {"model": {"builtin": "sphere", "triangles": 500}, "fur_patches": "hard"})
        self.assertEqual(answer.status, 201, answer)
        self.assert_problem(self.server.post("/v1/scenes", {"fur_patches": "own_uvs"}), 422, "/fur_patches")

    def test_the_contract_names_the_builtin_models_that_have_texture_coordinates(self):
        schemas = self.server.get("/openapi.json").json["components"]["schemas"]
        words = schemas["FurPatches"]["description"].replace("\n", " ")
        for builtin in schemas["BuiltinModel"]["properties"]["builtin"]["enum"]:
            model = {"builtin": builtin, "triangles": 300}
            answer = self.server.post("/v1/scenes", {"model": model, "fur_patches": "own_uvs"})
            self.assertIn(answer.status, (201, 422), answer)
            self.assertEqual(builtin in words, answer.status == 201, builtin)

    def test_a_model_without_texture_coordinates_is_refused(self):
        scene = self.server.new_scene("plane", 2)
        answer = self.load(scene, "own_uvs", with_uvs=False)
        self.assert_problem(answer, 422, "/fur_patches")
        self.assertIn("no texture coordinates", answer.json["detail"])
        self.assertEqual(scene.info()["revision"], 0)
        self.assert_problem(self.load(scene, "soft"), 422, "/fur_patches")

    def test_the_client_asks_for_it(self):
        scene = self.pelage("new", "--builtin", "sphere", "--triangles", 300, "--fur-patches", "hard").stdout.strip()
        self.pelage("load", scene, "-", "--format", "obj", "--fur-patches", "own_uvs", text=sheet().decode())
        self.pelage("load", scene, "-", "--format", "obj", "--fur-patches", "own_uvs", text=sheet(with_uvs=False).decode(), code=3)
        self.pelage("new", "--fur-patches", "none", code=3)


if __name__ == "__main__":
    unittest.main()
