"""Headers of EXR files of one part with scan lines, as pelage-render writes them (OpenEXR File Layout)."""

from __future__ import annotations

import io
import struct
from typing import BinaryIO, Dict, List, NamedTuple, Tuple

# Scan lines in a block, indexed by compression: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
BLOCK_LINES = (1, 1, 1, 16, 32, 16, 32, 32, 32, 256)
REQUIRED = (
    "channels",
    "compression",
    "dataWindow",
    "displayWindow",
    "lineOrder",
    "pixelAspectRatio",
    "screenWindowCenter",
    "screenWindowWidth",
)


class Header(NamedTuple):
    """attributes: Type and value by name. offsets: File offset of each block of lines; 0 if it was not written."""

    attributes: Dict[str, Tuple[bytes, bytes]]
    offsets: List[int]
    width: int
    height: int


def read_header(file: BinaryIO) -> Header:
    """Reads a header; the file is then at the first block. Raises ValueError, IndexError, KeyError or struct.error."""
    file.seek(8)
    attributes: Dict[str, Tuple[bytes, bytes]] = {}
    while True:
        name = read_text(file).decode("latin-1")
        if not name:
            break
        kind = read_text(file)
        (length,) = struct.unpack("<I", file.read(4))
        attributes[name] = (kind, file.read(length))
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"][1])
    count = -(-(bottom - top + 1) // BLOCK_LINES[attributes["compression"][1][0]])
    offsets = list(struct.unpack(f"<{count}Q", file.read(8 * count)))
    return Header(attributes, offsets, right - left + 1, bottom - top + 1)


def read_text(file: BinaryIO) -> bytes:
    text = b""
    while True:
        byte = file.read(1)
        if not byte or len(text) > 255:
            raise ValueError("no end of a text")
        if byte == b"\0":
            return text
        text += byte


def without_extras(content: bytes) -> bytes:
    """Returns the file with only the required attributes, because ffmpeg 5.1 fails after a value above 255 bytes."""
    file = io.BytesIO(content)
    header = read_header(file)
    begin = file.tell()
    start = content[:8]
    for name, (kind, value) in header.attributes.items():
        if name in REQUIRED:
            start += name.encode("latin-1") + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value
    start += b"\0"
    moved = len(start) + 8 * len(header.offsets) - begin
    table = struct.pack(f"<{len(header.offsets)}Q", *(offset + moved for offset in header.offsets))
    return start + table + content[begin:]
