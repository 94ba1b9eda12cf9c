"""Formats, layers and overlays, read by programs that are not ours."""

import io
import subprocess
import unittest

import numpy
from PIL import Image

from support.exr import read_attributes, read_exr
from support.server import BIN, THIN_COAT, ServedTest

CAMERA = {"position": [1.5, 1.8, 9.0], "target": [0, 0, 0], "fov_degrees": 30}
NAMES = ("beauty", "alpha", "depth", "position", "normal", "tangent", "albedo", "direct", "shadow", "sample_count",
         "strand", "root")


class Frames(ServedTest):
    arguments = {"gl": "osmesa"}

    def exr(self, scene, **request):
        answer = scene.frame(format="exr", camera=CAMERA, **request)
        self.assertEqual(answer.headers["content-type"], "image/x-exr")
        path = self.server.folder / "frame.exr"
        path.write_bytes(answer.body)
        return path

    def thin_scene(self, builtin, triangles, **more):
        scene = self.server.new_scene(builtin, triangles, **more)
        self.assertEqual(scene.run(THIN_COAT).status, 200)
        return scene

    def as_oiiotool_reads(self, path):
        """The channels of an EXR."""
        plain = path.with_name("plain.exr")
        subprocess.run(["oiiotool", path, "-d", "float", "--compression", "none", "-o", plain], check=True)
        return read_exr(plain.read_bytes())

    def described(self, path):
        return subprocess.run(["oiiotool", "--info", "-v", path], check=True, capture_output=True, text=True).stdout

    def test_a_pick_names_the_strand_that_the_aov_names(self):
        scene = self.server.new_scene("sphere", 500, fur={"length": 0.1, "inclination": 0.1})
        scene.run({"op": "set_coat", "coat": {"count": 500, "width_root": 0.005}})
        planes = self.as_oiiotool_reads(self.exr(scene, aovs=["strand", "root"], exr_type="float"))
        strand, along = planes["strand.id"], planes["strand.along"]
        self.assertGreater((strand > 0).mean(), 0.05)
        named, beside = 0, 0
        for x, y in [(x, y) for x in range(2, 128, 9) for y in range(2, 128, 9)]:
            at = {"view": {"camera": CAMERA, "width": 128, "height": 128}, "pixel": [x + 0.5, y + 0.5]}
            pick = scene.post("pick", at).json
            seen = pick.get("strand")
            self.assertEqual(seen["id"] if seen else 0, strand[y, x])
            if not seen:
                continue
            named, beside = named + 1, beside + (not pick["hit"])
            self.assertEqual(seen["kind"], "coat")
            self.assertAlmostEqual(seen["along"], along[y, x], places=6)
            numpy.testing.assert_allclose(seen["root"], [planes[f"root.{axis}"][y, x] for axis in "XYZ"], atol=1e-5)
            self.assertNotIn("strand", scene.post("pick", {**at, "reach": "skin"}).json)
        self.assertGreater(named, 20)
        self.assertGreater(beside, 3, "tips beside the skin are seen, too")

    def test_an_exr_says_its_revision_and_camera(self):
        scene = self.thin_scene("sphere", 500)
        camera = {"position": [1.5, 1, 2], "target": [0, 0.4, 0], "fov_degrees": 30}
        width, height = 160, 96
        frame = scene.frame(width=width, height=height, camera=camera, format="exr", exr_type="float", aovs=["position", "depth"],
                            crop={"left": 40, "top": 20, "width": 90, "height": 70})
        said = read_attributes(frame.body)
        self.assertEqual(said["pelage/revision"], "1")
        to_camera, to_ndc = (numpy.reshape(said[name], (4, 4)) for name in ("worldToCamera", "worldToNDC"))
        numpy.testing.assert_allclose([*camera["position"], 1] @ to_camera, [0, 0, 0, 1], atol=1e-5)
        planes = read_exr(frame.body)
        rows, columns = numpy.nonzero(numpy.isfinite(planes["Z"]))
        self.assertGreater(len(rows), 500)
        positions = numpy.stack([planes[f"position.{axis}"][rows, columns] for axis in "XYZ"] + [numpy.ones(len(rows))], axis=1)
        ndc = positions @ to_ndc
        numpy.testing.assert_allclose(ndc[:, 0] / ndc[:, 3] * width, columns + 40.5, atol=0.6)
        numpy.testing.assert_allclose(ndc[:, 1] / ndc[:, 3] * height, rows + 20.5, atol=0.6)
        self.assertTrue(((positions @ to_camera)[:, 2] > 0).all(), "what is seen lies before the camera")

    def test_aovs_agree_with_a_pick(self):
        scene = self.server.new_scene("torus", 3000, fur={"length": 0.01, "inclination": 0.3})
        path = self.exr(scene, aovs=list(NAMES))
        said = self.described(path)
        for name in ("position.X", "normal.Z", "tangent.Y", "albedo.B", "direct.R", "shadow.Y", "sample_count.Y", "strand.id", "strand.along", "root.Z", "Z"):
            self.assertIn(name, said)
        planes = read_exr(path.read_bytes())
        depth, alpha = planes["Z"], planes["A"]
        position, normal = (numpy.stack([planes[f"{name}.{axis}"] for axis in "XYZ"], -1) for name in ("position", "normal"))
        eye = numpy.array(CAMERA["position"], dtype=float)
        forward = -eye / numpy.linalg.norm(eye)
        size = numpy.linalg.norm(numpy.subtract(scene.info()["bounds"]["max"], scene.info()["bounds"]["min"]))
        hits, close = 0, 0
        for x in range(4, 128, 7):
            for y in range(4, 128, 7):
                at = {"view": {"camera": CAMERA, "width": 128, "height": 128}, "pixel": [x + 0.5, y + 0.5], "reach": "skin"}
                pick = scene.post("pick", at).json
                if not pick["hit"]:
                    continue
                hits += 1
                self.assertEqual(alpha[y, x], 1)
                there = numpy.dot(numpy.subtract(pick["position"], eye), forward)
                close += (-0.05 * size < depth[y, x] - there < 0.002 * size and
                          numpy.linalg.norm(position[y, x] - pick["position"]) < 0.05 * size and
                          numpy.dot(normal[y, x], pick["normal"]) > 0.9)
        self.assertGreater(hits, 50)
        self.assertGreater(close, 0.95 * hits, f"{close} of {hits}")
        self.assertTrue(numpy.isinf(depth[0, 0]))
        self.assertEqual(alpha[0, 0], 0)
        shadow = planes["shadow.Y"]
        self.assertTrue(((shadow >= 0) & (shadow <= 1)).all())
        self.assertLess(shadow.min(), 0.9)

    def test_alpha_and_light_are_those_of_the_picture(self):
        scene = self.thin_scene("sphere", 500)
        request = {"background": "transparent", "tone_map": "none"}
        png = scene.frame(camera=CAMERA, **request).image.astype(float) / 255
        path = self.exr(scene, exr_type="float", exposure=5, **request)
        self.assertIn("float", self.described(path).split("channel list")[0])
        light = numpy.stack([read_exr(path.read_bytes())[name] for name in "RGBA"], -1)
        self.assertLess(numpy.abs(light[..., 3] - png[..., 3]).max(), 0.003)
        covered = light[..., 3] > 0.99
        linear = numpy.clip(light[covered][..., :3] / light[covered][..., 3:], 0, 1)
        srgb = numpy.where(linear < 0.0031308, 12.92 * linear, 1.055 * numpy.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)
        self.assertLess(numpy.abs(srgb - png[covered][..., :3]).max(), 0.004)

    def test_half_is_smaller_and_default(self):
        scene = self.thin_scene("sphere", 500)
        single, half = self.exr(scene, exr_type="float").stat().st_size, self.exr(scene)
        self.assertLess(half.stat().st_size, 0.7 * single)
        self.assertIn("half", self.described(half))

    def test_sixteen_bits(self):
        scene = self.thin_scene("sphere", 500)
        answer = scene.frame(format="png16", background="studio")
        self.assertEqual(answer.headers["content-type"], "image/png")
        path, plain = self.server.folder / "deep.png", self.server.folder / "deep.tif"
        path.write_bytes(answer.body)
        self.assertIn("uint16", self.described(path))
        subprocess.run(["oiiotool", path, "--ch", "R", "--compression", "none", "-o", plain], check=True)
        with Image.open(plain) as image:
            self.assertGreater(len(numpy.unique(numpy.array(image))), 256)

    def test_jpeg(self):
        scene = self.thin_scene("sphere", 500)
        png = scene.frame(background="studio").image.astype(float)
        sizes = []
        for quality in (5, 60, 98):
            answer = scene.frame(format="jpeg", lossy_quality=quality, background="studio")
            self.assertEqual(answer.headers["content-type"], "image/jpeg")
            with Image.open(io.BytesIO(answer.body)) as image:
                self.assertEqual(image.format, "JPEG")
            sizes.append(len(answer.body))
        self.assertEqual(sizes, sorted(sizes))
        self.assertLess(numpy.abs(answer.image.astype(float) - png[..., :3]).mean(), 3)

    def test_webp(self):
        scene = self.thin_scene("sphere", 500)
        for background in ("studio", "transparent"):
            png = Image.fromarray(scene.frame(background=background).image).convert("RGBA")
            answer = scene.frame(format="webp", background=background, lossy_quality=95)
            self.assertEqual(answer.headers["content-type"], "image/webp")
            with Image.open(io.BytesIO(answer.body)) as image:
                self.assertEqual((image.format, image.mode), ("WEBP", "RGBA" if background == "transparent" else "RGB"))
                shown = [numpy.array(Image.alpha_composite(Image.new("RGBA", png.size, "grey"), picture.convert("RGBA"))).astype(float)
                         for picture in (image, png)]
            self.assertLess(numpy.abs(shown[0] - shown[1]).mean(), 3, background)

    def test_the_header_chooses_where_the_request_does_not(self):
        scene = self.thin_scene("sphere", 500)
        moving = {"Accept": "image/webp, image/jpeg;q=0.5"}
        for request, headers, expected in (({}, {}, "image/png"), ({}, moving, "image/webp"), ({"format": "png"}, moving, "image/png"),
                                           ({}, {"Accept": "image/jpeg"}, "image/jpeg"), ({}, {"Accept": "*/*"}, "image/png")):
            answer = scene.post("frames", {"width": 64, "height": 64, **request}, headers=headers)
            self.assertEqual((answer.headers["content-type"], answer.headers["vary"]), (expected, "Accept"), (request, headers))

    def test_drafts_keep_less(self):
        scene = self.thin_scene("sphere", 500)
        draft = {"quality": "draft", "format": "jpeg", "background": "studio"}
        self.assertEqual(scene.frame(**draft).body, scene.frame(**draft, lossy_quality=80).body)
        self.assertEqual(scene.frame(format="jpeg", background="studio").body,
                         scene.frame(format="jpeg", background="studio", lossy_quality=88).body)

    def test_same_request_same_content(self):
        scene = self.thin_scene("torus", 500)
        for request in ({"format": "exr", "aovs": ["beauty", "depth", "normal"]}, {"format": "png16"}, {"format": "jpeg"}, {"format": "webp"},
                        {"overlay": "strokes"}, {"overlay": "wire"}):
            self.assertEqual(scene.frame(**request).body, scene.frame(**request).body, request)

    def test_refusals(self):
        scene = self.server.new_scene("sphere", 500)
        for request, pointer in (({"aovs": ["depth"]}, "/aovs"), ({"aovs": ["beauty"], "format": "jpeg"}, "/aovs"),
                                 ({"format": "exr", "aovs": []}, "/aovs"), ({"format": "exr", "aovs": ["depht"]}, "/aovs/0"),
                                 ({"format": "exr", "aovs": ["depth", "depth"]}, "/aovs/1"),
                                 ({"format": "exr", "overlay": "length"}, "/overlay"), ({"overlay": "stretch"}, "/overlay"),
                                 ({"format": "jpeg", "background": "transparent"}, "/background"),
                                 ({"format": "jpeg", "lossy_quality": 101}, "/lossy_quality"), ({"format": "tiff"}, "/format"),
                                 ({"format": "exr", "width": 8192, "height": 8192, "aovs": ["beauty", "depth"]}, "/aovs")):
            self.assert_problem(scene.post("frames", request), 422, pointer)
        self.assert_problem(self.server.get(f"{scene.path}/frame.png?format=exr"), 422, "/format")

    def test_the_client_goes_by_the_ending(self):
        scene = self.thin_scene("sphere", 500)

        def draw(name, *arguments):
            path = self.server.folder / name
            subprocess.run([BIN / "pelage", "--server", self.server.address, "frame", scene.id, "-o", path, "--width", "32",
                            "--height", "32", *arguments], check=True, capture_output=True)
            return path.read_bytes()

        self.assertTrue(draw("a.png").startswith(b"\x89PNG"))
        self.assertTrue(draw("a.JPG").startswith(b"\xff\xd8"))
        self.assertTrue(draw("a.exr", "--aovs", "beauty,depth,normal").startswith(b"\x76\x2f\x31\x01"))
        self.assertIn("normal.X", self.described(self.server.folder / "a.exr"))
        self.assertTrue(draw("b.exr", "--format", "png", "--overlay", "strokes").startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main()
