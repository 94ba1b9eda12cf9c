"""Live news of a scene."""

import collections
import contextlib
import http.client
import json
import socket
import threading
import time
import unittest

from support.nightly import nightly
from support.server import Answer, Server, ServedTest, author, flood

QUIET = 4  # comments, of 15 seconds each, after which nothing more is expected
TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"
STREAMS = 32

Event = collections.namedtuple("Event", "name id data")


def look(k):
    """A command that is small and differs from that of another k."""
    return {"op": "set_look", "look": {"ambient": k / 1000}}


class Stream:
    """Follows a scene. Events come as they are asked for; None is the end of the stream."""

    def __init__(self, scene, last=None, *, query="", headers=None):
        self.connection = http.client.HTTPConnection("127.0.0.1", scene.server.port, timeout=60)
        last_id = {} if last is None else {"Last-Event-ID": str(last)}
        self.connection.request("GET", f"{scene.path}/events{query}", headers={**last_id, **(headers or {})})
        self.answer = self.connection.getresponse()
        self.comments = 0
        self.retry = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.answer.close()
        self.connection.close()

    def refusal(self):
        assert self.answer.status != 200, "the stream began"
        return Answer(self.answer.status, self.answer.getheaders(), self.answer.read())

    def block(self):
        """The lines up to an empty one, or None."""
        lines = []
        while line := self.answer.readline():
            line = line.decode().rstrip("\n")
            if not line:
                return lines
            lines.append(line)
        return None

    def next(self):
        while (lines := self.block()) is not None:
            members = dict(line.split(": ", 1) for line in lines if not line.startswith(":"))
            self.comments += any(line.startswith(":") for line in lines)
            if self.comments == QUIET:
                raise TimeoutError("the stream has no more events")
            self.retry = members.get("retry", self.retry)
            if "event" in members:
                return Event(members["event"], members.get("id"), json.loads(members["data"]))
        return None

    def take(self, count):
        return [self.next() for _ in range(count)]


