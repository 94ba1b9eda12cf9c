"""Makes every picture of docs/gallery.md, and the page itself, with the programs of build/release.

usage: docs/gallery/make.py [NAME...]     (all figures, or those whose name begins with one of the given ones)
       docs/gallery/make.py --page        (the page alone)
Needs deploy/packages.sh demo and a build: deploy/demo.sh makes both.
"""
import http.client
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from figures import FIGURES, SECTIONS

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ.get("PELAGE_BIN", ROOT / "build" / "release" / "bin"))
FOLDER = ROOT / "docs" / "gallery"
SIZE = 420


class Server:
    """Runs pelaged on a free port of this machine with a temporary data folder and OSMesa, so that it can draw shells."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        port = pathlib.Path(self.folder.name) / "port"
        self.process = subprocess.Popen([BIN / "pelaged", "--listen", "127.0.0.1:0", "--port-file", port, "--data",
                                         pathlib.Path(self.folder.name) / "data", "--gl", "osmesa"], stdout=subprocess.DEVNULL)
        while not port.exists():
            if self.process.poll() is not None:
                sys.exit("pelaged did not start")
            time.sleep(0.05)
        self.port = int(port.read_text())
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()

    def call(self, method, path, body):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=600)
        content = body if isinstance(body, bytes) else json.dumps(body).encode()
        connection.request(method, path, content, {"Content-Type": "application/json"} if method == "POST" else {})
        answer = connection.getresponse()
        data = answer.read()
        if answer.status not in (200, 201, 204):
            sys.exit(f"{method} {path}: {answer.status} {data.decode(errors='replace')}")
        return data


def make_scene(server, picture):
    """Makes a scene with the picture's model, fur and commands, and returns its path on the server."""
    model, path = picture["model"], None
    first = {"model": model, "fur": picture["fur"]} if "builtin" in model else {"model": {"builtin": "sphere", "triangles": 100}}
    scene = json.loads(server.call("POST", "/v1/scenes", {**first, "name": "gallery"}))
    path = f"/v1/scenes/{scene['id']}"
    if "file" in model:
        query = "&".join(f"{k}={v}" for k, v in {**model["options"], **picture.get("fur", {})}.items())
        server.call("PUT", f"{path}/model?{query}", pathlib.Path(model["file"]).read_bytes())
    for commands in picture["steps"]:
        if "recipe" in commands:
            run_recipe(server, scene["id"], commands["recipe"])
        else:
            server.call("POST", f"{path}/commands", commands)
    return path


def run_recipe(server, scene, name):
    recipe = ROOT / "clients" / "recipes" / f"{name}.json"
    subprocess.run([BIN / "pelage", "--server", f"http://127.0.0.1:{server.port}", "run", scene, recipe], check=True,
                   stdout=subprocess.DEVNULL)


def make_picture(server, picture, name):
    path = make_scene(server, picture)
    request = {"width": SIZE, "height": SIZE, **picture["frame"]}
    png = server.call("POST", f"{path}/frames", request)
    server.call("DELETE", path, b"")
    with tempfile.NamedTemporaryFile(suffix=".png") as file:
        file.write(png)
        file.flush()
        subprocess.run(["oiiotool", "--nosoftwareattrib", file.name, "--compression", "jpeg:88", "-o", FOLDER / f"{name}.jpg"], check=True)


def section_of(figure):
    """A figure as Markdown: rows of four pictures if their number is a multiple of four, else rows of three."""
    titles = [p["title"] for p in figure["pictures"]]
    lines, columns = [f"### {figure['title']}", "", figure["text"], ""], 4 if len(titles) % 4 == 0 else 3
    for row in range(0, len(titles), columns):
        part = titles[row:row + columns]
        lines += ["| " + " | ".join(part) + " |", "|" + "---|" * len(part)]
        lines += ["| " + " | ".join(f"![](gallery/{figure['name']}-{row + i}.jpg)" for i in range(len(part))) + " |", ""]
    return lines


def write_page():
    figures = {figure["name"]: figure for figure in FIGURES}
    assert sorted(figures) == sorted(name for _, names in SECTIONS for name in names)
    lines = ["# Gallery", "", "Each picture is a scene, commands and a frame, as any client would send them; `docs/gallery/make.py` makes them again.",
             "It skips figures whose model is not on the machine.", ""]
    for title, names in SECTIONS:
        lines += [f"## {title}", ""]
        for name in names:
            lines += section_of(figures[name])
    (ROOT / "docs" / "gallery.md").write_text("\n".join(lines), encoding="utf-8")


def main():
    wanted = tuple(sys.argv[1:]) or ("",)
    write_page()
    if "--page" in wanted:
        return
    with Server() as server:
        for figure in FIGURES:
            if not figure["name"].startswith(wanted):
                continue
            for i, picture in enumerate(figure["pictures"]):
                if not pathlib.Path(picture["model"].get("file", __file__)).exists():
                    print(f"{figure['name']}-{i}: skipped, there is no {picture['model']['file']}", flush=True)
                    continue
                start = time.monotonic()
                make_picture(server, picture, f"{figure['name']}-{i}")
                print(f"{figure['name']}-{i}: {picture['title']}, {time.monotonic() - start:.1f} s", flush=True)


main()
