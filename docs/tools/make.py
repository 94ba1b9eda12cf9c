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
BIN = pathlib.Path(os.environ.get("PELAGE_BIN", ROOT / "build" / "release" / "bin"))
SHARED = pathlib.Path(os.environ.get("PELAGE_SHARED", ROOT.parent / "shared")) / "meshes"
FOLDER = ROOT / "docs" / "tools"
SCHEMAS = json.loads((BIN / "openapi.json").read_text(encoding="utf-8"))["components"]["schemas"]
VIEW = ["--width", "420", "--height", "420", "--knob", "shells=24", "--knob", "shadow_maps=true", "--knob", "scale=1.5"]
NO_LIMIT = 1e20  # bounds as large as these only say that a number is finite; the words say the real ones


# Tables

def resolved(schema):
    """A schema with what it refers to; its own words and default come first."""
    if "$ref" not in schema:
        return schema
    return {**resolved(SCHEMAS[schema["$ref"].split("/")[-1]]), **{k: v for k, v in schema.items() if k != "$ref"}}


def short(number):
    return str(int(number)) if number == int(number) else f"{number:g}"


def bounds(low, high, low_open=False):
    low_known, high_known = low is not None and abs(low) < NO_LIMIT and not low_open, high is not None and high < NO_LIMIT
    if low_known and high_known:
        return f" {short(low)} to {short(high)}"
    return f" {short(low)} or more" if low_known else f" up to {short(high)}" if high_known else ""


# What stands in so many tables that its own words would only repeat themselves.
KNOWN = {"Position": "3 numbers, the model's coordinates", "Direction": "3 numbers; only where they point counts",
         "Colour": "`#rrggbb` (sRGB) or 3 linear numbers, 0 to 1", "Camera": "`auto`, or `position`, `target`, `up`, `fov_degrees`"}


def required_of(schema):
    """Members that are always required, by the schema itself or by a rule that is written for it."""
    return schema.get("required", []) + [name for rule in schema.get("allOf", []) for name in rule.get("required", [])]


def values(schema):
    """What a member may be, in words."""
    known = schema.get("$ref", "").split("/")[-1]
    if known in KNOWN:
        return KNOWN[known]
    schema = resolved(schema)
    if "enum" in schema:
        return ", ".join(map(str, schema["enum"]))
    if "oneOf" in schema:
        return " or ".join(values(one) for one in schema["oneOf"])
    kind = schema.get("type", "any")
    if kind in ("number", "integer"):
        low = schema.get("minimum")
        return kind + bounds(low, schema.get("maximum"), low is not None and 0 < low < 1e-20)
    if kind == "array":
        count = bounds(schema.get("minItems", 0), schema.get("maxItems"))
        if schema.get("minItems") == schema.get("maxItems"):
            count = f" {schema['maxItems']}"
        return f"list of{count}: {values(schema['items'])}"
    if kind == "string":
        return "text of" + bounds(schema.get("minLength", 0), schema.get("maxLength")) + " bytes"
    return "true or false" if kind == "boolean" else kind


def linked(name, schema):
    """Members that have a page or a table of their own."""
    target = schema.get("$ref", schema.get("items", {}).get("$ref", "")).split("/")[-1]
    if target in ("Brush", "Stroke"):
        return f"[{target.lower()}](brush.md)"
    if resolved(schema).get("type") == "object" and resolved(schema).get("properties") and target:
        return f"[{target}](#{target.lower()})"
    if target and schema.get("type") == "array" and resolved(SCHEMAS[target]).get("type") == "object":
        return f"list{bounds(schema.get('minItems', 0), schema.get('maxItems'))} of [{target}](#{target.lower()})"
    return values(schema)


def table(name):
    schema = SCHEMAS[name]
    lines = ["| member | value | default | meaning |", "|---|---|---|---|"]
    for member, own in schema["properties"].items():
        if "const" in own:
            continue
        words = resolved(own).get("description", "")
        default = f"`{json.dumps(resolved(own)['default'])}`" if "default" in resolved(own) else \
            "required" if member in required_of(schema) else ""
        lines.append(f"| `{member}` | {linked(member, own)} | {default} | {words} |".replace("\n", " "))
    return lines


def where(name):
    """Whether a tool takes a stroke, a flood or both."""
    schema = SCHEMAS[name]
    if "stroke" not in schema.get("properties", {}):
        return []
    if "flood" in schema["properties"]:
        return ["Takes either a stroke, or `flood` to work everywhere. The mask holds for both.", ""]
    if "stroke" in required_of(schema):
        return ["Needs a stroke. The mask holds.", ""]
    return ["Works everywhere, or under a stroke's brush where one is given. The mask holds.", ""]


# Pages

def first_lines(page):
    """Where the recipe is tried, and what has to be there first."""
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
             "`pelage undo fox` shows the fur before. The recipe (places are shares of the model's box):", "",
             "```json", recipe.strip(), "```", ""]
    for schema in page["schemas"]:
        heading = "Parameters" if schema == page["schemas"][0] else schema
        lines += [f"## {heading}", ""]
        if "description" in SCHEMAS[schema]:
            lines += [f"{SCHEMAS[schema]['description'].strip()}", ""]
        lines += [*where(schema), *table(schema), ""]
    lines += ["[All tools](../grooming.md)", ""]
    return "\n".join(lines)


def brush_text():
    lines = ["# Brush and stroke", "", (FOLDER / "brush_words.txt").read_text(encoding="utf-8").strip(), ""]
    for title, schema in (("Brush", "Brush"), ("Stroke", "Stroke"), ("Sample", "Sample"), ("View", "View")):
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
    """A pelaged on a free port of this machine with a folder of its own, and the client that talks to it."""

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
    """Another scene, groomed by a recipe of clients/recipes; its id."""
    scene = server.pelage("new", "--name", "source", "--builtin", "creature", "--triangles", "20000")
    server.pelage("run", scene, ROOT / "clients" / "recipes" / f"{recipe}.json")
    return scene


def make_pictures(server, name):
    """The fur that the example leaves, and before that the one without its last step."""
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
    """A recipe of clients/recipes on its model: before and after, for docs/recipes.md."""
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
    """The creature's groom on another model, by its fields and by its log, for docs/retarget.md."""
    path = SHARED / GROOMS[name]["file"]
    if not path.exists():
        return print(f"retarget-{name}: skipped, there is no {path}")
    source = make_source(server, "creature")
    scene = server.pelage("new", "--name", name)
    server.pelage("load", scene, path, *GROOMS[name]["options"])
    lines, look = (pathlib.Path(server.folder.name) / file for file in ("lines", "look.json"))
    lines.write_text(server.pelage("log", source, "--lines", "--for", scene), encoding="utf-8")
    look.write_text('{"op": "set_look", "look": {"colour_source": "coat"}}', encoding="utf-8")  # the model has none
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
