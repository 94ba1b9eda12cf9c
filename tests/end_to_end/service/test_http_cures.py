"""The weak spots of the HTTP library, each with what makes it harmless here."""

import concurrent.futures
import http.client
import itertools
import select
import signal
import socket
import subprocess
import tempfile
import time
import unittest

from support.server import BIN, Server, ServedTest, author, flood


def head(first, *headers, host="127.0.0.1"):
    lines = [first, f"Host: {host}"] if host else [first]
    return ("\r\n".join([*lines, *headers]) + "\r\n\r\n").encode()


def statuses(content):
    """Status codes of the answers in a stream."""
    return [int(part.split()[0]) for part in content.split(b"HTTP/1.1 ")[1:]]


class Framing(ServedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scene = cls.server.new_scene("plane", 2)
        cls.smuggled = head(f"DELETE {cls.scene.path} HTTP/1.1")

    def tearDown(self):
        self.assertEqual(self.server.get(self.scene.path).status, 200, "a request inside a body was run")
        super().tearDown()

    def refused(self, status, first, *headers, body=b"", late=None, **more):
        received = self.server.raw(head(first, *headers, **more) + body, late=self.smuggled if late is None else late)
        self.assertEqual(statuses(received), [status], received)
        self.assertIn(b"application/problem+json", received)
        return received

    def test_chunks_are_refused_and_what_follows_is_not_run(self):
        post = f"POST {self.scene.path}/commands HTTP/1.1"
        self.refused(411, post, "Transfer-Encoding: chunked")
        self.refused(411, post, "Transfer-Encoding: chunked", "Content-Length: 4")
        self.refused(411, post, "transfer-encoding: x, CHUNKED", body=b"5\r\nhello\r\n0\r\n\r\n")
        self.refused(411, "GET / HTTP/1.1", "Transfer-Encoding: chunked")

    def test_compressed_bodies(self):
        self.refused(415, f"POST {self.scene.path}/commands HTTP/1.1", "Content-Encoding: gzip", "Content-Length: 200")

    def test_two_lengths(self):
        self.refused(400, f"POST {self.scene.path}/commands HTTP/1.1", "Content-Length: 0", "Content-Length: 200")
        self.refused(400, f"POST {self.scene.path}/commands HTTP/1.1", "Content-Length: 0", "Content-Length: 0")

    def test_lengths_that_are_none(self):
        for value in ("+5", "-1", "5, 5", "0x10", "5 5", "99999999999999999999999", "five"):
            self.refused(400, f"POST {self.scene.path}/commands HTTP/1.1", f"Content-Length: {value}")

    def test_header_names_with_spaces(self):
        self.refused(400, f"POST {self.scene.path}/commands HTTP/1.1", "Content-Length : 200")
        self.refused(400, f"POST {self.scene.path}/commands HTTP/1.1", " Content-Length: 200")

    def test_bodies_where_none_belong(self):
        for method, path in (("GET", "/livez"), ("HEAD", "/livez"), ("DELETE", "/v1/scenes/nobody")):
            length = f"Content-Length: {len(self.smuggled)}"
            self.refused(400, f"{method} {path} HTTP/1.1", length)
            self.refused(400, f"{method} {path} HTTP/1.1", length, body=self.smuggled, late=b"")

    def test_bodies_over_the_limit(self):
        self.refused(413, f"POST {self.scene.path}/commands HTTP/1.1", "Content-Length: 99999999")
        self.refused(413, f"PUT {self.scene.path}/model?format=obj HTTP/1.1", f"Content-Length: {(256 << 20) + 1}")
        self.refused(413, f"PUT {self.scene.path}/model?format=obj HTTP/1.1", "Content-Length: 18446744073709551615")

    def test_a_refused_body_that_comes_late_is_not_run(self):
        for first in ("POST /nowhere HTTP/1.1", "PUT /v1/scenes HTTP/1.1", "PATCH / HTTP/1.1", "OPTIONS / HTTP/1.1",
                      "TRACE / HTTP/1.1", "BREW / HTTP/1.1", "no request at all"):
            received = self.server.raw(head(first, "Content-Length: 500"), late=self.smuggled)
            self.assertNotIn(204, statuses(received), received)
            self.assertNotIn(200, statuses(received), received)

    def test_expectations_are_refused_before_the_body(self):
        received = self.server.raw(head(f"POST {self.scene.path}/commands HTTP/1.1", "Content-Length: 99999999",
                                        "Expect: 100-continue"), late=self.smuggled)
        self.assertEqual(statuses(received), [413], received)

    def test_ranges(self):
        many = "bytes=" + ",".join("0-" for _ in range(1000))
        self.refused(416, "GET /openapi.json HTTP/1.1", f"Range: {many}")
        self.refused(416, "GET /openapi.json HTTP/1.1", "Range: bytes=0-1,2-3")
        self.refused(416, "GET /openapi.json HTTP/1.1", "Range: bytes=x")
        whole = self.server.get("/openapi.json")
        one = self.server.get("/openapi.json", headers={"Range": "bytes=0-9"})
        self.assertEqual((one.status, one.body), (200, whole.body))

    def test_refused_methods_list_the_allowed_ones(self):
        for method, path, takes in (("DELETE", "/v1/scenes", "GET, HEAD, POST"), ("PATCH", self.scene.path, "GET, HEAD, DELETE"),
                                    ("PATCH", "/nothing", "GET, HEAD, POST, PUT, DELETE")):
            answer = self.server.call(method, path)
            self.assertEqual((answer.status, answer.headers["allow"], answer.json["limit"]), (405, takes, takes))

    def test_parameters_that_nobody_reads_are_refused(self):
        for path in ("/v1/scenes", self.scene.path):
            self.assert_problem(self.server.get(f"{path}?nth=2"), 422, "/nth")
        self.assert_problem(self.server.call("DELETE", f"{self.scene.path}?sure=1"), 422, "/sure")

    def test_flags_are_numbers_or_words(self):
        scene = self.server.new_scene("plane", 2)
        scene.thin_out()
        for word in ("1", "true"):
            self.assertIn("strands", self.server.get(f"{scene.path}/export/usda?dry_run={word}").json)
        for word in ("0", "false"):
            self.assertTrue(self.server.get(f"{scene.path}/export/usda?dry_run={word}").body.startswith(b"#usda"))

    def test_heads_match_their_answers(self):
        scene = self.server.new_scene("plane", 2)
        scene.thin_out()
        answer = self.server.call("HEAD", f"{scene.path}/export/usda")
        self.assertEqual((answer.status, answer.headers["accept-ranges"]), (200, "none"))

    def test_a_connection_that_closes_is_not_kept(self):
        answer = self.refused(404, "GET /nothing HTTP/1.1", late=b"").lower()
        self.assertIn(b"connection: close", answer)
        self.assertNotIn(b"keep-alive:", answer)

    def test_a_post_without_a_length_has_no_body(self):
        received = self.server.raw(head(f"POST {self.scene.path}/undo HTTP/1.1", "Connection: close"))
        self.assertEqual(statuses(received), [422], received)  # 400 once it has waited for a body in vain

    def test_forms_and_other_types(self):
        for kind in ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x"):
            answer = self.server.post(f"{self.scene.path}/commands", b"{}", headers={"Content-Type": kind})
            self.assert_problem(answer, 415)
        answer = self.server.call("PUT", f"{self.scene.path}/model?format=obj", b"v", headers={
            "Content-Type": "multipart/form-data; boundary=x"})
        self.assert_problem(answer, 415)

    def test_a_body_that_never_comes(self):
        received = self.server.raw(head(f"POST {self.scene.path}/commands HTTP/1.1", "Content-Length: 50") + b"{")
        self.assertEqual(statuses(received), [400], received)

    def test_long_heads(self):
        received = self.server.raw(head(f"GET /{'x' * 20000} HTTP/1.1"))
        self.assertIn(statuses(received)[0], (400, 404, 414), received)
        for headers in (["X: " + "y" * 100000], [f"X{k}: {'y' * 1000}" for k in range(100)]):
            received = self.server.raw(head("GET /livez HTTP/1.1", *headers))
            self.assertEqual(statuses(received), [431], received)
            self.assertIn(b"application/problem+json", received)


class Senders(ServedTest):
    def test_other_hosts_are_refused_on_every_method(self):
        for method in ("GET", "HEAD", "POST", "PUT", "DELETE"):
            for host in ("evil.example", "127.0.0.1.evil.example", "localhost.evil.example", "[::2]", "127.0.0.1@evil.example"):
                received = self.server.raw(head(f"{method} /v1/scenes HTTP/1.1", "Content-Length: 0", host=host))
                self.assertEqual(statuses(received), [403], received)

    def test_our_names(self):
        for host in ("127.0.0.1", "localhost", f"localhost:{self.server.port}", "[::1]:80", "127.0.0.2"):
            received = self.server.raw(head("GET /livez HTTP/1.1", "Connection: close", host=host))
            self.assertEqual(statuses(received), [200], received)

    def test_no_host_or_two(self):
        self.assertEqual(statuses(self.server.raw(head("GET /livez HTTP/1.1", host=None))), [400])
        self.assertEqual(statuses(self.server.raw(head("GET /livez HTTP/1.1", "Host: 127.0.0.1"))), [400])

    def test_pages_of_other_sites(self):
        for origin in ("http://evil.example", "null", f"http://127.0.0.1:{self.server.port + 1}"):
            answer = self.server.post("/v1/scenes", {}, headers={"Origin": origin})
            self.assert_problem(answer, 403)
        same = {"Origin": self.server.address, "Host": f"127.0.0.1:{self.server.port}"}
        self.assertEqual(self.server.get("/v1/scenes", headers=same).status, 200)

    def test_a_client_cannot_pose_as_another(self):
        answer = self.server.get("/livez", headers={"REMOTE_ADDR": "10.0.0.1", "X-Forwarded-For": "10.0.0.1"})
        self.assertEqual(answer.status, 200)


class Connections(ServedTest):
    def test_slow_and_idle_connections_do_not_stall_others(self):
        slow = [socket.create_connection(("127.0.0.1", self.server.port)) for _ in range(20)]
        for connection in slow:
            connection.sendall(b"GET /livez HT")
        self.assertEqual(self.server.get("/livez").status, 200)
        for connection in slow:  # none was given up to make room
            connection.setblocking(False)
            with self.assertRaises(BlockingIOError):
                connection.recv(1)
            connection.close()

    def test_idle_clients_lock_nobody_out(self):
        idle = [http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=20) for _ in range(130)]
        for connection in idle:
            self.addCleanup(connection.close)
            connection.request("GET", "/livez")
            self.assertEqual(connection.getresponse().read(), b"alive\n")
        for path in ("/livez", "/v1/scenes"):
            self.assertEqual(self.server.get(path, timeout=20).status, 200)
        idle[0].request("GET", "/livez")  # still there
        self.assertEqual(idle[0].getresponse().read(), b"alive\n")

    def test_more_clients_than_connections(self):
        idle = [socket.create_connection(("127.0.0.1", self.server.port), timeout=20) for _ in range(600)]
        for connection in idle:
            self.addCleanup(connection.close)
        self.assertEqual(self.server.get("/v1/scenes", timeout=20).status, 200)
        self.assertEqual(idle[0].recv(1), b"")  # the oldest gave way

    def test_a_slow_head_is_dropped(self):
        """A byte a second, for as long as the server listens."""
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=1) as slow:
            received = b""
            for byte in itertools.chain(b"GET /livez HTTP/1.1\r\n", itertools.repeat(ord("x"), 100)):
                try:
                    slow.sendall(bytes([byte]))
                    if block := slow.recv(65536):
                        received += block
                        continue
                    break
                except socket.timeout:
                    pass
                except OSError:
                    break
        self.assertEqual(statuses(received), [408], received)
        self.assertIn(b"application/problem+json", received)

    def test_many_at_once(self):
        with concurrent.futures.ThreadPoolExecutor(40) as pool:
            answers = list(pool.map(lambda _: self.server.get("/livez").status, range(400)))
        self.assertEqual(set(answers), {200})

    def test_a_connection_is_kept(self):
        connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=20)
        for _ in range(20):
            connection.request("GET", "/livez")
            answer = connection.getresponse()
            answer.read()
            self.assertFalse(answer.will_close)
        connection.close()

    def test_a_command_whose_client_has_gone_changes_nothing(self):
        scene = self.server.new_scene("torus", 50000)
        self.assertEqual(scene.run(flood([1, 0, 0])).json["revision"], 1)
        smooth = {"op": "smooth", "flood": True, "passes": 1200, "fields": ["direction"]}  # about a second, within the limit
        with self.assertRaises(TimeoutError):
            self.server.post(f"{scene.path}/commands", smooth, timeout=0.1)
        # This waits for the one before it, which ends now.
        self.assertEqual(scene.run(flood([0, 1, 0])).json["revision"], 2)

    def test_two_servers_do_not_share_a_port(self):
        second = subprocess.run([BIN / "pelaged", "--listen", f"127.0.0.1:{self.server.port}", "--data",
                                 self.server.folder / "other"], capture_output=True, timeout=60)
        self.assertEqual(second.returncode, 2, second)
        self.assertIn(b"Cannot listen", second.stderr)

    def test_uploads_of_one_client_leave_places_for_others(self):
        scene = self.server.new_scene("plane", 2)
        mine = [socket.create_connection(("127.0.0.1", self.server.port), timeout=20) for _ in range(4)]
        for connection in mine:  # bodies that stop half way
            self.addCleanup(connection.close)
            connection.sendall(head(f"PUT {scene.path}/skin_texture HTTP/1.1", "Content-Length: 1000") + b"half")
        for _ in range(2):
            (refused, *_), _, _ = select.select(mine, [], [], 20)
            self.assertEqual(statuses(refused.recv(65536)), [503])
            mine.remove(refused)
        theirs = self.server.call("PUT", f"{scene.path}/skin_texture", b"no picture", headers=author("Ben"))
        self.assertNotIn(theirs.status, (429, 503), theirs)

    def test_waiting_requests_leave_room_for_others(self):
        scene = self.server.new_scene("plane", 2)
        path = f"{scene.path}/frame.png?width=8&height=8&after=0&wait=10"
        with concurrent.futures.ThreadPoolExecutor(40) as pool:
            waiting = [pool.submit(self.server.get, path) for _ in range(40)]
            time.sleep(1)
            self.assertEqual(self.server.get(scene.path).status, 200)
            self.assertEqual(sum(not future.done() for future in waiting), 32)
            answers = [future.result() for future in waiting]
        counts = {status: sum(a.status == status for a in answers) for status in (304, 503)}
        self.assertEqual(counts, {304: 32, 503: 8})
        self.assertTrue(all(a.headers.get("retry-after") for a in answers if a.status == 503))


