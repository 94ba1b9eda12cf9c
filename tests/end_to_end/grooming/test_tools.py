"""What each tool of the demo does can be seen in the picture and in the fields."""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy

from support.nightly import nightly
from support.server import REPOSITORY, THIN_COAT, ServedTest, shared_folder

DEMO = REPOSITORY / "deploy" / "demo_groom.py"
FRAME = {"width": 192, "height": 192, "background": "transparent"}


def demo_steps(info):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        (path / "info.json").write_text(json.dumps(info), encoding="utf-8")
        subprocess.run([sys.executable, str(DEMO), str(path / "info.json"), folder], check=True)
        return {p.stem: [json.loads(line) for line in p.read_text().splitlines()] for p in sorted(path.glob("*.jsonl"))}


def linear(content):
    value = content / 255
    return numpy.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def eroded(mask, pixels):
    for axis in (0, 1):
        for step in range(-pixels, pixels + 1):
            mask = mask & numpy.roll(mask, step, axis)
    return mask


class Tools(ServedTest):
    def share_changed(self, before, after):
        """Returns the share of pixels that differ by more than 2 of 255, among those that show fur before or after."""
        fur = (before[..., 3] > 0) | (after[..., 3] > 0)
        differs = numpy.abs(before.astype(int) - after.astype(int)).max(axis=-1) > 2
        return (differs & fur).sum() / fur.sum()

    def picked(self, scene):
        view = {"camera": {"auto": "three_quarter"}, "width": 512, "height": 512}
        answers = [scene.post("pick", {"view": view, "pixel": [x, y], "reach": "skin"}).json
                   for x in range(120, 420, 20) for y in range(120, 420, 20)]
        return [a for a in answers if a["hit"]]

    def check_steps(self, scene):
        before = scene.frame(**FRAME).image
        fields = self.picked(scene)
        for name, commands in demo_steps(scene.info()).items():
            for command in commands:
                self.assertEqual(scene.run(command).status, 200)
            after = scene.frame(**FRAME).image
            self.assertGreater(self.share_changed(before, after), 0.05, name)
            now = self.picked(scene)
            if name == "1-comb":  # from tail to nose: what leant back now leans forward
                self.assertGreater(numpy.mean([p["direction"][2] for p in now]),
                                   numpy.mean([p["direction"][2] for p in fields]) + 0.3)
            if name == "2-blow":  # away from the source
                source = numpy.array(commands[0]["source"])
                along = [numpy.dot(p["direction"], numpy.array(p["position"]) - source) /
                         numpy.linalg.norm(numpy.array(p["position"]) - source) for p in now]
                self.assertGreater(numpy.mean(along), 0.4)
            if name == "3-attract":
                self.assertGreater(max(b["length"] / a["length"] for a, b in zip(fields, now) if a["length"] > 0), 1.2)
                self.assertGreater(max(p["stretch"] for p in now), 0.1)
            before, fields = after, now

    def test_creature(self):
        scene = self.server.new_scene("creature", 3000)
        self.assertEqual(scene.run(THIN_COAT).status, 200)
        self.check_steps(scene)

    def check_file(self, path, query):
        scene = self.server.new_scene("torus")
        answer = self.server.call("PUT", f"{scene.path}/model?{query}", path.read_bytes())
        self.assertEqual(answer.status, 200, answer)
        self.check_steps(scene)

    @nightly
    def test_spot(self):
        self.check_file(shared_folder() / "meshes" / "spot.glb", "format=glb&front=-z")

    @nightly
    def test_koala(self):
        self.check_file(shared_folder() / "meshes" / "koala.ply", "format=ply")

    def test_curves_come_and_go(self):
        scene = self.server.new_scene("creature", 3000)
        self.assertEqual(scene.run(THIN_COAT).status, 200)
        whiskered = scene.frame(**FRAME)
        self.assertEqual(scene.run({"op": "set_curves", "groups": []}).status, 200)
        bare = scene.frame(**FRAME)
        self.assertNotEqual(whiskered.body, bare.body)
        self.assertLess(self.share_changed(whiskered.image, bare.image), 0.1)
        group = {"curves": [[[0, 1.3, 0], [0, 1.6, 0]], [[0.2, 1.3, 0], [0.2, 1.6, 0]]], "fill": 10, "width_root": 0.005,
                 "width_tip": 0.005, "root_colour": "#ff0000", "tip_colour": "#ff0000"}
        self.assertEqual(scene.run({"op": "set_curves", "groups": [group]}).status, 200)
        red = scene.frame(**FRAME).image
        shown = (red[..., 3] > 127) & (red[..., 0] > 2 * red[..., 1].astype(int)) & (red[..., 0] > 2 * red[..., 2].astype(int))
        self.assertGreater(shown.sum(), 20)
        for body in (bare.body, whiskered.body):
            self.assertEqual(scene.post("undo", {}).status, 200)
            self.assertEqual(scene.frame(**FRAME).body, body)

    @nightly
    def test_horse(self):
        self.check_file(pathlib.Path("/usr/share/glmark2/models/horse.3ds"), "format=3ds&up=y&front=x")  # it looks along x

    def test_dense_fur_of_a_file_shows_no_background(self):
        scene = self.server.new_scene("torus")
        content = (shared_folder() / "meshes" / "koala_low.obj").read_bytes()
        self.assertEqual(self.server.call("PUT", f"{scene.path}/model?format=obj", content).status, 200)
        self.check_background(scene)

    def test_dense_fur_shows_no_background(self):
        self.check_background(self.server.new_scene("creature", 3000))

    def check_background(self, scene):
        """Behind pixels that say they are opaque (alpha 255 stands for .998 and more) no more of the background shows than
        that, in linear light, beside the rounding of both pictures to 8 bits. Eyes are away: they mirror the background."""
        self.assertEqual(scene.run({"op": "set_eyes", "eyes": []}).status, 200)
        alpha = scene.frame(**FRAME).image[..., 3]
        opaque = alpha == 255
        self.assertGreater(opaque[eroded(alpha > 127, 6)].mean(), 0.98)
        red = scene.frame(**{**FRAME, "background": "#ff0000"}).image[opaque].astype(int)
        green = scene.frame(**{**FRAME, "background": "#00ff00"}).image[opaque].astype(int)
        step = linear(numpy.maximum(red, green) + 1) - linear(numpy.maximum(red, green))
        leak = numpy.abs(linear(red) - linear(green)) - step
        self.assertLessEqual(leak.max(), 0.5 / 255)


