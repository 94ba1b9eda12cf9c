"""A server with room for few scenes: the others are evicted and opened again."""

import json
import pathlib
import re
import socket
import unittest
from concurrent.futures import ThreadPoolExecutor

from support.nightly import nightly
from support.server import Server, comb


def gauges(server):
    lines = server.get("/metrics").body.decode().splitlines()
    return {line.split()[0]: float(line.split()[1]) for line in lines if line.startswith("pelage_scene")}


class Memory(unittest.TestCase):
    def setUp(self):
        self.server = Server(arguments=["--memory", "1M"])
        self.addCleanup(lambda: self.server.close())

    @nightly
    def test_evicted_scenes_are_listed_and_opened_again(self):
        scenes = [self.server.new_scene("sphere", 2000) for _ in range(3)]
        for scene in scenes:
            self.assertEqual(scene.run(comb([-0.5, 0, 0.5], [0.5, 0, 0.5], radius=0.3)).status, 200)
        listed = self.server.get("/v1/scenes").body
        before = gauges(self.server)
        self.assertEqual(before["pelage_scene_memory_budget_bytes"], 1 << 20)
        self.assertEqual(before["pelage_scenes"], 3)
        self.assertGreater(before["pelage_scenes_evicted"], 0)
        pictures = [self.server.get(f"{scene.path}/frame.png?width=64&height=64").body for scene in scenes]
        again = [self.server.get(f"{scene.path}/frame.png?width=64&height=64").body for scene in scenes]
        self.assertEqual(pictures, again)
        self.assertEqual(self.server.get("/v1/scenes").body, listed)
        self.assertGreater(gauges(self.server)["pelage_scene_reopenings_total"], before["pelage_scene_reopenings_total"])
        self.assertEqual(self.server.terminate(), 0)
        self.server.start()
        self.assertEqual(self.server.get("/v1/scenes").body, listed)
        self.assertEqual(scenes[0].post("undo").status, 200)

    def test_copies_of_the_renderer_count_once_they_are_drawn(self):
        scene = self.server.new_scene("sphere", 2000)
        scene.thin_out()
        before = gauges(self.server)
        self.assertEqual(before["pelage_scene_copies_bytes"], 0)
        self.assertEqual(self.server.get(f"{scene.path}/frame.png?width=64&height=64").status, 200)
        after = gauges(self.server)
        self.assertGreater(after["pelage_scene_copies_bytes"], 100_000)
        self.assertEqual(after["pelage_scene_memory_bytes"] - before["pelage_scene_memory_bytes"],
                         after["pelage_scene_copies_bytes"])
        self.assertIn("pelage_gl_bytes", self.server.get("/metrics").body.decode())

    def test_a_budget_that_is_none_is_refused(self):
        for text in ("lots", "0", "-1G"):
            with self.assertRaisesRegex(AssertionError, "--memory"):
                Server(arguments=["--memory", text]).close()


class Coats(unittest.TestCase):
    """Slices of a coat seen closely take 90 MB, and half a gigabyte while they are baked."""

    def setUp(self):
        self.server = Server(gl="osmesa")  # shells alone take slices
        self.addCleanup(self.server.close)

    def metric(self, name):
        return next(float(line.split()[1]) for line in self.server.get("/metrics").body.decode().splitlines()
                    if line.startswith(name))

    def peak_bytes(self):
        status = pathlib.Path(f"/proc/{self.server.process.pid}/status").read_text()
        return 1024 * int(re.search(r"VmHWM:\s+(\d+)", status)[1])

    def test_equal_cold_frames_bake_their_coat_once(self):
        scene, before = self.server.new_scene("sphere", 2000), self.peak_bytes()
        shells = {"width": 96, "height": 96, "quality": {"method": "shells", "shells": {"count": 4}}}
        with ThreadPoolExecutor(6) as pool:
            answers = list(pool.map(lambda _: scene.frame(**shells), range(6)))
        self.assertEqual(len({answer.body for answer in answers}), 1)
        self.assertEqual(self.metric("pelage_coats_baked_total"), 1)
        self.assertLess(self.peak_bytes() - before, 1.5e9)

    def test_a_bake_that_all_have_left_ends(self):
        scene = self.server.new_scene("sphere", 2000)
        body = json.dumps({"quality": {"method": "shells"}}).encode()
        request = (f"POST {scene.path}/frames HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\n"
                   f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n").encode() + body
        for _ in range(3):
            with socket.create_connection(("127.0.0.1", self.server.port)) as client:
                client.sendall(request)
        self.assertEqual(scene.frame(quality="draft", width=32, height=32).status, 200)
        self.assertEqual(self.server.get("/livez").status, 200)


if __name__ == "__main__":
    unittest.main()
