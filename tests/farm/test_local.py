"""`pelage farm submit --engine local` with the real pelage-render: what is submitted again, and what is refused."""

import os
import pathlib
import signal
import subprocess
import time
import unittest

from support import BIN, FarmTest, nightly
import pelage


class Local(FarmTest):
    def submit(self, job, *words, **more):
        return self.farm("submit", job, "--engine", "local", "--max-parallel", 2, *words, **more).stdout

    def files(self):
        return sorted((self.folder / "ball.farm" / "out").iterdir())

    def test_frames_are_drawn_once_and_what_is_missing_again(self):
        job = self.write_job(frames="1-6")
        said = self.submit(job)
        self.assertIn("6 frames, about ", said)
        self.assertIn("6 of 6 frames, 0 tasks running, 0 frames failed", said)
        folder, files = self.folder / "ball.farm", self.files()
        self.assertEqual([file.name for file in files], [f"ball.{k:04}.png" for k in range(1, 7)])
        self.assertIn("All 6 frames are there", self.submit(job))
        before = {file: file.stat().st_ino for file in files}
        files[5].unlink()
        files[3].write_bytes(files[3].read_bytes()[:200])
        (folder / "out" / ".ball.0006.png.99.tmp").write_text("of a task that was killed")
        said = self.submit(folder)
        self.assertIn("1 of 2 chunks to draw, 2 of 6 frames", said)
        self.assertEqual(self.files(), files)
        changed = [number for number, file in enumerate(files) if file.stat().st_ino != before[file] and number != 5]
        self.assertEqual(changed, [3])
        self.assertIn("6 frames, 0 with faults", self.farm("check", folder).stdout)

    def test_tiles(self):
        job = self.write_job(frames="1-3", tiles={"columns": 2, "rows": 1})
        said = self.submit(job)
        self.assertIn("3 frames in 2 tiles, about ", said)
        self.assertIn("2 chunks of up to 3 tiles", said)
        self.assertIn("6 of 6 tiles, 0 tasks running, 0 tiles failed", said)
        self.assertEqual([file.name for file in self.files()], [f"ball.{k:04}.png" for k in range(1, 4)])
        self.assertIn("3 frames, 0 with faults", self.farm("check", job.with_suffix(".farm")).stdout)
        self.files()[1].unlink()
        self.assertIn("2 of 2 chunks to draw, 2 of 6 tiles", self.submit(job))
        self.assertEqual(len(self.files()), 3)

    def test_tiles_that_nobody_put_together_are_sent_again(self):
        job = self.write_job(frames="1", tiles={"columns": 2, "rows": 1})
        self.submit(job)
        folder = self.folder / "ball.farm"
        (frame,) = self.files()
        whole, tiles = frame.read_bytes(), {}
        frame.unlink()
        for number in ("1", "2"):  # as by processes that were killed before they could merge the tiles
            subprocess.run([BIN / "pelage-render", folder / "job.json", "--tile", number], check=True, stdout=subprocess.DEVNULL)
            (tile,) = self.files()
            tiles[tile] = tile.read_bytes()
            tile.unlink()
        for tile, content in tiles.items():
            tile.write_bytes(content)
        self.assertIn("2 of 2 tiles", self.submit(folder))
        self.assertEqual([file.read_bytes() for file in self.files()], [whole])

    def test_a_changed_job_is_drawn_anew(self):
        self.submit(self.write_job(frames="1-4"))
        said = self.submit(self.write_job(frames="1-4", frame={"width": 64, "height": 40, "quality": "draft"}))
        self.assertIn("4 frames, about", said, "it is measured again")
        self.assertIn("2 of 2 chunks to draw, 4 of 4 frames", said)
        self.farm("check", self.folder / "ball.farm")
        self.assertIn("2 of 2 frames", self.submit(self.write_job(frames="1-2")))
        self.assertEqual(len(self.files()), 4, "frames that this job does not have stay")
        self.farm("check", self.folder / "ball.farm")

    def test_a_frame_that_fails(self):
        job = self.write_job(frames="1-4")
        folder = self.folder / "ball.farm"
        self.farm("submit", job, "--engine", "slurm", "--dry-run", "--max-parallel", 2)
        (folder / "out" / "ball.0001.png").mkdir(parents=True)  # so that no file can be written there
        said = self.submit(folder, code=1)
        self.assertRegex(said, r"frames failed\n +0  failed   1-2 +\S.*ball.0001.png")
        (folder / "out" / "ball.0001.png").rmdir()
        self.submit(folder)

    def test_an_interrupt_ends_the_tasks(self):
        job = self.write_job(frames="1-400", frame={"width": 256, "height": 256})
        command = [str(BIN / "pelage"), "farm", "submit", str(job), "--engine", "local"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder) as process:
            out = self.folder / "ball.farm" / "out"
            deadline = time.monotonic() + 60
            while not (out.is_dir() and any(out.glob("*.png"))) and time.monotonic() < deadline:
                time.sleep(0.05)
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertEqual(renderers_in(self.folder), [])
        for log in (self.folder / "ball.farm" / "logs").iterdir():
            self.assertIn("stopped", log.read_text(), "it had the time to end")
        self.assertLess(0, len(list(out.glob("*.png"))))
        self.assertEqual(list(out.glob(".*.tmp")), [])

    def test_two_do_not_draw_the_same_frames(self):
        job = self.write_job(frames="1-400", frame={"width": 256, "height": 256})
        folder = self.folder / "ball.farm"
        with subprocess.Popen([str(BIN / "pelage"), "farm", "submit", str(job), "--engine", "local"], stdout=subprocess.DEVNULL) as process:
            while not list((folder / "logs").glob("*.log")) and process.poll() is None:
                time.sleep(0.05)
            self.assertIn("Another `pelage farm submit`", self.farm("submit", folder, code=1).stderr)
            status = self.status(folder)
            self.assertEqual((status["failed"], status["chunks"][0]["state"]), (0, "running"))
            process.terminate()
        self.assertGreater(self.status(folder, code=1)["failed"], 0)

    def test_refusals(self):
        job = self.write_job(frames="5-1")
        said = self.farm("submit", job, code=3).stderr
        self.assertIn("5-1", said)
        self.assertIn("  next:", said)
        self.assertIn("cannot be read", self.farm("submit", "none.json", code=3).stderr)
        self.assertIn("scene cannot be read", self.farm("submit", self.write_job(builtin=None, scene="none.pelage"), code=3).stderr)
        self.assertIn("no folder of a farm job", self.farm("status", self.folder, code=3).stderr)
        self.farm("submit", job, "--engine", "lsf", code=2)

    def test_the_files_that_a_job_moves_by_are_copied(self):
        for number, height in (("", 1), (".01", 1), (".02", 2)):
            text = f"v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 {height} 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n"
            (self.folder / f"tetra{number}.obj").write_text(text)
        job = self.write_job(frames="1-2", builtin=None, scene="tetra.obj", motion={"model": "tetra.##.obj"})
        self.assertIn("2 of 2 frames", self.submit(job))
        models = self.folder / "ball.farm" / "models"
        self.assertEqual(sorted(path.name for path in models.iterdir()), ["tetra.01.obj", "tetra.02.obj"])
        for path in self.folder.glob("tetra.*.obj"):
            path.unlink()
        self.assertIn("there is none", self.farm("submit", job, code=3).stderr)

    def test_pack(self):
        recipe = self.folder / "groom.json"
        recipe.write_text('{"variables": {"fur": 0.02}, "steps": [{"op": "length", "flood": true, "value": "${fur}"}]}')
        self.farm("pack", "--builtin", "sphere", "--triangles", 500, "--recipe", recipe, "--set", "fur=0.05", "-o", "ball.pelage")
        job = self.write_job(frames="1-2", builtin=None, scene="ball.pelage")
        self.assertIn("2 of 2 frames", self.submit(job))
        self.assertIn("from a server or from a model", self.farm("pack", "-o", "x.pelage", code=2).stderr)
        self.assertIn("groom.jsn", self.farm("pack", "--builtin", "sphere", "--recipe", "groom.jsn", "-o", "x.pelage", code=3).stderr)

    def test_pack_a_scene_of_a_server(self):
        with pelage.local(BIN / "pelaged") as server:
            server.create("ball", model={"builtin": "sphere", "triangles": 500})
            self.assertIn("ball.pelage, ", self.farm("pack", "ball", "-o", "ball.pelage", "--server", server.address).stdout)
            self.assertIn("no scene", self.farm("pack", "bal", "-o", "x.pelage", "--server", server.address, code=3).stderr)
        self.assertIn("1 of 1 frames", self.submit(self.write_job(frames="1", builtin=None, scene="ball.pelage")))

    def test_a_scene_of_a_server_is_fetched_as_it_is_then(self):
        with pelage.local(BIN / "pelaged") as server:
            scene = server.create("ball", model={"builtin": "sphere", "triangles": 500})
            job = self.write_job(frames="1-2", builtin=None, scene=f"{server.address}/ball")
            self.assertIn("2 of 2 frames", self.submit(job))
            self.assertIn("All 2 frames are there", self.submit(job))
            scene.length(flood=True, value=0.2)
            self.assertIn("2 of 2 chunks to draw", self.submit(job))
            said = self.farm("submit", self.write_job(builtin=None, scene=f"{server.address}/bal"), code=3).stderr
            self.assertIn("no scene", said)
        self.assertIn("names no scene", self.farm("submit", self.write_job(builtin=None, scene="http://localhost/"), code=3).stderr)
        self.assertTrue((self.folder / "ball.farm" / "ball.pelage").exists())
        renderer = subprocess.run([BIN / "pelage-render", self.write_job(builtin=None, scene="http://localhost/x")], capture_output=True, text=True)
        self.assertEqual(renderer.returncode, 3)
        self.assertIn("pelage farm submit", renderer.stderr)

    def test_exr(self):
        job = self.write_job(frames="1-2", output="out/ball.#.exr")
        self.submit(job)
        folder = self.folder / "ball.farm"
        self.farm("check", folder)
        file = folder / "out" / "ball.2.exr"
        file.write_bytes((folder / "out" / "ball.1.exr").read_bytes())
        self.assertIn("ball.2.exr: stale", self.farm("check", folder, code=1).stdout)
        self.assertIn("1 of 2 chunks to draw, 1 of 2 frames", self.submit(folder))
        self.farm("movie", folder, "-o", "ball.mp4")
        self.assertIn("frames 1-2", self.farm("sheet", folder, "-o", "ball.png").stdout)

    @nightly
    def test_a_bar_on_a_terminal(self):
        job = self.write_job(frames="1-40")
        done = subprocess.run(["script", "-qec", f"{BIN}/pelage farm submit {job} --engine local", "/dev/null"], capture_output=True,
                              text=True, timeout=120, stdin=subprocess.DEVNULL)
        self.assertRegex(done.stdout, r"\[#*\.*\] +\d+%, \d+ of 40 frames")


def renderers_in(folder):
    """Processes of pelage-render that work in the folder."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if b"pelage-render" in (process / "cmdline").read_bytes() and os.readlink(process / "cwd").startswith(str(folder)):
                found.append(process.name)
        except OSError:
            pass
    return found


if __name__ == "__main__":
    unittest.main()
