"""Settings of a scene, read and sent back over HTTP."""

import unittest

from support.contract import named
from support.server import ServedTest, flood

NAMES = {"curves": ("set_curves", "groups"), "skin": ("set_skin", "regions"), "skin_texture": ("set_skin_texture", "picture")}
SET = ("coats", "look", "lights", "environment", "ground", "wind", "eyes", "curves", "skin", "skin_texture", "blowers", "attractors", "symmetry")


def command(member, value):
    op, name = NAMES.get(member, (f"set_{member}", member))
    return {"op": op, name: value}


class Settings(ServedTest):
    def settings(self, scene, query=""):
        answer = self.server.get(f"{scene.path}/settings{query}")
        self.assertEqual(answer.status, 200, answer)
        named("Settings").validate(answer.json)
        self.assertEqual(answer.headers["etag"], f'"{answer.json["revision"]}"')
        return answer.json

    def test_what_is_read_and_sent_back_changes_nothing(self):
        for builtin in ("creature", "sphere"):
            scene = self.server.new_scene(builtin, 3000)
            settings = self.settings(scene)
            self.assertEqual(set(settings), {*SET, "revision", "checkpoints", "edit_layers"})
            for member in SET:
                answer = scene.run(command(member, settings[member]))
                self.assertEqual((answer.status, answer.json.get("revision")), (200, 0), f"{member} {answer}")
                self.assertEqual(answer.json["results"][0]["touched"], 0)

    def test_one_member_is_changed_and_sent_back(self):
        scene = self.server.new_scene("creature", 3000)
        coat = self.settings(scene)["coats"][0]["coat"]
        self.assertEqual(scene.run({"op": "set_coat", "coat": {**coat, "bend": 0.75}}).json["revision"], 1)
        settings = self.settings(scene)
        self.assertEqual(settings["coats"][0]["coat"], {**coat, "bend": 0.75})
        eyes = [{**eye, "wetness": 0.25} for eye in settings["eyes"]]
        self.assertEqual(len(eyes), 2)
        self.assertEqual(scene.run(command("eyes", eyes)).json["revision"], 2)
        self.assertEqual(self.settings(scene)["eyes"], eyes)

    def test_earlier_revisions(self):
        scene = self.server.new_scene("creature", 3000)
        first = self.settings(scene)
        scene.run(command("eyes", []))
        scene.run({"op": "checkpoint", "name": "eyeless"})
        scene.run({"op": "edit_layer", "name": "mane", "weight": 0.5})
        now = self.settings(scene)
        self.assertEqual((now["eyes"], now["revision"]), ([], 3))
        self.assertEqual(now["checkpoints"], [{"name": "eyeless", "revision": 2}])
        self.assertEqual(now["edit_layers"], scene.info()["edit_layers"])
        self.assertEqual(self.settings(scene, "?revision=0"), first)
        self.assertEqual(self.settings(scene, "?revision=3"), now)
        scene.post("undo", {"steps": 3})
        self.assertEqual(self.settings(scene), {**first, "revision": 4})
        path = f"{scene.path}/settings"
        for query, pointer in (("revision=5", "/revision"), ("revision=-1", "/revision"), ("revision=x", "/revision"), ("rev=1", "/rev")):
            self.assert_problem(self.server.get(f"{path}?{query}"), 422, pointer)
        self.assert_problem(self.server.get("/v1/scenes/none/settings"), 404)
        self.assert_problem(self.server.post(path, {}), 405)
        model = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        self.assertEqual(self.server.call("PUT", f"{scene.path}/model?format=obj", model).status, 200)
        self.assert_problem(self.server.get(f"{path}?revision=4"), 422, "/revision")
        self.assertEqual(self.settings(scene)["eyes"], [])

    def test_not_modified(self):
        scene = self.server.new_scene("sphere", 500)
        path = f"{scene.path}/settings"
        self.assertEqual(self.server.get(path, headers={"If-None-Match": '"0"'}).status, 304)
        scene.run(flood([0, -1, 0]))
        self.assertEqual(self.server.get(path, headers={"If-None-Match": '"0"'}).status, 200)
        old = self.server.get(f"{path}?revision=0", headers={"If-None-Match": '"0"'})
        self.assertEqual((old.status, old.headers["etag"]), (304, '"0"'))


if __name__ == "__main__":
    unittest.main()


class FirstGround(ServedTest):
    """A scene may begin with a ground, which is then no step that undo would take away."""

    def check(self, info):
        settings = self.server.get(f"/v1/scenes/{info['id']}/settings").json
        self.assertTrue(settings["ground"]["visible"])
        self.assertEqual(info["undo_steps"], 0)

    def test_a_new_scene(self):
        answer = self.server.post("/v1/scenes", {"name": "on ground", "model": {"builtin": "sphere", "triangles": 500}, "ground": True})
        self.check(answer.json)
        self.assertEqual(self.server.post(f"/v1/scenes/{answer.json['id']}/undo", {}).status, 422)
        self.check(self.server.get(f"/v1/scenes/{answer.json['id']}").json)

    def test_a_model_that_comes_later(self):
        scene = self.server.new_scene("sphere", 500)
        self.assertFalse(self.server.get(f"{scene.path}/settings").json["ground"]["visible"])
        self.assertEqual(self.server.call("PUT", f"{scene.path}/model?format=obj&ground=true", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").status, 200)
        self.check(scene.info())
