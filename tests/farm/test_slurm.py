"""A real Slurm with two nodes on this machine: a task is killed, a node is killed, and in the end every frame is complete."""

import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

from support import FarmTest, REPOSITORY, needs, nightly

SLURM = REPOSITORY / "deploy" / "farm" / "slurm.sh"
DEAD_SECONDS = 5  # without a sign of life, after which a node is down
LONGEST_SECONDS = 150  # timeout of every wait, for a busy machine
FRAMES, CHUNKS = 24, 6


def processes():
    """Yields (process id, command line, environment) of all processes."""
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            lines = (process / "environ").read_bytes().split(b"\0")
            environment = dict(line.decode(errors="replace").split("=", 1) for line in lines if b"=" in line)
            yield int(process.name), (process / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace"), environment
        except OSError:
            pass  # it has ended, or is not ours


def parent_of(process):
    return int(pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[1])


class Slurm(FarmTest):
    def setUp(self):
        super().setUp()
        os.environ["PATH"] += os.pathsep + "/usr/sbin"
        for program in ("slurmctld", "slurmd", "munged", "sbatch"):
            needs(shutil.which(program), program)
        self.cluster = self.folder / "slurm"
        self.addCleanup(self.stop)
        self.slurm("start", self.cluster, 2)
        os.environ["SLURM_CONF"] = str(self.cluster / "slurm.conf")
        self.addCleanup(os.environ.pop, "SLURM_CONF")
        self.log = []

    def slurm(self, *words):
        done = subprocess.run([SLURM, *map(str, words)], env={**os.environ, "PELAGE_SLURM_DEAD_SECONDS": str(DEAD_SECONDS)},
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stdout)

    def stop(self):
        """Stops the cluster and kills whatever is left of it, in any state."""
        subprocess.run([SLURM, "stop", self.cluster], stdin=subprocess.DEVNULL, timeout=60)
        for process, _, environment in processes():
            if process != os.getpid() and environment.get("SLURM_CONF", "").startswith(str(self.folder)):
                os.kill(process, signal.SIGKILL)

    def tasks(self):
        """Yields (process id, chunk, node) of the running renderers."""
        for process, command, environment in processes():
            if environment.get("SLURM_CONF") == os.environ["SLURM_CONF"] and "job.json" in command and "slurmstepd" not in command:
                yield process, int(environment["SLURM_ARRAY_TASK_ID"]), environment["SLURMD_NODENAME"]

    def wait(self, what, condition):
        """Waits until the condition returns something true, and returns that."""
        deadline = time.monotonic() + LONGEST_SECONDS
        while time.monotonic() < deadline:
            found = condition()
            if found:
                return found
            time.sleep(0.05)
        raise AssertionError(f"{what} did not come: {self.farm_log()}")

    def farm_log(self):
        return {file.name: file.read_text()[-1000:] for file in (self.folder / "ball.farm" / "logs").glob("*.log")}

    def at_work(self, node):
        """Returns a task of this node that has drawn some frames of its chunk but not all."""
        for process, chunk, where in self.tasks():
            drawn = (self.folder / "ball.farm" / "logs" / f"{chunk}.log").read_text().count("Saved: ")
            if where == node and 0 < drawn < FRAMES // CHUNKS:
                return process, chunk
        return None

    def kill_node(self, node):
        """Kills the daemon, its step daemons and their tasks at once, like a power failure."""
        doomed = [int((self.cluster / "pids" / f"slurmd-{node}").read_text())]
        for process, _, where in self.tasks():
            if where == node:
                doomed += [process, parent_of(process)]
        for process in doomed:
            os.kill(process, signal.SIGKILL)

    def over(self):
        status = self.status(self.folder / "ball.farm", code=None)
        return status if all(chunk["state"] not in ("running", "waiting") for chunk in status["chunks"]) else None

    def test_killed_tasks_and_nodes(self):
        job = self.write_job(f"1-{FRAMES}", frame={"width": 256, "height": 256, "quality": {"scale": 2}})
        folder = self.folder / "ball.farm"
        self.assertIn(f"{CHUNKS} of {CHUNKS} chunks to draw", self.farm("submit", job, "--max-parallel", CHUNKS).stdout)
        self.assertIn("still draws", self.farm("submit", job, code=1).stderr, "never twice at the same time")

        process, killed = self.wait("a task on n0", lambda: self.at_work("n0"))
        os.kill(process, signal.SIGKILL)
        _, lost = self.wait("a task on n1", lambda: self.at_work("n1"))
        self.kill_node("n1")

        status = self.wait("the end", self.over)
        failed = {chunk["chunk"]: chunk["reason"] for chunk in status["chunks"] if chunk["state"] == "failed"}
        self.assertEqual(failed, {killed: "FAILED: its log ends without an error: it was killed"}, self.farm_log())
        printed = (folder / "logs" / f"{lost}.log").read_text()
        self.assertIn("Skipped: ", printed, "the frames that the dead node had drawn are not drawn again")

        before = {file: file.stat().st_ino for file in (folder / "out").glob("ball.*.png")}
        self.slurm("node", self.cluster, "n1")
        self.assertIn(f"1 of {CHUNKS} chunks to draw", self.farm("submit", folder).stdout)
        self.assertIn(f"{FRAMES} of {FRAMES} frames", self.farm("status", folder, "--watch").stdout)
        self.assertEqual({file: file.stat().st_ino for file in before}, before, "what was whole is not drawn again")

        self.assertIn("0 with faults", self.farm("check", folder).stdout)
        self.assertIn(f"All {FRAMES} frames are there", self.farm("submit", folder).stdout)
        self.assertEqual(sorted(file.name for file in (folder / "out").iterdir()), [f"ball.{k:04}.png" for k in range(1, FRAMES + 1)])

    @nightly
    def test_a_job_that_is_cancelled(self):
        """Slurm sends SIGTERM, as at a time limit; only complete frames are left."""
        job = self.write_job("1-200", frame={"width": 256, "height": 256, "quality": {"scale": 2}})
        folder = self.folder / "ball.farm"
        self.farm("submit", job)
        self.wait("a frame", lambda: list((folder / "out").glob("ball.*.png")))
        subprocess.run(["scancel", "--user", str(os.getuid())], check=True)
        status = self.wait("the end", self.over)
        self.assertGreater(status["failed"], 0)
        self.assertEqual(list((folder / "out").glob(".*")), [])
        self.assertEqual(list(self.tasks()), [])


if __name__ == "__main__":
    unittest.main()
