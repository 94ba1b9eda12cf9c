"""Light from pictures: uploaded, logged as numbers, kept, replayed, and refused when the picture is bad."""

import tempfile
import unittest
from pathlib import Path

import numpy

from support.pictures import exr, hdr, png
from support.server import THIN_COAT, ServedTest

RED_AND_BLUE = numpy.zeros((8, 16, 3))
RED_AND_BLUE[:, :8, 0] = RED_AND_BLUE[:, 8:, 2] = 1


class Environment(ServedTest):
    def put(self, scene, content, query=""):
        return self.server.call("PUT", f"{scene.path}/environment{query}", content)

    def scene(self):
        scene = self.server.new_scene("sphere", 500)
        grey = {"op": "set_coat", "coat": {**THIN_COAT["coat"], "ramp": [{"at": 0, "colour": [0.5, 0.5, 0.5]}]}}
        scene.run({"op": "set_lights", "lights": []}, grey, {"op": "set_look", "look": {"skin": [0.5, 0.5, 0.5]}})
        return scene

    def halves(self, scene):
        """Mean colours of the left and the right of the picture."""
        image = scene.frame(width=96, height=96, camera={"auto": "front"}, background="transparent", tone_map="none").image
        image = numpy.where(image[..., 3:] > 200, image[..., :3], 0).astype(float)
        return image[:, :40].mean(axis=(0, 1)), image[:, 56:].mean(axis=(0, 1))

    def test_exr_and_hdr_light_the_sides_that_they_should(self):
        for content in (exr(RED_AND_BLUE), hdr(RED_AND_BLUE)):
            scene = self.scene()
            answer = self.put(scene, content, "?intensity=2")
            self.assertEqual(answer.status, 200, answer)
            self.assertEqual((answer.json["revision"], answer.headers["etag"]), (2, '"2"'))
            left, right = self.halves(scene)
            self.assertGreater(left[0], 1.4 * left[2])
            self.assertGreater(right[2], 1.4 * right[0])
            self.assertEqual(self.put(scene, content, "?intensity=2&turn_degrees=180").status, 200)
            left, right = self.halves(scene)
            self.assertGreater(left[2], 1.4 * left[0])
            scene.post("undo", {"steps": 2})
            left, right = self.halves(scene)
            self.assertAlmostEqual(left[0], right[0], delta=2)

    def test_the_log_replays_without_the_picture_and_a_restart_keeps_the_light(self):
        scene, other = self.scene(), self.server.new_scene("sphere", 500)
        self.assertEqual(self.put(scene, exr(RED_AND_BLUE), "?turn_degrees=30").status, 200)
        frame = scene.frame(width=64, height=64).body
        for line in self.server.get(f"{scene.path}/log?format=jsonl").body.decode().splitlines():
            self.assertEqual(self.server.call("POST", f"{other.path}/commands", line.encode()).status, 200)
        self.assertEqual(other.frame(width=64, height=64).body, frame)
        self.server.terminate()
        self.server.start()
        self.assertEqual(scene.frame(width=64, height=64).body, frame)

    def test_a_frame_of_ours_can_light_another(self):
        scene = self.scene()
        picture = scene.post("frames", {"width": 64, "height": 32, "format": "exr"}).body
        self.assertEqual(self.put(scene, picture).status, 200)

    def test_bad_pictures_are_refused_and_change_nothing(self):
        scene = self.scene()
        white, bad = numpy.ones((4, 8, 3)), numpy.ones((4, 8, 3))
        bad[1, 2, 0] = numpy.nan
        cases = {"nothing": b"", "noise": b"x" * 1000, "a PNG": png(255 * white), "cut HDR": hdr(white)[:-7], "cut EXR": exr(white)[:-7],
                 "no number": exr(bad), "infinite": exr(numpy.full((2, 4, 3), numpy.inf)),
                 "too strong": exr(1e30 * white), "huge EXR": exr(white, header_size=(2**30, 2**30)),
                 "lying EXR": exr(white, header_size=(4096, 4096)), "wide EXR": exr(white, header_size=(4097, 1)),
                 "huge HDR": b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999999 +X 99999999\n",
                 "broken header": exr(white)[:40] + b"\xff" * 200 + exr(white)[240:]}
        for name, content in cases.items():
            with self.subTest(name):
                answer = self.put(scene, content)
                self.assert_problem(answer, 422)
                self.assertIn("environment cannot be read", answer.json["detail"])
                if name == "no number":
                    self.assertIn("column 2 of row 1", answer.json["detail"])
        self.assertEqual(scene.info()["revision"], 1)
        self.assertEqual(self.server.get("/livez").status, 200)

    def test_parameters_and_preconditions(self):
        scene = self.scene()
        content = hdr([[[1, 1, 1]]])
        for query, pointer in (("?intensity=101", "/intensity"), ("?turn_degrees=361", "/turn_degrees"), ("?turn=1", "/turn")):
            answer = self.put(scene, content, query)
            self.assert_problem(answer, 422)
            self.assertEqual(answer.json["pointer"], pointer)
        self.assertEqual(self.server.call("PUT", f"{scene.path}/environment", content, headers={"If-Match": '"7"'}).status, 412)
        self.assertEqual(self.server.call("PUT", "/v1/scenes/nothing/environment", content).status, 404)
        answer = self.server.call("PUT", f"{scene.path}/environment", None, headers={"Content-Length": str((128 << 20) + 1)})
        self.assert_problem(answer, 413)

    def test_the_client_sends_it(self):
        scene = self.scene()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "light.exr"
            path.write_bytes(exr(RED_AND_BLUE))
            said = self.pelage("environment", scene.id, path, "--intensity", 2, "--turn-degrees", -20).stdout
            self.assertIn("revision 2", said)
            path.write_bytes(b"x")
            self.assertIn("cannot be read", self.pelage("environment", scene.id, path, code=3).stderr)
            self.pelage("environment", scene.id, path, "--intensity", 200, code=3)
        environment = self.server.get(f"{scene.path}/log").json["entries"][-1]["commands"]["environment"]
        self.assertEqual((environment["intensity"], environment["turn_degrees"], len(environment["harmonics"])), (2, -20, 9))


if __name__ == "__main__":
    unittest.main()