class Events(ServedTest):
    def setUp(self):
        self.scene = self.server.new_scene("plane", 50)

    def log(self, scene=None):
        return self.server.get(f"{(scene or self.scene).path}/log").json["entries"]

    def assert_changes(self, events, revisions):
        self.assertEqual([(event.name, event.id) for event in events], [("change", str(r)) for r in revisions])
        self.assertEqual([event.data["revision"] for event in events], list(revisions))

    def test_it_begins_with_the_scene(self):
        self.scene.run(flood([1, 0, 0]))
        with Stream(self.scene) as stream:
            self.assertEqual(stream.answer.status, 200)
            for name, value in (("Content-Type", "text/event-stream"), ("Cache-Control", "no-store"), ("X-Accel-Buffering", "no")):
                self.assertEqual(stream.answer.getheader(name), value)
            expected = {"revision": 1, "first_revision": 0, "undo_steps": 1, "redo_steps": 0, "model_id": self.scene.info()["model_id"]}
            self.assertEqual(stream.next(), Event("scene", "1", expected))
            self.assertEqual(stream.retry, "1000")

    def test_each_change_is_sent_in_order(self):
        with Stream(self.scene) as stream:
            self.assertEqual(stream.next().name, "scene")
            self.scene.run(flood([1, 0, 0]), {"op": "length", "flood": True, "value": 0.05}, flood([0, 0, 1]))
            self.scene.run(flood([0, 0, 1]))
            self.scene.post("undo", {"steps": 2})
            self.scene.post("redo", {"steps": 1})
            self.scene.post("revert", {"revision": 2})
            events = stream.take(5)
        self.assert_changes(events, range(1, 6))
        shown = [(e.data["kind"], e.data["argument"], e.data["ops"], e.data["undo_steps"], e.data["redo_steps"]) for e in events]
        self.assertEqual(shown, [("do", 0, ["comb", "length"], 1, 0), ("do", 0, ["comb"], 2, 0), ("undo", 2, [], 0, 2),
                                 ("redo", 1, [], 1, 1), ("revert", 2, [], 2, 0)])
        for event, entry in zip(events, self.log()):
            for member in ("revision", "kind", "touched", "author"):
                self.assertEqual(event.data[member], entry[member])

    def test_what_changes_nothing_is_no_news(self):
        with Stream(self.scene) as stream:
            stream.next()
            self.scene.run(flood([1, 0, 0]), query="?dry_run=1")
            self.assertEqual(self.scene.run({"op": "nonsense"}).status, 422)
            self.scene.run(flood([1, 0, 0]))
            self.assert_changes([stream.next()], [1])

    def test_changes_since_the_last_event(self):
        for k in range(4):
            self.scene.run(flood([1, k, 0]))
        with Stream(self.scene, 1) as stream:
            self.assert_changes(stream.take(3), [2, 3, 4])
            self.assertEqual(stream.next()[:2], ("scene", "4"))
            self.scene.run(flood([0, 0, 1]))
            self.assert_changes([stream.next()], [5])
        with Stream(self.scene, 5) as stream:
            self.assertEqual(stream.next()[:2], ("scene", "5"))

    def test_a_last_event_that_this_model_does_not_have(self):
        self.scene.run(flood([1, 0, 0]))
        self.scene.post("subdivide", {"levels": 1})
        self.scene.run(flood([1, 0, 0]))
        for last in (0, 1, 4, 2 ** 64 - 1):
            with Stream(self.scene, last) as stream:
                self.assertEqual(stream.next()[:2], ("scene", "3"), last)
        with Stream(self.scene, 2) as stream:
            self.assert_changes([stream.next()], [3])

    def test_more_than_a_handful_behind(self):
        steps = 300  # more than are sent at a time
        for k in range(steps):
            self.scene.run(look(k))
        with Stream(self.scene, 0) as stream:
            self.assert_changes(stream.take(steps), range(1, steps + 1))
            self.assertEqual(stream.next()[:2], ("scene", str(steps)))

    def test_nothing_is_lost_or_doubled_while_others_stroke(self):
        strokes = 150

        def stroke():
            for k in range(strokes):
                self.assertEqual(self.scene.run(look(k)).status, 200)

        writer = threading.Thread(target=stroke)
        writer.start()
        seen, last = [], 0
        while last < strokes:
            with Stream(self.scene, last) as stream:
                for _ in range(7):
                    event = stream.next()
                    last = int(event.id)
                    if event.name == "change":
                        seen.append(last)
                    if last == strokes:
                        break
        writer.join()
        self.assertEqual(seen, list(range(1, strokes + 1)))

    def test_two_who_follow_see_the_same(self):
        with Stream(self.scene) as first, Stream(self.scene) as second:
            first.next(), second.next()
            self.scene.run(flood([1, 0, 0]), headers=author("Zoë"))
            self.scene.run(flood([0, 0, 1]), headers=author("Ben"))
            events = first.take(2)
            self.assertEqual(second.take(2), events)
        self.assertEqual([event.data["author"] for event in events], ["Zoë", "Ben"])

    def test_a_new_model(self):
        ids = [self.scene.info()["model_id"]]
        with Stream(self.scene) as stream:
            stream.next()
            self.scene.run(flood([1, 0, 0]))
            stream.next()
            self.scene.post("subdivide", {"levels": 1})
            finer = stream.next()
            self.assertEqual((finer.name, finer.id, finer.data["first_revision"], finer.data["undo_steps"]), ("scene", "2", 2, 0))
            ids.append(finer.data["model_id"])
            self.server.call("PUT", f"{self.scene.path}/model?format=obj&discard=1", TRIANGLE)
            other = stream.next()
            self.assertEqual((other.name, other.id, other.data["first_revision"]), ("scene", "3", 3))
            ids.append(other.data["model_id"])
            self.scene.run(flood([1, 0, 0]))
            self.assert_changes([stream.next()], [4])
        self.assertEqual(len(set(ids)), 3, ids)
        self.assertEqual(self.scene.info()["model_id"], ids[-1])

    def test_the_model_id_follows_the_mesh(self):
        known = self.scene.info()["model_id"]
        self.scene.run(flood([1, 0, 0]))
        branch = self.scene.post("branch", {"name": "side"}).json
        same = self.server.new_scene("plane", 50)
        self.assertEqual({self.scene.info()["model_id"], branch["model_id"], same.info()["model_id"]}, {known})
        self.assertNotEqual(self.server.new_scene("plane", 200).info()["model_id"], known)
        for texture in (b"vt 0 1\n", b"vt 0 .5\n"):
            self.server.call("PUT", f"{same.path}/model?format=obj", TRIANGLE.replace(b"vt 0 1\n", texture))
            self.assertNotEqual(same.info()["model_id"], known)
            known = same.info()["model_id"]

    def test_a_removed_scene(self):
        with Stream(self.scene) as stream:
            stream.next()
            self.server.call("DELETE", self.scene.path)
            self.assertEqual(stream.next(), Event("removed", None, {}))
            self.assertIsNone(stream.next())

    def test_refusals(self):
        nobody = f"{self.scene.path}x/events"
        self.assert_problem(self.server.get(nobody), 404)
        with Stream(self.scene, query="?after=3") as stream:
            self.assert_problem(stream.refusal(), 422, "/after")
        self.assert_problem(self.server.post(f"{self.scene.path}/events", {}), 405)
        for last in ("x", "-1", "1.5", "0x1", str(2 ** 64)):
            with Stream(self.scene, last) as stream:
                self.assert_problem(stream.refusal(), 400)

    def test_a_head_ends(self):
        answer = self.server.call("HEAD", f"{self.scene.path}/events", timeout=20)
        self.assertEqual((answer.status, answer.headers["content-type"], answer.body), (200, "text/event-stream", b""))

    def test_events_are_not_compressed(self):
        with Stream(self.scene, headers={"Accept-Encoding": "gzip, br"}) as stream:
            self.assertIsNone(stream.answer.getheader("Content-Encoding"))
            self.assertEqual(stream.next().name, "scene")

    @nightly
    def test_a_quiet_stream_is_kept_alive(self):
        with Stream(self.scene) as stream:
            stream.next()
            while not stream.comments:
                lines = stream.block()
                stream.comments += lines == [":"]
            self.scene.run(flood([1, 0, 0]))
            self.assert_changes([stream.next()], [1])