class BrushSymmetry(ServedTest):
    """A brush's own symmetry stands in place of the scene's."""

    PLANE = {"planes": [{"point": [0, 0, 0], "normal": [1, 0, 0]}]}

    def hash_after(self, *commands):
        scene = self.server.new_scene("sphere", 2000)
        for command in commands:
            answer = scene.run(command)
            self.assertEqual(answer.status, 200, answer)
        return scene.info()["fields_hash"]

    def comb(self, **brush):
        samples = [{"position": [0.6, 0.2 * k, 0.75]} for k in range(3)]
        return {"op": "comb", "stroke": {"samples": samples}, "brush": {"radius": 0.1, **brush}}

    def test_it_does_what_the_scenes_does(self):
        alone = self.hash_after(self.comb())
        mirrored = self.hash_after({"op": "set_symmetry", "symmetry": self.PLANE}, self.comb())
        self.assertNotEqual(alone, mirrored)
        self.assertEqual(self.hash_after(self.comb(symmetry=self.PLANE)), mirrored)
        self.assertEqual(self.hash_after({"op": "set_symmetry", "symmetry": self.PLANE}, self.comb(symmetry={"planes": []})), alone)

    def test_what_is_too_far_is_refused(self):
        far = {"planes": [{"point": [1e20, 0, 0], "normal": [1, 0, 0]}]}
        scene = self.server.new_scene("sphere", 500)
        self.assert_problem(scene.run(self.comb(symmetry=far)), 422, "/brush/symmetry/planes/0/point")
        self.assertEqual(scene.info()["revision"], 0)

    def test_the_log_keeps_it(self):
        scene = self.server.new_scene("sphere", 500)
        plane = {"planes": [{"point": [0.3, 0, 0], "normal": [1, 0, 0]}]}
        self.assertEqual(scene.run(self.comb(symmetry=plane)).status, 200)
        log = self.server.get(f"{scene.path}/log").json["entries"]
        self.assertEqual(log[-1]["commands"]["brush"]["symmetry"]["planes"][0]["point"], [0.3, 0, 0])


class GuidesReach(ServedTest):
    """Guides and keys change nothing farther away than their reach."""

    def changed(self, command):
        scene = self.server.new_scene("sphere", 3000)
        view = {"camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fov_degrees": 35}, "width": 200, "height": 200}
        pixels = [[100, y] for y in range(10, 190, 5)]

        def leans():
            picks = [scene.post("pick", {"view": view, "pixel": pixel, "reach": "skin"}).json for pixel in pixels]
            picks = [one for one in picks if one["hit"]]
            return numpy.array([numpy.array(one["direction"]) * one["inclination"] for one in picks]), [one["position"] for one in picks]

        before, positions = leans()
        answer = scene.run(command)
        self.assertEqual(answer.status, 200, answer)
        after, _ = leans()
        away = [numpy.linalg.norm(numpy.array(position) - [0, 0, 1]) for position in positions]
        return numpy.linalg.norm(after - before, axis=1), numpy.array(away)

    def check(self, command):
        everywhere, away = self.changed(command)
        near, _ = self.changed({**command, "reach": 0.4, "units": "world", "sigma": 0.7})
        self.assertGreater(everywhere[away > 0.5].max(), 0.05)
        self.assertGreater(near[away < 0.1].max(), 0.05)
        self.assertLess(near[away > 0.5].max(), 1e-9)
        between = near[(away > 0.25) & (away < 0.4)]
        self.assertLess(between.mean(), near[away < 0.1].mean())

    def test_of_keys(self):
        self.check({"op": "interpolate", "keys": [{"position": [0, 0, 1], "direction": [1, 0, 0], "inclination": 0.9}]})

    def test_of_guides(self):
        self.check({"op": "flow", "curves": [[[-0.02, 0, 1], [0.02, 0, 1]]], "inclination": 0.9})

    def test_no_reach_is_refused(self):
        scene = self.server.new_scene("sphere", 500)
        command = {"op": "flow", "curves": [[[-0.1, 0, 1], [0.1, 0, 1]]], "reach": 0}
        self.assert_problem(scene.run(command), 422, "/reach")
