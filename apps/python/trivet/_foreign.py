"""Scenes of other programs as the compiled module takes them."""

from __future__ import annotations

from typing import Any, Iterable, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays, _trivet
from ._errors import BadInputError
from ._properties import Material
from ._shape import Shape
from ._snapshot import material_of

Entry = tuple[str, _trivet.Shape, NDArray[np.float64], bool, Any]


def entries(names: Iterable[str], shapes: Iterable[Any], poses: Iterable[ArrayLike], fixed: Iterable[str],
            materials: Mapping[str, Material]) -> list[Entry]:
    """Name, shape, pose, fixed and material of each object; a mesh that comes twice is one shape."""
    out: list[Entry] = []
    fixed_names = set(fixed)
    of_mesh: dict[int, Shape] = {}
    for name, mesh, pose in _zipped(names, shapes, poses):
        if not isinstance(mesh, Shape) and id(mesh) not in of_mesh:
            of_mesh[id(mesh)] = Shape(mesh)
        shape = mesh if isinstance(mesh, Shape) else of_mesh[id(mesh)]
        out.append((name, shape._shape, _arrays.matrix(f'pose of "{name}"', pose), name in fixed_names,
                    material_of(materials.get(name))))
    unknown = fixed_names - {one[0] for one in out}
    if unknown:
        raise _arrays.refuse("fixed", repr(sorted(unknown)), "names of the objects")
    return out


def parts_of_trimesh(scene: Any) -> tuple[list[str], list[Shape], list[Any]]:
    """Names, shapes and poses of the nodes of a trimesh.Scene that have geometry."""
    names, shapes, poses = [], [], []
    shape_of: dict[str, Shape] = {}
    for node in scene.graph.nodes_geometry:
        matrix, geometry = scene.graph[node]
        if geometry not in shape_of:
            shape_of[geometry] = Shape(scene.geometry[geometry])
        names.append(str(node))
        shapes.append(shape_of[geometry])
        poses.append(matrix)
    return names, shapes, poses


def _zipped(names: Iterable[str], shapes: Iterable[Any], poses: Iterable[ArrayLike]) -> list[tuple[str, Any, Any]]:
    n, s, p = list(names), list(shapes), list(poses)
    if not len(n) == len(s) == len(p):
        raise BadInputError(f"{len(n)} names, {len(s)} shapes and {len(p)} poses are not accepted; accepted: one of each "
                            "for every object")
    for name in n:
        if not isinstance(name, str):
            raise _arrays.refuse("names", repr(name), "a str")
    return list(zip(n, s, p))
