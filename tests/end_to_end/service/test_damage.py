"""A journal that is damaged, cut, missing or on a full disk: everything else is served, and the fault is reported."""

import os
import pathlib
import shutil
import sqlite3
import subprocess
import tempfile
import unittest

from support.server import Scene, Server, ServedTest, comb, flood

BLUE = {"op": "paint", "field": "tip_colour", "colour": "#0000ff", "flood": True}


class DamageTest(ServedTest):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.close)

    @classmethod
    def setUpClass(cls):
        pass

    def groomed(self, height=0.0, **more):
        scene = self.server.new_scene("sphere", 500, **more)
        for step in (flood([0, -1, 0], lean=0.6), comb([-0.5, height, 0.5], [0.5, 0.3, 0.5], radius=0.3), BLUE):
            self.assertEqual(scene.run(step).status, 200)
        return scene

    @property
    def file(self):
        return self.server.data / "pelage.sqlite"

    def flip_a_bit(self, question, *parameters):
        """In the file, in the middle of a value. The server is not running."""
        with sqlite3.connect(self.file) as database:
            value = database.execute(question, parameters).fetchone()[0]
        at = len(value) // 2
        middle = value[max(at - 40, 0):at + 40]
        content = bytearray(self.file.read_bytes())
        self.assertEqual(content.count(middle), 1, "its bytes occur in the file once")
        content[content.index(middle) + len(middle) // 2] ^= 4
        self.file.write_bytes(content)

    def restart_with_flip(self, question, *parameters):
        self.assertEqual(self.server.terminate(), 0)
        self.flip_a_bit(question, *parameters)
        self.server.start()

    def listed(self):
        return {scene["id"]: scene for scene in self.server.get("/v1/scenes").json["scenes"]}

    def ready(self):
        answer = self.server.get("/readyz")
        self.assertEqual(answer.status, 200, answer)
        return answer.body.decode()


class OneBadScene(DamageTest):
    def test_a_flipped_bit_in_one_entry_leaves_the_rest_served(self):
        scenes = [self.groomed(name=name, height=height) for name, height in (("ant", 0), ("bee", 0.1), ("cat", 0.2))]
        before = [scene.info() for scene in scenes]
        bad = scenes[1]
        self.restart_with_flip("SELECT delta FROM entries WHERE scene = ? AND revision = 2", bad.id)
        for scene, info in ((scenes[0], before[0]), (scenes[2], before[2])):
            self.assertEqual(scene.info(), info)
            self.assertEqual(scene.post("undo").status, 200)
        self.assertIn(bad.id, self.server.printed())
        self.assertIn(f"scene {bad.id}: the journal is damaged", self.ready())
        self.assertIn("revision 2", self.listed()[bad.id]["damage"])
        self.assertEqual([scene["damage"] == "" for scene in self.listed().values()], [True, False, True])
        self.assertEqual(bad.info()["revision"], 1)
        self.assertEqual(bad.frame(quality="draft").image.shape[0], 128)
        for refused in (bad.run(BLUE), bad.post("undo"), bad.post("revert", {"revision": 0}), bad.post("amend", {"revision": 1, "commands": []}),
                        bad.post("subdivide", {"levels": 1})):
            self.assert_problem(refused, 409)
            self.assertIn("revision 2", refused.json["detail"])
        saved = self.server.get(f"{bad.path}/export/pelage")
        self.assertEqual(saved.status, 200, saved)
        opened = self.server.call("POST", "/v1/open", saved.body, headers={"Content-Type": "application/octet-stream"})
        self.assertEqual(opened.status, 201, opened)
        branch = bad.post("branch", {"name": "bee"})
        for copy in (opened.json, branch.json):
            self.assertEqual((copy["revision"], copy["damage"]), (1, ""))
            self.assertEqual(copy["fields_hash"], bad.info()["fields_hash"])
            self.assertEqual(Scene(self.server, copy["id"]).run(BLUE).status, 200)
        self.assertEqual(self.server.call("DELETE", bad.path).status, 204)
        self.assertEqual(self.ready(), "ready\n")
        self.assertEqual(self.server.terminate(), 0)
        self.server.start()
        self.assertEqual(self.ready(), "ready\n")
        self.assertEqual(len(self.listed()), 4)

    def test_a_damaged_model_is_listed_and_can_be_removed(self):
        good, bad = self.groomed(name="ant"), self.groomed(name="bee")
        with_model = self.server.call("PUT", f"{bad.path}/model?format=obj&discard=1", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertEqual(with_model.status, 200, with_model)
        self.restart_with_flip("SELECT raw FROM scenes WHERE id = ?", bad.id)
        self.assertIn("model", self.listed()[bad.id]["damage"])
        self.assertEqual(self.listed()[bad.id]["name"], "bee")
        self.assertIn(bad.id, self.ready())
        for refused in (self.server.get(bad.path), bad.run(BLUE), self.server.get(f"{bad.path}/export/pelage")):
            self.assert_problem(refused, 409)
        self.assertEqual(good.run(BLUE).status, 200)
        self.assertIn("damage", self.pelage("list", "--json").stdout)
        self.assertEqual(self.server.call("DELETE", bad.path).status, 204)
        self.assertEqual(list(self.listed()), [good.id])
        self.assertEqual(self.ready(), "ready\n")


class ShorterLog(DamageTest):
    def test_a_missing_wal_is_reported(self):
        scene = self.groomed()
        self.assertEqual(self.server.terminate(), 0)
        self.server.start()
        self.assertEqual(scene.run(BLUE, BLUE).status, 200)
        self.server.kill()
        pathlib.Path(f"{self.file}-wal").unlink()
        self.server.start()
        self.assertEqual(scene.info()["revision"], 3)
        for said in (self.server.printed(), self.ready()):
            self.assertIn(f"scene {scene.id} was at revision 4 and is at revision 3", said)
        self.assertEqual(scene.run(BLUE).status, 200)
        self.server.kill()
        self.server.start()
        self.assertEqual(self.ready(), "ready\n")
        self.assertEqual(scene.info()["revision"], 4)

    def test_a_folder_that_is_gone_makes_the_server_not_ready(self):
        scene = self.groomed()
        before = scene.info()
        aside = self.server.folder / "aside"
        self.server.data.rename(aside)
        problem = self.server.get("/readyz")
        self.assert_problem(problem, 503)
        self.assertIn("pelage.sqlite", problem.json["detail"])
        self.assert_problem(scene.run(BLUE), 503)
        self.assert_problem(self.server.post("/v1/scenes", {"model": {"builtin": "plane"}}), 503)
        self.assertEqual(scene.info(), before)
        self.assertEqual(scene.frame(quality="draft").image.shape[0], 128)
        self.assertIn("pelage_ready 0", self.server.get("/metrics").body.decode())
        aside.rename(self.server.data)
        self.assertEqual(self.ready(), "ready\n")
        self.assertEqual(scene.run(BLUE).status, 200)
        shutil.rmtree(self.server.data)
        self.assert_problem(self.server.get("/readyz"), 503)


class FullDisk(unittest.TestCase):
    def setUp(self):
        self.disk = pathlib.Path(tempfile.mkdtemp(prefix="pelage-disk-"))
        self.addCleanup(self.disk.rmdir)
        if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=128m", "tmpfs", self.disk], capture_output=True).returncode:
            self.skipTest("a small disk cannot be mounted here")
        self.addCleanup(subprocess.run, ["umount", self.disk], check=True)
        self.server = Server(data=self.disk / "data")
        self.addCleanup(self.server.close)

    def test_start_list_and_delete_work(self):
        server = self.server
        scenes = [server.new_scene("sphere", 500) for _ in range(3)]
        before = [scene.info() for scene in scenes]
        filler = self.disk / "filler"
        with open(filler, "wb", buffering=0) as file:
            while True:
                try:
                    file.write(bytes(4096))
                except OSError:
                    break
        problem = server.get("/readyz")
        self.assertEqual(problem.status, 503)
        self.assertIn("0 MiB left", problem.json["detail"])
        for refused in (scenes[0].run(flood([0, -1, 0])), server.post("/v1/scenes", {"model": {"builtin": "torus", "triangles": 500}})):
            self.assertEqual(refused.status, 503, refused)
            self.assertIn("0 MiB left", refused.json["detail"])
        for end in (server.kill, server.terminate):
            end()
            server.start()
            self.assertEqual([scene.info() for scene in scenes], before)
            self.assertEqual(len(server.get("/v1/scenes").json["scenes"]), 3)
        self.assertEqual(server.call("DELETE", scenes[1].path).status, 204)
        self.assertEqual(len(server.get("/v1/scenes").json["scenes"]), 2)
        filler.unlink()
        self.assertEqual(server.get("/readyz").status, 200)
        self.assertEqual(scenes[0].run(flood([0, -1, 0])).status, 200)
        server.kill()
        server.start()
        self.assertEqual([scene.id for scene in scenes if scene.info().get("revision") is not None], [scenes[0].id, scenes[2].id])


class KeysOverARestart(DamageTest):
    def test_a_key_means_method_path_query_and_body(self):
        key = {"Idempotency-Key": "once"}
        wanted = {"name": "one", "model": {"builtin": "sphere", "triangles": 500}}
        made = self.server.post("/v1/scenes", wanted, headers=key)
        scene = Scene(self.server, made.json["id"])
        requests = {"commands": BLUE, "undo": {"steps": 1}, "redo": {"steps": 1}, "branch": {"name": "side"}, "subdivide": {"levels": 1}}
        first = {name: scene.post(name, body, headers=key) for name, body in requests.items()}
        for name, answer in first.items():
            self.assertIn(answer.status, (200, 201), (name, answer))
        revision, scenes = scene.info()["revision"], sorted(self.listed())
        for restart in (False, True):
            if restart:
                self.server.kill()
                self.server.start()
            again = self.server.post("/v1/scenes", wanted, headers=key)
            self.assertEqual((again.status, again.json["id"], again.headers["location"]), (201, scene.id, scene.path))
            self.assertEqual(self.server.post("/v1/scenes", {**wanted, "name": "two"}, headers=key).status, 422)
            for name, body in requests.items():
                again = scene.post(name, body, headers=key)
                self.assertEqual(again.status, first[name].status, (name, again))
                for member in ("id", "revision", "fields_hash"):
                    self.assertEqual(again.json.get(member), first[name].json.get(member), (name, restart))
                other = scene.post(name, {**body, "name" if name == "branch" else "x": "other"}, headers=key)
                self.assertEqual(other.status, 422, (name, other))
                self.assertIn("Idempotency-Key", other.json["detail"], name)
            self.assertEqual(scene.post("commands?dry_run=1", BLUE, headers=key).status, 422)
            self.assertEqual(scene.info()["revision"], revision)
            self.assertEqual(sorted(self.listed()), scenes)
        self.assertEqual(self.server.call("DELETE", scene.path).status, 204)
        self.assertEqual(self.server.post("/v1/scenes", wanted, headers={"Idempotency-Key": "new"}).status, 201)


if __name__ == "__main__":
    unittest.main()
