"""From a JSON command to a picture, on every kind of GL."""

import unittest

import numpy

from support.nightly import nightly
from support.server import THIN_COAT, Server, ServedTest, comb


class FirstLight:
    def thin_scene(self, builtin="sphere"):
        scene = self.server.new_scene(builtin)
        self.assertEqual(scene.run(THIN_COAT).json["revision"], 1)
        return scene

    def test_comb_changes_the_picture(self):
        scene = self.thin_scene()
        before = scene.frame(camera={"auto": "left"})
        self.assertEqual(before.headers["content-type"], "image/png")
        self.assertEqual(before.headers["pelage-revision"], "1")
        self.assertIn("draw;dur=", before.headers["server-timing"])
        self.assertEqual(before.image.shape[:2], (128, 128))

        bounds = scene.info()["bounds"]
        middle = [(a + b) / 2 for a, b in zip(bounds["min"], bounds["max"])]
        start, end = list(middle), list(middle)
        start[2], end[2] = bounds["min"][2], bounds["max"][2]
        answer = scene.run(comb(start, end, samples=30, radius=0.5, lean=1.0))
        self.assertEqual(answer.status, 200, answer)
        self.assertGreater(answer.json["results"][0]["touched"], 100)
        self.assertEqual(answer.json["revision"], 2)
        self.assertEqual(answer.headers["etag"], '"2"')

        after = scene.frame(camera={"auto": "left"})
        self.assertEqual(after.headers["pelage-revision"], "2")
        changed = numpy.any(before.image != after.image, axis=-1).mean()
        self.assertGreater(changed, 0.01)

        undone = scene.post("undo")
        self.assertEqual(undone.json["revision"], 3)
        self.assertEqual(scene.frame(camera={"auto": "left"}).body, before.body)

    def test_bare_skin_and_back(self):
        scene = self.thin_scene()
        before = scene.frame(camera={"auto": "front"})
        region = {"centre": [0, 0, 1], "radii": [0.2, 0.2, 0.2], "colour": "#0000ff", "shine": 0, "scatter": 0}
        self.assertEqual(scene.run({"op": "set_skin", "regions": [region]}).json["revision"], 2)
        after = scene.frame(camera={"auto": "front"})
        middle = after.image[after.image.shape[0] // 2, after.image.shape[1] // 2]
        self.assertGreater(int(middle[2]), 2 * int(middle[0]))
        self.assertEqual(scene.post("undo").json["revision"], 3)
        self.assertEqual(scene.frame(camera={"auto": "front"}).body, before.body)
        self.assertEqual(scene.post("redo").json["revision"], 4)
        self.assertEqual(scene.frame(camera={"auto": "front"}).body, after.body)

    def test_the_knobs_that_were_used_draw_the_frame_again(self):
        import json
        scene = self.thin_scene("torus")
        drawn = scene.frame(quality="draft")
        again = scene.frame(quality=json.loads(drawn.headers["pelage-quality"]))
        self.assertEqual(drawn.body, again.body)
        self.assertNotEqual(drawn.body, scene.frame(quality={"raster": {"strands": 64}}).body)

    def test_address_and_body_ask_for_the_same_picture(self):
        scene = self.thin_scene("torus")
        posted = scene.frame(width=96, height=64, camera={"auto": "top"}, background="#ff0000", exposure=1)
        got = self.server.get(f"{scene.path}/frame.png?width=96&height=64&camera=top&background=%23ff0000&exposure=1")
        self.assertEqual(got.body, posted.body)
        self.assertEqual(got.image.shape, (64, 96, 3))

    def test_transparent_background(self):
        scene = self.thin_scene()
        image = scene.frame(background="transparent").image
        self.assertEqual(image.shape, (128, 128, 4))
        self.assertEqual(image[0, 0, 3], 0)
        self.assertEqual(image[64, 64, 3], 255)


class FirstLightEgl(FirstLight, ServedTest):
    arguments = {"gl": "egl"}


class FirstLightOsmesa(FirstLight, ServedTest):
    arguments = {"gl": "osmesa"}


class Backends(unittest.TestCase):
    @nightly
    def test_egl_and_osmesa_give_the_same_bytes(self):
        pictures = {}
        for gl in ("egl", "osmesa"):
            server = Server(gl=gl)
            self.addCleanup(server.close)
            if "llvmpipe" not in server.printed():
                self.skipTest("EGL has a GPU here; only one Mesa gives the same bytes")
            scene = server.new_scene("creature", 4000)
            scene.run(comb([0, 0.3, -0.5], [0, 0.3, 0.5], radius=0.3))
            pictures[gl] = [scene.frame(width=200, height=160, camera={"auto": view}, quality=quality).body
                            for view in ("three_quarter", "left") for quality in ("interactive", "detailed")]
        self.assertEqual(pictures["egl"], pictures["osmesa"])

    def test_a_gl_that_is_not_there_is_a_refusal_that_says_so(self):
        with self.assertRaises(AssertionError):
            Server(gl="vulkan")


if __name__ == "__main__":
    unittest.main()
