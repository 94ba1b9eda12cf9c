"""Uploads of the Python package: models and the files that they name, environments, textures, pictures and maps."""

import json

import numpy

from support.package import PackageTest, pelage
from support.pictures import hdr, png

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"


class Files(PackageTest):
    def test_load_sends_what_the_model_names(self):
        (self.folder / "skin").mkdir()
        (self.folder / "skin" / "a b.png").write_bytes(png(numpy.full((4, 4, 3), 200)))
        (self.folder / "m.mtl").write_text("newmtl m\nmap_Kd -s 1 1 1 skin/a%20b.png\n")
        model = self.folder / "Model.OBJ"
        model.write_text(f"mtllib m.mtl\n{TRIANGLE}usemtl m\nf 1/1 2/2 3/3\n")
        info = self.scene.load(model, up="z", front="x", length=0.05, form="even", flip=[1])
        self.assertEqual((info["model"], info["up"], info["front"], info["triangles"]), ("zip", "z", "x", 1))
        self.assertEqual([repair["code"] for repair in info["repairs"]], ["flipped_triangles", "open_edges"], "and nothing missing")
        self.assertEqual(self.scene.revision, info["revision"])

    def test_load_of_a_gltf(self):
        positions = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype="<f4").tobytes()
        (self.folder / "mesh.bin").write_bytes(positions)
        document = {"asset": {"version": "2.0"}, "buffers": [{"uri": "mesh.bin", "byteLength": 36}],
                    "bufferViews": [{"buffer": 0, "byteLength": 36}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0,
                    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
                    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]}
        (self.folder / "m.gltf").write_text(json.dumps(document))
        self.assertEqual(self.scene.load(self.folder / "m.gltf")["vertices"], 3)

    def test_load_warns_of_files_that_are_missing_or_outside(self):
        inner = self.folder / "inner"
        inner.mkdir()
        (self.folder / "outside.mtl").write_text("newmtl m\n")
        (inner / "m.obj").write_text(f"mtllib ../outside.mtl\nmtllib none.mtl\n{TRIANGLE}f 1 2 3\n")
        with self.assertWarnsRegex(UserWarning, r"m.obj names files .*: \.\./outside.mtl, none.mtl") as caught:
            info = self.scene.load(str(inner / "m.obj"))
        self.assertEqual((info["model"], caught.filename), ("obj", __file__))

    def test_load_is_refused(self):
        (self.folder / "m.obj").write_text("nothing")
        with self.assertRaises(pelage.Refused):
            self.scene.load(self.folder / "m.obj")
        with self.assertRaises(FileNotFoundError):
            self.scene.load(self.folder / "none.obj")
        (self.folder / "m.xyz").write_text("nothing")
        with self.assertRaises(pelage.Refused) as caught:
            self.scene.load(self.folder / "m.xyz")
        self.assertEqual(caught.exception.pointer, "/format")

    def test_load_keeps_a_groom_unless_it_is_discarded(self):
        (self.folder / "m.obj").write_text(TRIANGLE + "f 1 2 3\n")
        self.scene.noise(flood=True)
        before = self.scene.info()
        transfer = self.scene.load(self.folder / "m.obj")["carried"]
        self.assertEqual(transfer["vertices"], 3)
        self.assertEqual(self.client.open(transfer["before"]).info()["fields_hash"], before["fields_hash"])
        self.assertNotIn("carried", self.scene.info())
        self.assertNotIn("carried", self.scene.load(self.folder / "m.obj", discard=True))
        self.scene.rename("triangle")
        self.assertEqual((self.scene.name, self.scene.info()["name"]), ("triangle", "triangle"))
        self.assertEqual(self.scene.load(self.folder / "m.obj", discard=True)["triangles"], 1)

    def test_progress_of_an_upload(self):
        reports = []
        (self.folder / "m.obj").write_text(TRIANGLE + "f 1/1 2/2 3/3\n" + "# filler\n" * 100_000)
        self.scene.load(self.folder / "m.obj", progress=reports.append)
        shares = [report.share for report in reports]
        self.assertEqual((shares, shares[-1]), (sorted(set(shares)), 1))
        self.assertGreater(len(shares), 2)
        self.assertEqual(reports[-1].text, "0.9 of 0.9 MB sent")

    def test_environment_texture_and_pictures(self):
        picture = hdr(numpy.ones((2, 4, 3)))
        (self.folder / "sky.hdr").write_bytes(picture)
        self.scene.upload_environment(self.folder / "sky.hdr", intensity=2, author="Ann")
        self.assertEqual(self.scene.settings()["environment"]["intensity"], 2)
        self.assertEqual(self.log()[-1]["author"], "Ann")
        self.scene.upload_skin_texture(png(numpy.full((4, 4, 3), 90)), if_match=1)
        self.assertNotEqual(self.scene.settings()["skin_texture"], "own")
        stored = self.scene.upload_picture(png(numpy.full((4, 4, 3), 128)))
        self.assertEqual((stored["width"], stored["bits"]), (4, 8))
        self.scene.mask(picture={"name": stored["picture"]})
        self.assertEqual(self.scene.revision, 3)

    def test_maps(self):
        self.scene.length(flood=True, mode="jitter", value=0.5)
        drawn = self.scene.download_map("length", size=64, format="exr")
        self.assertEqual((drawn.about["field"], drawn.about["encoding"], drawn.revision), ("length", "value", 1))
        drawn.save(self.folder / "length.exr")
        self.scene.length(flood=True, value=0.1)
        answer = self.scene.upload_map("length", self.folder / "length.exr", strength=1, units="relative")
        self.assertEqual(answer["results"][0]["op"], "map")
        self.assertEqual(self.scene.compare(1, 2)["fields"][0]["field"], "length")
        self.assertEqual(self.scene.compare(1, answer["revision"])["fields"], [])
        self.assertIsNotNone(self.scene.download_map("density", size=16)._repr_png_())
