"""Properties of an object of a scene, looked up each time."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from . import _arrays
from ._results import Result, done, result_of
from ._shape import Shape

if TYPE_CHECKING:
    from ._scene import Scene

Material = Union[str, Mapping[str, float]]
Array = NDArray[np.float64]
T = TypeVar("T")


class Properties:
    """An object's properties; see `trivet.Object`."""

    __slots__ = ("_scene", "_key", "_name")

    def __init__(self, scene: Scene, key: int, name: str) -> None:
        self._scene = scene
        self._key = key
        self._name = name

    @property
    def name(self) -> str:
        """Its name in the scene."""
        return self._name

    @property
    def scene(self) -> Scene:
        """Where it is."""
        return self._scene

    def _ask(self, query: Callable[[int, str], T]) -> T:
        return query(self._key, self._name)

    @property
    def pose(self) -> Optional[Array]:
        """(4, 4): rotation and translation, without the scale; None when it is out of the scene."""
        return self._ask(self._scene._scene.pose)

    @property
    def matrix(self) -> Optional[Array]:
        """(4, 4): takes `shape.vertices` to the world, metres, with scale and the turn of y to z; None likewise."""
        return self._ask(self._scene._scene.matrix)

    @property
    def position(self) -> Optional[Array]:
        """(3,): where the shape's origin is; None likewise."""
        return self._ask(self._scene._scene.position)

    @property
    def wxyz(self) -> Optional[Array]:
        """(4,): its rotation as a unit quaternion w x y z; None likewise."""
        return self._ask(self._scene._scene.wxyz)

    @property
    def center_mass(self) -> Optional[Array]:
        """(3,): centre of mass, world; None likewise."""
        return self._ask(self._scene._scene.center_mass)

    @property
    def bounds(self) -> Optional[Array]:
        """(2, 3): a world box that holds it, perhaps a little larger; None likewise."""
        return self._ask(self._scene._scene.bounds)

    @property
    def shape(self) -> Shape:
        """Its triangles; objects share them."""
        return Shape._of(self._ask(self._scene._scene.shape))

    @property
    def state(self) -> str:
        """"unplaced", "fixed", "stable", "wedged", "held", "unsupported" or "invalid"."""
        return self._ask(self._scene._scene.state)

    @property
    def placed(self) -> bool:
        """True if it is in the scene, not merely known."""
        return self._ask(self._scene._scene.placed)

    @property
    def at_rest(self) -> bool:
        """True if its `state` is "stable" or "fixed"."""
        return self.state in ("stable", "fixed")

    @property
    def fixed(self) -> bool:
        """Never moves, carries everything."""
        return self._ask(self._scene._scene.fixed)

    @fixed.setter
    def fixed(self, value: bool) -> None:
        self._do(op="fix" if _arrays.flag("fixed", value) else "unfix")

    @property
    def locked(self) -> bool:
        """No operation may move it; it may topple all the same."""
        return self._ask(self._scene._scene.locked)

    @locked.setter
    def locked(self, value: bool) -> None:
        self._do(op="lock" if _arrays.flag("locked", value) else "unlock")

    @property
    def group(self) -> str:
        """Objects of one group move as one; empty: of none."""
        return self._ask(self._scene._scene.group)

    @group.setter
    def group(self, value: str) -> None:
        if _arrays.text("group", value):
            self._do(op="group", group=value)
        else:
            self._do(op="ungroup")

    @property
    def material(self) -> dict[str, Any]:
        """"name", "friction", "density" (kg/m3), "restitution". Set: a name of `trivet.materials()`, or a dict."""
        return self._ask(self._scene._scene.material)

    @material.setter
    def material(self, value: Material) -> None:
        self._do(op="material", material=material_of(value))

    @property
    def scale(self) -> float:
        """Metres for each unit of the shape."""
        return self._ask(self._scene._scene.scale)

    @property
    def up(self) -> str:
        """"y" or "z": the axis of the shape that points up."""
        return self._ask(self._scene._scene.up)

    @property
    def margin(self) -> float:
        """Metres its centre of mass is inside the hull of the contacts that carry it; negative: it leans or hangs."""
        return self._ask(self._scene._scene.margin)

    @property
    def least_friction(self) -> float:
        """The smallest Coulomb coefficient that holds it; infinity: none does."""
        return self._ask(self._scene._scene.least_friction)

    @property
    def weight(self) -> float:
        """Newtons, by the density of its material."""
        return self._ask(self._scene._scene.weight)

    @property
    def flexible(self) -> Optional[dict[str, Any]]:
        """Certificate of rest of a cloth or cable, with "net_force", "balance", "stable", "supports"; else None."""
        text = self._ask(self._scene._scene.flexible)
        return None if text is None else json.loads(text)

    @property
    def middle(self) -> Optional[Array]:
        """Positions (n, 3) of a cloth or cable, in the middle of its thickness, world; else None."""
        return self._ask(self._scene._scene.middle)

    def _try(self, budget: Optional[float] = None, **operation: Any) -> Result:
        operation["object"] = self._name
        given = {key: value for key, value in operation.items() if value is not None}
        return result_of(self._scene._scene.perform(given, self._key, _arrays.seconds("budget", budget)))

    def _perform(self, op: str, budget: Optional[float], arguments: dict[str, Any]) -> Result:
        return self._try(budget, op=op, **arguments)

    def _do(self, **operation: Any) -> Result:
        operation["object"] = self._name
        return done(self._scene._scene.perform(operation, self._key, 0.0))

    def __reduce__(self) -> Any:
        lives = self._scene._scene.find(self._name) == self._key
        return _unpickled, (type(self), self._scene, self._name, lives)

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, Properties) and self._scene is other._scene and self._key == other._key
                and self._name == other._name)

    def __hash__(self) -> int:
        return hash((id(self._scene), self._key))

    def __repr__(self) -> str:
        number = self._scene._scene.find(self._name)
        return f"<trivet.Object {self._name!r}, {self.state if number == self._key else 'deleted'}>"


_GONE = (1 << 64) - 1  # a key that no object has


def _unpickled(kind: type[Properties], scene: Scene, name: str, lives: bool) -> Properties:
    """By name: keys are others in a scene that was pickled, too."""
    key = scene._scene.find(name) if lives else None
    return kind(scene, _GONE if key is None else key, name)


def material_of(value: Optional[Material]) -> Any:
    """A material as operations have it."""
    if value is None or isinstance(value, str):
        return value
    accepted = "a name of trivet.materials(), or a dict of friction, density and restitution"
    return _arrays.plain("material", _arrays.mapping("material", value, accepted))
