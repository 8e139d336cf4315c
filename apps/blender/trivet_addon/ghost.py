"""Ghosts: where bodies would come to lie, drawn over the view."""

from __future__ import annotations

from typing import Mapping, Sequence

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader
from mathutils import Matrix

from .bodies import Body

WELL = (0.25, 0.8, 0.35)  # it would lie here
REFUSED = (0.9, 0.25, 0.2)
_ALPHA = 0.55
_MOST_FACES = 300_000  # more are drawn as their box
_LIGHT = np.array([0.36, -0.48, 0.8])
_BOX = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                 [0, 6, 4], [1, 5, 7], [1, 7, 3]])


def _builtin(name: str):
    try:
        return gpu.shader.from_builtin(name)
    except (ValueError, SystemError):  # before Blender 4
        return gpu.shader.from_builtin("3D_" + name)


def flat_shader():
    """One colour for all."""
    return _builtin("UNIFORM_COLOR")


def triangles(body: Body) -> np.ndarray:
    """(n, 3, 3) corners in the world, or those of its box if there are too many."""
    vertices, faces = body.arrays()
    if len(faces) > _MOST_FACES:
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        vertices = np.array([[(low, high)[x][0], (low, high)[y][1], (low, high)[z][2]]
                             for x in (0, 1) for y in (0, 1) for z in (0, 1)])
        faces = _BOX
    return vertices[faces] + body.origin


def shades(corners: np.ndarray, colour: Sequence[float]) -> np.ndarray:
    """(3 n, 4) colours of corners, lit from one side."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    light = 0.65 + 0.35 * (normals @ _LIGHT) / np.where(lengths > 0, lengths, 1)
    out = np.empty((len(corners), 4), np.float32)
    out[:, :3], out[:, 3] = light[:, None] * np.array(colour), _ALPHA
    return np.repeat(out, 3, axis=0)


class Ghost:
    """Draws bodies where motions take them, until `end`."""

    def __init__(self, bodies: Sequence[Body]) -> None:
        self._bodies = {body.name: body for body in bodies}
        self._batches: dict = {}
        self._shown: dict = {}
        self._colour = WELL
        self._shader = _builtin("SMOOTH_COLOR")
        self._handle = bpy.types.SpaceView3D.draw_handler_add(self._draw, (), "WINDOW", "POST_VIEW")

    def show(self, motions: Mapping[str, np.ndarray], colour: Sequence[float]) -> None:
        self._shown, self._colour = dict(motions), tuple(colour)

    @property
    def names(self) -> list:
        return list(self._shown)

    def end(self) -> None:
        if self._handle is not None:
            bpy.types.SpaceView3D.draw_handler_remove(self._handle, "WINDOW")
            self._handle = None

    def _batch(self, name: str):
        key = (name, self._colour)
        if key not in self._batches:
            corners = triangles(self._bodies[name])
            self._batches[key] = batch_for_shader(self._shader, "TRIS", {
                "pos": corners.reshape(-1, 3).astype(np.float32), "color": shades(corners, self._colour)})
        return self._batches[key]

    def _draw(self) -> None:
        gpu.state.blend_set("ALPHA")
        gpu.state.depth_test_set("LESS_EQUAL")
        gpu.state.depth_mask_set(True)
        for name, motion in self._shown.items():
            with gpu.matrix.push_pop():
                gpu.matrix.multiply_matrix(Matrix(motion.tolist()))
                self._batch(name).draw(self._shader)
        gpu.state.depth_mask_set(False)
        gpu.state.depth_test_set("NONE")
        gpu.state.blend_set("NONE")
