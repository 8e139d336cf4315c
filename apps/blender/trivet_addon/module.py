"""Layouts by the Python module, in this process. Without bpy."""

from __future__ import annotations

import hashlib
from collections import OrderedDict
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from .bodies import Body, translation
from .layouts import LayoutError, Outcome, Settings, Status, Verdict, near

_MOST_FACES = 8_000_000


class ShapeCache:
    """Shapes by their content: the index of a mesh that has not changed is not built again."""

    def __init__(self, most_faces: int = _MOST_FACES) -> None:
        self._shapes: OrderedDict = OrderedDict()
        self._faces, self._most = 0, most_faces

    def shape(self, trivet: Any, vertices: np.ndarray, faces: np.ndarray) -> Any:
        digest = hashlib.blake2b(np.ascontiguousarray(vertices), digest_size=16)
        digest.update(np.ascontiguousarray(faces))
        key = (len(vertices), digest.digest())
        if key in self._shapes:
            self._shapes.move_to_end(key)
            return self._shapes[key]
        shape = trivet.Shape(vertices, faces)
        self._shapes[key] = shape
        self._faces += len(faces)
        while self._faces > self._most and len(self._shapes) > 1:
            self._faces -= len(self._shapes.popitem(last=False)[1].faces)
        return shape


_cache = ShapeCache()


def _shape_of(trivet: Any, body: Body) -> Any:
    try:
        return _cache.shape(trivet, *body.arrays())
    except trivet.BadInputError as error:
        raise LayoutError(f'"{body.name}": {error}') from error


def outcome_of(result: Any) -> Outcome:
    return Outcome(bool(result), result.code or ("" if result else result.status), result.reason, tuple(result.objects),
                   result.end, result.blocked_by, tuple(one.name for one in result.gave_way), tuple(result.carried))


def verdict_of(check: Any) -> Verdict:
    return Verdict(tuple((one.a, one.b) for one in check.crossings), tuple((one.a, one.b) for one in check.contained),
                   tuple(check.not_at_rest), tuple(check.topples), check.stability, check.margin)


class ModuleLayout:
    """See `layouts.Layout`."""

    def __init__(self, trivet: Any, bodies: Sequence[Body], out: Sequence[str], settings: Settings) -> None:
        self._trivet = trivet
        try:
            self._start(bodies, out, settings)
        except trivet.TrivetError as error:
            raise LayoutError(str(error)) from error

    def _start(self, bodies: Sequence[Body], out: Sequence[str], settings: Settings) -> None:
        trivet = self._trivet
        shapes = {body.name: _shape_of(trivet, body) for body in bodies}
        material = {body.name: {"friction": body.friction, "density": body.density} for body in bodies}
        here = [body for body in bodies if body.name not in out]
        self._scene = trivet.Scene.from_poses(
            [body.name for body in here], [shapes[body.name] for body in here], [translation(body.origin) for body in here],
            fixed=[body.name for body in here if body.fixed], materials={body.name: material[body.name] for body in here},
            floor=settings.floor, clearance=settings.clearance)
        self._scene.device = settings.device or "auto"
        self._scene.detector = settings.detector
        for body in bodies:
            if body.name in out:
                self._scene.add(body.name, shapes[body.name], fixed=body.fixed, material=material[body.name])
        self._scene.time_budget = settings.seconds

    def perform(self, operation: Mapping[str, Any]) -> Outcome:
        try:
            return outcome_of(self._scene.perform([operation]))
        except self._trivet.NotDone as error:
            return outcome_of(error.result)
        except self._trivet.BadInputError as error:
            return Outcome(False, "invalid_argument", str(error))

    def mend(self) -> Mapping[str, str]:
        try:
            return {one["object"]: one["why"] for one in self._scene.mend()["unable"]}
        except self._trivet.NotDone as error:
            raise LayoutError(str(error)) from error

    def undo(self) -> None:
        self._scene.undo()

    def pose(self, name: str) -> Optional[np.ndarray]:
        return self._scene[name].pose

    def status(self, name: str) -> Status:
        one = self._scene[name]
        return Status(one.state, tuple(getattr(o, "name", o) for o in one.supports), tuple(o.name for o in one.loads()),
                      one.margin, one.least_friction)

    def verdict(self) -> Verdict:
        return verdict_of(self._scene.check())

    def export(self, path: str, collision: str) -> list:
        try:
            done = self._scene.export(path, collision=collision)
        except self._trivet.TrivetError as error:
            raise LayoutError(str(error)) from error
        return [*done.files, *done.notes]

    def cancel(self) -> None:
        self._scene.cancel()

    def close(self) -> None:
        pass


def judge(trivet: Any, bodies: Sequence[Body], settings: Settings):
    """See `backends.Backend.judge`."""
    layout = ModuleLayout(trivet, bodies, [], settings)
    return layout.verdict(), {body.name: layout.status(body.name) for body in bodies}


def crossings(trivet: Any, bodies: Sequence[Body], about: Sequence[str]) -> list:
    """See `backends.Backend.crossings`; by the very numbers that Blender has."""
    chosen = near(bodies, set(about))
    try:
        shapes = [_shape_of(trivet, body) for body in chosen]
        found = trivet.interpenetrations(shapes, [translation(body.origin) for body in chosen],
                                         positions=[_shown(shape, body) for shape, body in zip(shapes, chosen)])
    except trivet.TrivetError as error:
        raise LayoutError(str(error)) from error
    pairs = [(chosen[one.a].name, chosen[one.b].name) for one in found]
    return [pair for pair in pairs if set(pair) & set(about)]


def _shown(shape: Any, body: Body) -> np.ndarray:
    """World positions of the shape's vertices."""
    out = np.empty((len(shape.vertices), 3))
    used = shape.vertex_map >= 0
    out[shape.vertex_map[used]] = body.world()[used]
    return out
