"""An object of a scene, and what is done with it."""

from __future__ import annotations

from typing import Any, Optional, Union

from . import _arrays
from ._errors import BadInputError
from ._operations import Operations
from ._results import Result

Other = Union["Object", str]


class Object(Operations):
    """An object of a scene: the scene and a name for ever, never a pointer.

    Every property is looked up when it is asked for; once the object is deleted, `NoSuchObject` is raised (undo brings it
    back). Pickles and copies with its scene. Lengths in metres, world: z up. Operations raise `Refused`; ``try_put`` and so
    on return the `Result` instead.
    """

    __slots__ = ()

    @property
    def supports(self) -> list[Other]:
        """Supports: objects, and "floor"."""
        return [name if name == "floor" else self._scene[name] for name in self._ask(self._scene._scene.supports)]

    def loads(self, recursive: bool = False) -> list[Object]:
        """Loads: objects that rest on it.

        Parameters
        ----------
        recursive : bool
            All that moves along with it, groups too.

        Returns
        -------
        list of Object
        """
        return [self._scene[name] for name in self._scene._scene.loads(self._key, self._name,
                                                                      _arrays.flag("recursive", recursive))]

    def _perform(self, op: str, budget: Optional[float], arguments: dict[str, Any]) -> Result:
        # PUT falls from where the object is now, unless another place is given.
        if op == "put" and not arguments.keys() & {"position", "on", "at"}:
            arguments = {**self._here(), **arguments}
        return super()._perform(op, budget, arguments)

    def _here(self) -> dict[str, Any]:
        position, wxyz = self.position, self.wxyz
        if position is None or wxyz is None:
            raise BadInputError(f'put "{self._name}": it is out of the scene; accepted: with position, or on')
        return {"position": position.tolist(), "rotation": wxyz.tolist()}

    def duplicate(self, name: str) -> Object:
        """A new object of the same shape, scale and material, out of the scene until it is put.

        Parameters
        ----------
        name : str
            Not taken.

        Returns
        -------
        Object

        Raises
        ------
        Refused
            "name_taken".
        """
        self._do(op="duplicate", **{"as": _arrays.text("name", name)})
        return self._scene[name]

    def rename(self, name: str) -> Object:
        """It under another name; nothing moves. This one has the old name, and is gone until the step is undone.

        Parameters
        ----------
        name : str
            Not taken.

        Returns
        -------
        Object

        Raises
        ------
        Refused
            "name_taken".
        """
        self._do(op="rename", to=_arrays.text("name", name))
        return self._scene[name]
