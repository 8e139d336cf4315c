"""An object of a scene, and what is done with it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence, Union

from numpy.typing import ArrayLike

from . import _arrays
from ._errors import BadInputError
from ._named import name_of, names
from ._properties import Properties
from ._results import Result, raise_for

if TYPE_CHECKING:
    from ._scene import Scene

Other = Union["Object", str]


class Object(Properties):
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
        """What rests on it; with `recursive` all that moves along with it, groups too."""
        return [self._scene[name] for name in self._scene._scene.loads(self._key, self._name,
                                                                      _arrays.flag("recursive", recursive))]

    def put(self, position: Optional[ArrayLike] = None, wxyz: Optional[ArrayLike] = None, *, on: Optional[Other] = None,
            at: Optional[ArrayLike] = None, keep: float = 0.0, seed: int = 0, least_margin: float = 0.0,
            most_friction: Optional[float] = None, settle_left: bool = False,
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
        return _checked(self.try_put(position, wxyz, on=on, at=at, keep=keep, seed=seed, least_margin=least_margin,
                                     most_friction=most_friction, settle_left=settle_left, budget=budget))

    def try_put(self, position: Optional[ArrayLike] = None, wxyz: Optional[ArrayLike] = None, *,
                on: Optional[Other] = None, at: Optional[ArrayLike] = None, keep: float = 0.0, seed: int = 0,
                least_margin: float = 0.0, most_friction: Optional[float] = None, settle_left: bool = False,
                budget: Optional[float] = None) -> Result:
        """As `put`, but a refusal is returned."""
        flag = _arrays.flag("settle_left", settle_left) or None
        if on is not None:
            if position is not None:
                raise BadInputError("put: position and on are given; accepted: one of them")
            return self._put_on(on, budget, at=_place(at), seed=_arrays.whole("seed", seed, 0, 2 ** 63 - 1),
                                keep=_arrays.number("keep", keep),
                                least_margin=_arrays.number("least_margin", least_margin),
                                most_friction=_optional("most_friction", most_friction), rotation=_rotation(wxyz),
                                settle_left=flag)
        self._refuse_without_on(at=(at, None), keep=(keep, 0), seed=(seed, 0), least_margin=(least_margin, 0),
                                most_friction=(most_friction, None))
        if position is None:
            position = self.position
            if position is None:
                raise BadInputError(f'put "{self._name}": it is out of the scene; accepted: with position, or on')
            wxyz = self.wxyz if wxyz is None else wxyz
        return self._try(budget, op="put", position=_arrays.vector("position", position, 3), rotation=_rotation(wxyz),
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
        """Stand exactly here: tested for interpenetration, not settled; its `state` says whether it rests."""
        return _checked(self._try(op="stand", position=_arrays.vector("position", position, 3), rotation=_rotation(wxyz)))

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
        """
        return _checked(self.try_push(direction, distance, to=to, via=via, **options))

    def try_push(self, direction: Optional[ArrayLike] = None, distance: Optional[float] = None, *,
                 to: Optional[ArrayLike] = None, via: Optional[Sequence[ArrayLike]] = None, **options: Any) -> Result:
        """As `push`, but a refusal is returned."""
        if to is not None:
            options["to"] = _arrays.vector("to", to, 2)
            if via is not None:
                options["via"] = _points("via", via, 2)
        else:
            if direction is None or distance is None:
                raise BadInputError("push: without direction and distance; accepted: both of them, or to")
            options["direction"] = _arrays.vector("direction", direction, 2)
            options["distance"] = _arrays.number("distance", distance)
        return self._try(op="push", **_options(options, self._scene))

    def turn(self, degrees: float, about: str = "normal", **options: Any) -> Result:
        """Turn about a contact that is held: right-handed, degrees.

        Parameters
        ----------
        degrees : float
        about : "normal", "line" or "point"
        **options
            `with_` (the partner of the contact), `point`, `centre`, `axis` ((3,), world), `settle`, `settle_left`,
            `together`, `budget`.
        """
        return _checked(self.try_turn(degrees, about, **options))

    def try_turn(self, degrees: float, about: str = "normal", **options: Any) -> Result:
        """As `turn`, but a refusal is returned."""
        return self._try(op="turn", about=_arrays.text("about", about), angle_deg=_arrays.number("degrees", degrees), **_options(options, self._scene))

    def pick_up(self, distance: float, **options: Any) -> Result:
        """Lift along the contact's normal, metres; it is held then. Options: `with_`, `settle_left`, `together`."""
        return _checked(self._try(op="pick_up", distance=_arrays.number("distance", distance), **_options(options, self._scene)))

    def translate(self, by: ArrayLike, **options: Any) -> Result:
        """Move along a straight line up to a collision: (3,) metres.

        Options: `via` (waypoints), `free` (through everything), `settle`, `settle_left`, `together`.
        """
        if options.get("via") is not None:
            options["via"] = _points("via", options["via"], 3)
        return _checked(self._try(op="translate", by=_arrays.vector("by", by, 3), **_options(options, self._scene)))

    def rotate(self, axis: ArrayLike, degrees: float, **options: Any) -> Result:
        """Turn about an axis up to a collision: (3,), right-handed degrees.

        Options: `centre` ((3,); nothing: the centre of mass), `free`, `settle`, `settle_left`, `together`.
        """
        return _checked(self._try(op="rotate", axis=_arrays.vector("axis", axis, 3),
                                  angle_deg=_arrays.number("degrees", degrees), **_options(options, self._scene)))

    def unplace(self, settle_left: bool = False) -> Result:
        """Take it out of the scene; it can be put again."""
        return _checked(self._try(op="unplace", settle_left=_arrays.flag("settle_left", settle_left) or None))

    def remove(self, settle_left: bool = False) -> Result:
        """Delete it."""
        return _checked(self._try(op="delete", settle_left=_arrays.flag("settle_left", settle_left) or None))

    def duplicate(self, name: str) -> Object:
        """A new object of the same shape, scale and material, out of the scene until it is put."""
        self._do(op="duplicate", **{"as": _arrays.text("name", name)})
        return self._scene[name]

    def rename(self, name: str) -> Object:
        """It under another name; nothing moves. This one has the old name, and is gone until the step is undone."""
        self._do(op="rename", to=_arrays.text("name", name))
        return self._scene[name]


def _rotation(wxyz: Optional[ArrayLike]) -> Optional[list[float]]:
    return None if wxyz is None else _arrays.vector("wxyz", wxyz, 4)


def _optional(what: str, value: Optional[float]) -> Optional[float]:
    return None if value is None else _arrays.number(what, value)


def _points(what: str, value: Any, size: int) -> list[list[float]]:
    points = _arrays.listed(what, value, f"a sequence of points, {size} numbers each")
    return [_arrays.vector(what, one, size) for one in points]


def _place(at: Any) -> Any:
    return at if at is None or isinstance(at, str) else _arrays.vector("at", at, 2)


def _checked(result: Result) -> Result:
    if not result:
        raise_for(result)
    return result


_VECTORS = ("point", "centre", "axis", "normal")
_NUMBERS = ("step_up", "step_down")
_FLAGS = ("slide", "settle", "settle_left", "free")


def _options(options: dict[str, Any], scene: Scene) -> dict[str, Any]:
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
