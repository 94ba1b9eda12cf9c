"""The contract and the decoder agree: on what they take and refuse, and on the values of members that are not given."""

import json
import unittest

from support.contract import COMMANDS, SCHEMAS, named
from support.pictures import png
from support.server import ServedTest, comb, flood


class Requests(ServedTest):
    """The schemas and the decoder take and refuse the same requests."""

    def agree(self, schema, body, send):
        if schema == "Command" and isinstance(body.get("op"), str):
            schema = COMMANDS.get(body["op"], schema)  # no other can match, and to see that takes long
        valid = named(schema).is_valid(body)
        answer = send(body)
        self.assertEqual(answer.status < 400, valid, (body, answer))

    def variations(self, body):
        """The body itself, and with each member missing, of another type, too small or too large, and unknown ones."""
        yield body
        yield {**body, "unknown": 1}
        for key, value in body.items():
            yield {k: v for k, v in body.items() if k != key}
            for other in (None, "text", [], {}, True, -1, 1e30, 0.5):
                if other != value:
                    yield {**body, key: other}
            if key != "samples" and isinstance(value, list) and value and isinstance(value[0], dict):  # their times depend on each other
                for inner in self.variations(value[0]):
                    yield {**body, key: [inner, *value[1:]]}
            if isinstance(value, dict):
                for inner in self.variations(value):
                    yield {**body, key: inner}

    def test_commands(self):
        scene = self.server.new_scene("plane", 50)
        view = {"camera": {"auto": "front"}, "width": 64, "height": 64}
        full_brush = {"radius": 0.05, "units": "world", "falloff_shape": "volume", "falloff": "smooth", "strength": 0.8,
                      "spacing": 0.5, "front_faces_only": True, "invert": False}
        kept = self.server.call("PUT", f"{scene.path}/pictures", png([[[9, 9, 9]]])).json["picture"]
        bodies = [
            {"op": "map", "picture": kept, "field": "length", "encoding": "value", "scale": 0.05, "units": "world", "strength": 0.5},
            {"op": "map", "picture": kept, "field": "direction", "encoding": "fast_fur"},
            {"op": "mask", "picture": {"name": kept, "channel": "red"}, "combine": "add", "value": 0.25},
            {**comb([0, 0, 0], [1, 0, 0], samples=2), "brush": full_brush, "lean": 0.5},
            flood([0, 1, 0]),
            {"op": "comb", "stroke": {"id": "", "part": 0, "last": True, "view": view,
                                      "samples": [{"screen": [3, 4], "pressure": 0.5, "time": 1}]}},
            {"op": "blow", "source": [0, 1, 0], "direction": [0, -1, 0], "cone_degrees": 40, "softness": 0.25, "strength": 0.5},
            {"op": "attract", "point": [0, 0.4, 0.6], "radius": 0.2, "units": "world", "duration": 1.0, "threshold": 0.3,
             "max_stretch": 3},
            {"op": "set_look", "look": {"colour_source": "coat", "ambient": 0.3, "skin": "#102030", "back_attenuation": 0.5}},
            {"op": "set_coat", "coat": {"count": 100, "tile": 0.2, "curl": 0.1, "lean_curve": "root", "seed": 3,
                                        "ramp": [{"at": 0, "colour": [0, 0, 0]}], "wave": 0.1, "lodge": 0.5, "wetness": 0.5,
                                        "undercoat": {"share": 0.5, "length": 0.4, "colour": "#808080"},
                                        "ticking": {"share": 0.1, "colour": [1, 1, 1]},
                                        "tufts": {"gather": 0.5, "size": 0.2, "scales": 3, "seed": 5},
                                        "pattern": {"kind": "stripes", "axis": [0, 0, 1], "colour": "#000000", "seed": 4},
                                        "variation": {"lightness": 0.2, "size": 0.1}}},
            {"op": "set_coats", "coats": [{"name": "mane", "begins": {"region": "none", "length": 2}, "coat": {"count": 100}}]},
            {"op": "set_environment", "environment": {"sky": [1, 1, 1], "ground": "#102030", "intensity": 2}},
            {"op": "set_environment", "environment": {"harmonics": [[1, 2, 3]] * 9, "turn_degrees": 30, "intensity": 2}},
            {"op": "set_skin_texture", "picture": "own"},
            {"op": "set_wind", "wind": {"speed": 2, "direction": [0, 0, 1], "gusts": 0.25, "turbulence": 0.5, "turbulence_scale": 0.1, "seed": 3,
                                        "frequency": 3, "damping": 0.5, "time": -2}},
            {"op": "set_lights", "lights": [{"kind": "point", "position": [0, 1, 0], "colour": "#ffffff", "intensity": 2, "radius": 0.25}]},
            {"op": "set_lights", "lights": [{"kind": "area", "direction": [0, -1, 0], "position": [0, 1, 0], "width": 0.5, "height": 0.25},
                                            {"kind": "directional", "angle_degrees": 4}]},
            {"op": "set_eyes", "eyes": [{"position": [0, 1, 0], "radius": 0.02, "gaze": [0, 0, 1], "sclera": "#ffffff", "bulge": 0.25,
                                         "iris": {"colour": "#806020", "size": 0.5, "depth": 0.25, "relief": 0.1, "limbal_ring": 0.25},
                                         "pupil": {"shape": "slit", "size": 0.25}, "refraction": 1.5, "wetness": 0.25,
                                         "lids": {"facing": [0, 0, 1], "width_degrees": 60, "upper_degrees": 20}},
                                        {"position": [0, 1, 0], "radius": 0.02, "look_at": [0, 1, 1], "pupil": {"size": "automatic"}}]},
            {"op": "set_curves", "groups": [{"curves": [[[0, 1, 0], [1, 1, 0]], [[0, 2, 0], [1, 2, 0], [1, 3, 0]]], "width_root": 0.05,
                                             "width_tip": 0.01, "root_colour": "#ffffff", "tip_colour": [0.5, 0.5, 0.5], "fill": 3,
                                             "spread": 0.25, "seed": 7}]},
            {"op": "set_curves", "groups": []},
            {"op": "set_skin", "regions": [{"centre": [0, 1, 0], "radii": [0.1, 0.2, 0.3], "axis": [0, 0, 1], "turn_degrees": 20,
                                            "softness": 0.25, "facing": {"direction": [0, 0, 1], "angle_degrees": 60, "fade_degrees": 5},
                                            "colour": "#101010", "shine": 0.5, "roughness": 0.25, "wetness": 0.5, "scatter": 0.5,
                                            "bumps": {"height": 0.001, "size": 0.01}}]},
        ]
        for body in bodies:
            for variation in self.variations(body):
                self.agree("Command", variation, lambda b: scene.post("commands?dry_run=1", b))

    def test_frames_and_the_rest(self):
        scene = self.server.new_scene("plane", 50)
        scene.thin_out()  # what is not refused is drawn or traced
        frame = {"width": 8, "height": 8, "camera": {"position": [0, 0.5, 2], "target": [0, 0.3, 0], "up": [0, 1, 0], "fov_degrees": 35},
                 "quality": {"scale": 1.0, "eye_steps": 2},
                 "background": "transparent", "exposure": 0, "tone_map": "none", "view": "", "format": "png"}
        exr = {"width": 8, "height": 8, "background": "studio", "format": "exr", "exr_type": "half", "aovs": ["depth", "beauty"], "overlay": "none"}
        jpeg = {"width": 8, "height": 8, "background": "studio", "format": "jpeg", "lossy_quality": 50, "overlay": "strokes"}
        difference = {"width": 8, "height": 8, "overlay": "difference", "overlay_from": 0}
        past = {"width": 8, "height": 8, "revision": 0, "progressive": False, "time": 2.5}
        trace = {"passes": 1, "transport": "paths", "scattering": "energy_conserving", "bounces": 2, "strands": 100,
                 "noise": 0, "seconds": 0.1, "shutter": 0.02, "filter": True, "seed": 1}
        strands = {"width": 8, "height": 8, "quality": {"method": "strands", "eye_steps": 2, "trace": trace}, "overlay": "length"}
        look = {"width": 8, "height": 8, "quality": {"method": "strands", "trace": {"passes": 1, "scattering": "look", "strands": 100}}}
        raster = {"width": 8, "height": 8, "overlay": "length",
                  "quality": {"method": "raster", "scale": 1.0, "eye_steps": 2, "raster": {"strands": 2, "light_of": 4}}}
        progressive = {"width": 8, "height": 8, "quality": "reference", "progressive": trace}
        switched = {"width": 8, "height": 8, "quality": "reference", "progressive": False, "overlay": "wire"}
        several = [frame, exr, jpeg, difference, strands, look, raster, {**progressive, "quality": "draft", "overlay": "mask"}, progressive, {**progressive, "progressive": True},
                   switched, past]
        for variation in (v for request in several for v in self.variations(request)):
            self.agree("FrameRequest", variation, lambda b: scene.post("frames", b))
        pick = {"view": {"camera": {"auto": "front"}, "width": 600, "height": 600}, "pixel": [1, 1]}
        for variation in self.variations(pick):
            self.agree("PickRequest", variation, lambda b: scene.post("pick", b))
        for query in ({"ray": {"origin": [0, 0, 9], "direction": [0, 0, -1]}}, {"nearest": [1, 2, 3]},
                      {"farthest": {"direction": [0, 1, 0], "min": [-1, -1, -1], "max": [1, 1, 1]}}):
            for variation in self.variations(query):
                self.agree("PickRequest", variation, lambda b: scene.post("pick", b))

    def test_layers(self):
        empty, scene = self.server.new_scene("plane", 50), self.server.new_scene("plane", 50)
        scene.run({"op": "edit_layer", "name": "text"})
        for variation in self.variations({"op": "edit_layer", "action": "add", "name": "a", "weight": 0.5, "muted": True}):
            self.agree("Command", variation, lambda b: empty.post("commands?dry_run=1", b))
        for body in ({"op": "edit_layer", "action": "set", "name": "text", "weight": 0.5, "muted": True, "rename": "b"},
                     {"op": "edit_layer", "action": "move", "name": "text", "above": ""}):
            for variation in self.variations(body):
                if variation.get("above") == "text" or ("above" in variation and "action" not in variation):
                    continue  # well formed: on itself, and a new layer whose name is taken
                self.agree("Command", variation, lambda b: scene.post("commands?dry_run=1", b))
        colour = {"op": "paint", "flood": True, "field": "tip_colour"}
        for variation in self.variations({"strength": 0.5, "strand_from": 0.25, "strand_to": 0.75}):
            self.agree("Command", {**colour, "brush": variation}, lambda b: scene.post("commands?dry_run=1", b))

    def test_recipes(self):
        scene = self.server.new_scene("plane", 50)
        body = {"file": "a.json", "recipe": {"steps": [{"op": "lift", "flood": True}]}, "files": {"b.json": {"steps": []}}, "variables": {}, "places": {}}
        for key in body:
            for other in ({k: v for k, v in body.items() if k != key}, *({**body, key: value} for value in (None, 1, True, [], "text"))):
                if key != "file" or other.get(key, "") != "":
                    self.agree("RecipeRequest", other, lambda b: scene.post("recipe", b))

    def test_subdivide(self):
        for variation in self.variations({"levels": 1, "masked": True}):
            scene = self.server.new_scene("plane", 8)
            self.agree("Subdivide", variation, lambda b: scene.post("subdivide", b))
            self.server.call("DELETE", scene.path)

    def test_turn(self):
        scene = self.server.new_scene("plane", 8)
        for variation in self.variations({"up": "z", "front": "-y"}):
            self.agree("TurnModel", variation, lambda b: scene.post("turn", b))

    def test_rename(self):
        scene = self.server.new_scene("plane", 8)
        for variation in self.variations({"name": "other"}):
            self.agree("SceneName", variation, lambda b: scene.post("rename", b))

    def test_retarget(self):
        scene = self.server.new_scene("plane", 50)
        body = {"op": "retarget", "scene": scene.id, "revision": 0, "align": "none", "fields": ["length"], "strength": 0.5}
        for variation in self.variations(body):
            if variation.get("scene") == "text" or variation.get("revision") not in (0, None):
                continue  # well formed, and only the server knows that there is no such scene or revision
            self.agree("Command", variation, lambda b: scene.post("commands?dry_run=1", b))

    def test_branches_and_amendments(self):
        scene = self.server.new_scene("plane", 50)
        scene.run(flood([1, 0, 0]))

        def branch(request):
            answer = scene.post("branch", request)
            if answer.status == 201:
                self.server.call("DELETE", answer.headers["location"])
            return answer

        for variation in self.variations({"name": "a", "revision": 1}):
            self.agree("BranchRequest", variation, branch)
        amendment = {"revision": 1, "commands": [{"op": "set_ground", "ground": {"visible": True}}, flood([1, 0, 0])]}
        for variation in self.variations(amendment):
            self.agree("AmendRequest", variation, lambda b: scene.post("amend?dry_run=1", b))

    def test_new_scenes(self):
        body = {"name": "a", "model": {"builtin": "plane", "triangles": 2}, "fur": {"length": 0.1, "inclination": 0.2}, "fur_patches": "hard"}

        def create(request):
            answer = self.server.post("/v1/scenes", request)
            if answer.status == 201:
                self.server.call("DELETE", answer.headers["location"])
            return answer

        for variation in self.variations(body):
            self.agree("NewScene", variation, create)


