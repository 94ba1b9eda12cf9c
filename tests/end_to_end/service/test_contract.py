"""The contract that the build makes, the server and limits.h say the same."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import jsonschema

from support.contract import COMMANDS, CONTRACT, SCHEMAS, named, validator
from support.pictures import hdr, png
from support.server import BIN, REPOSITORY, ServedTest, flood


def operations():
    for path, item in CONTRACT["paths"].items():
        for method in ("get", "post", "put", "delete"):
            if method in item:
                yield path, method, item[method]


class Document(unittest.TestCase):
    def test_schemas_are_schemas(self):
        for name, schema in SCHEMAS.items():
            with self.subTest(name):
                jsonschema.Draft202012Validator.check_schema(schema)

    def test_references_lead_somewhere(self):
        for reference in re.findall(r'"\$ref": "#/([^"]+)"', json.dumps(CONTRACT)):
            here = CONTRACT
            for step in reference.split("/"):
                if isinstance(here, list):
                    here = dict(enumerate(here))
                    step = int(step)
                self.assertIn(step, here, reference)
                here = here[step]

    def test_parameters_of_paths_are_declared(self):
        for path, _, operation in operations():
            if "{id}" in path:
                self.assertIn({"$ref": "#/components/parameters/SceneId"}, CONTRACT["paths"][path]["parameters"])
            self.assertTrue(operation["operationId"])
            self.assertTrue(operation["responses"])

    def test_each_command_has_a_name_of_its_own(self):
        self.assertEqual(len(COMMANDS), len(SCHEMAS["Command"]["oneOf"]))
        for schema in COMMANDS.values():
            self.assertIn("op", SCHEMAS[schema]["required"])

    def test_objects_are_closed_and_numbers_have_limits(self):
        requests = ("NewScene", "FirstGroom", "View", "Sample", "Stroke", "Brush", "Batch", "Comb", "Blow", "Attract", "SetCoat", "SetCoats", "CoatEntry", "CoatBeginning",
                    "SetLook", "SetLights", "SetEnvironment", "Environment", "SetGround", "Ground", "SetWind", "Wind", "SetEyes", "SetSkinTexture", "SetCurves", "CurveGroup", "Eye", "Iris", "Pupil",
                    "Map", "MaskPicture", "SetSkin", "SkinRegion", "SkinFacing", "SkinBumps",
                    "Lids", "Coat", "Undercoat", "Ticking", "Tufts", "Pattern", "Variation", "Look", "Fibre", "Light", "Steps",
                    "RevisionBody", "Subdivide", "TurnModel", "SceneName", "Retarget", "ChangeEditLayer", "BranchRequest", "AmendRequest", "Knobs", "Tracing", "FrameRequest",
                    "PickRay", "PickFarthest", "RecipeRequest")
        for name in requests:
            self.assertIs(SCHEMAS[name]["additionalProperties"], False, name)
            for key, schema in SCHEMAS[name]["properties"].items():
                if schema.get("type") in ("number", "integer"):
                    self.assertIn("minimum", schema, f"{name}.{key}")
                    self.assertIn("maximum", schema, f"{name}.{key}")

    def test_random_requests_and_answers_are_described_and_nothing_else_is(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "documents"
            subprocess.run([BIN / "property_json", "--gtest_filter=Described*"], check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, env={**os.environ, "RC_PARAMS": "seed=1", "PELAGE_DOCUMENTS": str(file)})
            documents = [line.split(" ", 1) for line in file.read_text(encoding="utf-8").splitlines()]
        self.assertGreaterEqual(len(documents), 500 + 1300)
        closed = set()
        for schema, text in documents:
            document = json.loads(text)
            error = jsonschema.exceptions.best_match(named(schema).iter_errors(document))
            self.assertIsNone(error, f"{schema} {text[:2000]}")
            if schema not in closed:  # once for each: what is closed does not depend on the values
                self.assertFalse(named(schema).is_valid({**document, "undescribed": 1}), schema)
                closed.add(schema)

    def test_limits_are_those_of_the_header(self):
        text = (REPOSITORY / "base" / "limits.h").read_text()
        limits = {}
        for name, value in re.findall(r"constexpr \S+ (\w+) = ([^;]+);", text):
            value = re.sub(r"std::size_t\{(\d+)\}", r"\1", value).replace("'", "")
            limits[name] = eval(value, {"__builtins__": {}})  # noqa: S307: numbers and shifts of our own header
        whole = json.dumps(CONTRACT)
        self.assertEqual(SCHEMAS["Batch"]["properties"]["commands"]["maxItems"], limits["commands_per_batch"])
        self.assertEqual(SCHEMAS["Stroke"]["properties"]["samples"]["maxItems"], limits["samples_per_stroke"])
        self.assertIn(f"at most {limits['dabs_per_stroke']} dabs", SCHEMAS["Brush"]["properties"]["spacing"]["description"])
        self.assertEqual(SCHEMAS["SetLights"]["properties"]["lights"]["maxItems"], limits["lights"])
        self.assertEqual(SCHEMAS["Environment"]["properties"]["harmonics"]["items"]["items"]["maximum"], limits["harmonic"])
        self.assertIn(f"{limits['picture_pixels']} pixels on a side", whole)
        self.assertEqual(SCHEMAS["SetEyes"]["properties"]["eyes"]["maxItems"], limits["eyes"])
        self.assertEqual(SCHEMAS["SetCurves"]["properties"]["groups"]["maxItems"], limits["curve_groups"])
        self.assertIn(f"At most {limits['curves']} curves", SCHEMAS["SetCurves"]["description"])
        guides = SCHEMAS["CurveGroup"]["properties"]["curves"]
        self.assertEqual((guides["maxItems"], guides["items"]["maxItems"]), (limits["curves"], limits["curve_points"]))
        self.assertEqual(SCHEMAS["Eye"]["properties"]["radius"]["minimum"], limits["min_eye_radius"])
        self.assertEqual(SCHEMAS["SetSkin"]["properties"]["regions"]["maxItems"], limits["skin_regions"])
        self.assertEqual(SCHEMAS["SkinRegion"]["properties"]["radii"]["items"]["minimum"], limits["min_skin_radius"])
        self.assertEqual(SCHEMAS["Coat"]["properties"]["ramp"]["maxItems"], limits["ramp_stops"])
        self.assertEqual(SCHEMAS["Layering"]["properties"]["count"]["maximum"], limits["shells"])
        tracing = SCHEMAS["Tracing"]["properties"]
        self.assertEqual((tracing["passes"]["maximum"], tracing["strands"]["maximum"]), (limits["trace_passes"], limits["strands"]))
        self.assertEqual(SCHEMAS["FrameRequest"]["properties"]["width"]["maximum"], limits["frame_pixels"])
        of_map = SCHEMAS["MapRequest"]["properties"]
        self.assertEqual((of_map["size"]["maximum"], of_map["dilate"]["maximum"]), (limits["map_pixels"], limits["map_dilation"]))
        self.assertEqual(SCHEMAS["MeshRequest"]["properties"]["triangles"]["maximum"], limits["proxy_triangles"])
        self.assertEqual(SCHEMAS["StoredPicture"]["properties"]["width"]["maximum"], limits["picture_pixels"])
        self.assertEqual(SCHEMAS["NewScene"]["properties"]["name"]["maxLength"], limits["name_bytes"])
        self.assertIn(f"At most {limits['edit_layers']}.", SCHEMAS["ChangeEditLayer"]["description"])
        self.assertEqual(SCHEMAS["Scene"]["properties"]["edit_layers"]["maxItems"], limits["edit_layers"])
        self.assertEqual(SCHEMAS["Subdivide"]["properties"]["levels"]["maximum"], limits["subdivide_levels"])
        self.assertEqual(SCHEMAS["SceneList"]["properties"]["scenes"]["maxItems"], limits["scenes"])
        builtin = SCHEMAS["BuiltinModel"]["properties"]
        self.assertEqual(builtin["triangles"]["maximum"], limits["builtin_triangles"])
        self.assertEqual(CONTRACT["components"]["parameters"]["Wait"]["schema"]["maximum"], limits["wait_seconds"])
        for name in ("command_body_bytes", "model_bytes", "model_triangles", "picture_bytes"):
            self.assertIn(str(limits[name]), whole, name)
        self.assertIn(f"{limits['json_depth']} levels", whole)
        self.assertIn(f"{int(limits['command_coordinate_sizes'])} sizes", whole)


class Answers(ServedTest):
    def check(self, path, method, answer):
        operation = CONTRACT["paths"][path][method]
        response = operation["responses"].get(str(answer.status), operation["responses"].get("default"))
        self.assertIsNotNone(response, (path, method, answer))
        while "$ref" in response:
            response = CONTRACT["components"]["responses"][response["$ref"].rsplit("/", 1)[1]]
        kind = answer.headers.get("content-type", "").split(";")[0]
        if "content" not in response:
            return self.assertEqual(answer.body, b"")
        self.assertIn(kind, response["content"], (path, method, answer))
        if kind.endswith("json"):
            validator(response["content"][kind]["schema"]).validate(answer.json)
        for header in response.get("headers", {}):
            if header not in ("Pelage-Trace", "Pelage-Missed"):  # of traced pictures, and of those that missed something
                self.assertIn(header.lower(), answer.headers)

    def test_the_served_contract_is_the_made_one(self):
        self.assertEqual(self.server.get("/openapi.json").json, CONTRACT)

    def test_every_operation_answers_what_it_says(self):
        scene = self.server.new_scene("sphere", 500)
        scene.thin_out()
        body = {"/v1/scenes": {"model": {"builtin": "plane", "triangles": 2}}, "commands": flood([0, 1, 0]), "undo": {}, "redo": {"steps": 1}, "branch": {"name": "side"},
                "subdivide": {"levels": 1, "masked": False}, "turn": {"up": "y", "front": "z"}, "rename": {"name": "other"}, "open": self.server.get(f"{scene.path}/export/pelage").body, "frames": {"width": 16, "height": 16}, "pick": {"pixel": [256, 256]},
                "recipe": {"recipe": {"steps": [{"pick": {"nearest": [0, 0, 0]}, "as": "near"}, {"op": "lift", "flood": True, "assert": {"min_vertices": 1}}]}}}
        files = {"model": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n",
                 "environment": hdr([[[1, 1, 1]]]), "skin_texture": png([[[1, 2, 3]]]), "pictures": png([[[1, 2, 3]]]),
                 "{field}": png([[[1, 2, 3]]]), "guides": b'{"curves": [[[0.2, 0.2, 0], [0.2, 0.3, 0.1]]]}'}
        asset = re.search(rb'"/assets/([^"]+)"', self.server.get("/").body)[1].decode()
        seen = 0
        for path, method, _ in operations():
            name = path.rsplit("/", 1)[1]
            if method == "delete" or name == "events":  # which do not end: test_events.py
                continue
            revision = scene.info()["revision"] if name != "scenes" else 0
            query = {"model": "?format=obj", "guides": "?format=json", "frame.png": "?width=16&height=16", "compare": f"?from={revision}&to={revision}"}
            file = "comb.html" if path.startswith("/docs") else asset
            address = path.replace("{id}", scene.id).replace("{field}", "length").replace("{format}", "hair").replace("{name}", file) + query.get(name, "")
            body["revert"] = {"revision": revision}
            if name == "amend":
                steps = [entry["revision"] for entry in self.server.get(f"{scene.path}/log").json["entries"] if entry["in_effect"]]
                body["amend"] = {"revision": steps[-1], "commands": [flood([1, 0, 0])]}
            sent = None if method == "get" else files[name] if method == "put" else body.get(path, body.get(name))
            with self.subTest(f"{method} {path}"):
                type_of = {"Content-Type": "application/octet-stream"} if name == "open" else {}
                answer = self.server.call(method.upper(), address, sent, headers=type_of)
                self.assertLess(answer.status, 400, answer)
                self.check(path, method, answer)
                if method == "post":
                    self.check(path, method, self.server.call("POST", address, "{"))
                self.check(path, method, self.server.call(method.upper(), address, sent, headers={"Host": "evil.example"}))
                seen += 1
        self.assertGreaterEqual(seen, 25)
        self.check("/v1/scenes/{id}/log", "get", self.server.get(f"{scene.path}/log?format=jsonl"))
        self.check("/v1/scenes/{id}/pick", "post", scene.post("pick", {"pixel": [0, 0]}))
        self.check("/v1/scenes/{id}", "delete", self.server.call("DELETE", scene.path))
        self.check("/v1/scenes/{id}", "delete", self.server.call("DELETE", scene.path))


class Status(ServedTest):
    own_server = True

    def test_metrics(self):
        scene = self.server.new_scene("plane", 2)
        scene.thin_out()
        scene.frame(width=8, height=8)
        self.server.get("/nowhere")
        text = self.server.get("/metrics").body.decode()
        for line in ('pelage_requests_total{route="/v1/scenes",status="201"} 1', "pelage_scenes 1", "pelage_ready 1",
                     'pelage_requests_total{route="/v1/scenes/{id}/frames",status="200"} 1', "pelage_frames_total 1",
                     "pelage_frame_seconds_count 1", 'pelage_requests_total{route="other",status="404"} 1'):
            self.assertIn(line + "\n", text)
        self.assertNotIn(scene.id, text)
        self.assertGreater(int(re.search(r"process_resident_memory_bytes (\d+)", text)[1]), 1 << 20)
        for line in text.splitlines():
            self.assertRegex(line, r'^(# (HELP|TYPE) \S+ .+|[a-z_]+(\{([a-z]+="[^"]*",?)+\})? [0-9.e+-]+)$')

    def test_health(self):
        self.assertEqual(self.server.get("/livez").body, b"alive\n")
        self.assertEqual(self.server.get("/readyz").body, b"ready\n")


if __name__ == "__main__":
    unittest.main()
