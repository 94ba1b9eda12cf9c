"""A clear problem document that names field and limit; the scene unchanged; the server alive."""

import unittest

from support.server import ServedTest, comb, flood


class BadCommands(ServedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scene = cls.server.new_scene()

    def setUp(self):
        self.before = self.scene.info()

    def tearDown(self):
        self.assertEqual(self.scene.info(), self.before)
        super().tearDown()

    def refused(self, body, status, pointer=None):
        answer = self.scene.post("commands", body)
        self.assert_problem(answer, status, pointer)
        return answer.json

    def test_not_json(self):
        for body in ("", "comb", "{", "[1,", '{"op": "comb"} {}', "\x00", '{"op": NaN}', '{"op": Infinity}'):
            self.refused(body, 400)

    def test_duplicate_keys(self):
        self.refused('{"op": "comb", "brush": {"radius": 1, "radius": 2}}', 400, "/brush/radius")

    def test_too_deep(self):
        self.refused("[" * 33 + "]" * 33, 400)

    def test_huge_numbers(self):
        self.refused('{"op": "blow", "source": [1e400, 0, 0]}', 400, "/source")
        self.refused('{"op": "blow", "source": [1e300, 0, 0]}', 422, "/source/0")
        self.refused({"op": "blow", "source": [1e25, 0, 0]}, 422)

    def test_a_coordinate_beyond_a_million_sizes(self):
        problem = self.refused(comb([0, 0, 0], [1e9, 0, 0]), 422)
        self.assertTrue(problem["pointer"].startswith("/stroke/samples/"), problem)
        self.assertTrue(problem["limit"])

    def test_unknown_names_come_with_the_nearest_known_one(self):
        problem = self.refused({**comb([0, 0, 0], [1, 0, 0]), "brsh": {}}, 422, "/brsh")
        self.assertEqual(problem["nearest"], "brush")
        self.assertEqual(self.refused({"op": "cmb"}, 422, "/op")["nearest"], "comb")

    def test_what_is_not_built_is_refused(self):
        stroke = comb([0, 0, 0], [1, 0, 0])
        stroke["brush"]["falloff_shape"] = "geodesic"
        self.assertEqual(self.refused(stroke, 422, "/brush/falloff_shape")["limit"], "volume | surface | screen")
        self.refused({"op": "subdivide"}, 422, "/op")
        stroke = comb([0, 0, 0], [1, 0, 0])
        stroke["brush"]["units"] = "pixels"
        self.refused(stroke, 422, "/stroke/view")

    def test_out_of_range(self):
        stroke = comb([0, 0, 0], [1, 0, 0])
        stroke["brush"]["strength"] = 2
        self.assertEqual(self.refused(stroke, 422, "/brush/strength")["limit"], "[0, 1]")
        self.refused(comb([0, 0, 0], [1, 0, 0], radius=-1), 422, "/brush/radius")

    def test_a_batch_is_all_or_nothing_and_names_the_command(self):
        self.refused({"commands": [flood([0, 1, 0]), flood([0, 0, 0])]}, 422, "/commands/1/direction")
        problem = self.refused({"commands": [flood([0, 1, 0]), {"op": "comb", "stroke": {"samples": [
            {"triangle": 4000000000, "barycentric": [0, 0, 1]}]}}]}, 422)
        self.assertEqual(problem["pointer"], "/commands/1/stroke/samples/0/triangle")

    def test_limits_of_counts(self):
        self.refused({"commands": [flood([0, 1, 0])] * 1001}, 422, "/commands")
        samples = [{"position": [0, 0, 0]}] * 10001
        self.refused({"op": "comb", "stroke": {"samples": samples}}, 422, "/stroke/samples")

    def test_a_body_over_the_limit(self):
        for content in ((1 << 20) + 1, 3 << 20):
            problem = self.refused(" " * content, 413)
            self.assertIn("1048576", problem["limit"])

    def test_a_body_at_the_limit_is_read(self):
        body = '{"op": "comb"}'
        self.refused(body + " " * ((1 << 20) - len(body)), 422, "/stroke")

    def test_a_stroke_that_misses(self):
        answer = self.scene.run(comb([50, 50, 50], [51, 50, 50], radius=0.01))
        self.assertEqual(answer.status, 200, answer)
        self.assertEqual(answer.json["results"][0]["touched"], 0)
        self.assertEqual(answer.json["revision"], self.before["revision"])

    def test_moves_that_are_not_there(self):
        self.assert_problem(self.scene.post("undo", {"steps": 1}), 422)
        self.assert_problem(self.scene.post("redo"), 422)
        self.assert_problem(self.scene.post("undo", {"steps": 0}), 422, "/steps")
        self.assert_problem(self.scene.post("revert", {"revision": 999}), 422)
        self.assert_problem(self.scene.post("revert", {}), 422, "/revision")

    def test_unknown_parameters(self):
        answer = self.scene.run(flood([0, 1, 0]), query="?dryrun=1")
        self.assert_problem(answer, 422, "/dryrun")
        self.assertEqual(answer.json["nearest"], "dry_run")
        self.assert_problem(self.scene.run(flood([0, 1, 0]), query="?dry_run=yes"), 422, "/dry_run")

    def test_a_dry_run_changes_nothing(self):
        answer = self.scene.run(flood([0, 1, 0], lean=0.9), query="?dry_run=1")
        self.assertEqual(answer.status, 200, answer)
        self.assertGreater(answer.json["results"][0]["touched"], 0)


class BadFrames(ServedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scene = cls.server.new_scene()
        cls.scene.run({"op": "set_coat", "coat": {"count": 500}})  # it grows at once

    def test_sizes(self):
        for width, height, pointer in ((0, 0, "/width"), (8193, 64, "/width"), (64, 8193, "/height"), (-1, 64, "/width"),
                                       (1e9, 64, "/width"), (1.5, 64, "/width"), (None, 64, "/width")):
            self.assert_problem(self.scene.post("frames", {"width": width, "height": height}), 422, pointer)
        self.assert_problem(self.server.get(f"{self.scene.path}/frame.png?width=0"), 422, "/width")

    def test_cameras(self):
        def refused(camera, pointer):
            self.assert_problem(self.scene.post("frames", {"camera": camera}), 422, pointer)
        refused({"auto": "below"}, "/camera/auto")
        refused({"position": [0, 0, 1]}, "/camera/target")
        refused({"position": [0, 0, 1], "target": [0, 0, 1]}, "/camera")
        refused({"position": [0, 1, 0], "target": [0, 0, 0]}, "/camera/up")
        refused({"position": [0, 0, 1], "target": [0, 0, 0], "fov_degrees": 180}, "/camera/fov_degrees")

    def test_dials(self):
        def refused(request, pointer):
            self.assert_problem(self.scene.post("frames", request), 422, pointer)
        for value in (0, 0.5, -1, 600001, "40", None):
            refused({"budget_ms": value}, "/budget_ms")
        for value in (0, -1, 1.1, "low"):
            refused({"max_error": value}, "/max_error")
        refused({"budget_ms": 40, "quality": "draft"}, "/budget_ms")
        refused({"max_error": 0.1, "quality": {"scale": 1}}, "/max_error")
        refused({"budget_ms": 40, "max_error": 0.1}, "/max_error")
        self.assert_problem(self.server.get(f"{self.scene.path}/frame.png?budget_ms=40&scale=1"), 422, "/budget_ms")

    def test_extremes_give_a_picture(self):
        for request in ({"width": 1, "height": 1}, {"width": 8192, "height": 1}, {"exposure": 20}, {"exposure": -20},
                        {"camera": {"position": [0, 0, 1e20], "target": [0, 0, 0]}},
                        {"camera": {"position": [0, 0, 1e-9], "target": [0, 0, 0]}},
                        {"quality": {"raster": {"strands": 0.01}}}, {"camera": {"position": [0, 0, 3], "target": [0, 0, 0], "fov_degrees": 150}}):
            self.scene.frame(**request)

    def test_picks(self):
        self.assert_problem(self.scene.post("pick", {"pixel": [513, 0]}), 422, "/pixel/0")
        self.assert_problem(self.scene.post("pick", {}), 422, "/pixel")


class BadScenes(ServedTest):
    def test_new_scenes(self):
        for body, pointer in (({"name": ""}, "/name"), ({"name": "x" * 201}, "/name"), ({"name": "a\nb"}, "/name"),
                              ({"model": {"builtin": "cow"}}, "/model/builtin"),
                              ({"model": {"builtin": "torus", "triangles": 0}}, "/model/triangles"),
                              ({"fur": {"length": -1}}, "/fur/length"), ({"modle": {}}, "/modle")):
            self.assert_problem(self.server.post("/v1/scenes", body), 422, pointer)
        self.assertEqual(self.server.get("/v1/scenes").json, {"scenes": []})

    def test_scenes_that_are_not_there(self):
        for method, path, body in (("GET", "", None), ("DELETE", "", None), ("POST", "/commands", flood([0, 1, 0])),
                                   ("GET", "/frame.png", None), ("GET", "/log", None), ("POST", "/pick", {"pixel": [1, 1]}),
                                   ("PUT", "/model?format=obj", b"v 0 0 0")):
            for identifier in ("nobody", "%2e%2e", "'; drop table scenes; --".replace(" ", "%20")):
                self.assert_problem(self.server.call(method, f"/v1/scenes/{identifier}{path}", body), 404)

    def test_addresses_and_methods_that_are_not_there(self):
        self.assert_problem(self.server.get("/v1/scene"), 404)
        self.assert_problem(self.server.get("/../etc/passwd"), 404)
        self.assert_problem(self.server.call("PUT", "/v1/scenes", b"x"), 405)
        self.assert_problem(self.server.call("DELETE", "/v1/scenes"), 405)

    def test_the_limit_of_scenes(self):
        made = [self.server.new_scene("plane", 2) for _ in range(64)]
        answer = self.server.post("/v1/scenes", {"model": {"builtin": "plane", "triangles": 2}})
        self.assert_problem(answer, 409)
        self.assertNotIn("retry-after", answer.headers)  # it would not help
        for scene in made:
            self.assertEqual(self.server.call("DELETE", scene.path).status, 204)
        self.assertEqual(self.server.get("/v1/scenes").json, {"scenes": []})


if __name__ == "__main__":
    unittest.main()
