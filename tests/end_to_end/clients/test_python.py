"""The Python package: scenes, commands, history, pictures and uploads against a real server."""

import contextlib
import io
import json
import pathlib
import sys
import tempfile
import threading
import unittest.mock
import urllib.request

import numpy
from PIL import Image

from support.pictures import hdr, png
from support.server import REPOSITORY, ServedTest

sys.path.insert(0, str(REPOSITORY / "clients" / "python"))
import pelage  # noqa: E402

SIZE = {"width": 64, "height": 48}
THIN_COAT = {"count": 500}  # it grows at once
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"


class PackageTest(ServedTest):
    """A scene of its own for each test, which looks at it over HTTP too."""

    def setUp(self):
        self.client = pelage.Server(self.server.address)
        self.addCleanup(self.client.close)
        self.scene = self.client.create("fox", model={"builtin": "torus", "triangles": 500})
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def log(self):
        return self.server.get(f"/v1/scenes/{self.scene.id}/log").json["entries"]


class Scenes(PackageTest):
    def test_create_list_open_remove(self):
        info = self.scene.info()
        self.assertEqual((info["name"], info["model"]), ("fox", "torus"))
        self.assertIn(self.scene.id, [scene.id for scene in self.client.scenes()])
        self.assertEqual(self.client.open(self.scene.id).name, "fox")
        other = self.client.create("näme / 2", model={"builtin": "plane", "triangles": 2}, fur={"length": 0.5})
        self.assertEqual(self.client.open("näme / 2").id, other.id)
        other.remove()
        with self.assertRaisesRegex(pelage.NotFound, "näme / 2"):
            self.client.open("näme / 2")

    def test_a_name_of_two_scenes_is_refused(self):
        for _ in range(2):
            self.client.create("twin", model={"builtin": "plane", "triangles": 2})
        with self.assertRaisesRegex(pelage.PelageError, "2 scenes are named"):
            self.client.open("twin")

    def test_the_service(self):
        self.assertTrue(self.client.is_alive() and self.client.is_ready())
        self.assertGreater(self.client.metrics()['pelage_requests_total{route="/v1/scenes",status="201"}'], 0)
        self.assertEqual(self.client.contract()["info"]["title"], "Pelage")
        self.assertIn(b"<html", self.client.studio_file())
        with self.assertRaises(pelage.NotFound):
            self.client.studio_file("nothing.js")

    def test_address_and_token_from_the_environment(self):
        with unittest.mock.patch.dict("os.environ", {"PELAGE_SERVER": self.server.address, "PELAGE_TOKEN": "secret"}):
            client = pelage.Server()
        self.assertEqual(client.address, self.server.address)
        self.assertEqual(client._connection._headers, {"Authorization": "Bearer secret"})
        for address in ("localhost:8080", "ftp://localhost", "http://", ""):
            with self.subTest(address), unittest.mock.patch.dict("os.environ", {"PELAGE_SERVER": address}):
                if address:
                    self.assertRaises(ValueError, pelage.Server)

    def test_threads_share_a_scene(self):
        client = pelage.Server(self.server.address, retries=0)
        scene = client.open(self.scene.id)

        def groom(seed):
            scene.noise(flood=True, seed=seed)
            client.close()

        threads = [threading.Thread(target=groom, args=(seed,)) for seed in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        client.close()
        self.assertEqual(self.scene.info()["revision"], 8)


class Grooming(PackageTest):
    def test_a_command_is_sent_as_it_is_given(self):
        answer = self.scene.length(flood=True, value=0.07, author="Änn ☃")
        self.assertEqual((answer["revision"], answer["results"][0]["op"], self.scene.revision), (1, "length", 1))
        entry = self.log()[0]
        self.assertEqual((entry["commands"]["value"], entry["author"]), (0.07, "Änn ☃"))

    def test_strokes_take_arrays(self):
        positions = numpy.array([[1, 0.2, 0], [1, 0.3, 0]])
        answer = self.scene.comb(stroke=pelage.stroke(positions, pressures=[0.5, 1], times=numpy.array([0, 0.1])),
                                 brush={"radius": 0.3, "front_faces_only": False})
        self.assertGreater(answer["results"][0]["touched"], 0)
        samples = self.log()[0]["commands"]["stroke"]["samples"]
        self.assertEqual([sample["pressure"] for sample in samples], [0.5, 1])
        self.scene.comb(flood=True, direction=numpy.array([0, 1, 0]), lean=numpy.float32(0.5))
        with self.assertRaisesRegex(ValueError, "1 values for 2 positions"):
            pelage.stroke(positions, times=[0])

    def test_what_is_no_json_is_refused_before_it_is_sent(self):
        for value, error in ((float("nan"), ValueError), ({1, 2}, pelage.PelageError)):
            with self.subTest(value), self.assertRaises(error):
                self.scene.length(flood=True, value=value)
        self.assertEqual(self.log(), [])

    def test_dry_run_and_if_match(self):
        answer = self.scene.length(flood=True, value=0.07, dry_run=True)
        self.assertGreater(answer["results"][0]["touched"], 0)
        self.assertEqual(self.scene.info()["revision"], 0)
        with self.assertRaises(pelage.Conflict) as caught:
            self.scene.lift(flood=True, if_match=4)
        self.assertEqual(caught.exception.status, 412)
        self.assertEqual(self.scene.lift(flood=True, if_match=0)["revision"], 1)

    def test_problems_carry_their_document(self):
        with self.assertRaises(pelage.Refused) as caught:
            self.scene.run({"op": "lenght"})
        problem = caught.exception
        self.assertEqual((problem.status, problem.pointer, problem.nearest), (422, "/op", "length"))
        self.assertEqual(problem.document["detail"], problem.detail)
        self.assertIn("nearest: length", str(problem))
        with self.assertRaises(pelage.Refused) as caught:
            self.scene.noise(flood=True, amount=11)
        self.assertEqual((caught.exception.pointer, caught.exception.limit), ("/amount", "[0, 10]"))

    def test_a_batch_is_one_step(self):
        with self.scene.batch(author="Ann") as batch:
            batch.length(flood=True, value=0.05)
            batch.noise(flood=True)
        self.assertEqual([result["op"] for result in batch.answer["results"]], ["length", "noise"])
        self.assertEqual((self.scene.revision, self.log()[0]["author"]), (1, "Ann"))
        with self.scene.batch(dry_run=True) as batch:
            batch.lift(flood=True)
        self.assertEqual((batch.answer["revision"], self.scene.info()["revision"]), (1, 1))

    def test_a_batch_that_is_not_sent(self):
        with self.scene.batch() as empty:
            pass
        self.assertIsNone(empty.answer)
        with self.assertRaises(KeyError), self.scene.batch() as batch:
            batch.lift(flood=True)
            raise KeyError
        with self.assertRaisesRegex(ValueError, "belong to the batch"), self.scene.batch() as batch:
            batch.lift(flood=True, author="Ann")
        self.assertEqual(self.scene.info()["revision"], 0)

    def test_settings_go_back_as_they_came(self):
        settings = self.scene.settings()
        with self.scene.batch() as batch:
            batch.set_coat(coat={**settings["coats"][0]["coat"], "count": 123})
            batch.set_look(look=settings["look"])
            batch.set_lights(lights=settings["lights"])
            batch.set_eyes(eyes=[{"position": [0, 0, 1], "radius": 0.05}])
        self.assertEqual(self.scene.settings()["coats"][0]["coat"]["count"], 123)
        self.assertEqual(self.scene.settings()["lights"], settings["lights"])
        self.assertEqual(self.scene.settings(0)["coats"][0]["coat"], settings["coats"][0]["coat"])

    def test_history(self):
        for value in (0.04, 0.05, 0.07):
            self.scene.length(flood=True, value=value)
        self.assertEqual(self.scene.undo(2, author="Ann")["revision"], 4)
        self.assertEqual(self.scene.redo()["revision"], 5)
        self.assertEqual(self.scene.revert(1)["revision"], 6)
        self.assertEqual([entry["kind"] for entry in self.scene.log()], ["do", "do", "do", "undo", "redo", "revert"])
        self.assertEqual(self.scene.compare(1, 2)["fields"][0]["field"], "length")
        self.assertEqual([step["value"] for step in self.scene.steps()], [0.04])

    def test_amend_and_branch(self):
        self.scene.length(flood=True, value=0.05)
        self.scene.noise(flood=True)
        branch = self.scene.branch("other", revision=1)
        self.assertEqual((branch.name, branch.revision), ("other", 1))
        change = [{"op": "length", "flood": True, "value": 0.06}]
        self.assertEqual(self.scene.amend(1, change, dry_run=True)["results"][0]["op"], "length")
        self.assertEqual(self.scene.info()["revision"], 2)
        self.scene.amend(1, change)
        self.assertEqual([step["op"] for step in self.scene.steps()], ["length", "noise"])
        self.assertEqual(branch.info()["revision"], 1)

    def test_a_log_is_carried_to_another_scene(self):
        self.scene.comb(stroke=pelage.stroke([[1, 0.2, 0], [1, 0.3, 0]]), brush={"radius": 0.3})
        other = self.client.create("ball", model={"builtin": "sphere", "triangles": 300})
        own, carried = self.scene.steps()[0], self.scene.steps(carried_to=other)[0]
        self.assertNotEqual(own["stroke"], carried["stroke"])
        self.assertGreater(other.run(carried)["results"][0]["touched"], 0)


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

    def test_better_frames_go_on_to_the_last(self):
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

    def test_load_keeps_a_groom_unless_told_otherwise(self):
        (self.folder / "m.obj").write_text(TRIANGLE + "f 1 2 3\n")
        self.scene.noise(flood=True)
        before = self.scene.info()
        kept = self.scene.load(self.folder / "m.obj")["carried"]
        self.assertEqual(kept["vertices"], 3)
        self.assertEqual(self.client.open(kept["before"]).info()["fields_hash"], before["fields_hash"])
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


class Following(PackageTest):
    def test_news_in_order(self):
        self.scene.length(flood=True, value=0.05)
        news = self.scene.follow(since=0)
        self.assertEqual((next(news).data["ops"], next(news).data["undo_steps"]), (["length"], 1))
        self.client.open(self.scene.id).lift(flood=True, author="Ann")
        change = next(news)
        self.assertIsInstance(change, pelage.Change)
        self.assertEqual((change.revision, change.data["author"], self.scene.revision), (2, "Ann", 2))
        self.scene.remove()
        self.assertEqual(list(news), [pelage.Removed(2)])
        with self.assertRaises(pelage.NotFound):
            next(self.scene.follow())

    def test_it_begins_with_the_state(self):
        with contextlib.closing(self.scene.follow()) as news:
            state = next(news)
        self.assertIsInstance(state, pelage.SceneState)
        self.assertEqual(state.data["model_id"], self.scene.info()["model_id"])
