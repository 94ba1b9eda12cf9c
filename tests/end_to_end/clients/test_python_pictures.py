"""Pictures and picks of the Python package: frames, live and traced ones, their files, addresses and costs."""

import io
import threading
import unittest.mock
import urllib.request

from PIL import Image

from support.package import PackageTest, pelage

SIZE = {"width": 64, "height": 48}
THIN_COAT = {"count": 500}  # it grows at once


class Pictures(PackageTest):
    def setUp(self):
        super().setUp()
        self.scene.set_coat(coat=THIN_COAT)

    def test_a_frame(self):
        frame = self.scene.frame(camera="front", **SIZE)
        self.assertEqual(Image.open(io.BytesIO(frame.bytes)).size, (64, 48))
        self.assertEqual((frame.format, frame.revision, frame.quality["method"]), ("png", 1, "raster"))
        self.assertGreaterEqual(frame.estimate["error_safety"], 1)
        self.assertIn("bytes", frame.counters)
        self.assertGreater(frame.timing["draw"], 0)
        self.assertAlmostEqual(frame.milliseconds, sum(v for k, v in frame.timing.items() if k != "cpu"))
        self.assertIsNone(frame.trace)

    def test_a_camera_is_a_word_or_an_object(self):
        named, whole = (self.scene.frame(camera=camera, **SIZE).bytes for camera in ("left", {"auto": "left"}))
        self.assertEqual(named, whole)
        self.assertNotEqual(named, self.scene.frame(camera={"position": [0, 0, 9], "target": [0, 0, 0]}, **SIZE).bytes)

    def test_notebooks_show_png_and_jpeg(self):
        frame = self.scene.frame(**SIZE)
        self.assertEqual((frame._repr_png_(), frame._repr_jpeg_()), (frame.bytes, None))
        frame = self.scene.frame(format="jpeg", **SIZE)
        self.assertEqual((frame._repr_png_(), frame._repr_jpeg_()), (None, frame.bytes))

    def test_files_by_their_endings(self):
        starts = {"a.png": b"\x89PNG", "b.JPG": b"\xff\xd8", "c.jpeg": b"\xff\xd8", "d.exr": b"v/1\x01"}
        for name, start in starts.items():
            with self.subTest(name):
                frame = self.scene.save_frame(self.folder / name, **SIZE)
                self.assertEqual((self.folder / name).read_bytes(), frame.bytes)
                self.assertTrue(frame.bytes.startswith(start), frame.bytes[:4])
        self.scene.save_frame(self.folder / "deep.png", format="png16", **SIZE)
        self.assertEqual((self.folder / "deep.png").read_bytes()[24], 16, "bits of a channel")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), [*sorted(starts), "deep.png"])

    def test_other_endings_are_refused_before_the_drawing(self):
        route = 'pelage_requests_total{route="/v1/scenes/{id}/frames",status="200"}'
        before = self.client.metrics().get(route)
        for name, more in (("x.gif", {}), ("x", {}), ("x.png", {"format": "exr"})):
            with self.subTest(name), self.assertRaises(ValueError):
                self.scene.save_frame(self.folder / name, **more, **SIZE)
        self.assertEqual(self.client.metrics().get(route), before)
        frame = self.scene.frame(**SIZE)
        with self.assertRaisesRegex(ValueError, "exr"):
            frame.save(self.folder / "x.exr")

    def test_a_file_that_cannot_be_written_leaves_the_old_one(self):
        frame = self.scene.frame(**SIZE)
        path = self.folder / "x.png"
        path.write_text("old")
        with unittest.mock.patch("os.replace", side_effect=OSError("full")), self.assertRaises(OSError):
            frame.save(path)
        self.assertEqual([(one.name, one.read_text()) for one in self.folder.iterdir()], [("x.png", "old")])

    def test_cost_of_a_frame(self):
        cost = self.scene.frame_cost(quality="detailed", **SIZE)
        self.assertGreaterEqual(cost["safety"], 1)
        with self.assertRaises(pelage.Refused) as caught:
            self.scene.frame(quality={"raster": {"strands": 1000, "light_of": 1}}, width=8192, height=8192, max_seconds=1)
        self.assertEqual(caught.exception.pointer, "/max_seconds")
        self.assertEqual(self.scene.frames_under_way(), [])

    def test_earlier_revisions(self):
        before = self.scene.frame(**SIZE)
        self.scene.length(flood=True, value=0.2)
        self.assertNotEqual(self.scene.frame(**SIZE).bytes, before.bytes)
        earlier = self.scene.frame(revision=1, **SIZE)
        self.assertEqual((earlier.revision, earlier.bytes), (1, before.bytes))

    def lift(self):
        self.scene.lift(flood=True)
        self.client.close()

    def test_live_frames_come_with_each_change(self):
        frames = self.scene.live_frames(view="me", quality="draft", **SIZE)
        self.assertEqual(next(frames).revision, 1)
        self.scene.length(flood=True, value=0.2)
        self.assertEqual(next(frames).revision, 2)
        with unittest.mock.patch("pelage.pictures.WAIT", 0.01):
            timer = threading.Timer(0.3, self.lift)
            timer.start()
            self.assertEqual(next(frames).revision, 3, "after some waits without news")
            timer.join()
        self.scene.remove()
        self.assertRaises(pelage.NotFound, next, frames)

    def test_better_frames_continue_to_the_last(self):
        frames = list(self.scene.better_frames(view="me", progressive={"passes": 6, "strands": 20000}, **SIZE))
        passes = [frame.trace["passes"] for frame in frames]
        self.assertEqual((passes[0], passes[-1], passes), (0, 6, sorted(set(passes))))
        self.assertEqual([frame.trace["end"] for frame in frames], ["none"] * (len(frames) - 1) + ["passes"])

    def test_a_traced_frame(self):
        frame = self.scene.frame(quality={"method": "strands", "trace": {"passes": 2, "strands": 20000}}, **SIZE)
        self.assertEqual((frame.trace["passes"], frame.trace["end"]), (2, "passes"))

    def test_the_address_of_a_frame(self):
        address = self.scene.frame_address(camera="left", background="#ff0000", light_of=4, **SIZE)
        with urllib.request.urlopen(address) as answer:
            self.assertEqual(Image.open(answer).size, (64, 48))

    def test_pick(self):
        ball = self.client.create("ball", model={"builtin": "sphere", "triangles": 300})
        ball.set_coat(coat=THIN_COAT)
        hit = ball.pick(32.5, 32.5, camera="front", width=64, height=64)
        self.assertTrue(hit["hit"])
        self.assertGreater(hit["position"][2], 0.9)
        self.assertEqual(self.scene.pick(0.5, 0.5, camera="front", width=64, height=64), {"hit": False})

    def test_mesh_subdivide(self):
        self.assertTrue(self.scene.mesh(triangles=200).startswith(b"glTF"))
        triangles = self.scene.info()["triangles"]
        self.assertEqual(self.scene.subdivide(levels=1)["triangles"], 4 * triangles)
        self.assertEqual(self.scene.turn(up="z", front="-y")["undo_steps"], 0)
