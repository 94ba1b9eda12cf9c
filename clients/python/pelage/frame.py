"""Pictures that the server has drawn."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

from . import arrays
from .connection import Answer
from .files import Path, check_format, write_whole
from .schemas import FrameCounters, FrameEstimate, Knobs, MapAbout, TraceReport

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Picture:
    """bytes: The file's bytes. format: Their format, as requested. revision: The scene's revision that was drawn."""

    def __init__(self, answer: Answer, format: str) -> None:
        self.bytes = answer.body
        self.format = format
        self.revision = int(answer.headers["pelage-revision"])

    def save(self, path: Path) -> None:
        """Writes the bytes to a file, which appears whole or not at all.

        Raises ValueError where the ending stands for another format.
        """
        check_format(path, self.format)
        write_whole(path, self.bytes)

    def array(self) -> NDArray[Any]:
        """The pixels as a NumPy array. Raises PelageError unless the format is npy or npy_linear."""
        return arrays.decoded(self.bytes, self.format)

    def _repr_png_(self) -> Optional[bytes]:
        return self.bytes if self.format in ("png", "png16") else None

    def _repr_jpeg_(self) -> Optional[bytes]:
        return self.bytes if self.format == "jpeg" else None

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.format}, {len(self.bytes)} bytes, revision {self.revision}>"


class Frame(Picture):
    """A frame. A notebook shows it when its format is PNG or JPEG.

    quality: The knobs that were used; as `quality` they draw the same frame.
    estimate: Its error and cost, or None where nothing is known of them.
    missed: What it did not keep of the request: "budget_ms", "max_error", "seconds".
    trace: Of a traced picture, and of all `better_frames`; else None.
    counters: What it asked of the GL, or None.
    timing: Milliseconds by the name of the stage, such as "draw" and "encode".
    """

    def __init__(self, answer: Answer, format: str) -> None:
        super().__init__(answer, format)
        self.quality: Optional[Knobs] = header(answer, "pelage-quality")
        self.estimate: Optional[FrameEstimate] = header(answer, "pelage-error")
        self.missed: Tuple[str, ...] = tuple(filter(None, answer.headers.get("pelage-missed", "").split(", ")))
        self.trace: Optional[TraceReport] = header(answer, "pelage-trace")
        self.counters: Optional[FrameCounters] = header(answer, "pelage-counters")
        self.timing = timing_of(answer.headers.get("server-timing", ""))

    @property
    def milliseconds(self) -> float:
        """Sum over all stages; `cpu` is no stage."""
        return sum(value for name, value in self.timing.items() if name != "cpu")


class FieldMap(Picture):
    """A field as a picture over the model's texture coordinates. about: How to read it."""

    def __init__(self, answer: Answer, format: str) -> None:
        super().__init__(answer, format)
        self.about: MapAbout = json.loads(answer.headers["pelage-map"])


def header(answer: Answer, name: str) -> Any:
    """Returns the JSON value of a header, or None."""
    return json.loads(answer.headers[name]) if name in answer.headers else None


def timing_of(text: str) -> Dict[str, float]:
    """"draw;dur=1.5, read;dur=0" as a dictionary."""
    pairs = (entry.strip().split(";dur=") for entry in text.split(",") if ";dur=" in entry)
    return {name: float(value) for name, value in pairs}
