"""Whether a frame's file is whole, and what it says about itself. Reads headers and lengths, decodes no pixel."""

from __future__ import annotations

import os
import struct
from typing import BinaryIO, Dict, NamedTuple

FINGERPRINT = "pelage/fingerprint"
# Lines in a block of EXR, by its compression: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
EXR_BLOCK_LINES = (1, 1, 1, 16, 32, 16, 32, 32, 32, 256)


class ShortFile(Exception):
    """The file ends too early, or is no picture."""


class FrameFile(NamedTuple):
    """fingerprint: Of scene, frame, settings and version, as pelage-render writes it; "" where there is none."""

    width: int
    height: int
    fingerprint: str


def inspect(path: str) -> FrameFile:
    """Of a whole PNG or EXR file. Raises ShortFile, and OSError."""
    with open(path, "rb") as file:
        start = file.read(8)
        size = os.fstat(file.fileno()).st_size
        try:
            if start == b"\x89PNG\r\n\x1a\n":
                return inspect_png(file, size)
            if start[:4] == b"\x76\x2f\x31\x01":
                return inspect_exr(file, size)
        except (struct.error, IndexError, ValueError) as error:
            raise ShortFile("it ends inside of its header") from error
    raise ShortFile("it is empty" if not size else "it is neither PNG nor EXR")


def inspect_png(file: BinaryIO, size: int) -> FrameFile:
    width = height = 0
    fingerprint = ""
    position = 8
    while True:
        file.seek(position)
        length, kind = struct.unpack(">I4s", file.read(8))
        position += 12 + length
        if position > size:
            raise ShortFile(f"it ends after {size} bytes, inside of its data")
        if kind == b"IHDR":
            width, height = struct.unpack(">II", file.read(8))
        elif kind in (b"tEXt", b"iTXt"):
            key, _, value = file.read(length).partition(b"\0")
            if key == FINGERPRINT.encode():
                fingerprint = value.rpartition(b"\0")[2].decode("latin-1")
        elif kind == b"IEND":
            return FrameFile(width, height, fingerprint)


def inspect_exr(file: BinaryIO, size: int) -> FrameFile:
    """Of one part with scan lines, as pelage-render writes it."""
    attributes = exr_attributes(file)
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    lines = EXR_BLOCK_LINES[attributes["compression"][0]]
    count = -(-(bottom - top + 1) // lines)
    offsets = struct.unpack(f"<{count}Q", file.read(8 * count))
    end = 0
    if min(offsets) > 0:
        file.seek(max(offsets) + 4)
        end = max(offsets) + 8 + struct.unpack("<I", file.read(4))[0]
    if not 0 < end <= size:
        raise ShortFile(f"it ends after {size} bytes, inside of its data")
    return FrameFile(right - left + 1, bottom - top + 1, attributes.get(FINGERPRINT, b"").decode("latin-1"))


def exr_attributes(file: BinaryIO) -> Dict[str, bytes]:
    """The header, by name; leaves the file at the table of offsets."""
    file.seek(8)
    attributes: Dict[str, bytes] = {}
    while True:
        name = text_of(file)
        if not name:
            return attributes
        text_of(file)  # the type
        (length,) = struct.unpack("<I", file.read(4))
        attributes[name] = file.read(length)


def text_of(file: BinaryIO) -> str:
    text = b""
    while True:
        byte = file.read(1)
        if not byte or len(text) > 255:
            raise ValueError("no end of a text")
        if byte == b"\0":
            return text.decode("latin-1")
        text += byte