class Defaults(ServedTest):
    """The log shows every member of a command, and so what was taken for those that were not given."""

    def assert_defaults(self, schema, taken, *, given=()):
        properties = SCHEMAS[schema]["properties"]
        for key, value in taken.items():
            declared = properties[key]
            if "default" not in declared and "$ref" in declared:
                declared = SCHEMAS[declared["$ref"].rsplit("/", 1)[1]]
            if key in given or "default" not in declared:
                continue
            if isinstance(value, list):  # colours are 32-bit inside
                for a, b in zip(value, declared["default"]):
                    self.assertAlmostEqual(a, b, places=6, msg=f"{schema}.{key}")
            elif declared["default"] == [1, 1, 1]:
                self.assertEqual(value, "#ffffff")
            else:
                self.assertEqual(value, declared["default"], f"{schema}.{key}")

    def test_commands(self):
        scene = self.server.new_scene("sphere", 500)
        answer = scene.run(comb([-0.5, 0, 0.5], [0.5, 0, 0.5], radius=1.0), {"op": "blow", "source": [0, 0, 1], "direction": [0, 0, -1]},
                           {"op": "attract", "point": [0, 0, 0.6]}, {"op": "set_coat", "coat": {"count": 10}},
                           {"op": "set_look", "look": {"ambient": 1}}, {"op": "set_lights", "lights": [{"intensity": 3}]},
                           {"op": "set_environment", "environment": {"harmonics": [[1, 1, 1]] * 9, "intensity": 1}},
                           {"op": "set_wind", "wind": {"speed": 2}},
                           {"op": "set_eyes", "eyes": [{"position": [0, 0, 1], "radius": 0.02, "lids": {}}]},
                           {"op": "set_curves", "groups": [{"curves": [[[0, 0, 1], [0, 0, 2]]]}]},
                           {"op": "set_skin", "regions": [{"centre": [0, 0, 1], "radii": [0.1, 0.1, 0.1],
                                                           "facing": {"direction": [0, 0, 1]}}]})
        self.assertEqual(answer.status, 200, answer)
        commands = self.server.get(f"{scene.path}/log").json["entries"][0]["commands"]["commands"]
        combed, blown, attracted, coat, look, lights, environment, wind, eyes, curves, skin = commands
        self.assert_defaults("Comb", combed)
        self.assert_defaults("Stroke", combed["stroke"])
        self.assert_defaults("Brush", combed["brush"], given=["radius"])
        self.assert_defaults("Brush", blown["brush"])
        self.assert_defaults("Blow", blown, given=["direction"])
        self.assert_defaults("Attract", attracted)
        self.assert_defaults("Coat", coat["coat"], given=["count"])
        for schema, part in (("Undercoat", "undercoat"), ("Ticking", "ticking"), ("Tufts", "tufts"), ("Pattern", "pattern"), ("Variation", "variation")):
            self.assert_defaults(schema, coat["coat"][part])
        self.assert_defaults("Look", look["look"], given=["ambient"])
        self.assert_defaults("Light", lights["lights"][0], given=["intensity"])
        self.assert_defaults("Environment", environment["environment"], given=["harmonics"])
        self.assert_defaults("Wind", wind["wind"], given=["speed"])
        self.assert_defaults("Eye", eyes["eyes"][0])
        self.assert_defaults("CurveGroup", curves["groups"][0])
        for schema, part in (("Iris", "iris"), ("Pupil", "pupil"), ("Lids", "lids")):
            self.assert_defaults(schema, eyes["eyes"][0][part])
        for schema, taken in (("SkinRegion", skin["regions"][0]), ("SkinFacing", skin["regions"][0]["facing"]),
                              ("SkinBumps", skin["regions"][0]["bumps"])):
            self.assert_defaults(schema, taken)

    def test_frames(self):
        scene = self.server.new_scene("sphere", 500)
        scene.thin_out()
        plain = scene.post("frames", {})
        self.assert_defaults("Knobs", json.loads(plain.headers["pelage-quality"]))
        self.assertEqual(plain.image.shape[:2], (512, 512))
        said = {key: value["default"] for key, value in SCHEMAS["FrameRequest"]["properties"].items() if "default" in value}
        self.assertEqual(scene.post("frames", said).body, plain.body)

    def test_scenes(self):
        plain = self.server.post("/v1/scenes", {}).json
        said = {"name": SCHEMAS["NewScene"]["properties"]["name"]["default"],
                "model": {k: v["default"] for k, v in SCHEMAS["BuiltinModel"]["properties"].items()},
                "fur": {k: v["default"] for k, v in SCHEMAS["FirstGroom"]["properties"].items()},
                "fur_patches": SCHEMAS["NewScene"]["properties"]["fur_patches"]["default"]}
        same = self.server.post("/v1/scenes", said).json
        for key in ("name", "model", "triangles", "fields_hash"):
            self.assertEqual(plain[key], same[key])


if __name__ == "__main__":
    unittest.main()
