"""Traced pictures over HTTP: to the end, and as the progressive picture of a rasterized one."""

import json
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy

from support.nightly import nightly
from support.server import THIN_COAT, Server, ServedTest, flood

SIZE = {"width": 96, "height": 96}
ROUNDS = 400  # requests that a loop makes at most


def thin_torus(server):
    """At revision 1."""
    scene = server.new_scene("torus", 500)
    scene.run(THIN_COAT)
    return scene


def trace_of(answer):
    return json.loads(answer.headers["pelage-trace"])


class Traced(ServedTest):
    def setUp(self):
        self.scene = thin_torus(self.server)
        self.addCleanup(self.server.call, "DELETE", self.scene.path)  # which ends its traces

    def ask(self, query="", *, progressive=None, scene=None, **request):
        """A request with progressive."""
        progressive = {"passes": 8, "strands": 20000} if progressive is None else progressive
        body = {**SIZE, "view": "artist", "progressive": progressive, **request}
        return (scene or self.scene).post(f"frames{query}", body)

    def better(self, revision, passes, *, wait=20, **request):
        return self.ask(f"?after={revision}&after_pass={passes}&wait={wait}", **request)

    def reference(self, trace=None, **request):
        trace = {"passes": 4, "strands": 20000, **(trace or {})}
        return self.scene.post("frames", {**SIZE, "quality": {"method": "strands", "trace": trace}, **request})

    def stroke(self):
        """Turns all fur, to another side each time."""
        self.side = -getattr(self, "side", -1)
        answer = self.scene.run(flood([self.side, 0.3, 0]))
        self.assertEqual(answer.status, 200, answer)
        return answer.json["revision"]

    # Progressive rendering to the end

    def test_reference_png(self):
        answer = self.reference()
        self.assertEqual(answer.status, 200, answer)
        self.assertEqual(answer.image.shape, (96, 96, 3))
        self.assertGreater(answer.image.std(), 5)
        trace = trace_of(answer)
        self.assertEqual((trace["passes"], trace["end"]), (4, "passes"))
        self.assertGreater(trace["strands"], 0)
        self.assertEqual(answer.headers["etag"], '"1.4"')
        quality = json.loads(answer.headers["pelage-quality"])
        self.assertEqual(quality["method"], "strands")
        for stage in ("queue", "upload", "draw", "grow", "trace", "read", "encode"):
            self.assertIn(stage + ";dur=", answer.headers["server-timing"])
        again = self.scene.post("frames", {**SIZE, "quality": quality})
        self.assertEqual(again.body, answer.body, "what Pelage-Quality says draws the same frame")

    def test_same_seed_and_passes_give_the_same_content(self):
        first = self.reference()
        self.assertEqual(self.reference().body, first.body)
        self.assertNotEqual(self.reference({"seed": 9}).body, first.body)
        one = Server(threads=1)
        try:
            scene = thin_torus(one)
            request = {**SIZE, "quality": {"method": "strands", "trace": {"passes": 4, "strands": 20000}}}
            self.assertEqual(scene.post("frames", request).body, first.body, "whatever --threads is")
        finally:
            one.close()

    def test_reference_exr(self):
        answer = self.reference(format="exr", aovs=["beauty", "depth", "normal"])
        self.assertEqual(answer.status, 200, answer)
        self.assertEqual(answer.headers["content-type"], "image/x-exr")
        for channel in (b"normal.X\0", b"Z\0", b"A\0"):
            self.assertIn(channel, answer.body[:2000])

    def test_reference_by_address(self):
        answer = self.server.get(f"{self.scene.path}/frame.png?width=32&height=32&quality=reference")
        self.assertEqual(answer.status, 200, answer)
        self.assertEqual(trace_of(answer)["passes"], 64)
        self.assertEqual(answer.headers["etag"], '"1.64"')
        known = self.server.get(f"{self.scene.path}/frame.png?width=32&height=32&quality=reference",
                                headers={"If-None-Match": '"1.64"'})
        self.assertEqual(known.status, 304)
        drawn = self.server.get(f"{self.scene.path}/frame.png?width=32&height=32", headers={"If-None-Match": '"1.64"'})
        self.assertEqual(drawn.status, 200, "what is rasterized is another picture")

    # ProgressivePicture

    def test_rasterized_first_and_then_better_and_better(self):
        plain = self.scene.frame(**SIZE)
        drawn = self.ask()
        self.assertEqual(drawn.status, 200, drawn)
        self.assertEqual(drawn.body, plain.body, "the request's own quality")
        self.assertNotIn("pelage-trace", plain.headers)
        self.assertEqual((trace_of(drawn)["passes"], trace_of(drawn)["end"]), (0, "none"))
        self.assertEqual(drawn.headers["etag"], '"1"')
        seen = []
        while not seen or trace_of(seen[-1])["end"] == "none":
            passes = trace_of(seen[-1])["passes"] if seen else 0
            answer = self.better(1, passes)
            self.assertEqual(answer.status, 200, answer)
            self.assertGreater(trace_of(answer)["passes"], passes)
            self.assertEqual(answer.headers["pelage-revision"], "1")
            self.assertEqual(answer.headers["etag"], f'"1.{trace_of(answer)["passes"]}"')
            seen.append(answer)
        self.assertEqual(trace_of(seen[-1])["passes"], 8)
        self.assertEqual(self.better(1, 8, wait=0.2).status, 304, "there is nothing better")
        self.assertEqual(self.better(1, 7, wait=0).body, seen[-1].body, "the last one stays")
        same = self.scene.post("frames", {**SIZE, "quality": json.loads(seen[-1].headers["pelage-quality"])})
        self.assertEqual(same.body, seen[-1].body, "a progressive picture ends where the reference does")

    def test_a_stroke_answers_a_rasterized_picture_of_the_new_revision(self):
        long = {"passes": 60000, "strands": 20000}
        self.ask(progressive=long)
        self.assertEqual(trace_of(self.better(1, 0, progressive=long))["passes"] > 0, True)
        waiting = {}
        waiter = threading.Thread(target=lambda: waiting.update(answer=self.better(1, 59999, progressive=long)))
        waiter.start()
        time.sleep(0.3)
        revision = self.stroke()
        waiter.join()
        drawn = waiting["answer"]
        self.assertEqual(drawn.headers["pelage-revision"], str(revision))
        self.assertEqual(trace_of(drawn)["passes"], 0)
        passes = 0
        for _ in range(3):
            answer = self.better(revision, passes, progressive=long)
            self.assertEqual(answer.headers["pelage-revision"], str(revision), "no picture of the old revision")
            self.assertGreater(trace_of(answer)["passes"], passes)
            passes = trace_of(answer)["passes"]
        old = self.better(1, 0, progressive=long)
        self.assertEqual(old.headers["pelage-revision"], str(revision))
        self.assertEqual(trace_of(old)["passes"], 0)
        undone = self.scene.post("undo").json["revision"]
        self.assertEqual(self.better(revision, 1, progressive=long).headers["pelage-revision"], str(undone))

    def test_progressive_rendering_starts_again_where_it_was_dropped(self):
        self.ask()
        self.scene.frame(**SIZE, view="artist")  # something else
        answer = self.better(1, 0)
        self.assertGreater(trace_of(answer)["passes"], 0)

    def test_two_views(self):
        left, right = {"view": "left"}, {"view": "right", "camera": {"auto": "back"}}
        for view in (left, right):
            self.assertEqual(self.ask(**view).status, 200)
        last = {}
        for view in (left, right):
            passes = 0
            for _ in range(ROUNDS):
                answer = self.better(1, passes, **view)
                passes = trace_of(answer)["passes"]
                if trace_of(answer)["end"] != "none":
                    break
            self.assertEqual(passes, 8)
            last[view["view"]] = answer
        self.assertFalse(numpy.array_equal(last["left"].image, last["right"].image))

    def test_grooming_works_beside_progressive_rendering(self):
        long = {"passes": 60000, "strands": 20000}
        self.ask(progressive=long)
        for _ in range(3):
            revision = self.stroke()
            self.assertEqual(self.scene.frame(**SIZE).headers["pelage-revision"], str(revision))
        self.assertEqual(self.better(1, 0, progressive=long).headers["pelage-revision"], str(revision))

    def test_superseded(self):
        outcome = {}
        request = {**SIZE, "view": "artist", "quality": {"method": "strands", "trace": {"passes": 60000}}}
        waiter = threading.Thread(target=lambda: outcome.update(answer=self.scene.post("frames", request)))
        waiter.start()
        time.sleep(0.5)
        self.assertEqual(self.scene.frame(**SIZE, view="artist").status, 200)
        waiter.join()
        self.assert_problem(outcome["answer"], 409)

    def test_scene_that_goes_away(self):
        scene = thin_torus(self.server)
        long = {"passes": 60000, "strands": 20000}
        self.ask(progressive=long, scene=scene)
        outcome = {}
        waiter = threading.Thread(target=lambda: outcome.update(answer=self.better(1, 50000, progressive=long, scene=scene)))
        waiter.start()
        time.sleep(0.3)
        self.assertEqual(self.server.call("DELETE", scene.path).status, 204)
        waiter.join()
        self.assert_problem(outcome["answer"], 404)
        self.assertEqual(self.reference().status, 200, "the tracer is free again")

    def test_server_that_stops(self):
        server = Server()
        try:
            scene = thin_torus(server)
            outcome = {}
            request = {**SIZE, "quality": {"method": "strands", "trace": {"passes": 60000}}}
            waiter = threading.Thread(target=lambda: outcome.update(answer=scene.post("frames", request)))
            waiter.start()
            self.ask(progressive={"passes": 60000}, scene=scene)
            time.sleep(0.5)
            self.assertEqual(server.terminate(), 0, server.printed())
            waiter.join()
            self.assertEqual(outcome["answer"].status, 503)
        finally:
            server.close()

    # Refusals and the rest

    def test_refusals(self):
        def refused(status, pointer, query="", **request):
            self.assert_problem(self.scene.post(f"frames{query}", {**SIZE, **request}), status, pointer)

        refused(422, "/after_pass", "?after_pass=1", progressive=True)
        refused(422, "/after_pass", "?after=0&after_pass=1")
        refused(422, "/after_pass", "?after=0&after_pass=1", progressive=False)
        refused(422, "/after_pass", "?after=0&after_pass=-1", progressive=True)
        refused(422, "/after_pass", "?after=0&after_pass=x", progressive=True)
        refused(400, "/after_pass", "?after=0&after_pass=1&after_pass=2", progressive=True)
        refused(422, "/progressive", quality="reference", progressive=True)
        refused(422, "/progressive/passes", progressive={"passes": 0})
        refused(422, "/progressive/bounces", progressive={"bounces": 4})
        refused(422, "/progressive/pases", progressive={"pases": 4})
        refused(422, "/quality/trace/strands", quality={"method": "strands", "trace": {"strands": 0}})
        refused(422, "/quality/trace", quality={"trace": {}})
        refused(422, "/quality/shells", quality={"method": "strands", "shells": {}})
        refused(422, "/progressive", quality={"method": "shells"}, progressive=True)
        address = f"{self.scene.path}/frame.png?after=0&after_pass=1"
        self.assert_problem(self.server.get(address), 422, "/after_pass")

    def test_memory_is_bounded(self):
        server = Server(arguments=["--trace-memory", "0.0625"])
        try:
            scene = thin_torus(server)
            answer = scene.post("frames", {"width": 2048, "height": 2048, "quality": "reference"})
            self.assert_problem(answer, 413)
            request = {"width": 2048, "height": 2048, "quality": "draft", "progressive": True, "view": "artist"}
            self.assertEqual(scene.post("frames", request).status, 200, "what is rasterized takes no such memory")
            self.assert_problem(scene.post("frames?after=1&after_pass=0&wait=20", request), 413)
        finally:
            server.close()

    def test_metrics(self):
        self.reference()
        metrics = self.server.get("/metrics").body.decode()
        values = dict(line.rsplit(" ", 1) for line in metrics.splitlines() if line.startswith("pelage_trace"))
        self.assertGreaterEqual(int(values["pelage_traces_total"]), 1)
        self.assertGreaterEqual(int(values["pelage_trace_passes_total"]), 4)
        self.assertGreater(float(values["pelage_trace_seconds_total"]), 0)

    def test_client(self):
        file = self.server.folder / "traced.png"
        size = ["--width", "64", "--height", "64", "-o", file]
        run = self.pelage("frame", self.scene.id, *size, "--quality", "reference", "--passes", 2, "--strands", 20000)
        self.assertIn("trace;dur=", run.stdout)
        traced = file.read_bytes()
        run = self.pelage("frame", self.scene.id, *size, "--progressive", "--passes", 4, "--strands", 20000)
        lines = run.stdout.splitlines()
        self.assertIn("rasterized", lines[0])
        self.assertIn("4 passes, noise 0.", lines[-1])
        run = self.pelage("frame", self.scene.id, *size, "--progressive", "--passes", 1, "--strands", 20000)
        self.assertRegex(run.stdout.splitlines()[-1], r": revision \d+, 1 pass, [0-9.]+ s$")
        self.assertNotEqual(file.read_bytes(), traced)
        run = self.pelage("--json", "frame", self.scene.id, *size, "--progressive", "--passes", 60000, "--until-pass", 2,
                          "--strands", 20000)
        self.assertGreaterEqual(json.loads(run.stdout.splitlines()[-1])["trace"]["passes"], 2)
        run = self.pelage("frame", self.scene.id, *size, "--progressive", "--passes", 60000, "--for", 0)
        self.assertEqual(len(run.stdout.splitlines()), 1)
        self.pelage("frame", self.scene.id, *size, "--passes", 2, code=3)
        self.pelage("frame", self.scene.id, *size, "--until-pass", 2, code=2)
        self.pelage("frame", self.scene.id, "-o", "-", "--progressive", code=3)


