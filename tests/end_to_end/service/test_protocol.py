"""Revisions, conditions, repeated requests, waiting and picking."""

import concurrent.futures
import re
import socket
import threading
import time
import unittest

from support.server import ServedTest, Server, comb, flood


class Revisions(ServedTest):
    def test_if_match(self):
        scene = self.server.new_scene()
        self.assert_problem(scene.run(flood([0, 1, 0]), headers={"If-Match": '"5"'}), 412)
        for wrong in ("5", '"', '"x"', 'W/"0"', '"0", "1"', '""'):
            self.assert_problem(scene.run(flood([0, 1, 0]), headers={"If-Match": wrong}), 400)
        self.assertEqual(scene.info()["revision"], 0)
        self.assertEqual(scene.run(flood([0, 1, 0]), headers={"If-Match": '"0"'}).status, 200)
        self.assertEqual(scene.run(flood([1, 0, 0]), headers={"If-Match": "*"}).status, 200)
        self.assert_problem(scene.post("undo", {}, headers={"If-Match": '"1"'}), 412)
        self.assertEqual(scene.post("undo", {}, headers={"If-Match": '"2"'}).json["revision"], 3)

    def test_only_one_of_many_rivals_wins(self):
        scene = self.server.new_scene()
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            answers = list(pool.map(lambda k: scene.run(flood([k, 1, 0]), headers={"If-Match": '"0"'}).status, range(1, 9)))
        self.assertEqual(sorted(answers), [200] + [412] * 7)

    def test_revisions_are_never_used_twice(self):
        scene = self.server.new_scene()
        seen = [scene.run(flood([0, 1, 0])).json["revision"], scene.run(flood([1, 0, 0])).json["revision"],
                scene.post("undo", {"steps": 2}).json["revision"], scene.post("redo").json["revision"],
                scene.run(flood([0, 0, 1])).json["revision"], scene.post("revert", {"revision": 1}).json["revision"],
                scene.post("undo").json["revision"]]
        self.assertEqual(seen, [1, 2, 3, 4, 5, 6, 7])
        self.assert_problem(scene.post("redo", {"steps": 5}), 422)
        kinds = [entry["kind"] for entry in self.server.get(f"{scene.path}/log").json["entries"]]
        self.assertEqual(kinds, ["do", "do", "undo", "redo", "do", "revert", "undo"])

    def test_etags(self):
        scene = self.server.new_scene()
        scene.thin_out()
        first = self.server.get(scene.path)
        same = self.server.get(scene.path, headers={"If-None-Match": first.headers["etag"]})
        self.assertEqual((same.status, same.body), (304, b""))
        scene.run(flood([0, 1, 0]))
        self.assertEqual(self.server.get(scene.path, headers={"If-None-Match": first.headers["etag"]}).status, 200)
        picture = f"{scene.path}/frame.png?width=32&height=32"
        tag = self.server.get(picture).headers["etag"]
        self.assertEqual(self.server.get(picture, headers={"If-None-Match": tag}).status, 304)
        self.assertEqual(self.server.get(picture, headers={"If-None-Match": '"0"'}).status, 200)


class Idempotency(ServedTest):
    def test_a_repeated_request_is_run_once(self):
        scene = self.server.new_scene()
        key = {"Idempotency-Key": "a1"}
        first = scene.run(flood([0, 1, 0]), headers=key)
        again = scene.run(flood([0, 1, 0]), headers=key)
        self.assertEqual((first.status, first.body, first.headers["etag"]), (again.status, again.body, again.headers["etag"]))
        self.assertEqual(scene.info()["revision"], 1)
        self.assert_problem(scene.run(flood([1, 0, 0]), headers=key), 422)
        self.assert_problem(scene.run(flood([0, 1, 0]), headers=key, query="?dry_run=1"), 422)
        self.assertEqual(self.server.new_scene().run(flood([0, 1, 0]), headers=key).status, 200)

    def test_a_change_is_known_after_a_kill(self):
        server = Server()
        self.addCleanup(server.close)
        scene = server.new_scene()
        made = [scene.run(flood([0, 1, 0]), headers={"Idempotency-Key": "a"}), scene.post("undo", {}, headers={"Idempotency-Key": "b"})]
        self.assertEqual([answer.status for answer in made], [200, 200])
        server.kill()
        server.start()
        again = [scene.run(flood([0, 1, 0]), headers={"Idempotency-Key": "a"}), scene.post("undo", {}, headers={"Idempotency-Key": "b"})]
        for first, answer in zip(made, again):
            expected = first.json | {"results": []}
            self.assertEqual((answer.status, answer.json, answer.headers["etag"]), (200, expected, first.headers["etag"]))
        self.assertEqual(scene.info()["revision"], 2)
        self.assertEqual(scene.run(flood([0, 1, 0]), headers={"Idempotency-Key": "c"}).json["revision"], 3)

    def test_what_failed_may_be_tried_again(self):
        scene = self.server.new_scene()
        key = {"Idempotency-Key": "b1"}
        self.assert_problem(scene.run({"op": "comb"}, headers=key), 422)
        self.assertEqual(scene.run(flood([0, 1, 0]), headers=key).status, 200)
        self.assert_problem(scene.run(flood([0, 1, 0]), headers={"Idempotency-Key": "x" * 201}), 400)

    def test_scenes_are_made_once(self):
        body = {"name": "once", "model": {"builtin": "plane", "triangles": 2}}
        made = [self.server.post("/v1/scenes", body, headers={"Idempotency-Key": "c1"}) for _ in range(3)]
        self.assertEqual({answer.headers["location"] for answer in made}, {made[0].headers["location"]})
        self.assertEqual(sum(scene["name"] == "once" for scene in self.server.get("/v1/scenes").json["scenes"]), 1)

    def test_at_the_same_time(self):
        scene = self.server.new_scene("sphere", 10000)
        batch = [comb([0, 0, -0.5], [0, 0.3, 0.5], radius=0.5, lean=0.5 + k / 100) for k in range(30)]
        with concurrent.futures.ThreadPoolExecutor(6) as pool:
            answers = list(pool.map(lambda _: scene.run(*batch, headers={"Idempotency-Key": "d1"}), range(6)))
        self.assertTrue(all(answer.status in (200, 409) for answer in answers), answers)
        self.assertEqual(scene.info()["revision"], 1)


