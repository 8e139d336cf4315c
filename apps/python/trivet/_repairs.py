"""Many objects at once: places by relations, and scenes that are repaired."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Mapping, Union

from . import _arrays
from ._object import Object

if TYPE_CHECKING:
    from ._results import Result


class Repairs:
    """Arranging, mending and settling of a scene; see `trivet.Scene`."""

    __slots__ = ()

    def arrange(self: Any, problem: Mapping[str, Any], *, budget: float = 0.0) -> Result:
        """Places for several objects at once, by relations between them; one step of history.

        Parameters
        ----------
        problem : mapping
            As ``trivet schema arrange`` has it: ``{"seed": 7, "things": [{"objects": "cup_*"}], "relations": [{"is": "on",
            "a": "*", "b": "table"}]}``. Without ``"things"``: all objects that are out of the scene.
        budget : float
            Seconds; 0: those of `time_budget`.

        Returns
        -------
        Result
            `settled` has the things in the order in which they were put.

        Raises
        ------
        Refused
            Not all can be met: ``"no_arrangement"``, with the objects of the conflict and the metres that are ``"missing"``.
        """
        given = _arrays.mapping("problem", problem, "a dict, as trivet schema arrange has it")
        result: Result = self.perform([{"op": "arrange", **given}], budget=budget)
        return result

    def mend(self: Any, only: Iterable[Union[Object, str]] = (), tolerance: float = 0.0, *,
             budget: float = 0.0) -> dict[str, Any]:
        """Finds the nearest scene in which nothing interpenetrates, everything rests, and what stood on what still does.

        One step of history. What is at rest stays, to the bit; what finds no place stays where it was, and is named.

        Parameters
        ----------
        only : objects or names
            Objects that may move; none: all that are free.
        tolerance : float
            Metres by which poses may be off; 0: found from the poses.
        budget : float
            Seconds for all; 0: those of `time_budget`. What is left then stays where it was.

        Returns
        -------
        dict
            "moved", each with "object", "from", "to" (metres), "metres", "degrees"; "unable", each with "object" and
            "why"; "tolerance", "supports_meant", "supports_kept", "relations" (names lost and gained).
        """
        return _repaired(self, {"op": "mend", "only": only, "tolerance": tolerance}, budget)

    def settle_all(self: Any, only: Iterable[Union[Object, str]] = (), lift: float = 0.2, *,
                   budget: float = 0.0) -> dict[str, Any]:
        """Lets what floats or is sunk come to rest, the lowest first; one step of history.

        Parameters
        ----------
        only, budget
            As for `mend`.
        lift : float
            Largest height, metres, to lift an object before it is let go.

        Returns
        -------
        dict
            "moved" and "unable", as of `mend`.
        """
        return _repaired(self, {"op": "settle", "only": only, "lift": lift}, budget)


def _repaired(scene: Any, operation: dict[str, Any], budget: float) -> dict[str, Any]:
    only = [operation["only"]] if isinstance(operation["only"], (str, Object)) else list(operation["only"])
    result: Result = scene.perform([{**operation, "only": only}], budget=budget)
    return result.repaired or {}
