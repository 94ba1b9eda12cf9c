"""Files for the farm engines: an Open Job Description template, a Kubernetes manifest, a Slurm script."""

import json
import os
import re
import shlex
import shutil
import subprocess
import unittest

import yaml

from support import REPOSITORY, FarmTest, needs
from pelage.farm.yaml import to_yaml

NODE = os.environ.get("PELAGE_NODE", shutil.which("node"))
# Members of a Job that this project writes, from the API reference of Kubernetes 1.29. The schemas would accept unknown ones.
JOB_MEMBERS = {
    "": {"apiVersion", "kind", "metadata", "spec"}, "metadata": {"generateName", "labels"},
    "spec": {"completionMode", "completions", "parallelism", "backoffLimitPerIndex", "podFailurePolicy", "template"},
}


class Yaml(unittest.TestCase):
    def test_it_reads_back(self):
        for value in ({"a": "no", "b": [1, 2.5, True, None], "c": {"d": "x: y # z\n\"'", "e": []}, "f": {}},
                      [{"a": [[1, 2], ["3"]]}, {"b": {"c": "1-5"}}], ["- a", "{{Param.X}}", "é \\"], "~"):
            self.assertEqual(yaml.safe_load(to_yaml(value)), value)


# Prints what pelage-render prints about a job of 12 frames, without the 3 s that a renderer takes to start.
RENDERER = """#!/bin/sh
echo '{"seconds_per_frame": 0.5, "fps": 24, "frames": ['
for k in 1 2 3 4 5 6 7 8 9 10 11 12; do
  [ $k = 1 ] || echo ,
  echo "{\\"frame\\": $k, \\"file\\": \\"out/$k.png\\", \\"fingerprint\\": \\"f$k\\", \\"width\\": 16, \\"height\\": 8}"
done
echo ']}'
"""


