"""Things that the tests inside Blender share: the add-on enabled, scenes, and a judge of its own."""
import os
import sys

import addon_utils
import bpy
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ADDON = "trivet_addon"


def arguments():
    return sys.argv[sys.argv.index("--") + 1:]


def enable(zip_file, module_folder, program=""):
    """The add-on as a user installs it, from its zip, with the module of a folder."""
    if module_folder and module_folder not in sys.path:
        sys.path.insert(0, module_folder)  # for the judge, too
    bpy.ops.preferences.addon_install(filepath=zip_file)
    addon_utils.enable(ADDON, default_set=True)
    chosen = bpy.context.preferences.addons[ADDON].preferences
    chosen.folder, chosen.program = module_folder, program
    return chosen


def clear():
    for data in (bpy.data.objects, bpy.data.meshes, bpy.data.curves, bpy.data.metaballs):
        for one in list(data):
            data.remove(one)
    for one in list(bpy.data.collections):
        bpy.data.collections.remove(one)
    bpy.context.scene.trivet.property_unset("clearance")


def select(objects):
    for one in bpy.data.objects:
        one.select_set(False)
    for one in objects:
        one.select_set(True)
    bpy.context.view_layer.objects.active = objects[0] if objects else None
    bpy.context.view_layer.update()


def put(**options):
    return bpy.ops.trivet.put("EXEC_DEFAULT", True, **options)


def shown_bodies(owner_of=lambda one: one):
    """{name: (n, 3) world positions, (m, 3) faces} of all that Blender shows, by its own float32 matrices."""
    out = {}
    for instance in bpy.context.evaluated_depsgraph_get().object_instances:
        shown = (instance.parent if instance.is_instance else instance.object).original
        if not instance.show_self or instance.object.type not in {"MESH", "CURVE", "SURFACE", "META", "FONT"}:
            continue
        mesh = instance.object.to_mesh()
        if mesh and mesh.polygons:
            mesh.calc_loop_triangles()
            points = np.array([vertex.co for vertex in mesh.vertices], np.float64)
            faces = np.array([triangle.vertices for triangle in mesh.loop_triangles], np.int32)
            matrix = np.array(instance.matrix_world, np.float64)
            placed = points @ matrix[:3, :3].T + matrix[:3, 3]
            out.setdefault(owner_of(shown).name, []).append(
                (placed, faces if np.linalg.det(matrix[:3, :3]) > 0 else faces[:, ::-1]))
        instance.object.to_mesh_clear()
    joined = {}
    for name, parts in out.items():
        starts = np.cumsum([0] + [len(points) for points, _ in parts[:-1]])
        joined[name] = (np.concatenate([points for points, _ in parts]),
                        np.concatenate([faces + start for (_, faces), start in zip(parts, starts)]))
    return joined


def scene_of(trivet, bodies, fixed, floor):
    """The scene that Blender shows as one of Trivet, each body about its own middle: to be judged by `check`."""
    names, shapes, poses = [], [], []
    for name, (points, faces) in sorted(bodies.items()):
        middle = np.round(points.mean(axis=0))  # subtracts without an error that matters
        pose = np.eye(4)
        pose[:3, 3] = middle
        names.append(name)
        shapes.append(trivet.Shape(points - middle, faces))
        poses.append(pose)
    return trivet.Scene.from_poses(names, shapes, poses, fixed=[name for name in names if name in fixed], floor=floor,
                                   clearance=bpy.context.scene.trivet.clearance)


def pairs_that_cross(trivet, bodies):
    """Exactly, on the very numbers that Blender shows; the number of pairs judged, and those that cross."""
    shapes, positions = [], []
    for _, (points, faces) in sorted(bodies.items()):
        shape = trivet.Shape(points, faces)
        at = np.empty((len(shape.vertices), 3))
        used = shape.vertex_map >= 0
        at[shape.vertex_map[used]] = points[used]
        shapes.append(shape)
        positions.append(at)
    names = sorted(bodies)
    found = trivet.interpenetrations(shapes, [np.eye(4)] * len(shapes), positions=positions)
    return len(names) * (len(names) - 1) // 2, [(names[one.a], names[one.b]) for one in found]


def matrices():
    """All that an undo has to bring back, to the bit."""
    return {one.name: (tuple(map(tuple, one.matrix_world)), tuple(one.location), tuple(one.scale), one.trivet.role)
            for one in bpy.data.objects}