class Tokens(ServedTest):
    arguments = {"token": "secret"}

    def test_all_but_health_and_the_studio_needs_the_token(self):
        for path, status in (("/v1/scenes", 401), ("/metrics", 401), ("/openapi.json", 401), ("/", 200), ("/assets/none", 404), ("/docs", 308), ("/docs/comb.html", 200), ("/docsx", 401), ("/livez", 200),
                             ("/readyz", 200)):
            for given in ("", "Bearer wrong", "Bearer secre", "Bearer secret2", "secret", "Basic secret"):
                answer = self.server.get(path, headers={"Authorization": given})
                self.assertEqual(answer.status, status, (path, given))
                if status == 401:
                    self.assertEqual(answer.headers["www-authenticate"], "Bearer")
        self.assertEqual(self.server.get("/v1/scenes").status, 200)


class Listening(unittest.TestCase):
    def test_an_open_address_needs_a_token(self):
        for address in ("0.0.0.0:0", "[::]:0"):
            with tempfile.TemporaryDirectory() as data:
                run = subprocess.run([BIN / "pelaged", "--listen", address, "--data", data], capture_output=True, timeout=60)
            self.assertEqual(run.returncode, 2, run)
            self.assertIn(b"--token", run.stderr)

    def test_wrong_options(self):
        for arguments in (["--listen", "nonsense"], ["--listen", "127.0.0.1:99999"], ["--gl", "vulkan"], ["--threads", "-1"],
                          ["--nonsense"]):
            run = subprocess.run([BIN / "pelaged", *arguments], capture_output=True, timeout=60)
            self.assertEqual(run.returncode, 2, run)


