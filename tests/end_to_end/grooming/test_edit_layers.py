"""Edit layers over HTTP and with the client: seen, weighed, muted, refused, in the log."""

import json
import pathlib
import tempfile

import numpy

from support.server import ServedTest

FRAME = {"width": 160, "height": 160, "background": "transparent", "camera": {"auto": "left"}}
LONGER = {"op": "length", "flood": True, "mode": "scale", "value": 3, "edit_layer": "winter", "brush": {"strength": 1}}


class Layers(ServedTest):
    arguments = {"gl": "egl"}

    def scene_with_winter(self):
        scene = self.server.new_scene("creature", 3000)
        thin = {"op": "set_coat", "coat": {"count": 500}}  # it grows at once
        self.assertEqual(scene.run(thin, {"op": "edit_layer", "name": "winter"}).status, 200)
        return scene

    def test_an_edit_layer_shows_by_its_weight(self):
        scene = self.scene_with_winter()
        summer = scene.frame(**FRAME).image
        self.assertEqual(scene.run(LONGER).status, 200)
        winter = scene.frame(**FRAME).image
        covered = lambda image: (image[..., 3] > 127).sum()
        self.assertGreater(covered(winter), 1.05 * covered(summer))
        self.assertEqual(scene.run({"op": "edit_layer", "action": "set", "name": "winter", "muted": True}).status, 200)
        numpy.testing.assert_array_equal(scene.frame(**FRAME).image, summer)
        scene.run({"op": "edit_layer", "action": "set", "name": "winter", "muted": False, "weight": 0.5})
        half = covered(scene.frame(**FRAME).image)
        self.assertTrue(covered(summer) < half < covered(winter))
        self.assertEqual(scene.info()["edit_layers"], [{"name": "winter", "weight": 0.5, "muted": False}])

    def test_what_cannot_be_is_refused_by_name(self):
        scene = self.scene_with_winter()
        revision = scene.info()["revision"]
        refusals = [
            ({**LONGER, "edit_layer": "spring"}, "/edit_layer"),
            ({"op": "edit_layer", "name": "winter"}, "/name"),
            ({"op": "edit_layer", "action": "move", "name": "winter"}, "/above"),
            ({"op": "edit_layer", "action": "set", "name": "winter"}, ""),
            ({"op": "edit_layer", "name": "heavy", "weight": 4.5}, "/weight"),
            ({"op": "paint", "flood": True, "field": "mask", "edit_layer": "winter"}, "/edit_layer"),
            ({"op": "smooth", "flood": True, "fields": ["mask", "length"], "edit_layer": "winter"}, "/edit_layer"),
            ({"op": "smooth", "flood": True, "brush": {"invert": True}}, "/brush/invert"),
            ({"op": "length", "flood": True, "brush": {"strand_to": 0.5}}, "/brush/strand_from"),
            ({"op": "paint", "flood": True, "field": "tip_colour", "brush": {"strand_from": 0.5, "strand_to": 0.5}},
             "/brush/strand_to"),
        ]
        for command, pointer in refusals:
            answer = scene.run(command)
            self.assertEqual((answer.status, answer.json["pointer"]), (422, pointer), command)
        self.assertEqual(scene.info()["revision"], revision)

    def test_the_client_shows_edit_layers_and_warnings(self):
        scene = self.scene_with_winter()
        fine = {"op": "comb", "edit_layer": "winter", "brush": {"radius": 0.001},
                "stroke": {"samples": [{"triangle": 5, "barycentric": [0.3, 0.3, 0.4]}, {"triangle": 9, "barycentric": [0.3, 0.3, 0.4]}]}}
        answer = scene.run(fine)
        self.assertIn("finer than the mesh", answer.json["results"][0]["warnings"][0])
        with tempfile.TemporaryDirectory() as folder:
            recipe = pathlib.Path(folder) / "fine.json"
            recipe.write_text(json.dumps(fine), encoding="utf-8")
            self.assertIn("warning: the brush is finer", self.pelage("run", scene.id, recipe).stdout)
        self.assertIn("layer       winter (weight 1)", self.pelage("info", scene.id).stdout)


if __name__ == "__main__":
    import unittest

    unittest.main()
