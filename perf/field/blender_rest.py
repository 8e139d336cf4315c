"""Blender's rigid bodies as an engine of the field: blender -b -P blender_rest.py -- SECONDS SCENE.xml

Reads a scene of Trivet's for MuJoCo: each body becomes a compound of its convex parts, with its mass and friction. Blender
places the origin of a rigid body in its centre of mass, so parts are given in a frame there.
"""
import json
import os
import sys
import xml.etree.ElementTree

import bpy
from mathutils import Quaternion, Vector

RATE = 240  # steps in a second
FRAMES = 24  # frames in a second


def numbers(element, name):
    return [float(v) for v in element.get(name).split()]


def read_hull(path):
    with open(path) as file:
        rows = [line.split() for line in file]
    return [[float(v) for v in r[1:4]] for r in rows if r[:1] == ["v"]], \
        [[int(v.split("/")[0]) - 1 for v in r[1:]] for r in rows if r[:1] == ["f"]]


def new_object(name, vertices, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    shown = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(shown)
    return shown


def make_rigid(shown, kind, shape, mass, friction):
    bpy.context.view_layer.objects.active = shown
    bpy.ops.rigidbody.object_add(type=kind)
    body = shown.rigid_body
    body.collision_shape, body.mass, body.friction, body.restitution = shape, mass, friction, 0
    body.use_margin, body.collision_margin, body.use_deactivation = True, 0, False
    return body


def add_body(element, files):
    """The object of a body; its origin is the centre of mass."""
    inertial = element.find("inertial")
    centre, mass = numbers(inertial, "pos"), numbers(inertial, "mass")[0]
    parts = [g for g in element.findall("geom") if g.get("class") == "collision"]
    kind = "ACTIVE" if element.find("freejoint") is not None else "PASSIVE"
    shown = new_object(element.get("name"), [], [])
    rotation = Quaternion(numbers(element, "quat"))
    shown.rotation_mode, shown.rotation_quaternion = "QUATERNION", rotation
    shown.location = Vector(numbers(element, "pos")) + rotation @ Vector(centre)
    friction = numbers(parts[0], "friction")[0]
    for geom in parts:
        vertices, faces = read_hull(files[geom.get("mesh")])
        part = new_object(geom.get("mesh"), [[a - b for a, b in zip(v, centre)] for v in vertices], faces)
        part.parent = shown
        bpy.context.view_layer.update()
        make_rigid(part, "PASSIVE", "CONVEX_HULL", mass / len(parts), friction)
    bpy.context.view_layer.update()
    make_rigid(shown, kind, "COMPOUND", mass, friction)
    return shown, Vector(centre), kind == "ACTIVE"


def main():
    seconds, scene = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.rigidbody.world_add()
    world = bpy.context.scene.rigidbody_world
    world.substeps_per_frame, world.solver_iterations = RATE // FRAMES, 100
    last = round(float(seconds) * FRAMES)
    world.point_cache.frame_end = bpy.context.scene.frame_end = last + 1
    root = xml.etree.ElementTree.parse(scene).getroot()
    folder = os.path.join(os.path.dirname(os.path.abspath(scene)), root.find("compiler").get("meshdir"))
    files = {m.get("name"): os.path.join(folder, m.get("file")) for m in root.find("asset").findall("mesh")}
    floor = new_object("floor", [[50 * x, 50 * y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)],
                       [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]])
    floor.location = Vector((0, 0, -1))
    make_rigid(floor, "PASSIVE", "BOX", 1, 0.5)
    bodies = [add_body(element, files) for element in root.find("worldbody").findall("body")]
    for frame in range(1, last + 2):
        bpy.context.scene.frame_set(frame)
    objects = []
    graph = bpy.context.evaluated_depsgraph_get()
    for shown, centre, free in bodies:
        if free:
            world_from_centre = shown.evaluated_get(graph).matrix_world
            rotation = world_from_centre.to_quaternion()
            position = world_from_centre.translation - rotation @ centre
            objects.append({"name": shown.name, "position": list(position), "rotation": list(rotation)})
    print(json.dumps({"simulator": "Blender " + bpy.app.version_string, "objects": objects}), flush=True)


main()
