"""Moves of an object that lies where it lies, or is held."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from numpy.typing import ArrayLike

from . import _arrays
from ._errors import BadInputError
from ._options import checked_options, points
from ._properties import Properties
from ._results import Result, checked


class Moves(Properties):
    """How an object is moved; see `trivet.Object`."""

    __slots__ = ()

    def push(self, direction: Optional[ArrayLike] = None, distance: Optional[float] = None, *,
             to: Optional[ArrayLike] = None, via: Optional[Sequence[ArrayLike]] = None, **options: Any) -> Result:
        """Push along the surface on which it lies; its loads come along.

        Parameters
        ----------
        direction, distance : (2,) array and float
            Seen from above; metres along it.
        to, via : (2,) array, sequence of them
            Instead: the target of its position, and waypoints.
        **options
            `normal` (of the surface, towards the object: along walls; `direction`, `to` and `via` are then to the right
            and upwards, seen from the object), `step_up`, `step_down` (metres), `slide`, `settle`, `settle_left` (bool),
            `together` (objects), `budget`.

        Returns
        -------
        Result
            `end` is "reached", "blocked" (by `blocked_by`), "step" or "edge".

        Raises
        ------
        Refused
            It lies on nothing, is fixed, or nothing can move.
        BadInputError
            Neither direction and distance nor `to`, or an option that it has not.
        """
        return checked(self.try_push(direction, distance, to=to, via=via, **options))

    def try_push(self, direction: Optional[ArrayLike] = None, distance: Optional[float] = None, *,
                 to: Optional[ArrayLike] = None, via: Optional[Sequence[ArrayLike]] = None, **options: Any) -> Result:
        """As `push`, with its parameters, but a refusal is returned: a `Result` that is false."""
        if to is not None:
            options["to"] = _arrays.vector("to", to, 2)
            if via is not None:
                options["via"] = points("via", via, 2)
        else:
            if direction is None or distance is None:
                raise BadInputError("push: without direction and distance; accepted: both of them, or to")
            options["direction"] = _arrays.vector("direction", direction, 2)
            options["distance"] = _arrays.number("distance", distance)
        return self._try(op="push", **checked_options(options, self._scene))

    def turn(self, degrees: float, about: str = "normal", **options: Any) -> Result:
        """Turn about a contact that is held: right-handed, degrees.

        Parameters
        ----------
        degrees : float
            Seen against the normal, line or axis.
        about : "normal", "line" or "point"
            Of the contact.
        **options
            `with_` (the partner of the contact), `point`, `centre`, `axis` ((3,), world), `settle`, `settle_left`,
            `together`, `budget`.

        Returns
        -------
        Result
            `turned_deg`, and why it ended.

        Raises
        ------
        Refused
            There is no such contact, or it is fixed.
        """
        return checked(self.try_turn(degrees, about, **options))

    def try_turn(self, degrees: float, about: str = "normal", **options: Any) -> Result:
        """As `turn`, with its parameters, but a refusal is returned: a `Result` that is false."""
        return self._try(op="turn", about=_arrays.text("about", about), angle_deg=_arrays.number("degrees", degrees), **checked_options(options, self._scene))

    def pick_up(self, distance: float, **options: Any) -> Result:
        """Lift along the contact's normal, its loads along with it; it is held then.

        Parameters
        ----------
        distance : float
            Metres.
        **options
            `with_` (the partner of the contact), `settle_left` (bool), `together` (objects), `budget`.

        Returns
        -------
        Result

        Raises
        ------
        Refused, OutOfTime, Cancelled
            The scene is as it was.
        """
        return checked(self._try(op="pick_up", distance=_arrays.number("distance", distance), **checked_options(options, self._scene)))

    def translate(self, by: ArrayLike, **options: Any) -> Result:
        """Move along a straight line up to a collision.

        Parameters
        ----------
        by : (3,) array
            World, metres.
        **options
            `via` (waypoints, (3,) metres from the start), `free` (through everything), `settle`, `settle_left` (bool),
            `together` (objects), `budget`.

        Returns
        -------
        Result
            `end` is "reached" or "blocked" (by `blocked_by`); `interpenetrates` after a free move.

        Raises
        ------
        Refused, OutOfTime, Cancelled
            The scene is as it was.
        """
        if options.get("via") is not None:
            options["via"] = points("via", options["via"], 3)
        return checked(self._try(op="translate", by=_arrays.vector("by", by, 3), **checked_options(options, self._scene)))

    def rotate(self, axis: ArrayLike, degrees: float, **options: Any) -> Result:
        """Turn about an axis up to a collision.

        Parameters
        ----------
        axis : (3,) array
            World, of any length but 0.
        degrees : float
            Right-handed.
        **options
            `centre` ((3,), world, metres; nothing: the centre of mass), `free` (through everything), `settle`,
            `settle_left` (bool), `together` (objects), `budget`.

        Returns
        -------
        Result
            `turned_deg`; `end` is "reached" or "blocked" (by `blocked_by`).

        Raises
        ------
        Refused, OutOfTime, Cancelled
            The scene is as it was.
        """
        return checked(self._try(op="rotate", axis=_arrays.vector("axis", axis, 3),
                                  angle_deg=_arrays.number("degrees", degrees), **checked_options(options, self._scene)))
