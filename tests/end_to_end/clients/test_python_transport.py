"""The Python package on a bad day: lost connections, a busy server, streams that break, private servers that do not start."""

import gc
import http.server
import json
import os
import pathlib
import signal
import socket
import stat
import subprocess
import sys
import tempfile
import threading
import unittest
import unittest.mock

from support.server import BIN, REPOSITORY, Server

sys.path.insert(0, str(REPOSITORY / "clients" / "python"))
import pelage  # noqa: E402
from pelage.connection import Connection  # noqa: E402
from pelage.events import messages  # noqa: E402

INFO = {"id": "s", "name": "fox", "revision": 0}
CHANGED = {"revision": 1, "fields_hash": "", "results": []}
BUSY = {"status": 503, "title": "Busy", "detail": "Too much work."}


def answer(status, document, headers=()):
    """Answers a request."""
    def respond(handler):
        body = json.dumps(document).encode()
        handler.send_response(status)
        for name, value in (("Content-Length", str(len(body))), *headers):
            handler.send_header(name, value)
        handler.end_headers()
        handler.wfile.write(body)
    return respond


def hang_up(handler):
    handler.close_connection = True
    handler.connection.shutdown(socket.SHUT_RDWR)


def news(*events):
    """A stream of (event, id, data) that ends."""
    def respond(handler):
        handler.send_response(200)
        handler.end_headers()
        for event, number, data in events:
            handler.wfile.write(f": hello\nevent: {event}\nid: {number}\ndata: {json.dumps(data)}\n\n".encode())
        handler.close_connection = True
    return respond


