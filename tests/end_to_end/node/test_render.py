"""pelage-render: jobs to files, as a farm runs it."""
import json
import os
import signal
import subprocess
import sys
import unittest

from PIL import Image

from support.nightly import nightly
from support.jobs import JOB, JobTest
from support.png import chunks_of, texts_of
from support.server import BIN, REPOSITORY, THIN_COAT, ServedTest, flood

sys.path.insert(0, str(REPOSITORY / "clients" / "python"))
from pelage.farm.exr import read_header  # noqa: E402


class RenderTest(JobTest):
    def test_frames_are_drawn_and_reported_as_farms_expect(self):
        run = self.render(self.job())
        names = [f"ball.{k:03}.png" for k in range(1, 7)]
        self.assertEqual([path.name for path in self.frames()], names)
        lines = run.stdout.splitlines()
        self.assertEqual([line for line in lines if line.startswith("Saved: ")],
                         [f"Saved: '{self.folder}/out/{name}'" for name in names])
        shares = [float(line.split()[1]) for line in lines if line.startswith("openjd_progress: ")]
        self.assertEqual(shares, sorted(shares))
        self.assertEqual((shares[0], shares[-1]), (0, 100))
        self.assertRegex(lines[-1], r"pelage-render: done, 6 drawn, 0 skipped, [0-9.]+ s")
        texts = texts_of(self.frames()[2])
        self.assertEqual(texts["pelage/frame"], "3")
        self.assertEqual(texts["pelage/revision"], "1")  # after the job's command
        self.assertRegex(texts["pelage/fingerprint"], "^[0-9a-f]{32}$")
        self.assertEqual(json.loads(texts["pelage/request"])["width"], 48)
        self.assertEqual(len({digest for digest in self.hashes().values()}), 6)  # it turns

    def test_parts_on_any_number_of_threads_give_the_same_bytes(self):
        job = self.job(frames="1-4")
        self.render(job)
        whole = self.hashes()
        subprocess.run(["rm", "-r", self.folder / "out"], check=True)
        self.render(job, "--frames", "3-4", "--threads", 1)
        self.render(job, "--frames", "2,1", "--threads", 2)
        self.assertEqual(self.hashes(), whole)

    def test_tiles_become_the_file_of_the_whole(self):
        """All kinds of frames: shells of a scale of their own, traced and filtered strands, 16 bits, transparent ones."""
        ground = {"op": "set_ground", "ground": {"visible": True}}
        frames = {
            "detailed": {"quality": "detailed"}, "draft": {"quality": "draft", "background": "studio", "format": "png16"},
            "traced": {"quality": {"method": "strands", "trace": {"passes": 3, "noise": 0.01}}, "background": "transparent"},
        }
        for name, frame in frames.items():
            with self.subTest(name):
                job = {"frames": "2", "commands": [ground], "frame": {"width": 70, "height": 50, **frame}}
                self.render(self.job(output=f"{name}/#.png", **job))
                self.render(self.job(output="out/#.png", tiles={"columns": 3, "rows": 2}, **job))
                self.assertEqual([path.name for path in self.frames()], ["2.png"])
                for path in self.frames():
                    self.assertEqual(path.read_bytes(), (self.folder / name / path.name).read_bytes(), path)

    def test_tiles_of_an_exr(self):
        def pixels(path):
            with open(path, "rb") as file:
                return path.read_bytes()[min(read_header(file).offsets):]

        frame = {"width": 70, "height": 50, "aovs": ["beauty", "depth", "normal"]}
        self.render(self.job(output="whole/#.exr", frames="3", frame=frame))
        self.render(self.job(output="out/#.exr", frames="3", frame=frame, tiles={"columns": 2, "rows": 2}), "--tile", 1)
        self.assertEqual([path.name for path in self.frames()], ["3.tile1.exr"])
        self.render(self.folder / "job.json")
        self.assertEqual([path.name for path in self.frames()], ["3.exr"])
        whole, merged = self.folder / "whole" / "3.exr", self.frames()[0]
        self.assertEqual(pixels(merged), pixels(whole))

    def test_tiles_are_drawn_by_any_number_of_processes_at_a_time(self):
        job = self.job(frames="1-2", tiles={"columns": 2, "rows": 2}, frame={"width": 64, "height": 64, "quality": "draft"})
        runs = [subprocess.Popen([BIN / "pelage-render", job, "--tile", str(tile), "--threads", "1"], stdout=subprocess.PIPE, text=True)
                for tile in (1, 2, 3, 4)]
        said = "".join(run.communicate(timeout=120)[0] for run in runs)
        self.assertEqual([run.returncode for run in runs], [0] * 4, said)
        names = [f"ball.{k:03}.png" for k in range(1, 3)]
        self.assertEqual([path.name for path in self.frames()], names)
        for name in names:
            self.assertGreaterEqual(said.count(f"/{name}'"), 1)
        whole = self.hashes()
        self.render(self.job(frames="1-2", frame={"width": 64, "height": 64, "quality": "draft"}))
        self.assertEqual(self.hashes(), whole)

    def test_only_tiles_that_are_missing_are_drawn_again(self):
        job = self.job(frames="1-2", tiles={"columns": 2, "rows": 1})
        self.render(job, "--tile", 2)
        run = self.render(job, "--skip-existing")
        self.assertEqual((run.stdout.count("Skipped:"), run.stdout.count("Saved:")), (2, 4), run.stdout)  # 2 tiles, 2 frames
        leftover = self.folder / "out" / "ball.001.tile2.png"
        leftover.write_bytes(b"of a process that was killed")
        run = self.render(job, "--skip-existing")
        self.assertEqual((run.stdout.count("Skipped:"), run.stdout.count("Saved:")), (4, 0), run.stdout)
        self.assertFalse(leftover.exists())
        self.frames()[0].unlink()
        self.render(job, "--tile", 1)
        (self.folder / "out" / "ball.001.tile2.png").write_bytes(self.frames()[1].read_bytes())  # is no such tile
        self.render(job, "--tile", 1, "--skip-existing")
        self.assertIn("ball.001.tile1.png", [path.name for path in self.frames()])
        self.render(job, "--skip-existing")
        self.assertEqual([path.name for path in self.frames()], ["ball.001.png", "ball.002.png"])

    def test_tiles_that_would_not_fit_together_are_refused(self):
        tiles = {"columns": 2, "rows": 2}
        for more, pointer in (({"frame": {"budget_ms": 50}}, "/frame/budget_ms"),
                              ({"frame": {"crop": {"width": 8, "height": 8}}}, "/frame/crop"),
                              ({"frame": {"quality": {"method": "strands", "trace": {"seconds": 1}}}}, "/frame/quality/trace/seconds"),
                              ({"frame": {"width": 1}}, "/tiles"), ({"tiles": {"columns": 17}}, "/tiles/columns")):
            self.assertIn(pointer, self.render(self.job(**{"tiles": tiles, **more}), code=3).stderr)
        self.assertIn("[1, 4]", self.render(self.job(tiles=tiles), "--tile", 5, code=3).stderr)
        self.assertIn("a job with tiles", self.render(self.job(), "--tile", 1, code=3).stderr)

    def test_a_crop_is_the_part_of_the_whole(self):
        frame = {"width": 70, "height": 50, "quality": "draft"}
        self.render(self.job(output="whole/#.png", frames="3", frame=frame))
        self.render(self.job(frames="3", frame={**frame, "crop": {"left": 20, "top": 10, "width": 31, "height": 25}}))
        whole, part = (Image.open(path) for path in (self.folder / "whole" / "3.png", self.frames()[0]))
        self.assertEqual(part.size, (31, 25))
        self.assertEqual(part.tobytes(), whole.crop((20, 10, 51, 35)).tobytes())
        plan = json.loads(self.render(self.folder / "job.json", "--check").stdout)
        self.assertEqual((plan["frames"][0]["width"], plan["frames"][0]["height"]), (31, 25))

    def test_only_what_is_missing_or_stale_is_drawn_again(self):
        self.render(self.job(frames="1-4"))
        before = self.hashes()
        self.frames()[1].unlink()
        short = self.frames()[2]  # frame 4
        short.write_bytes(short.read_bytes()[:-20])
        run = self.render(self.job(frames="1-4"), "--skip-existing")
        self.assertEqual(run.stdout.count("Saved:"), 2, run.stdout)
        self.assertEqual(run.stdout.count("Skipped:"), 2)
        self.assertEqual(self.hashes(), before)
        run = self.render(self.job(frames="1-4", frame={**JOB["frame"], "exposure": 1}), "--skip-existing")
        self.assertEqual(run.stdout.count("Saved:"), 4)

    def test_check_draws_nothing_and_says_what_would_be_drawn(self):
        plan = json.loads(self.render(self.job(), "--check", "--measure", 2, "--frames", "2-3").stdout)
        self.assertEqual([frame["frame"] for frame in plan["frames"]], [2, 3])
        self.assertGreater(plan["seconds_per_frame"], 0)
        self.assertFalse((self.folder / "out").exists())
        self.render(self.job())
        self.assertEqual(texts_of(self.frames()[1])["pelage/fingerprint"], plan["frames"][0]["fingerprint"])

    def test_an_exr_says_where_it_comes_from(self):
        self.render(self.job(output="out/#.exr", frames="7", frame={"width": 32, "height": 32, "aovs": ["beauty", "depth"]}))
        header = self.frames()[0].read_bytes()[:8192]
        self.assertIn(b"framesPerSecond\0rational\0\x08\0\0\0\x18\0\0\0\x01\0\0\0", header)  # 24 / 1
        self.assertRegex(header, rb"capDate\0string\0\x13\0\0\0\d{4}:\d\d:\d\d \d\d:\d\d:\d\d")
        for name in (b"HostComputer", b"Software", b"pelage/renderTime", b"pelage/fingerprint", b"pelage/quality", b"pelage/camera"):
            self.assertIn(name + b"\0string\0", header)

    def test_what_is_wrong_is_refused_before_any_work(self):
        for more, pointer in (({"frames": "5-1"}, "/frames"), ({"output": "fox.png"}, "/output"), ({"fsp": 3}, "/fsp"),
                              ({"frame": {"width": 9000}}, "/frame/width"),
                              ({"keyframes": [{"parameter": "/lihgts/0", "keys": [{"frame": 1, "value": 1}]}]},
                               "/keyframes/0/parameter"),
                              ({"keyframes": [{"parameter": "/frame/exposure", "keys": [{"frame": 1, "value": 1},
                                                                                     {"frame": 6, "value": 99}]}]},
                               "/frame/exposure")):
            run = self.render(self.job(**more), code=3)
            self.assertIn(pointer, run.stderr)
            self.assertIn("openjd_fail: ", run.stdout)
            self.assertFalse((self.folder / "out").exists(), more)
        self.render(self.folder / "none.json", code=3)
        self.render("--frobnicate", code=2)
        self.render(code=2)
        self.render(self.job(), "--frames", "7", code=3)

    def test_jobs_that_come_with_the_program_are_right(self):
        jobs = sorted((REPOSITORY / "clients" / "jobs").glob("*.json"))
        self.assertTrue(jobs)
        for job in jobs:
            self.assertTrue(json.loads(self.render(job, "--check").stdout)["frames"], job)

    def test_a_device_that_is_not_there_is_refused(self):
        run = self.render(self.job(frames="1"), "--device", 31, code=4)
        self.assertIn("none of number 31", run.stderr)
        self.render(self.job(frames="1"), "--device", 0)  # the software device, where there is no GPU
        self.assertEqual(len(self.frames()), 1)

    def test_an_output_that_cannot_be_written_says_so(self):
        (self.folder / "out").write_text("a file, no folder")
        run = self.render(self.job(), code=1)
        self.assertIn("cannot be written", run.stderr)

    def test_a_stopped_task_leaves_complete_frames_and_resumes_later(self):
        job = self.job(frames="1-400")
        process = subprocess.Popen([BIN / "pelage-render", job], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while "Saved:" not in process.stdout.readline():
            pass
        process.send_signal(signal.SIGTERM)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143)
        self.check_whole(400)

    def kill(self, job, times=10):
        """Some processes that draw it, one after another. PELAGE_KILLS says how many, `times` unless it does."""
        for k in range(int(os.environ.get("PELAGE_KILLS", times))):
            process = subprocess.Popen([BIN / "pelage-render", job, "--skip-existing"], stdout=subprocess.PIPE, text=True)
            for _ in range(3 + 3 * k % 20):
                process.stdout.readline()
            process.kill()
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, -9)

    @nightly
    def test_no_frame_is_torn_by_kills(self):
        self.kill(self.job(frames="1-2000"))
        self.check_whole(2000)

    def test_no_tile_is_lost_by_kills(self):
        self.check_no_tile_is_lost(kills=3, frames=3)

    @nightly
    def test_no_tile_is_lost_by_many_kills(self):
        self.check_no_tile_is_lost(kills=10, frames=12)

    def check_no_tile_is_lost(self, kills, frames):
        self.kill(self.job(frames="1-2000", tiles={"columns": 2, "rows": 2}), kills)
        self.check_whole(10_000)
        self.render(self.folder / "job.json", "--frames", f"1-{frames}", "--skip-existing")
        names = [f"ball.{k:03}.png" for k in range(1, frames + 1)]
        self.assertEqual([path.name for path in self.frames() if path.name in names], names)
        merged = {name: digest for name, digest in self.hashes().items() if name in names}
        subprocess.run(["rm", "-r", self.folder / "out"], check=True)
        self.render(self.job(frames="1-2000"), "--frames", f"1-{frames}")
        self.assertEqual(self.hashes(), merged)

    def check_whole(self, below):
        whole = [path for path in self.frames() if not path.name.startswith(".")]
        self.assertTrue(0 < len(whole) < below, len(whole))
        for path in whole:
            chunks_of(path)

    def test_the_schema_is_one(self):
        schema = json.loads(self.render("--schema").stdout)
        import jsonschema
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        self.assertTrue(validator.is_valid(JOB))
        self.assertFalse(validator.is_valid({**JOB, "fsp": 24}))
        self.assertFalse(validator.is_valid({**JOB, "frame": {"width": 0}}))


class SavedSceneTest(ServedTest):
    def test_a_saved_groom_is_drawn_as_the_server_draws_it(self):
        scene = self.server.new_scene("sphere", 800)
        self.assertEqual(self.server.post(f"/v1/scenes/{scene.id}/commands", {"commands": [THIN_COAT, flood([0, 0, 1])]}).status, 200)
        folder = self.server.folder
        self.pelage("export", scene.id, "-o", folder / "ball.pelage")
        frame = {"width": 64, "height": 64, "camera": {"auto": "left"}, "quality": "interactive"}
        (folder / "job.json").write_text(json.dumps({"scene": "ball.pelage", "output": "ball.png", "frame": frame}))
        run = subprocess.run([BIN / "pelage-render", folder / "job.json"], capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 0, run)
        served = folder / "served.png"
        served.write_bytes(self.server.post(f"/v1/scenes/{scene.id}/frames", frame).body)
        pixels = [[body for name, body in chunks_of(path) if name == b"IDAT"] for path in (folder / "ball.png", served)]
        self.assertEqual(*pixels)
        self.assertEqual(texts_of(folder / "ball.png")["pelage/revision"], "1")


if __name__ == "__main__":
    unittest.main()
