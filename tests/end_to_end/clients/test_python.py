"""The Python package: the service, scenes, commands, history and news against a real server."""

import contextlib
import threading
import unittest.mock

import numpy

from support.package import PackageTest, pelage


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

    def test_values_that_json_lacks_are_refused_before_they_are_sent(self):
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

    def test_settings_can_be_sent_back_unchanged(self):
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

    def test_a_log_is_transferred_to_another_scene(self):
        self.scene.comb(stroke=pelage.stroke([[1, 0.2, 0], [1, 0.3, 0]]), brush={"radius": 0.3})
        other = self.client.create("ball", model={"builtin": "sphere", "triangles": 300})
        own, transferred = self.scene.steps()[0], self.scene.steps(carried_to=other)[0]
        self.assertNotEqual(own["stroke"], transferred["stroke"])
        self.assertGreater(other.run(transferred)["results"][0]["touched"], 0)


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
