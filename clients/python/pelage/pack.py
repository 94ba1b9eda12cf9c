"""Packs a model file and the files that it references into one upload."""

from __future__ import annotations

import io
import json
import os
import pathlib
import urllib.parse
import warnings
import zipfile
from typing import Dict, Iterator, List, NamedTuple, Optional, Tuple

from .files import Path


class PackedModel(NamedTuple):
    """content: The file's own bytes, or a zip archive of it and the files that it references. format: Its format."""

    content: bytes
    format: str


def pack_model(path: Path, format: Optional[str]) -> PackedModel:
    """Reads a model, an OBJ's material files and their pictures, and a .gltf's buffers and pictures.

    Names that lead out of the model's folder and below are not followed; they and files that are not there give a
    UserWarning. format: That of the model; its ending unless given. Raises OSError where the model cannot be read.
    """
    model = pathlib.Path(path)
    kind = format or model.suffix[1:].lower()
    content = model.read_bytes()
    files, missing = named_files(model.parent, kind, content)
    if missing:
        warnings.warn(f"{model.name} names files that are not beside it: {', '.join(missing)}", stacklevel=4)
    if not files:
        return PackedModel(content, kind)
    return PackedModel(zipped({**files, model.name: content}), "zip")


def named_files(folder: pathlib.Path, kind: str, content: bytes) -> Tuple[Dict[str, bytes], List[str]]:
    """Returns the referenced files by their relative paths, and the names that cannot be read."""
    files: Dict[str, bytes] = {}
    missing: List[str] = []

    def add(name: str) -> bytes:
        found = read_below(folder, name)
        if found is None:
            missing.append(name)
            return b""
        files[found[0]] = found[1]
        return found[1]

    if kind == "gltf":
        for name in unique(names_in_gltf(content)):
            add(name)
    elif kind == "obj":
        for library in unique(names_in_obj(content)):
            for picture in unique(names_in_mtl(add(library))):
                add(picture)
    return files, missing


def read_below(folder: pathlib.Path, name: str) -> Optional[Tuple[str, bytes]]:
    """Returns the relative path and the bytes of a file, given its name, plain or percent-encoded."""
    for spelling in (name, urllib.parse.unquote(name)):
        path = os.path.normpath(spelling.replace("\\", "/"))
        if os.path.isabs(path) or path.split(os.sep)[0] == "..":
            continue
        try:
            return pathlib.PurePath(path).as_posix(), (folder / path).read_bytes()
        except (OSError, ValueError):
            continue
    return None


def zipped(files: Dict[str, bytes]) -> bytes:
    """Zips files without compression, because pictures would not get smaller."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as target:
        for name, content in files.items():
            target.writestr(name, content)
    return archive.getvalue()


def unique(names: Iterator[str]) -> List[str]:
    return [name for name in dict.fromkeys(names) if name]


def lines_of(content: bytes) -> Iterator[Tuple[str, str]]:
    """Yields the first word of each line, and the rest."""
    for line in content.decode("utf-8", "surrogateescape").splitlines():
        word, _, rest = line.strip().replace("\t", " ").partition(" ")
        yield word, rest.strip()


def names_in_obj(content: bytes) -> Iterator[str]:
    return (rest for word, rest in lines_of(content) if word == "mtllib")


def names_in_mtl(content: bytes) -> Iterator[str]:
    """Returns the names of colour pictures; options come before a name."""
    return (rest.split()[-1] if rest.startswith("-") else rest for word, rest in lines_of(content) if word == "map_Kd")


def names_in_gltf(content: bytes) -> Iterator[str]:
    try:
        root = json.loads(content)
    except ValueError:
        return  # the server reports what is wrong with it
    for kind in ("buffers", "images"):
        entries = root.get(kind) if isinstance(root, dict) else None
        for entry in entries if isinstance(entries, list) else []:
            uri = entry.get("uri") if isinstance(entry, dict) else None
            if isinstance(uri, str) and not uri.startswith("data:"):
                yield uri
