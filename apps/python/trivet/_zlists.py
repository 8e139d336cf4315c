"""z-lists: all faces on the lines of sight of an image, sorted by depth."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._errors import BadInputError

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]


class ZList(NamedTuple):
    """The faces of one pixel, nearest first: columns of one length; see `ZLists`."""

    object: Ints
    face: Ints
    nearest: Floats
    farthest: Floats


@dataclass(frozen=True)
class ZLists:
    """Complete z-lists of a scene: per pixel every face that it touches, nearest first.

    Conservative: a face is in the list of every pixel that it touches, or misses by less than 0.02 pixels, with the
    interval of its depths there. Orthogonal; pixel (column, row), row 0 at the bottom, is the square that begins at
    ``corner + pixel * (column, row)``, metres along `right` and `up` from the world's origin.

    Attributes
    ----------
    names : tuple of str
        Objects in the scene's order.
    width, height : int
    pixel : float
        Metres.
    corner : (float, float)
    right, up, direction : (3,) arrays
        Unit, world; `direction` points away from the eye.
    start : (width * height + 1,) int array
        Entries of pixel k = row * width + column are those from ``start[k]`` to ``start[k + 1]`` - 1.
    object, face : (n,) int arrays
        Number in `names`, row of `Shape.faces`.
    nearest, farthest : (n,) arrays
        Depths along `direction` from the plane through the world's origin, metres.
    """

    names: tuple[str, ...]
    width: int
    height: int
    pixel: float
    corner: tuple[float, float]
    right: Floats
    up: Floats
    direction: Floats
    start: NDArray[np.int64] = field(repr=False)
    object: Ints = field(repr=False)
    face: Ints = field(repr=False)
    nearest: Floats = field(repr=False)
    farthest: Floats = field(repr=False)

    def at(self, column: int, row: int) -> ZList:
        """The list of a pixel.

        Parameters
        ----------
        column, row : int
            Row 0 at the bottom.

        Returns
        -------
        ZList

        Raises
        ------
        BadInputError
            There is no such pixel.
        """
        if not (0 <= column < self.width and 0 <= row < self.height):
            raise BadInputError(f"pixel: ({column}, {row}) is not accepted; accepted: columns below {self.width}, rows below "
                                f"{self.height}")
        k = row * self.width + column
        part = slice(int(self.start[k]), int(self.start[k + 1]))
        return ZList(self.object[part], self.face[part], self.nearest[part], self.farthest[part])

    def lengths(self) -> NDArray[np.int64]:
        """(height, width): entries of each pixel; for matplotlib with ``origin="lower"``."""
        return np.diff(self.start).reshape(self.height, self.width)

    def depth(self) -> Floats:
        """(height, width): depth of what is seen first, metres; infinity where there is nothing."""
        out = np.full(self.width * self.height, np.inf)
        covered = np.diff(self.start) > 0
        out[covered] = self.nearest[self.start[:-1][covered]]
        return out.reshape(self.height, self.width)
