"""The chunks of PNG files, and the texts in them."""

import struct
import zlib


def chunks_of(path):
    """The chunks of a whole PNG; raises where it is none."""
    data, at, chunks = path.read_bytes(), 8, []
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(name + body), path
        chunks.append((name, body))
        at += 12 + length
    assert chunks[-1][0] == b"IEND", path
    return chunks


def texts_of(path):
    return dict(body.decode().split("\0", 1) for name, body in chunks_of(path) if name == b"tEXt")
