"""Labelled images: what a camera sees, per pixel and per object."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._camera import Camera
from ._errors import NoSuchObject
from ._named import name_of

Floats = NDArray[np.float64]

#: Instance number of the floor.
FLOOR = 65535


@dataclass(frozen=True, eq=False)
class Labels:
    """Labelled images of one view; exact: a pixel is labelled by what the ray through its centre meets first.

    Images are (height, width) arrays, row 0 above. Objects are those in the scene, n of them, in its order.

    Attributes
    ----------
    camera : Camera
        Intrinsics and extrinsics, OpenCV's convention.
    depth : (height, width) float32 array
        Metres along the camera's z; 0 where nothing is.
    instances : (height, width) uint16 array
        1 + number of the object in `names`; 0: nothing; `trivet.FLOOR`: the floor.
    classes : (height, width) uint16 array
        1 + number of the class in `class_names`; 0: nothing, or the floor.
    normals : (height, width, 3) float32 array, or None
        Camera frame, unit, towards the camera; 0 where nothing is.
    names : tuple of str
    class_names : tuple of str
        Sorted, each once.
    class_ids : (n,) int array
        1 + number of each object's class in `class_names`.
    boxes_visible : (n, 4) array
        x, y, width, height, pixels, as COCO counts (pixel (i, j) covers [i, i + 1] x [j, j + 1]): of what is seen; NaN of
        objects that are not.
    boxes_whole : (n, 4) array
        The same of all of the object in front of the camera, hidden parts and those beside the picture too (amodal); cut
        off at three times the picture's size; NaN behind the camera.
    pixels_visible, pixels_alone : (n,) int arrays
        In which it is seen; that it would cover alone (0 without `visibility`).
    visible_share : (n,) array
        0 to 1: `pixels_visible` by all pixels that it would cover, those beside the picture too (0 without `visibility`).
    """

    camera: Camera
    names: tuple[str, ...]
    class_names: tuple[str, ...]
    class_ids: NDArray[np.int32] = field(repr=False)
    boxes_visible: Floats = field(repr=False)
    boxes_whole: Floats = field(repr=False)
    pixels_visible: NDArray[np.int64] = field(repr=False)
    pixels_alone: NDArray[np.int64] = field(repr=False)
    visible_share: Floats = field(repr=False)
    depth: NDArray[np.float32] = field(repr=False)
    instances: NDArray[np.uint16] = field(repr=False)
    classes: NDArray[np.uint16] = field(repr=False)
    normals: Optional[NDArray[np.float32]] = field(repr=False)

    @property
    def intrinsics(self) -> Floats:
        """(3, 3): of the camera, pixels."""
        return self.camera.intrinsics

    @property
    def camera_from_world(self) -> Floats:
        """(4, 4): extrinsics of the camera."""
        return self.camera.camera_from_world

    def mask(self, what: Any) -> NDArray[np.bool_]:
        """Where an object is seen.

        Parameters
        ----------
        what : Object, or str
            Its name, or "floor".

        Returns
        -------
        (height, width) bool array

        Raises
        ------
        NoSuchObject
            It was not in the scene.
        """
        name = name_of("what", what)
        if name != "floor" and name not in self.names:
            raise NoSuchObject(f'there is no object "{name}" in the picture\'s scene')
        number = FLOOR if name == "floor" else 1 + self.names.index(name)
        out: NDArray[np.bool_] = self.instances == number
        return out

    def points(self) -> Floats:
        """(height, width, 3): where each pixel's ray ends, world, metres; NaN where nothing is."""
        height, width = self.depth.shape
        k = self.intrinsics
        z = np.where(self.depth > 0, self.depth.astype(np.float64), np.nan)
        x = (np.arange(width) - k[0, 2]) / k[0, 0] * z
        y = ((np.arange(height) - k[1, 2]) / k[1, 1])[:, None] * z
        pose = self.camera.world_from_camera
        out: Floats = np.stack([x, y, z], -1) @ pose[:3, :3].T + pose[:3, 3]
        return out
