"""Faces that interpenetrate, drawn over the view after Check until something moves.

Which objects interpenetrate is judged exactly; which faces are drawn comes from Blender's own trees, in float32.
"""

from __future__ import annotations

from typing import Iterable

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader
from mathutils.bvhtree import BVHTree

from .bodies import Body
from .ghost import REFUSED, flat_shader
from .memory import where_is

_MOST_FACES = 500_000  # of a pair
_shown: dict = {"corners": np.empty((0, 3, 3)), "places": {}, "handle": None}


def crossing_faces(a: Body, b: Body):
    """(n, 3, 3) corners, world, of faces of two bodies that meet, and the number of pairs of faces."""
    if a.num_faces + b.num_faces > _MOST_FACES:
        return np.empty((0, 3, 3)), 0
    corners, trees = [], []
    for body in (a, b):
        vertices, faces = body.arrays()
        near_a = vertices + (body.origin - a.origin)  # float32 is fine there
        corners.append(vertices[faces] + body.origin)
        trees.append(BVHTree.FromPolygons(near_a.tolist(), faces.tolist()))
    pairs = np.array(trees[0].overlap(trees[1]), int).reshape(-1, 2)
    return np.concatenate([corners[k][np.unique(pairs[:, k])] for k in (0, 1)]), len(pairs)


def show(corners: np.ndarray, owners: Iterable) -> None:
    """Draws these until one of the owners is elsewhere."""
    _shown["corners"], _shown["places"] = corners, {_key(owner): where_is(owner) for owner in owners}


def _key(owner):
    """As bpy.data.objects has it: with the library of what is linked."""
    return owner.name, owner.library.filepath if owner.library else None


def clear() -> None:
    show(np.empty((0, 3, 3)), ())


def is_shown() -> bool:
    places = _shown["places"]
    there = {key: bpy.data.objects.get(key) for key in places}
    return len(_shown["corners"]) > 0 and all(there[key] and where_is(there[key]) == place for key, place in places.items())


def _draw() -> None:
    if not is_shown():
        return
    shader = flat_shader()
    corners = _shown["corners"]
    triangles = batch_for_shader(shader, "TRIS", {"pos": corners.reshape(-1, 3).astype(np.float32)})
    edges = corners[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 3).astype(np.float32)
    lines = batch_for_shader(shader, "LINES", {"pos": edges})
    gpu.state.blend_set("ALPHA")
    shader.bind()
    for batch, alpha in ((triangles, 0.25), (lines, 0.9)):
        shader.uniform_float("color", (*REFUSED, alpha))
        batch.draw(shader)
    gpu.state.blend_set("NONE")


def register() -> None:
    _shown["handle"] = bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_VIEW")


def unregister() -> None:
    clear()
    bpy.types.SpaceView3D.draw_handler_remove(_shown["handle"], "WINDOW")
