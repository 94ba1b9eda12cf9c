"""File formats by extension, and atomic writing of files."""

from __future__ import annotations

import contextlib
import os
import uuid
from typing import BinaryIO, Iterator, Union

Path = Union[str, "os.PathLike[str]"]

# Formats that a file with an extension may have; the first is the default.
FORMATS = {
    ".png": ("png", "png16"),
    ".jpg": ("jpeg",),
    ".jpeg": ("jpeg",),
    ".webp": ("webp",),
    ".exr": ("exr", "exr_half"),
    ".npy": ("npy", "npy_linear"),
}


def formats_of(path: Path) -> "tuple[str, ...]":
    """Returns the formats of a file's extension. Raises ValueError for an unknown one."""
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending not in FORMATS:
        raise ValueError(f"{os.fspath(path)}: the ending says no format; take one of {', '.join(FORMATS)}")
    return FORMATS[ending]


def check_format(path: Path, kind: str) -> None:
    """Raises ValueError if the file's extension does not fit the format."""
    if kind not in formats_of(path):
        raise ValueError(f"{os.fspath(path)}: the ending stands for {' or '.join(formats_of(path))}, not {kind}")


@contextlib.contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """Opens a temporary file beside the path and renames it at the end of the block, so that the write is atomic."""
    target = os.path.realpath(os.fspath(path))
    part = f"{target}.{uuid.uuid4().hex[:8]}.part"
    try:
        with open(part, "xb") as file:
            yield file
        os.replace(part, target)
    except BaseException:
        if os.path.exists(part):
            os.unlink(part)
        raise


def write_whole(path: Path, content: bytes) -> None:
    """Writes a file, which appears whole or not at all."""
    with whole_file(path) as file:
        file.write(content)


def read_whole(source: Union[bytes, Path]) -> bytes:
    """Returns `source` if it is bytes, else the content of the file at that path."""
    if isinstance(source, bytes):
        return source
    with open(source, "rb") as file:
        return file.read()
