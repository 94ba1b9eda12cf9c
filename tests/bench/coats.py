"""Draws a lion and a terrier with four coats each in every tier, reads each exported file back, and measures how far roots lie from
their mesh.

Run by hand: coats.py FOLDER, from tests/bench, with PELAGE_BIN. It writes a picture of each animal in each tier.
"""

import json
import pathlib
import re
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "end_to_end"))
from support.server import Server  # noqa: E402

REPOSITORY = pathlib.Path(__file__).parents[2]
TIERS = ("draft", "interactive", "detailed", "reference")


def numbers(text, declaration):
    found = re.search(re.escape(declaration) + r" = \[(.*?)\](?: \(|\n)", text, re.DOTALL)
    return numpy.fromstring(re.sub(r"[(),]", " ", found[1]), sep=" ")


def distances(points, triangles):
    """Distance of each point to the nearest triangle."""
    best = numpy.full(len(points), numpy.inf)
    for a, b, c in triangles:
        u, v, w = b - a, c - a, points - a
        uu, uv, vv = u @ u, u @ v, v @ v
        s, t = numpy.linalg.solve([[uu, uv], [uv, vv]], [w @ u, w @ v]) if uu * vv - uv * uv > 1e-20 else (numpy.zeros(len(w)),) * 2
        inside = (s >= 0) & (t >= 0) & (s + t <= 1)
        flat = numpy.linalg.norm(w - numpy.outer(s, u) - numpy.outer(t, v), axis=1)
        best = numpy.where(inside, numpy.minimum(best, flat), best)
        for start, along in ((a, u), (a, v), (b, c - b)):
            share = numpy.clip((points - start) @ along / max(along @ along, 1e-30), 0, 1)
            best = numpy.minimum(best, numpy.linalg.norm(points - start - numpy.outer(share, along), axis=1))
    return best


def groomed(server, name):
    scene = server.new_scene("creature", 8000)
    text = (REPOSITORY / "clients" / "recipes" / f"{name}.json").read_text()
    steps = server.post(f"{scene.path}/recipe", {"recipe": json.loads(text)}).json["steps"]
    for step in steps:
        answer = server.post(f"{scene.path}/commands", {"commands": step["commands"]})
        assert answer.status == 200, answer
    return scene


def roots_off_the_skin(server, scene):
    """By coat: number of strands, and the largest distance of a root from the mesh in the file, in sizes."""
    text = server.get(f"{scene.path}/export/usda?skin=true&every=40", timeout=600).body.decode()
    fur, skin = text.split('def Mesh "skin"')
    counts = numbers(fur, "int[] curveVertexCounts").astype(int)
    points = numbers(fur, "point3f[] points").reshape(-1, 3)
    roots = points[numpy.cumsum(counts) - counts]
    groups = numbers(fur, "int[] primvars:groom_group_id").astype(int)
    names = re.search(r"groom_group_name = \[(.*?)\]", fur)[1].split(", ")
    positions = numbers(skin, "point3f[] points").reshape(-1, 3)
    triangles = positions[numbers(skin, "int[] faceVertexIndices").astype(int).reshape(-1, 3)]
    off = distances(roots, triangles) / scene.info()["size"]
    return {names[int(numpy.argmax(groups == group))]: (int((groups == group).sum()), float(off[groups == group].max())) for group in numpy.unique(groups)}


def main(folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    server = Server(gl="none")
    try:
        for name in ("lion", "terrier"):
            scene = groomed(server, name)
            print(name, ", ".join(coat["name"] for coat in scene.info()["coats"]))
            for tier in TIERS:
                frame = {"width": 720, "height": 720, "camera": {"auto": "three_quarter"}, "quality": tier, "format": "png"}
                if tier == "reference":
                    frame["quality"] = {"method": "strands", "trace": {"passes": 16}}
                answer = server.post(f"{scene.path}/frames", frame, timeout=600)
                assert answer.status == 200, answer
                (folder / f"{name}-{tier}.png").write_bytes(answer.body)
                print(f"  {tier}: {answer.headers.get('server-timing')}")
            for coat, (strands, off) in roots_off_the_skin(server, scene).items():
                print(f"  {coat}: {strands} strands of one in 40, roots at most {off:.2e} sizes from the skin")
    finally:
        server.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
