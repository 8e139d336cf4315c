"""Reading: bodies from what Blender shows: evaluated meshes, modifiers, instances, parents, curves and text."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Iterable, Optional

import bpy
import numpy as np

from .bodies import NOT_FINITE, Body, fault_of, meets, part_of
from .layouts import safe_names
from .properties import settings_of

SURFACES = {"MESH", "CURVE", "SURFACE", "META", "FONT"}


class TooLarge(Exception):
    """More triangles than the preferences accept."""


@dataclass
class Reading:
    """Bodies, the object of each that moves it, and objects that Trivet cannot take."""

    movers: set  # objects
    bodies: list
    owners: dict  # name of the body -> object
    faults: dict  # object -> why
    left_out: list = field(default_factory=list)  # names of objects in the way that cannot be taken
    rendered_otherwise: list = field(default_factory=list)  # names
    together: dict = field(default_factory=dict)  # mover -> {object: its matrix} of those that move with it as one body

    def __post_init__(self) -> None:
        self._by_name = {body.name: body for body in self.bodies}
        self._names = {owner: name for name, owner in self.owners.items()}

    def name_of(self, owner: bpy.types.Object) -> Optional[str]:
        return self._names.get(owner)

    def body(self, name: str) -> Body:
        return self._by_name[name]

    def all_of(self, name: str) -> dict:
        """{object: its matrix when it was read} that a body's motion moves: its owner, and those together with it."""
        owner = self.owners[name]
        return {owner: self._by_name[name].matrix, **self.together.get(owner, {})}

    def add(self, body: Body, owner: bpy.types.Object) -> None:
        self.bodies.append(body)
        self.owners[body.name], self._by_name[body.name], self._names[owner] = owner, body, body.name
        self.movers.add(owner)

    def remove(self, name: str) -> None:
        """Takes a body out again that was added."""
        self.bodies.remove(self._by_name.pop(name))
        owner = self.owners.pop(name)
        del self._names[owner]
        self.movers.discard(owner)


def mesh_arrays(mesh: bpy.types.Mesh):
    """(n, 3) float32 coordinates and (m, 3) corners of Blender's own triangles: what it draws."""
    mesh.calc_loop_triangles()
    coordinates = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", coordinates)
    triangles = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    return coordinates.reshape(-1, 3), triangles.reshape(-1, 3)


def metres_of_unit(context) -> float:
    """Metres of Blender's unit, as the scene has it."""
    units = context.scene.unit_settings
    return 1.0 if units.system == "NONE" else units.scale_length


def matrix_of(matrix) -> np.ndarray:
    return np.array(matrix, np.float64)


def ancestors(owner: bpy.types.Object):
    """The object, its parent, and so on."""
    while owner:
        yield owner
        owner = owner.parent


def root_among(owner: bpy.types.Object, among: Iterable) -> Optional[bpy.types.Object]:
    """The outermost of the object and its ancestors that is among these."""
    return next((one for one in reversed(list(ancestors(owner))) if one in among), None)


def _solid_root(owner: bpy.types.Object) -> bpy.types.Object:
    """The outermost ancestor of obstacles that is a thing itself, and not an empty that only keeps order."""
    solid = [one for one in ancestors(owner) if one.type in SURFACES or one.instance_type == "COLLECTION"]
    return solid[-1] if solid else owner


def _owner_of(owner: bpy.types.Object, movers: set) -> bpy.types.Object:
    """The object by which this one moves: the outermost mover, the nearest that is free, or that of an obstacle."""
    top = root_among(owner, movers)
    if top is not None:
        return top
    free = (one for one in ancestors(owner) if settings_of(one).role == "FREE")
    return next(free, None) or _solid_root(owner)


def _is_there(instance, shown: bpy.types.Object, movers: set, view) -> bool:
    """True if an instance of the depsgraph counts as a thing in the scene."""
    if not instance.show_self or instance.object.type not in SURFACES:
        return False
    if not instance.is_instance and not (shown.visible_get(viewport=view) if view else shown.visible_get()):
        return False
    if root_among(shown, movers) is not None:
        return True
    return settings_of(shown).role != "IGNORED" and shown.display_type not in {"WIRE", "BOUNDS"}


def _obstacle_filter(context, kind: str):
    """Which objects may be in the way, beside those that move."""
    if kind == "SELECTED":
        return lambda one: one.select_get()
    collection = context.scene.trivet.obstacles
    if kind == "COLLECTION" and collection is not None:
        names = {one.name_full for one in collection.all_objects}
        return lambda one: any(up.name_full in names for up in ancestors(one))
    return lambda one: True


