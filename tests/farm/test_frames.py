"""The checker of frames, movies and contact sheets, on files that are made here."""

import json
import os
import shutil
import subprocess
import unittest

from support import FarmTest, needs, png
from pelage.farm.check import faults_of
from pelage.farm.folder import FarmFolder
from pelage.farm.frame_files import FrameFile, ShortFile, inspect
from pelage.farm.plan import Plan, PlannedFrame
from pelage.farm.ranges import Chunk

FRAMES = 8


class Frames(FarmTest):
    def setUp(self):
        super().setUp()
        needs(shutil.which("ffmpeg"), "ffmpeg")
        self.made = FarmFolder(self.folder / "ball.farm")
        (self.made.path / "out").mkdir(parents=True)
        self.plan = Plan([PlannedFrame(k, str(self.path(k)), f"f{k}", 16, 8) for k in range(1, FRAMES + 1)], 12, 0.5)
        for k in range(1, FRAMES + 1):
            self.path(k).write_bytes(self.picture(k))
        (self.made.path / "job.json").write_text("{}")
        self.made.write_plan(self.plan)
        self.made.write_chunks([Chunk([1, 2, 3, 4], 0), Chunk([5, 6, 7, 8], 0)])

    def path(self, k):
        return self.made.path / "out" / f"ball.{k:04}.png"

    def picture(self, k, **more):
        return png(colour=(30 * k, 100, 100), fingerprint=f"f{k}", **more)

    def kinds(self):
        return {fault.frame: fault.kind for fault in faults_of(self.plan)}

    def test_whole_frames_have_no_faults(self):
        self.assertEqual(self.kinds(), {})
        self.assertIn("8 frames, 0 with faults", self.farm("check", self.made.path).stdout)

    def test_each_fault_is_found(self):
        self.path(1).unlink()
        self.path(2).write_bytes(self.picture(2)[:-30])
        self.path(3).write_bytes(b"")
        self.path(4).write_bytes(self.picture(4, width=15))
        self.path(5).write_bytes(png(colour=(2, 2, 2), fingerprint="f5"))
        self.path(6).write_bytes(self.picture(5))
        damaged = bytearray(self.picture(7))
        damaged[-25] ^= 255  # inside the data
        self.path(7).write_bytes(damaged)
        wanted = {1: "missing", 2: "short", 3: "short", 4: "size", 5: "black", 6: "stale", 7: "short"}
        self.assertEqual(self.kinds(), wanted)
        report = json.loads(self.farm("check", self.made.path, "--json", code=1).stdout)
        self.assertEqual({one["frame"]: one["kind"] for one in report["faults"]}, wanted)
        said = self.farm("check", self.made.path, code=1).stdout
        self.assertIn("8 frames, 7 with faults: 1-7", said)
        self.assertIn("ball.0001.png: missing", said)

    def test_a_pipe_is_no_frame(self):
        self.path(2).unlink()
        os.mkfifo(self.path(2))
        self.assertEqual(self.kinds(), {2: "short"})

    def test_how_dark_is_black(self):
        self.path(5).write_bytes(png(colour=(20, 20, 20), fingerprint="f5"))
        self.assertEqual(self.kinds(), {})
        self.farm("check", self.made.path, "--black", 0.1, code=1)

    def test_every_cut_of_a_file_is_short(self):
        whole = self.picture(1)
        file = self.folder / "cut.png"
        for length in range(len(whole)):
            file.write_bytes(whole[:length])
            with self.assertRaises(ShortFile, msg=length):
                inspect(str(file))
        file.write_bytes(whole)
        self.assertEqual(inspect(str(file)), FrameFile(16, 8, "f1"))

    def test_exr(self):
        file, cut = self.folder / "x.exr", self.folder / "cut.exr"
        subprocess.run(["ffmpeg", "-v", "error", "-i", self.path(1), "-vf", "scale=40:70", "-pix_fmt", "gbrpf32le", file], check=True)
        self.assertEqual(inspect(str(file)), FrameFile(40, 70, ""))
        whole = file.read_bytes()
        for length in range(0, len(whole), 97):
            cut.write_bytes(whole[:length])
            with self.assertRaises(ShortFile, msg=length):
                inspect(str(cut))

    def test_a_folder_that_was_moved(self):
        moved = self.folder / "elsewhere"
        self.made.path.rename(moved)
        self.assertIn("8 frames, 0 with faults", self.farm("check", moved).stdout)
        self.assertEqual(self.status(moved)["done"], FRAMES)

    def frames_in(self, file):
        shown = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames,width,height,pix_fmt,codec_name",
                                "-of", "json", file], capture_output=True, check=True)
        return json.loads(shown.stdout)["streams"][0]

    def test_clips(self):
        self.farm("movie", self.made.path, "-o", "ball.mp4")
        stream = self.frames_in(self.folder / "ball.mp4")
        self.assertEqual((stream["codec_name"], stream["pix_fmt"], stream["nb_read_frames"]), ("h264", "yuv420p", str(FRAMES)))
        self.farm("movie", "ball.farm/out/ball.####.png", "-o", "ball.gif", "--width", 32, "--fps", 6)
        stream = self.frames_in(self.folder / "ball.gif")
        self.assertEqual((stream["width"], stream["height"], stream["nb_read_frames"]), (32, 16, str(FRAMES)))
        self.farm("movie", self.made.path, "-o", "ball.webp")
        self.assertEqual((self.folder / "ball.webp").read_bytes().count(b"ANMF"), FRAMES)
        self.assertEqual(list(self.folder.glob(".part*")), [])

    def test_odd_sides(self):
        for k in range(1, FRAMES + 1):
            self.path(k).write_bytes(self.picture(k, width=15, height=7))
        self.farm("movie", self.made.path, "-o", "ball.mp4")
        stream = self.frames_in(self.folder / "ball.mp4")
        self.assertEqual((stream["width"], stream["height"]), (16, 8))

    def test_a_clip_has_all_frames_or_is_refused(self):
        self.path(3).write_bytes(self.picture(3)[:-30])
        self.path(5).unlink()
        said = self.farm("movie", self.made.path, "-o", "ball.mp4", code=1).stderr
        self.assertIn("Frames are missing: 3,5", said)
        self.assertIn("  next:", said)
        self.farm("movie", self.made.path, "-o", "ball.avi", code=1)
        self.path(3).unlink()
        self.farm("movie", "ball.farm/out/ball.####.png", "-o", "ball.mp4")  # of the frames that exist
        self.assertEqual(self.frames_in(self.folder / "ball.mp4")["nb_read_frames"], str(FRAMES - 2))
        self.assertIn("no frames", self.farm("movie", "no/x.####.png", "-o", "ball.mp4", code=3).stderr)

    def test_sheets(self):
        self.assertIn("frames 1-7x2", self.farm("sheet", self.made.path, "-o", "s.png", "--count", 4, "--columns", 3, "--width", 40).stdout)
        stream = self.frames_in(self.folder / "s.png")
        self.assertEqual((stream["width"], stream["height"]), (3 * 40 + 2 * 2, 2 * 20 + 2))
        self.path(5).unlink()
        self.assertIn("missing: 5", self.farm("sheet", self.made.path, "-o", "s.jpg").stdout)

    def test_status_counts_what_is_on_disk(self):
        status = self.status(self.made.path)
        self.assertEqual((status["done"], status["failed"]), (FRAMES, 0))
        self.path(2).write_bytes(self.picture(2)[:-30])
        self.path(6).write_bytes(self.picture(5))  # of another frame
        self.assertEqual(self.status(self.made.path)["done"], FRAMES - 2)


if __name__ == "__main__":
    unittest.main()
