"""Measures how well a groom is transferred to new versions of its model: a cow is groomed and gets each version, and fur is compared
where both versions have the same skin. Run by hand; prints a table, and with FOLDER draws each version beside the original groom.

usage: PELAGE_BIN=build/tests/bin python3 tests/bench/model_versions.py [FOLDER]
"""
import math
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "end_to_end"))
from support.server import Server, shared_folder  # noqa: E402

SAMPLES = 300


class Obj:
    """Positions, texture coordinates and faces of corners (position, texture coordinate), by material."""

    def __init__(self, positions, uvs, faces):
        self.positions, self.uvs, self.faces = numpy.array(positions, float), uvs, faces

    @staticmethod
    def read(path):
        positions, uvs, faces = [], [], []
        for line in path.read_text().splitlines():
            word, *rest = line.split() or [""]
            if word == "v":
                positions.append([float(x) for x in rest[:3]])
            elif word == "vt":
                uvs.append(rest[:2])
            elif word == "f":
                faces.append((None, [tuple(int(n or 0) for n in (corner + "/").split("/")[:2]) for corner in rest]))
        return Obj(positions, uvs, faces)

    def text(self):
        lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in self.positions] + [f"vt {u} {v}" for u, v in self.uvs]
        last = None
        for material, corners in self.faces:
            if material != last:
                lines.append(f"usemtl {material or 'skin'}")
                last = material
            lines.append("f " + " ".join(f"{p}/{t}" if t and self.uvs else str(p) for p, t in corners))
        return "\n".join(lines) + "\n"

    def moved(self, image_of):
        return Obj([image_of(p) for p in self.positions], self.uvs, self.faces)

    def triangulated(self):
        return Obj(self.positions, self.uvs, [(m, [c[0], c[k], c[k + 1]]) for m, c in self.faces for k in range(1, len(c) - 1)])

    def shuffled(self):
        order = numpy.random.default_rng(1).permutation(len(self.positions))
        number = numpy.empty(len(order), int)
        number[order] = numpy.arange(1, len(order) + 1)
        faces = [(m, [(int(number[p - 1]), t) for p, t in c]) for m, c in self.faces[::-1]]
        return Obj(self.positions[order], self.uvs, faces)

    def finer(self):
        """Returns the model with each triangle split in four."""
        positions, middles, faces = list(self.positions), {}, []
        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                positions.append((positions[a - 1] + positions[b - 1]) / 2)
                middles[key] = len(positions)
            return middles[key]
        for m, c in self.triangulated().faces:
            a, b, d = (p for p, _ in c)
            ab, bd, da = middle(a, b), middle(b, d), middle(d, a)
            faces += [(m, [(x, 0) for x in three]) for three in ((a, ab, da), (ab, b, bd), (da, bd, d), (ab, bd, da))]
        return Obj(positions, [], faces)

    def coarser(self, cells=22):
        """Returns the model with all vertices in a grid cell merged into one."""
        low, size = self.positions.min(0), self.positions.max(0) - self.positions.min(0)
        cell = numpy.floor((self.positions - low) / size.max() * cells).astype(int)
        _, number = numpy.unique(cell, axis=0, return_inverse=True)
        number = number.reshape(-1)
        positions = numpy.array([self.positions[number == k].mean(0) for k in range(number.max() + 1)])
        faces = [(m, [(int(number[p - 1]) + 1, 0) for p, _ in c]) for m, c in self.triangulated().faces]
        return Obj(positions, [], [(m, c) for m, c in faces if len({p for p, _ in c}) == 3])

    def without(self, gone):
        return Obj(self.positions, self.uvs, [(m, c) for m, c in self.faces if not any(gone(self.positions[p - 1]) for p, _ in c)])

    def with_horn(self, centre, radius, height):
        """Returns the model with an added cone that has its own material and a closed base."""
        n, first = 12, len(self.positions)
        ring = [centre + radius * numpy.array([math.cos(a), 0, math.sin(a)]) for a in numpy.arange(n) * 2 * math.pi / n]
        positions = [*self.positions, *ring, centre + [0, height, 0], centre]
        tip, base = first + n + 1, first + n + 2
        side = [("horn", [(first + 1 + k, 0), (tip, 0), (first + 1 + (k + 1) % n, 0)]) for k in range(n)]
        below = [("horn", [(first + 1 + k, 0), (first + 1 + (k + 1) % n, 0), (base, 0)]) for k in range(n)]
        return Obj(positions, self.uvs, self.faces + side + below)


