"""Tests of the Python package, which they import from here, against a real server."""

import pathlib
import sys
import tempfile

from support.server import REPOSITORY, ServedTest

sys.path.insert(0, str(REPOSITORY / "clients" / "python"))
import pelage  # noqa: E402


class PackageTest(ServedTest):
    """A scene of its own for each test, which looks at it over HTTP too."""

    def setUp(self):
        self.client = pelage.Server(self.server.address)
        self.addCleanup(self.client.close)
        self.scene = self.client.create("fox", model={"builtin": "torus", "triangles": 500})
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def log(self):
        return self.server.get(f"/v1/scenes/{self.scene.id}/log").json["entries"]
