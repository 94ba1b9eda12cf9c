"""Branches, amendments, checkpoints and pictures of differences, over HTTP and with the client."""

import json
import pathlib
import tempfile
import unittest

from support.server import ServedTest, comb, flood

BLUE, RED = ({"op": "paint", "field": "tip_colour", "colour": colour, "flood": True} for colour in ("#0000ff", "#ff0000"))


def steps_of(scene):
    return scene.server.get(f"{scene.path}/log?format=jsonl").body.decode().splitlines()


class Amend(ServedTest):
    def groomed(self):
        scene = self.server.new_scene("sphere", 2000)
        for step in (flood([0, -1, 0], lean=0.6), comb([-0.5, 0, 0.5], [0.5, 0, 0.5], radius=0.3), BLUE,
                     {"op": "smooth", "flood": True, "passes": 2}):
            self.assertEqual(scene.run(step).status, 200)
        return scene

    def test_an_amended_log_replays_to_the_same_fields(self):
        scene = self.groomed()
        before = scene.info()
        other = comb([0, -0.5, 0.5], [0, 0.5, 0.5], radius=0.4)
        answer = scene.post("amend", {"revision": 2, "commands": [other]})
        self.assertEqual(answer.status, 200, answer)
        self.assertEqual([result["op"] for result in answer.json["results"]], ["comb", "paint", "smooth"])
        self.assertEqual(answer.headers["etag"], '"8"')
        lines = steps_of(scene)
        self.assertEqual([json.loads(line)["op"] for line in lines], ["comb", "comb", "paint", "smooth"])
        anew = self.server.new_scene("sphere", 2000)
        for line in lines:
            self.assertEqual(anew.run(json.loads(line)).status, 200)
        self.assertEqual(anew.info()["fields_hash"], scene.info()["fields_hash"])
        self.assertNotEqual(before["fields_hash"], scene.info()["fields_hash"])
        entries = self.server.get(f"{scene.path}/log").json["entries"]
        self.assertEqual([entry["kind"] for entry in entries], ["do"] * 4 + ["revert"] + ["replay"] * 3)
        self.assertEqual([entry["revision"] for entry in entries if entry["in_effect"]], [1, 6, 7, 8])
        self.assertEqual([line[:8] for line in self.pelage("log", scene.id).stdout.splitlines()][:2], ["     1* ", "     2  "])
        self.assertEqual(scene.post("undo").json["fields_hash"], before["fields_hash"])
        self.assertEqual(scene.post("redo").json["fields_hash"], answer.json["fields_hash"])

    def test_what_is_refused_changes_nothing(self):
        scene = self.server.new_scene("sphere", 500)
        fan = {"name": "fan", "source": [0, 3, 0], "direction": [0, -1, 0]}
        self.assertEqual(scene.run({"op": "set_blowers", "blowers": [fan]}).status, 200)
        self.assertEqual(scene.run({"op": "blow", "blower": "fan"}).status, 200)
        before = scene.info()
        problem = scene.post("amend", {"revision": 1, "commands": []})
        self.assert_problem(problem, 422, "/commands")
        self.assertIn("revision 2", problem.json["detail"])
        self.assert_problem(scene.post("amend", {"revision": 9, "commands": []}), 422, "/revision")
        self.assert_problem(scene.post("amend", {"revision": 2, "commands": [{"op": "blow", "blower": "fen"}]}), 422, "/commands/0/blower")
        self.assert_problem(scene.post("amend", {"revision": 2}), 422, "/commands")
        self.assert_problem(scene.post("amend", {"revision": 2, "commands": []}, headers={"If-Match": '"1"'}), 412)
        tried = scene.post("amend?dry_run=1", {"revision": 2, "commands": [flood([1, 0, 0])]})
        self.assertEqual(tried.status, 200, tried)
        self.assertGreater(tried.json["results"][0]["touched"], 0)
        self.assertEqual(scene.info(), before)

    def test_the_client_amends(self):
        scene = self.groomed()
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "red.json"
            file.write_text(json.dumps(RED))
            self.assertIn("nothing is changed", self.pelage("amend", scene.id, 3, file, "--dry-run").stdout)
            self.assertEqual(scene.info()["revision"], 4)
            self.pelage("amend", scene.id, 3, file)
        self.assertEqual(json.loads(steps_of(scene)[2])["colour"], "#ff0000")
        replayed = self.server.get(f"{scene.path}/log").json["entries"][-2]
        answer = json.loads(self.pelage("amend", scene.id, replayed["revision"], "--drop", "--json").stdout)
        self.assertEqual(answer["revision"], scene.info()["revision"])
        self.assertEqual([json.loads(line)["op"] for line in steps_of(scene)], ["comb", "comb", "smooth"])
        self.assertIn("in effect", self.pelage("amend", scene.id, 1000, "--drop", code=3).stderr)
        self.pelage("amend", scene.id, 1, code=2)
        self.pelage("amend", scene.id, 1, "--drop", "--if-match", 1, code=3)