def turned(p, pivot, degrees):
    """Rotates about the x axis through the pivot."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    x, y, z = p - pivot
    return pivot + [x, c * y - s * z, s * y + c * z]


def smooth(low, high, x):
    t = min(1, max(0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def versions(cow):
    """Yields for each version: name, file, query, map of positions from the first file (None if it is removed), scale of lengths."""
    same = lambda p: p  # noqa: E731
    neck = numpy.array([0, 0.1, 0.25])
    def nod(p):
        return p + smooth(0.25, 0.55, p[2]) * (turned(p, neck, 12) - p)
    fat = lambda p: p * [1.15, 1, 1]  # noqa: E731
    yield "the same file again", cow, "", same, 1
    yield "vertices and faces in another order", cow.shuffled(), "", same, 1
    yield "each triangle in four", cow.finer(), "", same, 1
    yield "fewer vertices", cow.coarser(), "", same, 1
    yield "centimetres in place of metres", cow.moved(lambda p: 100 * p), "", lambda p: 100 * p, 100
    yield "Z up in place of Y", cow.moved(lambda p: numpy.array([p[0], -p[2], p[1]])), "&up=z&front=-y", same, 1
    yield "moved three units away", cow.moved(lambda p: p + [3, 0, 0]), "", lambda p: p + [3, 0, 0], 1
    yield "head nods 12 degrees", cow.moved(nod), "", nod, 1
    yield "15% wider", cow.moved(fat), "", fat, 1
    yield "a horn with a material of its own", cow.with_horn(numpy.array([0, 0.85, 0.45]), 0.05, 0.3), "", same, 1
    yield "a leg is cut off", cow.without(lambda p: p[1] < -0.35 and p[0] > 0 and p[2] > 0), "", \
        lambda p: None if p[1] < -0.3 and p[0] > -0.05 and p[2] > -0.05 else p, 1
    yield "no texture coordinates", Obj(cow.positions, [], cow.faces), "", same, 1
    yield "mirrored halves", cow.moved(lambda p: p * [-1, 1, 1]).flipped(), "", lambda p: p, 1


def flipped(self):
    return Obj(self.positions, self.uvs, [(m, c[::-1]) for m, c in self.faces])


Obj.flipped = flipped


def groom(scene):
    def along(*points):
        return {"samples": [{"position": list(p), "time": 0.1 * k} for k, p in enumerate(points)]}
    brush = {"radius": 0.12, "strength": 0.9}
    scene.run({"op": "length", "flood": True, "value": 0.05, "brush": {"strength": 1}})
    scene.run({"op": "comb", "brush": brush, "stroke": along([0.35, 0.3, 0.4], [0.35, 0, 0.1], [0.35, -0.2, -0.3])})
    scene.run({"op": "length", "brush": brush, "value": 0.11, "stroke": along([0, 0.6, 0.2], [0, 0.5, -0.2], [0, 0.4, -0.5])})
    scene.run({"op": "paint", "brush": brush, "field": "tip_colour", "colour": "#ffffff", "stroke": along([-0.3, 0.2, 0], [-0.3, 0, -0.3])})
    scene.run({"op": "edit_layer", "action": "add", "name": "lifted"})
    scene.run({"op": "lift", "flood": True, "brush": {"strength": 0.2}, "edit_layer": "lifted"})


def picked(scene, position):
    pick = scene.post("pick", {"nearest": list(position)}).json
    return numpy.array(pick["direction"]) * pick["inclination"], pick["length"] * scene.info()["size"], numpy.array(pick["painted"]["tip_colour"])


def compare(before, after, positions, position_of, length_scale):
    angles, lengths, colours = [], [], []
    for p in positions:
        there = position_of(p)
        if there is None:
            continue
        old, new = picked(before, p), picked(after, there)
        cosine = old[0] @ new[0] / max(1e-12, numpy.linalg.norm(old[0]) * numpy.linalg.norm(new[0]))
        angles.append(math.degrees(math.acos(min(1, max(-1, cosine)))))
        lengths.append(abs(new[1] / length_scale / old[1] - 1))
        colours.append(numpy.abs(new[2] - old[2]).max())
    return numpy.quantile(angles, [0.5, 0.95]), numpy.quantile(lengths, 0.95), numpy.quantile(colours, 0.95)


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None
    cow = Obj.read(shared_folder() / "meshes" / "spot.obj")
    positions = cow.positions[numpy.random.default_rng(7).choice(len(cow.positions), SAMPLES, replace=False)]
    server = Server()
    try:
        print(f"{'version':36} {'align':5} {'far':>12}  turned by, median and 95%   length 95%  colour 95%")
        for k, (name, model, query, position_of, length_scale) in enumerate(versions(cow)):
            scene = server.new_scene("sphere", 500)
            put = f"{scene.path}/model?format=obj"
            assert server.call("PUT", put, cow.text().encode()).status == 200
            groom(scene)
            answer = server.call("PUT", put + query, model.text().encode())
            assert answer.status == 200, answer
            transfer = answer.json["carried"]
            before = type(scene)(server, transfer["before"])
            angle, length, colour = compare(before, scene, positions, position_of, length_scale)
            print(f"{name:36} {transfer['align']:5} {transfer['far']:5} of {transfer['vertices']:5}  {angle[0]:10.2f} {angle[1]:8.2f} degrees"
                  f" {100 * length:9.2f}%  {colour:.3f}", flush=True)
            if folder:
                folder.mkdir(parents=True, exist_ok=True)
                for which, one in (("before", before), ("after", scene)):
                    picture = one.frame(width=480, height=400, quality="interactive", camera={"auto": "three_quarter"})
                    (folder / f"{k:02}-{which}.png").write_bytes(picture.body)
            server.remove_scenes()
    finally:
        server.close()


if __name__ == "__main__":
    main()
