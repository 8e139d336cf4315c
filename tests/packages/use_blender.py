"""The extension as installed in Blender: blender -b --factory-startup --python-exit-code 9 -P use_blender.py -- ZIP KIND

From Blender 4.2 on it is installed as an extension, before as an add-on. Puts a monkey by the backend that is found, which has
to be KIND, "MODULE" or "PROGRAM"; prints which, and where it lies.
"""
import importlib
import os
import sys

import addon_utils
import bpy

ADDON = "trivet_addon"
ZIP, KIND = sys.argv[sys.argv.index("--") + 1:]

if bpy.app.version >= (4, 2, 0):
    ADDON = "bl_ext.user_default." + ADDON
    bpy.ops.extensions.package_install_files(filepath=os.path.abspath(ZIP), repo="user_default", enable_on_install=True)
else:
    bpy.ops.preferences.addon_install(filepath=os.path.abspath(ZIP))  # Blender asks for its folder
    addon_utils.enable(ADDON, default_set=True)
memory, preferences = (importlib.import_module(f"{ADDON}.{name}") for name in ("memory", "preferences"))
print("Blender:", bpy.app.version_string, "|", ADDON)

backend = preferences.find_backend(preferences.of(bpy.context))
print("backend:", backend.text, "|", backend.note)
assert backend.kind == KIND, backend
assert (KIND == "PROGRAM") == ("does not load" in backend.note), backend.note

for one in list(bpy.data.objects):
    bpy.data.objects.remove(one)
bpy.ops.mesh.primitive_plane_add(size=4)
bpy.ops.mesh.primitive_monkey_add(location=(0, 0, 3), rotation=(0.3, 0.2, 0.1))
monkey = bpy.context.object
for one in bpy.data.objects:
    one.select_set(one == monkey)
assert bpy.ops.trivet.put("EXEC_DEFAULT", True) == {"FINISHED"}
assert monkey.name in memory.last.done and not memory.last.refused, memory.last.refused
assert bpy.ops.trivet.check("EXEC_DEFAULT", True) == {"FINISHED"}
bpy.context.view_layer.update()
lowest = min((monkey.matrix_world @ vertex.co).z for vertex in monkey.data.vertices)
assert 0 < lowest < 1e-3, lowest
print("put:", list(monkey.matrix_world.to_translation()))

# Each operator once, judged by Check.
RUN = ("EXEC_DEFAULT", True)
bpy.ops.mesh.primitive_cube_add(size=0.3, location=(1.2, 1.2, 1))
cube = bpy.context.object
bpy.ops.mesh.primitive_cube_add(size=0.1, location=(1.2, 1.2, 1.5))
cap = bpy.context.object


def select(*objects):
    for one in bpy.data.objects:
        one.select_set(one in objects)
    bpy.context.view_layer.objects.active = objects[0]


select(cube, cap)
apart = cap.location.z - cube.location.z
assert bpy.ops.trivet.put_here(*RUN, point=(1.2, 1.2, 0), turn=0.4, as_one=True) == {"FINISHED"}
assert abs(cap.matrix_world.translation.z - cube.matrix_world.translation.z - apart) < 1e-5
select(cap)
assert bpy.ops.trivet.put_here(*RUN, point=(-1.2, 1.2, 0), way=1) == {"FINISHED"}
assert bpy.ops.trivet.paint(*RUN, path="[[-1.5, -1.5, 0], [-0.5, -1.5, 0]]", spacing=0.19) == {"FINISHED"}
assert len(memory.last.done) == 6, memory.last
select(cube, cap)
assert bpy.ops.trivet.scatter(*RUN, number=3, pile=True) == {"FINISHED"}
select(cap)
assert bpy.ops.trivet.push(*RUN, by=(0.1, 0)) == {"FINISHED"}
assert bpy.ops.trivet.check(*RUN) == {"FINISHED"}
assert not memory.last.crossings and not memory.last.verdict.not_at_rest, memory.last
print("operators: all")
