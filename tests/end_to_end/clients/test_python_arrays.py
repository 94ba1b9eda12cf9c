"""Arrays of the Python package, and exports: frames, fields and maps as numbers, both ways."""

import contextlib
import io
import pathlib
import sys
import tempfile
import unittest.mock

import numpy
from PIL import Image

from support.server import REPOSITORY, ServedTest

sys.path.insert(0, str(REPOSITORY / "clients" / "python"))
import pelage  # noqa: E402

SIZE = {"width": 64, "height": 48}


class Arrays(ServedTest):
    def setUp(self):
        self.client = pelage.Server(self.server.address)
        self.addCleanup(self.client.close)
        self.scene = self.client.create("fox", model={"builtin": "torus", "triangles": 500})
        self.scene.set_coat(coat={"count": 500})  # it grows at once
        self.vertices = self.scene.info()["vertices"]
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_a_frame_has_the_pixels_of_its_png(self):
        for background in ("transparent", "#204060"):
            array = self.scene.frame_array(camera="front", background=background, **SIZE)
            frame = self.scene.frame(camera="front", background=background, **SIZE)
            self.assertEqual((array.shape, array.dtype), ((48, 64, 4), numpy.uint8))
            numpy.testing.assert_array_equal(array, numpy.asarray(Image.open(io.BytesIO(frame.bytes)).convert("RGBA")))

    def test_a_linear_frame_has_the_channels_of_its_aovs(self):
        array = self.scene.frame_array(linear=True, aovs=["depth", "beauty", "normal"], **SIZE)
        self.assertEqual((array.shape, array.dtype), ((48, 64, 8), numpy.float32))
        hit = array[..., 4] > 0.99
        self.assertTrue(hit.any() and numpy.isfinite(array[hit]).all())
        self.assertEqual(self.scene.frame_array(linear=True, **SIZE).shape, (48, 64, 4))

    def test_files(self):
        frame = self.scene.save_frame(self.folder / "fox.npy", **SIZE)
        numpy.testing.assert_array_equal(numpy.load(self.folder / "fox.npy"), frame.array())
        self.assertEqual(frame.array().dtype, numpy.uint8)
        self.scene.save_frame(self.folder / "linear.npy", format="npy_linear", **SIZE)
        self.assertEqual(numpy.load(self.folder / "linear.npy").dtype, numpy.float32)
        self.assertIsNone(frame._repr_png_())

    def test_fields_there_and_back(self):
        self.scene.noise(flood=True, fields=["direction", "length", "density"], amount=0.3)
        self.scene.paint(flood=True, field="tip_colour", colour="#d8904a", value=0.6)
        for name, shape in (("length", ()), ("density", ()), ("direction", (3,)), ("tip_colour", (4,))):
            with self.subTest(name):
                field = self.scene.field(name)
                self.assertEqual((field.shape, field.dtype), ((self.vertices, *shape), numpy.float32))
                self.assertLess(self.scene.set_field(name, field)["results"][0]["max_change"], 1e-6)
                self.scene.set_field(name, 0.5 * field)
                numpy.testing.assert_allclose(self.scene.field(name), 0.5 * field, atol=1e-5)

    def test_positions_are_in_the_order_of_fields(self):
        positions, bounds = self.scene.positions(), self.scene.info()["bounds"]
        self.assertEqual((positions.shape, positions.dtype), ((self.vertices, 3), numpy.float64))
        numpy.testing.assert_allclose((positions.min(0), positions.max(0)), (bounds["min"], bounds["max"]), atol=1e-6)
        length = 0.01 + 0.05 * (positions[:, 1] - positions[:, 1].min())
        self.scene.set_field("length", length)
        for vertex in range(0, self.vertices, self.vertices // 7):
            found = self.scene.pick_nearest(positions[vertex].tolist())
            self.assertAlmostEqual(found["length"], length[vertex], delta=1e-4)

    def test_a_field_is_one_step_with_an_author(self):
        answer = self.scene.set_field("length", numpy.linspace(0, 0.1, self.vertices), author="Ann", if_match=1)
        self.assertEqual((answer["revision"], list(self.scene.log())[-1]["author"]), (2, "Ann"))
        numpy.testing.assert_allclose(self.scene.field("length"), numpy.linspace(0, 0.1, self.vertices), atol=1e-6)
        self.scene.undo()
        self.assertEqual(len(numpy.unique(self.scene.field("length"))), 1)

    def test_the_inclination_is_the_length_of_the_direction(self):
        self.scene.comb(flood=True, direction=[0, 1, 0], lean=0.5, brush={"strength": 1})
        self.scene.unify(flood=True, inclination=0.5, weight=1, brush={"strength": 1})
        direction = self.scene.field("direction")
        numpy.testing.assert_allclose(numpy.linalg.norm(direction, axis=1), 0.5, atol=1e-3)
        self.assertGreater(direction[:, 1].mean(), 0)

    def test_arrays_that_do_not_fit_are_refused(self):
        for array in (numpy.zeros(self.vertices - 1), numpy.full(self.vertices, numpy.nan), numpy.zeros((2, 2, 2, 2))):
            with self.subTest(array.shape), self.assertRaises(pelage.Refused):
                self.scene.set_field("length", array)
        with self.assertRaises(ValueError):
            self.scene.set_field("length", ["long"])
        self.assertEqual(self.scene.info()["revision"], 1)

    def test_maps_there_and_back(self):
        self.scene.length(flood=True, mode="jitter", value=0.5)
        array = self.scene.map_array("length", size=128)
        self.assertEqual((array.shape, array.dtype), ((128, 128), numpy.float32))
        self.assertEqual(self.scene.map_array("tip_colour", size=16).shape, (16, 16, 4))
        before = self.scene.field("length")
        self.scene.length(flood=True, value=0.1)
        self.scene.set_map_array("length", array, author="Ann")
        self.assertLess(numpy.abs(self.scene.field("length") - before).max(), 0.01)

    def test_without_numpy_it_says_so_before_anything_is_drawn(self):
        def answers():
            metrics = self.server.get("/metrics").body.decode().splitlines()
            return [line for line in metrics if line.startswith("pelage_requests_total") and ("frames" in line or "maps" in line)]

        before = answers()
        with unittest.mock.patch.dict(sys.modules, {"numpy": None}):
            for call in (self.scene.frame_array, lambda: self.scene.field("length"), lambda: self.scene.set_field("length", [1])):
                with self.assertRaisesRegex(pelage.PelageError, "pip install numpy"):
                    call()
        self.assertEqual(answers(), before)

    def test_exports(self):
        for name, start in (("fox.usda", b"#usda"), ("fox.hair", b"HAIR")):
            with self.subTest(name):
                about = self.scene.export(self.folder / name, every=10)
                content = (self.folder / name).read_bytes()
                self.assertEqual((content[:len(start)], about["bytes"], about["revision"]), (start, len(content), 1))
                self.assertEqual(self.scene.export_about(format=about["format"], every=10), about)
        self.assertGreater(self.scene.export(self.folder / "fox.glb", shells=2)["triangles"], 0)
        (self.folder / "fox.glb").unlink()
        with contextlib.suppress(pelage.Refused):
            self.scene.export(self.folder / "fox.abcd")
            self.fail("an unknown format")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["fox.hair", "fox.usda"])

    def test_a_scene_in_a_file_opens_again(self):
        self.scene.export(self.folder / "fox.pelage")
        again = self.client.open_file(self.folder / "fox.pelage", name="again")
        self.assertEqual((again.name, again.info()["fields_hash"]), ("again", self.scene.info()["fields_hash"]))
        with self.assertRaises(pelage.Refused):
            self.client.open_file(__file__)
