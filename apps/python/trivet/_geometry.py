"""First contact and interpenetration of shapes, without a scene."""

from __future__ import annotations

from typing import Any, Iterable, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _trivet
from ._errors import BadInputError
from ._results import FirstContact
from ._shape import Shape


def _shape(mesh: Any) -> Shape:
    return mesh if isinstance(mesh, Shape) else Shape(mesh)


def first_contact(moving: Any, moving_pose: ArrayLike, fixed: Any, fixed_pose: ArrayLike, *,
                  along: Optional[ArrayLike] = None, distance: Optional[float] = None,
                  about: Optional[Tuple[ArrayLike, ArrayLike]] = None, degrees: float = 360.0,
                  clearance: float = 0.0) -> Optional[FirstContact]:
    """When a moving shape first touches another: exact for faces, nothing stepped over, turns too.

    Parameters
    ----------
    moving, fixed : Shape, or a mesh as `Shape` takes one
    moving_pose, fixed_pose : (4, 4) arrays
        World from shape; with a uniform scale.
    along, distance : (3,) array and float
        A translation in this direction (of any length but 0) by `distance` metres; nothing: by `along` itself, so that its
        length is the way.
    about, degrees : (axis, centre), each (3,), and float
        Instead: a right-handed turn about the axis through `centre`.
    clearance : float
        Metres that it stays away; 0: 2^-20 of the size of both.

    Returns
    -------
    FirstContact or None
        None: the whole motion is free.

    Raises
    ------
    BadInputError
        Both or neither of `along` and `about`, or an argument that is not accepted.
    """
    if (along is None) == (about is None):
        raise BadInputError("along and about: both or none are given; accepted: one of them")
    centre = None
    if about is not None:
        if not isinstance(about, (tuple, list)) or len(about) != 2:
            raise _arrays.refuse("about", repr(about), "an axis and a point on it")
        axis = _arrays.vector("axis", about[0], 3)
        centre = np.array(_arrays.vector("centre", about[1], 3))
        amount = _arrays.number("degrees", degrees, "-3600 to 3600", -3600.0, 3600.0)
    else:
        axis = _arrays.vector("along", along, 3)
        way = np.linalg.norm(axis) if distance is None else distance
        amount = _arrays.number("distance", way, "0 to 1e15 metres", 0.0, 1e15)
    found = _trivet.first_contact(_shape(moving)._shape, _arrays.matrix("moving_pose", moving_pose),
                                  _shape(fixed)._shape, _arrays.matrix("fixed_pose", fixed_pose), np.array(axis), centre,
                                  amount, _arrays.number("clearance", clearance))
    if found is None:
        return None
    amount = found.pop("amount")
    turned = about is not None
    return FirstContact(distance=0.0 if turned else amount, degrees=amount if turned else 0.0, **found)


class Interpenetration(NamedTuple):
    """Two of the shapes that interpenetrate."""

    a: int  #: number among the shapes
    b: int
    crossings: int  #: pairs of faces that cross or touch
    contained: int  #: components of one inside the other, where no faces cross


def interpenetrations(shapes: Iterable[Any], poses: Iterable[ArrayLike], *,
                      positions: Optional[Iterable[Optional[ArrayLike]]] = None) -> list[Interpenetration]:
    """All pairs of shapes that interpenetrate, by exact predicates.

    Parameters
    ----------
    shapes : Shapes, or meshes as `Shape` takes them
    poses : (4, 4) arrays
    positions : (n, 3) arrays or None, optional
        World positions of the rows of `Shape.vertices` instead: the very numbers that another program has; their pose is
        then about where they are.

    Returns
    -------
    list of Interpenetration
        By numbers among the shapes.

    Raises
    ------
    BadInputError
        Not one of each, or an argument that is not accepted.
    """
    given = [_shape(one) for one in _arrays.listed("shapes", shapes, "a sequence of shapes")]
    matrices = _arrays.listed("poses", poses, "a sequence of (4, 4) arrays")
    where: list[Optional[ArrayLike]] = [None] * len(given)
    if positions is not None:
        where = _arrays.listed("positions", positions, "a sequence of (n, 3) arrays or None")
    if not len(given) == len(matrices) == len(where):
        raise BadInputError(f"{len(given)} shapes, {len(matrices)} poses and {len(where)} positions are not accepted; "
                            "accepted: one of each")
    entries = []
    for shape, pose, x in zip(given, matrices, where):
        placed = None if x is None else _arrays.vertices("positions", x)
        entries.append((shape._shape, _arrays.matrix("poses", pose), placed))
    return [Interpenetration(*one) for one in _trivet.interpenetrations(entries)]


def random_rotation(rng: np.random.Generator) -> list[float]:
    """A rotation w x y z, uniform among all: a point of the unit ball in four dimensions, made a unit.

    Without sine and cosine: the same bits wherever `rng` gives the same.

    Parameters
    ----------
    rng : numpy.random.Generator

    Returns
    -------
    list of 4 float
        w, x, y, z; of length 1.
    """
    if not isinstance(rng, (np.random.Generator, np.random.RandomState)):
        raise _arrays.refuse("rng", _arrays.short(rng), "a numpy.random.Generator, as by numpy.random.default_rng(7)")
    while True:
        q = rng.uniform(-1.0, 1.0, 4)
        squared = float(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        if 1e-4 < squared <= 1.0:
            return [float(x / np.sqrt(squared)) for x in q]