class Waiting(ServedTest):
    def test_news_end_a_wait(self):
        scene = self.server.new_scene("plane", 2)
        scene.thin_out()
        timer = threading.Timer(0.7, lambda: scene.run(flood([1, 0, 0], lean=0.9)))
        begin = time.monotonic()
        timer.start()
        answer = self.server.get(f"{scene.path}/frame.png?width=16&height=16&after=1&wait=20")
        timer.join()
        self.assertEqual(answer.status, 200, answer)
        self.assertEqual(answer.headers["pelage-revision"], "2")
        self.assertGreater(time.monotonic() - begin, 0.6)

    def test_no_news(self):
        scene = self.server.new_scene("plane", 2)
        for query in ("after=0", "after=0&wait=0", "after=0&wait=0.3", "after=7"):
            answer = self.server.get(f"{scene.path}/frame.png?{query}")
            self.assertEqual((answer.status, answer.body, answer.headers["etag"]), (304, b"", '"0"'))
        self.assertEqual(scene.post("frames?after=0&wait=0.2", {}).status, 304)

    def test_old_news_are_answered_at_once(self):
        scene = self.server.new_scene("plane", 2)
        scene.thin_out()
        self.assertEqual(scene.post("frames?after=0&wait=20", {"width": 8, "height": 8}).status, 200)

    def test_bad_waits(self):
        scene = self.server.new_scene("plane", 2)
        for query, pointer in (("after=0&wait=26", "/wait"), ("after=0&wait=-1", "/wait"), ("after=0&wait=nan", "/wait"),
                               ("wait=1", "/after"), ("after=-1", "/after"), ("after=x", "/after"), ("after=1e3", "/after")):
            self.assert_problem(self.server.get(f"{scene.path}/frame.png?{query}"), 422, pointer)

    def test_a_scene_that_goes_away(self):
        scene = self.server.new_scene("plane", 2)
        timer = threading.Timer(0.5, lambda: self.server.call("DELETE", scene.path))
        timer.start()
        answer = self.server.get(f"{scene.path}/frame.png?after=0&wait=20")
        timer.join()
        self.assert_problem(answer, 404)


class Views(ServedTest):
    def test_of_many_frames_for_one_view_the_newest_is_drawn(self):
        scene = self.server.new_scene("sphere", 2000)
        request = {"width": 256, "height": 256, "quality": "detailed", "view": "me"}
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            answers = list(pool.map(lambda _: scene.post("frames", request).status, range(8)))
        self.assertTrue(set(answers) <= {200, 409}, answers)
        self.assertIn(200, answers)
        self.assertIn(409, answers)

    def test_frames_that_nobody_waits_for_are_dropped(self):
        def frames_drawn():
            return int(re.search(r"pelage_frames_total (\d+)", self.server.get("/metrics").body.decode())[1])

        scene = self.server.new_scene("sphere", 2000)
        before = frames_drawn()
        body = b'{"width": 320, "height": 320, "quality": "detailed"}'
        head = f"POST {scene.path}/frames HTTP/1.1\r\nHost: localhost\r\nContent-Length: {len(body)}\r\n\r\n".encode()
        for _ in range(8):
            with socket.create_connection(("127.0.0.1", self.server.port)) as connection:
                connection.sendall(head + body)
                time.sleep(0.05)
        scene.frame()
        self.assertLess(frames_drawn() - before, 6)


class Picking(ServedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scene = cls.server.new_scene("sphere", 500)
        cls.view = {"camera": {"auto": "front"}, "width": 200, "height": 200}

    def pick(self, *pixel):
        return self.scene.post("pick", {"view": self.view, "pixel": pixel}).json

    def test_a_hit(self):
        hit = self.pick(100, 100)
        self.assertTrue(hit["hit"])
        self.assertAlmostEqual(sum(hit["barycentric"]), 1, places=6)
        self.assertGreater(hit["normal"][2], 0.95)
        self.assertGreater(hit["position"][2], 0)
        self.assertGreater(hit["length"], 0)

    def test_what_is_picked_can_be_combed(self):
        picks = [self.pick(60 + 20 * k, 100) for k in range(5)]
        samples = [{"triangle": p["triangle"], "barycentric": p["barycentric"]} for p in picks]
        answer = self.scene.run({"op": "comb", "stroke": {"samples": samples}, "lean": 1.0})
        self.assertGreater(answer.json["results"][0]["touched"], 0, answer)
        after = self.pick(100, 100)
        self.assertGreater(after["direction"][0], 0.5, "the fur lies along +X, where the stroke went")

    def test_a_miss(self):
        self.assertEqual(self.pick(0, 0), {"hit": False})


if __name__ == "__main__":
    unittest.main()
