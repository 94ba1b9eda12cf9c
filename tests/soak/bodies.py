"""Small files of every kind that the server accepts, to be sent intact or damaged."""
import json
import pathlib
import struct
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from support.pictures import hdr, png  # noqa: E402

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (1, 3, 7, 5), (0, 4, 6, 2)]
TRIANGLES = [(a, b, c) for a, b, c, _ in QUADS] + [(a, c, d) for a, _, c, d in QUADS]


def lines(rows, prefix="", first=0):
    return "".join(prefix + " ".join(str(value + first) for value in row) + "\n" for row in rows)


def obj():
    return (lines(CORNERS, "v ") + lines(QUADS, "f ", 1)).encode()


def off():
    return f"OFF\n8 6 0\n{lines(CORNERS)}{lines([(4, *quad) for quad in QUADS])}".encode()


def ply():
    coordinates = "".join(f"property float {axis}\n" for axis in "xyz")
    head = f"ply\nformat ascii 1.0\nelement vertex 8\n{coordinates}element face 6\nproperty list uchar int vertex_indices\nend_header\n"
    return (head + lines(CORNERS) + lines([(4, *quad) for quad in QUADS])).encode()


def stl():
    faces = b"".join(struct.pack("<12fH", 0, 0, 0, *(value for k in face for value in CORNERS[k]), 0) for face in TRIANGLES)
    return b"a box".ljust(80) + struct.pack("<I", len(TRIANGLES)) + faces


def glb():
    binary = b"".join(struct.pack("<3f", *corner) for corner in CORNERS) + b"".join(struct.pack("<3H", *face) for face in TRIANGLES)
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
                      {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
        "buffers": [{"byteLength": len(binary)}]}).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


MODELS = {"obj": obj(), "off": off(), "ply": ply(), "stl": stl(), "glb": glb()}
PICTURES = [png(numpy.full((4, 4, 3), 90)), hdr(numpy.full((4, 8, 3), 0.5))]
GUIDES = {"json": json.dumps({"curves": [[[0, 0, 1], [0, 0.2, 1.2]], [[1, 0, 0], [1.2, 0.1, 0]]]}).encode()}


def exported(server):
    """Returns guides and a saved scene, written by the server: ({format: bytes}, bytes)."""
    scene = server.new_scene("sphere", 200)
    scene.run({"op": "set_coat", "coat": {"count": 100}})
    guides = {name: server.get(f"{scene.path}/export/{name}?every=10").body for name in ("usda", "hair")}
    saved = server.get(f"{scene.path}/export/pelage").body
    server.call("DELETE", scene.path)
    return {**GUIDES, **guides}, saved