class Branch(ServedTest):
    def test_a_branch_changes_independently(self):
        scene = self.server.new_scene("sphere", 2000)
        thin = {"op": "set_coat", "coat": {"count": 2000}}
        scene.run(thin, comb([-0.5, 0, 0.5], [0.5, 0, 0.5], radius=0.3))
        first = scene.info()
        scene.run(BLUE)
        answer = scene.post("branch", {"name": "red one", "revision": 1})
        self.assertEqual(answer.status, 201, answer)
        self.assertEqual(answer.headers["location"], f"/v1/scenes/{answer.json['id']}")
        self.assertEqual(answer.headers["etag"], '"1"')
        self.assertEqual({**answer.json, "id": "", "name": ""}, {**first, "id": "", "name": ""})
        side = type(scene)(self.server, answer.json["id"])
        side.run(RED)
        blue, red = (one.frame(background="transparent").image.astype(int) for one in (scene, side))
        self.assertGreater((blue[..., 2] - blue[..., 0])[48:80, 48:80].mean(), 20)
        self.assertGreater((red[..., 0] - red[..., 2])[48:80, 48:80].mean(), 20)
        again = scene.frame(background="transparent").image.astype(int)
        self.assertEqual(abs(again - blue).max(), 0, "the two do not share what the renderer keeps")
        self.assertEqual(self.server.call("DELETE", scene.path).status, 204)
        self.assertEqual(abs(side.frame(background="transparent").image.astype(int) - red).max(), 0)
        self.assertEqual(side.post("undo", {"steps": 2}).status, 200)

    def test_refusals(self):
        scene = self.server.new_scene("plane", 50)
        self.assert_problem(scene.post("branch", {"revision": 1}), 422, "/revision")
        self.assert_problem(scene.post("branch", {"name": "x" * 201}), 422, "/name")
        self.assert_problem(self.server.post("/v1/scenes/none/branch", {}), 404)
        self.assertEqual(scene.post("branch").json["name"], "branch")
        key = {"Idempotency-Key": "once"}
        ids = {scene.post("branch", {}, headers=key).json["id"] for _ in range(2)}
        self.assertEqual(len(ids), 1)

    def test_the_client_branches(self):
        scene = self.server.new_scene("sphere", 500)
        scene.run(flood([0, -1, 0]))
        identifier = self.pelage("branch", scene.id, "side").stdout.strip()
        self.assertEqual(json.loads(self.pelage("info", "side", "--json").stdout)["id"], identifier)
        early = json.loads(self.pelage("branch", scene.id, "early", "--revision", 0, "--json").stdout)
        self.assertEqual(early["revision"], 0)
        self.assertIn("revision", self.pelage("branch", scene.id, "late", "--revision", 5, code=3).stderr)


