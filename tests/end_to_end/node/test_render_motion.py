"""pelage-render: fur and models that move from frame to frame, and motion blur."""

import json
import subprocess
import unittest

from PIL import Image

from support.jobs import JOB, JobTest
from support.png import chunks_of
from support.server import BIN, THIN_COAT, shared_folder


class RenderMotionTest(JobTest):
    def pixels(self):
        return {path.name: b"".join(body for name, body in chunks_of(path) if name == b"IDAT") for path in self.frames()}

    def test_a_blurred_frame_is_the_mean_of_its_moments_in_light(self):
        """Against frames of a job that goes four times as fast: those at the two moments."""
        def keys(pace):
            return [{"parameter": "/frame/camera/position", "keys": [{"frame": 0, "value": [-2, 0.3, 2.4]},
                                                                     {"frame": 16 * pace, "value": [2, 0.3, 2.4]}]},
                    {"parameter": "/lights/0/intensity", "keys": [{"frame": 0, "value": 0}, {"frame": 16 * pace, "value": 8}]}]

        frame = {"width": 48, "height": 40, "quality": "detailed", "aovs": ["beauty", "depth"], "exr_type": "float"}
        camera = {"camera": {"position": [0, 0, 1], "target": [0, 0, 0]}}
        wind = {"op": "set_wind", "wind": {"speed": 0.6}}
        job = {"output": "out/#.exr", "turntable": None, "commands": [THIN_COAT, wind], "frame": {**frame, **camera}}
        job = {name: value for name, value in {**JOB, **job}.items() if value is not None}

        def drawn(name, **more):
            path = self.folder / f"{name}.json"
            path.write_text(json.dumps({**job, "output": f"{name}/#.exr", **more}))
            self.render(path)

        drawn("blurred", frames="8", keyframes=keys(1), motion_blur={"shutter": 1, "samples": 2})
        drawn("sharp", frames="31,33", fps=96, keyframes=keys(4))

        def differ(one, other):
            run = subprocess.run(["oiiotool", "-fail", "1e-5", "-failpercent", "0", self.folder / one, self.folder / other,
                                  "--diff"], capture_output=True, text=True)
            return run.returncode != 0

        sharp = [self.folder / "sharp" / f"{number}.exr" for number in (31, 33)]
        subprocess.run(["oiiotool", *sharp, "--add", "--mulc", "0.5", "--ch", "R,G,B,A", "-o", self.folder / "mean.exr"], check=True)
        subprocess.run(["oiiotool", sharp[1], "--ch", "Z", "-o", self.folder / "depth.exr"], check=True)
        for channels, whole in (("R,G,B,A", "mean.exr"), ("Z", "depth.exr")):
            subprocess.run(["oiiotool", self.folder / "blurred" / "8.exr", "--ch", channels, "-o", self.folder / "part.exr"], check=True)
            self.assertFalse(differ("part.exr", whole), whole)
        self.assertTrue(differ("mean.exr", "sharp/31.exr"))

    def test_a_scene_at_rest_is_as_sharp_with_motion_blur(self):
        for quality in ("draft", "detailed"):
            frame = {"frame": {"width": 70, "height": 50, "quality": quality}, "turntable": {"degrees": 0}, "frames": "3"}
            self.render(self.job(output="sharp/#.png", **frame))
            self.render(self.job(output="blurred/#.png", motion_blur={"samples": 3}, **frame))
            one, other = (Image.open(self.folder / name / "3.png").tobytes() for name in ("sharp", "blurred"))
            self.assertLessEqual(max(abs(a - b) for a, b in zip(one, other, strict=True)), 1, quality)

    def test_blurred_tiles_become_the_file_of_the_whole(self):
        for quality in ("detailed", {"method": "strands", "trace": {"passes": 2, "strands": 2000}}):
            job = {"frames": "2", "motion_blur": {"samples": 2}, "frame": {"width": 70, "height": 50, "quality": quality}}
            self.render(self.job(output="whole/#.png", **job))
            self.render(self.job(output="out/#.png", tiles={"columns": 2, "rows": 2}, **job))
            self.assertEqual(self.frames()[0].read_bytes(), (self.folder / "whole" / "2.png").read_bytes())

    def test_the_wind_moves_the_fur_from_frame_to_frame(self):
        wind = {"op": "set_wind", "wind": {"speed": 1, "gusts": 1}}
        still = {"turntable": {"degrees": 0, "turns": "camera"}, "frames": "1-4", "fps": 2}
        self.render(self.job(**still))
        self.assertEqual(len({b"".join(body for name, body in chunks_of(path) if name == b"IDAT") for path in self.frames()}), 1)
        self.render(self.job(**still, commands=[wind]))
        moved = self.hashes()
        self.assertEqual(len(set(moved.values())), 4)
        self.render(self.job(**still, commands=[wind]), "--frames", "4,2")  # whatever was drawn before
        self.assertEqual(self.hashes(), moved)
        grow = [{"parameter": "/wind/speed", "keys": [{"frame": 1, "value": 0}, {"frame": 4, "value": 2}]}]
        self.render(self.job(**still, commands=[wind], keyframes=grow))
        self.assertNotEqual(self.hashes()["ball.004.png"], moved["ball.004.png"])

    def test_a_model_moves_by_numbered_files_with_its_groom(self):
        for number, stretch in (("", 0), (".01", 0), (".02", 0.1), (".03", 0.2)):
            self.write_ball(f"ball{number}.obj", stretch)
        comb = [{"op": "comb", "flood": True, "direction": [1, 0, 0], "lean": 0.8}]
        self.render(self.moving(commands=comb))
        still = self.pixels()
        self.assertEqual(len(set(still.values())), 1)
        self.render(self.moving(commands=comb, motion={"model": "ball.##.obj"}))
        moved = self.pixels()
        self.assertEqual(moved["ball.001.png"], still["ball.001.png"])
        self.assertEqual(len(set(moved.values())), 3)
        hashes = self.hashes()
        self.render(self.moving(commands=comb, motion={"model": "ball.##.obj"}), "--frames", "3,2", "--threads", 1)
        self.assertEqual(self.hashes(), hashes)  # whatever was drawn before
        self.write_ball("ball.02.obj", 0.15)
        run = self.render(self.moving(commands=comb, motion={"model": "ball.##.obj"}), "--skip-existing")
        self.assertEqual(run.stdout.count("Saved:"), 1, run.stdout)  # that file's frame alone

    def test_a_blurred_model_is_interpolated_between_numbered_files(self):
        """Against frames of files that stand where the model is at the two moments."""
        for number, stretch in (("", 0), (".01", 0), (".02", 0.1), (".03", 0.2), (".17", 0.075), (".19", 0.125)):
            self.write_ball(f"ball{number}.obj", stretch)
        dense = {"op": "set_coat", "coat": {}}  # single strands are blurred at positions of their own
        motion = {"motion": {"model": "ball.##.obj"}, "frame": {**JOB["frame"], "format": "exr"}, "commands": [dense]}
        self.render(self.moving(**motion, frames="17,19", output="sharp/##.exr"))
        self.render(self.moving(**motion, frames="2", output="out/##.exr", motion_blur={"shutter": 1, "samples": 2}))
        mean = self.folder / "mean.exr"
        sharp = [self.folder / "sharp" / f"{number}.exr" for number in (17, 19)]
        subprocess.run(["oiiotool", *sharp, "--add", "--mulc", "0.5", "-o", mean], check=True)

        def error(one, other):
            run = subprocess.run([BIN / "pelage", "--json", "compare", one, other], capture_output=True, text=True, check=True)
            return json.loads(run.stdout)["flip"]["mean"]

        self.assertLess(error(mean, self.frames()[0]), 0.1 * error(mean, sharp[0]))

    def test_fur_swings_by_the_motion_of_the_body(self):
        for frame in range(-2, 5):  # it starts with a jerk at frame 1
            self.write_ball(f"ball.{'-' if frame < 0 else ''}{abs(frame):02}.obj", 0.1 * max(0, frame))
        self.write_ball("ball.obj")
        motion = {"model": "ball.##.obj"}
        self.render(self.moving(motion=motion))
        stiff = self.pixels()
        self.render(self.moving(motion={**motion, "inertia": 1}))
        swung = self.pixels()
        self.assertTrue(all(swung[name] != stiff[name] for name in list(swung)[1:]), "the jerk is felt afterwards")
        hashes = self.hashes()
        self.render(self.moving(motion={**motion, "inertia": 1}), "--frames", "3", "--threads", 1)  # whatever was drawn before
        self.assertEqual(self.hashes(), hashes)
        self.write_ball("ball.-01.obj", 0.01)  # which all of them follow from
        run = self.render(self.moving(motion={**motion, "inertia": 1}), "--skip-existing")
        self.assertEqual(run.stdout.count("Saved:"), 3, run.stdout)

    def test_a_model_that_is_another_is_refused_by_its_file(self):
        self.write_ball("ball.obj"), self.write_ball("ball.01.obj"), self.write_ball("ball.02.obj", sides=14)
        run = self.render(self.moving(motion={"model": "ball.##.obj"}, frames="1-2"), code=3)
        self.assertIn("ball.02.obj: It is not the scene's model in another pose: it has 112 vertices", run.stderr)
        self.assertEqual(len(self.frames()), 1)
        run = self.render(self.moving(motion={"model": "ball.##.obj"}, frames="1-3"), "--check", code=3)
        self.assertIn("ball.03.obj cannot be read", run.stderr)

    def test_an_animation_of_a_file_moves_its_model(self):
        fox = shared_folder() / "meshes" / "Fox.glb"
        motion = {"model": str(fox), "animation": "Walk", "loop_seconds": 0.5}
        self.render(self.moving(scene=str(fox), frames="0,1,3", fps=6, options={"format": "glb", "pose": "Walk@0"}, motion=motion))
        walked = self.pixels()
        self.assertNotEqual(walked["ball.001.png"], walked["ball.000.png"])
        self.assertEqual(walked["ball.003.png"], walked["ball.000.png"])


if __name__ == "__main__":
    unittest.main()
