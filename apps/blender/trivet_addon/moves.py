"""Moves along contacts with all that lies on what is moved, and puts where there is room. Without bpy."""

from __future__ import annotations

import math
from typing import Any, Callable, Iterable, Mapping, Sequence

import numpy as np

from .bodies import Body
from .layouts import Layout, Outcome
from .work import MakeLayout, Progress, Put, Report, motions_in

# Refusals that another place may not meet.
_BY_PLACE = {"crossing", "inside", "float32_contact", "below_floor", "float32_below_floor", "touches_at_start",
             "already_touches"}


def push_operation(names: Sequence[str], by: Sequence[float]) -> dict:
    """Along the surface on which it lies. by : (2,) metres, seen from above."""
    return {"op": "push", "object": names[0], "direction": [float(by[0]), float(by[1])],
            "distance": math.hypot(by[0], by[1]), **_together(names)}


def turn_operation(names: Sequence[str], degrees: float) -> dict:
    """About the normal of its contact."""
    return {"op": "turn", "object": names[0], "angle_deg": float(degrees), **_together(names)}


def translate_operation(names: Sequence[str], by: Sequence[float], let_go: bool) -> dict:
    """Along a straight line up to a collision. by : (3,) metres."""
    return {"op": "translate", "object": names[0], "by": [float(x) for x in by], "settle": let_go, **_together(names)}


def _together(names: Sequence[str]) -> dict:
    return {"together": list(names[1:])} if len(names) > 1 else {}


class Move:
    """One operation on bodies that lie where they lie; their loads come along.

    operation : as a layout file has it; None: nothing is asked for
    """

    def __init__(self, make: MakeLayout, bodies: Sequence[Body], movers: Sequence[str], operation: Any) -> None:
        self._make, self._bodies, self._movers, self._operation = make, list(bodies), list(movers), operation
        self.progress = Progress()

    def run(self) -> Report:
        """Raises Stopped."""
        if self._operation is None or not self._movers:
            return Report()
        self.progress.at(0, 1, self._operation["op"])
        layout = self._make(self._bodies, [])
        self.progress.watch(layout)
        try:
            outcome = layout.perform(self._operation)
            self.progress.at(1, 1, "the scene as a whole")
            return self._report(layout, outcome)
        finally:
            layout.close()

    def _report(self, layout: Layout, outcome: Outcome) -> Report:
        if not outcome:
            return Report(refused={self._operation["object"]: outcome})
        motions = motions_in(layout, self._bodies)
        report = Report(motions=motions, verdict=layout.verdict(), outcome=outcome)
        report.done = [name for name in self._movers if name in motions]
        report.gave_way = list(outcome.gave_way)
        report.statuses = {name: layout.status(name) for name in motions}
        return report


def first_that_can(layout: Layout, operations: Iterable[Mapping[str, Any]]) -> Outcome:
    """Performs the first that is not refused for its place; if none is, the refusal of the first."""
    first = None
    for operation in operations:
        outcome = layout.perform(operation)
        if outcome or outcome.code not in _BY_PLACE:
            return outcome
        first = first or outcome
    return first or Outcome(False, "no_place", "no place was given")


def _put(body: Body, position: np.ndarray, wxyz: Sequence[float] = (1, 0, 0, 0)) -> dict:
    return {"op": "put", "object": body.name, "position": position.tolist(), "rotation": list(map(float, wxyz))}


_HALF = math.sqrt(0.5)
# w x y z: as it is, on each of four sides, upside down.
WAYS_TO_LIE = ((1.0, 0.0, 0.0, 0.0), (_HALF, _HALF, 0.0, 0.0), (_HALF, 0.0, _HALF, 0.0), (_HALF, -_HALF, 0.0, 0.0),
               (_HALF, 0.0, -_HALF, 0.0), (0.0, 1.0, 0.0, 0.0))


def laid(turn: float, way: int) -> tuple:
    """w x y z: one of WAYS_TO_LIE, then turned about the vertical. turn : radians"""
    w, x, y, z = WAYS_TO_LIE[way]
    c, s = math.cos(turn / 2), math.sin(turn / 2)
    return c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w


def rotation_of(wxyz: Sequence[float]) -> np.ndarray:
    """(3, 3) of a unit quaternion."""
    w, x, y, z = wxyz
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def put_at(layout: Layout, body: Body, point: Sequence[float], wxyz: Sequence[float], gap: float) -> Outcome:
    """Let go with its lowest point just above a point, or as far above that as it is free there.

    point : (3,) world; wxyz : from how it is; gap : metres
    """
    vertices = body.arrays()[0] @ rotation_of(wxyz).T
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    start = np.array([point[0] - (low[0] + high[0]) / 2, point[1] - (low[1] + high[1]) / 2, point[2] - low[2] + gap])
    size = float(np.linalg.norm(high - low))
    lifts = [0.0, *(size * 2.0 ** k for k in range(-6, 3))]
    return first_that_can(layout, (_put(body, start + [0, 0, lift], wxyz) for lift in lifts))


_WAYS = np.array([[0, 0, 1], *([x, y, z] for z in (0, 1) for x in (-1, 0, 1) for y in (-1, 0, 1) if (x, y) != (0, 0))], float)


def ways_out(body: Body) -> list:
    """(3,) offsets by which a body may get free: the nearest first, up before sideways, to three times its size."""
    size = float(np.linalg.norm(np.ptp(body.bounds(), axis=0)))
    ways = _WAYS / np.linalg.norm(_WAYS, axis=1)[:, None]
    lengths = [size * 3.0 * 1.5 ** -k for k in range(20, -1, -1)]
    return [np.zeros(3), *(way * length for length in lengths for way in ways)]


class Separate:
    """Takes bodies that interpenetrate up, and puts each, the lowest first, as near to where it was as it is free.

    crossings : () -> pairs of names
    """

    def __init__(self, make: MakeLayout, crossings: Callable[[], Sequence], bodies: Sequence[Body],
                 movers: Sequence[str]) -> None:
        self._make, self._crossings, self._bodies, self._movers = make, crossings, list(bodies), list(movers)
        self.progress = Progress()

    def run(self) -> Report:
        """Raises Stopped."""
        self.progress.at(0, 1, "judging")
        named = {name for pair in self._crossings() for name in pair}
        top = max((float(body.bounds()[1, 2]) for body in self._bodies), default=0.0)
        put = Put(self._make, self._bodies, [name for name in self._movers if name in named],
                  lambda layout, body: _put_free(layout, body, top))
        put.progress = self.progress
        return put.run()


def _put_free(layout: Layout, body: Body, top: float) -> Outcome:
    """Let go where it is, or as near to that as it is free; at last from above all."""
    above = np.array([0, 0, top - float(body.bounds()[0, 2]) + 0.1 * float(np.ptp(body.bounds()[:, 2]))])
    return first_that_can(layout, (_put(body, body.origin + way) for way in [*ways_out(body), above]))
