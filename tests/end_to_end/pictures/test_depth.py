"""How deep one sees into fur: rasterized strands beside traced ones. Black roots, white tips and even light, so that what
is seen is its height."""
import math
import unittest

from support.exr import read_exr
from support.nightly import nightly
from support.server import ServedTest

GREY = [{"at": 0, "colour": [1, 1, 1]}, {"at": 1, "colour": [1, 1, 1]}]
HEIGHT = [{"at": 0, "colour": [0, 0, 0]}, {"at": 1, "colour": [1, 1, 1]}]
COAT = {"count": 8400, "width_root": 0.00044, "width_tip": 0.00011, "clump": 0.2}
RASTER = {"scale": 2, "raster": {"strands": 1000, "light_of": 1}}
STRANDS = {"method": "strands", "trace": {"passes": 8, "scattering": "look"}}


class Depth(ServedTest):
    def scene(self, builtin, length, inclination):
        scene = self.server.new_scene(builtin, 3000)
        whole = {"flood": True, "brush": {"strength": 1}}
        for command in ({"op": "set_ground", "ground": {"visible": False}}, {"op": "set_lights", "lights": []},
                        {"op": "set_look", "look": {"specular": 0, "self_shadow": 0, "ambient": 1, "ambient_floor": 1,
                                                    "colour_source": "coat"}},
                        {"op": "length", "mode": "set", "value": length, **whole},
                        {"op": "unify", "direction": [0, -1, -0.3], "inclination": inclination, "weight": 1, **whole}):
            self.assertEqual(scene.run(command).status, 200, command)
        return scene

    def light(self, scene, ramp, quality, camera):
        self.assertEqual(scene.run({"op": "set_coat", "coat": {**COAT, "ramp": ramp}}).status, 200)
        frame = scene.frame(width=96, height=96, format="exr", exr_type="float", background="transparent", quality=quality,
                            camera=camera)
        return read_exr(frame.body)["G"].sum()

    def seen_height(self, scene, quality, elevation, distance):
        angle = math.radians(elevation)
        target = [(low + high) / 2 for low, high in zip(*(scene.info()["bounds"][k] for k in ("min", "max")))]
        direction = (.6 * math.cos(angle), math.sin(angle), .8 * math.cos(angle))
        camera = {"position": [t + distance * w for t, w in zip(target, direction)], "target": target, "up": [0, 1, 0],
                  "fov_degrees": 1.5 if distance > 3 else 35}
        return self.light(scene, HEIGHT, quality, camera) / self.light(scene, GREY, quality, camera)

    def check(self, scene, elevation, distance, delta=0.025):
        drawn, traced = (self.seen_height(scene, quality, elevation, distance) for quality in (RASTER, STRANDS))
        self.assertAlmostEqual(drawn, traced, delta=delta, msg=f"{elevation} degrees")

    @nightly
    def test_flat_skin(self):
        for inclination in (0, 0.7):
            scene = self.scene("plane", 0.03, inclination)
            for elevation in (60, 15):
                with self.subTest(inclination=inclination, elevation=elevation):
                    self.check(scene, elevation, 4)

    @nightly
    def test_bent_skin_lets_strands_stand_apart(self):
        self.check(self.scene("sphere", 0.04, 0.7), 15, 1.6, 0.03)


if __name__ == "__main__":
    unittest.main()
