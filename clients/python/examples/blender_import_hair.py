"""Reads what to_blender.py has written into Blender, and renders it by Cycles on the CPU.

    blender -b -P blender_import_hair.py -- FOLDER                       # FOLDER/cycles.png
    blender -b -P blender_import_hair.py -- FOLDER --save fur.blend      # and a file to go on with

For Blender 3.4, and runs inside of it. FOLDER has fur.hair (strands), skin.glb (the model) and scene.json (camera, light).
Strands become poly curves with a radius and a colour at each point: a mesh of edges, which geometry nodes turn into curves,
takes seconds where as many splines take minutes. Blender's z points up: y of the model becomes z, and z becomes -y.
"""

from __future__ import annotations

import argparse
import json
import math
import pathlib
import struct
import sys
from typing import Any, Dict, NamedTuple

import bpy
import mathutils
import numpy

UPRIGHT = mathutils.Matrix.Rotation(math.pi / 2, 4, "X")  # from y up to z up


class Strands(NamedTuple):
    """counts: Number of points of each strand. positions, radii, colours: One entry per point; colours are linear."""

    counts: Any
    positions: Any
    radii: Any
    colours: Any


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="blender_import_hair.py")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--save", type=pathlib.Path)
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])


def read_hair(content: bytes) -> Strands:
    """Parses a HAIR file with the arrays that Pelage writes: segments, points, thickness and colours."""
    magic, strands, points, arrays = struct.unpack_from("<4sIII", content)
    if magic != b"HAIR" or arrays != 1 | 2 | 4 | 16:
        raise ValueError("this is no HAIR file of Pelage")
    segments = numpy.frombuffer(content, "<u2", strands, 128)
    numbers = numpy.frombuffer(content, "<f4", 7 * points, 128 + 2 * strands)
    positions, thickness, colours = numpy.split(numbers, (3 * points, 4 * points))
    return Strands(segments.astype(int) + 1, positions.reshape(-1, 3), thickness / 2, colours.reshape(-1, 3))


def mesh_of(strands: Strands) -> bpy.types.Mesh:
    """Returns a mesh with a vertex for each point and edges along the strands."""
    first = numpy.arange(len(strands.positions) - 1)
    inside = numpy.ones(len(first), bool)
    inside[numpy.cumsum(strands.counts)[:-1] - 1] = False  # from the tip of one strand to the root of the next
    edges = numpy.stack([first, first + 1], axis=1)[inside]
    mesh = bpy.data.meshes.new("fur")
    mesh.vertices.add(len(strands.positions))
    mesh.vertices.foreach_set("co", strands.positions.ravel())
    mesh.edges.add(len(edges))
    mesh.edges.foreach_set("vertices", edges.astype(numpy.int32).ravel())
    mesh.attributes.new("strand_radius", "FLOAT", "POINT").data.foreach_set("value", strands.radii)
    mesh.attributes.new("strand_colour", "FLOAT_VECTOR", "POINT").data.foreach_set("vector", strands.colours.ravel())
    mesh.update()
    return mesh


def curves_of_edges(edges: bpy.types.Object, material: bpy.types.Material) -> bpy.types.NodeTree:
    """Returns geometry nodes that turn the edges of another object into curves with radius and material."""
    group = bpy.data.node_groups.new("strands", "GeometryNodeTree")
    group.inputs.new("NodeSocketGeometry", "Geometry")
    group.outputs.new("NodeSocketGeometry", "Geometry")
    source, curves, radii, materials, output = (group.nodes.new(kind) for kind in (
        "GeometryNodeObjectInfo", "GeometryNodeMeshToCurve", "GeometryNodeSetCurveRadius", "GeometryNodeSetMaterial",
        "NodeGroupOutput"))
    group.links.new(source.outputs["Geometry"], curves.inputs[0])
    for before, after in ((curves, radii), (radii, materials), (materials, output)):
        group.links.new(before.outputs[0], after.inputs[0])
    radius = group.nodes.new("GeometryNodeInputNamedAttribute")
    radius.data_type = "FLOAT"
    radius.inputs["Name"].default_value = "strand_radius"
    group.links.new(radius.outputs["Attribute"], radii.inputs["Radius"])
    source.inputs["Object"].default_value = edges
    materials.inputs["Material"].default_value = material
    return group