class Scripted:
    """A server that answers each request by the next step. requests: (method, path, headers, body) of all."""

    def __init__(self, *steps):
        self.steps, self.requests = list(steps), []
        script = self

        class Handler(http.server.BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def respond(self):
                body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
                script.requests.append((self.command, self.path, self.headers, body))
                script.steps.pop(0)(self)

            do_GET = do_POST = do_PUT = do_DELETE = respond

            def log_message(self, *_):
                pass

        self.http = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.http.daemon_threads = True
        self.thread = threading.Thread(target=self.http.serve_forever, args=(0.01,))
        self.thread.start()
        self.address = f"http://127.0.0.1:{self.http.server_port}"

    def close(self):
        self.http.shutdown()
        self.thread.join()
        self.http.server_close()

    def keys(self):
        return [headers["Idempotency-Key"] for _, _, headers, _ in self.requests]


class ScriptedTest(unittest.TestCase):
    def scene(self, *steps, retries=3, timeout=20):
        """A scene whose requests are answered by the steps."""
        self.script = Scripted(*steps)
        self.addCleanup(self.script.close)
        self.slept = []
        self.enterContext(unittest.mock.patch("time.sleep", self.slept.append))
        connection = Connection(self.script.address, None, timeout, retries)
        self.addCleanup(connection.close)
        return pelage.Scene(connection, INFO)


class Retries(ScriptedTest):
    def test_a_lost_change_is_sent_again_with_its_key(self):
        scene = self.scene(hang_up, hang_up, answer(200, CHANGED), answer(200, CHANGED))
        self.assertEqual(scene.lift(flood=True)["revision"], 1)
        first = self.script.keys()
        self.assertEqual((len(first), len(set(first))), (3, 1))
        self.assertEqual(len({body for *_, body in self.script.requests}), 1)
        scene.lift(flood=True)
        self.assertEqual(len(set(self.script.keys())), 2, "each call has a key of its own")
        self.assertTrue(0.05 <= self.slept[0] <= 0.1 <= self.slept[1] <= 0.2, self.slept)

    def test_every_change_has_a_key_and_pictures_have_none(self):
        changed, made = answer(200, CHANGED), answer(201, INFO)
        scene = self.scene(*[changed] * 6, made, answer(200, INFO), answer(200, {"hit": False}))
        scene.run({"op": "lift", "flood": True}), scene.undo(), scene.redo(), scene.revert(0), scene.amend(1, [])
        with scene.batch() as batch:
            batch.lift(flood=True)
        scene.branch(), scene.subdivide(), scene.pick(1, 1)
        self.assertEqual(len(set(self.script.keys()[:8])), 8)
        self.assertEqual([path.split("/")[-1] for _, path, *_ in self.script.requests],
                         ["commands", "undo", "redo", "revert", "amend", "commands", "branch", "subdivide", "pick"])
        self.assertIsNone(self.script.keys()[8])

    def test_a_first_try_that_still_runs_is_waited_for(self):
        conflict = answer(409, {"status": 409, "title": "Conflict", "detail": "The first one is still running."})
        scene = self.scene(hang_up, conflict, conflict, answer(200, CHANGED))
        self.assertEqual(scene.lift(flood=True)["revision"], 1)
        scene = self.scene(conflict)
        self.assertRaises(pelage.Conflict, scene.lift, flood=True)

    def test_a_busy_server_is_asked_again_when_it_says(self):
        scene = self.scene(answer(503, BUSY, [("Retry-After", "7")]), answer(429, BUSY, [("Retry-After", "900")]), answer(200, CHANGED))
        scene.lift(flood=True)
        self.assertEqual(self.slept, [7, 30], "30 seconds at most")
        self.assertEqual(len(set(self.script.keys())), 1)

    def test_a_server_that_stays_busy(self):
        scene = self.scene(*[answer(503, BUSY)] * 4)
        with self.assertRaises(pelage.Busy) as caught:
            scene.lift(flood=True)
        self.assertEqual((caught.exception.status, caught.exception.detail), (503, "Too much work."))
        self.assertEqual(len(self.script.requests), 4)

    def test_uploads_are_not_sent_twice_but_when_they_were_refused(self):
        scene = self.scene(hang_up)
        self.assertRaises(pelage.Unreachable, scene.upload_map, "length", b"picture")
        self.assertEqual(len(self.script.requests), 1)
        scene = self.scene(answer(503, BUSY), answer(200, CHANGED))
        self.assertEqual(scene.upload_map("length", b"picture")["revision"], 1)
        scene = self.scene(hang_up, answer(200, {"picture": "p"}))
        self.assertEqual(scene.upload_picture(b"picture")["picture"], "p", "nothing is changed by it")

    def test_an_answer_before_the_body_is_read(self):
        listener = self.enterContext(socket.create_server(("127.0.0.1", 0)))

        def refuse():
            with listener.accept()[0] as peer:
                peer.recv(100)
                peer.sendall(b'HTTP/1.1 413 Too large\r\nContent-Length: 29\r\n\r\n{"status": 413, "title": "x"}')

        thread = threading.Thread(target=refuse)
        thread.start()
        with pelage.Server(f"http://127.0.0.1:{listener.getsockname()[1]}", retries=0) as client:
            scene = pelage.Scene(client._connection, INFO)
            with self.assertRaises(pelage.Refused) as caught:
                scene.upload_map("length", bytes(64 << 20))
        self.assertEqual(caught.exception.status, 413)
        thread.join()

    def test_a_file_that_breaks_off_is_fetched_again(self):
        def half(handler):
            handler.send_response(200)
            handler.send_header("Content-Length", "2000")
            handler.end_headers()
            handler.wfile.write(bytes(1000))
            handler.close_connection = True

        about = {"revision": 0, "strands": 1}
        scene = self.scene(half, answer(200, ["whole"], [("Pelage-Export", json.dumps(about))]), half, answer(404, {"title": "x"}))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "fox.usda")
            self.assertEqual(scene.export(path), about)
            self.assertEqual(path.read_text(), '["whole"]')
            self.assertRaises(pelage.NotFound, scene.export, path, every=2)
            self.assertEqual((path.read_text(), os.listdir(folder)), ('["whole"]', ["fox.usda"]))
        self.assertEqual([path for _, path, *_ in self.script.requests[1:3]], ["/v1/scenes/s/export/usda", "/v1/scenes/s/export/usda?every=2"])

    def test_no_answer_in_time_is_not_asked_again(self):
        came, ended = threading.Event(), threading.Event()
        self.addCleanup(ended.set)
        scene = self.scene(lambda handler: (came.set(), ended.wait(20), hang_up(handler)), timeout=0.2)
        with self.assertRaisesRegex(pelage.Unreachable, "timed out"):
            scene.info()
        self.assertTrue(came.wait(20), "a busy machine may read the request after the client has given up")
        self.assertEqual((len(self.script.requests), self.slept), (1, []))

    def test_nobody_listens(self):
        scene = self.scene()
        self.script.http.server_close()
        self.assertRaises(pelage.Unreachable, scene.info)
        self.assertEqual(len(self.slept), 3)
        self.assertFalse(pelage.Server(self.script.address).is_alive())

    def test_problems_that_are_no_documents(self):
        scene = self.scene(answer(502, "bad gateway"), answer(404, ["x"]), answer(500, {"title": "x"}))
        with self.assertRaises(pelage.Failed) as caught:
            scene.info()
        self.assertEqual((caught.exception.status, caught.exception.detail), (502, '"bad gateway"'))
        self.assertRaises(pelage.NotFound, scene.info)
        self.assertRaises(pelage.Failed, scene.info)

    def test_a_connection_is_kept_and_an_idle_one_is_not(self):
        ports = []
        note = lambda handler: (ports.append(handler.client_address[1]), answer(200, INFO)(handler))  # noqa: E731
        scene = self.scene(note, note, note)
        scene.info(), scene.info()
        with unittest.mock.patch("pelage.connection.IDLE_SECONDS", -1.0):
            scene.info()
        self.assertEqual((ports[0] == ports[1], ports[1] == ports[2]), (True, False))

    def test_progress_of_a_frame(self):
        reported = threading.Event()
        reports = []
        listed = answer(200, {"frames": [{"view": "other", "share": 0.9, "seconds": 1, "expected_seconds": 2},
                                         {"view": "mine", "share": 0.25, "seconds": 1, "expected_seconds": 4}]})

        def draw_or_list(handler):  # whichever of the two comes first
            if handler.command == "GET":
                return listed(handler)
            reported.wait(20)
            answer(200, {}, [("Pelage-Revision", "0")])(handler)

        def report(progress):
            reports.append(progress)
            reported.set()

        scene = self.scene(*[draw_or_list] * 1000)
        with unittest.mock.patch("pelage.pictures.POLL", 0.02):
            scene.frame(view="mine", progress=report)
        self.assertEqual(reports[0], pelage.Progress(0.25, "of about 4 s, 1 s so far"))
        self.assertEqual(reports[-1], pelage.Progress(1, "done"))

    def test_printed_progress(self):
        terminal = unittest.mock.Mock(**{"isatty.return_value": True})
        with unittest.mock.patch("sys.stderr", terminal):
            pelage.print_progress(pelage.Progress(0.25, "of 4 s"))
            pelage.print_progress(pelage.Progress(1, "done"))
            terminal.isatty.return_value = False
            pelage.print_progress(pelage.Progress(0.25, "of 4 s"))
        written = "".join(call.args[0] for call in terminal.write.call_args_list)
        self.assertEqual(written, "\r\033[K 25% of 4 s\r\033[K")


