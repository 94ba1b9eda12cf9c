"""pelage-render --check: what a task would refuse is refused before any is sent, and the file that is wrong is named."""

import base64
import json
import os
import struct
import unittest

from support.jobs import JOB, JobTest


class RenderCheckTest(JobTest):
    def write_balls(self, *stretches):
        self.write_ball("ball.obj")
        for number, stretch in enumerate(stretches, 1):
            self.write_ball(f"ball.{number:02}.obj", stretch)

    def write_animated(self, name, animation="Walk", buffer=None):
        """A triangle as a glTF that an animation moves; its bytes are in it, or in the file `buffer`."""
        data = struct.pack("<9f3H2x", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2) + struct.pack("<2f6f", 0, 1, 0, 0, 0, 0, 0.5, 0)
        address = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
        if buffer:
            (self.folder / buffer).write_bytes(data)
            address = buffer
        views = ((0, 36), (36, 6), (44, 8), (52, 24))
        kinds = ((5126, 3, "VEC3"), (5123, 3, "SCALAR"), (5126, 2, "SCALAR"), (5126, 2, "VEC3"))
        accessors = [{"bufferView": k, "componentType": kind, "count": count, "type": shape} for k, (kind, count, shape) in enumerate(kinds)]
        accessors[0].update(min=[0, 0, 0], max=[1, 1, 0])
        accessors[2].update(min=[0], max=[1])
        (self.folder / name).write_text(json.dumps({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "buffers": [{"uri": address, "byteLength": len(data)}],
            "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": size} for start, size in views], "accessors": accessors,
            "animations": [{"name": animation, "samplers": [{"input": 2, "output": 3}],
                            "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]}))

    def animated(self, model="fly.gltf", animation="Walk", **more):
        return self.moving(scene="fly.gltf", options={"format": "gltf"}, motion={"model": model, "animation": animation}, **more)

    def refused(self, job, *arguments):
        """Returns the messages about a wrong job."""
        checked = self.render(job, "--check", *arguments, code=3)
        self.assertIn("openjd_fail: ", checked.stdout)
        return checked.stderr

    def test_an_animation_that_the_file_does_not_have(self):
        self.write_animated("fly.gltf")
        self.render(self.animated(), "--check")
        said = self.refused(self.animated(animation="Wlak"))
        self.assertIn("fly.gltf", said)
        self.assertIn("Wlak", said)
        self.assertIn("/motion/model", said)

    def test_a_file_that_needs_others(self):
        self.write_animated("fly.gltf")
        self.write_animated("far.gltf", buffer="far.bin")
        said = self.refused(self.animated(model="far.gltf"))
        self.assertIn("far.gltf", said)
        self.assertIn("far.bin", said)

    def test_a_broken_file_inside_of_a_sequence(self):
        self.write_balls(0, 0.1, 0.2, 0.3)
        self.render(self.moving(motion={"model": "ball.##.obj"}, frames="1-4"), "--check")
        broken = self.folder / "ball.03.obj"
        broken.write_text(broken.read_text()[:400])
        said = self.refused(self.moving(motion={"model": "ball.##.obj"}, frames="1-4"))
        self.assertIn("ball.03.obj: ", said)
        blur = {"motion_blur": {"samples": 2, "shutter": 1}}
        for frames in ("2", "1-4"):
            said = self.refused(self.moving(motion={"model": "ball.##.obj"}, frames=frames, **blur))
            self.assertIn("ball.03.obj: ", said)
            self.assertNotIn("ball.02.obj", said)
            said = self.render(self.moving(motion={"model": "ball.##.obj"}, frames=frames, **blur), code=3).stderr
            self.assertIn("ball.03.obj: ", said)
            self.assertNotIn("ball.02.obj", said)

    def test_a_broken_file_that_the_fur_swings_by(self):
        self.write_balls(0, 0.1, 0.2, 0.3)
        (self.folder / "ball.01.obj").write_text("v 0 0 0\n")
        motion = {"model": "ball.##.obj", "inertia": 1}
        for arguments in (("--check",), ()):
            said = self.render(self.moving(motion=motion, frames="4"), *arguments, code=3).stderr
            self.assertIn("ball.01.obj: ", said)
            self.assertNotIn("ball.04.obj", said)

    def test_a_scene_that_cannot_be_read_is_named(self):
        (self.folder / "ball.obj").write_text("v 0 0\n")
        self.assertIn("ball.obj: ", self.refused(self.moving()))

    def test_the_output_folder_is_tried_before_the_first_frame(self):
        (self.folder / "out").write_text("a file, no folder")
        for arguments in (("--check",), ()):
            said = self.render(self.job(), *arguments, code=1)
            self.assertIn("cannot be written", said.stderr)
            self.assertNotIn("openjd_status", said.stdout)
        (self.folder / "out").unlink()
        self.render(self.job(), "--check")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["job.json"], "trying leaves nothing")

    def test_what_is_wrong_in_a_job_names_file_and_cause(self):
        said = self.refused(self.job(frames="10-1"))
        self.assertIn("job.json: ", said)
        self.assertIn('"10-1" ends before it begins', said)
        self.assertIn("1-10", said)
        self.assertIn('"1-9x0" has a step below 1', self.refused(self.job(frames="1-9x0")))
        self.assertNotIn("job.json", self.refused(self.job(), "--frames", "10-1"), "the command line is wrong, not the file")
        (self.folder / "job.json").write_text('{"frames": "1",,}')
        said = self.refused(self.folder / "job.json")
        self.assertIn("job.json: ", said)
        self.assertIn("not JSON", said)
        self.assertIn("line 1, column 16", said)
        self.assertIn("job.json: ", self.refused(self.job(fsp=3)))

    def test_whole_numbers_stay_whole_while_the_shutter_is_open(self):
        still = {"turntable": None, "frames": "1-3", "motion_blur": {"samples": 2}}
        keys = [{"frame": 1, "value": 4}, {"frame": 3, "value": 6}]
        blurred = {**JOB, **still, "keyframes": [{"parameter": "/frame/quality/raster/light_of", "keys": keys}],
                   "frame": {**JOB["frame"], "quality": {"raster": {"light_of": 4}}}}
        path = self.folder / "job.json"
        path.write_text(json.dumps({name: value for name, value in blurred.items() if value is not None}))
        self.render(path, "--check")

    def test_a_pipe_is_no_file(self):
        """Nobody writes to it: whoever opened it would wait for ever."""
        os.mkfifo(self.folder / "pipe.obj")
        said = self.refused(self.moving(scene="pipe.obj"))
        self.assertIn("pipe.obj", said)
        os.mkfifo(self.folder / "pipe.json")
        self.assertIn("pipe.json", self.refused(self.folder / "pipe.json"))
        (self.folder / "out").mkdir()
        os.mkfifo(self.folder / "out" / "ball.001.png")
        self.render(self.job(frames="1"), "--skip-existing")
        self.assertTrue(self.frames()[0].is_file())


    def test_a_frame_that_is_too_large_for_its_quality_is_drawn_in_tiles(self):
        quality = {"scale": 0.25, "method": "shells", "shells": {"count": 1024, "order": "sorted"}}
        large = {"frames": "1", "frame": {"width": 8192, "height": 8192, "quality": quality}}
        said = self.refused(self.job(**large))
        self.assertIn("/frame/quality", said)
        self.assertIn("tiles of a job", said)
        small = {"frames": "1", "frame": {"width": 4096, "height": 2160, "quality": {"scale": 0.25}}}
        self.render(self.job(**small, tiles={"columns": 16, "rows": 16}), "--tile", 1)
        self.assertEqual([path.name for path in self.frames()], ["ball.001.tile1.png"])


class RenderLimitTest(JobTest):
    slow = {"frames": "1-2", "frame": {"width": 256, "height": 256,
                                      "quality": {"method": "strands", "trace": {"passes": 4000, "strands": 3000}}}}

    def test_a_frame_that_passes_its_limit_ends_with_a_code_of_its_own(self):
        run = self.render(self.job(**{**self.slow, "frame": {**self.slow["frame"], "max_seconds": 1}}), code=5)
        self.assertIn("/frame/max_seconds", run.stderr)
        self.assertIn("frame 1", run.stderr)
        self.assertEqual(self.frames(), [])

    def test_a_limit_changes_no_picture(self):
        prints = []
        for more in ({}, {"max_seconds": 86400}):
            plan = json.loads(self.render(self.job(frame={**JOB["frame"], **more}), "--check").stdout)
            prints.append([frame["fingerprint"] for frame in plan["frames"]])
        self.assertEqual(*prints)

    def test_the_limit_is_of_time_that_passed_and_not_of_an_estimate(self):
        """A server refuses such a frame at once. The largest frame of a thick coat takes long on any machine."""
        frame = {"width": 8192, "height": 8192, "quality": {"raster": {"strands": 1000, "light_of": 1}}, "max_seconds": 1}
        thick = {"op": "set_coat", "coat": {"count": 20000}}
        run = self.render(self.job(frames="1", frame=frame, commands=[thick]), code=5)
        self.assertNotIn("expected", run.stderr)


if __name__ == "__main__":
    unittest.main()
