"""The extension as installed in Blender: blender -b --factory-startup --python-exit-code 9 -P use_blender.py -- ZIP KIND

Puts a monkey by the backend that is found, which has to be KIND, "MODULE" or "PROGRAM"; prints which, and where it lies.
"""
import os
import sys

import addon_utils
import bpy

ADDON = "trivet_addon"
ZIP, KIND = sys.argv[sys.argv.index("--") + 1:]

bpy.ops.preferences.addon_install(filepath=os.path.abspath(ZIP))  # Blender asks for its folder
addon_utils.enable(ADDON, default_set=True)
from trivet_addon import memory, preferences  # noqa: E402

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
