"""Models as Blender reads them: blender -b --factory-startup --python blender_reader.py -- PATHS OUT. PATHS has a path a line; OUT gets a
line of JSON for each: triangles, area, volume and box of the scene, or the error.
"""
import json
import os
import sys

import bpy

OPERATORS = {".fbx": "import_scene.fbx", ".dae": "wm.collada_import", ".gltf": "import_scene.gltf", ".glb": "import_scene.gltf",
             ".x3d": "import_scene.x3d", ".ply": "import_mesh.ply", ".stl": "import_mesh.stl", ".obj": "wm.obj_import"}


def load(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    group, name = OPERATORS[os.path.splitext(path)[1].lower()].split(".")
    if "FINISHED" not in getattr(getattr(bpy.ops, group), name)(filepath=path):
        raise ValueError("refused")


def measured():
    out = {"triangles": 0, "area": 0.0, "volume": 0.0, "lower": [1e300] * 3, "upper": [-1e300] * 3}
    for instance in bpy.context.evaluated_depsgraph_get().object_instances:
        if instance.object.type == "MESH":
            add(instance.object.data, instance.matrix_world, out)
    return out


def add(mesh, world, out):
    points = [world @ v.co for v in mesh.vertices]
    mesh.calc_loop_triangles()
    for triangle in mesh.loop_triangles:
        a, b, c = (points[i] for i in triangle.vertices)
        normal = (b - a).cross(c - a)
        out["triangles"] += 1
        out["area"] += normal.length / 2
        out["volume"] += normal.dot(a) / 6
        for p in (a, b, c):
            out["lower"] = [min(x, y) for x, y in zip(out["lower"], p)]
            out["upper"] = [max(x, y) for x, y in zip(out["upper"], p)]


def main():
    paths, answers = sys.argv[sys.argv.index("--") + 1:]
    with open(paths) as given, open(answers, "w") as out:
        for path in given.read().splitlines():
            try:
                load(path)
                found = measured()
            except Exception as error:  # of add-ons that trust their files
                found = {"error": str(error).strip().splitlines()[-1] if str(error).strip() else type(error).__name__}
            print(json.dumps({"reader": "Blender", "file": path, **found}), file=out, flush=True)


main()
