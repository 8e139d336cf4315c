"""Arguments as the compiled module takes them, or a BadInputError that names what is wrong."""

from __future__ import annotations

import operator
import os
from typing import Any, Callable, Mapping, Optional, Sequence

import numpy as np
from numpy.typing import NDArray

from ._errors import BadInputError

_NUMBERS = "iuf"


def short(value: Any) -> str:
    try:
        text = " ".join(repr(value).split())
    except RecursionError:
        return f"a {type(value).__name__} of too many levels"
    return text if len(text) <= 60 else text[:57] + "..."


def refuse(what: str, given: str, accepted: str) -> BadInputError:
    return BadInputError(f"{what}: {given} is not accepted; accepted: {accepted}")


def _array(what: str, value: Any, accepted: str) -> NDArray[Any]:
    if isinstance(value, np.ma.MaskedArray) and np.any(value.mask):
        raise refuse(what, "a masked array", accepted)
    try:
        array = np.asarray(value)
    except (ValueError, TypeError) as error:
        raise refuse(what, short(value), accepted) from error
    if array.dtype.kind not in _NUMBERS and array.size > 0:
        raise refuse(what, f"{short(value)} of type {array.dtype}", accepted)
    return array


def vector(what: str, value: Any, *sizes: int) -> list[float]:
    """So many finite numbers, by one of `sizes`, as a list."""
    accepted = f"{' or '.join(map(str, sizes))} finite numbers"
    array = _array(what, value, accepted)
    if array.ndim != 1 or len(array) not in sizes:
        raise refuse(what, f"{short(value)} of shape {array.shape}", accepted)
    if not np.isfinite(array).all():
        raise refuse(what, short(array.tolist()), accepted)
    return [float(x) for x in array]


def number(what: str, value: Any, accepted: str = "a number", lowest: float = -np.inf, highest: float = np.inf) -> float:
    """One number of this range; no text, no truth value, no NaN."""
    if isinstance(value, (str, bytes, bool, np.bool_)):
        raise refuse(what, short(value), accepted)
    try:
        out = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise refuse(what, short(value), accepted) from error
    if not lowest <= out <= highest:
        raise refuse(what, short(value), accepted)
    return out


def seconds(what: str, value: Optional[float]) -> float:
    """A budget; nothing: unlimited, as 0."""
    return 0.0 if value is None else number(what, value, "seconds, at least 0", 0.0, float(np.finfo(float).max))


def whole(what: str, value: Any, lowest: int, highest: int) -> int:
    """A whole number of this range."""
    accepted = f"a whole number from {lowest} to {highest}"
    try:
        number = operator.index(value)
    except TypeError:
        raise refuse(what, short(value), accepted) from None
    if not lowest <= number <= highest:
        raise refuse(what, short(value), accepted)
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
        raise refuse(f"{what}: row {row}", short(array[row].tolist()), accepted)
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


def flag(what: str, value: Any) -> bool:
    """True or False, and not what Python takes for one of them."""
    if not isinstance(value, (bool, np.bool_)):
        raise refuse(what, short(value), "True or False")
    return bool(value)


def text(what: str, value: Any) -> str:
    """A str that UTF-8 has: no half of a surrogate pair."""
    if not isinstance(value, str):
        raise refuse(what, short(value), "a str")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise refuse(what, short(value), "a str that UTF-8 has") from None
    return value


def path(what: str, value: Any) -> str:
    """A path as a str."""
    accepted = "a path: a str or os.PathLike, not empty, without NUL"
    try:
        name = os.fspath(value)
    except TypeError:
        raise refuse(what, short(value), accepted) from None
    name = os.fsdecode(name)
    if not name or "\0" in name:
        raise refuse(what, short(value), accepted)
    return text(what, name)


def listed(what: str, value: Any, accepted: str) -> list[Any]:
    """A list of anything that can be iterated over, but for texts."""
    if isinstance(value, (str, bytes)):
        raise refuse(what, short(value), accepted)
    try:
        items = iter(value)
    except TypeError:
        raise refuse(what, short(value), accepted) from None
    return list(items)


def mapping(what: str, value: Any, accepted: str) -> Mapping[Any, Any]:
    if not isinstance(value, Mapping):
        raise refuse(what, short(value), accepted)
    return value


def callback(what: str, value: Any) -> Optional[Callable[..., Any]]:
    if value is not None and not callable(value):
        raise refuse(what, short(value), "a function, or None")
    return value  # type: ignore[no-any-return]


def plain(what: str, value: Any, named: Callable[[str, Any], Any] = lambda _, value: value, depth: int = 64) -> Any:
    """A part of an operation as the compiled module takes it: numbers, texts, lists and dicts; of NumPy, too.

    `named` gives the names of objects, and other values as they are.
    """
    value = named(what, value)
    if value is None or isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, str):
        return text(what, value)
    if isinstance(value, np.floating):  # not by tolist(), which leaves a long double as it is
        return float(value)
    if depth > 0:
        if isinstance(value, (np.generic, np.ndarray)):
            return plain(what, value.tolist(), named, depth - 1)
        if isinstance(value, Mapping):
            return {text(what, key): plain(f"{what}: /{key}", one, named, depth - 1) for key, one in value.items()}
        if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
            return [plain(what, one, named, depth - 1) for one in value]
    raise refuse(what, short(value), "numbers, texts, and lists and dicts of them, up to 64 within each other")