class Streams(ScriptedTest):
    def test_a_stream_resumes_where_it_broke(self):
        state, first, second = ({"revision": number} for number in (0, 1, 2))
        scene = self.scene(news(("scene", 0, state), ("change", 1, first)), hang_up, answer(503, BUSY),
                           news(("change", 2, second), ("removed", 2, {})))
        followed = list(scene.follow())
        self.assertEqual([type(one).__name__ for one in followed], ["SceneState", "Change", "Change", "Removed"])
        self.assertEqual([headers["Last-Event-ID"] for _, _, headers, _ in self.script.requests], [None, "1", "1", "1"])

    def test_a_stream_that_breaks_now_and_then_resumes(self):
        breaks = [step for number in range(1, 5) for step in (hang_up, news(("change", number, {"revision": number})))]
        scene = self.scene(news(("scene", 0, {"revision": 0})), *breaks, hang_up, news(("removed", 4, {})), retries=2)
        self.assertEqual([one.revision for one in scene.follow()], [0, 1, 2, 3, 4, 4])

    def test_a_stream_that_stays_broken(self):
        scene = self.scene(news(("scene", 0, {"revision": 0})), *[hang_up] * 3)
        followed = scene.follow()
        next(followed)
        self.assertRaises(pelage.Unreachable, next, followed)
        self.assertEqual(len(self.script.requests), 4)
        scene = self.scene(*[answer(503, BUSY)] * 4)
        self.assertRaises(pelage.Busy, next, scene.follow())

    def test_messages(self):
        stream = b": c\nretry: 1\n\nevent: a\nid: 1\ndata: x\ndata: y\n\ndata:z\n\nid: 5\n\nevent: lost\ndata: x\n"
        self.assertEqual([tuple(one) for one in messages(stream.splitlines(True))], [("a", "x\ny", "1"), ("message", "z", "1")])


