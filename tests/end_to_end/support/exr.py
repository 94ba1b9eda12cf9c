"""Reads the EXR that frames come as: oiiotool undoes the compression, the rest is plain."""

import pathlib
import struct
import subprocess
import tempfile

import numpy


def attributes_of(content):
    """The header's attributes as bytes, and where it ends."""
    found, at = {}, 8
    while content[at] != 0:
        name, kind = (content[at:].split(b"\0", 2)[k].decode() for k in (0, 1))
        at += len(name) + len(kind) + 2
        size = struct.unpack_from("<i", content, at)[0]
        found[name] = content[at + 4:at + 4 + size]
        at += 4 + size
    return found, at + 1


def channels_in(attribute):
    """Names of channels; each is followed by its type and 12 bytes more."""
    names, at = [], 0
    while attribute[at] != 0:
        end = attribute.index(b"\0", at)
        names.append(attribute[at:end].decode())
        assert struct.unpack_from("<i", attribute, end + 1)[0] == 2, "32-bit float"
        at = end + 17
    return names


def read_exr(content):
    """Channels by name, rows x columns each."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = pathlib.Path(folder) / "frame.exr", pathlib.Path(folder) / "plain.exr"
        source.write_bytes(content)
        subprocess.run(["oiiotool", source, "-d", "float", "--compression", "none", "-o", target], check=True)
        plain = target.read_bytes()
    attributes, at = attributes_of(plain)
    names = channels_in(attributes["channels"])
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    columns, rows = right - left + 1, bottom - top + 1
    line = numpy.dtype([("y", "<i4"), ("size", "<i4"), ("values", "<f4", (len(names), columns))])
    lines = numpy.frombuffer(plain, dtype=line, count=rows, offset=at + 8 * rows)  # after the table of offsets
    return {name: lines["values"][:, k].astype(float) for k, name in enumerate(names)}