class Difference(ServedTest):
    def yellow(self, image, side):
        """Returns green minus blue in the left or right half of the middle; it is above 0 for tan fur."""
        columns = slice(26, 34) if side == "left" else slice(62, 70)
        return (image[44:52, columns, 1].astype(int) - image[44:52, columns, 2]).mean()

    def test_a_picture_shows_where_the_fields_have_changed(self):
        scene = self.server.new_scene("sphere", 2000)
        view = {"camera": {"auto": "front"}, "width": 96, "height": 96}
        scene.run({"op": "checkpoint", "name": "start"})
        sphere = {"centre": [0.8, 0, 0.6], "radius": 0.25}
        self.assertEqual(scene.run({"op": "mask", "sphere": sphere, "combine": "subtract"}).status, 200)
        now = scene.info()["revision"]
        same, changed = (scene.frame(**view, overlay="difference", overlay_from=revision).image for revision in (now, 0))
        for image, side, minimum, maximum in ((same, "left", -20, 40), (same, "right", -20, 40), (changed, "left", -20, 40), (changed, "right", 80, 255)):
            self.assertGreater(self.yellow(image, side), minimum, side)
            self.assertLess(self.yellow(image, side), maximum, side)
        address = f"{scene.path}/frame.png?camera=front&width=96&height=96&overlay=difference&overlay_from=0"
        self.assertEqual(self.server.get(address).body, scene.frame(**view, overlay="difference", overlay_from=0).body)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "changed.png"
            self.pelage("frame", scene.id, "-o", file, "--camera", "front", "--width", 96, "--height", 96, "--overlay", "difference", "--from", 0)
            self.assertEqual(file.read_bytes(), scene.frame(**view, overlay="difference", overlay_from=0).body)
        self.assert_problem(scene.post("frames", {**view, "overlay": "difference", "overlay_from": now + 1}), 422, "/overlay_from")
        self.assert_problem(scene.post("frames", {**view, "overlay": "difference"}), 422, "/overlay_from")
        self.assert_problem(scene.post("frames", {**view, "overlay_from": 0}), 422, "/overlay_from")
        self.pelage("frame", scene.id, "--overlay", "difference", "--from", 99, code=3)

    def test_revisions_of_an_earlier_model_cannot_be_compared_with(self):
        scene = self.server.new_scene("sphere", 500)
        scene.run(flood([0, -1, 0]))
        model = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        self.assertEqual(self.server.call("PUT", f"{scene.path}/model?format=obj&discard=1", model).status, 200)
        self.assert_problem(scene.post("frames", {"overlay": "difference", "overlay_from": 1}), 422, "/overlay_from")
        self.assertEqual(scene.frame(overlay="difference", overlay_from=2).status, 200)


class Checkpoints(ServedTest):
    def test_a_name_that_moves_with_an_amendment(self):
        scene = self.server.new_scene("sphere", 2000)
        scene.run(comb([-0.5, 0, 0.5], [0.5, 0, 0.5], radius=0.3))
        scene.run({"op": "checkpoint", "name": "combed"})
        scene.run(BLUE)
        other = comb([0, -0.5, 0.5], [0, 0.5, 0.5], radius=0.4)
        self.assertEqual(scene.post("amend", {"revision": 1, "commands": [other]}).status, 200)
        erased = scene.run({"op": "erase", "checkpoint": "combed", "flood": True, "brush": {"strength": 1}})
        self.assertEqual(erased.status, 200, erased)
        anew = self.server.new_scene("sphere", 2000)
        anew.run(other)
        self.assertEqual(erased.json["fields_hash"], anew.info()["fields_hash"])
        comparison = self.server.get(f"{scene.path}/compare?from=3&to={erased.json['revision']}").json
        self.assertIn("tip_colour", [field["field"] for field in comparison["fields"]])


class Lines(ServedTest):
    def test_of_no_steps_there_are_none(self):
        scene = self.server.new_scene()
        answer = self.server.get(f"{scene.path}/log?format=jsonl", timeout=20)
        self.assertEqual((answer.status, answer.body, answer.headers["content-type"]), (200, b"", "application/jsonl"))


class Restart(ServedTest):
    def test_branches_and_amendments_outlive_a_kill(self):
        server = self.server
        scene = server.new_scene("sphere", 1000)
        for step in (flood([0, -1, 0], lean=0.6), BLUE, comb([-0.5, 0, 0.5], [0.5, 0, 0.5], radius=0.3)):
            scene.run(step)
        side = type(scene)(server, scene.post("branch", {"revision": 2}).json["id"])
        self.assertEqual(scene.post("amend", {"revision": 1, "commands": []}).status, 200)
        before = [one.info() for one in (scene, side)]
        server.kill()
        server.start()
        self.assertEqual([one.info() for one in (scene, side)], before)
        self.assertEqual(len(steps_of(scene)), 2)
        self.assertEqual(scene.post("undo").status, 200)
        self.assertEqual(len(steps_of(scene)), 3)
        self.assertEqual(side.post("undo", {"steps": 2}).status, 200)


if __name__ == "__main__":
    unittest.main()
