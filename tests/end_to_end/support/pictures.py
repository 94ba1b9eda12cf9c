"""Small files of pictures, written byte by byte."""

import io
import struct

import numpy
from PIL import Image


def hdr(pixels):
    """Radiance HDR, without runs. `pixels`: rows x columns x 3, 0 or more."""
    pixels = numpy.asarray(pixels, dtype=float)
    rows, columns, _ = pixels.shape
    largest = pixels.max(axis=2)
    mantissa, exponent = numpy.frexp(largest)
    scale = numpy.where(largest > 1e-32, mantissa * 256 / numpy.maximum(largest, 1e-32), 0)
    content = numpy.concatenate([pixels * scale[..., None], numpy.where(largest > 1e-32, exponent + 128, 0)[..., None]], axis=2)
    return f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {rows} +X {columns}\n".encode() + content.astype(numpy.uint8).tobytes()


def exr(pixels, *, header_size=None):
    """OpenEXR, 32 bit, not compressed. `header_size` (columns, rows) lies about the size."""
    pixels = numpy.asarray(pixels, dtype="<f4")
    rows, columns, _ = pixels.shape
    said_columns, said_rows = header_size or (columns, rows)
    window = struct.pack("<4i", 0, 0, said_columns - 1, said_rows - 1)
    channels = b"".join(name + b"\0" + struct.pack("<i4xii", 2, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    header = struct.pack("<ii", 20000630, 2)
    for name, kind, value in ((b"channels", b"chlist", channels), (b"compression", b"compression", b"\0"),
                              (b"dataWindow", b"box2i", window), (b"displayWindow", b"box2i", window),
                              (b"lineOrder", b"lineOrder", b"\0"), (b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
                              (b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)),
                              (b"screenWindowWidth", b"float", struct.pack("<f", 1))):
        header += name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value
    header += b"\0"
    lines = [struct.pack("<ii", y, 12 * columns) + row[:, ::-1].T.tobytes() for y, row in enumerate(pixels)]
    offsets, at = [], len(header) + 8 * rows
    for line in lines:
        offsets.append(at)
        at += len(line)
    return header + struct.pack(f"<{rows}Q", *offsets) + b"".join(lines)


def png(pixels):
    """8 bits. `pixels`: rows x columns x 3 or 4."""
    file = io.BytesIO()
    Image.fromarray(numpy.asarray(pixels, dtype=numpy.uint8)).save(file, "PNG")
    return file.getvalue()
