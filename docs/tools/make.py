"""Makes the pages of the tools and their pictures, with the programs of build/release.

usage: docs/tools/make.py [NAME...]     (all tools, or those whose name begins with one of the given ones)
       docs/tools/make.py --pages       (only the text)
       docs/tools/make.py --check       (says which pages differ from what the contract and pages.py say)
Needs deploy/packages.sh demo and a build, whose bin/openapi.json is the contract: deploy/demo.sh makes both.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from pages import GROOMS, PAGES

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))
from schema_rows import Schemas  # noqa: E402

BIN = pathlib.Path(os.environ.get("PELAGE_BIN", ROOT / "build" / "release" / "bin"))
SHARED = pathlib.Path(os.environ.get("PELAGE_SHARED", ROOT.parent / "shared")) / "meshes"
FOLDER = ROOT / "docs" / "tools"
SCHEMAS = Schemas(json.loads((BIN / "openapi.json").read_text(encoding="utf-8"))["components"]["schemas"])
VIEW = ["--width", "420", "--height", "420", "--quality", "detailed"]

# Tables

def linked(row):
    """Returns the type of a member: a link if it has a page or a table of its own, else its value."""
    if row.target in ("Brush", "Stroke"):
        return f"[{row.target.lower()}](brush.md)"
    if row.target and row.many:
        return f"{row.kind.rsplit(' ', 1)[0]} [{row.target}](#{row.target.lower()})"
    return f"[{row.target}](#{row.target.lower()})" if row.target else row.value


def table(name):
    lines = ["| member | value | default | meaning |", "|---|---|---|---|"]
    for row in SCHEMAS.rows(SCHEMAS.all[name]):
        default = f"`{row.default}`" if row.default is not None else "required" if row.required else ""
        lines.append(f"| `{row.name}` | {linked(row)} | {default} | {row.words} |")
    return lines


def where(name):
    words = SCHEMAS.where(SCHEMAS.all[name])
    return [words, ""] if words else []


# Pages

def first_lines(page):
    """Says which scene to try the recipe in, and what to upload first."""
    if page["builtin"] == "creature":
        return ["To try it, with the scene `fox` of the [first steps](../../README.md#first-steps-by-hand):"]
    return ["To try it:", "", f"    build/release/bin/pelage new --name fox --builtin {page['builtin']} --triangles 20000",
            f"    build/release/bin/pelage map upload fox docs/tools/examples/{page['picture']}"]


def page_text(name):
    page = PAGES[name]
    recipe = (FOLDER / "examples" / f"{name}.json").read_text(encoding="utf-8")
    source = ["    SOURCE=$(build/release/bin/pelage new --name source)",
              f"    build/release/bin/pelage run $SOURCE clients/recipes/{page['source']}.json"] if page["source"] else []
    given = " --set source=$SOURCE" if page["source"] else ""
    lines = [f"# {page['title']}", "", page["words"].strip(), "", "| before | after |", "|---|---|",
             f"| ![]({name}-before.jpg) | ![]({name}-after.jpg) |", "",
             *first_lines(page), "",
             *source, f"    build/release/bin/pelage run fox docs/tools/examples/{name}.json{given}",
             f"    build/release/bin/pelage frame fox -o {name}.png {' '.join(page['camera'])}", "",
             "`pelage undo fox` shows the fur before. The recipe (positions are shares of the model's box):", "",
             "```json", recipe.strip(), "```", ""]
    for schema in page["schemas"]:
        heading = "Parameters" if schema == page["schemas"][0] else schema
        lines += [f"## {heading}", ""]
        lines += [SCHEMAS.all[schema]["description"].strip(), ""]
        lines += [*where(schema), *table(schema), ""]
    lines += ["[All tools](../grooming.md)", ""]
    return "\n".join(lines)


def brush_text():
    lines = ["# Brush and stroke", "", (FOLDER / "brush_words.txt").read_text(encoding="utf-8").strip(), ""]
    for title, schema in (("Brush", "Brush"), ("Symmetry", "Symmetry"), ("Plane", "Plane"), ("Stroke", "Stroke"), ("Sample", "Sample"), ("View", "View")):
        lines += [f"## {title}", "", *table(schema), ""]
    return "\n".join([*lines, "[All tools](../grooming.md)", ""])


def all_pages():
    return {"brush": brush_text(), **{name: page_text(name) for name in PAGES}}


def check():
    stale = [name for name, text in all_pages().items()
             if not (FOLDER / f"{name}.md").exists() or (FOLDER / f"{name}.md").read_text(encoding="utf-8") != text]
    pictures = [f"{name}-{when}.jpg" for name in PAGES for when in ("before", "after")]
    missing = [picture for picture in pictures if not (FOLDER / picture).exists()]
    if stale or missing:
        sys.exit(f"stale: {stale}; missing: {missing}. Run docs/tools/make.py")
    print(f"{len(PAGES) + 1} pages are current")


def write_pages():
    for name, text in all_pages().items():
        (FOLDER / f"{name}.md").write_text(text, encoding="utf-8")


# Pictures

class Server:
    """Runs pelaged on a free port of this machine with a temporary data folder, and calls the client."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        port = pathlib.Path(self.folder.name) / "port"
        self.process = subprocess.Popen([BIN / "pelaged", "--listen", "127.0.0.1:0", "--port-file", port, "--data",
                                         pathlib.Path(self.folder.name) / "data"], stdout=subprocess.DEVNULL)
        while not port.exists():
            if self.process.poll() is not None:
                sys.exit("pelaged did not start")
            time.sleep(0.05)
        self.address = f"http://127.0.0.1:{port.read_text().strip()}"
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()

    def pelage(self, *arguments):
        run = subprocess.run([BIN / "pelage", "--server", self.address, *arguments], capture_output=True, text=True)
        if run.returncode:
            sys.exit(f"pelage {' '.join(map(str, arguments))}: {run.stderr}")
        return run.stdout.strip()


