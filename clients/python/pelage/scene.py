"""A scene: a model, its fur and the log of every change."""

from __future__ import annotations

import contextlib
import json
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Sequence, Union, cast

from . import arrays, events
from .commands import Commands
from .connection import Connection, quoted, with_query
from .files import Path, read_whole
from .options import Options
from .pictures import Pictures, given
from .progress import ReportProgress
from .schemas import (
    Command,
    CommandAnswer,
    Comparison,
    Field,
    FrameProgress,
    LogEntry,
    Pick,
    RecipeStep,
    SceneInfo,
    Settings,
    StoredPicture,
)

if TYPE_CHECKING:
    import numpy
    from numpy.typing import ArrayLike, NDArray


class Batch(Commands[None]):
    """Commands that become one undo step.

    commands: The commands so far, as they will be sent.
    answer: The server's answer, set at the end of the block; None if there are no commands.
    """

    def __init__(self) -> None:
        self.commands: List[Dict[str, Any]] = []
        self.answer: Optional[CommandAnswer] = None

    def _run(self, command: Dict[str, Any], options: Options) -> None:
        if options != Options():
            raise ValueError("author, dry_run and if_match belong to the batch, not to a command in it")
        self.commands.append(given(command))


class Scene(Commands[CommandAnswer], Pictures):
    """A scene on a server. Any number of threads and processes may use the same one.

    id: Its unique id. name: Its name; several scenes may have the same.
    revision: The last revision that this object knows; `info()` updates it.
    """

    def __init__(self, connection: Connection, info: SceneInfo) -> None:
        super().__init__(connection, f"/v1/scenes/{quoted(info['id'])}", info["revision"])
        self.id = info["id"]
        self.name = info["name"]

    def __repr__(self) -> str:
        return f"<Scene {self.name} {self.id}, revision {self.revision}>"

    def info(self) -> SceneInfo:
        """Its model, revision and edit layers."""
        return self._described(self._connection.get(self._path))

    def settings(self, revision: Optional[int] = None) -> Settings:
        """Coat, look, lights, eyes and all else that commands set, with all defaults; now or at a revision."""
        return cast(Settings, self._connection.get(f"{self._path}/settings", given({"revision": revision})).json)

    def rename(self, name: str) -> None:
        """Gives the scene another name, at most 200 bytes; its id and revision stay."""
        self.name = self._described(self._connection.post(f"{self._path}/rename", {"name": name}))["name"]

    def remove(self) -> None:
        """Removes the scene and its log for good."""
        self._connection.delete(self._path)

    # Commands

    def run(
        self,
        *commands: Union[Command, Dict[str, Any]],
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> CommandAnswer:
        """Runs one command or 2 to 1000 as one undo step, all or nothing; each as the contract has it."""
        body: Any = commands[0] if len(commands) == 1 else {"commands": commands}
        return self._post("commands", body, Options(author, dry_run, if_match))

    @contextlib.contextmanager
    def batch(
        self, *, author: Optional[str] = None, dry_run: bool = False, if_match: Optional[int] = None
    ) -> Iterator[Batch]:
        """Collects commands and runs them at the end of the block as one undo step. An exception sends nothing."""
        batch = Batch()
        yield batch
        if batch.commands:
            batch.answer = self._post("commands", {"commands": batch.commands}, Options(author, dry_run, if_match))

    def _run(self, command: Dict[str, Any], options: Options) -> CommandAnswer:
        return self._post("commands", given(command), options)

    # History

    def undo(self, steps: int = 1, *, author: Optional[str] = None, if_match: Optional[int] = None) -> CommandAnswer:
        """Takes back the newest steps."""
        return self._post("undo", {"steps": steps}, Options(author, False, if_match))

    def redo(self, steps: int = 1, *, author: Optional[str] = None, if_match: Optional[int] = None) -> CommandAnswer:
        """Does again what was taken back."""
        return self._post("redo", {"steps": steps}, Options(author, False, if_match))

    def revert(
        self, revision: int, *, author: Optional[str] = None, if_match: Optional[int] = None
    ) -> CommandAnswer:
        """Goes back to an earlier revision of this model; can itself be undone."""
        return self._post("revert", {"revision": revision}, Options(author, False, if_match))

    def amend(
        self,
        revision: int,
        commands: Sequence[Union[Command, Dict[str, Any]]],
        *,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> CommandAnswer:
        """Puts commands in the place of the step that made a revision, and replays what follows. None leave it out."""
        body = {"revision": revision, "commands": commands}
        return self._post("amend", body, Options(author, dry_run, if_match))

    def branch(self, name: Optional[str] = None, *, revision: Optional[int] = None) -> Scene:
        """A scene of its own that begins as this one was at a revision, by default now. Its name is "branch" unless given."""
        answer = self._connection.post(f"{self._path}/branch", given({"name": name, "revision": revision}))
        return Scene(self._connection, cast(SceneInfo, answer.json))

    def log(self) -> List[LogEntry]:
        """Every entry since the model came, oldest first."""
        return cast(List[LogEntry], cast(Any, self._connection.get(f"{self._path}/log").json)["entries"])

    def steps(self, carried_to: Optional[Scene] = None) -> List[Dict[str, Any]]:
        """The undo steps that lead to where the scene is now; `run` takes each of them.

        carried_to: A scene. Positions, directions and lengths are transferred to its model. A step that names vertices
        or revisions cannot be transferred and raises `Refused`.
        """
        query = given({"format": "jsonl", "for": carried_to.id if carried_to else None})
        return [json.loads(line) for line in self._connection.get(f"{self._path}/log", query).body.splitlines()]

    def compare(self, first: int, second: int) -> Comparison:
        """Returns the differences between two revisions, field by field."""
        return cast(Comparison, self._connection.get(f"{self._path}/compare", {"from": first, "to": second}).json)

    def follow(self, since: Optional[int] = None) -> Iterator[events.News]:
        """Yields the scene's events as they happen: its state first, then each change; ends after `Removed`.

        Reconnects after a lost connection without a gap. since: A revision; begins with the changes after it.
        """
        for news in events.follow(self._connection, f"{self._path}/events", since):
            self.revision = news.revision
            yield news

    # Pictures and fields

    def frames_under_way(self) -> List[FrameProgress]:
        """Returns the frames of the scene that are being drawn or waiting, and their progress."""
        return cast(List[FrameProgress], self._connection.get(f"{self._path}/frames").json["frames"])

    def frame_address(self, **parameters: Union[str, int, float, bool]) -> str:
        """Returns a URL that always serves a PNG of the scene's current state, for a page or another program.

        parameters: Those of GET frame.png, such as `camera="front", width=256`. A server with a token asks for it there too.
        """
        return self._connection.address + with_query(f"{self._path}/frame.png", parameters)

    def upload_skin_texture(
        self,
        picture: Union[bytes, Path],
        *,
        author: Optional[str] = None,
        if_match: Optional[int] = None,
        progress: Optional[ReportProgress] = None,
    ) -> CommandAnswer:
        """Lays a PNG or JPEG on the model by its texture coordinates, as one undo step. picture: Its bytes or path."""
        options = Options(author, False, if_match)
        return self._changed(self._upload("skin_texture", read_whole(picture), {}, options, progress))

    def upload_picture(
        self, picture: Union[bytes, Path], *, progress: Optional[ReportProgress] = None
    ) -> StoredPicture:
        """Stores a PNG, JPEG, EXR or HDR for use by `map` and `mask`; changes nothing. picture: Its bytes or path."""
        content = read_whole(picture)
        answer = self._connection.put(f"{self._path}/pictures", content, repeatable=True, progress=progress)
        return cast(StoredPicture, answer.json)

    def pick_ray(self, origin: Sequence[float], direction: Sequence[float]) -> Pick:
        """The first position on the surface that a ray hits; `{"hit": False}` where it passes by. Model coordinates."""
        return self._post_pick({"ray": {"origin": list(origin), "direction": list(direction)}})

    def pick_farthest(
        self,
        direction: Sequence[float],
        min: Optional[Sequence[float]] = None,
        max: Optional[Sequence[float]] = None,
    ) -> Pick:
        """The position that lies farthest along a direction, as the tip of an ear, of what lies in a box.

        min, max: The lowest and the highest corner of the box, model coordinates; the whole model without them.
        """
        corners = {"min": min, "max": max}
        box = {name: list(corner) for name, corner in corners.items() if corner is not None}
        return self._post_pick({"farthest": {"direction": list(direction), **box}})

    def pick_nearest(self, position: Sequence[float]) -> Pick:
        """The position on the surface that is nearest to another in model coordinates."""
        return self._post_pick({"nearest": list(position)})

    def recipe_steps(
        self,
        recipe: Mapping[str, Any],
        *,
        files: Optional[Mapping[str, Any]] = None,
        variables: Optional[Mapping[str, Any]] = None,
        places: Optional[Mapping[str, Any]] = None,
    ) -> List[RecipeStep]:
        """The steps of a recipe for this model; nothing is changed. `run(*step["commands"])` runs one.

        files: Documents of the recipes that it includes, by name. variables: Values in place of the recipe's.
        places: Places and sizes in place of variables and picks.
        """
        given_parts = given({"recipe": recipe, "files": files, "variables": variables, "places": places})
        return cast("List[RecipeStep]", self._connection.post(f"{self._path}/recipe", given_parts, changes=False).json["steps"])

    def set_map_array(self, field: Field, array: ArrayLike, **options: Any) -> CommandAnswer:
        """Reads a field from an array [height, width] or [height, width, channels] as from a picture.

        options: Options of `upload_map`.
        """
        return self.upload_map(field, arrays.encoded(array), **options)

    def positions(self) -> NDArray[numpy.float64]:
        """Returns the positions of the vertices, [vertices, 3], in the model's coordinates and the order of `field`."""
        return arrays.decoded(self._connection.get(f"{self._path}/vertices").body, "npy")

    def field(self, name: Field) -> NDArray[numpy.float32]:
        """A field at the vertices as a NumPy array of float32: [vertices], or [vertices, channels].

        direction: [vertices, 3], vectors along the surface in model coordinates, as long as the tip is inclined.
        root_colour, tip_colour: [vertices, 4], linear red, green and blue, and how much they cover. length: sizes.
        """
        return self.map_array(name, encoding="vertices")

    def set_field(self, name: Field, array: ArrayLike, **options: Any) -> CommandAnswer:
        """Puts an array of the shape that `field` gives in the place of a field, as one undo step.

        options: As of `upload_map`, such as strength and author. The mask holds; values beyond the field's range are
        held at its limit and counted as `clamped`.
        """
        return self.upload_map(name, arrays.encoded(array), encoding="vertices", **options)

    def _post(self, name: str, body: Any, options: Options) -> CommandAnswer:
        path = f"{self._path}/{name}"
        return self._changed(self._connection.post(path, body, query=options.query, headers=options.headers))
