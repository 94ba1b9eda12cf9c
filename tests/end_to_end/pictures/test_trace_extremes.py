"""Traced pictures of what is at the end of every range: an answer, and a server that goes on."""

import json

from support.server import Server, ServedTest

TRACE = {"passes": 1, "strands": 3000}


def boxes(scale, offset=0.0):
    """Two cubes that share an edge's vertices, a sliver, a triangle of no area and one alone."""
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    positions = corners + [(x + 1, y + 1, z) for x, y, z in corners] + [(3, 0, 0), (4, 0, 0), (3, 1, 0), (3.5, 1e-9, 0)]
    cube = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
            (1, 5, 7), (1, 7, 3)]
    faces = cube + [tuple(8 + i for i in face) for face in cube] + [(16, 17, 18), (16, 17, 19), (16, 16, 17), (0, 1, 7)]
    lines = [f"v {x * scale + offset:.9g} {y * scale:.9g} {z * scale:.9g}" for x, y, z in positions]
    return "\n".join(lines + ["f " + " ".join(str(i + 1) for i in face) for face in faces]).encode()


class TraceExtremes(ServedTest):
    def traced(self, scene, trace=None, **request):
        quality = {"method": "strands", "trace": {**TRACE, **(trace or {})}}
        return scene.post("frames", {"width": 24, "height": 24, "quality": quality, **request})

    def answered(self, scene, trace=None, **request):
        answer = self.traced(scene, trace, **request)
        self.assertEqual(answer.status, 200, answer)
        report = json.loads(answer.headers["pelage-trace"])
        self.assertGreaterEqual(report["passes"], 1)
        return report

    def test_cameras(self):
        scene = self.server.new_scene("sphere", 500)
        for eye in ([0, 0, 0], [0, 0, 1], [0, 0, 1.01], [0, 1e6, 1], [0, 0, 1e20], [1e27, 0, 0], [-1e27, 1e27, 1e27]):
            for fov in (1, 150):
                camera = {"position": eye, "target": [0, 1e-3, 2e-3], "up": [0.3, 1, 0.2], "fov_degrees": fov}
                self.answered(scene, camera=camera)
                self.answered(scene, {"transport": "paths"}, camera=camera)

    def test_lights(self):
        scene = self.server.new_scene("sphere", 500)
        for kind in ("point", "spot", "area"):
            for position in ([0, 0, 0], [0, 0, 1], [0, 1e27, 0]):
                light = {"kind": kind, "position": position, "intensity": 1e8}
                if kind != "point":
                    light["direction"] = [0, 0, -1]
                self.assertEqual(scene.run({"op": "set_lights", "lights": [light]}).status, 200)
                self.answered(scene)
        sun = {"kind": "directional", "direction": [0, -1, 0], "angle_degrees": 90, "intensity": 1e8}
        self.assertEqual(scene.run({"op": "set_lights", "lights": [sun]}).status, 200)
        self.answered(scene, {"transport": "paths", "bounces": 4096})

    def test_dense_and_thin_coats(self):
        scene = self.server.new_scene("torus", 500)
        coats = ({"count": 100000, "tile": 0.01}, {"count": 1, "tile": 1}, {"width_root": 0, "width_tip": 0},
                 {"width_root": 0.05, "width_tip": 0.05, "curl": 0.5, "curl_turns": 20})
        for coat in coats:
            self.assertEqual(scene.run({"op": "set_coat", "coat": coat}).status, 200)
            self.assertLessEqual(self.answered(scene)["strands"], 5000)
            self.answered(scene, {"strands": 1, "passes": 65536, "seconds": 0.01})

    def test_sizes(self):
        scene = self.server.new_scene("sphere", 500)
        for width, height in ((1, 1), (1, 8192), (8192, 1)):
            self.answered(scene, {"filter": False}, width=width, height=height)
        for trace in ({"filter": False}, {"filter": True}):
            self.assert_problem(self.traced(scene, trace, width=8192, height=8192), 413, "/width")
        self.answered(scene, {"seed": 4294967295, "noise": 1})

    def test_models(self):
        scene = self.server.new_scene("sphere", 500)
        for scale, offset in ((1, 0), (1e-6, 0), (1e6, 0), (1, 1e3)):
            answer = self.server.call("PUT", f"{scene.path}/model?format=obj", boxes(scale, offset))
            self.assertIn(answer.status, (200, 201, 422), answer)
            self.answered(scene)
            self.answered(scene, {"transport": "paths"})
        one = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"
        self.assertEqual(self.server.call("PUT", f"{scene.path}/model?format=obj", one).status, 200)
        self.assertGreater(self.answered(scene)["strands"], 0)

    def test_little_memory(self):
        server = Server(arguments=["--trace-memory", "0.0625"])
        try:
            scene = server.new_scene("torus", 500)
            scene.run({"op": "set_coat", "coat": {"count": 10000, "tile": 0.016}})
            self.assert_problem(self.traced(scene, {"strands": 8000000}), 413, "/quality/trace/strands")
            self.answered(scene, {"strands": 500})
        finally:
            server.close()