class RealRetries(unittest.TestCase):
    def test_a_server_that_restarts_meanwhile(self):
        server = Server()
        self.addCleanup(server.close)
        client = pelage.Server(server.address, retries=10)
        self.addCleanup(client.close)
        scene = client.create("fox", model={"builtin": "plane", "triangles": 50})
        news = scene.follow()
        next(news)
        server.terminate()
        again = [BIN / "pelaged", "--listen", f"127.0.0.1:{server.port}", "--data", server.data, "--threads", "2"]
        process = subprocess.Popen(again, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        self.assertEqual(scene.length(flood=True, value=0.05)["revision"], 1)
        self.assertEqual(next(one for one in news if isinstance(one, pelage.Change)).revision, 1)
        scene.remove()

    def test_a_token(self):
        server = Server(token="secret")
        self.addCleanup(server.close)
        with pelage.Server(server.address, "secret") as client:
            self.assertEqual(client.scenes(), [])
        with pelage.Server(server.address) as client, self.assertRaises(pelage.Refused) as caught:
            client.scenes()
        self.assertEqual(caught.exception.status, 401)


class Local(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def program(self, text):
        path = self.folder / "pelaged"
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(stat.S_IRWXU)
        return path

    def test_it_starts_and_stops(self):
        with pelage.local(BIN / "pelaged", arguments=["--threads", "1"]) as server:
            self.assertTrue(server.is_ready())
            self.assertIn(server.address, server.log())
            folder = server.folder
            self.assertEqual(server.create(model={"builtin": "plane", "triangles": 2}).name, "scene")
        self.assertFalse(server.is_alive() or folder.exists())

    def test_it_stops_when_nobody_holds_it(self):
        server = pelage.local(BIN / "pelaged")
        client = pelage.Server(server.address)
        self.assertTrue(client.is_alive())
        del server
        gc.collect()
        self.assertFalse(client.is_alive())

    def test_scenes_in_a_folder_of_their_own_stay(self):
        for names in ([], ["fox"]):
            with pelage.local(BIN / "pelaged", data=self.folder / "data") as server:
                self.assertEqual([scene.name for scene in server.scenes()], names)
                server.create("fox", model={"builtin": "plane", "triangles": 2})

    def test_where_the_program_is(self):
        with unittest.mock.patch.dict("os.environ", {"PELAGE_SERVER_PROGRAM": str(BIN / "pelaged"), "PELAGE_TOKEN": "x"}):
            with pelage.local() as server:
                self.assertEqual(server.scenes(), [], "with the token, which both have")
        with unittest.mock.patch.dict("os.environ", {"PATH": str(BIN)}):
            os.environ.pop("PELAGE_SERVER_PROGRAM", None)
            with pelage.local() as server:
                self.assertTrue(server.is_alive())
        with self.assertRaisesRegex(pelage.NotStarted, "no program nothing-here"):
            pelage.local("nothing-here")

    def test_a_program_that_fails_says_why(self):
        with self.assertRaisesRegex(pelage.NotStarted, "(?s)ended with 3.*no luck today"):
            pelage.local(self.program("echo no luck today; exit 3"))
        with self.assertRaisesRegex(pelage.NotStarted, "--nonsense"):
            pelage.local(BIN / "pelaged", arguments=["--nonsense"])

    def test_a_program_that_never_starts_is_ended(self):
        file = self.folder / "number"
        try:
            pelage.local(self.program(f"echo $$ > {file}; echo waiting; exec sleep 100"), seconds=0.5)
        except pelage.NotStarted as error:  # which holds all that its traceback holds
            self.assertRegex(str(error), "(?s)not ready after 0.5 s.*waiting")
            self.assertRaises(ProcessLookupError, os.kill, int(file.read_text()), signal.SIGKILL)
        else:
            self.fail("it cannot be ready")
