"""Open Job Description: a template of revision 2023-09."""

from __future__ import annotations

from typing import Any, Dict, List, Sequence

from .folder import FarmFolder
from .ranges import range_of

GRACE_SECONDS = 30
MAX_NAME = 128


def template(folder: FarmFolder, chunks: Sequence[int], threads: int) -> Dict[str, Any]:
    """A step with a task for each chunk. It stands in the folder of the job, where its paths begin."""
    lines = folder.chunks()
    step: Dict[str, Any] = {
        "name": "Draw",
        "parameterSpace": {
            "taskParameterDefinitions": [
                {"name": "Frames", "type": "STRING", "range": [range_of(lines[chunk]) for chunk in chunks]}
            ]
        },
        "script": {"actions": {"onRun": action(threads)}},
    }
    if threads:
        step["hostRequirements"] = {"amounts": [{"name": "amount.worker.vcpu", "min": threads}]}
    return {
        "specificationVersion": "jobtemplate-2023-09",
        "name": folder.name[:MAX_NAME],
        "parameterDefinitions": parameters(),
        "steps": [step],
    }


def action(threads: int) -> Dict[str, Any]:
    return {
        "command": "{{Param.Renderer}}",
        "args": [
            "{{Param.Folder}}/job.json",
            "--frames={{Task.Param.Frames}}",
            "--skip-existing",
            "--threads",
            str(threads),
        ],
        "cancelation": {"mode": "NOTIFY_THEN_TERMINATE", "notifyPeriodInSeconds": GRACE_SECONDS},
    }


def parameters() -> List[Dict[str, Any]]:
    return [
        {
            "name": "Folder",
            "type": "PATH",
            "objectType": "DIRECTORY",
            "dataFlow": "INOUT",
            "default": ".",
            "description": "The folder with job.json, where the frames go too.",
        },
        {
            "name": "Renderer",
            "type": "STRING",
            "default": "pelage-render",
            "description": "The program, on the PATH of the workers.",
        },
    ]
