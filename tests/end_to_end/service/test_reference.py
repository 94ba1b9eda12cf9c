"""The reference at /docs: all its pages, and all its examples against a real server."""

import contextlib
import html.parser
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import yaml

from support.nightly import nightly
from support.server import BIN, REPOSITORY, ServedTest

REFERENCE = REPOSITORY / "docs" / "reference"
sys.path[:0] = [str(REFERENCE), str(REPOSITORY / "docs"), str(REPOSITORY / "clients" / "python")]
import examples  # noqa: E402
import pelage  # noqa: E402, F401: the examples import it
from contract import Contract, group_page  # noqa: E402

CONTRACT = Contract(BIN / "openapi.json")
CLIENTS = yaml.safe_load((REFERENCE / "clients.yaml").read_text(encoding="utf-8"))
# What the examples name and only a server can make.
SCENE, OTHER_SCENE, PICTURE, ASSET = "35c8d81f0075", "b2c47d1e90fa", "4f3c1e0a9d2b48768c5e7a1b3d9f6024", "style-OFJ6LLIM.css"
VOID = ("meta", "link", "img", "input", "br", "wbr")
TYPES = {"html": "text/html; charset=utf-8", "css": "text/css; charset=utf-8", "jpg": "image/jpeg", "png": "image/png"}