class Turns(ServedTest):
    @nightly
    def test_pictures_that_take_turns_have_the_bits_that_they_have_alone(self):
        scenes = [self.server.new_scene("torus", 800), self.server.new_scene("sphere", 500)]
        quality = {"method": "strands", "trace": {"strands": 3000, "passes": 48}}
        alone = [scene.frame(quality=quality).body for scene in scenes]
        with ThreadPoolExecutor(4) as pool:
            together = list(pool.map(lambda scene: scene.frame(quality=quality).body, scenes * 2))
        self.assertEqual(together, alone * 2)

    def test_a_long_trace_lets_others_first_pass_through(self):
        scene, other = self.server.new_scene("torus", 800), self.server.new_scene("sphere", 500)
        quality = {"method": "strands", "trace": {"strands": 3000, "passes": 65536}}
        long = threading.Thread(target=lambda: scene.post("frames", {"width": 128, "height": 128, "quality": quality}))
        long.start()
        while not self.passes():
            time.sleep(0.05)
        self.assertEqual(other.frame(quality={"method": "strands", "trace": {"strands": 3000, "passes": 4}}).status, 200)
        self.assertTrue(long.is_alive(), "it is far from its end")
        self.assertEqual(self.server.call("DELETE", scene.path).status, 204)  # which ends it
        long.join()

    def passes(self):
        lines = self.server.get("/metrics").body.decode().splitlines()
        return next(float(line.split()[1]) for line in lines if line.startswith("pelage_trace_passes_total"))
