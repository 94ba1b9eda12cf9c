"""A pelaged on a free port with a folder of its own, and small ways to talk to it."""

import atexit
import http.client
import io
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest
import urllib.parse

import numpy
from PIL import Image

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
BIN = pathlib.Path(os.environ.get("PELAGE_BIN", REPOSITORY / "build" / "release" / "bin"))
START_SECONDS = 120  # sanitizers and a loaded machine
THIN_COAT = {"op": "set_coat", "coat": {"count": 500}}  # it grows at once


def shared_folder():
    """The folder of real models; tests that need it skip without it, but fail in CI."""
    folder = pathlib.Path(os.environ.get("PELAGE_SHARED", REPOSITORY.parent / "shared"))
    if folder.is_dir():
        return folder
    if os.environ.get("CI") == "true":
        raise AssertionError(f"the folder of shared models is missing: {folder}")
    raise unittest.SkipTest(f"the folder of shared models is missing: {folder}")


class Answer:
    def __init__(self, status, headers, body):
        self.status, self.headers, self.body = status, {k.lower(): v for k, v in headers}, body

    @property
    def json(self):
        return json.loads(self.body)

    @property
    def image(self):
        """Rows x columns x 3 or 4, 8 bits."""
        return numpy.asarray(Image.open(io.BytesIO(self.body)))

    def __repr__(self):
        return f"{self.status} {self.body[:400]!r}"


