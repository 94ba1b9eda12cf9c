"""Next steps that the client suggests after an error."""

import contextlib
import http.server
import json
import threading
import time
import unittest

from support.server import ServedTest

COMB = json.dumps({"op": "comb", "flood": True, "direction": [0, 1, 0]})
MAX_SCENES = 64


class NextSteps(ServedTest):
    arguments = {"token": "secret"}

    def next_of(self, *arguments, code, token="secret", **more):
        """The step after `next:` that a refused line prints."""
        run = self.pelage(*arguments, "--token", token, code=code, **more)
        lines = [line.split(":", 1)[1].strip() for line in run.stderr.splitlines() if line.startswith("  next:")]
        self.assertEqual(len(lines), 1, run.stderr)
        return lines[0]

    def test_files(self):
        scene = self.server.new_scene("plane", 2)
        picture = self.server.folder / "no" / "x.png"
        self.assertIn("name a file that exists", self.next_of("run", scene.id, "/nonexistent", code=3))
        self.assertIn("name a file that exists", self.next_of("load", scene.id, "/nonexistent.obj", code=3))
        self.assertIn("name a file that exists", self.next_of("compare", "/nonexistent.png", "-", code=3))
        recipe = self.server.folder / "main.json"
        recipe.write_text('{"include": ["none.json"], "steps": [{"use": "none"}]}')
        self.assertIn("name a file that exists", self.next_of("run", scene.id, recipe, code=3))
        self.assertIn("you may write", self.next_of("frame", scene.id, "--width", 8, "--height", 8, "-o", picture, code=1))
        self.assertIn("you may write", self.next_of("trade", "--quick", "-o", "/proc/x", code=1))

    def test_senders(self):
        self.assertIn("--token", self.next_of("list", token="wrong", code=1))
        self.assertIn("--token", self.next_of("trade", "--scene", "any", "-o", self.server.folder, token="wrong", code=1))
        with stub_server(403, "about:blank") as stub:
            self.assertIn("--host", self.next_of("list", "--server", stub, code=1))
        self.assertIn("`pelaged`", self.next_of("list", "--server", "http://127.0.0.1:1", code=1))

    def test_scenes_that_are_too_many(self):
        scenes = [self.server.new_scene("plane", 2) for _ in range(MAX_SCENES - len(self.server.get("/v1/scenes").json["scenes"]))]
        for line in (("new", "--builtin", "plane"), ("branch", scenes[0].id, "b")):
            self.assertIn("`pelage rm`", self.next_of(*line, code=1))
        for scene in scenes:
            self.assertEqual(self.server.call("DELETE", scene.path).status, 204)

    def test_a_busy_server(self):
        for status, kind in ((429, "busy"), (503, "unavailable")):
            with stub_server(status, f"urn:pelage:problem:{kind}") as stub:
                step = self.next_of("run", "any", "-", "--server", stub, code=1, text=COMB)
                self.assertIn("try again", step)
                self.assertNotIn("pelaged", step)

    def test_a_busy_server_is_asked_again_when_it_says(self):
        with stub_server(429, "urn:pelage:problem:busy", times=2, retry_after=1) as stub:
            begin = time.monotonic()
            run = self.pelage("list", "--json", "--server", stub)
            self.assertEqual(run.stdout.strip(), '{"scenes":[]}')
            self.assertEqual(run.stderr.count("asking again in 1 s"), 2)
            self.assertGreater(time.monotonic() - begin, 1.9)

    def test_a_scene_that_is_not_there(self):
        self.assertIn("`pelage list`", self.next_of("info", "none", code=3))


@contextlib.contextmanager
def stub_server(status, kind, times=1000, retry_after=None):
    """The address of a server that answers so many times with a problem document, then with an empty list of scenes."""
    problem = json.dumps({"type": kind, "title": "t", "status": status, "detail": "Said by the stub."}).encode()

    class Handler(http.server.BaseHTTPRequestHandler):
        left = times

        def do_GET(self):
            Handler.left -= 1
            refused = Handler.left >= 0
            body = problem if refused else b'{"scenes":[]}'
            self.send_response(status if refused else 200)
            self.send_header("Content-Type", "application/problem+json" if refused else "application/json")
            self.send_header("Content-Length", str(len(body)))
            if refused and retry_after:
                self.send_header("Retry-After", str(retry_after))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_):
            pass

    with http.server.HTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
            thread.join()


if __name__ == "__main__":
    unittest.main()
