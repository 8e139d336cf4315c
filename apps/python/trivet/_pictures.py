"""Pictures and labelled images of a scene."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Sequence, Union, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays, _trivet
from ._camera import MAX_SIDE, Camera, size_of
from ._film import Film
from ._labels import Labels
from ._named import highlighted, name_of
from ._shape import PathLike
from ._view import View, encode_png, num_faces, view_of

if TYPE_CHECKING:
    from ._scene import Scene

Highlight = Union[Iterable[Any], Mapping[Any, ArrayLike]]
_HIGHLIGHT = (1.0, 0.35, 0.02, 0.6)
_MOST_SHOWN = 500_000  # faces of a page


class Pictures:
    """Pictures of a scene by a camera; see `trivet.Scene`. By rays on the processor: no display, no GPU."""

    __slots__ = ()
    _scene: _trivet.Scene

    def camera(self, size: Sequence[int] = (640, 360)) -> Camera:
        """The camera of `render` when none is given: from above, with all objects in the picture.

        Parameters
        ----------
        size : (int, int)
            Width and height, pixels.

        Returns
        -------
        Camera
        """
        return Camera._of(self._scene.automatic_camera(*size_of(size)))

    def dome(self, count: int, *, seed: int = 1, radius: float = 0.0, elevation: Sequence[float] = (15.0, 75.0),
             fov: float = 30.0, size: Sequence[int] = (640, 360)) -> list[Camera]:
        """Cameras all around the scene, looking at its middle; those of ``trivet render --dome``.

        Parameters
        ----------
        count : int
            1 to 1,000,000.
        seed : int
            The same bits for a seed on any machine.
        radius : float
            Metres from the middle; 0: so that all of the scene is seen.
        elevation : (float, float)
            Lowest and highest, degrees; even by area between them.
        fov : float
            Degrees from the lower to the upper edge, 1 to 170.
        size : (int, int)
            Width and height, pixels.

        Returns
        -------
        list of Camera
        """
        lowest, highest = _arrays.vector("elevation", elevation, 2)
        found = self._scene.dome(_arrays.whole("count", count, 1, 1_000_000), *size_of(size),
                                 _arrays.whole("seed", seed, 0, 2 ** 64 - 1), _arrays.number("radius", radius),
                                 lowest, highest, _arrays.number("fov", fov))
        return [Camera._of(one) for one in found]

    def render(self, camera: Optional[Camera] = None, *, size: Optional[Sequence[int]] = None, samples: int = 16,
               bounces: int = 3, transparent: bool = False, highlight: Highlight = (),
               progress: Optional[Callable[[float], Any]] = None, num_threads: int = 0) -> NDArray[np.uint8]:
        """A picture: soft shadows, reflections, glass, textures; the pixels of ``trivet render --renderer path``.

        The scene may change meanwhile: it is drawn as it was at the call. Ctrl+C stops the work.

        Parameters
        ----------
        camera : Camera, optional
            Nothing: `camera`, so that everything is seen.
        size : (int, int), optional
            Width and height, pixels, without a camera; nothing: 640 x 360.
        samples : int
            Paths per pixel, 1 to 4096: 4 for a draft, 16 clean, 64 for print. Time grows with it.
        bounces : int
            Reflections of a path, 0 to 64; 0: shadows and sky only.
        transparent : bool
            Nothing behind the scene: a fourth channel is opacity.
        highlight : names, objects or pairs of them, or a dict of them
            Drawn in orange, or in a colour: linear RGB and its strength, 0 to 1. Pairs as in `Check.crossings`.
        progress : callable, optional
            ``progress(fraction)``, from threads of Trivet's too, one at a time; what it raises stops the work and is raised
            here.
        num_threads : int
            0: all cores; the pixels do not depend on it.

        Returns
        -------
        (height, width, 3) uint8 array
            sRGB, row 0 above; (height, width, 4) if `transparent`.

        Raises
        ------
        BadInputError
            A size beyond 16384 pixels a side or 2^26 together, samples or bounces out of range.
        """
        image = self._scene.render(self._camera_of(camera, size)._camera, _arrays.whole("samples", samples, 1, 4096),
                                   _arrays.whole("bounces", bounces, 0, 64), _arrays.flag("transparent", transparent),
                                   _colours(highlight, cast("Scene", self)), _arrays.callback("progress", progress),
                                   _arrays.whole("num_threads", num_threads, 0, 1024))
        return image if transparent else np.ascontiguousarray(image[:, :, :3])

    def labels(self, camera: Optional[Camera] = None, *, size: Optional[Sequence[int]] = None,
               classes: Optional[Mapping[str, str]] = None, normals: bool = True, visibility: bool = True,
               num_threads: int = 0) -> Labels:
        """Labelled images for machine learning, exact: what ``trivet render --depth --ids --boxes`` writes.

        See-through materials count as opaque; the floor is seen from above only.

        Parameters
        ----------
        camera, size
            As for `render`.
        classes : dict of str, optional
            Class of objects by their names. Of others it is that of the layout, the name of the model's file, or the
            object's name.
        normals, visibility : bool
            Whether `Labels.normals` (else None) and `Labels.pixels_alone` and `visible_share` (else 0) are wanted.
        num_threads : int
            0: all cores; the labels do not depend on it.

        Returns
        -------
        Labels
        """
        view = self._camera_of(camera, size)
        values = self._scene.labels(view._camera, _class_names(classes, cast("Scene", self)),
                                    _arrays.flag("normals", normals), _arrays.flag("visibility", visibility),
                                    _arrays.whole("num_threads", num_threads, 0, 1024))
        return Labels(camera=view, **values)

    def write_data_set(self, folder: PathLike, cameras: Iterable[Camera], *, form: str = "coco",
                       classes: Optional[Mapping[str, str]] = None, samples: int = 16, bounces: int = 3,
                       depth_unit: float = 0.001, progress: Optional[Callable[[int, int], Any]] = None,
                       num_threads: int = 0) -> None:
        """Pictures and labels of many views as a data set in a folder: what ``trivet render --coco, --bop`` writes.

        Fixed objects are no targets, unless all are fixed: they have neither annotations nor poses. Files that describe all views are written last: a folder without them is not whole. Ctrl+C stops it within a view.

        Parameters
        ----------
        folder : path
            Made if it is not there. A set that is there gets the views as further ones: COCO further images, BOP the next
            scene; its ids stay.
        cameras : Cameras
            A view of each, as by `dome`; one at least.
        form : "coco" or "bop"
            COCO's instances (boxes, masks as run lengths, visible shares), or BOP's (poses, depth, masks, models in
            millimetres).
        classes, samples, bounces, num_threads
            As for `labels` and `render`.
        depth_unit : float
            Metres for each unit of BOP's depth images, 1e-9 to 1e9.
        progress : callable, optional
            ``progress(done, total)``, of views; what it raises stops the work and is raised here.

        Raises
        ------
        EnvironmentFailure
            A file cannot be written.
        """
        views = [self._camera_of(_is_camera(one), None)._camera
                 for one in _arrays.listed("cameras", cameras, "cameras, as by dome(100)")]
        if not views:
            raise _arrays.refuse("cameras", "[]", "one camera at least")
        unit = _arrays.number("depth_unit", depth_unit, "1e-9 to 1e9", 1e-9, 1e9)
        self._scene.write_data_set(_arrays.path("folder", folder), _arrays.text("form", form), views,
                                   _class_names(classes, cast("Scene", self)),
                                   _arrays.whole("samples", samples, 1, 4096), _arrays.whole("bounces", bounces, 0, 64),
                                   unit, _arrays.callback("progress", progress),
                                   _arrays.whole("num_threads", num_threads, 0, 1024))

    def view(self, *, show: Iterable[str] = (), highlight: Iterable[Any] = (), height: int = 480,
             max_faces: int = _MOST_SHOWN) -> View:
        """The scene in a page of its own, to be turned by mouse; notebooks show it. Textures are shown by their mean colour.

        Parameters
        ----------
        show : names
            Of "hulls" (convex hulls), "contacts" (points and normals) and "supports" (what rests on what); each can be
            switched in the page, too.
        highlight : names, objects or pairs of them
            Drawn in orange. Pairs as in `Check.crossings`.
        height : int
            Pixels in a notebook.
        max_faces : int
            Of all shapes, each once; a page has about 25 bytes for each.

        Returns
        -------
        View

        Raises
        ------
        BadInputError
            More faces.
        """
        return view_of(cast("Scene", self), show, highlight, _arrays.whole("height", height, 1, MAX_SIDE),
                       _arrays.whole("max_faces", max_faces, 0, 1 << 31))

    def film(self) -> Film:
        """A film of the operations in a block; see `Film`."""
        return Film(cast("Scene", self))

    def _repr_html_(self) -> str:
        if num_faces(cast("Scene", self)) <= _MOST_SHOWN:
            return self.view()._repr_html_()
        rows = "".join(f"<tr><td>{html.escape(o.name)}</td><td>{o.state}</td></tr>" for o in cast("Scene", self))
        return f"<table><tr><th>object</th><th>state</th></tr>{rows}</table>"

    def _repr_png_(self) -> bytes:
        return encode_png(self.render(size=(480, 270), samples=4))

    def _camera_of(self, camera: Optional[Camera], size: Optional[Sequence[int]]) -> Camera:
        if camera is None:
            return self.camera((640, 360) if size is None else size)
        if not isinstance(camera, Camera):
            raise _arrays.refuse("camera", repr(camera), "a trivet.Camera, as by Camera.look_at(eye, target)")
        if size is not None and size_of(size) != camera.size:
            raise _arrays.refuse("size", repr(size), f"that of the camera, {camera.size}, or a size without a camera")
        size_of(camera.size)
        return camera


def _is_camera(value: Any) -> Any:
    if value is None:
        raise _arrays.refuse("cameras", "None", "trivet.Cameras, as by dome(100)")
    return value


def _class_names(classes: Optional[Mapping[str, str]], scene: Scene) -> dict[str, str]:
    given = _arrays.mapping("classes", {} if classes is None else classes, "a dict of classes by names")
    return {name_of("classes", name, scene): _class_name(value) for name, value in given.items()}


def _class_name(value: Any) -> str:
    if not _arrays.text("classes", value):
        raise _arrays.refuse("classes", repr(value), "names of classes, not empty")
    return str(value)


def _colours(highlight: Highlight, scene: Scene) -> dict[str, list[float]]:
    if not isinstance(highlight, Mapping):
        return {name: list(_HIGHLIGHT) for name in highlighted(highlight, scene)}
    out = {}
    for what, colour in highlight.items():
        values = _arrays.vector("highlight", colour, 4)
        if not all(0 <= x <= 1 for x in values):
            raise _arrays.refuse("highlight", repr(colour), "4 numbers from 0 to 1")
        out.update({name: values for name in highlighted([what], scene)})
    return out
