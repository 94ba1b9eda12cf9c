"""Kubernetes 1.29 and newer: an Indexed Job with a pod for each chunk."""

from __future__ import annotations

import re
from typing import Any, Dict, Sequence

from .folder import FarmFolder

GRACE_SECONDS = 30
MOUNT = "/farm"
TRIES = 3  # retries of a pod
# pelage-render's exit codes for wrong use and for a bad job or scene, which a retry cannot fix.
HOPELESS_CODES = [2, 3]


def manifest(
    folder: FarmFolder, chunks: Sequence[int], at_once: int, threads: int, image: str, claim: str
) -> Dict[str, Any]:
    """at_once: Maximum of parallel pods; 0 for all. image: Container image. claim: Volume claim that holds the folder.

    Pod indices count 0, 1, 2, ...; PELAGE_CHUNKS maps them to chunks, because a second run has only some of them.
    """
    pod = {
        "restartPolicy": "Never",
        "terminationGracePeriodSeconds": GRACE_SECONDS,
        "containers": [container(folder, chunks, threads, image)],
        "volumes": [{"name": "farm", "persistentVolumeClaim": {"claimName": claim}}],
    }
    spec = {
        "completionMode": "Indexed",
        "completions": len(chunks),
        "parallelism": min(at_once or len(chunks), len(chunks)),
        "backoffLimitPerIndex": TRIES,
        "podFailurePolicy": {
            "rules": [
                {"action": "FailIndex", "onExitCodes": {"operator": "In", "values": HOPELESS_CODES}},
                {"action": "Ignore", "onPodConditions": [{"type": "DisruptionTarget", "status": "True"}]},
            ]
        },
        "template": {"metadata": {"labels": {"app": "pelage-farm"}}, "spec": pod},
    }
    metadata = {"generateName": f"{label(folder.name)}-", "labels": {"app": "pelage-farm"}}
    return {"apiVersion": "batch/v1", "kind": "Job", "metadata": metadata, "spec": spec}


def container(folder: FarmFolder, chunks: Sequence[int], threads: int, image: str) -> Dict[str, Any]:
    line = 'set -- $PELAGE_CHUNKS; shift "$JOB_COMPLETION_INDEX"; exec sh chunk.sh "$1"'
    made: Dict[str, Any] = {
        "name": "pelage-render",
        "image": image,
        "command": ["/bin/sh", "-c", line],
        "workingDir": MOUNT,
        "env": [
            {"name": "PELAGE_RENDER", "value": "pelage-render"},
            {"name": "PELAGE_CHUNKS", "value": " ".join(map(str, chunks))},
        ],
        "volumeMounts": [{"name": "farm", "mountPath": MOUNT, "subPath": folder.path.name}],
    }
    if threads:
        made["resources"] = {"requests": {"cpu": str(threads)}, "limits": {"cpu": str(threads)}}
    return made


def label(name: str) -> str:
    """Returns a valid Kubernetes name: lower-case letters, digits and dashes, at most 50 characters."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower())[:50].strip("-") or "frames"
