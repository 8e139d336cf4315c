"""Writing: bodies to where Trivet has them, and whether Blender then shows them there."""

from __future__ import annotations

from typing import Mapping, Optional

import bpy
import numpy as np
from mathutils import Matrix

from .bodies import angles_near_lock, deviation, is_sheared
from .reading import Reading, ancestors, matrix_of, read
from .properties import settings_of

_CHANNELS = ("location", "rotation_euler", "rotation_quaternion", "rotation_axis_angle", "scale")
_TRANSFORMS = ("location", "rotation", "scale", "delta_")


def why_it_stays(owner: bpy.types.Object, auto_key: bool) -> Optional[str]:
    """Why Blender or the artist would not let it move; None if nothing is known against it."""
    if settings_of(owner).role == "FIXED":
        return "is marked as fixed"
    if owner.library is not None and owner.override_library is None:
        return "is linked from another file; accepted: a library override of it"
    if any(owner.lock_location) or any(owner.lock_rotation):
        return "has locked locations or rotations"
    animation = owner.animation_data
    if animation is None:
        return None
    if any(driver.data_path.startswith(_TRANSFORMS) for driver in animation.drivers):
        return "is moved by a driver"
    if not auto_key and any(curve.data_path.startswith(_TRANSFORMS) for curve in _curves(animation)):
        return "is animated: its keys would take it back; accepted: with auto keying on"
    return None


def _curves(animation) -> list:
    """Curves of an object's action, and of the strips that play in its stead."""
    strips = [strip.action for track in animation.nla_tracks if not track.mute for strip in track.strips if not strip.mute]
    return [curve for action in (animation.action, *strips) if action is not None for curve in _curves_of(action)]


def _curves_of(action) -> list:
    """From Blender 4.4 on they are in layers."""
    if not getattr(action, "is_action_layered", False):
        return list(action.fcurves)
    return [curve for layer in action.layers for strip in layer.strips for bag in strip.channelbags for curve in bag.fcurves]


def _channels(owner: bpy.types.Object) -> dict:
    return {name: tuple(getattr(owner, name)) for name in _CHANNELS}


def _depth(owner: bpy.types.Object) -> int:
    return sum(1 for _ in ancestors(owner))


class Writer:
    """Gives objects new matrices, and can give back the old ones."""

    def __init__(self, context, reading: Reading) -> None:
        self._context, self._reading = context, reading
        self._channels = {owner: _channels(owner) for name in reading.owners for owner in reading.all_of(name)}

    def write(self, motions: Mapping[str, np.ndarray]) -> dict:
        """The outermost first; bodies below one that moves are told that they stay. Returns the motions of all written."""
        moving = {owner for name in motions for owner in self._reading.all_of(name)}
        wanted, written = {}, {}
        for body in self._reading.bodies:
            owner = self._reading.owners[body.name]
            if owner in moving or any(up in moving for up in ancestors(owner.parent)):
                written[body.name] = motions.get(body.name, np.eye(4))
                wanted.update((one, written[body.name] @ matrix) for one, matrix in self._reading.all_of(body.name).items())
        depths = sorted({_depth(owner) for owner in wanted})
        for depth in depths:
            for owner, matrix in wanted.items():
                if _depth(owner) == depth:
                    owner.matrix_world = Matrix(matrix.tolist())
                    _mend_angles(owner, matrix)
            self._context.view_layer.update()
        return written

    def put_back(self) -> None:
        """To the bit: the numbers themselves, not a matrix that has to be taken apart."""
        for owner, channels in self._channels.items():
            for name, values in channels.items():
                if tuple(getattr(owner, name)) != values:
                    setattr(owner, name, values)
        self._context.view_layer.update()


def _mend_angles(owner: bpy.types.Object, wanted: np.ndarray) -> None:
    """Euler angles where Blender's own are not precise; see angles_near_lock."""
    if any(owner.delta_rotation_euler) or not all(owner.scale):
        return
    above = np.eye(4)
    if owner.parent is not None:
        above = matrix_of(owner.parent.matrix_world) @ matrix_of(owner.matrix_parent_inverse)
    if abs(np.linalg.det(above)) > 0:
        linear = (np.linalg.inv(above) @ wanted)[:3, :3]
        lengths = np.linalg.norm(linear, axis=0) * np.sign(owner.scale)
        angles = angles_near_lock(linear / lengths, owner.rotation_mode) if lengths.all() else None
        if angles is not None:
            owner.rotation_euler = angles


def probe(context, reading: Reading, names):
    """Moves and turns each body a little, looks where Blender has it, and moves it back.

    Returns ({name: (object, why)} of those that do not go where they are told, by constraints or a parent of unequal
    scale, and metres by which others are off: Blender's matrices are float32).
    """
    writer = Writer(context, reading)
    turn = np.array(Matrix.Rotation(0.7, 4, (0.36, 0.48, 0.8)), np.float64)
    out, motions, precision = {}, {}, 0.0
    for name in names:
        body = reading.body(name)
        centre = body.bounds().mean(axis=0)
        motion = turn.copy()
        motion[:3, 3] = centre - turn[:3, :3] @ centre + 0.1 * np.ptp(body.bounds(), axis=0)
        motions[name] = motion
    writer.write(motions)
    for name, motion in motions.items():
        box = reading.body(name).bounds()
        for owner, matrix in reading.all_of(name).items():
            wanted = motion @ matrix
            off = _off(box, matrix, wanted, matrix_of(owner.matrix_world))
            if off > 1e-3 * float(np.linalg.norm(np.ptp(box, axis=0))):
                out[name] = (owner, _reason(owner, wanted))
            else:
                precision = max(precision, off)
    writer.put_back()
    return out, precision


def _off(box: np.ndarray, matrix: np.ndarray, wanted: np.ndarray, shown: np.ndarray) -> float:
    """Metres by which corners of a box, in the world below `matrix`, are elsewhere than they should be."""
    corners = np.linalg.inv(matrix) if abs(np.linalg.det(matrix)) > 0 else np.eye(4)
    points = np.c_[box, np.ones(2)] @ corners.T
    return float(np.abs(points @ (shown - wanted).T)[:, :3].max())


def _reason(owner: bpy.types.Object, wanted: np.ndarray) -> str:
    live = [one.name for one in owner.constraints if not one.mute and one.influence > 0]
    if live:
        return f'is held by its constraint "{live[0]}"'
    if not all(owner.scale):
        return "has a scale of 0"
    parent = owner.parent
    if parent is not None:
        above = matrix_of(parent.matrix_world) @ matrix_of(owner.matrix_parent_inverse)
        if abs(np.linalg.det(above)) > 0 and is_sheared(np.linalg.inv(above) @ wanted):
            return f'lies below "{parent.name}", which is scaled unequally; accepted: its scale applied'
    if owner.rigid_body is not None and owner.rigid_body.type == "ACTIVE":
        return "is moved by its rigid body; accepted: on the simulation's first frame"
    return "does not go where it is told"


def misplaced(context, reading: Reading, motions: Mapping[str, np.ndarray], tolerance: float):
    """({name: metres} of moved bodies that Blender shows elsewhere, what it shows of the moved)."""
    moved = {reading.owners[name] for name in motions}
    together = next(([lead, *others] for lead, others in reading.together.items()), [])
    shown = read(context, reading.movers, together=together, only=moved)
    out = {}
    for name, motion in motions.items():
        body = reading.body(name)
        there = shown.name_of(reading.owners[name])
        off = deviation(body, motion, shown.body(there)) if there else float("inf")
        if off > tolerance:
            out[name] = off
    return out, shown
