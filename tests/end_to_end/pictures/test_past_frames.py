"""Frames of earlier revisions, beside those that were drawn when the scene was there."""

import json
import pathlib
import tempfile
import threading
import unittest

from support.exr import read_attributes, read_exr
from support.nightly import nightly
from support.pictures import png
from support.server import THIN_COAT, ServedTest, comb, flood

VIEW = {"camera": {"auto": "front"}, "width": 96, "height": 96, "quality": "draft"}
RED = {"op": "paint", "field": "tip_colour", "colour": "#ff0000", "flood": True}


def without_revision(picture):
    """An EXR's attributes but for the revision that it names, and its channels bit by bit; other files as they are."""
    if picture[:4] != b"\x76\x2f\x31\x01":
        return picture
    attributes = read_attributes(picture)
    del attributes["pelage/revision"]
    return attributes, {name: plane.tobytes() for name, plane in read_exr(picture).items()}


class PastFrames(ServedTest):
    def thin_scene(self, triangles=500):
        scene = self.server.new_scene("sphere", triangles)
        self.assertEqual(scene.run(THIN_COAT).json["revision"], 1)
        return scene

    def groomed(self, **request):
        """A scene with one revision for each kind of change, and what was drawn at each."""
        scene = self.server.new_scene("sphere", 2000)
        seen = [scene.frame(**VIEW, **request).body]

        def see(answer):
            self.assertEqual(answer.status, 200, answer)
            seen.append(scene.frame(**VIEW, **request).body)

        see(scene.run(THIN_COAT))
        see(scene.run(flood([0, -1, 0], lean=0.6)))
        see(scene.run(comb([-0.5, 0, 0.5], [0.5, 0, 0.5], radius=0.3)))
        see(scene.run(RED))
        see(scene.post("undo", {"steps": 2}))
        see(scene.run({"op": "set_coat", "coat": {**THIN_COAT["coat"], "bend": 0.9, "ramp": [{"at": 0, "colour": "#000080"}]}}))
        see(scene.run({"op": "set_lights", "lights": [{"kind": "directional", "direction": [1, 0, 0]}]}))
        see(scene.run({"op": "set_skin", "regions": [{"centre": [0, 0, 1], "radii": [0.2, 0.2, 0.2]}]}))
        see(scene.post("revert", {"revision": 3}))
        return scene, seen

    def test_they_are_what_was_drawn_then(self):
        scene, seen = self.groomed()
        self.assertGreater(len(set(seen)), 7)
        for revision in (*range(len(seen)), 4, 4, 1, 9, 6):
            answer = scene.frame(**VIEW, revision=revision)
            self.assertEqual(answer.body, seen[revision], revision)
            self.assertEqual((answer.headers["etag"], answer.headers["pelage-revision"]), (f'"{revision}"', str(revision)))
            self.assertEqual(scene.frame(**VIEW).body, seen[-1], f"the present after {revision}")
        address = f"{scene.path}/frame.png?camera=front&width=96&height=96&quality=draft&revision=4"
        self.assertEqual(self.server.get(address).body, seen[4])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "then.png"
            self.pelage("frame", scene.id, "-o", file, "--camera", "front", "--width", 96, "--height", 96, "--quality", "draft", "--revision", 4)
            self.assertEqual(file.read_bytes(), seen[4])

    def test_at_other_cameras_and_with_an_overlay(self):
        scene = self.thin_scene(2000)
        scene.run(comb([-0.5, 0, 0.5], [0.5, 0, 0.5], radius=0.3))
        for request in ({"overlay": "length"}, {"overlay": "difference", "overlay_from": 1}, {"camera": {"auto": "left"}},
                        {"format": "exr", "aovs": ["beauty", "depth"]}, {"budget_ms": 50}):
            ask = {**VIEW, **request}
            if "budget_ms" in ask:
                del ask["quality"]
            scene.post("revert", {"revision": 2})
            now = scene.frame(**ask)
            scene.run(RED)
            then = scene.frame(**ask, revision=2)
            if "budget_ms" not in ask:  # whose knobs may change as frames are learnt from
                self.assertEqual(without_revision(then.body), without_revision(now.body), request)
            self.assertEqual(then.headers["pelage-revision"], "2")

    @nightly
    def test_traced(self):
        trace = {"quality": {"method": "strands", "trace": {"passes": 2, "strands": 2000}}, "overlay": "mask"}
        view = {**VIEW, **trace}
        scene = self.server.new_scene("sphere", 500)
        scene.run({"op": "mask", "sphere": {"centre": [0.8, 0, 0.6], "radius": 0.5}, "combine": "subtract"})
        now = scene.frame(**view)
        scene.run(RED, {"op": "length", "flood": True, "value": 0.1}, flood([1, 0, 0]))
        self.assertNotEqual(scene.frame(**view).body, now.body)
        then = scene.frame(**view, revision=1)
        self.assertEqual((then.body, then.headers["etag"]), (now.body, '"1.2"'))

    def test_with_another_skin_texture(self):
        model = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"
        scene = self.thin_scene()
        self.assertEqual(self.server.call("PUT", f"{scene.path}/model?format=obj", model).status, 200)
        seen = [scene.frame(**VIEW).body]
        for colour in ((255, 0, 0), (0, 255, 0)):
            picture = png([[colour] * 4] * 4)
            self.assertEqual(self.server.call("PUT", f"{scene.path}/skin_texture", picture).status, 200)
            seen.append(scene.frame(**VIEW).body)
        self.assertEqual(len(set(seen)), 3)
        for step in (2, 0, 1, 0):
            self.assertEqual(scene.frame(**VIEW, revision=2 + step).body, seen[step])
            self.assertEqual(scene.frame(**VIEW).body, seen[2])

    def test_not_modified(self):
        scene = self.thin_scene()
        scene.run(flood([0, -1, 0]))
        address = f"{scene.path}/frame.png?width=16&height=16&revision="
        self.assertEqual(self.server.get(f"{address}1", headers={"If-None-Match": '"1"'}).status, 304)
        self.assertEqual(self.server.get(f"{address}1", headers={"If-None-Match": '"2"'}).status, 200)
        self.assert_problem(self.server.get(f"{address}3", headers={"If-None-Match": '"3"'}), 422, "/revision")

    def test_refusals(self):
        scene = self.server.new_scene("sphere", 500)
        scene.run(flood([0, -1, 0]))
        self.assert_problem(scene.post("frames", {**VIEW, "revision": 2}), 422, "/revision")
        self.assert_problem(scene.post("frames", {**VIEW, "revision": -1}), 422, "/revision")
        self.assert_problem(scene.post("frames", {**VIEW, "revision": 0, "progressive": True}), 422, "/progressive")
        for query in ("after=0", "after=0&wait=1"):
            self.assert_problem(scene.post(f"frames?{query}", {**VIEW, "revision": 0}), 422, "/after")
            self.assert_problem(self.server.get(f"{scene.path}/frame.png?revision=0&{query}"), 422, "/after")
        traced = {"quality": {"method": "strands", "trace": {"passes": 1}}}
        self.assert_problem(scene.post("frames", {**traced, "revision": 2}), 422, "/revision")
        self.assert_problem(self.server.get(f"{scene.path}/frame.png?revision=2"), 422, "/revision")

    def test_a_new_model_drops_them(self):
        scene = self.thin_scene()
        scene.run(flood([0, -1, 0]))
        scene.frame(**VIEW, revision=1)
        model = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        self.assertEqual(self.server.call("PUT", f"{scene.path}/model?format=obj&discard=1", model).status, 200)
        for revision in (0, 1, 2):
            self.assert_problem(scene.post("frames", {**VIEW, "revision": revision}), 422, "/revision")
        first = scene.frame(**VIEW, revision=3).body
        scene.run(flood([0, -1, 0]))
        self.assertEqual(scene.frame(**VIEW, revision=3).body, first)

    def test_while_the_scene_changes(self):
        scene = self.thin_scene(2000)
        first = scene.frame(**VIEW).body
        failures = []

        def look(revision):
            for _ in range(12):
                asked = revision()
                answer = scene.post("frames", {**VIEW, "revision": asked})
                if answer.status != 200 or answer.headers["pelage-revision"] != str(asked) or (asked == 1 and answer.body != first):
                    failures.append(answer)

        watchers = [threading.Thread(target=look, args=(which,))
                    for which in (lambda: 1, lambda: scene.info()["revision"], lambda: scene.info()["revision"] // 2 + 1)]
        for watcher in watchers:
            watcher.start()
        for k in range(12):
            scene.run(flood([1, k - 6, 0.5]))
        for watcher in watchers:
            watcher.join()
        self.assertEqual(failures, [])


if __name__ == "__main__":
    unittest.main()
