"""Checks a scene in headless Blender:

    blender -b --factory-startup -P blender_check.py -- SCENE EXPECTED.json [PICTURE.png]

Same objects, names, materials, cameras, lights, and poses to float32 rounding."""
import json
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

scene_file, expected_file, *picture = sys.argv[sys.argv.index("--") + 1:]
with open(expected_file) as file:
    expected = json.load(file)


# Debian 12's Blender uses a numpy name that this numpy has removed.
if not hasattr(numpy, "bool"):
    numpy.bool = bool


def fail(message):
    print("blender_check: " + message)
    sys.exit(1)


def below(thing):
    yield thing
    for child in thing.children:
        yield from below(child)


bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=scene_file)
roots = {o.name: o for o in bpy.context.scene.objects if o.parent is None}
if len(roots) != len(expected):
    fail(f"{len(roots)} objects, not {len(expected)}: {sorted(roots)}")
# Blender converts y up to z up, in positions and in matrices.
turn = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
worst = 0
for want in expected:
    thing = roots.get(want["name"])
    if thing is None:
        fail(f"no object \"{want['name']}\" among {sorted(roots)}")
    parts = list(below(thing))
    materials = sorted({slot.material.name for o in parts for slot in o.material_slots})
    # Materials of the same name are numbered: "china.001".
    bare = sorted({m.rsplit(".", 1)[0] if m[-3:].isdigit() and m[-4:-3] == "." else m for m in materials})
    if bare != want["materials"]:
        fail(f"materials of \"{want['name']}\": {bare}, not {want['materials']}")
    for kind, key in (("CAMERA", "cameras"), ("LIGHT", "lights")):
        found = sum(o.type == kind for o in parts)
        if found != want[key]:
            fail(f"{found} {key} of \"{want['name']}\", not {want[key]}")
    rows = [want["world"][i:i + 4] for i in range(0, 16, 4)]
    pivot = Matrix.Translation(Vector(want["pivot"]))
    found = thing.matrix_world @ turn @ pivot
    size = max(1, *(abs(x) for x in want["pivot"]), *(abs(x) for row in rows for x in row))
    worst = max(worst, max(abs(found[r][c] - rows[r][c]) for r in range(4) for c in range(4)) / size)
if worst > 3e-6:
    fail(f"poses differ by {worst}")
images = [i for i in bpy.data.images if i.type == "IMAGE"]
print(f"{scene_file}: Blender {bpy.app.version_string}: {len(expected)} objects, "
      f"{len(bpy.data.materials)} materials, {len(images)} images; poses differ by {worst:.1e} at most")

if picture:
    scene = bpy.context.scene
    corners = [o.matrix_world @ Vector(c) for o in scene.objects if o.type == "MESH" for c in o.bound_box]
    lower = Vector([min(c[i] for c in corners) for i in range(3)])
    upper = Vector([max(c[i] for c in corners) for i in range(3)])
    centre, size = (lower + upper) / 2, (upper - lower).length
    camera = bpy.data.objects.new("view", bpy.data.cameras.new("view"))
    scene.collection.objects.link(camera)
    camera.location = centre + Vector((0.55, -0.75, 0.6)) * size
    camera.rotation_euler = (centre - camera.location).to_track_quat("-Z", "Y").to_euler()
    camera.data.angle, camera.data.clip_end = 0.75, 10 * size
    scene.camera = camera
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.rotation_euler = 3, (0.6, 0.2, 0.4)
    scene.collection.objects.link(sun)
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.7, 0.8, 1, 1)
    scene.world = world
    scene.render.engine, scene.cycles.samples, scene.cycles.device = "CYCLES", 24, "CPU"
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y = 800, 600
    scene.render.filepath = picture[0]
    bpy.ops.render.render(write_still=True)
