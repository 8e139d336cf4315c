"""Cameras of pictures and labelled images."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays, _trivet
from ._errors import BadInputError

Floats = NDArray[np.float64]

MAX_SIDE = 16384
MAX_PIXELS = 1 << 26


def size_of(size: Any) -> tuple[int, int]:
    """Width and height, or a BadInputError."""
    accepted = f"(width, height), each 1 to {MAX_SIDE} pixels, at most {MAX_PIXELS} together"
    if isinstance(size, (str, bytes)) or not isinstance(size, (Sequence, np.ndarray)) or len(size) != 2:
        raise _arrays.refuse("size", repr(size), accepted)
    try:
        width, height = (_arrays.whole("size", side, 1, MAX_SIDE) for side in size)
    except BadInputError:
        raise _arrays.refuse("size", repr(size), accepted) from None
    if width * height > MAX_PIXELS:
        raise _arrays.refuse("size", repr(size), accepted)
    return width, height


class Camera:
    """A pinhole camera, in the convention of OpenCV; immutable.

    Camera frame: x to the right, y down, z forward, metres. The centre of the pixel in column i and row j, from above
    left, has the image coordinates (i, j); a point (x, y, z) of the camera frame is seen at
    ``(fx * x / z + cx, fy * y / z + cy)``. Made by `look_at`, `from_matrix`, `Scene.camera` and `Scene.dome`; pickles.
    """

    __slots__ = ("_camera",)
    _camera: _trivet.Camera

    def __init__(self) -> None:
        raise TypeError("Camera(): make one by Camera.look_at, Camera.from_matrix, Scene.camera or Scene.dome")

    @classmethod
    def _of(cls, camera: _trivet.Camera) -> Camera:
        out = cls.__new__(cls)
        out._camera = camera
        return out

    @classmethod
    def _of_state(cls, state: tuple[Any, ...]) -> Camera:
        return cls._of(_trivet.Camera.of_state(state))

    @classmethod
    def look_at(cls, eye: ArrayLike, target: ArrayLike = (0.0, 0.0, 0.0), *, up: ArrayLike = (0.0, 0.0, 1.0),
                fov: float = 30.0, size: Sequence[int] = (640, 360)) -> Camera:
        """From a point towards another; the same as ``--camera`` of ``trivet render``.

        Parameters
        ----------
        eye, target : (3,) arrays
            World, metres.
        up : (3,) array
            World; points up in the picture. Replaced by another direction if it is that of the view.
        fov : float
            Degrees from the lower to the upper edge, 1 to 170.
        size : (int, int)
            Width and height, pixels, 1 to 16384 each.

        Returns
        -------
        Camera

        Raises
        ------
        BadInputError
            Eye and target coincide, or a number is out of range.
        """
        width, height = size_of(size)
        return cls._of(_trivet.Camera.look_at(np.array(_arrays.vector("eye", eye, 3)),
                                              np.array(_arrays.vector("target", target, 3)),
                                              np.array(_arrays.vector("up", up, 3)), _arrays.number("fov", fov), width, height))

    @classmethod
    def from_matrix(cls, camera_from_world: ArrayLike, intrinsics: ArrayLike, size: Sequence[int]) -> Camera:
        """A camera that was measured, or comes from another program.

        Parameters
        ----------
        camera_from_world : (4, 4) array
            Extrinsics: takes points of the world to the camera frame.
        intrinsics : (3, 3) array
            ``[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]``, pixels.
        size : (int, int)
            Width and height, pixels, 1 to 16384 each.

        Returns
        -------
        Camera

        Raises
        ------
        BadInputError
            Not a rotation and a translation (to 1e-6); skewed or negative focal lengths.
        """
        width, height = size_of(size)
        matrix = _arrays.matrix("camera_from_world", camera_from_world)
        return cls._of(_trivet.Camera.from_matrix(matrix, _arrays.matrix("intrinsics", intrinsics, 3), width, height))

    @property
    def size(self) -> tuple[int, int]:
        """Width and height, pixels."""
        return self._camera.width, self._camera.height

    @property
    def intrinsics(self) -> Floats:
        """(3, 3): ``[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]``, pixels; OpenCV's camera matrix."""
        return self._camera.intrinsics

    @property
    def camera_from_world(self) -> Floats:
        """(4, 4): takes points of the world to the camera frame, metres."""
        return self._camera.camera_from_world

    @property
    def world_from_camera(self) -> Floats:
        """(4, 4): the camera's pose."""
        out = np.eye(4)
        out[:3, :3] = self.camera_from_world[:3, :3].T
        out[:3, 3] = self.eye
        return out

    @property
    def eye(self) -> Floats:
        """(3,): where it is, world, metres."""
        return self._camera.eye

    def project(self, points: ArrayLike) -> tuple[Floats, Floats]:
        """Where points of the world are seen.

        Parameters
        ----------
        points : (n, 3) array
            World, metres.

        Returns
        -------
        pixels : (n, 2) array
            Image coordinates, column first; NaN of points that are not in front of the camera.
        depth : (n,) array
            Metres along the camera's z.
        """
        given = _arrays.vertices("points", points)
        seen = (given - self.eye) @ self.camera_from_world[:3, :3].T
        depth = seen[:, 2].copy()
        seen[depth <= 0] = np.nan
        k = self.intrinsics
        pixels = seen[:, :2] / seen[:, 2:] * (k[0, 0], k[1, 1]) + k[:2, 2]
        return pixels, depth

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Camera) and self._values() == other._values()

    def __hash__(self) -> int:
        return hash(self._values())

    def _values(self) -> tuple[Any, ...]:
        arrays = (self.intrinsics, self.camera_from_world, self.eye)
        return (self.size, *(value for array in arrays for value in array.ravel().tolist()))

    def __reduce__(self) -> Any:
        return Camera._of_state, (self._camera.state(),)

    def __repr__(self) -> str:
        eye = ", ".join(f"{x:.4g}" for x in self.eye)
        return f"<trivet.Camera at ({eye}), {self.size[0]} x {self.size[1]} pixels>"
