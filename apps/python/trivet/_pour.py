"""Heaps: objects that fall one after the other over another, onto each other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Union

import numpy as np
from numpy.typing import NDArray

from . import _arrays
from ._named import name_of
from ._named import names as _names

if TYPE_CHECKING:
    from ._object import Object

_MIDDLE = 0.35  # part of the support, about its middle, over which they fall
_MOST_TRIES = 12  # places of each
_GAP = 0.02  # above the heap, of the object's size
_TURNS = ("none", "up", "any")


class Pours:
    """Heaps in a scene; see `trivet.Scene`."""

    __slots__ = ()

    def pour(self: Any, objects: Iterable[Union[Object, str]], on: Union[Object, str], *, seed: int = 0,
             turn: str = "any") -> list[Object]:
        """Let objects that are out of the scene fall over the middle of another: a heap, a bowl of fruit, a box of toys.

        They fall one after the other from above all that lies there, and come to rest on it or on each other. One that
        rolls off wherever it falls stays out. One step of history.

        Parameters
        ----------
        objects : list of Object or str
            In the order in which they fall.
        on : Object or str
            It is in the scene.
        seed : int
            Each seed gives another heap; the same one gives the same bits.
        turn : "none", "up" or "any"
            How each is turned before it falls: as its shape is, about the vertical, every way.

        Returns
        -------
        list of Object
            Those that lie there.

        Raises
        ------
        BadInputError
            `on` is out of the scene, or one of the objects is in it.
        """
        if turn not in _TURNS:
            raise _arrays.refuse("turn", _arrays.short(turn), '"none", "up" or "any"')
        support = self[name_of("on", on, self)]
        given = _names("objects", objects, self)
        for name in given:
            if self[name].placed:
                raise _arrays.refuse("objects", _arrays.short(name), "objects that are out of the scene")
        if support.bounds is None:
            raise _arrays.refuse("on", _arrays.short(support.name), "an object that is in the scene")
        random = np.random.default_rng(_arrays.whole("seed", seed, 0, 2 ** 63))
        with self.transaction():
            return _Pouring(self, support, turn, random).all_of(given)


class _Pouring:
    """One heap while it grows."""

    def __init__(self, scene: Any, support: Object, turn: str, random: np.random.Generator) -> None:
        self._scene, self._turn, self._random = scene, turn, random
        self._low, self._high = np.asarray(support.bounds)
        self._top = float(self._high[2])

    def all_of(self, names: list[str]) -> list[Object]:
        out = []
        for name in names:
            one = self._scene[name]
            if any(self._falls_there(one) for _ in range(_MOST_TRIES)):
                out.append(one)
                self._top = max(self._top, float(one.bounds[1, 2]))
        return out

    def _falls_there(self, one: Object) -> bool:
        middle, radius = _ball(one)
        wxyz = _rotation(self._random, self._turn)
        centre, half = (self._low + self._high) / 2, _MIDDLE * (self._high - self._low) / 2
        at = centre[:2] + half[:2] * self._random.uniform(-1.0, 1.0, 2)
        start = np.array([at[0], at[1], self._top + (1 + _GAP) * radius]) - _turned(wxyz, middle)
        if not one.try_put(position=start, wxyz=wxyz):
            return False
        if self._is_over(one):
            return True
        self._scene.perform([{"op": "unplace", "object": one}])
        return False

    def _is_over(self, one: Object) -> bool:
        at = one.center_mass
        if at is None:
            return False
        return bool((self._low[:2] <= at[:2]).all() and (at[:2] <= self._high[:2]).all() and at[2] > self._low[2])


def _ball(one: Object) -> tuple[NDArray[Any], float]:
    """Middle of the shape's box, z up, and half its diagonal; metres."""
    low, high = one.shape.vertices.min(axis=0), one.shape.vertices.max(axis=0)
    x, y, z = one.scale * (low + high) / 2
    middle = np.array([x, -z, y] if one.up == "y" else [x, y, z])
    return middle, float(one.scale * np.sqrt(((high - low) ** 2).sum()) / 2)


def _turned(wxyz: Iterable[float], point: NDArray[Any]) -> NDArray[Any]:
    w, *axis = wxyz
    cross = 2 * np.cross(axis, point)
    out: NDArray[Any] = point + w * cross + np.cross(axis, cross)
    return out


def _rotation(random: np.random.Generator, turn: str) -> list[float]:
    """w x y z, uniform among those of `turn`."""
    if turn == "none":
        return [1.0, 0.0, 0.0, 0.0]
    while True:
        q = random.uniform(-1.0, 1.0, 4)
        if turn == "up":
            q[1] = q[2] = 0.0
        length = float(np.sqrt((q * q).sum()))
        if 0.01 < length <= 1.0:
            return [float(x) / length for x in q]
