"""Options of operations, as the compiled module takes them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from numpy.typing import ArrayLike

from . import _arrays
from ._named import name_of, names

if TYPE_CHECKING:
    from ._scene import Scene


def rotation(wxyz: Optional[ArrayLike]) -> Optional[list[float]]:
    return None if wxyz is None else _arrays.vector("wxyz", wxyz, 4)


def optional(what: str, value: Optional[float]) -> Optional[float]:
    return None if value is None else _arrays.number(what, value)


def points(what: str, value: Any, size: int) -> list[list[float]]:
    given = _arrays.listed(what, value, f"a sequence of points, {size} numbers each")
    return [_arrays.vector(what, one, size) for one in given]


def place(at: Any) -> Any:
    return at if at is None or isinstance(at, str) else _arrays.vector("at", at, 2)


_VECTORS = ("point", "centre", "axis", "normal")
_NUMBERS = ("step_up", "step_down")
_FLAGS = ("slide", "settle", "settle_left", "free")


def checked_options(options: dict[str, Any], scene: Scene) -> dict[str, Any]:
    """Options as operations have them; what an operation has not, it refuses itself."""
    out: dict[str, Any] = {}
    for key, value in options.items():
        if value is None:
            continue
        if key == "together":
            out[key] = names(key, value, scene)
        elif key == "with_":
            out["with"] = name_of(key, value, scene)
        elif key in _VECTORS:
            out[key] = _arrays.vector(key, value, 3)
        elif key in _NUMBERS:
            out[key] = _arrays.number(key, value)
        elif key in _FLAGS:
            out[key] = _arrays.flag(key, value)
        else:
            out[key] = _arrays.plain(key, value)
    return out