class _Meshes:
    """Arrays of evaluated meshes; an instance's mesh is read once."""

    def __init__(self) -> None:
        self._read: dict = {}

    def arrays(self, instance):
        data = instance.object.data
        key = (instance.object.original.name_full, instance.is_instance, data.as_pointer() if data else 0)
        if key not in self._read:
            mesh = instance.object.to_mesh()
            self._read[key] = mesh_arrays(mesh) if mesh and len(mesh.polygons) else None
            instance.object.to_mesh_clear()
        return self._read[key]


def renders_otherwise(owner: bpy.types.Object) -> bool:
    """True if its surface is another one in renders than in the view."""
    for one in owner.modifiers:
        levels = getattr(one, "levels", 0) if one.type in {"SUBSURF", "MULTIRES"} else 0
        if one.show_viewport != one.show_render or (one.show_render and levels != getattr(one, "render_levels", levels)):
            return True
    data = owner.data
    if isinstance(data, bpy.types.MetaBall):
        return data.render_resolution != data.resolution
    return isinstance(data, bpy.types.Curve) and (data.render_resolution_u not in {0, data.resolution_u}
                                                  or data.render_resolution_v not in {0, data.resolution_v})


def _is_beyond(instance, owner: bpy.types.Object, movers: set, reach: Optional[np.ndarray]) -> bool:
    """True if an instance that stays is too far away to matter."""
    if reach is None or not instance.is_instance or owner in movers or settings_of(owner).role == "FREE":
        return False
    corners = np.array(instance.object.bound_box, np.float64) @ matrix_of(instance.matrix_world)[:3, :3].T
    corners += matrix_of(instance.matrix_world)[:3, 3]
    return not meets(reach, corners.min(axis=0), corners.max(axis=0))


def read(context, movers: Iterable, *, together: Iterable = (), only: Optional[Iterable] = None, obstacles: str = "VISIBLE",
         most_faces: int = 0, reach: Optional[np.ndarray] = None) -> Reading:
    """Reads the scene that Blender shows.

    movers : objects that move as one with what is below them
    together : of these the ones that move as one body, by the first of them
    only : of these owners alone, where given
    most_faces : TooLarge is raised beyond; 0: any number
    reach : (k, 2, 3) boxes, world; instances that stay are read where they meet one; None: all
    """
    movers, together = set(movers), list(together)
    leads = {one: together[0] for one in together}
    wanted = None if only is None else set(only)
    view = context.space_data if context.space_data and context.space_data.type == "VIEW_3D" else None
    in_the_way = _obstacle_filter(context, obstacles)
    parts: dict = {}
    otherwise: dict = {}  # name -> bool
    meshes, count = _Meshes(), 0
    for instance in context.evaluated_depsgraph_get().object_instances:
        shown = (instance.parent if instance.is_instance else instance.object).original
        if not _is_there(instance, shown, movers, view):
            continue
        owner = _owner_of(shown, movers)
        owner = leads.get(owner, owner)
        if (wanted is not None and owner not in wanted) or not (owner in movers or in_the_way(shown)):
            continue
        if _is_beyond(instance, owner, movers, reach):
            continue
        arrays = meshes.arrays(instance)
        if arrays is None:
            continue
        count += len(arrays[1])
        if most_faces and count > most_faces:
            raise TooLarge(f"more than {most_faces / 1e6:g} million triangles; accepted: fewer, or a larger number in the "
                           "preferences, or fewer obstacles")
        parts.setdefault(owner, []).append(part_of(*arrays, matrix_of(instance.matrix_world)))
        for one in (shown, instance.object.original):
            if one.name_full not in otherwise:
                otherwise[one.name_full] = renders_otherwise(one)
    expected = {leads.get(one, one) for one in movers}
    out = _reading(parts, movers, expected if wanted is None else wanted & expected)
    if together:
        out.together[together[0]] = {one: matrix_of(one.matrix_world) for one in together[1:]}
    out.rendered_otherwise = sorted(name for name, differs in otherwise.items() if differs)
    return out


def _reading(parts: dict, movers: set, expected: set) -> Reading:
    owners = sorted({*parts, *expected}, key=lambda one: one.name_full)
    names = safe_names([one.name_full for one in owners])
    bodies, by_name, faults, left_out = [], {}, {}, []
    for owner in owners:
        chosen = settings_of(owner)
        body = Body(names[owner.name_full], parts.get(owner, []), matrix_of(owner.matrix_world),
                    chosen.role != "FREE" and owner not in movers, chosen.friction, chosen.density)
        fault = fault_of(body)
        if fault is None:
            bodies.append(body)
            by_name[body.name] = owner
        elif owner in movers:
            faults[owner] = fault
        elif fault == NOT_FINITE:
            left_out.append(owner.name_full)
    return Reading(movers, bodies, by_name, faults, left_out)