def fur_material() -> bpy.types.Material:
    """Returns a material with the colour of each point. Principled Hair transmits more light and is paler and noisier."""
    material = bpy.data.materials.new("fur")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    colour = tree.nodes.new("ShaderNodeAttribute")
    colour.attribute_name = "strand_colour"
    hair = tree.nodes.new("ShaderNodeBsdfPrincipled")
    hair.inputs["Roughness"].default_value, hair.inputs["Specular"].default_value = 0.5, 0.2
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(colour.outputs["Vector"], hair.inputs["Base Color"])
    tree.links.new(hair.outputs["BSDF"], output.inputs["Surface"])
    return material


def add_fur(strands: Strands) -> None:
    """Adds the fur as a hair object, because Cycles draws curves of hair objects only, not those made from a mesh."""
    edges = bpy.data.objects.new("fur edges", mesh_of(strands))
    fur = bpy.data.objects.new("fur", bpy.data.hair_curves.new("fur"))
    fur.matrix_world = UPRIGHT
    fur.modifiers.new("strands", "NODES").node_group = curves_of_edges(edges, fur_material())
    bpy.context.collection.objects.link(fur)


def read_skin(content: bytes) -> bpy.types.Mesh:
    """Reads the mesh that the server sends as glTF: positions, normals, triangles.

    Blender 3.4's own importer fails with NumPy 1.24 and newer, which Debian 12 has.
    """
    length = struct.unpack_from("<I", content, 12)[0]
    about = json.loads(content[20 : 20 + length])
    vertices, corners = (about["accessors"][k]["count"] for k in (0, 2))
    kind = "<u2" if about["accessors"][2]["componentType"] == 5123 else "<u4"
    start = 28 + length
    positions = numpy.frombuffer(content, "<f4", 3 * vertices, start).reshape(-1, 3) + about["nodes"][0]["translation"]
    triangles = numpy.frombuffer(content, kind, corners, start + about["bufferViews"][2]["byteOffset"]).reshape(-1, 3)
    mesh = bpy.data.meshes.new("skin")
    mesh.from_pydata(positions.tolist(), [], triangles.tolist())
    mesh.polygons.foreach_set("use_smooth", numpy.ones(len(mesh.polygons), bool))
    return mesh


def add_skin(content: bytes, colour: Any) -> None:
    material = bpy.data.materials.new("skin")
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (*colour, 1)
    surface.inputs["Roughness"].default_value, surface.inputs["Specular"].default_value = 0.9, 0
    skin = bpy.data.objects.new("skin", read_skin(content))
    skin.data.materials.append(material)
    skin.matrix_world = UPRIGHT
    bpy.context.collection.objects.link(skin)


def add_camera(camera: Dict[str, Any]) -> None:
    made = bpy.data.cameras.new("camera")
    made.sensor_fit = "VERTICAL"
    made.angle = math.radians(camera["fov_degrees"])
    made.clip_start, made.clip_end = 1e-3, 1e6
    scene = bpy.context.scene
    scene.camera = bpy.data.objects.new("camera", made)
    scene.collection.objects.link(scene.camera)
    position, target = (UPRIGHT @ mathutils.Vector(camera[name]) for name in ("position", "target"))
    scene.camera.location = position
    scene.camera.rotation_euler = (target - position).to_track_quat("-Z", "Y").to_euler()


def add_light(lights: Any, ambient: float) -> None:
    """Adds suns and a uniform sky. A sun of strength pi equals a light of intensity 1."""
    for light in lights:
        sun = bpy.data.lights.new("sun", "SUN")
        sun.energy, sun.color = math.pi * light["intensity"], light["colour"]
        sun.angle = 2 * math.radians(light["angle_degrees"])
        shining = bpy.data.objects.new("sun", sun)
        shining.rotation_euler = (UPRIGHT @ mathutils.Vector(light["direction"])).to_track_quat("-Z", "Y").to_euler()
        bpy.context.collection.objects.link(shining)
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (ambient, ambient, ambient, 1)
    bpy.context.scene.world = world


def render(path: pathlib.Path, size: int, samples: int) -> None:
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", samples, False
    scene.cycles_curves.shape = "RIBBONS"
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.resolution_percentage = 100
    scene.render.film_transparent = True
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = str(path.resolve())
    bpy.ops.render.render(write_still=True)


def main() -> None:
    args = arguments()
    about = json.loads((args.folder / "scene.json").read_text(encoding="utf-8"))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    add_skin((args.folder / "skin.glb").read_bytes(), about["skin"])
    add_fur(read_hair((args.folder / "fur.hair").read_bytes()))
    add_camera(about["camera"])
    add_light(about["lights"], about["ambient"])
    if args.save:
        bpy.ops.wm.save_as_mainfile(filepath=str(args.save.resolve()))
    render(args.folder / "cycles.png", about["size"], args.samples)


main()