class StreamLimit(ServedTest):
    def held(self):
        text = self.server.get("/metrics").body.decode()
        return int(text.split("\npelage_event_streams ")[1].split("\n")[0])

    def wait_held(self, count):
        for _ in range(100):  # ends before a heartbeat could find out
            if self.held() == count:
                return
            time.sleep(0.1)
        self.assertEqual(self.held(), count)

    def test_streams_leave_room_for_others(self):
        scene = self.server.new_scene("plane", 2)
        streams = [Stream(scene) for _ in range(STREAMS)]
        try:
            self.assertEqual({stream.answer.status for stream in streams}, {200})
            self.assertEqual(self.held(), STREAMS)
            with Stream(scene) as one_more:
                refused = one_more.refusal()
            self.assert_problem(refused, 503)
            self.assertTrue(refused.headers["retry-after"])
            self.assertEqual(scene.run(flood([1, 0, 0])).status, 200)
            for stream in streams:
                self.assertEqual([event.id for event in stream.take(2)], ["0", "1"])
            streams.pop().close()
            self.wait_held(STREAMS - 1)
            with Stream(scene) as another:
                self.assertEqual(another.next().id, "1")
        finally:
            for stream in streams:
                stream.close()
        self.wait_held(0)

    def test_a_client_that_is_cut_off_frees_its_stream(self):
        scene = self.server.new_scene("plane", 2)
        with socket.create_connection(("127.0.0.1", self.server.port)) as connection:
            connection.sendall(f"GET {scene.path}/events HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
            self.assertIn(b"200 OK", connection.recv(4096))
            self.assertEqual(self.held(), 1)
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\x01\0\0\0\0\0\0\0")  # ends with a reset
        self.wait_held(0)


class Memory(ServedTest):
    arguments = {"arguments": ["--memory", "1M"]}

    def test_a_followed_scene_stays_open(self):
        followed = self.server.new_scene("torus", 5000)
        with Stream(followed) as stream:
            stream.next()
            for _ in range(3):
                self.server.new_scene("torus", 5000).run(flood([1, 0, 0]))
            followed.run(flood([1, 0, 0]))
            self.assertEqual(stream.next()[:2], ("change", "1"))
            metrics = self.server.get("/metrics").body.decode()
        self.assertIn("\npelage_scenes_evicted 3\n", metrics)
        self.assertIn("\npelage_scene_reopenings_total 0\n", metrics)


class Stopping(unittest.TestCase):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.close)
        self.scene = self.server.new_scene("plane", 50)

    def test_streams_end_when_the_server_stops(self):
        request = f"GET {self.scene.path}/events HTTP/1.1\r\nHost: localhost\r\n\r\n".encode()
        with contextlib.ExitStack() as stack:
            streams = [stack.enter_context(socket.create_connection(("127.0.0.1", self.server.port), timeout=60)) for _ in range(3)]
            for stream in streams:
                stream.sendall(request)
                received = b""
                while b"model_id" not in received:
                    received += stream.recv(4096)
            self.assertEqual(self.server.terminate(), 0)
            for stream in streams:
                received = b""
                while block := stream.recv(4096):
                    received += block
                self.assertTrue(received.endswith(b"0\r\n\r\n"), received)  # the end, and not one in the middle

    def test_a_restart_loses_nothing(self):
        with Stream(self.scene) as stream:
            stream.next()
            self.scene.run(flood([1, 0, 0]), headers=author("Ann"))
            self.scene.run(flood([0, 0, 1]), headers=author("Ben"))
            last = stream.next().id
            self.server.kill()
        self.server.start()
        self.scene.post("undo", {})
        with Stream(self.scene, last) as stream:
            events = stream.take(3)
            self.assertEqual([event[:2] for event in events], [("change", "2"), ("change", "3"), ("scene", "3")])
            self.assertEqual([event.data["author"] for event in events[:2]], ["Ben", ""])
            self.assertEqual((events[0].data["undo_steps"], events[1].data["undo_steps"]), (2, 1))


if __name__ == "__main__":
    unittest.main()
