"""Writes templates of Open Job Description, revision 2023-09."""

from __future__ import annotations

from typing import Any, Dict, List, Sequence

from .folder import FarmFolder
from .ranges import Chunk, range_of

GRACE_SECONDS = 30
MAX_NAME = 128


def template(folder: FarmFolder, chunks: Sequence[int], threads: int) -> Dict[str, Any]:
    """Returns a template with one step and a task for each chunk. Its paths are relative to the job's folder."""
    all_chunks = folder.chunks()
    wanted = [all_chunks[chunk] for chunk in chunks]
    tiled = any(chunk.tile for chunk in wanted)
    step: Dict[str, Any] = {
        "name": "Draw",
        "parameterSpace": task_parameters(wanted, tiled),
        "script": {"actions": {"onRun": action(threads, tiled)}},
    }
    if threads:
        step["hostRequirements"] = {"amounts": [{"name": "amount.worker.vcpu", "min": threads}]}
    return {
        "specificationVersion": "jobtemplate-2023-09",
        "name": folder.name[:MAX_NAME],
        "parameterDefinitions": parameters(),
        "steps": [step],
    }


def task_parameters(chunks: Sequence[Chunk], tiled: bool) -> Dict[str, Any]:
    frames = {"name": "Frames", "type": "STRING", "range": [range_of(chunk.frames) for chunk in chunks]}
    if not tiled:
        return {"taskParameterDefinitions": [frames]}
    tiles = {"name": "Tile", "type": "INT", "range": [chunk.tile for chunk in chunks]}
    return {"taskParameterDefinitions": [frames, tiles], "combination": "(Frames, Tile)"}  # pairs of equal index


def action(threads: int, tiled: bool) -> Dict[str, Any]:
    return {
        "command": "{{Param.Renderer}}",
        "args": [
            "{{Param.Folder}}/job.json",
            "--frames={{Task.Param.Frames}}",
            *(["--tile={{Task.Param.Tile}}"] if tiled else []),
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
