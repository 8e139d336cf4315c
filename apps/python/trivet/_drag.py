"""Drags: an operation that follows a hand."""

from __future__ import annotations

from types import TracebackType
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays, _trivet
from ._errors import BadInputError, SceneBusy
from ._given import given
from ._operations import PARAMETERS
from ._results import Result, done, result_of

if TYPE_CHECKING:
    from ._scene import Scene

# Arguments that an operation needs to begin; a drag gives its extent as it goes.
_EXTENT: dict[str, dict[str, Any]] = {
    "push": {"direction": [1.0, 0.0], "distance": 0.0},
    "turn": {"angle_deg": 0.0},
    "pick_up": {"distance": 0.0},
    "translate": {"by": [0.0, 0.0, 0.0]},
    "rotate": {"axis": [0.0, 0.0, 1.0], "angle_deg": 0.0},
}


def _options(op: str, options: dict[str, Any], scene: Scene) -> dict[str, Any]:
    parameters = PARAMETERS[op]
    for name in options:
        if name not in parameters:
            raise BadInputError(f'{op}: unknown option "{name}"; accepted: {", ".join(parameters)}')
    return given(scene, *((parameters[name][0], name, parameters[name][1], value, None) for name, value in options.items()))


class Drag:
    """An operation that follows a hand, and is done once, when the block ends.

    Nothing changes in the scene meanwhile, and nothing else may change it; other threads wait. When the block raises, or
    after `cancel`, nothing was done. Afterwards `result` has what the operation gave; a refusal is raised. It belongs to the
    thread that began it: calls in others, and while another of its calls is at work, raise `SceneBusy`, and it goes on.

    >>> with scene.drag("plate", "push") as hand:     # doctest: +SKIP
    ...     for x, y in mouse:
    ...         hand.follow([x, y])
    """

    def __init__(self, scene: Scene, name: str, op: str, options: dict[str, Any]) -> None:
        if not isinstance(op, str) or op not in _EXTENT:
            raise _arrays.refuse("op", _arrays.short(op), ", ".join(_EXTENT))
        self._scene = scene
        self._operation = {"op": op, "object": name, **_EXTENT[op], **_options(op, options, scene)}
        self._drag: Optional[_trivet.Drag] = None
        self.result: Optional[Result] = None

    def __enter__(self) -> Drag:
        self._drag = self._scene._scene.drag(self._operation)
        return self

    def __exit__(self, kind: Optional[type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        drag = self._drag
        if drag is None:
            return
        try:
            if kind is None:
                self.result = done(drag.finish())
        finally:
            drag.end()  # in another thread it raises, and the drag goes on
            self._drag = None

    def _live(self) -> _trivet.Drag:
        if self._drag is None:
            raise SceneBusy("the drag has not begun or has ended; accepted: in its block")
        return self._drag

    def follow(self, goal: ArrayLike) -> Result:
        """Go on to here, as far as it goes.

        Parameters
        ----------
        goal : (2,) or (3,) array, or float
            "push": where its position is to be, seen from above. "translate": (3,) metres from the start. "turn" and
            "rotate": degrees from the start. "pick_up": metres.

        Returns
        -------
        Result
            Of this motion: `end`, `blocked_by`, ...; false when the drag is refused, and goes no further.
        """
        op = self._operation["op"]
        if op in ("push", "translate"):
            point = _arrays.vector("goal", goal, 2, 3) if op == "push" else _arrays.vector("goal", goal, 3)
            return result_of(self._live().follow_point(np.array([*point, 0.0][:3])))
        return result_of(self._live().follow_amount(_arrays.number("goal", goal, f"a number for {op!r}")))

    def poses(self) -> dict[str, NDArray[np.float64]]:
        """(4, 4) poses of the object and its loads where the hand has them."""
        return dict(self._live().placements())

    def cancel(self) -> None:
        """End it; nothing was done."""
        self._live().end()
        self._drag = None
