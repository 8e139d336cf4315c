"""Blender's cloth over fixed meshes: crossings, motion that is left, processor time. Run by drape_blender.py.

blender -b --factory-startup -P cloth.py -- FRAMES CELLS_U CELLS_V LENGTH_U LENGTH_V X Y Z THICKNESS MESH.obj ...
Prints a line of JSON. The cloth has the settings that Blender gives to a new one, but for its distances.
"""
import json
import sys
import time

import bpy
from mathutils import bvhtree


def read(path):
    vertices, faces = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.startswith("v "):
                vertices.append(tuple(map(float, line.split()[1:4])))
            elif line.startswith("f "):
                faces.append(tuple(int(word) - 1 for word in line.split()[1:]))
    return vertices, faces


def grid(cells, lengths, at):
    """As Trivet's sheets: diagonals in both directions in turn."""
    (nu, nv), vertices, faces = cells, [], []
    for j in range(nv + 1):
        for i in range(nu + 1):
            vertices.append((at[0] + lengths[0] * (i / nu - .5), at[1] + lengths[1] * (j / nv - .5), at[2]))
    for j in range(nv):
        for i in range(nu):
            a = j * (nu + 1) + i
            b, c, d = a + 1, a + nu + 1, a + nu + 2
            faces += [(a, b, d), (a, d, c)] if (i + j) % 2 == 0 else [(a, b, c), (b, d, c)]
    return vertices, faces


def add(name, vertices, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    mesh.update()
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    return thing


def positions(cloth):
    evaluated = cloth.evaluated_get(bpy.context.evaluated_depsgraph_get())
    out = [tuple(v.co) for v in evaluated.to_mesh().vertices]
    evaluated.to_mesh_clear()
    return out


def main():
    words = sys.argv[sys.argv.index("--") + 1:]
    frames, cells = int(words[0]), (int(words[1]), int(words[2]))
    lengths, at, thickness = tuple(map(float, words[3:5])), tuple(map(float, words[5:8])), float(words[8])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    fixed = [read(path) for path in words[9:]]
    for vertices, faces in fixed:
        obstacle = add("fixed", vertices, faces)
        obstacle.modifiers.new("collision", "COLLISION")
        obstacle.collision.thickness_outer = thickness
        obstacle.collision.use_culling = False
    faces = grid(cells, lengths, at)[1]
    cloth = add("cloth", *grid(cells, lengths, at))
    modifier = cloth.modifiers.new("cloth", "CLOTH")
    collisions = modifier.collision_settings
    collisions.use_self_collision = True
    collisions.distance_min = collisions.self_distance_min = thickness
    scene.frame_start, scene.frame_end = 1, frames
    modifier.point_cache.frame_end = frames
    start, before, now = time.process_time(), None, None
    for frame in range(1, frames + 1):
        scene.frame_set(frame)
        if frame >= frames - 1:
            before, now = now, positions(cloth)
    seconds = time.process_time() - start
    own = bvhtree.BVHTree.FromPolygons(now, faces)
    through = sum(len(own.overlap(bvhtree.BVHTree.FromPolygons(*mesh))) for mesh in fixed)
    itself = sum(a < b and not set(faces[a]) & set(faces[b]) for a, b in own.overlap(own))
    moved = max(sum((a - b) ** 2 for a, b in zip(p, q)) ** .5 for p, q in zip(before, now))
    print("RESULT", json.dumps({
        "cpu s": seconds, "crossing others": through, "crossing itself": itself,
        "mm a frame": 1000 * moved, "lowest m": min(p[2] for p in now)}), flush=True)


main()