class Server:
    def __init__(self, *, gl="auto", threads=2, data=None, arguments=(), token=None, binaries=BIN):
        self.gl, self.threads, self.arguments, self.token = gl, threads, list(arguments), token
        self.binaries = binaries
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="pelage-test-"))
        self.data = pathlib.Path(data) if data else self.folder / "data"
        self.process = None
        try:
            self.start()
        except AssertionError:
            self.close()
            raise

    def start(self):
        port_file = self.folder / "port"
        port_file.unlink(missing_ok=True)
        command = [self.binaries / "pelaged", "--listen", "127.0.0.1:0", "--port-file", port_file, "--data", self.data,
                   "--gl", self.gl, "--threads", str(self.threads), *self.arguments]
        if self.token:
            command += ["--token", self.token]
        with open(self.folder / "output", "ab") as output:
            self.process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT)
        deadline = time.monotonic() + START_SECONDS
        while not port_file.exists():
            if self.process.poll() is not None or time.monotonic() > deadline:
                raise AssertionError(f"pelaged did not start: {self.printed()}")
            time.sleep(0.02)
        self.port = int(port_file.read_text())
        self.address = f"http://127.0.0.1:{self.port}"

    def printed(self):
        return (self.folder / "output").read_text(errors="replace")

    def terminate(self):
        """SIGTERM; gives the exit code."""
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout=300)

    def kill(self):
        self.process.kill()
        self.process.wait()

    def close(self):
        if self.process.poll() is None:
            self.terminate()
        shutil.rmtree(self.folder, ignore_errors=True)

    # HTTP

    def call(self, method, path, body=None, headers=None, timeout=120):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        headers = dict(headers or {})
        if isinstance(body, (dict, list)):
            body = json.dumps(body)
        if body is not None and method == "POST":
            headers.setdefault("Content-Type", "application/json")
        if self.token:
            headers.setdefault("Authorization", f"Bearer {self.token}")
        try:
            connection.request(method, path, body=body, headers=headers)
            answer = connection.getresponse()
            return Answer(answer.status, answer.getheaders(), answer.read())
        finally:
            connection.close()

    def get(self, path, **more):
        return self.call("GET", path, **more)

    def post(self, path, body=None, **more):
        return self.call("POST", path, body, **more)

    def raw(self, content, *, late=b"", pause=0.3, timeout=20):
        """Sends bytes as they are, after a pause `late`, and gives all that comes until the server closes or is
        silent for a while."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=timeout) as connection:
            connection.sendall(content)
            if late:
                time.sleep(pause)
                try:
                    connection.sendall(late)
                except OSError:
                    pass  # closed by the server: what we want to see
            received = b""
            try:
                while block := connection.recv(65536):
                    received += block
            except (socket.timeout, ConnectionResetError):
                pass
            return received

    # Scenes

    def remove_scenes(self):
        for scene in self.get("/v1/scenes").json["scenes"]:
            self.call("DELETE", f"/v1/scenes/{scene['id']}")

    def new_scene(self, builtin="sphere", triangles=2000, **more):
        answer = self.post("/v1/scenes", {"model": {"builtin": builtin, "triangles": triangles}, **more})
        assert answer.status == 201, answer
        return Scene(self, answer.json["id"])


class Scene:
    def __init__(self, server, identifier):
        self.server, self.id, self.path = server, identifier, f"/v1/scenes/{identifier}"

    def info(self):
        return self.server.get(self.path).json

    def run(self, *commands, query="", headers=None):
        body = commands[0] if len(commands) == 1 else {"commands": list(commands)}
        return self.server.post(f"{self.path}/commands{query}", body, headers=headers)

    def post(self, name, body=None, **more):
        return self.server.post(f"{self.path}/{name}", body, **more)

    def thin_out(self):
        """Leaves few strands: its first frame, which grows them, and its exports take little time."""
        answer = self.run(THIN_COAT)
        assert answer.status == 200, answer

    def frame(self, **request):
        answer = self.post("frames", {"width": 128, "height": 128, **request})
        assert answer.status == 200, answer
        return answer


def comb(begin, end, *, samples=5, radius=0.15, **more):
    """A stroke from one point to another."""
    points = [[a + (b - a) * k / (samples - 1) for a, b in zip(begin, end)] for k in range(samples)]
    samples = [{"position": point, "time": 0.05 * k} for k, point in enumerate(points)]
    return {"op": "comb", "stroke": {"samples": samples}, "brush": {"radius": radius}, **more}


def flood(direction, **more):
    return {"op": "comb", "flood": True, "direction": direction, **more}


def author(name):
    """The header that names who makes a change."""
    return {"Pelage-Author": urllib.parse.quote(name, safe="")}


def lines_of(server, count=1, having=()):
    """The lines of requests that have the text, or all of several, once there are `count`: a line comes after its answer."""
    texts = [having] if isinstance(having, str) else having
    deadline = time.monotonic() + 20
    while True:
        found = [line for line in server.printed().splitlines() if " request " in line and all(text in line for text in texts)]
        if len(found) >= count or time.monotonic() > deadline:
            return found
        time.sleep(0.02)


_shared = {}  # a server for each set of arguments, for all classes of this process that need none of their own


def shared_server(arguments):
    key = repr(sorted(arguments.items()))
    server = _shared.get(key)
    if server is None or server.process.poll() is not None:
        server = _shared[key] = Server(**arguments)
        atexit.register(server.close)
    return server


class ServedTest(unittest.TestCase):
    """One server for all tests of a process; each test leaves it alive, and each class without scenes."""

    arguments = {}
    own_server = False  # of a class that reads what the server has done since its start

    @classmethod
    def setUpClass(cls):
        cls.server = Server(**cls.arguments) if cls.own_server else shared_server(cls.arguments)
        cls.addClassCleanup(cls.server.close if cls.own_server else cls.server.remove_scenes)

    def tearDown(self):
        try:
            self.assertEqual(self.server.get("/livez").status, 200)
        except OSError as error:
            self.fail(f"the server is gone: {error}; it printed {self.server.printed()}")

    def pelage(self, *arguments, code=0, text="", environment=None):
        """Runs the command-line client, which has to end with `code`."""
        run = subprocess.run([BIN / "pelage", *map(str, arguments)], input=text, capture_output=True, text=True, timeout=120,
                             env={**os.environ, "PELAGE_SERVER": self.server.address, **(environment or {})})
        self.assertEqual(run.returncode, code, run)
        return run

    def assert_problem(self, answer, status, pointer=None):
        self.assertEqual(answer.status, status, answer)
        self.assertEqual(answer.headers["content-type"], "application/problem+json")
        self.assertEqual(answer.json["status"], status)
        self.assertTrue(answer.json["detail"])
        if pointer is not None:
            self.assertEqual(answer.json.get("pointer"), pointer, answer)
