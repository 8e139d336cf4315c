"""An object of a scene, and what is done with it."""

from __future__ import annotations

from typing import Any, Optional, Union

from numpy.typing import ArrayLike

from . import _arrays
from ._errors import BadInputError
from ._moves import Moves
from ._named import name_of
from ._options import optional, place, rotation
from ._results import Result, checked

Other = Union["Object", str]


class Object(Moves):
    """An object of a scene: the scene and a name for ever, never a pointer.

    Every property is looked up when it is asked for; once the object is deleted, `NoSuchObject` is raised (undo brings it
    back). Pickles and copies with its scene. Lengths in metres, world: z up. Operations raise `Refused`; ``try_put`` and so
    on return the `Result` instead.
    """

    __slots__ = ()

    @property
    def supports(self) -> list[Other]:
        """What it rests on: objects, and "floor"."""
        return [name if name == "floor" else self._scene[name] for name in self._ask(self._scene._scene.supports)]

    def loads(self, recursive: bool = False) -> list[Object]:
        """What rests on it.

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

    def put(self, position: Optional[ArrayLike] = None, wxyz: Optional[ArrayLike] = None, *, on: Optional[Other] = None,
            at: Optional[ArrayLike] = None, keep: float = 0.0, seed: int = 0, least_margin: float = 0.0,
            most_friction: Optional[float] = None, tries: int = 1, within: float = 0.5, settle_left: bool = False,
            budget: Optional[float] = None) -> Result:
        """Let the object fall from where it is held, settle, and prove that it rests.

        Nothing interpenetrates afterwards, in float64 and as exported in float32; otherwise the scene is as it was.

        Parameters
        ----------
        position : (3,) array, optional
            Where the origin of the shape is let go, metres, z up; nothing: where it is now. Not with `on`.
        wxyz : (4,) array, optional
            Its rotation there, a quaternion of any length; nothing: none, or that it has now if `position` is left out.
        on : Object or "floor", optional
            Instead of `position`: wherever there is room on this.
        at : (2,) array or "anywhere", optional
            With `on`, as the four below: nearest to this point, seen from above, metres. Anywhere: as `seed` says.
        keep : float
            Metres from all but the support.
        seed : int
            Selects the place of ``at="anywhere"``.
        least_margin : float
            Metres of its centre of mass from where it would tip, at rest; other places are tried.
        most_friction : float, optional
            Coulomb's coefficient that it may need to stay there; other places are tried.
        tries : int
            Starts to try, from 1 to 64; not with `on`. Where it would topple or be wedged, it is turned about the vertical,
            moved, and let fall again, in the same container; `Result.try_number` says which start it was.
        within : float
            Largest distance of these from `position`, in parts of the object's size.
        settle_left : bool
            Objects that it leaves without support settle, too; else they are named in `Result.unsupported`.
        budget : float, optional
            Seconds; `OutOfTime` is raised beyond.

        Returns
        -------
        Result

        Raises
        ------
        Refused
            With a `code` ("wedged", "crossing", "nothing_below", "no_free_place", ...) and the `objects` in the way.
        OutOfTime, Cancelled, KeyboardInterrupt
            The scene is as it was.
        BadInputError
            An argument is not accepted.
        """
        return checked(self.try_put(position, wxyz, on=on, at=at, keep=keep, seed=seed, least_margin=least_margin,
                                     most_friction=most_friction, tries=tries, within=within,
                                     settle_left=settle_left, budget=budget))

    def try_put(self, position: Optional[ArrayLike] = None, wxyz: Optional[ArrayLike] = None, *,
                on: Optional[Other] = None, at: Optional[ArrayLike] = None, keep: float = 0.0, seed: int = 0,
                least_margin: float = 0.0, most_friction: Optional[float] = None, tries: int = 1,
                within: float = 0.5, settle_left: bool = False, budget: Optional[float] = None) -> Result:
        """As `put`, with its parameters, but a refusal is returned: a `Result` that is false."""
        flag = _arrays.flag("settle_left", settle_left) or None
        if on is not None:
            if position is not None:
                raise BadInputError("put: position and on are given; accepted: one of them")
            if tries != 1:
                raise BadInputError("put: on and tries are given; accepted: one of them, as on tries places of its own")
            return self._put_on(on, budget, at=place(at), seed=_arrays.whole("seed", seed, 0, 2 ** 63 - 1),
                                keep=_arrays.number("keep", keep),
                                least_margin=_arrays.number("least_margin", least_margin),
                                most_friction=optional("most_friction", most_friction), rotation=rotation(wxyz),
                                settle_left=flag)
        self._refuse_without_on(at=(at, None), keep=(keep, 0), seed=(seed, 0), least_margin=(least_margin, 0),
                                most_friction=(most_friction, None))
        if position is None:
            position = self.position
            if position is None:
                raise BadInputError(f'put "{self._name}": it is out of the scene; accepted: with position, or on')
            wxyz = self.wxyz if wxyz is None else wxyz
        return self._try(budget, op="put", position=_arrays.vector("position", position, 3), rotation=rotation(wxyz),
                         tries=_arrays.whole("tries", tries, 1, 64), within=_arrays.number("within", within),
                         settle_left=flag)

    def _put_on(self, on: Other, budget: Optional[float], **options: Any) -> Result:
        return self._try(budget, op="put", on=name_of("on", on, self._scene), **options)

    def _refuse_without_on(self, **options: tuple[Any, Any]) -> None:
        """A forgotten `on` must not give another place than that which was asked for."""
        given = [name for name, (value, usual) in options.items()
                 if not (value is usual or isinstance(value, (int, float)) and value == usual)]
        if given:
            raise BadInputError(f'put "{self._name}": {", ".join(given)} without on; accepted: with on, an object or '
                                '"floor"')

    def stand(self, position: ArrayLike, wxyz: Optional[ArrayLike] = None) -> Result:
        """Stand exactly here: tested for interpenetration, not settled; its `state` says whether it rests.

        Parameters
        ----------
        position : (3,) array
            Of the shape's origin, world, metres.
        wxyz : (4,) array, optional
            Rotation, a quaternion of any length; nothing: none.

        Returns
        -------
        Result

        Raises
        ------
        Refused
            "crossing", "inside", "below_floor", ..., with the `objects`.
        """
        return checked(self._try(op="stand", position=_arrays.vector("position", position, 3), rotation=rotation(wxyz)))

    def unplace(self, settle_left: bool = False) -> Result:
        """Take it out of the scene; it can be put again.

        Parameters
        ----------
        settle_left : bool
            Objects that it leaves without support settle; else they are named in `Result.unsupported`.

        Returns
        -------
        Result
        """
        return checked(self._try(op="unplace", settle_left=_arrays.flag("settle_left", settle_left) or None))

    def remove(self, settle_left: bool = False) -> Result:
        """Delete it.

        Parameters
        ----------
        settle_left : bool
            As for `unplace`.

        Returns
        -------
        Result
        """
        return checked(self._try(op="delete", settle_left=_arrays.flag("settle_left", settle_left) or None))

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
