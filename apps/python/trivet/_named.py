"""Objects as arguments: of this scene, or names."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from . import _arrays
from ._errors import NoSuchObject
from ._properties import Properties

if TYPE_CHECKING:
    from ._scene import Scene


def name_of(what: str, value: Any, scene: Optional[Scene] = None) -> str:
    """Name of an object, given as the object or its name; an object must be of `scene`, and still there."""
    if not isinstance(value, Properties):
        if not isinstance(value, str):
            raise _arrays.refuse(what, _arrays.short(value), "an object or its name")
        return _arrays.text(what, value)
    if scene is not None and value.scene is not scene:
        raise _arrays.refuse(what, f'"{value.name}" of another scene', "objects of this scene, or their names")
    if scene is not None and value not in scene:
        raise NoSuchObject(f'there is no object "{value.name}"')
    return value.name


def names(what: str, value: Any, scene: Optional[Scene] = None) -> list[str]:
    """The same of several."""
    return [name_of(what, one, scene) for one in _arrays.listed(what, value, "a sequence of objects or their names")]


def highlighted(value: Any, scene: Scene) -> list[str]:
    """Names to be drawn in a colour; of pairs, as `Check.crossings` has them, both, but for the floor."""
    out = []
    for one in _arrays.listed("highlight", value, "objects, names, or pairs of them as in Check.crossings"):
        if isinstance(one, tuple) and len(one) > 1 and all(isinstance(x, (int, float)) for x in one[2:]):
            out += [name for name in names("highlight", one[:2], scene) if name != "floor"]
        else:
            out.append(name_of("highlight", one, scene))
    return out
