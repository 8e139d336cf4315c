"""Results of operations and queries: values, never views of a scene that changes."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any, NamedTuple, NoReturn, Optional

import numpy as np
from numpy.typing import NDArray

from . import _trivet
from ._errors import BadInputError, Cancelled, NotDone, OutOfTime, Refused

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]

#: All causes of refusals, as `Result.code` and `Refused.code` have them.
CAUSES: tuple[str, ...] = tuple(_trivet.causes())


class GaveWay(NamedTuple):
    """An object that moved though it was not asked to."""

    name: str
    moved: float  #: metres, of its centre of mass
    turned_deg: float


@dataclass(frozen=True)
class Result:
    """Result of an operation; true if it was done.

    Attributes
    ----------
    status : "ok", "refused", "cancelled" or "out of time"
    code, reason, objects, numbers
        Of a refusal: its cause (see ``trivet.CAUSES``), the sentence for people, the names in it, and its
        figures by name.
    end : "done", "at_rest", "reached", "blocked", "step", "edge" or "limit"
        Why it ended; means nothing when refused. Blocked by `blocked_by` at the point `blocked_at`, world, metres.
    moved, turned_deg : float
        Metres from where the object's position was, and degrees by `turn` and `rotate`.
    carried, unsupported, settled : tuple of str
        Loads that moved along; free objects that nothing holds any more; objects that were released, in order.
    gave_way : tuple of GaveWay
    interpenetrates : tuple of str
        After a free move.
    unsound : tuple of str
        Objects below it, directly or not, that are held, unsupported or invalid: it may not stay.
    path : (n, 4, 4) array
        Poses of the object after each motion, metres, world.
    num_motions : int
    seconds : float
        Wall clock.
    try_number : int
        Of a `put`: which start it was; 1 is the one that was asked for.
    start_shifted, start_turned_deg : float
        Metres and degrees about the vertical of that start from the one that was asked for.
    repaired : dict
        Of `Scene.mend` and `Scene.settle_all`: what they return; None for other operations.
    """

    status: str
    code: str
    reason: str
    objects: tuple[str, ...]
    numbers: dict[str, float]
    end: str
    moved: float
    turned_deg: float
    blocked_by: str
    blocked_at: Optional[Floats]
    carried: tuple[str, ...]
    unsupported: tuple[str, ...]
    settled: tuple[str, ...]
    gave_way: tuple[GaveWay, ...]
    interpenetrates: tuple[str, ...]
    unsound: tuple[str, ...]
    num_motions: int
    seconds: float
    path: Floats = field(repr=False)
    try_number: int = 1
    start_shifted: float = 0.0
    start_turned_deg: float = 0.0
    repaired: Optional[dict[str, Any]] = None

    def __bool__(self) -> bool:
        return self.status == "ok"

    @property
    def ok(self) -> bool:
        """True if it was done."""
        return self.status == "ok"


def result_of(values: dict[str, Any]) -> Result:
    values["gave_way"] = tuple(GaveWay(*one) for one in values["gave_way"])
    if "repaired" in values:
        values["repaired"] = json.loads(values["repaired"])
    return Result(**values)


def raise_for(result: Result) -> NoReturn:
    if result.code in ("invalid_argument", "invalid_name"):
        raise BadInputError(result.reason)
    kinds: dict[str, type[NotDone]] = {"cancelled": Cancelled, "out of time": OutOfTime}
    raise kinds.get(result.status, Refused)(result)


def checked(result: Result) -> Result:
    if not result:
        raise_for(result)
    return result


def done(values: dict[str, Any]) -> Result:
    """The result, or what says that the operation was not done."""
    return checked(result_of(values))


def _named(names: tuple[str, ...], numbers: Ints) -> NDArray[np.str_]:
    return np.array([*names, "floor"], dtype=np.str_)[numbers]


@dataclass(frozen=True)
class Contacts:
    """All contact points of a scene, each once: columns of one length n.

    Attributes
    ----------
    names : tuple of str
        Objects in the scene's order.
    objects : (n, 2) int array
        The object and what it touches, numbers in `names`; -1 is the floor.
    contact : (n,) int array
        Points of one number make one contact of two objects.
    type : (n,) array of str
        "point", "line" or "area", of the contact.
    kind : (n,) array of str
        "vertex-face", "face-vertex", "edge-edge" or "closest" (of two faces): what meets, the object's first.
    features : (n, 2) int array
        Rows of `Shape.vertices` and `Shape.faces`, or edges; of the floor 0.
    point, normal : (n, 3) arrays
        World, metres; unit, from the second object of the pair to the first.
    gap : (n,) array
        Metres, at least 0.
    """

    names: tuple[str, ...]
    objects: Ints
    contact: Ints
    type: NDArray[np.str_]
    kind: NDArray[np.str_]
    features: Ints
    point: Floats
    normal: Floats
    gap: Floats

    def __len__(self) -> int:
        return len(self.gap)

    def to_pandas(self) -> Any:
        """A pandas.DataFrame, a row for each point. Needs pandas."""
        pandas: Any = import_module("pandas")

        pairs = _named(self.names, self.objects).reshape(-1, 2)
        columns: dict[str, Any] = {"object": pairs[:, 0], "support": pairs[:, 1],
                                   "contact": self.contact, "type": self.type, "gap": self.gap}
        for k, axis in enumerate("xyz"):
            columns[axis] = self.point[:, k]
            columns["n" + axis] = self.normal[:, k]
        return pandas.DataFrame(columns)


@dataclass(frozen=True)
class SupportGraph:
    """Graph of which object rests on which.

    Attributes
    ----------
    names : tuple of str
        Objects in the scene's order.
    edges : (m, 2) int array
        Support and load, numbers in `names`; -1 is the floor.
    """

    names: tuple[str, ...]
    edges: Ints

    def named_edges(self) -> list[tuple[str, str]]:
        """The edges by names; the floor is ``"floor"``."""
        return [(str(a), str(b)) for a, b in _named(self.names, self.edges).reshape(-1, 2)]

    def to_networkx(self) -> Any:
        """A networkx.DiGraph from supports to loads. Needs networkx."""
        networkx: Any = import_module("networkx")

        graph = networkx.DiGraph()
        graph.add_nodes_from(self.names)
        graph.add_edges_from(self.named_edges())
        return graph


class Crossing(NamedTuple):
    """Two objects that interpenetrate."""

    a: str
    b: str
    number: int  #: pairs of faces; of contained ones: components of `a` inside `b`


@dataclass(frozen=True)
class Check:
    """A scene judged from its poses alone; true if it passed.

    Attributes
    ----------
    ok : bool
        Nothing interpenetrates, in float64 and as exported in float32, and each free object is at rest with all
        others held.
    crossings, float32_crossings, contained : tuple of Crossing
    not_at_rest, topples, marginal : tuple of str
    smallest_gap : float
        Metres, over all contacts; infinity without one.
    stability : "stable", "marginal", "unstable" or "unknown"
        Of the scene as a whole, by friction. `why_unknown` says more.
    stable : bool, for stable and marginal scenes
    margin : float
        Metres by which all weights may be shifted sideways before an object gives way; infinity without a free one.
    names, force_objects, force_point, force
        Contact forces that balance the weights: (n, 2) numbers in `names` (-1: floor) of the object that is pushed
        and what pushes it; (n, 3) metres; (n, 3) newtons. Complete only when stable.
    """

    ok: bool
    crossings: tuple[Crossing, ...]
    float32_crossings: tuple[Crossing, ...]
    contained: tuple[Crossing, ...]
    not_at_rest: tuple[str, ...]
    smallest_gap: float
    stability: str
    stable: bool
    why_unknown: str
    topples: tuple[str, ...]
    marginal: tuple[str, ...]
    margin: float
    names: tuple[str, ...]
    force_objects: Ints = field(repr=False)
    force_point: Floats = field(repr=False)
    force: Floats = field(repr=False)

    def __bool__(self) -> bool:
        return self.ok


def check_of(values: dict[str, Any]) -> Check:
    for key in ("crossings", "float32_crossings", "contained"):
        values[key] = tuple(Crossing(*one) for one in values[key])
    for key in ("not_at_rest", "topples", "marginal"):
        values[key] = tuple(values[key])
    return Check(ok=values.pop("passed"), **values)


class Overlap(NamedTuple):
    """Two objects whose convex parts overlap: a simulator pushes them apart."""

    a: str
    b: str
    depth: float  #: metres
    allowed: float  #: metres


@dataclass(frozen=True)
class Simulated:
    """Motion of an exported scene in a simulator; true if all stayed where they were.

    Attributes
    ----------
    simulator : str
        Its name and version.
    seconds, penetration : float
        How long it ran; metres of the deepest contact at the start.
    warnings : int
        Of the simulator.
    stays : bool
        No object moved by more than a centimetre, and there was no warning.
    objects : dict
        (metres, degrees) that each free object moved and turned, by names.
    """

    simulator: str
    seconds: float
    penetration: float
    warnings: int
    stays: bool
    objects: dict[str, tuple[float, float]]

    def __bool__(self) -> bool:
        return self.stays


@dataclass(frozen=True)
class Export:
    """Files of a simulator's scene, the scene itself first.

    Attributes
    ----------
    files, notes : tuple of str
    overlaps : tuple of Overlap
        Deepest first.
    masses : dict
        Kilograms by the objects' names.
    simulated : Simulated or None
        With ``simulate``.
    """

    files: tuple[str, ...]
    notes: tuple[str, ...]
    overlaps: tuple[Overlap, ...]
    masses: dict[str, float]
    simulated: Optional[Simulated] = None


@dataclass(frozen=True)
class FirstContact:
    """Where a motion first touches; false is what `first_contact` does not return: None is free.

    Attributes
    ----------
    crossing : bool
        The shapes cross or touch before the motion begins; no other field means anything.
    distance, degrees : float
        How far the motion is free: metres of a translation (degrees is 0), degrees of a turn (distance is 0).
    point, normal : (3,) arrays
        World; on the fixed shape; unit, from the fixed shape to the moving one.
    gap : float
        Metres at the end.
    faces : (int, int)
        Rows of `faces` of the moving and the fixed shape, as they were given.
    """

    crossing: bool
    distance: float
    degrees: float
    point: Floats
    normal: Floats
    gap: float
    faces: tuple[int, int]
