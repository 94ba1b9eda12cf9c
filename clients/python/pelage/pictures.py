"""Implements the methods of `Requests`: pictures, models and maps."""

from __future__ import annotations

import contextlib
import json
import os
import threading
from typing import TYPE_CHECKING, Any, Dict, Iterator, Mapping, Optional, Union, cast

from . import arrays
from .connection import Answer, Connection, Query, quoted
from .errors import PelageError
from .files import Path, check_format, formats_of, read_whole, whole_file, write_whole
from .frame import FieldMap, Frame
from .options import Options
from .pack import pack_model
from .progress import Progress, ReportProgress
from .requests import Requests
from .schemas import CommandAnswer, ExportAbout, Field, FrameCost, FrameProgressList, Pick, SceneInfo

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

WAIT = 20.0  # seconds that one request waits for a newer or better frame; the server allows 25
POLL = 1.0  # seconds between two reports of a frame's progress


class Pictures(Requests):
    """revision: The last known revision of the scene."""

    def __init__(self, connection: Connection, path: str, revision: int) -> None:
        self._connection = connection
        self._path = path
        self.revision = revision

    # Frames

    def _frame(self, members: Dict[str, Any], progress: Optional[ReportProgress]) -> Frame:
        request = frame_request(members)
        with self._reported(request, progress):
            return Frame(self._post_frame(request), request.get("format", "png"))

    def _save_frame(self, members: Dict[str, Any], path: Path, progress: Optional[ReportProgress]) -> Frame:
        format = members["format"] or formats_of(path)[0]
        check_format(path, format)
        frame = self._frame({**members, "format": format}, progress)
        write_whole(path, frame.bytes)
        return frame

    def _frame_cost(self, members: Dict[str, Any]) -> FrameCost:
        return cast(FrameCost, self._post_frame(frame_request(members), {"dry_run": "1"}).json)

    def _frame_array(
        self, members: Dict[str, Any], linear: bool, progress: Optional[ReportProgress]
    ) -> NDArray[Any]:
        arrays.numpy_module()  # fails before anything is drawn
        return self._frame({**members, "format": "npy_linear" if linear else "npy"}, progress).array()

    def _live_frames(self, members: Dict[str, Any]) -> Iterator[Frame]:
        frame = self._frame(members, None)
        while True:
            yield frame
            frame = self._newer(frame_request(members), {"after": frame.revision})

    def _better_frames(self, members: Dict[str, Any]) -> Iterator[Frame]:
        progressive = True if members["progressive"] is None else members["progressive"]
        request = frame_request({**members, "progressive": progressive})
        frame = Frame(self._post_frame(request), request.get("format", "png"))
        while frame.trace is not None:
            yield frame
            if frame.trace["end"] != "none":
                return
            frame = self._newer(request, {"after": frame.revision, "after_pass": frame.trace["passes"]})

    def _newer(self, request: Dict[str, Any], known: Mapping[str, int]) -> Frame:
        """Waits for a picture that is newer or better than what is known."""
        while True:
            answer = self._post_frame(request, {**known, "wait": WAIT})
            if answer.status != 304:
                return Frame(answer, request.get("format", "png"))

    def _post_frame(self, request: Dict[str, Any], query: Optional[Query] = None) -> Answer:
        return self._connection.post(f"{self._path}/frames", request, query=query, changes=False)

    @contextlib.contextmanager
    def _reported(self, request: Dict[str, Any], progress: Optional[ReportProgress]) -> Iterator[None]:
        """Reports the frame's progress while the block runs, and its end."""
        if progress is None:
            yield
            return
        done = threading.Event()
        watch = threading.Thread(target=self._watch, args=(request.get("view", ""), done, progress), daemon=True)
        watch.start()
        try:
            yield
        finally:
            done.set()
            watch.join()
        progress(Progress(1.0, "done"))

    def _watch(self, view: str, done: threading.Event, progress: ReportProgress) -> None:
        with contextlib.closing(self._connection):  # closes this thread's connection at the end
            while not done.wait(POLL):
                try:
                    answer = self._connection.get(f"{self._path}/frames", retries=0)
                except PelageError:
                    continue  # the frame's own request reports the error
                frames = cast(FrameProgressList, answer.json)["frames"]
                ours = [frame for frame in frames if frame["view"] == view]
                if ours:
                    drawn = max(ours, key=lambda frame: frame["share"])
                    text = f"of about {drawn['expected_seconds']:.0f} s, {drawn['seconds']:.0f} s so far"
                    progress(Progress(drawn["share"], text))

    # Models and maps

    def _load(
        self,
        members: Dict[str, Any],
        path: Path,
        discard: bool,
        if_match: Optional[int],
        progress: Optional[ReportProgress],
    ) -> SceneInfo:
        model = pack_model(path, members["format"])
        query = {**members, "format": model.format, "discard": int(discard)}
        return self._described(self._upload("model", model.content, query, Options(None, False, if_match), progress))

    def _upload_environment(
        self,
        members: Dict[str, Any],
        picture: Union[bytes, Path],
        author: Optional[str],
        if_match: Optional[int],
        progress: Optional[ReportProgress],
    ) -> CommandAnswer:
        options = Options(author, False, if_match)
        return self._changed(self._upload("environment", read_whole(picture), members, options, progress))

    def _download_map(self, members: Dict[str, Any], field: Field) -> FieldMap:
        return FieldMap(self._connection.get(f"{self._path}/maps/{field}", members), members["format"] or "png16")

    def _upload_map(
        self,
        members: Dict[str, Any],
        field: Field,
        picture: Union[bytes, Path],
        author: Optional[str],
        if_match: Optional[int],
        progress: Optional[ReportProgress],
    ) -> CommandAnswer:
        options = Options(author, False, if_match)
        return self._changed(self._upload(f"maps/{field}", read_whole(picture), members, options, progress))

    def _upload_guides(
        self,
        members: Dict[str, Any],
        curves: Union[bytes, Path],
        author: Optional[str],
        if_match: Optional[int],
        progress: Optional[ReportProgress],
    ) -> CommandAnswer:
        ending = "" if isinstance(curves, bytes) else os.path.splitext(os.fspath(curves))[1][1:].lower()
        query = {**members, "format": members["format"] or ending}
        options = Options(author, False, if_match)
        return self._changed(self._upload("guides", read_whole(curves), query, options, progress))

    def _map_array(self, members: Dict[str, Any], field: Field) -> NDArray[numpy.float32]:
        arrays.numpy_module()  # fails before anything is drawn
        return self._download_map({**members, "format": "npy"}, field).array()

    def _upload(
        self,
        name: str,
        content: bytes,
        query: Mapping[str, Any],
        options: Options,
        progress: Optional[ReportProgress],
    ) -> Answer:
        """Uploads content. Is not retried when the connection is lost, because the scene may have changed already."""
        return self._connection.put(
            f"{self._path}/{name}", content, query=query, headers=options.headers, progress=progress
        )

    def _export(self, members: Dict[str, Any], path: Path) -> ExportAbout:
        ending = os.path.splitext(os.fspath(path))[1][1:].lower()
        format = members["format"] or ("shells" if ending == "glb" else ending)  # the GLB format that any viewer shows
        query = {**members, "format": None}
        with whole_file(path) as file:
            answer = self._connection.get_into(file, f"{self._path}/export/{quoted(format)}", query)
        return cast(ExportAbout, json.loads(answer.headers["pelage-export"]))

    def _export_about(self, members: Dict[str, Any]) -> ExportAbout:
        query = {**members, "format": None, "dry_run": "1"}
        return cast(ExportAbout, self._connection.get(f"{self._path}/export/{quoted(members['format'])}", query).json)

    # The model

    def _pick(self, members: Dict[str, Any], x: float, y: float, reach: str) -> Pick:
        return self._post_pick({"view": frame_request(members), "pixel": [x, y], "reach": reach})

    def _post_pick(self, request: Mapping[str, Any]) -> Pick:
        return cast(Pick, self._connection.post(f"{self._path}/pick", request, changes=False).json)

    def _mesh(self, members: Dict[str, Any]) -> bytes:
        return self._connection.get(f"{self._path}/mesh", members).body

    def _subdivide(self, members: Dict[str, Any], if_match: Optional[int]) -> SceneInfo:
        headers = Options(None, False, if_match).headers
        return self._described(self._connection.post(f"{self._path}/subdivide", given(members), headers=headers))

    def _turn(self, members: Dict[str, Any], if_match: Optional[int]) -> SceneInfo:
        headers = Options(None, False, if_match).headers
        return self._described(self._connection.post(f"{self._path}/turn", given(members), headers=headers))

    def _described(self, answer: Answer) -> SceneInfo:
        info = cast(SceneInfo, answer.json)
        self.revision = info["revision"]
        return info

    def _changed(self, answer: Answer) -> CommandAnswer:
        result = cast(CommandAnswer, answer.json)
        self.revision = result["revision"]
        return result


def given(members: Mapping[str, Any]) -> Dict[str, Any]:
    """Returns the members that are not None."""
    return {name: value for name, value in members.items() if value is not None}


def frame_request(members: Mapping[str, Any]) -> Dict[str, Any]:
    """Returns the request to send; a camera given by name becomes an automatic camera."""
    request = given(members)
    if isinstance(request.get("camera"), str):
        request["camera"] = {"auto": request["camera"]}
    return request
