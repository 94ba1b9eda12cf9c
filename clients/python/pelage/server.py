"""A server and its scenes."""

from __future__ import annotations

import os
import types
from typing import Any, Dict, List, Optional, Type, TypeVar, cast

from .connection import Connection, quoted
from .errors import Busy, NotFound, PelageError, Unreachable
from .files import Path, read_whole
from .pictures import given
from .scene import Scene
from .schemas import BuiltinModel, FirstGroom, FurPatches, SceneInfo

S = TypeVar("S", bound="Server")


class Server:
    """A running `pelaged`. Any number of threads may use it; `with` closes the connection of this thread at the end."""

    def __init__(
        self,
        address: Optional[str] = None,
        token: Optional[str] = None,
        *,
        timeout: float = 300.0,
        retries: int = 5,
    ) -> None:
        """Sends nothing yet.

        address: Such as "https://groom.example:8080"; PELAGE_SERVER, else http://127.0.0.1:8080, unless given.
        token: PELAGE_TOKEN, else none, unless given.
        timeout: Seconds to wait for any sign of the server; of a frame that takes longer give more.
        retries: Tries after the first where the connection is lost or the server has no room (429, 503).
        Raises ValueError for what is no address.
        """
        where = address or os.environ.get("PELAGE_SERVER") or "http://127.0.0.1:8080"
        self._connection = Connection(where, token or os.environ.get("PELAGE_TOKEN"), timeout, retries)

    @property
    def address(self) -> str:
        """The server's address; a browser shows the studio there."""
        return self._connection.address

    def create(
        self,
        name: Optional[str] = None,
        *,
        model: Optional[BuiltinModel] = None,
        fur: Optional[FirstGroom] = None,
        fur_patches: Optional[FurPatches] = None,
        ground: Optional[bool] = None,
    ) -> Scene:
        """Makes a scene with a built-in model; `Scene.load` puts one from a file in its place.

        name: "scene" unless given. model: The creature of 5000 triangles unless given. fur: The first fur.
        fur_patches: How the sample tile is laid on the surface; "overlapping" unless given.
        ground: Whether the ground below the model is visible at first.
        """
        members = {"name": name, "model": model, "fur": fur, "fur_patches": fur_patches, "ground": ground}
        return Scene(self._connection, cast(SceneInfo, self._connection.post("/v1/scenes", given(members)).json))

    def open_file(self, path: Path, name: Optional[str] = None) -> Scene:
        """Makes a scene of a .pelage file (`Scene.export`), with its log and undo.

        name: The file's own unless given. Not tried again once it was sent. Raises Refused for other files.
        """
        answer = self._connection.post_bytes("/v1/open", read_whole(path), given({"name": name}))
        return Scene(self._connection, cast(SceneInfo, answer.json))

    def scenes(self) -> List[Scene]:
        """All scenes, at most 64."""
        infos = cast(List[SceneInfo], self._connection.get("/v1/scenes").json["scenes"])
        return [Scene(self._connection, info) for info in infos]

    def open(self, scene: str) -> Scene:
        """A scene by its id or its name. Raises NotFound, or PelageError where several have that name."""
        try:
            return Scene(self._connection, cast(SceneInfo, self._connection.get(f"/v1/scenes/{quoted(scene)}").json))
        except NotFound as error:
            named = [one for one in self.scenes() if one.name == scene]
            if not named:
                raise NotFound(404, {**error.document, "detail": f"There is no scene {scene!r}."}) from None
        if len(named) > 1:
            raise PelageError(f"{len(named)} scenes are named {scene!r}; open one by its id: {[one.id for one in named]}")
        return named[0]

    def is_alive(self) -> bool:
        """Returns True if the process answers; asks once, without retries."""
        return self._answers("/livez")

    def is_ready(self) -> bool:
        """Returns True if the server accepts work; asks once, without retries."""
        return self._answers("/readyz")

    def metrics(self) -> Dict[str, float]:
        """Prometheus metrics; a name has its labels, such as 'pelage_requests_total{route="/readyz",status="200"}'."""
        lines = self._connection.get("/metrics").body.decode().splitlines()
        pairs = (line.rsplit(" ", 1) for line in lines if line and not line.startswith("#"))
        return {name: float(value) for name, value in pairs}

    def contract(self) -> Dict[str, Any]:
        """The OpenAPI document of this server."""
        return cast(Dict[str, Any], self._connection.get("/openapi.json").json)

    def studio_file(self, name: Optional[str] = None) -> bytes:
        """The studio's page, or the file of that name in its assets."""
        return self._connection.get(f"/assets/{quoted(name)}" if name else "/").body

    def docs_file(self, name: str = "index.html") -> bytes:
        """A page of the reference that the server has at /docs, or a picture of it."""
        return self._connection.get(f"/docs/{quoted(name)}").body

    def close(self) -> None:
        """Closes the connection of this thread; a later request opens another."""
        self._connection.close()

    def __enter__(self: S) -> S:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[types.TracebackType],
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.address}>"

    def _answers(self, path: str) -> bool:
        try:
            return self._connection.get(path, retries=0).status == 200
        except (Busy, Unreachable):
            return False
