"""GET .../mesh: a light mesh for clients that cast rays."""

import concurrent.futures
import json
import unittest

import numpy

from support.server import ServedTest, flood


class Glb:
    def __init__(self, body):
        size = int.from_bytes(body[12:16], "little")
        self.json, self.binary = json.loads(body[20:20 + size]), body[28 + size:]
        assert body[:4] == b"glTF" and int.from_bytes(body[8:12], "little") == len(body)
        self.positions, self.normals = self.read(0, "<f4").reshape(-1, 3), self.read(1, "<f4").reshape(-1, 3)
        kind = {5123: "<u2", 5125: "<u4"}[self.json["accessors"][2]["componentType"]]
        self.triangles = self.read(2, kind).reshape(-1, 3)
        self.model_positions = self.positions.astype(float) + self.json["nodes"][0]["translation"]

    def fur(self):
        attributes = self.json["meshes"][0]["primitives"][0]["attributes"]
        return [self.read(attributes[name], "<f4").reshape(-1, 3) for name in ("_FUR_MIDDLE", "_FUR_TIP")]

    def read(self, accessor, kind):
        view = self.json["bufferViews"][self.json["accessors"][accessor]["bufferView"]]
        begin = view.get("byteOffset", 0)
        return numpy.frombuffer(self.binary[begin:begin + view["byteLength"]], kind)


