"""Renders the scene of bench_peer_scene in Blender Cycles: the same strands, skin, light, environment, camera and fibre.

usage: blender --background --factory-startup --python cycles.py -- FOLDER SAMPLES[,SAMPLES...] [SEED [NAME]]

Writes FOLDER/cycles_N.exr for each number of samples and adds a line to FOLDER/cycles.txt: samples, wall-clock and CPU seconds of
the whole render, including building Cycles' scene and index. With NAME it writes cycles_NAME.exr and no line.

Cycles takes the fibre parameters of Chiang 2016 unchanged: absorption per radius, both roughnesses and the tilt. It takes a
light by its irradiance, pi times what a white matt surface that faces it returns. Coordinates are ours: the camera is given
by its axes, and a uniform environment has no up.
"""
import json
import math
import pathlib
import resource
import sys
import time

import bpy
import mathutils
import numpy


def mesh_object(name, positions, edges, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(positions, edges, faces)
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def strand_points(folder, scene):
    numbers = numpy.fromfile(folder / "strands.bin", numpy.float32).reshape(-1, 7)
    assert len(numbers) == scene["strands"] * scene["points"]
    return numbers


def line_mesh(numbers, points):
    """Makes a mesh of lines from the strands, root first, with radius and sigma_a at each vertex."""
    first = numpy.arange(len(numbers)).reshape(-1, points)[:, :-1].reshape(-1)
    edges = numpy.stack([first, first + 1], axis=1)
    lines = mesh_object("lines", numbers[:, :3].tolist(), edges.tolist(), [])
    radius = lines.data.attributes.new("radius", "FLOAT", "POINT")
    radius.data.foreach_set("value", numpy.ascontiguousarray(numbers[:, 3]))
    sigma = lines.data.attributes.new("sigma_a", "FLOAT_VECTOR", "POINT")
    sigma.data.foreach_set("vector", numpy.ascontiguousarray(numbers[:, 4:]).reshape(-1))
    lines.hide_render = True
    return lines


def grow_hair(lines, material):
    """Turns the lines into hair curves with geometry nodes, because scripts cannot add hair curves in Blender 3.4."""
    group = bpy.data.node_groups.new("hair", "GeometryNodeTree")
    group.inputs.new("NodeSocketGeometry", "Geometry")
    group.outputs.new("NodeSocketGeometry", "Geometry")
    nodes, link = group.nodes, group.links.new
    source = nodes.new("GeometryNodeObjectInfo")
    source.inputs["Object"].default_value = lines
    curve = nodes.new("GeometryNodeMeshToCurve")
    painted = nodes.new("GeometryNodeSetMaterial")
    painted.inputs["Material"].default_value = material
    out = nodes.new("NodeGroupOutput")
    link(source.outputs["Geometry"], curve.inputs["Mesh"])
    link(curve.outputs["Curve"], painted.inputs["Geometry"])
    link(painted.outputs["Geometry"], out.inputs["Geometry"])
    data = bpy.data.hair_curves.new("hair")
    data.materials.append(material)
    hair = bpy.data.objects.new("hair", data)
    bpy.context.scene.collection.objects.link(hair)
    hair.modifiers.new("grow", "NODES").node_group = group


def material_of(name, shader, settings):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    node, out = nodes.new(shader), nodes.new("ShaderNodeOutputMaterial")
    for key, value in settings.items():
        node.inputs[key].default_value = value
    material.node_tree.links.new(node.outputs["BSDF"], out.inputs["Surface"])
    return material, node


def hair_material(fibre):
    material, node = material_of("hair", "ShaderNodeBsdfHairPrincipled", {
        "Roughness": fibre["longitudinal_roughness"], "Radial Roughness": fibre["azimuthal_roughness"],
        "Coat": 0, "IOR": fibre["refractive_index"], "Offset": math.radians(fibre["cuticle_tilt"]),
        "Random Roughness": 0, "Random Color": 0})
    node.parametrization = "ABSORPTION"
    sigma = material.node_tree.nodes.new("ShaderNodeAttribute")
    sigma.attribute_name = "sigma_a"
    material.node_tree.links.new(sigma.outputs["Vector"], node.inputs["Absorption Coefficient"])
    return material


def add_skin(folder, scene):
    content = (folder / "skin.bin").read_bytes()
    split = 12 * scene["vertices"]
    positions = numpy.frombuffer(content[:split], numpy.float32).reshape(-1, 3)
    faces = numpy.frombuffer(content[split:], numpy.uint32).reshape(-1, 3)
    skin = mesh_object("skin", positions.tolist(), [], faces.tolist())
    skin.data.materials.append(material_of("skin", "ShaderNodeBsdfDiffuse", {"Color": (*scene["skin"], 1)})[0])


def place(thing, right, up, back, at):
    thing.matrix_world = mathutils.Matrix([(*row, 1 if i == 3 else 0) for i, row in enumerate((right, up, back, at))]).transposed()


def add_camera(scene):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.clip_start, camera.clip_end = 1e-3, 1e3
    camera.angle = 2 * math.atan(scene["camera"]["tan_half_fov"])
    thing = bpy.data.objects.new("camera", camera)
    axes = scene["camera"]
    place(thing, axes["right"], axes["up"], [-x for x in axes["forward"]], axes["position"])
    bpy.context.scene.collection.objects.link(thing)
    bpy.context.scene.camera = thing


def add_light(scene):
    light = scene["light"]
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy, sun.color = math.pi, light["radiance"]
    sun.angle = 2 * light["half_angle"]
    thing = bpy.data.objects.new("sun", sun)
    thing.rotation_mode = "QUATERNION"
    thing.rotation_quaternion = mathutils.Vector(light["direction"]).to_track_quat("-Z", "Y")
    bpy.context.scene.collection.objects.link(thing)
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (*scene["environment"], 1)
    bpy.context.scene.world = world


def set_render(scene):
    settings = bpy.context.scene
    settings.render.engine = "CYCLES"
    settings.render.resolution_x, settings.render.resolution_y = scene["width"], scene["height"]
    settings.render.resolution_percentage = 100
    settings.render.film_transparent = True
    settings.render.threads_mode, settings.render.threads = "FIXED", 2
    settings.render.use_compositing = settings.render.use_sequencer = False
    settings.view_settings.view_transform = "Raw"
    output = settings.render.image_settings
    output.file_format, output.color_mode, output.color_depth, output.exr_codec = "OPEN_EXR", "RGBA", "32", "ZIP"
    settings.cycles_curves.shape = "RIBBONS"
    cycles = settings.cycles
    cycles.device, cycles.use_denoising, cycles.use_adaptive_sampling, cycles.use_auto_tile = "CPU", False, False, False
    cycles.pixel_filter_type, cycles.filter_width, cycles.blur_glossy = "BOX", 1, 0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    bounces = scene["bounces"] - 1  # Cycles does not count the first scattering event
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces


def cpu_seconds():
    spent = resource.getrusage(resource.RUSAGE_SELF)
    return spent.ru_utime + spent.ru_stime


def render(folder, samples, seed, name):
    settings = bpy.context.scene
    settings.cycles.samples, settings.cycles.seed = samples, seed
    settings.render.filepath = str(folder / f"cycles_{name or samples}.exr")
    wall, cpu = time.monotonic(), cpu_seconds()
    bpy.ops.render.render(write_still=True)
    wall, cpu = time.monotonic() - wall, cpu_seconds() - cpu
    print(f"cycles {samples} samples: wall {wall:.2f} s, CPU {cpu:.2f} s", flush=True)
    if not name:
        with open(folder / "cycles.txt", "a") as times:
            times.write(f"{samples} {wall} {cpu}\n")


def main(arguments):
    folder = pathlib.Path(arguments[0])
    scene = json.loads((folder / "scene.json").read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    grow_hair(line_mesh(strand_points(folder, scene), scene["points"]), hair_material(scene["fibre"]))
    add_skin(folder, scene)
    add_camera(scene)
    add_light(scene)
    set_render(scene)
    seed, name = int(arguments[2]) if len(arguments) > 2 else 0, arguments[3] if len(arguments) > 3 else ""
    for samples in arguments[1].split(","):
        render(folder, int(samples), seed, name)


main(sys.argv[sys.argv.index("--") + 1:])
