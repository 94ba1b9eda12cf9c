"""Slurm: an array job with a task for each chunk."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from typing import Dict, List, Sequence

from .errors import FarmError
from .folder import FarmFolder
from .ranges import range_of

# Slurm sends SIGTERM this many seconds before a time limit ends the task.
GRACE_SECONDS = 30
SCRIPT = """\
#!/bin/sh
#SBATCH --job-name={name}
#SBATCH --array={array}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@{grace}
#SBATCH --output=logs/%a.log
{more}# A task of a node that died is queued again by Slurm; of its chunk it draws what is missing.
exec sh chunk.sh "$SLURM_ARRAY_TASK_ID"
"""
# States of `pelage farm status` by Slurm's state; in all other states the task is over.
LIVE = {
    "PENDING": "waiting",
    "CONFIGURING": "waiting",
    "REQUEUED": "waiting",
    "REQUEUE_HOLD": "waiting",
    "SUSPENDED": "waiting",
    "RUNNING": "running",
    "COMPLETING": "running",
    "STAGE_OUT": "running",
}


def script(folder: FarmFolder, chunks: Sequence[int], at_once: int, threads: int) -> str:
    """Returns the script for sbatch. at_once: Maximum of parallel tasks; 0 for all. threads: Cores; 0 for the default."""
    array = range_of(chunks).replace("x", ":") + (f"%{at_once}" if at_once else "")
    more = f"#SBATCH --cpus-per-task={threads}\n" if threads else ""
    name = re.sub(r"[^\w.-]+", "-", folder.name)
    return SCRIPT.format(name=name, array=array, grace=GRACE_SECONDS, more=more)


def submit(folder: FarmFolder) -> str:
    """Submits submit.sbatch to Slurm; returns the job's number. Raises FarmError."""
    printed = run("sbatch", "--parsable", f"--chdir={folder.path}", str(folder.path / "submit.sbatch"))
    return printed.strip().partition(";")[0]


def task_states(job: str) -> Dict[int, str]:
    """Returns Slurm's state of each task, by chunk. Slurm reports finished tasks for some minutes only. Raises FarmError if
    Slurm does not answer."""
    try:
        printed = run("squeue", "--noheader", "--array", "--states=all", "--job", job, "--format=%K %T")
    except FarmError as error:
        if "Invalid job id" in str(error):  # over for so long that Slurm has forgotten it
            return {}
        raise
    pairs: List[List[str]] = [line.split() for line in printed.splitlines()]
    return {int(task): state for task, state in pairs}


def run(*command: str) -> str:
    """Runs a program of Slurm and returns its output."""
    if shutil.which(command[0]) is None:
        step = "install slurm-client, or take another --engine; --dry-run only writes the folder"
        raise FarmError(f"There is no program {command[0]}", step)
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode:
        where = f" (SLURM_CONF={os.environ['SLURM_CONF']})" if "SLURM_CONF" in os.environ else ""
        step = f"see whether `sinfo` answers on this machine{where}"
        raise FarmError(f"{command[0]}: {done.stderr.strip()}", step)
    return done.stdout