class Engines(FarmTest):
    def renderer(self):
        program = self.folder / "pelage-render"
        program.write_text(RENDERER)
        program.chmod(0o755)
        return program

    def written(self, engine, name, *words, **more):
        """Returns the job's folder, and the text of the file for the engine."""
        self.farm("submit", self.write_job(**more), "--engine", engine, "--dry-run", "--max-parallel", 4, *words,
                  environment={"PELAGE_RENDER": str(self.renderer())})
        folder = self.folder / "ball.farm"
        return folder, (folder / name).read_text()

    def test_open_job_description(self):
        """Checks the rules of revision 2023-09 that our templates could break. `openjd check` knows all of them."""
        folder, text = self.written("openjd", "template.yaml", "--threads", 2)
        template = yaml.safe_load(text)
        self.assertEqual(template["specificationVersion"], "jobtemplate-2023-09")
        self.assertLessEqual(set(template), {"specificationVersion", "name", "description", "parameterDefinitions", "jobEnvironments", "steps"})
        self.assertTrue(1 <= len(template["name"]) <= 128)
        names = {one["name"]: one["type"] for one in template["parameterDefinitions"]}
        self.assertEqual(names, {"Folder": "PATH", "Renderer": "STRING"})
        (step,) = template["steps"]
        self.assertLessEqual(set(step), {"name", "description", "dependencies", "stepEnvironments", "hostRequirements", "parameterSpace", "script"})
        (parameter,) = step["parameterSpace"]["taskParameterDefinitions"]
        self.assertEqual(set(parameter), {"name", "type", "range"})
        self.assertTrue(1 <= len(parameter["range"]) <= 1024)
        self.assertEqual(parameter["range"], (folder / "chunks.txt").read_text().split())
        run = step["script"]["actions"]["onRun"]
        self.assertEqual(run["cancelation"]["mode"], "NOTIFY_THEN_TERMINATE")
        self.assertTrue(0 < run["cancelation"]["notifyPeriodInSeconds"] <= 600)
        self.assertTrue(all(isinstance(word, str) for word in [run["command"], *run["args"]]))
        known = {f"Param.{name}" for name in names} | {f"Task.Param.{parameter['name']}"}
        used = set(re.findall(r"\{\{\s*([\w.]+)\s*\}\}", json.dumps(run)))
        self.assertEqual(used, known)
        self.assertEqual(step["hostRequirements"], {"amounts": [{"name": "amount.worker.vcpu", "min": 2}]})

    def test_tiles_become_a_parameter_of_open_job_description(self):
        job = self.write_job(frames="1-2", tiles={"columns": 2, "rows": 1})
        self.farm("submit", job, "--engine", "openjd", "--dry-run")
        template = yaml.safe_load((self.folder / "ball.farm" / "template.yaml").read_text())
        (step,) = template["steps"]
        self.assertEqual(step["parameterSpace"], {
            "taskParameterDefinitions": [{"name": "Frames", "type": "STRING", "range": ["1-2", "1-2"]}, {"name": "Tile", "type": "INT", "range": [1, 2]}],
            "combination": "(Frames, Tile)"})
        self.assertIn("--tile={{Task.Param.Tile}}", step["script"]["actions"]["onRun"]["args"])
        if shutil.which("openjd"):  # Debian 12 has no package for it
            subprocess.run(["openjd", "check", self.folder / "ball.farm" / "template.yaml"], check=True)

    def valid(self, job):
        done = subprocess.run([NODE, "validate_job.mjs"], input=json.dumps(job), text=True, capture_output=True)
        return done.returncode == 0, done.stderr

    def test_kubernetes(self):
        needs(NODE and os.path.exists("node_modules/kubernetes-models"), "the npm package kubernetes-models")
        _, text = self.written("kubernetes", "kubernetes.yaml", "--threads", 2, "--image", "registry/pelage:1", "--claim", "frames")
        job = yaml.safe_load(text)
        self.assertEqual(self.valid(job), (True, ""))
        self.assertEqual(self.valid({**job, "spec": {**job["spec"], "completions": "4"}})[0], False, "the schema says nothing")
        for part, members in JOB_MEMBERS.items():
            self.assertEqual(set(job[part] if part else job), members)
        spec = job["spec"]
        self.assertEqual((spec["completionMode"], spec["completions"], spec["parallelism"]), ("Indexed", 4, 4))
        pod = spec["template"]["spec"]
        (container,) = pod["containers"]
        self.assertEqual((pod["restartPolicy"], container["image"]), ("Never", "registry/pelage:1"))
        self.assertEqual(pod["volumes"][0]["persistentVolumeClaim"], {"claimName": "frames"})

    def test_a_pod_draws_the_chunk_of_its_index(self):
        folder, text = self.written("kubernetes", "kubernetes.yaml")
        container = yaml.safe_load(text)["spec"]["template"]["spec"]["containers"][0]
        fake = self.folder / "fake"
        fake.write_text("#!/bin/sh\necho \"$@\"\n")
        fake.chmod(0o755)
        chunks = (folder / "chunks.txt").read_text().split()
        for index, number in enumerate((1, 3)):
            environment = {**os.environ, "PELAGE_RENDER": str(fake), "PELAGE_CHUNKS": "1 3", "JOB_COMPLETION_INDEX": str(index)}
            printed = subprocess.run(container["command"], cwd=folder, env=environment, capture_output=True, text=True, check=True).stdout
            self.assertEqual(printed.split()[:3], ["job.json", f"--frames={chunks[number]}", "--skip-existing"])

    def test_threads_are_what_the_task_was_given(self):
        for words, environment, wanted in ((("--threads", 3), {"SLURM_CPUS_ON_NODE": "5"}, "3"), ((), {"SLURM_CPUS_ON_NODE": "5"}, "5"), ((), {}, "0")):
            folder, _ = self.written("slurm", "submit.sbatch", *words)
            (self.folder / "pelage-render").write_text("#!/bin/sh\necho \"$@\"\n")
            printed = subprocess.run(["sh", folder / "chunk.sh", "0"], env={"PATH": os.environ["PATH"], **environment}, capture_output=True,
                                     text=True, check=True, cwd="/").stdout
            self.assertEqual(printed.split()[-2:], ["--threads", wanted])

    def test_names_with_spaces(self):
        job = self.write_job().rename(self.folder / "my ball.json")
        self.farm("submit", job, "--dry-run", environment={"PELAGE_RENDER": str(self.renderer())})
        self.assertIn("#SBATCH --job-name=my-ball\n", (self.folder / "my ball.farm" / "submit.sbatch").read_text())

    def test_flamenco(self):
        """The job type compiles tasks, with a stand-in for Flamenco's manager."""
        needs(NODE, "node")
        script = (REPOSITORY / "deploy" / "farm" / "pelage.js").read_text() + """
            const tasks = [];
            const author = {Command: (name, parameters) => ({name, ...parameters}),
                            Task: (name, type) => ({name, type, commands: [], addCommand(one) { this.commands.push(one); }})};
            compileJob({settings: {folder: "/shared/fox.farm", chunks: 3}, addTask: (task) => tasks.push(task)});
            console.log(JSON.stringify({tasks, settings: JOB_TYPE.settings.map((one) => one.key)}));"""
        made = json.loads(subprocess.run([NODE, "-e", script], capture_output=True, text=True, check=True).stdout)
        self.assertEqual(made["settings"], ["folder", "chunks"])
        self.assertEqual([task["commands"] for task in made["tasks"]],
                         [[{"name": "exec", "exe": "sh", "args": ["/shared/fox.farm/chunk.sh", str(k)]}] for k in range(3)])

    def test_slurm(self):
        _, text = self.written("slurm", "submit.sbatch", "--threads", 3)
        for line in ("--array=0-3%4", "--requeue", "--signal=B:TERM@30", "--output=logs/%a.log", "--cpus-per-task=3"):
            self.assertIn(f"#SBATCH {line}\n", text)

    def test_what_other_engines_draw_is_counted_on_disk(self):
        self.farm("submit", self.write_job(), "--engine", "openjd", environment={"PELAGE_RENDER": str(self.renderer())})
        status = self.status(self.folder / "ball.farm")
        self.assertEqual((status["failed"], {chunk["state"] for chunk in status["chunks"]}), (0, {"sent"}))

    def test_a_dry_run_submits_nothing(self):
        folder, _ = self.written("slurm", "submit.sbatch")
        self.assertFalse((folder / "sent.json").exists())
        self.assertEqual({chunk["state"] for chunk in self.status(folder)["chunks"]}, {"unsent"})

    def test_the_line_that_a_dry_run_prints_has_its_options(self):
        environment = {"PELAGE_RENDER": str(self.renderer())}
        words = ("--engine", "kubernetes", "--max-parallel", 3, "--chunk-seconds", 2, "--threads", 5, "--image", "my pelage", "--claim", "shared")
        printed = self.farm("submit", self.write_job(), *words, "--dry-run", environment=environment).stdout
        line = shlex.split(re.search("Submit it with: (.*)", printed)[1])
        self.assertEqual(line[:3], ["pelage", "farm", "submit"])
        names = ("chunks.txt", "chunk.sh", "kubernetes.yaml")
        before = [(self.folder / "ball.farm" / name).read_text() for name in names]
        self.farm(*line[2:], environment=environment)
        self.assertEqual([(self.folder / "ball.farm" / name).read_text() for name in names], before)
        self.assertIn('"my pelage"', before[2])

    def test_a_job_that_is_a_pipe_is_refused(self):
        os.mkfifo(self.folder / "pipe.json")
        self.assertIn("pipe.json", self.farm("submit", "pipe.json", "--dry-run", code=3).stderr)
        os.mkfifo(self.folder / "pipe.pelage")
        job = self.write_job(builtin=None, scene="pipe.pelage")
        self.assertIn("pipe.pelage", self.farm("submit", job, "--dry-run", code=3).stderr)


if __name__ == "__main__":
    unittest.main()
