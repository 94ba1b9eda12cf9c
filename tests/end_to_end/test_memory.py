"""A server with room for few scenes: the others are evicted and opened again."""

import unittest

from support.server import Server, comb


def gauges(server):
    lines = server.get("/metrics").body.decode().splitlines()
    return {line.split()[0]: float(line.split()[1]) for line in lines if line.startswith("pelage_scene")}


class Memory(unittest.TestCase):
    def setUp(self):
        self.server = Server(arguments=["--memory", "1M"])
        self.addCleanup(lambda: self.server.close())

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


if __name__ == "__main__":
    unittest.main()
