"""Scenes for the tests inside Blender: the awkward ten, and random heaps."""
import math

import bmesh
import bpy
import numpy as np
from mathutils import Euler, Matrix

import support

ADD = bpy.ops.mesh


def new(operator, name, location, rotation=(0, 0, 0), scale=(1, 1, 1), **options):
    operator(location=location, rotation=rotation, **options)
    one = bpy.context.object
    one.name, one.scale = name, scale
    return one


def empty(name, location=(0, 0, 0), rotation=(0, 0, 0), scale=(1, 1, 1)):
    one = bpy.data.objects.new(name, None)
    bpy.context.collection.objects.link(one)
    one.location, one.rotation_euler, one.scale = location, rotation, scale
    bpy.context.view_layer.update()
    return one


def _table_with_bowl():
    new(ADD.primitive_cube_add, "table", (0, 0, 0.7), scale=(0.8, 0.5, 0.03), size=2)
    new(ADD.primitive_cylinder_add, "foot", (0, 0, 0.33), radius=0.25, depth=0.66)
    bowl = new(ADD.primitive_uv_sphere_add, "bowl", (0.35, 0.15, 0.97), radius=0.22, segments=48, ring_count=24)
    mesh = bmesh.new()
    mesh.from_mesh(bowl.data)
    bmesh.ops.delete(mesh, geom=[vertex for vertex in mesh.verts if vertex.co.z > 0.04], context="VERTS")
    mesh.to_mesh(bowl.data)
    mesh.free()
    bowl.modifiers.new("solid", "SOLIDIFY").thickness = 0.01


def _mug():
    """A mug that is selected, with a handle that is not."""
    mug = new(ADD.primitive_cylinder_add, "mug", (0.1, -0.3, 1.2), (0.3, 0.4, 0), radius=0.05, depth=0.12)
    handle = new(ADD.primitive_torus_add, "mug handle", (0.165, -0.3, 1.2), (math.pi / 2, 0, 0), major_radius=0.035,
                 minor_radius=0.008)
    bpy.context.view_layer.update()
    handle.parent = mug
    handle.matrix_parent_inverse = Matrix.Translation((0.1, -0.3, 1.2)).inverted()
    return mug


def _below_turned_empty():
    above = empty("empty (turned, scale 0.5)", (0.1, 0, 0.2), (0.3, 0.2, 0.5), (0.5,) * 3)
    cone = new(ADD.primitive_cone_add, "cone (parented)", (0, 0, 0), radius1=0.12, depth=0.3)
    cone.parent = above
    bpy.context.view_layer.update()
    cone.matrix_world = Matrix.LocRotScale((0.1, 0.05, 1.5), Euler((1, 0.4, 0)), (0.5,) * 3)
    return cone


def _below_unequal_empty():
    above = empty("empty (scale 1 2 0.5)", scale=(1, 2, 0.5))
    cube = new(ADD.primitive_cube_add, "cube (sheared parent)", (0.6, -0.2, 2.6), scale=(0.1, 0.05, 0.2), size=1)
    cube.parent = above
    cube.rotation_euler = (0.5, 0.3, 0)
    return cube


def _lamp():
    """An instanced collection of three meshes, which moves as one."""
    collection = bpy.data.collections.new("lamp")
    for name, operator, options, height in (
            ("base", ADD.primitive_cylinder_add, {"radius": 0.06, "depth": 0.02}, 0.01),
            ("pole", ADD.primitive_cylinder_add, {"radius": 0.01, "depth": 0.2}, 0.12),
            ("shade", ADD.primitive_cone_add, {"radius1": 0.05, "radius2": 0.02, "depth": 0.06}, 0.25)):
        one = new(operator, name, (0, 0, height), **options)
        bpy.context.collection.objects.unlink(one)
        collection.objects.link(one)
    lamp = empty("lamp (collection instance)", (-0.55, 0.25, 1.3), (0.2, 0.1, 0))
    lamp.instance_type, lamp.instance_collection = "COLLECTION", collection
    return lamp


def _text():
    curve = bpy.data.curves.new("text", "FONT")
    curve.body, curve.extrude, curve.size, curve.bevel_depth = "Trivet", 0.02, 0.15, 0.003
    one = bpy.data.objects.new("text", curve)
    bpy.context.collection.objects.link(one)
    one.location, one.rotation_euler = (0.35, -0.25, 1.9), (1.2, 0.2, 0.3)
    return one


def awkward_ten():
    """The ten, selected, in the air above a table with a bowl."""
    support.clear()
    _table_with_bowl()
    monkey = new(ADD.primitive_monkey_add, "monkey (subdivided)", (-0.4, -0.1, 1.4), (0.4, 0.3, 0.2), (0.12,) * 3)
    monkey.modifiers.new("smooth", "SUBSURF").levels = 2
    plank = new(ADD.primitive_cube_add, "plank (scaled)", (-0.1, 0.25, 1.25), (0.5, 0.2, 0.9), (0.25, 0.05, 0.02), size=1)
    apple = new(ADD.primitive_ico_sphere_add, "apple", (0.36, 0.16, 1.3), radius=0.05, subdivisions=3)
    linked = apple.copy()
    linked.name, linked.location = "apple 2 (linked)", (0.33, 0.14, 1.5)
    bpy.context.collection.objects.link(linked)
    stairs = new(ADD.primitive_cube_add, "stairs (mirrored, array)", (-0.2, -0.35, 1.6), (0.1, 0.7, 0.2),
                 (-0.05, 0.06, 0.04), size=1)
    array = stairs.modifiers.new("steps", "ARRAY")
    array.count, array.relative_offset_displace = 4, (1, 0, 1)
    ten = [monkey, plank, _mug(), _below_turned_empty(), _below_unequal_empty(), _lamp(), apple, linked, stairs, _text()]
    support.select(ten)
    return ten


def heap(seed, number=12):
    """Objects of unequal scales, four rotation modes and turned parents, 1 to 100 m from the origin, over a plane."""
    random = np.random.default_rng(seed)
    support.clear()
    far = float(10.0 ** random.integers(0, 3))
    ADD.primitive_plane_add(size=4, location=(far, far, 0.5))
    above = empty("above")
    above.matrix_world = Matrix.LocRotScale(random.normal(size=3) * far, Euler(random.normal(size=3)),
                                            (float(random.uniform(.2, 3)),) * 3)
    kinds = [ADD.primitive_monkey_add, ADD.primitive_cube_add, ADD.primitive_torus_add, ADD.primitive_cone_add]
    objects = []
    for k in range(number):
        kinds[k % 4]()
        one = bpy.context.object
        objects.append(one)
        if k % 3 == 0:
            one.parent = above
        one.rotation_mode = ["XYZ", "QUATERNION", "AXIS_ANGLE", "ZYX"][int(random.integers(4))]
        bpy.context.view_layer.update()
        at = (far + float(random.uniform(-.6, .6)), far + float(random.uniform(-.6, .6)), 1.2 + k * .6)
        scale = random.uniform(.05, .25, 3) if k % 3 else (.15,) * 3
        one.matrix_world = Matrix.LocRotScale(at, Euler(random.uniform(-3, 3, 3)), scale)
    bpy.context.scene.trivet.floor = False
    support.select(objects)
    return objects