class Stopping(unittest.TestCase):
    def test_sigterm_finishes_what_runs(self):
        server = Server()
        self.addCleanup(server.close)
        scene = server.new_scene("sphere", 2000)
        scene.frame()  # its strands are grown, which takes longest
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            waiting = pool.submit(server.get, f"{scene.path}/frame.png?after=0&wait=20")
            time.sleep(0.3)
            frame = pool.submit(scene.frame, width=160, height=160, quality="interactive", camera={"auto": "left"})
            for _ in range(500):
                if server.get(f"{scene.path}/frames").json["frames"]:
                    break
                time.sleep(0.01)
            self.assertEqual(server.terminate(), 0)
            self.assertEqual(frame.result().image.shape[:2], (160, 160))
            self.assertEqual(waiting.result().status, 304)

    def test_sigterm_ends_what_takes_long_and_loses_nothing(self):
        server = Server(threads=1)
        self.addCleanup(server.close)
        scene = server.new_scene("sphere", 20000)
        self.assertEqual(scene.run({"op": "noise", "flood": True, "seed": 7, "amount": 0.2, "fields": ["direction"]}).status, 200)
        long = {"op": "smooth", "flood": True, "t": 0.5, "passes": 2000, "fields": ["direction"]}  # seconds each
        self.assertEqual(server.new_scene("plane", 2).run(long).status, 200)

        def revision_of_answer(_):
            try:
                answer = scene.run(long)
                return answer.json["revision"] if answer.status == 200 else 1
            except OSError:
                return 1

        with concurrent.futures.ThreadPoolExecutor(60) as pool:
            answered = [pool.submit(revision_of_answer, k) for k in range(60)]  # one after the other: minutes
            time.sleep(1)
            server.process.send_signal(signal.SIGTERM)
            self.assertEqual(server.process.wait(timeout=40), 0, server.printed())  # 10 s, on a machine that is not busy
            newest = max(one.result() for one in answered)
        server.start()
        self.assertGreaterEqual(scene.info()["revision"], newest)


if __name__ == "__main__":
    unittest.main()
