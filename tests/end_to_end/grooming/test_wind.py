"""Fur in the wind: time moves it, the same time draws the same bytes, and a calm scene pays nothing."""

import json
import pathlib
import tempfile

import numpy

from support.server import THIN_COAT, ServedTest, flood

SIZE = {"camera": {"auto": "front"}, "width": 96, "height": 96}
DRAFT = {**SIZE, "quality": "draft"}
COMB = flood([0, 1, 0], lean=0.8, brush={"strength": 0.5})
BREEZE = {"op": "set_wind", "wind": {"speed": 0.8, "direction": [1, 0, 0], "turbulence_scale": 0.2}}


class Wind(ServedTest):
    def scene(self, *commands, **more):
        scene = self.server.new_scene("sphere", 2000, fur={"length": 0.06, "inclination": 0.3}, **more)
        self.assertEqual(scene.run(THIN_COAT, *commands).status, 200)
        return scene

    def test_time_moves_the_fur_and_the_same_time_draws_the_same(self):
        scene = self.scene(BREEZE)
        first = scene.frame(**DRAFT, time=2).body
        others = [scene.frame(**DRAFT, time=time).body for time in (0, 1.5, 2.04, -3, 1e6)]
        self.assertEqual(len({first, *others}), 6)
        self.assertEqual(scene.frame(**DRAFT, time=2).body, first)
        self.assertEqual(self.scene(BREEZE).frame(**DRAFT, time=2).body, first, "in a scene that has shown no other time")

    def test_drafts_and_strands_answer_for_the_same_time(self):
        scene = self.scene(BREEZE)
        strands = {**SIZE, "quality": {"method": "strands", "trace": {"passes": 4, "strands": 20000}}}
        raster = {**SIZE, "quality": {"raster": {"strands": 4}, "scale": 2}}
        for request in (raster, strands):
            first, later = (scene.frame(**request, time=time).image.astype(float) for time in (2, 4.5))
            self.assertGreater(numpy.abs(first - later).mean(), 1)
            scene.frame(**DRAFT, time=9)
            again = scene.frame(**request, time=2).image.astype(float)
            self.assertEqual(numpy.abs(first - again).max(), 0)

    def test_without_wind_nothing_moves(self):
        scene = self.scene()
        still = scene.frame(**DRAFT).body
        for time in (0, 3, -20):
            self.assertEqual(scene.frame(**DRAFT, time=time).body, still)
        self.assertEqual(scene.run({"op": "set_wind", "wind": {"speed": 0, "gusts": 2, "time": 7}}).status, 200)
        self.assertEqual(scene.frame(**DRAFT).body, still)

    def test_still_and_moved_frames_leave_each_other_alone(self):
        scene = self.scene()
        still = scene.frame(**DRAFT).body
        scene.run(BREEZE)
        moved = scene.frame(**DRAFT, time=2).body
        self.assertEqual(scene.frame(**DRAFT, revision=1, time=2).body, still, "a revision before the wind")
        self.assertEqual(scene.frame(**DRAFT, time=2).body, moved)
        scene.post("undo")
        self.assertEqual(scene.frame(**DRAFT).body, still)
        self.assertEqual(scene.frame(**DRAFT, revision=2, time=2).body, moved, "a revision of the wind")
        scene.post("redo")
        self.assertEqual(scene.frame(**DRAFT, time=2).body, moved)
        self.assertEqual(scene.run(COMB).status, 200)
        combed = scene.frame(**DRAFT, time=2).body
        self.assertNotEqual(combed, moved)
        fresh = self.scene(BREEZE)
        fresh.run(COMB)
        self.assertEqual(fresh.frame(**DRAFT, time=2).body, combed)

    def test_the_scene_has_a_time(self):
        scene = self.scene(BREEZE)
        at_two = scene.frame(**DRAFT, time=2).body
        scene.run({**BREEZE, "wind": {**BREEZE["wind"], "time": 2}})
        self.assertEqual(scene.frame(**DRAFT).body, at_two)
        self.assertNotEqual(scene.frame(**DRAFT, time=0).body, at_two)
        self.assertEqual(self.server.get(f"{scene.path}/settings").json["wind"]["time"], 2)
        address = f"{scene.path}/frame.png?camera=front&width=96&height=96&quality=draft&time="
        self.assertEqual(self.server.get(address + "2").body, at_two)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "then.png"
            self.pelage("frame", scene.id, "-o", file, "--camera", "front", "--width", 96, "--height", 96, "--quality", "draft", "--time", 2)
            self.assertEqual(file.read_bytes(), at_two)
        self.server.terminate()
        self.server.start()
        self.assertEqual(scene.frame(**DRAFT).body, at_two, "after a restart")

    def test_the_groom_stays(self):
        scene = self.scene()
        before = scene.info()["fields_hash"]
        scene.run(BREEZE)
        scene.frame(**DRAFT, time=2)
        self.assertEqual(scene.info()["fields_hash"], before)
        self.assertEqual(self.server.get(f"{scene.path}/compare?from=1&to=2").json["touched"], 0)

    def test_stiff_fur_moves_less(self):
        def moved(*commands):
            scene = self.scene(BREEZE, *commands)
            first, later = (scene.frame(**SIZE, time=time).image.astype(float) for time in (2, 4.5))
            blocks = (first - later).reshape(24, 4, 24, 4, -1).mean(axis=(1, 3))  # strands that cross a pixel do not show how far they moved
            return numpy.abs(blocks).mean()

        paint = {"op": "paint", "flood": True, "field": "stiffness", "brush": {"strength": 1}}
        self.assertLess(moved({**paint, "value": 4}), 0.5 * moved())
        self.assertNotEqual(moved({**paint, "value": 0}), moved())

    def test_an_open_shutter_blurs_what_moves(self):
        def strands(shutter, scene, **more):
            trace = {"passes": 8, "strands": 20000, "filter": False, "shutter": shutter}
            answer = scene.post("frames", {**SIZE, "quality": {"method": "strands", "trace": trace}, **more})
            self.assertEqual(answer.status, 200, answer)
            return answer.image.astype(float)

        scene = self.scene({**BREEZE, "wind": {**BREEZE["wind"], "gusts": 2}})
        sharp, blurred = strands(0, scene, time=2), strands(0.2, scene, time=2)
        self.assertGreater(numpy.abs(sharp - blurred).mean(), 1)
        self.assertLess(self.detail(blurred), self.detail(sharp))
        numpy.testing.assert_array_equal(strands(0.2, scene, time=2), blurred)
        calm = self.scene()
        numpy.testing.assert_array_equal(strands(0.2, calm, time=2), strands(0, calm))
        trace = {"passes": 1, "shutter": 11}
        self.assert_problem(scene.post("frames", {**SIZE, "quality": {"method": "strands", "trace": trace}}), 422, "/quality/trace/shutter")

    def detail(self, picture):
        """Returns the mean difference of neighbours."""
        return numpy.abs(numpy.diff(picture, axis=0)).mean() + numpy.abs(numpy.diff(picture, axis=1)).mean()

    def test_what_is_beyond_is_refused(self):
        scene = self.scene()
        self.assert_problem(scene.post("frames", {**DRAFT, "time": 1.1e6}), 422, "/time")
        self.assert_problem(scene.post("frames", {**DRAFT, "time": "now"}), 422, "/time")
        for wind, pointer in (({"speed": -1}, "/wind/speed"), ({"direction": [0, 0, 0]}, "/wind/direction"), ({"gusts": 11}, "/wind/gusts"),
                              ({"frequency": 0}, "/wind/frequency"), ({"damping": 0}, "/wind/damping"), ({"seeds": 1}, "/wind/seeds")):
            self.assert_problem(scene.run({"op": "set_wind", "wind": wind}), 422, pointer)
        self.assert_problem(scene.run({"op": "paint", "flood": True, "field": "stiffness", "value": 4.5}), 422, "/value")

    def test_a_progressive_picture_is_of_its_time(self):
        scene = self.scene(BREEZE)
        body = {**SIZE, "view": "artist", "progressive": {"passes": 4, "strands": 20000}, "time": 2}
        self.assertEqual(scene.post("frames", body).status, 200)
        traced = None
        for _ in range(100):
            answer = scene.post("frames?after=1&after_pass=3&wait=20", body)
            if answer.status == 200:
                traced = answer
                break
        strands = {**SIZE, "quality": {"method": "strands", "trace": {"passes": 4, "strands": 20000}}}
        self.assertEqual(json.loads(traced.headers["pelage-trace"])["passes"], 4)
        self.assertEqual(traced.body, scene.frame(**strands, time=2).body)
        self.assertNotEqual(traced.body, scene.frame(**strands, time=3).body)
