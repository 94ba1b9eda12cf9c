"""The groom in other programs' formats, read back by small readers of their own."""

import json
import re
import struct
import subprocess
import tempfile
from pathlib import Path

import numpy

from support.pictures import png
from support.server import BIN, Scene, ServedTest, Server

WHISKERS = {"op": "set_curves", "groups": [{"curves": [[[0, 0, 0.5], [0.5, 0, 1]], [[0, 0.1, 0.5], [0.5, 0.2, 1]]], "width_root": 0.01}]}


def numbers(text, declaration):
    """The numbers of an array of a USD text."""
    found = re.search(re.escape(declaration) + r" = \[(.*?)\](?: \(|\n)", text, re.DOTALL)
    return numpy.array([float(n) for n in re.findall(r"-?[0-9.]+(?:e[-+]?\d+)?", found[1])]) if found else None


class Usd:
    def __init__(self, text):
        self.text = text
        self.translate = numpy.array([float(n) for n in re.search(r"xformOp:translate = \((.*?)\)", text)[1].split(",")])
        self.counts = numbers(text, "int[] curveVertexCounts").astype(int)
        self.points = numbers(text, "point3f[] points").reshape(-1, 3)
        self.widths = numbers(text, "float[] widths")
        self.colours = numbers(text, "color3f[] primvars:displayColor").reshape(-1, 3)
        self.extent = numbers(text, "float3[] extent").reshape(2, 3)
        assert (numbers(text, "float3[] primvars:groom_color") == self.colours.ravel()).all()
        self.uvs = numbers(text, "float2[] primvars:groom_root_uv")
        self.roots = self.points[numpy.cumsum(self.counts) - self.counts]


class Hair:
    def __init__(self, content):
        magic, self.strands, points, arrays = struct.unpack_from("<4sIII", content)
        assert magic == b"HAIR" and arrays == 23, (magic, arrays)
        at = 128
        self.segments = numpy.frombuffer(content, "<u2", self.strands, at)
        at += 2 * self.strands
        self.points = numpy.frombuffer(content, "<f4", 3 * points, at).reshape(-1, 3)
        at += 12 * points
        self.thickness = numpy.frombuffer(content, "<f4", points, at)
        at += 4 * points
        self.colours = numpy.frombuffer(content, "<f4", 3 * points, at).reshape(-1, 3)
        assert at + 12 * points == len(content)


def standing(content):
    """The box of the first mesh of a GLB where its first node puts it."""
    size, = struct.unpack_from("<I", content, 12)
    gltf = json.loads(content[20:20 + size])
    node = gltf["nodes"][0]
    position = gltf["accessors"][gltf["meshes"][node["mesh"]]["primitives"][0]["attributes"]["POSITION"]]
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    turn = numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    corners = numpy.array([position["min"], position["max"]]) * node.get("scale", [1, 1, 1])
    positions = corners @ turn.T + node["translation"]
    return [positions.min(axis=0), positions.max(axis=0)]


