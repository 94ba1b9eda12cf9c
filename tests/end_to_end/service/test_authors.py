"""Authors of changes."""

import json
import unittest

from support.pictures import hdr, png
from support.server import ServedTest, author, flood

TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"


class Authors(ServedTest):
    def setUp(self):
        self.scene = self.server.new_scene("plane", 50)

    def authors(self, scene=None):
        return [entry["author"] for entry in self.server.get(f"{(scene or self.scene).path}/log").json["entries"]]

    def test_every_change_keeps_its_author(self):
        self.scene.run(flood([1, 0, 0]), headers=author("Ann"))
        self.scene.run(flood([0, 0, 1]))
        self.scene.post("undo", {}, headers=author("Ben"))
        self.scene.post("redo", {}, headers=author("Cy"))
        self.scene.post("revert", {"revision": 1}, headers=author("Di"))
        self.scene.run(flood([0, 0, 1]), headers=author("Eve"))
        self.assertEqual(self.authors(), ["Ann", "", "Ben", "Cy", "Di", "Eve"])
        self.scene.post("amend", {"revision": 1, "commands": [flood([1, 0, 1])]}, headers=author("Flo"))
        self.assertEqual(self.authors()[6:], ["Flo"] * 3)

    def test_uploads_keep_their_author(self):
        self.server.call("PUT", f"{self.scene.path}/model?format=obj", TRIANGLE, headers=author("nobody"))
        files = {"environment": hdr([[[1, 1, 1]]]), "skin_texture": png([[[1, 2, 3]]]), "maps/length": png([[[1, 2, 3]]])}
        for name, content in files.items():
            answer = self.server.call("PUT", f"{self.scene.path}/{name}", content, headers=author(name))
            self.assertEqual(answer.status, 200, answer)
        self.assertEqual(self.authors(), list(files))

    def test_a_branch_has_the_authors_of_its_log(self):
        self.scene.run(flood([1, 0, 0]), headers=author("Ann"))
        side = self.scene.post("branch", {"name": "side"}, headers=author("Ben")).json["id"]
        self.assertEqual([e["author"] for e in self.server.get(f"/v1/scenes/{side}/log").json["entries"]], ["Ann"])

    def test_names_come_back_as_they_were(self):
        names = ["Zoë Ångström", "100%41", "羊毛", "a, b; \"c\" \\", "é" * 100, "+ &=?"]
        for k, name in enumerate(names):
            self.assertEqual(self.scene.run(flood([1, k, 0]), headers=author(name)).status, 200)
        self.assertEqual(self.authors(), names)

    def test_names_that_are_refused(self):
        calls = (("POST", "commands", flood([1, 0, 0])), ("POST", "undo", {}), ("PUT", "environment", hdr([[[1, 1, 1]]])),
                 ("PUT", "maps/length", png([[[1, 2, 3]]])), ("PUT", "skin_texture", png([[[1, 2, 3]]])),
                 ("POST", "revert", {"revision": 0}), ("POST", "redo", {}), ("POST", "amend", {"revision": 1, "commands": []}))
        for method, name, body in calls:
            for bad in ("x" * 201, "%C3%A9" * 101, "a%00b", "a%0Db", "a%7F", "%FF", "%ED%A0%80"):
                answer = self.server.call(method, f"{self.scene.path}/{name}", body, headers={"Pelage-Author": bad})
                self.assert_problem(answer, 400)
                self.assertIn("200 bytes", answer.json["limit"])
        twice = f"POST {self.scene.path}/undo HTTP/1.1\r\nHost: localhost\r\nPelage-Author: a\r\nPelage-Author: b\r\n\r\n"
        self.assertIn(b" 400 ", self.server.raw(twice.encode(), timeout=3).split(b"\r\n")[0])
        self.assertEqual(self.authors(), [])

    def test_the_client_sends_and_shows_them(self):
        self.pelage("--author", "Zoë 100%41", "run", self.scene.id, "-", text=json.dumps(flood([1, 0, 0])))
        self.pelage("undo", self.scene.id)
        self.pelage("--author", "Ben", "redo", self.scene.id)
        self.assertEqual(self.authors(), ["Zoë 100%41", "", "Ben"])
        lines = self.pelage("log", self.scene.id).stdout.splitlines()
        self.assertRegex(lines[0], r"^ +1\* comb everywhere, 36 vertices, by Zoë 100%41$")
        self.assertRegex(lines[1], r"^ +2  undo, 36 vertices$")
        self.pelage("--author", "x" * 201, "undo", self.scene.id, code=3)


if __name__ == "__main__":
    unittest.main()
