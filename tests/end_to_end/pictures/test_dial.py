"""Budgets and errors through HTTP: the knobs are named, draw the same picture again, and stay."""

import json
import os
import subprocess
import tempfile
import threading
import time
import unittest

from support.contract import named
from support.server import BIN, THIN_COAT, Server, ServedTest, lines_of


def header(answer, name):
    return json.loads(answer.headers[name])


def cost_of(answer):
    timing = dict(part.strip().split(";dur=") for part in answer.headers["server-timing"].split(","))
    return float(timing["draw"])


class Dial(ServedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scene = cls.server.new_scene("torus", 800)
        cls.scene.run(THIN_COAT)

    def test_answers_say_what_the_contract_says(self):
        for request in ({"budget_ms": 60}, {"max_error": 0.5}, {"quality": "interactive"}, {}):
            answer = self.scene.frame(**request)
            named("FrameEstimate").validate(header(answer, "pelage-error"))
            named("Knobs").validate(header(answer, "pelage-quality"))
            self.assertGreater(cost_of(answer), 0)
        named("FrameRequest").validate({"budget_ms": 60})
        self.assertFalse(named("FrameRequest").is_valid({"budget_ms": 60, "quality": "draft"}))
        self.assertNotIn("pelage-error", self.scene.frame(quality={"scale": 0.9}).headers)

    def test_a_dry_run_says_what_tracing_takes(self):
        def seconds(**trace):
            quality = {"method": "strands", "trace": {"strands": 2000, **trace}}
            return self.scene.post("frames?dry_run=1", {"width": 256, "height": 256, "quality": quality}).json["seconds"]
        few, many = (seconds(passes=passes) for passes in (1, 65536))
        self.assertTrue(0 < few < many, (few, many))
        self.assertLessEqual(seconds(passes=65536, seconds=0.5), 0.5)

    def test_a_dry_run_says_what_a_frame_takes(self):
        costs = []
        for size in (100, 1000):
            answer = self.scene.post("frames?dry_run=1", {"width": size, "height": size, "quality": "detailed"})
            named("FrameCost").validate(answer.json)
            costs.append(answer.json["seconds"])
        self.assertLess(costs[0], costs[1])
        self.assert_problem(self.scene.post("frames?dry_run=2", {}), 422, "/dry_run")
        self.assert_problem(self.scene.post("frames?dry_run=1&after_pass=3", {}), 422, "/after_pass")
        knobs = {"raster": {"strands": 1000, "light_of": 1}, "scale": 1}
        long = {"width": 8000, "height": 8000, "quality": knobs, "max_seconds": 1}
        self.assert_problem(self.scene.post("frames", long), 422, "/max_seconds")

    def test_a_frame_that_is_drawn_is_listed(self):
        address = f"/v1/scenes/{self.scene.id}/frames"
        self.assertEqual(self.server.get(address).json, {"frames": []})
        request = {"width": 1500, "height": 1500, "quality": "detailed", "view": "slow"}
        drawing = threading.Thread(target=lambda: self.scene.frame(**request))
        drawing.start()
        seen = []
        while drawing.is_alive():
            listed = self.server.get(address).json
            named("FrameProgressList").validate(listed)
            seen += listed["frames"]
            time.sleep(0.01)
        drawing.join()
        self.assertEqual({(one["view"], one["width"]) for one in seen}, {("slow", 1500)})
        self.assertGreater(max(one["share"] for one in seen), 0)
        self.assertEqual(self.server.get(address).json, {"frames": []})

    def test_the_named_knobs_draw_the_same_picture(self):
        for request in ({"budget_ms": 30}, {"budget_ms": 2000}, {"max_error": 0.3}):
            planned = self.scene.frame(**request)
            again = self.scene.frame(quality=header(planned, "pelage-quality"))
            self.assertEqual(planned.body, again.body)
            self.assertEqual(header(again, "pelage-quality"), header(planned, "pelage-quality"))

    def test_get_and_post_agree(self):
        """The correction may move between two frames, so the knobs that the first one names are what is asked again."""
        got = self.server.get(f"{self.scene.path}/frame.png?width=128&height=128&max_error=0.5")
        self.assertEqual((got.status, header(got, "pelage-error")["end"]), (200, "error"))
        posted = self.scene.frame(max_error=0.5)
        self.assertEqual(header(posted, "pelage-error")["end"], "error")
        self.assertEqual(self.scene.frame(quality=header(got, "pelage-quality")).body, got.body)

    def test_the_ends(self):
        """No machine draws a large frame in the least budget."""
        scene = self.server.new_scene("torus", 800)  # whose correction is its own
        scene.run(THIN_COAT)
        too_large = {"budget_ms": 1, "width": 2048, "height": 2048}
        ends = [header(scene.frame(**request), "pelage-error")["end"]
                for request in (too_large, {"budget_ms": 600000}, {"max_error": 1}, {"max_error": 0.000001}, {})]
        self.assertEqual(ends, ["cheapest", "best", "error", "best", "asked"])

    def test_a_larger_budget_is_no_worse(self):
        """The correction may move from frame to frame, so budgets are held against each other where it was the same."""
        errors = {}  # by correction and safety, then by budget
        for budget in (1, 10, 30, 100, 1000) * 3:
            estimate = header(self.scene.frame(budget_ms=budget), "pelage-error")
            learnt = estimate["correction"], estimate["cost_safety"]
            errors.setdefault(learnt, {})[budget] = estimate["error"] * estimate["error_safety"]
        for by_budget in errors.values():
            falling = [error for _, error in sorted(by_budget.items())]
            self.assertEqual(falling, sorted(falling, reverse=True))
        self.assertTrue(any(len(by_budget) > 1 for by_budget in errors.values()), errors)

    def test_knobs_stay_while_the_correction_does(self):
        seen = {}
        for _ in range(12):
            answer = self.scene.frame(budget_ms=40)
            seen.setdefault(header(answer, "pelage-error")["correction"], set()).add(answer.headers["pelage-quality"])
        self.assertTrue(all(len(knobs) == 1 for knobs in seen.values()), seen)

    def test_a_missed_goal_is_reported(self):
        trace = {"strands": 20000, "passes": 4096, "seconds": 0.01}
        for request, missed in (({"budget_ms": 1, "width": 2048, "height": 2048}, "budget_ms"),
                                ({"max_error": 0.000001}, "max_error"),
                                ({"quality": {"method": "strands", "trace": trace}}, "seconds")):
            self.assertEqual(self.scene.frame(**request).headers.get("pelage-missed"), missed)
            path = f"path=/v1/scenes/{self.scene.id}/frames status=200 "
            self.assertTrue(lines_of(self.server, having=(path, f"missed {missed}")), missed)
        for request in ({"budget_ms": 600000}, {"max_error": 1}, {}):
            self.assertNotIn("pelage-missed", self.scene.frame(**request).headers)
        said = json.loads(self.pelage("--json", "frame", self.scene.id, "-o", self.server.folder / "missed.png",
                                      "--max-error", 0.000001).stdout)
        self.assertEqual(said["missed"], "max_error")

    def test_what_goes_with_a_dial(self):
        exr = self.scene.frame(budget_ms=50, format="exr", aovs=["beauty", "normal"])
        self.assertEqual(exr.headers["content-type"], "image/x-exr")
        self.scene.frame(budget_ms=50, overlay="length")
        trace = {"passes": 1, "strands": 2000}
        progressive = self.scene.frame(max_error=0.5, progressive=trace, view="dial")
        self.assertIn("pelage-trace", progressive.headers)
        self.assertIn("pelage-error", progressive.headers)
        better = self.scene.post(f"frames?after={progressive.headers['pelage-revision']}&after_pass=0&wait=25",
                                 {"width": 128, "height": 128, "max_error": 0.5, "progressive": trace, "view": "dial"})
        self.assertEqual(better.status, 200, better)
        self.assertEqual(header(better, "pelage-quality")["method"], "strands")

    def test_extremes(self):
        bald = self.server.new_scene("plane", 2, fur={"length": 0})
        long = self.server.new_scene("sphere", 100, fur={"length": 10})
        for scene in (bald, long):
            scene.run(THIN_COAT)
            for goal in ({"budget_ms": 1}, {"max_error": 1}):
                for size in ({"width": 1, "height": 1}, {"width": 8192, "height": 1}):
                    estimate = header(scene.frame(**goal, **size), "pelage-error")
                    self.assertTrue(0 < estimate["error"] <= 1 and 0 < estimate["cost_ms"] < 1e9, estimate)

    def test_the_client_asks_for_it(self):
        path = self.server.folder / "dial.png"
        said = json.loads(self.pelage("--json", "frame", self.scene.id, "-o", path, "--width", 64, "--height", 64,
                                      "--max-error", 0.5).stdout)
        self.assertEqual(said["estimate"]["end"], "error")
        self.pelage("frame", self.scene.id, "--budget-ms", 0, code=3)
        self.pelage("frame", self.scene.id, "--budget-ms", 40, "--quality", "draft", code=3)


class StoredCalibration(unittest.TestCase):
    def calibration_of(self, server):
        scene = server.new_scene("plane", 2)
        scene.run(THIN_COAT)
        return header(scene.frame(budget_ms=50, width=32, height=32), "pelage-error")["calibration"]

    def test_a_broken_file_is_reported_and_the_defaults_are_used(self):
        server = Server()
        self.addCleanup(server.close)
        self.assertEqual(self.calibration_of(server), "defaults")
        file = server.data / "calibration.json"
        for text, said in (("{", "is no calibration"), ('{"version": 3}', "field:   /version\n"),
                           ('{"name": "x"}', '"version" is missing.\n'), ("", "is no calibration")):
            server.terminate()
            file.write_text(text)
            server.start()
            self.assertIn(said, server.printed())
            self.assertIn("pelage calibrate", server.printed())
            self.assertEqual(self.calibration_of(server), "defaults")

    def test_a_calibration_counts_for_the_machine_that_it_was_measured_on(self):
        server = Server()
        self.addCleanup(server.close)
        description = server.printed().split(" with ", 1)[1].splitlines()[0]
        file = server.data / "calibration.json"
        for threads, name in ((server.threads, "2001-01-01"), (server.threads + 1, "defaults")):
            server.terminate()
            file.write_text(json.dumps({"version": 5, "name": "2001-01-01", "machine": description, "threads": threads,
                                        "price": 0.5}))
            server.start()
            self.assertEqual(self.calibration_of(server), name)
        self.assertRegex(server.printed(), fr"measured with {server.threads + 1} threads of .*\.\n  next:    .*`pelage calibrate`")

    def test_a_frame_that_passes_its_limit_is_stopped(self):
        """A calibration that is far too low lets a frame of minutes begin."""
        server = Server()
        self.addCleanup(server.close)
        description = server.printed().split(" with ", 1)[1].splitlines()[0]
        server.terminate()
        (server.data / "calibration.json").write_text(json.dumps(
            {"version": 5, "name": "2001-01-01", "machine": description, "threads": server.threads, "price": 1e-6}))
        server.start()
        scene = server.new_scene("torus", 800)
        frame = {"width": 4000, "height": 4000, "quality": {"scale": 2, "raster": {"strands": 1000, "light_of": 1}}, "max_seconds": 1}
        answer = scene.post("frames", frame)
        self.assertEqual((answer.status, answer.json.get("pointer")), (422, "/max_seconds"), answer)
        self.assertIn("took longer than 1 s", answer.json["detail"])
        self.assertEqual(scene.frame(quality="draft").status, 200)

    def test_calibrating_needs_a_gl(self):
        run = subprocess.run([BIN / "pelage", "calibrate", "--gl", "some"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 2, run)
        self.assertEqual(run.stderr.splitlines()[0], "--gl: some not in {auto,egl,none,osmesa}")

    def test_without_a_gl_each_reason_is_printed_once_with_a_next_step(self):
        with tempfile.TemporaryDirectory() as empty:
            run = subprocess.run([BIN / "pelaged", "--gl", "egl", "--data", empty], capture_output=True, text=True,
                                 env={**os.environ, "__EGL_VENDOR_LIBRARY_DIRS": empty})
        self.assertEqual(run.returncode, 4, run)
        said, following = run.stderr.splitlines()
        reasons = said.removeprefix("pelaged: no OpenGL 4.5: ").split("; ")
        self.assertEqual(len(set(reasons)), len(reasons), said)
        self.assertTrue(following.startswith("  next:    "), run.stderr)


if __name__ == "__main__":
    unittest.main()
