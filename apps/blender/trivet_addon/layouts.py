"""Layouts: the scene that Trivet has of Blender's, and what is asked of it. One interface, two ways. Without bpy.

`module.ModuleLayout` has it in this process, `program.ProgramLayout` in the program `trivet session`, over a pipe.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional, Protocol, Sequence, Tuple

import numpy as np

from .bodies import Body

UNITED = "what does not move"  # obstacles as one mesh


class LayoutError(Exception):
    """A layout that cannot be made or used; says why."""


@dataclass(frozen=True)
class Settings:
    """Settings that hold for a whole layout."""

    floor: bool = True
    clearance: float = 0.0  # metres; 0: 2^-20 of the scene's size
    seconds: float = 30.0  # an operation may take; 0: any time
    detector: str = "auto"  # as --detector of the program has it; no result depends on it
    device: int = 0  # EGL device of a GPU, from 1; 0: automatic

    @property
    def device_name(self) -> str:
        return str(self.device) if self.device else "auto"


@dataclass(frozen=True)
class Outcome:
    """The end of an operation; false when nothing was done."""

    ok: bool
    code: str = ""
    reason: str = ""
    objects: Tuple[str, ...] = ()
    end: str = ""
    blocked_by: str = ""
    gave_way: Tuple[str, ...] = ()
    carried: Tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return self.ok


@dataclass(frozen=True)
class Verdict:
    """A layout judged as a whole."""

    crossings: Tuple[Tuple[str, str], ...] = ()
    contained: Tuple[Tuple[str, str], ...] = ()
    not_at_rest: Tuple[str, ...] = ()
    topples: Tuple[str, ...] = ()
    stability: str = "stable"  # "stable", "marginal", "unstable", "unknown"
    margin: float = float("inf")  # metres by which all weights may be shifted sideways

    @property
    def stands(self) -> bool:
        return self.stability in ("stable", "marginal")


@dataclass(frozen=True)
class Status:
    """State of an object of a layout."""

    state: str  # "unplaced", "fixed", "stable", "wedged", "held", "unsupported", "invalid"
    supports: Tuple[str, ...] = ()
    loads: Tuple[str, ...] = ()
    margin: float = float("nan")  # metres
    least_friction: float = float("nan")


class Layout(Protocol):
    """Bodies by their names, at their origins: those of `out` are not in the scene until they are put."""

    def perform(self, operation: Mapping[str, Any]) -> Outcome:
        """An operation as a layout file has it."""

    def mend(self) -> Mapping[str, str]:
        """Brings free bodies that interpenetrate or hang to rest near where they are. Those that stay, and why."""

    def undo(self) -> None:
        """Takes the last operation back."""

    def pose(self, name: str) -> Optional[np.ndarray]:
        """(4, 4) from the body's vertices to the world; None: it is out of the scene."""

    def status(self, name: str) -> Status: ...

    def verdict(self) -> Verdict: ...

    def export(self, path: str, collision: str) -> list[str]:
        """Writes it for a simulator; files and notes."""

    def cancel(self) -> None:
        """From another thread: ends the operation under way."""

    def close(self) -> None: ...


_MOST_NAMES = 5


def few(names: Sequence[str], between: str = ", ") -> str:
    """The first ones, and how many more there are."""
    more = len(names) - _MOST_NAMES
    return between.join(names[:_MOST_NAMES]) + (f" and {more} more" if more > 0 else "")


def safe_names(names: Sequence[str]) -> dict:
    """{name in Blender: name in Trivet}, which has no "floor" of its own and no control characters."""
    out: dict = {}
    taken = {"floor", "", UNITED}
    for name in names:
        plain = "".join(c if c.isprintable() else "?" for c in name)
        safe, number = plain, 1
        while safe in taken:
            number += 1
            safe = f"{plain} ({number})"
        taken.add(safe)
        out[name] = safe
    return out


def near(bodies: Sequence[Body], about: set) -> list:
    """The bodies of `about`, and others whose boxes overlap one of theirs."""
    boxes = {body.name: body.bounds() for body in bodies}
    wanted = [boxes[name] for name in about if name in boxes]

    def meets(box: np.ndarray) -> bool:
        return any((box[0] <= other[1]).all() and (other[0] <= box[1]).all() for other in wanted)

    return [body for body in bodies if body.name in about or meets(boxes[body.name])]
