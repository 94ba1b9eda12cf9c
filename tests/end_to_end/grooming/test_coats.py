"""Coats over HTTP: grooming, drawing, tracing, picking and exporting several of them."""

import json
import pathlib
import re
import unittest

import numpy

from support.server import ServedTest

RECIPES = pathlib.Path(__file__).parents[3] / "clients" / "recipes"
FRAME = {"width": 160, "height": 160, "background": "transparent", "camera": {"auto": "left"}}
THIN = {"op": "set_coat", "coat": {"count": 400, "width_root": 0.002, "ramp": [{"at": 0, "colour": "#ffffff"}]}}
LOOK = {"op": "set_look", "look": {"colour_source": "coat"}}
BLUE = {"count": 400, "width_root": 0.002, "ramp": [{"at": 0, "colour": "#0000ff"}]}


class Coats(ServedTest):
    def scene_with_mane(self, **begins):
        scene = self.server.new_scene("creature", 3000)
        mane = {"name": "mane", "begins": {"length": 2, **begins}, "coat": BLUE}
        self.assertEqual(scene.run(THIN, LOOK, {"op": "set_coats", "coats": [{"name": "fur"}, mane]}).status, 200)
        return scene

    def blue(self, scene, **frame):
        """The share of pixels that are blue."""
        picture = scene.frame(**{**FRAME, **frame}).image.astype(int)
        return ((picture[..., 2] > picture[..., 0] + 60) & (picture[..., 3] > 60)).mean()

    def test_a_coat_is_drawn_and_traced_where_its_density_is(self):
        scene = self.scene_with_mane(region="none")
        frames = [{"quality": quality} for quality in ("draft", "interactive", "detailed")]
        frames.append({"quality": "reference", "width": 48, "height": 48})
        for frame in frames:
            self.assertEqual(self.blue(scene, **frame), 0, frame)
        scene.run({"op": "paint", "coats": ["mane"], "flood": True, "field": "density", "value": 1, "brush": {"strength": 1}})
        for frame in frames:
            self.assertGreater(self.blue(scene, **frame), 300 / 160**2, frame)
        scene.run({"op": "set_coats", "coats": [{"name": "fur"}, {"name": "mane", "muted": True}]})
        self.assertEqual(self.blue(scene, quality="interactive"), 0)
        self.assertEqual([(coat["name"], coat["id"], coat["muted"]) for coat in scene.info()["coats"]], [("fur", 0, False), ("mane", 1, True)])

    def test_a_new_coat_grows_as_far_as_the_mask_allows(self):
        scene = self.server.new_scene("creature", 3000)
        front = {"op": "mask", "box": {"min": [-9, -9, 0], "max": [9, 9, 9]}}
        scene.run(THIN, LOOK, front, {"op": "set_coats", "coats": [{"name": "fur"}, {"name": "mane", "begins": {"region": "mask", "length": 2}, "coat": BLUE}]})
        picture = scene.frame(**FRAME).image.astype(int)
        blue = numpy.nonzero((picture[..., 2] > picture[..., 0] + 60) & (picture[..., 3] > 60))[1]
        furred = numpy.nonzero(picture[..., 3] > 60)[1]
        self.assertGreater(len(blue), 300)
        middle = (furred.min() + furred.max()) / 2
        self.assertGreater(max((blue < middle).mean(), (blue > middle).mean()), 0.9, "one half of the animal")

    def test_a_picture_after_a_stroke_is_the_one_that_is_drawn_anew(self):
        scene = self.scene_with_mane()
        before = scene.frame(**FRAME, view="a").image
        scene.run({"op": "length", "coats": ["mane"], "value": 0.2, "brush": {"radius": 0.1, "strength": 1}, "stroke": {"samples": [{"position": [0, 0.4, 0]}]}})
        after = scene.frame(**FRAME, view="a").image
        self.assertGreater(numpy.abs(after.astype(int) - before).max(), 30)
        numpy.testing.assert_array_equal(after, scene.frame(**FRAME, view="b").image)
        scene.run({"op": "set_coats", "coats": [{"name": "fur", "muted": True}, {"name": "mane"}]})
        muted = scene.frame(**FRAME, view="a").image
        numpy.testing.assert_array_equal(muted, scene.frame(**FRAME, view="c").image)
        scene.run({"op": "set_coats", "coats": [{"name": "mane"}, {"name": "fur"}]})
        numpy.testing.assert_array_equal(scene.frame(**FRAME, view="a").image, scene.frame(**FRAME, view="d").image)

    def test_a_pick_names_the_coat_of_the_strand(self):
        scene = self.scene_with_mane()
        scene.run({"op": "paint", "coats": ["mane"], "flood": True, "field": "density", "value": 0.2, "brush": {"strength": 1}})
        view = {"camera": {"auto": "left"}, "width": 160, "height": 160}
        coats = set()
        for x in range(30, 130, 9):
            for y in range(30, 130, 9):
                at = {"view": view, "pixel": [x + 0.5, y + 0.5]}
                picked, skin = scene.post("pick", at).json, scene.post("pick", {**at, "reach": "skin"}).json
                if picked.get("strand", {}).get("kind") != "coat":
                    continue
                coats.add(picked["strand"]["coat"])
                if picked["hit"]:
                    times = 2 if picked["strand"]["coat"] == "mane" else 1
                    self.assertAlmostEqual(picked["length"], times * skin["length"], places=6)
        self.assertEqual(coats, {"fur", "mane"})

    def document_of(self, glb):
        """The JSON of a GLB: its length stands at byte 12, its kind at 16."""
        return json.loads(glb[20:20 + int.from_bytes(glb[12:16], "little")])

    def test_files_name_coats_and_hold_those_that_are_asked_for(self):
        scene = self.scene_with_mane()

        def groups(query=""):
            text = self.server.get(f"{scene.path}/export/usda{query}").body.decode()
            ids = re.search(r"groom_group_id = \[(.*?)\]", text)[1].split(", ")
            names = re.search(r"groom_group_name = \[(.*?)\]", text)[1].split(", ")
            return {pair: list(zip(ids, names)).count(pair) for pair in set(zip(ids, names))}

        whole = groups("?curves=false")
        self.assertEqual(set(whole), {("0", '"fur"'), ("1", '"mane"')})
        self.assertEqual(groups("?coat=mane&curves=false"), {("1", '"mane"'): whole[("1", '"mane"')]})
        self.assertEqual(groups()[("8", '"whiskers"')], groups("?coat=fur")[("8", '"whiskers"')])
        for format in ("shells", "cards"):
            document = self.document_of(self.server.get(f"{scene.path}/export/{format}").body)
            self.assertEqual({material["name"].split()[0] for material in document["materials"]}, {"skin", "eyes", "fur", "mane"}, format)
        refused = self.server.get(f"{scene.path}/export/fields")
        self.assertEqual((refused.status, refused.json["pointer"]), (422, "/coat"))
        self.assertEqual(self.server.get(f"{scene.path}/export/fields?coat=mane").status, 200)
        self.assertEqual(self.server.get(f"{scene.path}/export/usda?coat=beard").json["pointer"], "/coat")

    def test_maps_guides_and_overlays_take_a_coat(self):
        scene = self.scene_with_mane(length=4)
        lengths = {coat: self.server.get(f"{scene.path}/maps/length?coat={coat}&encoding=vertices&format=npy").body for coat in ("fur", "mane")}
        self.assertEqual(len(set(lengths.values())), 2)
        root = scene.post("pick", {"view": {"camera": {"auto": "left"}, "width": 100, "height": 100}, "pixel": [50, 50], "reach": "skin"}).json["position"]
        curves = {"curves": [[root, [root[0] + 0.1, root[1] + 0.3, root[2]]]]}
        self.assertEqual(self.server.call("PUT", f"{scene.path}/guides?format=json&coat=mane", curves).status, 200)
        same = self.server.get(f"{scene.path}/maps/length?coat=fur&encoding=vertices&format=npy").body
        self.assertEqual(same, lengths["fur"])
        first, second = (scene.frame(**FRAME, overlay="length", overlay_coat=coat).image for coat in ("fur", "mane"))
        self.assertGreater(numpy.abs(first.astype(int) - second).max(), 0)
        refused = scene.post("frames", {**FRAME, "overlay": "length", "overlay_coat": "beard"})
        self.assertEqual((refused.status, refused.json["pointer"]), (422, "/overlay_coat"))

    def test_what_cannot_be_is_refused_by_name(self):
        scene = self.scene_with_mane()
        refusals = [
            ({"op": "comb", "flood": True, "direction": [0, 1, 0], "coats": ["beard"]}, "/coats/0"),
            ({"op": "comb", "flood": True, "direction": [0, 1, 0], "coats": ["fur", "fur"]}, "/coats"),
            ({"op": "set_coat", "name": "beard", "coat": {}}, "/name"),
            ({"op": "set_coats", "coats": []}, "/coats"),
            ({"op": "set_coats", "coats": [{"name": "fur", "muted": True}]}, "/coats"),
            ({"op": "set_coats", "coats": [{"name": "a", "id": 8}]}, "/coats/0/id"),
            ({"op": "set_coats", "coats": [{"name": "a"}, {"name": "a"}]}, "/coats/1/name"),
            ({"op": "set_coats", "coats": [{"name": "fur"}, {"name": "tail", "begins": {"from": "beard"}}]}, "/coats/1/begins/from"),
            ({"op": "edit_layer", "name": "swept", "coat": "beard"}, "/coat"),
        ]
        revision = scene.info()["revision"]
        for command, pointer in refusals:
            answer = scene.run(command)
            self.assertEqual((answer.status, answer.json["pointer"]), (422, pointer), command)
        self.assertEqual(scene.info()["revision"], revision)

    def test_the_lion_and_the_terrier_have_four_coats(self):
        for name, coats in (("lion", ["fur", "mane", "tuft", "undercoat"]), ("terrier", ["fur", "saddle", "furnishings", "undercoat"])):
            scene = self.server.new_scene("creature", 3000)
            self.pelage("run", scene.id, str(RECIPES / f"{name}.json"))
            self.assertEqual([coat["name"] for coat in scene.info()["coats"]], coats)
            printed = self.pelage("info", scene.id).stdout
            self.assertTrue(all(f"coat        {coat}\n" in printed for coat in coats), printed)


if __name__ == "__main__":
    unittest.main()
