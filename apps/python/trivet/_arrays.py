"""Arguments as the compiled module takes them, or a BadInputError that names what is wrong."""

from __future__ import annotations

import operator
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from ._errors import BadInputError

_NUMBERS = "iuf"


def _text(value: Any) -> str:
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else text[:57] + "..."


def refuse(what: str, given: str, accepted: str) -> BadInputError:
    return BadInputError(f"{what}: {given} is not accepted; accepted: {accepted}")


def _array(what: str, value: Any, accepted: str) -> NDArray[Any]:
    try:
        array = np.asarray(value)
    except (ValueError, TypeError) as error:
        raise refuse(what, _text(value), accepted) from error
    if array.dtype.kind not in _NUMBERS and array.size > 0:
        raise refuse(what, f"{_text(value)} of type {array.dtype}", accepted)
    return array


def vector(what: str, value: Any, size: int) -> list[float]:
    """`size` finite numbers as a list."""
    accepted = f"{size} finite numbers"
    array = _array(what, value, accepted)
    if array.shape != (size,):
        raise refuse(what, f"{_text(value)} of shape {array.shape}", accepted)
    if not np.isfinite(array).all():
        raise refuse(what, _text(array.tolist()), accepted)
    return [float(x) for x in array]


def number(what: str, value: Any) -> float:
    """One number; the operation says which."""
    try:
        return float(value)
    except (TypeError, ValueError) as error:
        raise refuse(what, _text(value), "a number") from error


def whole(what: str, value: Any, lowest: int, highest: int) -> int:
    """A whole number of this range."""
    accepted = f"a whole number from {lowest} to {highest}"
    try:
        number = operator.index(value)
    except TypeError:
        raise refuse(what, _text(value), accepted) from None
    if not lowest <= number <= highest:
        raise refuse(what, _text(value), accepted)
    return number


def matrix(what: str, value: Any, side: int = 4) -> NDArray[np.float64]:
    """(4, 4), or (side, side), of finite numbers."""
    accepted = f"a ({side}, {side}) array of finite numbers"
    array = _array(what, value, accepted)
    if array.shape != (side, side):
        raise refuse(what, f"an array of shape {array.shape}", accepted)
    return np.ascontiguousarray(array, dtype=np.float64)


def vertices(what: str, value: Any) -> NDArray[np.float64]:
    """(n, 3) of finite numbers."""
    accepted = "(n, 3) finite numbers"
    array = _array(what, value, accepted)
    if array.ndim != 2 or array.shape[1] != 3:
        raise refuse(what, f"an array of shape {array.shape}", accepted)
    finite = np.isfinite(array)
    if not finite.all():
        row = int(np.argmin(finite.all(axis=1)))
        raise refuse(f"{what}: row {row}", _text(array[row].tolist()), accepted)
    return np.ascontiguousarray(array, dtype=np.float64)


def faces(what: str, value: Any, num_vertices: int) -> NDArray[np.int32]:
    """(m, 3) of whole numbers from 0 to `num_vertices` - 1."""
    accepted = "(m, 3) whole numbers; triangulate other polygons first"
    array = _array(what, value, accepted)
    if array.ndim != 2 or array.shape[1] != 3:
        raise refuse(what, f"an array of shape {array.shape}", accepted)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise refuse(what, f"an array of {array.dtype}", accepted)
    if array.size > 0 and not (0 <= int(array.min()) and int(array.max()) < num_vertices):
        wrong = np.argwhere((array < 0) | (array >= num_vertices))[0]
        raise refuse(f"{what}: row {wrong[0]}", f"vertex {array[tuple(wrong)]}",
                     f"0 to {num_vertices - 1}")
    return np.ascontiguousarray(array, dtype=np.int32)


def names(what: str, value: Any) -> list[str]:
    """Names of objects, given as objects or names."""
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise refuse(what, _text(value), "a sequence of objects or their names")
    return [name_of(what, one) for one in value]


def name_of(what: str, value: Any) -> str:
    """Name of an object, given as the object or its name."""
    name = getattr(value, "name", value)
    if not isinstance(name, str):
        raise refuse(what, _text(value), "an object or its name")
    return name
