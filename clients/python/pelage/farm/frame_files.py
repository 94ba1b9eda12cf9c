"""Checks that a frame's file is complete and reads its metadata, from headers and lengths, without decoding pixels."""

from __future__ import annotations

import os
import stat
import struct
from typing import BinaryIO, NamedTuple

from .exr import read_header

FINGERPRINT = "pelage/fingerprint"


class ShortFile(Exception):
    """The file is truncated or not a picture."""


class FrameFile(NamedTuple):
    """fingerprint: Hash of scene, frame, settings and version, written by pelage-render; "" if there is none."""

    width: int
    height: int
    fingerprint: str


def inspect(path: str) -> FrameFile:
    """Inspects a complete PNG or EXR file. Raises ShortFile if it is not, and OSError."""
    if not stat.S_ISREG(os.stat(path).st_mode):  # opening a pipe would block
        raise ShortFile("it is a folder, a pipe or a device")
    with open(path, "rb") as file:
        start = file.read(8)
        size = os.fstat(file.fileno()).st_size
        try:
            if start == b"\x89PNG\r\n\x1a\n":
                return inspect_png(file, size)
            if start[:4] == b"\x76\x2f\x31\x01":
                return inspect_exr(file, size)
        except (struct.error, LookupError, ValueError) as error:
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
    header = read_header(file)
    end = 0
    if min(header.offsets) > 0:
        file.seek(max(header.offsets) + 4)
        end = max(header.offsets) + 8 + struct.unpack("<I", file.read(4))[0]
    if not 0 < end <= size:
        raise ShortFile(f"it ends after {size} bytes, inside of its data")
    return FrameFile(header.width, header.height, header.attributes.get(FINGERPRINT, (b"", b""))[1].decode("latin-1"))
