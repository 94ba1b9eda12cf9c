"""Outputs for compositors: cryptomatte, and colour spaces of an OpenColorIO configuration."""

import contextlib
import json
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest
import unittest.mock

import numpy

from support.exr import read_attributes, read_exr
from support.server import THIN_COAT, ServedTest, Server

FRAME = {"width": 128, "height": 128, "background": "transparent", "camera": {"auto": "left"}, "format": "exr", "exr_type": "float"}
TRACED = {"method": "strands", "trace": {"passes": 16, "filter": False}}  # which only beauty and alpha pass through
FUR = {"name": "fur", "coat": {"count": 1000, "width_root": 0.004}}
MANE = {"name": "mane", "begins": {"length": 2}, "coat": {"count": 400, "width_root": 0.002}}

# ACES2065-1 and ACEScg as SMPTE ST 2065-1 and the Academy's S-2014-004 have them.
CONFIGURATION = """ocio_profile_version: 2
roles: {default: ACEScg, aces_interchange: ACES2065-1}
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  none: [!<View> {name: raw, colorspace: ACEScg}]
colorspaces:
  - !<ColorSpace> {name: ACES2065-1, encoding: scene-linear}
  - !<ColorSpace>
    name: ACEScg
    aliases: [lin_ap1]
    to_scene_reference: !<MatrixTransform> {matrix: [0.695452241357452, 0.140678696470294, 0.163869062172254, 0, 0.0447945633720377, 0.859671118456422, 0.0955343181715404, 0, -0.00552588255811354, 0.00402521030597866, 1.00150067225213, 0, 0, 0, 0, 1]}
  - !<ColorSpace>
    name: curved
    to_scene_reference: !<ExponentTransform> {value: 2.2}
"""
# Rec. 709 to ACEScg, by Bradford: rows.
ACESCG = numpy.array([[0.61309740, 0.33952315, 0.04737945], [0.07019372, 0.91635388, 0.01345240], [0.02061559, 0.10956977, 0.86981463]])


def colours(picture, prefix=""):
    return numpy.stack([picture[prefix + channel] for channel in "RGB"], -1)


class Matte:
    """Shares of objects by their names, rows x columns each."""

    def __init__(self, content):
        texts = {name: value for name, value in read_attributes(content).items() if name.startswith("cryptomatte/")}
        self.keys = {name.rsplit("/", 1)[1]: value for name, value in texts.items()}
        self.manifest = json.loads(self.keys["manifest"])
        self.channels = read_exr(content)
        ranks = [(self.channels[f"CryptoObject0{layer}.{a}"], self.channels[f"CryptoObject0{layer}.{b}"]) for layer in range(3) for a, b in ("RG", "BA")]
        self.ids, self.shares = (numpy.stack(part) for part in zip(*ranks))
        self.of = {name: self.share_of(struct.unpack("<f", struct.pack("<I", int(word, 16)))[0]) for name, word in self.manifest.items()}

    def share_of(self, number):
        return numpy.where(self.ids == number, self.shares, 0).sum(0)


