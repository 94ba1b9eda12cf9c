"""A walk through the command-line client."""

import contextlib
import http.server
import json
import os
import pty
import re
import signal
import subprocess
import threading
import time
import unittest

from PIL import Image

from support.nightly import nightly
from support.server import BIN, THIN_COAT, ServedTest, comb, flood, shared_folder




class Client(ServedTest):
    def new(self, *arguments):
        return self.pelage("new", *arguments).stdout.strip()

    def file(self, name, text):
        path = self.server.folder / name
        path.write_text(text)
        return path

    def test_from_new_to_rm(self):
        scene = self.new("--name", "walk", "--builtin", "sphere", "--triangles", 500)
        self.assertIn("walk", self.pelage("list").stdout)
        self.assertIn("revision    0", self.pelage("info", scene).stdout)

        steps = self.file("groom.jsonl", "\n".join(json.dumps(c) for c in (
            THIN_COAT, comb([0, 0.3, 0.95], [0, 0.9, 0.4], radius=0.3), {"op": "blow", "source": [0, 1, 1]},
            {"op": "attract", "point": [0, 0.7, 0.7], "radius": 0.4})))
        self.assertIn("revision 4", self.pelage("run", scene, steps).stdout)

        picture = self.server.folder / "out.png"
        self.pelage("frame", "walk", "-o", picture, "--camera", "left", "--width", 96, "--height", 64, "--quality", "draft",
                    "--background", "transparent", "--exposure", 0.5)
        with Image.open(picture) as image:
            self.assertEqual((image.size, image.mode), ((96, 64), "RGBA"))

        self.assertIn("position", self.pelage("pick", scene, 256, 256).stdout)
        self.assertIn("nothing there", self.pelage("pick", scene, 0, 0).stdout)
        self.assertIn("revision 5", self.pelage("undo", scene, 2).stdout)
        self.assertIn("revision 6", self.pelage("redo", scene).stdout)
        self.assertIn("revision 7", self.pelage("revert", scene, 0).stdout)
        self.assertEqual(len(self.pelage("log", scene).stdout.splitlines()), 7)
        self.assertEqual(self.pelage("log", scene, "--lines").stdout, "")
        self.pelage("rm", scene)
        self.assertIn("There is no scene", self.pelage("info", scene, code=3).stderr)

    def test_a_scene_from_a_file_is_whole_or_not_there(self):
        self.assertRegex(self.pelage("--version").stdout, r"^pelage \d+\.\d+\.\d+ \(commit [0-9a-f]{12}, contract \d+\.\d+\.\d+\)$")
        self.pelage("wait", "--seconds", 20)
        model = self.file("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        scene = self.new("--name", "square", "--file", model)
        self.assertIn("triangles   2", self.pelage("info", scene).stdout)
        before = self.pelage("list").stdout
        self.pelage("new", "--file", self.file("bad.obj", "f 1 2 3\n"), code=3)
        self.assertEqual(self.pelage("list").stdout, before)

    def test_positions_and_steps_are_printed_as_in_recipes(self):
        scene = self.new("--builtin", "sphere")
        self.pelage("run", scene, "-", text=json.dumps(THIN_COAT))
        self.assertRegex(self.pelage("pick", scene, 256, 256, "--camera", "front").stdout, r'in a recipe \{"at": \[0\.5\d*, 0\.5\d*, 1\]')
        far = self.pelage("run", scene, "-", text=json.dumps(comb([9, 9, 9], [9, 9, 8], radius=0.1))).stdout
        self.assertIn("warning: it changed nothing", far)
        near = self.pelage("run", scene, "-", text=json.dumps(flood([0, 1, 0], lean=0.9))).stdout
        self.assertNotIn("warning", near)
        self.assertRegex(self.pelage("log", scene).stdout, r"comb everywhere, \d+ vertices")

    def test_json_answers(self):
        scene = json.loads(self.pelage("--json", "new", "--builtin", "torus", "--triangles", 500).stdout)["id"]
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 0)
        run = self.pelage("run", scene, "-", "--json", text=json.dumps({"commands": [THIN_COAT, flood([0, 1, 0], lean=0.9)]}))
        self.assertEqual(json.loads(run.stdout)["revision"], 1)
        self.assertEqual(len(json.loads(self.pelage("log", scene, "--json").stdout)["entries"]), 1)
        self.assertIn("scenes", json.loads(self.pelage("list", "--json").stdout))
        frame = json.loads(self.pelage("frame", scene, "-o", self.server.folder / "j.png", "--json").stdout)
        self.assertEqual(frame["revision"], 1)
        self.assertIn("raster", frame["quality"])
        self.assertIn("hit", json.loads(self.pelage("pick", scene, 1, 1, "--json").stdout))

    def test_every_form_of_a_file(self):
        scene = self.new("--builtin", "sphere")
        one, two = flood([0, 1, 0], lean=0.9), flood([1, 0, 0], lean=0.8)
        self.pelage("run", scene, self.file("one.json", json.dumps(one, indent=2)))
        self.pelage("run", scene, self.file("array.json", json.dumps([one, two], indent=2)))
        self.pelage("run", scene, self.file("batch.json", json.dumps({"commands": [two, one]})))
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 4)

    def test_a_bad_step_stops_the_run_before_it_begins(self):
        scene = self.new("--builtin", "sphere")
        steps = self.file("bad.jsonl", json.dumps(flood([0, 1, 0], lean=0.9)) + "\n" + '{"op": "comb", "flod": true}\n')
        run = self.pelage("run", scene, steps, code=3)
        for word in ("step 2 of 2", "bad.jsonl", "/stroke", "next:"):
            self.assertIn(word, run.stderr)
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 0)

    def test_errors_help(self):
        scene = self.new("--builtin", "sphere")
        misspelt = {**flood([0, 1, 0]), "brush": {"raduis": 1}}
        run = self.pelage("run", scene, "-", code=3, text=json.dumps(misspelt))
        for word in ("/brush/raduis", "nearest: radius", "next:"):
            self.assertIn(word, run.stderr)
        run = self.pelage("frame", scene, "--width", 0, code=3)
        self.assertIn("[1, 8192]", run.stderr)
        self.assertIn("nearest: torus", self.pelage("new", "--builtin", "torsu", code=3).stderr)
        self.assertIn("Line 2", self.pelage("run", scene, "-", code=3, text='{"op": "comb"}\n{\n').stderr)
        self.assertIn("Cannot read", self.pelage("run", scene, "/nonexistent", code=3).stderr)
        self.assertIn("Cannot read", self.pelage("run", scene, "/", code=3).stderr)
        self.assertIn("Cannot write", self.pelage("frame", scene, "-o", "/nonexistent/x.png", code=1).stderr)
        late = self.pelage("run", scene, "-", "--if-match", 7, code=3, text=json.dumps(flood([0, 1, 0])))
        self.assertIn("revision", late.stderr)

    def test_help_says_the_default_of_form(self):
        for action in ("new", "load"):
            words = " ".join(self.pelage(action, "--help").stdout.split())
            self.assertIn("[animal for files, even for built-in models]", words)

    def test_exit_codes(self):
        self.pelage("--help")
        self.pelage(code=2)
        self.pelage("nonsense", code=2)
        for line, nearest in ((("fame", "fox"), "frame"), (("map", "gte"), "get")):
            refused = self.pelage(*line, code=2).stderr
            self.assertIn(f'There is no command "{line[-1] if nearest == "get" else line[0]}"', refused)
            self.assertIn(f"nearest: {nearest}", refused)
        self.pelage("frame", code=2)
        self.pelage("list", "--server", "ftp://x", code=2)
        gone = self.pelage("list", "--server", "http://127.0.0.1:1", code=1)
        self.assertIn("PELAGE_SERVER", gone.stderr)
        self.assertIn("http://127.0.0.1:1", gone.stderr)

    def test_dry_runs(self):
        scene = self.new("--builtin", "sphere")
        self.pelage("run", scene, "-", "--dry-run", text=json.dumps(flood([0, 1, 0], lean=0.9)))
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 0)

    def test_a_run_says_what_came_of_it(self):
        scene = self.new("--builtin", "plane", "--triangles", 100)
        steps = [flood([1, 0, k / 10], lean=0.5) for k in range(30)] + [comb([9, 9, 9], [9, 9, 8], radius=0.3)]
        text = "\n".join(map(json.dumps, steps))
        run = self.pelage("run", scene, "-", text=text)
        self.assertRegex(run.stdout, r"^31 steps, \d+ vertices touched, 1 warning, \d+\.\d\d s\n"
                                     r"warning: it changed nothing.* \(comb, step 31 of 31 of -\)\nrevision 30\n$")
        self.assertEqual(run.stderr, "")
        self.assertEqual(self.pelage("run", scene, "-", "--verbose", text=text).stdout.count("comb: touched"), 31)

    @nightly
    def test_who_waits_at_a_terminal_sees_a_bar(self):
        steps = self.file("two.jsonl", "\n".join(2 * [json.dumps(flood([0, 1, 0]))]))
        with slow_server(seconds=1.8) as address:
            shown = on_a_terminal("--server", address, "run", "any", steps)
            self.assertEqual(on_a_terminal("--server", address, "run", "any", steps, "--json"), "")
        self.assertRegex(shown, r"running \[#*\.*\] +0 %, step 1 of 2, 1 s")
        self.assertRegex(shown, r"running \[#{10}\.{10}\] +50 %, step 2 of 2, \d s")
        self.assertTrue(shown.endswith("\r\033[K"), shown)
        self.assertEqual(on_a_terminal("--server", self.server.address, "list"), "")

    def test_errors_are_json_where_answers_are(self):
        scene = self.new("--builtin", "plane", "--triangles", 2)
        problem = json.loads(self.pelage("--json", "frame", scene, "--fov", 0, "--position", "0,0,9", "--target", "0,0,0", code=3).stderr)
        self.assertEqual((problem["status"], problem["pointer"], problem["flag"]), (422, "/camera/fov_degrees", "--fov"))
        problem = json.loads(self.pelage("run", scene, "-", "--json", code=3, text='{"op": "lift", "flood": true, "brush": {"raduis": 1}}').stderr)
        self.assertEqual((problem["pointer"], problem["nearest"], problem["context"]), ("/brush/raduis", "radius", "step 1 of 1 of -"))
        self.assertEqual(json.loads(self.pelage("frame", "--json", code=2).stderr)["status"], 422)
        self.assertEqual(json.loads(self.pelage("--json", "info", "none", code=3).stderr)["status"], 404)

    def test_outputs_are_looked_at_before_the_work(self):
        for line in (("frame", "none", "-o", "/nonexistent/x.png"), ("export", "none", "-o", "/nonexistent/x.usda"),
                     ("map", "get", "none", "length", "-o", self.server.folder / "no" / "x.exr"), ("frame", "none", "-o", "/tmp"),
                     ("pick", "none", 1, 1, "--as", "a", "--places", "/nonexistent/p.json")):
            self.assertIn("Cannot write", self.pelage(*line, code=1).stderr)
        self.assertIn("Cannot write", self.pelage("compare", "no.png", "no.png", "--map", "/nonexistent/m.png", code=1).stderr)
        self.pelage("frame", "none", "-o", self.server.folder / "looked.png", code=3)
        self.assertEqual(list(self.server.folder.glob("*looked.png*")), [])

    def test_completions_and_the_manual_know_each_command(self):
        helped = self.pelage("--help").stdout
        commands = re.findall(r"^  ([a-z-]+) {2,}", helped.split("Subcommands:")[1].split("Examples:")[0], re.M)
        self.assertGreater(len(commands), 25)
        texts = [self.pelage("completions", shell).stdout for shell in ("bash", "zsh", "fish")] + [self.pelage("man").stdout]
        for command in commands:
            for text in texts:
                self.assertIn(command.replace("-", "\\-") if text is texts[-1] else command, text)
            if command not in ("map", "farm"):
                self.assertIn("Examples:\n  pelage", self.pelage(command, "--help").stdout.replace("pelaged --data groom-data & ", ""))
        self.pelage("completions", "csh", code=2)

    def test_completions_know_values_and_scenes(self):
        self.new("--name", "red fox", "--builtin", "plane", "--triangles", 2)
        around = {**os.environ, "PATH": f"{BIN}:{os.environ['PATH']}", "PELAGE_SERVER": f"http://127.0.0.1:{self.server.port}"}

        def completed(*words):
            line = " ".join(f"'{word}'" for word in words)
            script = self.file("complete.bash", self.pelage("completions", "bash").stdout
                               + f"COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}\n_pelage\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"\n")
            return subprocess.run(["bash", script], capture_output=True, text=True, check=True, env=around).stdout.splitlines()

        self.assertEqual(completed("pelage", "--json", "map", "get", "fox", "--dil"), ["--dilate"])
        self.assertEqual(completed("pelage", "frame", "fox", "--camera", ""), ["front", "back", "left", "right", "top", "three_quarter"])
        self.assertEqual(completed("pelage", "new", "--builtin", "cl"), ["cloth"])
        self.assertEqual(completed("pelage", "info", "re"), ["red\\ fox"])
        self.assertEqual(completed("pelage", "info", "--he"), ["--help"])

    def test_load(self):
        scene = self.new("--builtin", "plane", "--triangles", 2)
        cube = "\n".join(f"v {x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)) + """
f 1 2 4 3
f 5 7 8 6
f 1 5 6 2
f 3 4 8 7
f 1 3 7 5
f 2 6 8 4
"""
        self.assertIn("triangles   12", self.pelage("load", scene, self.file("cube.OBJ", cube)).stdout)
        self.assertIn("nearest", self.pelage("load", scene, self.file("cube.objj", cube), code=3).stderr)
        self.pelage("load", scene, "-", "--format", "obj", text="v 0 0 0\n", code=3)
        self.assertIn("up z, front -y", self.pelage("load", scene, self.file("c.obj", cube), "--up", "z").stdout)
        self.assertIn("flag:    --front", self.pelage("load", scene, self.file("c.obj", cube), "--up", "z", "--front", "-z", code=3).stderr)
        self.assertIn("part 9", self.pelage("load", scene, self.file("c.obj", cube), "--flip", 9, code=3).stderr)
        self.file("fox.mtl", "newmtl red\nKd 1 0 0\n")
        with_material = self.pelage("load", scene, self.file("c.obj", "mtllib fox.mtl\nmtllib gone.mtl\nusemtl red\n" + cube)).stdout
        self.assertIn("missing_material_files: 1 (gone.mtl)", with_material)
        self.assertNotIn("missing_materials", with_material)
        self.assertIn("put fox.bin beside", self.pelage("load", scene, self.file(
            "c.gltf", '{"asset": {"version": "2.0"}, "buffers": [{"uri": "fox.bin"}]}'), code=3).stderr)

    def test_watch_runs_again_in_place_of_the_run_before(self):
        scene = self.new("--builtin", "sphere", "--triangles", 500)
        self.pelage("run", scene, "-", text=json.dumps(flood([0, 1, 0], lean=0.9)))
        part = self.file("part.json", self.lengths(0.1))
        recipe = self.file("watched.json", json.dumps({"include": ["part.json"], "steps": [{"use": "part"}, {"op": "mask"}]}))
        with self.watching(scene, recipe) as client:
            self.assertRegex(client.stdout.readline(), r"^2 steps, \d+ vertices touched, (1 warning, )?\d.*, revision \d+$")
            one = self.lengths_of(scene)
            part.write_text(self.lengths(0.2))
            self.assertRegex(client.stdout.readline(), r"^2 steps, ")
            two = self.lengths_of(scene)
            part.write_text("{")
            self.assertIn("part.json", client.stderr.readline())
            self.assertEqual(self.lengths_of(scene), two)
            part.write_text(self.lengths(0.1))
            self.assertRegex(client.stdout.readline(), r"^2 steps, ")
            self.assertEqual(self.lengths_of(scene), one)
            self.assertNotEqual(one, two)
            client.send_signal(signal.SIGINT)
            self.assertEqual(client.wait(timeout=20), 0)
        self.assertEqual(len(self.pelage("log", scene, "--lines").stdout.splitlines()), 2)  # the comb, and the run that counts

    def test_watch_leaves_the_work_of_others_alone(self):
        scene = self.new("--builtin", "sphere", "--triangles", 500)
        recipe = self.file("mine.json", self.lengths(0.1))
        with self.watching(scene, recipe) as client:
            client.stdout.readline()
            time.sleep(0.5)  # it looks at the revision once more
            self.pelage("run", scene, "-", text=json.dumps(flood([0, 1, 0], lean=0.9)))
            recipe.write_text(self.lengths(0.2))
            self.assertEqual(client.wait(timeout=20), 3)
            self.assertIn("changed by someone else", client.stderr.read())
        self.assertEqual(json.loads(self.pelage("info", scene, "--json").stdout)["revision"], 2)

    @contextlib.contextmanager
    def watching(self, scene, recipe):
        """The client; it ends with the test whatever that finds."""
        command = [BIN / "pelage", "--server", self.server.address, "run", scene, recipe, "--watch"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as client:
            late = threading.Timer(60, client.kill)
            late.start()
            try:
                yield client
            finally:
                late.cancel()
                client.kill()

    @staticmethod
    def lengths(value):
        return json.dumps({"steps": [{"op": "length", "flood": True, "value": value, "brush": {"strength": 1}}]})

    def lengths_of(self, scene):
        return json.loads(self.pelage("info", scene, "--json").stdout)["fields_hash"]

    def test_steps_keep_their_numbers(self):
        scene = self.new("--builtin", "sphere", "--triangles", 500)
        for direction in ([0, 1, 0], [1, 0, 0]):
            self.pelage("run", scene, "-", text=json.dumps(flood(direction, lean=0.9)))
        self.pelage("amend", scene, 1, self.file("other.json", json.dumps(flood([0, 0, 1], lean=0.5))))
        self.assertIn("step 2", self.pelage("log", scene).stdout)
        self.pelage("amend", scene, 2, "--drop")
        self.assertEqual(len(self.pelage("log", scene, "--lines").stdout.splitlines()), 1)

    def test_a_bald_view(self):
        scene = self.new("--builtin", "sphere", "--triangles", 500)
        self.pelage("run", scene, "-", text=json.dumps(THIN_COAT))
        pictures = {}
        for overlay in ("none", "bald", "wire"):
            picture = self.server.folder / f"{overlay}.png"
            self.pelage("frame", scene, "-o", picture, "--overlay", overlay, "--width", 64, "--height", 64, "--quality", "draft")
            pictures[overlay] = picture.read_bytes()
        self.assertEqual(len(set(pictures.values())), 3)

    def test_guides_come_in(self):
        scene = self.new("--builtin", "sphere", "--triangles", 500)
        curves = json.dumps({"curves": [[[0, 1, 0], [0, 1.2, 0.1]], [[1, 0, 0], [1.2, 0, 0.1]]]})
        self.assertIn("interpolate: touched", self.pelage("guides", scene, self.file("two.json", curves), "--strength", "1").stdout)
        self.assertIn("flag:    --keys", self.pelage("guides", scene, self.file("two.json", curves), "--keys", 0, code=3).stderr)
        self.assertIn("No format", self.pelage("guides", scene, self.file("two.txt", curves), code=3).stderr)

    def test_what_a_frame_takes_is_known_before(self):
        scene = self.new("--builtin", "sphere", "--triangles", 500)
        self.assertRegex(self.pelage("frame", scene, "--dry-run").stdout, r"^about [0-9.e-]+ s, up to ")
        picture = self.file("none.png", "")
        refused = self.pelage("frame", scene, "-o", picture, "--width", 8000, "--height", 8000, "--knob", "strands=1000",
                              "--max-seconds", 1, code=3).stderr
        self.assertIn("flag:    --max-seconds", refused)

    def test_a_real_model(self):
        fox = shared_folder() / "meshes" / "Fox.glb"
        scene = self.new("--builtin", "plane", "--triangles", 2)
        self.assertIn("triangles   576", self.pelage("load", scene, fox).stdout)
        posed = self.pelage("load", scene, fox, "--pose", "Run@0.3").stdout
        self.assertIn("pose        Run@0.3", posed)
        self.assertIn("animations  Survey, Walk, Run", posed)
        self.assertIn("--pose", self.pelage("load", scene, fox, "--pose", "Fly", code=3).stderr)


@contextlib.contextmanager
def slow_server(seconds):
    """The address of a server that takes its time for each command."""
    answer = json.dumps({"revision": 1, "fields_hash": 32 * "0", "results": []}).encode()

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            self.send_response(200)
            self.send_header("Content-Length", str(len(answer)))
            self.end_headers()
            self.wfile.write(answer)

        def do_POST(self):
            self.rfile.read(int(self.headers["Content-Length"]))
            time.sleep(seconds)
            self.do_GET()

        def log_message(self, *_):
            pass

    with http.server.HTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
            thread.join()


def on_a_terminal(*arguments):
    """Returns what the client writes to standard error if that is a terminal."""
    ours, theirs = pty.openpty()
    with subprocess.Popen([BIN / "pelage", *map(str, arguments)], stderr=theirs, stdout=subprocess.DEVNULL) as client:
        os.close(theirs)
        shown = b""
        with contextlib.suppress(OSError):  # of the end
            while block := os.read(ours, 4096):
                shown += block
    os.close(ours)
    assert client.returncode == 0, shown
    return shown.decode()


if __name__ == "__main__":
    unittest.main()