class ProxyMesh(ServedTest):
    def mesh(self, scene, query="", **more):
        answer = self.server.get(f"{scene.path}/mesh{query}", **more)
        self.assertEqual(answer.status, 200, answer)
        self.assertEqual(answer.headers["content-type"], "model/gltf-binary")
        self.assertEqual(answer.headers["cache-control"], "no-cache")
        return answer

    def obj(self, scene, text):
        answer = self.server.call("PUT", f"{scene.path}/model?format=obj&discard=1", text.encode())
        self.assertEqual(answer.status, 200, answer)

    def test_a_sphere(self):
        scene = self.server.new_scene("sphere", 30000)
        self.assertEqual(len(Glb(self.mesh(scene).body).triangles), 20000)
        glb = Glb(self.mesh(scene, "?triangles=2000").body)
        self.assertLessEqual(len(glb.triangles), 2000)
        self.assertGreater(len(glb.triangles), 1500)
        middles = glb.model_positions[glb.triangles].mean(axis=1)
        for radius in (numpy.linalg.norm(glb.model_positions, axis=1), numpy.linalg.norm(middles, axis=1)):
            self.assertGreater(radius.min(), 0.98)
            self.assertLess(radius.max(), 1.0001)
        self.assertLess(numpy.abs(numpy.linalg.norm(glb.normals, axis=1) - 1).max(), 1e-5)

    def test_a_creature_fills_its_box_and_its_coordinates_are_those_of_strokes(self):
        scene = self.server.new_scene("creature", 3000)
        glb, bounds = Glb(self.mesh(scene, "?triangles=1500").body), scene.info()["bounds"]
        self.assertEqual(len(glb.triangles), 1500)
        size = scene.info()["size"]
        for ours, theirs in ((glb.model_positions.min(axis=0), bounds["min"]), (glb.model_positions.max(axis=0), bounds["max"])):
            self.assertLess(numpy.abs(ours - theirs).max(), 0.01 * size)
        point = glb.model_positions[len(glb.model_positions) // 3].tolist()
        stroke = {"op": "length", "value": 0.02, "brush": {"radius": 0.001}, "stroke": {"samples": [{"position": point}]}}
        self.assertGreaterEqual(scene.run(stroke).json["results"][0]["touched"], 1)

    def test_the_server_reads_its_own_mesh(self):
        scene, copy = self.server.new_scene("creature", 3000), self.server.new_scene("plane", 2)
        answer = self.server.call("PUT", f"{copy.path}/model?format=glb", self.mesh(scene).body)
        self.assertEqual(answer.status, 200, answer)
        ours, theirs = scene.info(), copy.info()
        self.assertEqual((ours["vertices"], ours["triangles"]), (theirs["vertices"], theirs["triangles"]))
        for end in ("min", "max"):
            self.assertTrue(numpy.allclose(ours["bounds"][end], theirs["bounds"][end], atol=1e-6 * ours["size"]))

    def test_the_tag_stays_with_strokes_and_changes_with_the_model(self):
        scene = self.server.new_scene("sphere", 5000)
        first = self.mesh(scene, "?triangles=500")
        tag = first.headers["etag"]
        self.assertRegex(tag, r'^"[^"]+"$')
        self.assertEqual(scene.run(flood([0, 1, 0])).status, 200)
        again = self.mesh(scene, "?triangles=500")
        self.assertEqual((again.headers["etag"], again.body), (tag, first.body))
        for known in (tag, f"W/{tag}", f'"other", {tag}', f'"other",{tag}', "*"):
            same = self.server.get(f"{scene.path}/mesh?triangles=500", headers={"If-None-Match": known})
            self.assertEqual((same.status, same.body, same.headers["etag"]), (304, b"", tag), known)
        self.mesh(scene, "?triangles=500", headers={"If-None-Match": '"other"'})
        self.assertNotEqual(self.mesh(scene, "?triangles=600").headers["etag"], tag)
        self.obj(scene, "v 1e9 0 0\nv 1000000001 0 0\nv 1e9 1 0\nf 1 2 3\n")
        changed = self.mesh(scene, "?triangles=500", headers={"If-None-Match": tag})
        self.assertNotEqual(changed.headers["etag"], tag)
        glb = Glb(changed.body)
        self.assertEqual(len(glb.triangles), 1)
        self.assertEqual(glb.model_positions.min(axis=0).tolist(), [1e9, 0, 0])
        self.assertEqual(scene.post("subdivide", {}).status, 200)
        self.assertNotEqual(self.mesh(scene, "?triangles=500").headers["etag"], changed.headers["etag"])

    def test_with_fur_it_says_where_strands_stand_and_its_tag_follows_the_groom(self):
        scene = self.server.new_scene("sphere", 5000)
        bare, furred = self.mesh(scene, "?triangles=500"), self.mesh(scene, "?triangles=500&fur=true")
        self.assertNotEqual(bare.headers["etag"], furred.headers["etag"])
        outwards, forwards = [], []
        for lean in (0, 1):
            commands = [{"op": "length", "flood": True, "value": 0.5, "units": "world"},
                        {"op": "comb", "flood": True, "direction": [1, 0, 0], "lean": lean}]
            self.assertEqual(scene.run({"commands": commands}).status, 200)
            answer = self.mesh(scene, "?triangles=500&fur=true", headers={"If-None-Match": furred.headers["etag"]})
            self.assertEqual(answer.headers["pelage-revision"], str(scene.info()["revision"]))
            glb = Glb(answer.body)
            middles, tips = glb.fur()
            self.assertLess(numpy.linalg.norm(tips, axis=1).max(), 0.5001)
            self.assertLess(numpy.linalg.norm(middles, axis=1).max(), 0.2501)
            outwards.append((tips * glb.normals).sum(axis=1).mean())
            forwards.append(tips[:, 0].mean())
        self.assertGreater(outwards[0], outwards[1] + 0.05)
        self.assertGreater(forwards[1], forwards[0] + 0.05)
        self.assertEqual(scene.run({"op": "length", "flood": True, "value": 0, "brush": {"strength": 1}}).status, 200)
        self.assertEqual(max(numpy.abs(part).max() for part in Glb(self.mesh(scene, "?triangles=500&fur=true").body).fur()), 0)

    def test_a_model_with_few_triangles_has_one_mesh(self):
        scene = self.server.new_scene("plane", 50)
        few, many = self.mesh(scene, "?triangles=100"), self.mesh(scene, "?triangles=200000")
        self.assertEqual((few.headers["etag"], few.body), (many.headers["etag"], many.body))

    def test_more_meshes_than_are_kept_and_many_clients_at_a_time(self):
        scenes = [self.server.new_scene("sphere", 3000) for _ in range(4)]
        wanted = [(scene, triangles) for scene in scenes for triangles in (100, 200, 400)] * 2
        with concurrent.futures.ThreadPoolExecutor(8) as clients:
            answers = list(clients.map(lambda one: (one, self.server.get(f"{one[0].path}/mesh?triangles={one[1]}")), wanted))
        for (_, triangles), answer in answers:
            if answer.status != 503:  # several meshes are made at a time, but not any number
                self.assertLessEqual(len(Glb(answer.body).triangles), triangles)
        for scene in scenes:
            self.server.call("DELETE", scene.path)
            self.assert_problem(self.server.get(f"{scene.path}/mesh?triangles=100"), 404)

    def test_what_is_refused(self):
        scene = self.server.new_scene("plane", 2)
        for query in ("triangles=0", "triangles=99", "triangles=200001", "triangles=many", "triangles=150.5"):
            self.assert_problem(self.server.get(f"{scene.path}/mesh?{query}"), 422, "/triangles")
        unknown = self.server.get(f"{scene.path}/mesh?triangle=100")
        self.assert_problem(unknown, 422)
        self.assertEqual(unknown.json["nearest"], "triangles")
        self.assert_problem(self.server.get("/v1/scenes/none/mesh"), 404)
        self.assert_problem(self.server.post(f"{scene.path}/mesh", {}), 405)
        self.obj(scene, "v 0 0 0\nv 1e-31 0 0\nv 0 1e-31 0\nf 1 2 3\n")
        self.assert_problem(self.server.get(f"{scene.path}/mesh"), 422)

    def test_head(self):
        scene = self.server.new_scene("sphere", 3000)
        full, head = self.mesh(scene), self.server.call("HEAD", f"{scene.path}/mesh")
        self.assertEqual((head.status, head.body, head.headers["etag"]), (200, b"", full.headers["etag"]))
        self.assertEqual(int(head.headers["content-length"]), len(full.body))


if __name__ == "__main__":
    unittest.main()