class Cryptomatte(ServedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scene = cls.server.new_scene("creature", 1000)
        answer = cls.scene.run({"op": "set_coats", "coats": [FUR, MANE]})
        assert answer.status == 200, answer

    def matte(self, scene, **frame):
        answer = scene.frame(**{**FRAME, "aovs": ["alpha", "cryptomatte"], **frame})
        self.assertEqual(answer.status, 200, answer.body)
        return Matte(answer.body)

    def test_shares_of_all_objects_add_up_to_what_is_covered(self):
        for quality in ("interactive", "detailed", TRACED):
            with self.subTest(quality):
                matte = self.matte(self.scene, quality=quality)
                self.assertEqual(set(matte.manifest), {"skin", "eyes", "curves", "coat/fur", "coat/mane"})
                self.assertEqual((matte.keys["name"], matte.keys["hash"], matte.keys["conversion"]), ("CryptoObject", "MurmurHash3_32", "uint32_to_float32"))
                numpy.testing.assert_allclose(sum(matte.of.values()), matte.channels["A"], atol=0.01)
                self.assertTrue((numpy.diff(matte.shares, axis=0) <= 0).all(), "most first")
                for name in ("skin", "eyes", "coat/fur", "coat/mane"):
                    self.assertGreater(matte.of[name].max(), 0.2, name)

    def test_drawn_and_traced_objects_lie_in_the_same_positions(self):
        drawn, traced = (self.matte(self.scene, quality=quality) for quality in ("detailed", TRACED))
        for name in drawn.manifest:
            self.assertLess(numpy.abs(drawn.of[name] - traced.of[name]).mean(), 0.05, name)
            self.assertAlmostEqual(drawn.of[name].mean(), traced.of[name].mean(), delta=0.02, msg=name)

    def test_each_coat_has_its_own_matte(self):
        scene = self.scene
        matte = self.matte(scene)
        scene.run({"op": "set_coats", "coats": [{"name": "fur", "muted": True}, {"name": "mane"}]})
        alone = self.matte(scene)
        self.assertNotIn("coat/fur", alone.manifest)
        self.assertGreater(alone.of["coat/mane"].mean(), matte.of["coat/mane"].mean(), "nothing is before it")
        scene.run({"op": "set_coats", "coats": [{"name": "mane"}, {"name": "fur"}]})
        turned = self.matte(scene)
        self.assertEqual(scene.post("undo", {"steps": 2}).status, 200)
        self.assertEqual(turned.manifest["coat/mane"], matte.manifest["coat/mane"])
        self.assertLess(numpy.abs(turned.of["coat/mane"] - matte.of["coat/mane"]).mean(), 0.01)

    def test_eight_coats_have_a_share_each(self):
        scene = self.server.new_scene("sphere", 300)
        coats = [{"name": "fur", "coat": {"count": 300, "width_root": 0.004}}] + [{"name": f"coat {k}", "begins": {"region": "all"}, "coat": {"count": 300, "width_root": 0.004}} for k in range(7)]
        self.assertEqual(scene.run({"op": "set_coats", "coats": coats}).status, 200)
        matte = self.matte(scene)
        for coat in coats:
            self.assertGreater(matte.of[f"coat/{coat['name']}"].max(), 0.01, coat["name"])
        self.assertLessEqual(sum(matte.of.values()).max(), 1.001)

    def test_a_crop_has_the_shares_of_the_whole(self):
        whole, part = self.matte(self.scene), self.matte(self.scene, crop={"left": 40, "top": 30, "width": 50, "height": 60})
        self.assertEqual(part.manifest, whole.manifest)
        for name in whole.of:
            numpy.testing.assert_allclose(part.of[name], whole.of[name][30:90, 40:90], atol=1e-6)

    def test_shells_and_pictures_have_none(self):
        scene = self.server.new_scene("sphere", 300)
        for frame in ({"quality": {"method": "shells"}}, {"format": "png", "exr_type": "half"}):
            self.assert_problem(scene.post("frames", {**FRAME, **frame, "aovs": ["cryptomatte"]}), 422, "/aovs")


class ColourSpaces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        configuration = pathlib.Path(cls.folder.name, "config.ocio")
        configuration.write_text(CONFIGURATION)
        with unittest.mock.patch.dict(os.environ, OCIO=str(configuration)):
            cls.server = Server()
        cls.addClassCleanup(cls.server.close)

    def picture_of(self, colour):
        """An EXR of all directions in one colour."""
        file = pathlib.Path(self.folder.name, "sky.exr")
        subprocess.run(["oiiotool", "--pattern", "constant:color=" + ",".join(map(str, colour)), "16x8", "3", "-d", "float", "-o", file], check=True)
        return file.read_bytes()

    def test_light_is_written_in_a_colour_space(self):
        scene = self.server.new_scene("sphere", 300)
        scene.run(THIN_COAT)
        for quality in ("interactive", {"method": "strands", "trace": {"passes": 4}}):
            frame = {**FRAME, "quality": quality, "aovs": ["beauty", "albedo", "normal"]}
            plain = read_exr(scene.frame(**frame).body)
            for name in ("ACEScg", "lin_ap1"):
                answer = scene.frame(**frame, colour_space=name)
                self.assertEqual(read_attributes(answer.body)["pelage/colourSpace"], name)
                aces = read_exr(answer.body)
                for prefix in ("", "albedo."):
                    numpy.testing.assert_allclose(colours(aces, prefix), colours(plain, prefix) @ ACESCG.T, atol=2e-5)
                for same in ("A", "normal.X"):
                    numpy.testing.assert_array_equal(aces[same], plain[same])

    def test_a_space_that_is_not_linear_takes_colours_without_their_alpha(self):
        scene = self.server.new_scene("sphere", 300)
        scene.run(THIN_COAT)
        plain, curved = (read_exr(scene.frame(**FRAME, **more).body) for more in ({"colour_space": "ACES2065-1"}, {"colour_space": "curved"}))
        alpha = plain["A"][..., None]
        straight = numpy.divide(colours(plain), alpha, where=alpha > 0, out=numpy.zeros_like(colours(plain)))
        numpy.testing.assert_allclose(colours(curved), numpy.maximum(straight, 0) ** (1 / 2.2) * alpha, atol=2e-3)

    def test_spaces_that_are_not_there_are_refused(self):
        scene = self.server.new_scene("sphere", 300)
        answer = scene.post("frames", {**FRAME, "colour_space": "ACEScgg"})
        self.assertEqual((answer.status, answer.json["pointer"]), (422, "/colour_space"))
        self.assertIn("ACEScg", answer.json["limit"])
        self.assertEqual(scene.post("frames", {**FRAME, "format": "png", "colour_space": "ACEScg"}).status, 422)
        with contextlib.closing(Server()) as plain:
            answer = plain.new_scene("sphere", 300).post("frames", {**FRAME, "colour_space": "ACEScg"})
            self.assertEqual((answer.status, answer.json["pointer"]), (422, "/colour_space"))
            self.assertIn("OCIO", answer.json["limit"])

    def test_a_sky_is_read_from_its_colour_space(self):
        scene, other = self.server.new_scene("sphere", 300), self.server.new_scene("sphere", 300)
        colour = numpy.array([0.2, 0.5, 0.8])
        put = lambda to, what, **query: self.server.call("PUT", to.path + "/environment" + "".join(f"?{k}={v}" for k, v in query.items()), what)  # noqa: E731
        self.assertEqual(put(scene, self.picture_of(ACESCG @ colour), colour_space="ACEScg").status, 200)
        self.assertEqual(put(other, self.picture_of(colour)).status, 200)
        found, wanted = (numpy.array(self.server.get(each.path + "/settings").json["environment"]["harmonics"]) for each in (scene, other))
        numpy.testing.assert_allclose(found, wanted, atol=1e-5)
        answer = put(scene, self.picture_of(colour), colour_space="curved")
        self.assertEqual((answer.status, answer.json["pointer"]), (422, "/colour_space"))


if __name__ == "__main__":
    unittest.main()
