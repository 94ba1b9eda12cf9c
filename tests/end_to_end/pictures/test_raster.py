"""Frames of rasterized strands: bits, layers, crops, what is refused, and what a stroke changes."""

import unittest

import numpy

from support.exr import read_exr
from support.nightly import nightly
from support.server import THIN_COAT, ServedTest, Server, comb, flood, shared_server

ALL = {"method": "raster", "raster": {"strands": 1000, "light_of": 1}}
VIEW = {"camera": {"auto": "front"}, "width": 160, "height": 120, "quality": {"method": "raster"}}
LIGHT = {**VIEW, "format": "exr", "exr_type": "float", "background": "transparent"}


def thin_scene(server, builtin="sphere", triangles=2000):
    """At revision 1."""
    scene = server.new_scene(builtin, triangles)
    scene.run(THIN_COAT)
    return scene


class Raster(ServedTest):
    @nightly
    def test_it_covers_and_shines_as_traced_strands(self):
        scene = self.server.new_scene("sphere", 2000)
        scene.run({"op": "set_ground", "ground": {"visible": False}})
        traced = {"method": "strands", "trace": {"passes": 32, "filter": False}}
        curls = {"curl": 0.12, "curl_turns": 8, "curl_together": 0.5, "clump": 0.5}
        band = {"ramp": [{"at": at, "colour": [grey] * 3} for at, grey in ((0, 0.4), (0.7, 0.4), (0.75, 0.08), (1, 0.4))]}
        larger = {"width": 240, "height": 180}  # curls at the silhouette are wide beside pixels of the smaller one
        # Shadows are as coarse as the grid's cells, those of curls guessed.
        for coat, size, apart in (({}, {}, 0.08), (band, {}, 0.08), (curls, larger, 0.12)):
            view = {**LIGHT, **size}
            scene.run({"op": "set_coat", "coat": coat})
            truth = read_exr(scene.frame(**{**view, "quality": traced}).body)
            for quality in (ALL, {"method": "raster"}, {"method": "raster", "scale": 2}):
                drawn = read_exr(scene.frame(**{**view, "quality": quality}).body)
                self.assertAlmostEqual(drawn["A"].sum() / truth["A"].sum(), 1, delta=0.03, msg=(coat, quality))
                self.assertAlmostEqual(drawn["G"].sum() / truth["G"].sum(), 1, delta=apart, msg=(coat, quality))

    def test_the_layers_are_those_of_the_picture(self):
        scene = self.server.new_scene("sphere", 2000)
        scene.run({"op": "set_coat", "coat": {"count": 1500, "width_root": 0.003}})
        scene.run(flood([0, -1, 0], lean=0.6))
        names = ["beauty", "depth", "position", "normal", "tangent", "albedo", "direct", "shadow"]
        layers = read_exr(scene.frame(**{**LIGHT, "quality": ALL, "aovs": names}).body)
        middle = (60, 80)
        normal = [layers[f"normal.{k}"][middle] for k in "XYZ"]
        self.assertGreater(normal[2], 0.95)
        self.assertLess(layers["tangent.Y"][middle], -0.2, "the fur leans down")
        self.assertTrue(numpy.isfinite(layers["Z"][middle]))
        self.assertTrue(numpy.isinf(layers["Z"][0, 0]))
        self.assertGreater(layers["position.Z"][middle], 0.4)
        self.assertTrue((layers["direct.G"] <= layers["G"] + 1e-3).all(), "the rest is light from around")
        self.assertTrue(((layers["shadow.Y"] >= 0) & (layers["shadow.Y"] <= 1)).all())
        self.assertGreater(layers["albedo.R"][middle], layers["albedo.B"][middle])

    def test_a_crop_has_the_pixels_of_the_whole(self):
        scene = thin_scene(self.server, "torus")
        whole = scene.frame(**VIEW).image
        crop = {"left": 33, "top": 21, "width": 70, "height": 50}
        part = scene.frame(**VIEW, crop=crop).image
        self.assertTrue((part == whole[21:71, 33:103]).all())

    def test_strokes_are_seen_and_undone_to_the_bit(self):
        scene = thin_scene(self.server)
        before = scene.frame(**VIEW).body
        self.assertEqual(scene.run(comb([-0.3, 0, 0.5], [0.3, 0, 0.5], radius=0.2)).status, 200)
        combed = scene.frame(**VIEW).body
        self.assertNotEqual(combed, before)
        scene.post("undo", {})
        self.assertEqual(scene.frame(**VIEW).body, before)
        self.assertEqual(scene.frame(**VIEW, revision=2).body, combed)
        other = thin_scene(self.server)
        other.run(comb([-0.3, 0, 0.5], [0.3, 0, 0.5], radius=0.2))
        self.assertEqual(other.frame(**VIEW).body, combed, "grown at once, not after what was there")

    def test_threads_change_no_bit(self):
        scene = self.server.new_scene("creature", 3000)
        with_two = scene.frame(**VIEW).body
        alone = Server(threads=1)
        try:
            self.assertEqual(alone.new_scene("creature", 3000).frame(**VIEW).body, with_two)
        finally:
            alone.close()

    def test_overlays_lie_over_it(self):
        scene = thin_scene(self.server)
        plain = scene.frame(**VIEW).image.astype(int)
        shown = scene.frame(**VIEW, overlay="length").image.astype(int)
        self.assertGreater(abs(shown[60, 80, :3] - plain[60, 80, :3]).max(), 20)
        self.assertLess(abs(shown[0, 0, :3] - plain[0, 0, :3]).max(), 2)

    def test_what_does_not_go_together_is_refused(self):
        scene = self.server.new_scene("plane", 2)
        for quality, pointer in (({"method": "raster", "shells": {}}, "/quality/shells"),
                                 ({"method": "raster", "trace": {}}, "/quality/trace"),
                                 ({"method": "raster", "raster": {"light_of": 9}}, "/quality/raster/light_of"),
                                 ({"method": "raster", "raster": {"strands": 0}}, "/quality/raster/strands"),
                                 ({"method": "strands", "scale": 2}, "/quality/scale")):
            self.assert_problem(scene.post("frames", {**VIEW, "quality": quality}), 422, pointer)

    def test_shells_need_a_gl(self):
        shells = {**VIEW, "quality": {"method": "shells"}, "background": "transparent"}
        self.assert_problem(self.server.new_scene("sphere", 500).post("frames", shells), 422, "/quality/method")
        scene = thin_scene(shared_server({"gl": "osmesa"}))
        drawn, strands = (scene.frame(**{**shells, **more}).image.astype(float) for more in ({}, {"quality": {}}))
        self.assertAlmostEqual(drawn[..., 3].sum() / strands[..., 3].sum(), 1, delta=0.1, msg="it is the same ball")
        self.assertGreater(abs(drawn - strands).mean(), 1, "drawn another way")
        light = read_exr(scene.frame(**{**shells, "format": "exr", "aovs": ["beauty", "alpha"]}).body)
        self.assertGreater(light["G"].max(), 0.05)

    def test_an_address_and_a_dry_run_know_it(self):
        scene = thin_scene(self.server)
        answer = self.server.get(f"{scene.path}/frame.png?camera=front&width=160&height=120&method=raster")
        self.assertEqual(answer.body, scene.frame(**VIEW).body)
        cost = scene.post("frames?dry_run=1", VIEW).json
        self.assertGreater(cost["seconds"], 0)
        self.assertLess(cost["seconds"], 1)

    def test_a_traced_picture_follows_it(self):
        scene = thin_scene(self.server)
        request = {**VIEW, "progressive": {"passes": 2, "strands": 20000}}
        first = scene.post("frames", request)
        self.assertEqual((first.status, first.headers["pelage-trace"][:12]), (200, '{"passes":0,'))
        better = scene.post("frames?after=1&after_pass=0&wait=20", request)
        self.assertEqual(better.status, 200, better)
        self.assertNotEqual(better.body, first.body)


if __name__ == "__main__":
    unittest.main()
