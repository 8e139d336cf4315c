"""Questions to a scene: contacts, supports, verdicts, z-lists."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _trivet
from ._results import Check, Contacts, SupportGraph, check_of
from ._zlists import ZLists

_TYPES = np.array(["point", "line", "area"])
_KINDS = np.array(["vertex-face", "face-vertex", "edge-edge", "closest"])


class Questions:
    """Questions about a scene; see `trivet.Scene`."""

    __slots__ = ()
    _scene: _trivet.Scene

    def contacts(self) -> Contacts:
        """All contact points, as columns of arrays; copies."""
        values = self._scene.contacts()
        values["type"] = _TYPES[values["type"]]
        values["kind"] = _KINDS[values["kind"]]
        return Contacts(**values)

    def support_graph(self) -> SupportGraph:
        """Graph of which object rests on which."""
        return SupportGraph(**self._scene.support_graph())

    def check(self, friction: Optional[float] = None, *, num_threads: int = 0) -> Check:
        """Judge the scene from its poses alone, exactly; nothing changes.

        Parameters
        ----------
        friction : float, optional
            Coulomb's coefficient at all contacts for the verdict on the whole scene; nothing: by the materials.
        num_threads : int
            0: all cores; the result does not depend on it.

        Returns
        -------
        Check
        """
        given = None if friction is None else _arrays.number("friction", friction)
        return check_of(self._scene.check(given, _arrays.whole("num_threads", num_threads, 0, 1024)))

    def zlists(self, direction: ArrayLike = (0.0, 0.0, -1.0), *, resolution: int = 256,
               region: Optional[ArrayLike] = None, max_bytes: float = 1e9, num_threads: int = 0) -> ZLists:
        """All faces on the lines of sight of an image, sorted by depth; see `ZLists`.

        Parameters
        ----------
        direction : (3,) array
            Away from the eye, of any length but 0.
        resolution : int
            Pixels along the longer side, 1 to 8192.
        region : (4,) array, optional
            Left, bottom, right and top of the image, metres along `ZLists.right` and `up`; nothing: all that there is.
        max_bytes : float
            Of the lists.
        num_threads : int
            0: all cores; the lists do not depend on it.

        Returns
        -------
        ZLists

        Raises
        ------
        BadInputError
            More bytes, or an argument out of range.
        """
        rectangle = None if region is None else _arrays.vector("region", region, 4)
        return ZLists(**self._scene.zlists(np.array(_arrays.vector("direction", direction, 3)),
                                           _arrays.whole("resolution", resolution, 1, 8192), rectangle,
                                           _arrays.number("max_bytes", max_bytes, "0 to 1e15", 0.0, 1e15),
                                           _arrays.whole("num_threads", num_threads, 0, 1024)))