class Page(html.parser.HTMLParser):
    """Tags that are closed, ids, addresses and the text of a page."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.addresses, self.text = [], [], [], ""
        self.feed(text)
        self.close()
        assert not self.open, self.open

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        assert tag != "script" and "style" not in attributes and not any(name.startswith("on") for name in attributes), (tag, attrs)
        self.ids += [attributes["id"]] if "id" in attributes else []
        self.addresses += [attributes[name] for name in ("href", "src") if name in attributes]
        self.open += [] if tag in VOID else [tag]

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, (tag, self.open)

    def handle_data(self, data):
        self.text += data


class Pages(ServedTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.pages, waiting = {}, ["index.html"]
        while waiting:
            name = waiting.pop()
            answer = cls.server.get(f"/docs/{name}")
            assert answer.status == 200, (name, answer)
            assert answer.headers["content-type"] == TYPES[name.rsplit(".", 1)[1]], (name, answer.headers)
            cls.pages[name] = Page(answer.body.decode()) if name.endswith(".html") else None
            named = [one.split("#")[0] for one in cls.pages[name].addresses] if cls.pages[name] else []
            waiting += {one for one in named if one and one != "../openapi.json"} - set(cls.pages) - set(waiting)

    def test_the_address_leads_to_the_first_page(self):
        for path, to in (("/docs", "docs/index.html"), ("/docs/", "index.html")):
            answer = self.server.get(path)
            self.assertEqual((answer.status, answer.headers["location"]), (308, to))
        for path in ("/docs/none.html", "/docs/a/b.html", "/docsx", "/docs/..%2findex.html", "/docs/style.css.gz"):
            self.assertEqual(self.server.get(path).status, 404, path)
        self.assertIn('route="/docs/{name}",status="404"', self.server.get("/metrics").body.decode())

    def test_each_command_operation_and_type_has_its_page(self):
        for command in CONTRACT.commands:
            page = self.pages[f"{command.op}.html"]
            for row in CONTRACT.schemas.rows(command.schema):
                self.assertIn(row.words.replace("`", ""), " ".join(page.text.split()), (command.op, row.name))
            self.assertIn(examples.as_json(command.example), page.text)
            self.assertIn(f"fox.{command.op}(", page.text)
        for operation in CONTRACT.operations:
            page = self.pages[group_page(operation.group)]
            self.assertIn(operation.id, page.ids)
            for parameter in operation.parameters:
                self.assertIn(parameter["name"], page.text)
        for name, schema in CONTRACT.types().items():
            self.assertIn(" ".join(schema["description"].replace("`", "").split())[:60], " ".join(self.pages[CONTRACT.page_of(name)].text.split()), name)
        self.assertGreater(len(self.pages), 34 + 8 + 90)

    def test_links_lead_somewhere_and_to_no_other_host(self):
        for name, page in self.pages.items():
            for address in page.addresses if page else []:
                file, _, fragment = address.partition("#")
                self.assertNotRegex(address, r"^(\w+:|/)", name)
                if fragment:
                    self.assertIn(fragment, self.pages[file or name].ids, (name, address))
            if page:
                self.assertEqual(len(page.ids), len(set(page.ids)), name)

    def test_tools_and_settings_have_a_picture(self):
        pictures = {name.rsplit(".", 1)[0] for name in self.pages if name.endswith(".jpg")}
        self.assertEqual({command.op for command in CONTRACT.commands} - pictures, {"set_skin_texture"})

    def test_all_of_it_is_small(self):
        self.assertLess(sum(path.stat().st_size for path in (REFERENCE / "pictures").iterdir()), 2_000_000)


class Examples(ServedTest):
    """Each in a scene `fox` with two steps done and one undone; those of operations in one of their own."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.other = cls.server.new_scene("creature", 1000, name="other")

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for path in (REFERENCE / "files").iterdir():
            shutil.copy(path, self.folder)
        self.asset = re.search(rb'"/assets/([^"]+)"', self.server.get("/").body)[1].decode()

    @contextlib.contextmanager
    def fox(self, builtin, triangles=500, pictures=True):
        scene = self.server.new_scene(builtin, triangles, name="fox")
        scene.run({"op": "length", "flood": True, "mode": "scale", "value": 1.1})
        if builtin == "torus" and pictures:  # which has texture coordinates
            self.server.call("PUT", f"{scene.path}/skin_texture", (REFERENCE / "files" / "squares.png").read_bytes())
        for _ in range(2):
            scene.run({"op": "lift", "flood": True})
        scene.post("undo", {})
        picture = PICTURE
        if pictures:  # reading one takes longer than most examples
            picture = self.server.call("PUT", f"{scene.path}/pictures", (REFERENCE / "files" / "squares.png").read_bytes()).json["picture"]
        real = {SCENE: scene.id, OTHER_SCENE: self.other.id, PICTURE: picture, ASSET: self.asset, "http://127.0.0.1:8080": self.server.address}
        try:
            yield scene, lambda text: re.sub("|".join(map(re.escape, real)), lambda found: real[found[0]], text)
        finally:
            for one in self.server.get("/v1/scenes").json["scenes"]:
                if one["id"] != self.other.id:
                    self.server.call("DELETE", f"/v1/scenes/{one['id']}")

    def shell(self, text):
        environment = {**os.environ, "PATH": f"{BIN}:{os.environ['PATH']}", "PELAGE_SERVER": self.server.address}
        done = subprocess.run(["bash", "-euc", text], cwd=self.folder, env=environment, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, (text, done.stdout[-500:], done.stderr[-500:]))
        return done.stdout

    def python(self, text):
        with contextlib.chdir(self.folder), contextlib.redirect_stdout(io.StringIO()):
            names = {}
            exec(compile(text, "example", "exec"), names)  # noqa: S102: our own examples
        names["server"].close()

    def test_commands(self):
        of_pictures = [command for command in CONTRACT.commands if command.op in ("map", "set_skin_texture")]
        others = [command for command in CONTRACT.commands if command not in of_pictures]
        for builtin, commands in (("torus", of_pictures), ("creature", others)):
            with self.fox(builtin, 4000) as (scene, real):
                for command in commands:
                    with self.subTest(command.op):
                        self.check_command(command, scene, real)

    def check_command(self, command, scene, real):
        dry = scene.post("commands?dry_run=1", json.loads(real(examples.as_json(command.example))))
        self.assertEqual(dry.status, 200, dry)
        self.assertEqual(dry.json["results"][0]["warnings"], [])
        sent = []
        for run, text in ((self.python, examples.command_python(command.example)), (self.shell, examples.command_cli(command.example))):
            run(real(text))
            sent.append(self.server.get(f"{scene.path}/log").json["entries"][-1]["commands"])
            self.assertEqual(scene.post("undo", {}).status, 200)
        self.assertEqual(sent[0], sent[1], "Python and the command line do not send the same")
        self.assertEqual(sent[0]["op"], command.op)

    def test_each_operation_is_reached_by_every_client(self):
        self.assertEqual(set(CLIENTS), {operation.id for operation in CONTRACT.operations})
        self.assertEqual([name for name, client in CLIENTS.items() if "cli" not in client], ["docs"])  # which leads to docsFile
        self.assertTrue(all("python" in client for client in CLIENTS.values()))

    @nightly
    def test_operations(self):
        for operation in CONTRACT.operations:
            client = CLIENTS[operation.id]
            for kind, text in (("curl", examples.curl(operation)), ("cli", client.get("cli")), ("python", examples.operation_python(client["python"]))):
                if text is None or kind != "python" and operation.id == "events":  # which does not end
                    continue
                pictures = bool(re.search(f"{PICTURE}|skin_texture", text))
                with self.subTest(f"{operation.id} {kind}"), self.fox("torus", pictures=pictures) as (_, real):
                    if kind == "python":
                        self.python(real(text))
                    else:
                        self.shell(real(text).replace("curl ", "curl --silent --show-error --fail-with-body ", 1))


if __name__ == "__main__":
    unittest.main()
