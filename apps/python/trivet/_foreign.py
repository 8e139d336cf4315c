"""Scenes of other programs as the compiled module takes them."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any, Iterable, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays, _trivet
from ._errors import BadInputError, EnvironmentFailure
from ._named import names as names_of
from ._properties import Material, material_of
from ._shape import Shape

if TYPE_CHECKING:
    from ._scene import Scene

Entry = tuple[str, _trivet.Shape, NDArray[np.float64], bool, Any, Any]


def _mass(value: Any) -> Any:
    """Kilograms, or a dict of plain numbers."""
    if isinstance(value, Mapping):
        return {key: np.asarray(one, float).tolist() for key, one in value.items()}
    return _arrays.number("mass", value)


def entries(names: Iterable[str], shapes: Iterable[Any], poses: Iterable[ArrayLike], fixed: Iterable[str],
            materials: Mapping[str, Material], masses: Mapping[str, Any]) -> list[Entry]:
    """Name, shape, pose, fixed, material and mass of each object; a mesh that comes twice is one shape."""
    out: list[Entry] = []
    fixed_names = set(names_of("fixed", fixed))
    material = {name: material_of(one) for name, one in _arrays.mapping("materials", materials, "a dict by names").items()}
    mass = {name: _mass(one) for name, one in _arrays.mapping("masses", masses, "a dict by names").items()}
    of_mesh: dict[int, Shape] = {}
    for name, mesh, pose in _zipped(names, shapes, poses):
        if not isinstance(mesh, Shape) and id(mesh) not in of_mesh:
            of_mesh[id(mesh)] = Shape(mesh)
        shape = mesh if isinstance(mesh, Shape) else of_mesh[id(mesh)]
        out.append((name, shape._shape, _arrays.matrix(f'pose of "{name}"', pose), name in fixed_names,
                    material.get(name), mass.get(name)))
    known = {one[0] for one in out}
    for what, given in (("fixed", fixed_names), ("materials", set(material)), ("masses", set(mass))):
        if not given <= known:
            raise _arrays.refuse(what, repr(sorted(given - known, key=str)), "names of the objects")
    return out


def parts_of_trimesh(scene: Any) -> tuple[list[str], list[Shape], list[Any]]:
    """Names, shapes and poses of the nodes of a trimesh.Scene that have geometry."""
    if not hasattr(getattr(scene, "graph", None), "nodes_geometry") or not hasattr(scene, "geometry"):
        raise _arrays.refuse("scene", f"a value of type {type(scene).__name__}", "a trimesh.Scene")
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


def trimesh_of(scene: Scene) -> Any:
    """A trimesh.Scene of what is in the scene; a shape of several objects is one geometry."""
    try:
        trimesh: Any = import_module("trimesh")
    except ImportError as error:
        raise EnvironmentFailure("to_trimesh: the package trimesh is missing; accepted: Python with trimesh") from error
    out = trimesh.Scene()
    geometry: dict[Shape, str] = {}
    for one in scene:
        if not one.placed:
            continue
        shape = one.shape
        if shape not in geometry:
            geometry[shape] = f"shape_{len(geometry)}"
            out.geometry[geometry[shape]] = trimesh.Trimesh(shape.vertices.copy(), shape.faces.copy(),
                                                            face_colors=shape.face_colors(), process=False)
        out.graph.update(frame_to=one.name, matrix=one.matrix, geometry=geometry[shape])
    return out


def _zipped(names: Iterable[str], shapes: Iterable[Any], poses: Iterable[ArrayLike]) -> list[tuple[str, Any, Any]]:
    n, s, p = (_arrays.listed(what, value, "one of each for every object")
               for what, value in (("names", names), ("shapes", shapes), ("poses", poses)))
    if not len(n) == len(s) == len(p):
        raise BadInputError(f"{len(n)} names, {len(s)} shapes and {len(p)} poses are not accepted; accepted: one of each "
                            "for every object")
    for name in n:
        _arrays.text("names", name)
    return list(zip(n, s, p))
