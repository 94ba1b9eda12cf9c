"""Events that end other programs: signals, numbers beyond a library's range, memory that runs out."""

import itertools
import os
import pathlib
import resource
import signal
import time
import unittest

import numpy

from support.server import Server, ServedTest


class Survival(ServedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scene = cls.server.new_scene("sphere", 2000)
        cls.scene.thin_out()

    def test_a_ray_from_beyond_the_limits_is_refused(self):
        far = 1e19
        for body, pointer in (({"ray": {"origin": [far, 0, 0], "direction": [0, 1, 0]}}, "/ray/origin"),
                              ({"nearest": [0, far, 0]}, "/nearest"),
                              ({"view": {"camera": {"position": [0, 0, far], "target": [0, 0, 0]}}, "pixel": [10, 10]},
                               "/view/camera/position"),
                              ({"view": {"camera": {"position": [0, 0, 3], "target": [far, 0, 0]}}, "pixel": [10, 10]},
                               "/view/camera/target")):
            answer = self.scene.post("pick", body)
            self.assert_problem(answer, 422, pointer)
            self.assertIn("sizes", answer.json["limit"])

    def test_a_ray_within_the_limits_hits_or_passes_by(self):
        for origin in ([0, 1e5, 0], [1e5, 1e5, 1e5], [-1e5, 0, 0]):
            for direction in ([0, -1, 0], [1, 0, 0], [1e5, 0, 1]):
                self.assertEqual(self.scene.post("pick", {"ray": {"origin": origin, "direction": direction}}).status, 200)

    def test_a_frame_of_whiskers_of_a_million_sizes_ends(self):
        whiskers = [[[0, .8, .6], [1e5 * x, 1e5 * y, 1e5 * z], [far * x, far * y, far * z]]
                    for x, y, z in itertools.product((-1, 1), repeat=3) for far in numpy.linspace(8e5, 9e5, 30)]
        self.assertEqual(self.scene.run(
            {"op": "set_curves", "groups": [{"curves": whiskers, "width_root": .0015, "width_tip": .0003}]}).status, 200)
        light = {"kind": "directional", "direction": [.4, -1, -.6], "intensity": 1.2, "cast_shadow": "hard"}
        self.assertEqual(self.scene.run({"op": "set_lights", "lights": [light]}).status, 200)
        self.scene.frame()

    def test_it_runs_again_after_sigstop_and_sigcont(self):
        process = self.server.process
        for _ in range(3):
            process.send_signal(signal.SIGSTOP)
            os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WNOWAIT)
            process.send_signal(signal.SIGCONT)
            self.assertEqual(self.server.get("/livez").status, 200)
        self.assertIsNone(process.poll())

    def test_signals_of_terminals_and_limits_do_not_end_it(self):
        for number in (signal.SIGHUP, signal.SIGXFSZ, signal.SIGPIPE):
            self.server.process.send_signal(number)
            time.sleep(0.05)
            self.assertIsNone(self.server.process.poll(), number.name)
            self.assertEqual(self.server.get("/livez").status, 200)


class FileSize(unittest.TestCase):
    """A limit on the size of files, as a shell's ulimit -f or a container sets it."""

    def test_a_file_beyond_the_limit_is_a_refusal(self):
        server = Server()
        self.addCleanup(server.close)
        scene = server.new_scene("sphere", 10_000)
        resource.prlimit(server.process.pid, resource.RLIMIT_FSIZE, (1 << 14, 1 << 14))
        answer = scene.run({"op": "noise", "flood": True, "amount": .5, "seed": 1})
        self.assertIn(answer.status, (500, 503), answer)
        self.assertEqual(server.get(scene.path).status, 200)
        self.assertEqual(scene.info()["revision"], 0)


@unittest.skipIf("PELAGE_SANITIZED" in os.environ, "a sanitizer ends the process where memory runs out")
class Memory(unittest.TestCase):
    """A limit on the process's memory: what does not fit is refused, and what fits is served."""

    def test_memory_that_runs_out_while_it_draws_is_a_refusal(self):
        server = Server(gl="none")
        self.addCleanup(server.close)
        scene = server.new_scene("sphere", 2000)
        scene.thin_out()
        scene.frame()  # all threads are there, and what they keep
        pages = int(pathlib.Path(f"/proc/{server.process.pid}/statm").read_text().split()[0])
        limit = pages * resource.getpagesize() + (200 << 20)
        resource.prlimit(server.process.pid, resource.RLIMIT_AS, (limit, resource.RLIM_INFINITY))
        for request in ({"width": 8192, "height": 8192}, {"width": 4096, "height": 4096, "format": "exr"},
                        {"width": 4096, "height": 4096, "quality": "reference"}):
            answer = scene.post("frames", {"quality": "interactive", **request})
            self.assertIn(answer.status, (413, 422, 503), answer)
            self.assertEqual(scene.frame().status, 200)
        resource.prlimit(server.process.pid, resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        self.assertEqual(server.terminate(), 0)


if __name__ == "__main__":
    unittest.main()
