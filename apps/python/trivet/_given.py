"""Arguments of operations, as the compiled module takes them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable

from . import _arrays
from ._named import name_of, names

if TYPE_CHECKING:
    from ._scene import Scene


def _points(size: int) -> Callable[[str, Any, Scene], list[list[float]]]:
    def read(what: str, value: Any, scene: Scene) -> list[list[float]]:
        listed = _arrays.listed(what, value, f"a sequence of points, {size} numbers each")
        return [_arrays.vector(what, one, size) for one in listed]
    return read


def _vector(size: int) -> Callable[[str, Any, Scene], list[float]]:
    return lambda what, value, scene: _arrays.vector(what, value, size)


def _place(what: str, value: Any, scene: Scene) -> Any:
    return _arrays.text(what, value) if isinstance(value, str) else _arrays.vector(what, value, 2)


_READ: dict[str, Callable[[str, Any, Scene], Any]] = {
    "flag": lambda what, value, scene: _arrays.flag(what, value),
    "number": lambda what, value, scene: _arrays.number(what, value),
    "whole": lambda what, value, scene: _arrays.whole(what, value, 0, 2 ** 63 - 1),
    "text": lambda what, value, scene: _arrays.text(what, value),
    "word": lambda what, value, scene: _arrays.text(what, value),
    "vector2": _vector(2),
    "vector3": _vector(3),
    "vector4": _vector(4),
    "points2": _points(2),
    "points3": _points(3),
    "place": _place,
    "name": name_of,
    "names": names,
}


def given(scene: Scene, *arguments: tuple[str, str, str, Any, Any]) -> dict[str, Any]:
    """Arguments that are not their defaults, by their keys in layouts.

    Parameters
    ----------
    *arguments : (key, name, kind, value, default)
        The name is that of the parameter, for messages; None as a value is as if it were left out.
    """
    out = {}
    for key, name, kind, value, default in arguments:
        if value is None:
            continue
        read = _READ[kind](name, value, scene)
        if default is None or read != default:
            out[key] = read
    return out
