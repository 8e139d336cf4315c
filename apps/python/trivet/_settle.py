"""Rules by which operations settle."""

from __future__ import annotations

from typing import Any, Mapping, Optional

import numpy as np

from . import _arrays, _trivet
from ._errors import BadInputError

_FLAGS = ("accept_wedged", "perfect_friction", "robust", "whole_at_rest")
_NAMES = ("accept_wedged", "clearance", "max_motions", "perfect_friction", "robust", "whole_at_rest")
_LARGEST = float(np.finfo(float).max)


def _checked(name: str, value: Any) -> Any:
    if name in _FLAGS:
        return _arrays.flag(name, value)
    if name == "max_motions":
        return _arrays.whole(name, value, 1, 1_000_000_000)
    if name == "clearance":
        return _arrays.number(name, value, "metres, at least 0; 0 for 2^-20 of the size of what is near", 0.0, _LARGEST)
    raise BadInputError(f"{name}: there is no such option; accepted: {', '.join(_NAMES)}")


class Settle:
    """Rules by which operations of a scene settle; a value that is set holds from the next one on.

    Attributes
    ----------
    clearance : float
        Metres that objects stay apart; 0: 2^-20 of the size of what is within 10 m, at most 0.0095 mm (more for large objects).
    max_motions : int
        Operations that need more are refused, 1 to 1,000,000,000.
    perfect_friction, whole_at_rest, robust, accept_wedged : bool
        The rules of rest; see ``--perfect-friction``, ``--whole-at-rest``, ``--robust`` and ``--accept-wedged`` of
        ``trivet run``.
    """

    __slots__ = ("_options",)
    clearance: float
    max_motions: int
    perfect_friction: bool
    whole_at_rest: bool
    robust: bool
    accept_wedged: bool

    def __init__(self, options: _trivet.SettleOptions) -> None:
        object.__setattr__(self, "_options", options)

    def __getattr__(self, name: str) -> Any:
        if name not in _NAMES:
            raise AttributeError(f"{name}: there is no such option; accepted: {', '.join(_NAMES)}")
        return getattr(self._options, name)

    def __setattr__(self, name: str, value: Any) -> None:
        setattr(self._options, name, _checked(name, value))

    def __dir__(self) -> list[str]:
        return [*object.__dir__(self), *_NAMES]

    def __repr__(self) -> str:
        return f"<trivet.Settle {', '.join(f'{name}={getattr(self, name)}' for name in _NAMES)}>"


def settings(clearance: Optional[float], options: Mapping[str, Any],
             settle: Optional[_trivet.SettleOptions] = None) -> _trivet.SettleOptions:
    """`settle`, or the defaults, with these changes; what is None is left as it is."""
    settle = settle or _trivet.settle_options()
    for name, value in {"clearance": clearance, **options}.items():
        if value is not None or name not in _NAMES:
            setattr(settle, name, _checked(name, value))
    return settle


def detection(detector: Any, device: Any) -> tuple[str, str]:
    """Names of a choice of a detector; the module says which are accepted."""
    _arrays.text("detector", detector)
    if device == "auto":
        return detector, "auto"
    return detector, str(_arrays.whole("device", device, 1, 1_000_000))
