"""Makes a .pelage file for a job, from a scene on a server, or from a model and a recipe on a private server."""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
from typing import List, Optional, Sequence
from urllib.parse import unquote, urlsplit

from ..local import local
from ..server import Server
from .errors import BAD_INPUT, FarmError

CLIENT = "pelage"
SCENE = "packed"


def pack_scene(server: Server, scene: str, output: str) -> int:
    """Packs a scene of a server, given by id or name. Returns the file's size in bytes."""
    server.open(scene).export(output, format="pelage")
    return os.path.getsize(output)


def is_on_server(scene: str) -> bool:
    """Returns True if a job's scene is on a server, such as http://localhost:8080/fox."""
    return urlsplit(scene).scheme in ("http", "https")


def fetch_scene(scene: str, folder: pathlib.Path) -> pathlib.Path:
    """Downloads a job's scene from a server into a folder. Raises FarmError, and the server's errors."""
    address = urlsplit(scene)
    name = unquote(address.path.strip("/"))
    if not name or "/" in name:
        raise FarmError(f"{scene} names no scene", "write it as http://localhost:8080/fox", BAD_INPUT)
    file = folder / f"{name}.pelage"
    with Server(f"{address.scheme}://{address.netloc}") as server:
        pack_scene(server, name, str(file))
    return file


def pack_model(model: Sequence[str], recipe: Optional[str], variables: Sequence[str], output: str) -> int:
    """Packs a model and a recipe, using a private server. Returns the file's size in bytes.

    model: Options of `pelage new`, such as ["--file", "fox.glb"]. variables: NAME=VALUE of the recipe. Raises FarmError.
    """
    with local() as server:
        client(server, ["new", "--name", SCENE, *model])
        if recipe:
            client(server, ["run", SCENE, recipe, *(word for one in variables for word in ("--set", one))])
        return pack_scene(server, SCENE, output)


def client(server: Server, words: List[str]) -> None:
    """Runs `pelage`, which handles recipes, on the server. Its errors appear on our standard error."""
    program = shutil.which(CLIENT)
    if program is None:
        raise FarmError(f"There is no program {CLIENT}", "build or install all programs in one folder, and set PATH")
    environment = {name: value for name, value in os.environ.items() if name != "PELAGE_TOKEN"}
    command = [program, "--server", server.address, *words]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, env=environment)
    if done.returncode:
        raise FarmError(f"`pelage {words[0]}` ended with {done.returncode}", "correct what it says above", done.returncode)
