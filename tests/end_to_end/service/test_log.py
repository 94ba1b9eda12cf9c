"""Requests in the server's log."""

import json
import re
import time
import unittest

from support.server import Server, ServedTest, flood, lines_of

TRACE = "4bf92f3577b34da6a3ce929d0e0e4736"


class Text(ServedTest):
    own_server = True

    def test_one_line_for_each_request(self):
        scene = self.server.new_scene("plane", 2)
        answer = self.server.get(f"{scene.path}/log?format=jsonl")
        (line,) = lines_of(self.server, having="?format=jsonl")
        head, _, rest = line.partition(" request ")
        self.assertRegex(head, r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z info$")
        fields = dict(field.split("=", 1) for field in rest.split())
        self.assertEqual(fields["id"], answer.headers["pelage-request"])
        self.assertEqual((fields["method"], fields["path"], fields["status"]), ("GET", f"{scene.path}/log?format=jsonl", "200"))
        self.assertGreaterEqual(int(fields["bytes"]), len(answer.body))
        self.assertGreaterEqual(float(fields["ms"]), 0)
        self.assertEqual(fields["client"], "127.0.0.1")

    def test_every_answer_has_an_id_of_its_own(self):
        ids = [self.server.get(path).headers["pelage-request"] for path in ("/livez", "/livez", "/nowhere", "/v1/scenes", "/")]
        self.assertEqual(len(set(ids)), 5)
        for name in ids:
            self.assertRegex(name, "^[0-9a-f]{16}$")
            self.assertEqual(len(lines_of(self.server, having=name)), 1)

    def test_a_trace_goes_through(self):
        answer = self.server.get("/livez", headers={"traceparent": f"00-{TRACE}-00f067aa0ba902b7-01"})
        self.assertRegex(answer.headers["pelage-request"], f"^{TRACE}-[0-9a-f]{{16}}$")
        self.assertEqual(len(lines_of(self.server, having=TRACE)), 1)

    def test_refusals_say_why(self):
        scene = self.server.new_scene("plane", 2)
        answer = scene.run(flood([1, 0, 0], brush={"strength": 7}))
        (line,) = lines_of(self.server, having=answer.headers["pelage-request"])
        self.assertIn("Z warning request ", line)
        self.assertIn(f'problem="{answer.json["detail"]} /brush/strength [0, 1]"', line)

    def test_what_is_no_request_has_a_line_too(self):
        self.server.raw(b"GET /forged\n2026-01-01 HTTP/1.1\r\n\r\n")
        self.server.raw(b"no request at all\r\n\r\n")
        self.assertTrue(lines_of(self.server, having=" status=400 "))
        self.assertFalse([line for line in self.server.printed().splitlines() if line.startswith("2026-01-01")])
        self.server.raw(b"GET /livez HTTP/1.1\r\nX: " + b"y" * 100000)
        (line,) = lines_of(self.server, having=" status=431 ")
        self.assertIn(" path=/livez ", line)
        self.assertIn("The head of the request is too long.", line)


class Json(ServedTest):
    arguments = {"arguments": ["--log-format", "json"]}

    def test_lines_are_objects(self):
        answer = self.server.get('/v1/scenes/"x"?y=%22')
        deadline = time.monotonic() + 20
        while answer.headers["pelage-request"] not in self.server.printed() and time.monotonic() < deadline:
            time.sleep(0.02)
        lines = [json.loads(line) for line in self.server.printed().splitlines() if line.startswith("{")]
        (line,) = [line for line in lines if line["id"] == answer.headers["pelage-request"]]
        self.assertEqual({name: line[name] for name in ("level", "event", "method", "path", "status", "client")},
                         {"level": "warning", "event": "request", "method": "GET", "path": '/v1/scenes/"x"?y=%22', "status": 404,
                          "client": "127.0.0.1"})
        self.assertRegex(line["time"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z$")
        self.assertGreaterEqual(line["bytes"], len(answer.body))
        self.assertEqual(line["problem"], answer.json["detail"])


class Levels(unittest.TestCase):
    def test_lines_below_the_level_are_left_out(self):
        for level, refusals in (("warning", 1), ("error", 0), ("off", 0)):
            server = Server(arguments=["--log-level", level])
            self.addCleanup(server.close)
            for path in ("/livez", "/nowhere", "/livez"):
                server.get(path)
            self.assertEqual(server.terminate(), 0)
            self.assertEqual(len(re.findall(" request ", server.printed())), refusals, server.printed())


if __name__ == "__main__":
    unittest.main()
