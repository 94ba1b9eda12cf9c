"""The subjects on which tiers are measured and judged: six animals, nine looks, and some special furs and views. Each is
a scene that a server makes through HTTP, without a ground, whose shadow would count as coverage."""
import json
import pathlib
import subprocess
import sys

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "end_to_end"))
from support.server import shared_folder  # noqa: E402

DISTANCES = {"near": 0.9, "whole": 1.6, "far": 4}  # distance from the middle of the bounding box, in sizes
DIRECTION = numpy.array([0.5, 0.22, 0.84])
CREST = [[0, 0.9, 0.57], [0, 0.99, 0.48], [0, 1.02, 0.39], [0, 1.0, 0.3], [0, 0.93, 0.21], [0, 0.71, 0.12]]
UPRIGHT = {"stroke": {"samples": [{"position": position} for position in CREST]},
           "brush": {"radius": 0.05, "strength": 1, "falloff": "constant"}}


class Subject:
    """A file under meshes or the built-in creature, with a recipe, a look, further commands, and a camera."""

    def __init__(self, name, file=None, recipe=None, look=None, front="z", fur="", commands=(), camera=None):
        self.name, self.file, self.recipe, self.look = name, file, recipe, look
        self.front, self.fur, self.commands, self.camera = front, fur, list(commands), camera

    def on(self, server):
        scene = server.new_scene("creature", 20000, name=self.name)
        if self.file:
            content = (shared_folder() / "meshes" / self.file).read_bytes()
            kind = self.file.split(".")[-1]
            answer = server.call("PUT", f"{scene.path}/model?format={kind}&front={self.front}{self.fur}", content)
            assert answer.status == 200, answer
        if self.recipe:
            recipe = ROOT / "clients" / "recipes" / f"{self.recipe}.json"
            subprocess.run([server.binaries / "pelage", "--server", server.address, "run", scene.id, recipe], check=True,
                           stdout=subprocess.DEVNULL)
        if self.look:
            look = ROOT / "clients" / "looks" / f"{self.look}.json"
            self.run(scene, json.loads(look.read_text(encoding="utf-8"))["commands"])
        self.run(scene, [*self.commands, {"op": "set_ground", "ground": {"visible": False}}])
        return scene

    @staticmethod
    def run(scene, commands):
        answer = scene.post("commands", {"commands": commands})
        assert answer.status == 200, answer

    def seen_from(self, scene, distance):
        if self.camera:
            return self.camera
        info = scene.info()
        low, high = numpy.array(info["bounds"]["min"]), numpy.array(info["bounds"]["max"])
        target = (low + high) / 2
        eye = target + DIRECTION / numpy.linalg.norm(DIRECTION) * DISTANCES[distance] * info["size"]
        return {"position": list(eye), "target": list(target), "up": [0, 1, 0], "fov_degrees": 35}


def coat(**settings):
    return {"op": "set_coat", "coat": {"ramp": [{"at": 0, "colour": [0.12, 0.06, 0.03]}, {"at": 1, "colour": [0.42, 0.25, 0.13]}],
                                       "root_share": 0.3, **settings}}


ANIMALS = [Subject("koala, plush", "koala_low.obj", "koala_plush"),
           Subject("cat as a fox", "cat.obj", "cat_fox", front="-x"),
           Subject("spot, sleek", "spot.obj", "spot_sleek", front="-z"),
           Subject("koala, white", "koala_low.obj", "koala_white"),
           Subject("creature", recipe="creature"),
           Subject("cat as a leopard", "cat.obj", look="leopard", front="-x", fur="&length=0.018&inclination=0.8")]
LOOKS = [Subject(f"look {look}", look=look) for look in
         ("bear", "fox", "leopard", "rabbit", "sheep", "shorthair_cat", "toy_plush", "wet_dog", "zebra")]
FURS = [Subject("long fur", commands=[{"op": "lift", **UPRIGHT}, {"op": "length", "mode": "set", "value": 0.15, **UPRIGHT}]),
        Subject("curly", commands=[coat(curl=0.12, curl_turns=8, curl_together=0.5, clump=0.5)]),
        Subject("wet", commands=[coat(wetness=1, clump=0.6, clump_size=0.016, fine_clump=0.7)]),
        Subject("undercoat", commands=[coat(count=16000, undercoat={"share": 0.7, "length": 0.45, "width": 0.4, "lightness": 1.4})]),
        Subject("wind", commands=[{"op": "set_wind", "wind": {"speed": 0.6, "direction": [1, 0, 0.3], "time": 1.3}}]),
        Subject("close-up", camera={"position": [1.3, 1.2, 2.9], "target": [0.08, 0.8, 0.5], "fov_degrees": 6})]
SUBJECTS = [*ANIMALS, *LOOKS, *FURS]