def draw(server, scene, camera, name):
    picture = pathlib.Path(server.folder.name) / "picture.png"
    server.pelage("frame", scene, "-o", picture, *VIEW, *camera)
    subprocess.run(["oiiotool", "--nosoftwareattrib", picture, "--compression", "jpeg:88", "-o", FOLDER / f"{name}.jpg"], check=True)


def make_source(server, recipe):
    """Makes another scene, groomed by a recipe of clients/recipes, and returns its id."""
    scene = server.pelage("new", "--name", "source", "--builtin", "creature", "--triangles", "20000")
    server.pelage("run", scene, ROOT / "clients" / "recipes" / f"{recipe}.json")
    return scene


def make_pictures(server, name):
    """Draws the fur after the example (NAME-after), and before its last step (NAME-before)."""
    page = PAGES[name]
    scene = server.pelage("new", "--name", "fox", "--builtin", page["builtin"], "--triangles", "20000")
    if page["picture"]:
        server.pelage("map", "upload", scene, FOLDER / "examples" / page["picture"])
    given = ["--set", f"source={make_source(server, page['source'])}"] if page["source"] else []
    server.pelage("run", scene, FOLDER / "examples" / f"{name}.json", *given)
    draw(server, scene, PAGES[name]["camera"], f"{name}-after")
    server.pelage("undo", scene)
    draw(server, scene, PAGES[name]["camera"], f"{name}-before")
    server.pelage("rm", scene)


def make_groom(server, name):
    """Draws a model before and after its recipe of clients/recipes, for docs/recipes.md."""
    model = GROOMS[name]
    path = SHARED / model["file"] if "file" in model else None
    if path and not path.exists():
        return print(f"{name}: skipped, there is no {path}")
    scene = server.pelage("new", "--name", name, "--builtin", "creature", "--triangles", "20000")
    if path:
        server.pelage("load", scene, path, *model["options"])
    draw(server, scene, model["camera"], f"groom-{name}-before")
    server.pelage("run", scene, ROOT / "clients" / "recipes" / f"{name}.json")
    draw(server, scene, model["camera"], f"groom-{name}-after")
    draw(server, scene, ["--camera", "left"], f"groom-{name}-left")
    server.pelage("rm", scene)


def make_retargeted(server, name):
    """Draws the creature's groom on another model, moved by its fields and by its log, for docs/retarget.md."""
    path = SHARED / GROOMS[name]["file"]
    if not path.exists():
        return print(f"retarget-{name}: skipped, there is no {path}")
    source = make_source(server, "creature")
    scene = server.pelage("new", "--name", name)
    server.pelage("load", scene, path, *GROOMS[name]["options"])
    lines, look = (pathlib.Path(server.folder.name) / file for file in ("lines", "look.json"))
    lines.write_text(server.pelage("log", source, "--lines", "--for", scene), encoding="utf-8")
    look.write_text('{"op": "set_look", "look": {"colour_source": "coat"}}', encoding="utf-8")  # the model has no colours of its own
    server.pelage("run", scene, FOLDER / "examples" / "retarget.json", "--set", f"source={source}")
    draw(server, scene, GROOMS[name]["camera"], f"retarget-{name}-fields")
    server.pelage("undo", scene)
    server.pelage("run", scene, lines)
    server.pelage("run", scene, look)
    draw(server, scene, GROOMS[name]["camera"], f"retarget-{name}-log")


def main():
    if sys.argv[1:] == ["--check"]:
        return check()
    write_pages()
    if sys.argv[1:] == ["--pages"]:
        return
    wanted = tuple(sys.argv[1:]) or ("",)
    with Server() as server:
        for name in [*PAGES, *GROOMS]:
            if name.startswith(wanted):
                start = time.monotonic()
                (make_pictures if name in PAGES else make_groom)(server, name)
                print(f"{name}: {time.monotonic() - start:.1f} s", flush=True)
        if "retarget-koala".startswith(wanted):
            make_retargeted(server, "koala")


main()
