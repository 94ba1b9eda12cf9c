"""Pelage: grooming fur from Python.

    with pelage.local() as server:
        scene = server.create("fox")
        scene.length(flood=True, value=0.05)
        scene.save_frame("fox.png", camera="front")

`Server` is a server that runs already, `local` starts one. Types of what is sent and answered are in `pelage.schemas`.
"""

from .errors import Busy, Conflict, Failed, NotFound, NotStarted, PelageError, Problem, Refused, Unreachable
from .events import Change, News, Removed, SceneState
from .frame import FieldMap, Frame
from .local import LocalServer, local
from .progress import Progress, print_progress
from .scene import Batch, Scene
from .server import Server
from .strokes import stroke

__version__ = "1.0.0"

__all__ = [
    "Batch",
    "Busy",
    "Change",
    "Conflict",
    "Failed",
    "FieldMap",
    "Frame",
    "LocalServer",
    "News",
    "NotFound",
    "NotStarted",
    "PelageError",
    "Problem",
    "Progress",
    "Refused",
    "Removed",
    "Scene",
    "SceneState",
    "Server",
    "Unreachable",
    "local",
    "print_progress",
    "stroke",
]