class Export(ServedTest):
    def scene_of(self, builtin="sphere", length=0.05, count=20):
        scene = self.server.new_scene(builtin, 500, fur={"length": length, "inclination": 0})
        self.assertEqual(scene.run({"op": "set_coat", "coat": {"count": count, "length_spread": 0.3}}).status, 200)  # some thousand strands
        return scene

    def export(self, scene, format, query=""):
        answer = self.server.get(f"{scene.path}/export/{format}{query}")
        self.assertEqual(answer.status, 200, answer)
        return answer

    def usd(self, scene, query=""):
        return Usd(self.export(scene, "usda", query).body.decode())

    def test_usd_and_hair_hold_the_same_strands(self):
        scene = self.scene_of()
        scene.run(WHISKERS)
        answer = self.export(scene, "usda")
        usd, hair = Usd(answer.body.decode()), Hair(self.export(scene, "hair").body)
        about = json.loads(answer.headers["pelage-export"])
        self.assertEqual((about["strands"], about["points"], about["bytes"]), (len(usd.counts), len(usd.points), len(answer.body)))
        self.assertEqual(about, self.export(scene, "usda", "?dry_run=1").json)
        numpy.testing.assert_array_equal(hair.segments + 1, usd.counts)
        size = scene.info()["size"]
        numpy.testing.assert_allclose(usd.points + usd.translate, hair.points, atol=1e-6 * size)
        numpy.testing.assert_allclose(usd.widths, hair.thickness, rtol=1e-6)
        numpy.testing.assert_allclose(usd.colours, hair.colours, rtol=1e-6)
        self.assertTrue((usd.widths > 0).all() and numpy.isfinite(usd.points).all())
        self.assertTrue((usd.points >= usd.extent[0]).all() and (usd.points <= usd.extent[1]).all())

    def test_roots_lie_on_the_skin_and_tips_a_length_away(self):
        scene = self.scene_of(length=0.05)
        usd, size = self.usd(scene), scene.info()["size"]
        radius = 0.5 * size / 3**0.5
        distances = numpy.linalg.norm(usd.roots, axis=1)
        self.assertLess(abs(distances / radius - 1).max(), 0.02)  # flat triangles
        tips = usd.points[numpy.cumsum(usd.counts) - 1]
        reach = numpy.linalg.norm(tips - usd.roots, axis=1) / size
        self.assertLess(reach.max(), 0.08)
        self.assertGreater(numpy.median(reach), 0.02)

    def test_bald_parts_have_no_strands(self):
        scene = self.scene_of(count=100)
        all_strands = len(self.usd(scene).counts)
        self.assertEqual(scene.run({"op": "paint", "flood": True, "field": "density", "value": 0.5, "brush": {"strength": 1}}).status, 200)
        self.assertAlmostEqual(len(self.usd(scene).counts) / all_strands, 0.5, delta=0.06)  # of a tile of 100 strands
        self.assertEqual(scene.run({"op": "paint", "flood": True, "field": "density", "value": 0, "brush": {"strength": 1}}).status, 200)
        answer = self.export(scene, "usda", "?dry_run=1").json
        self.assertEqual((answer["strands"], answer["points"]), (0, 0))
        self.assertEqual(Hair(self.export(scene, "hair").body).strands, 0)

    def test_fewer_strands_are_guides_or_wider(self):
        scene = self.scene_of()
        whole, few, wide = self.usd(scene), self.usd(scene, "?every=8"), self.usd(scene, "?every=8&widen=true")
        self.assertAlmostEqual(len(few.counts) / len(whole.counts), 1 / 8, delta=0.02)
        self.assertAlmostEqual(numpy.median(wide.widths) / numpy.median(few.widths), 8, delta=0.01)
        self.assertIn("int[] primvars:groom_guide = [1]", few.text)
        self.assertIn("int[] primvars:groom_guide = [0]", wide.text)
        self.assertIn("int[] primvars:groom_guide = [0]", whole.text)

    def test_curves_can_be_left_out(self):
        scene = self.scene_of()
        before = len(self.usd(scene).counts)
        self.assertEqual(scene.run(WHISKERS).status, 200)
        self.assertEqual(len(self.usd(scene).counts), before + 2)
        self.assertEqual(len(self.usd(scene, "?curves=false").counts), before)

    def test_roots_know_their_place_in_the_texture(self):
        torus = self.usd(self.scene_of("torus"))
        self.assertEqual(len(torus.uvs), 2 * len(torus.counts))
        self.assertTrue((torus.uvs >= 0).all() and (torus.uvs <= 1).all() and torus.uvs.std() > 0.2)
        self.assertIsNone(self.usd(self.scene_of("sphere")).uvs)

    def box(self):
        """A furred box that stands far from its origin, in a file with z up that looks along x."""
        positions = [(x, y, z) for x in (10, 11) for y in (20, 22) for z in (30, 33)]
        quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        text = "\n".join(["v %d %d %d" % corner for corner in positions] + ["f " + " ".join(str(k + 1) for k in quad) for quad in quads])
        scene = self.server.new_scene("plane", 2)
        loaded = self.server.call("PUT", f"{scene.path}/model?format=obj&up=z&front=x&length=0.05", text.encode())
        self.assertEqual(loaded.status, 200, loaded)
        self.assertEqual(scene.run({"op": "set_coat", "coat": {"count": 20}}).status, 200)
        return scene, numpy.array([[10, 20, 30], [11, 22, 33]])

    def test_what_is_exported_lies_on_the_file_that_the_model_came_from(self):
        scene, box = self.box()
        turned = [scene.info()["bounds"][end] for end in ("min", "max")]
        for query, wanted, up in (("", box, "Z"), ("&frame=pelage", turned, "Y")):
            usd, hair = self.usd(scene, "?curves=true" + query), Hair(self.export(scene, "hair", "?curves=true" + query).body)
            roots = usd.roots + usd.translate
            numpy.testing.assert_allclose([roots.min(axis=0), roots.max(axis=0)], wanted, atol=0.05)
            numpy.testing.assert_allclose(usd.points + usd.translate, hair.points, atol=1e-4)
            self.assertIn(f'upAxis = "{up}"', usd.text)
            self.assertIn("metersPerUnit = 1\n", usd.text)
        self.assertIn("metersPerUnit = 0.01\n", self.usd(scene, "?metres_per_unit=0.01").text)
        for query, wanted in (("shells?metres_per_unit=0.01", 0.01 * box), ("cards?metres_per_unit=0.01&cards=200", 0.01 * box),
                              ("fields?frame=pelage", turned)):
            with self.subTest(query):
                numpy.testing.assert_allclose(standing(self.export(scene, query).body), wanted, atol=1e-4)
        self.assertEqual(self.server.get(f"{scene.path}/export/hair?metres_per_unit=2").json["pointer"], "/metres_per_unit")
        self.assertEqual(self.server.get(f"{scene.path}/export/pelage?frame=source").json["pointer"], "/frame")

    def test_usd_has_cubic_curves_and_the_skin_where_they_are_asked_for(self):
        scene, box = self.box()
        scene.run({"op": "set_curves", "groups": [{"curves": [[[21, 33, 10.5], [21, 34, 10.5]]]}]})
        plain, rich = self.usd(scene), self.usd(scene, "?basis=cubic&skin=true")
        numpy.testing.assert_array_equal(rich.points, plain.points)
        for text in ('type = "cubic"', 'basis = "catmullRom"', 'wrap = "pinned"', 'def Mesh "skin"'):
            self.assertIn(text, rich.text)
            self.assertNotIn(text, plain.text)
        skin = rich.text[rich.text.index('def Mesh "skin"'):]
        self.assertEqual(numbers(skin, "int[] faceVertexCounts").tolist(), 12 * [3])
        points = numbers(skin, "point3f[] points").reshape(-1, 3) + rich.translate
        numpy.testing.assert_allclose([points.min(axis=0), points.max(axis=0)], box, atol=1e-4)
        triangles = points[numbers(skin, "int[] faceVertexIndices").astype(int).reshape(-1, 3)]
        outwards = numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        self.assertTrue(((triangles.mean(axis=1) - box.mean(axis=0)) * outwards).sum(axis=1).min() > 0)
        numpy.testing.assert_array_equal(numbers(plain.text, "float[] primvars:groom_width"), plain.widths)
        names = re.search(r"groom_group_name = \[(.*?)\]", plain.text)[1].split(", ")
        self.assertEqual((names.count('"fur"'), names.count('"whiskers"')), (len(plain.counts) - 1, 1))
        self.assertEqual(self.server.get(f"{scene.path}/export/hair?skin=true").json["pointer"], "/skin")

    def test_guides_come_back_in_the_axes_and_unit_of_the_file(self):
        scene, _ = self.box()
        put = lambda content, query: self.server.call("PUT", f"{scene.path}/guides?{query}", content)
        for format in ("usda", "hair"):
            curves = self.export(scene, format, "?every=8").body
            taken = put(curves, f"format={format}")
            self.assertEqual(taken.status, 200, taken)
            self.assertFalse([word for word in taken.json["results"][0]["warnings"] if "left out" in word])
            self.assertEqual(put(curves, f"format={format}&frame=pelage").status, 422)
        curve = "def BasisCurves \"c\" { int[] curveVertexCounts = [2] point3f[] points = [(%g, %g, %g), (%g, %g, %g)] }"
        y_up = '#usda 1.0\n( metersPerUnit = 0.01 upAxis = "Y" )\n' + curve % (1050, 3300, -2100, 1060, 3310, -2100)
        self.assertEqual(put(y_up.encode(), "format=usda&metres_per_unit=1").status, 200)
        self.assertEqual(put(y_up.encode(), "format=usda&metres_per_unit=2").status, 422)
        self.assertEqual(put(y_up.encode(), "format=usda").status, 422, "the unit of an OBJ is not known")

    def test_what_cannot_be_exported_is_refused(self):
        scene = self.scene_of()
        for path, pointer in (("usda?shells=4", "/shells"), ("shells?every=2", "/every"), ("usda?every=0", "/every"), ("usda?every=1.5", "/every"), ("usda?nth=2", "/nth")):
            answer = self.server.get(f"{scene.path}/export/{path}")
            self.assertEqual((answer.status, answer.json.get("pointer")), (422, pointer), answer)
        self.assert_problem(self.server.get(f"{scene.path}/export/fbx"), 404, "/format")
        self.assert_problem(self.server.get(f"{scene.path}/maps/fluff"), 404, "/field")

    def test_the_client_writes_whole_files_and_says_what_they_hold(self):
        scene = self.scene_of()
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "fur.hair")
            run = lambda *words: subprocess.run([BIN / "pelage", "--server", self.server.address, "export", scene.id, *words],
                                                capture_output=True, text=True, timeout=120)
            asked = run("-o", file, "--dry-run")
            self.assertEqual((asked.returncode, list(Path(folder).iterdir())), (0, []), asked)
            done = run("-o", file, "--every", "4")
            self.assertEqual(done.returncode, 0, done)
            self.assertIn(f"{Hair(file.read_bytes()).strands} strands", done.stdout)
            refused = run("-o", Path(folder, "fur.fbx"))
            self.assertEqual(refused.returncode, 3, refused)
            self.assertIn(".usda | .hair | .glb | .pelage", refused.stderr)
            self.assertEqual([p.name for p in Path(folder).iterdir()], ["fur.hair"])

    def test_a_scene_goes_to_another_server_and_back(self):
        scene = self.scene_of("torus")
        scene.run({"op": "noise", "flood": True, "amount": 0.5})
        self.assertEqual(self.server.call("PUT", f"{scene.path}/maps/length", png(numpy.full((8, 8, 3), 90, numpy.uint8))).status, 200)
        scene.post("undo")
        content = self.export(scene, "pelage").body
        picture = scene.frame(width=64, height=64).body
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "fur.pelage")
            file.write_bytes(content)
            other = Server()
            self.addCleanup(other.close)
            ran = subprocess.run([BIN / "pelage", "--server", other.address, "open", file, "--name", "there"], capture_output=True, text=True, timeout=120)
            self.assertEqual(ran.returncode, 0, ran)
        there = Scene(other, ran.stdout.strip())
        info, here = there.info(), scene.info()
        self.assertEqual((info["name"], info["revision"], info["fields_hash"], info["undo_steps"], info["redo_steps"]),
                         ("there", here["revision"], here["fields_hash"], here["undo_steps"], here["redo_steps"]))
        self.assertEqual(there.frame(width=64, height=64).body, picture)
        self.assertEqual(there.post("redo").status, 200)  # with the picture of the map
        self.assertEqual(scene.post("redo").status, 200)
        self.assertEqual(there.info()["fields_hash"], scene.info()["fields_hash"])
        other.kill()
        other.start()
        self.assertEqual(Scene(other, there.id).info()["fields_hash"], scene.info()["fields_hash"])

    def open(self, content, query=""):
        return self.server.call("POST", f"/v1/open{query}", content, headers={"Content-Type": "application/octet-stream"})

    def test_files_that_are_no_scenes_make_none(self):
        scene = self.scene_of()
        good = self.export(scene, "pelage").body
        before = len(self.server.get("/v1/scenes").json["scenes"])
        torn = bytearray(good)
        torn[len(good) // 2 : len(good) // 2 + 4096] = b"x" * 4096
        for content in (b"", b"no file", good[:4000], bytes(torn)):
            answer = self.open(content)
            self.assertEqual(answer.status, 422, answer)
            self.assertIn("exported as pelage", answer.json["limit"])
        self.assertEqual(self.open(good, "?name=" + 201 * "x").status, 422)
        self.assertEqual(self.server.call("POST", "/v1/open", good).status, 415)  # JSON, as it says
        self.assertEqual(len(self.server.get("/v1/scenes").json["scenes"]), before)
