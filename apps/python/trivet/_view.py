"""Scenes in notebooks and browsers: a page that needs nothing but itself."""

from __future__ import annotations

import base64
import html
import json
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterable

import numpy as np
from numpy.typing import NDArray

from . import _arrays, _trivet
from ._named import highlighted
from ._shape import PathLike, Shape, write_file

if TYPE_CHECKING:
    from ._scene import Scene

Floats = NDArray[np.float64]

_PARTS = ("hulls", "contacts", "supports")
_FLAT = 0.9999  # cosine; edges of a hull between faces in one plane are not drawn


class View:
    """A scene in a page of its own, to be turned by mouse: drag, wheel, right button to shift, click for what rests on what.

    A notebook shows it where it is the last value of a cell. Needs no network, only WebGL 2.

    Attributes
    ----------
    html : str
        The whole page.
    """

    __slots__ = ("html", "_height")

    def __init__(self, page: str, height: int) -> None:
        self.html = page
        self._height = height

    def save(self, path: PathLike) -> None:
        """Write the page, for a browser.

        Parameters
        ----------
        path : path
            In a folder that is there.

        Raises
        ------
        EnvironmentFailure
            It cannot be written.
        """
        write_file(path, self.html.encode())

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" sandbox="allow-scripts" '
                f'style="width: 100%; height: {self._height}px; border: 0"></iframe>')

    def __repr__(self) -> str:
        return f"<trivet.View, a page of {len(self.html) / 1e6:.1f} MB>"


def encode_png(image: Any) -> bytes:
    """A picture as the bytes of a PNG file.

    Parameters
    ----------
    image : (height, width, 3) or (height, width, 4) uint8 array
        sRGB and opacity, row 0 above; as `Scene.render` gives it.

    Returns
    -------
    bytes
    """
    array = np.asarray(image)
    accepted = "a (height, width, 3 or 4) array of uint8, not empty"
    if array.dtype != np.uint8 or array.ndim != 3 or array.shape[2] not in (3, 4) or array.size == 0:
        raise _arrays.refuse("image", f"an array of shape {array.shape} and type {array.dtype}", accepted)
    rgba = np.full((*array.shape[:2], 4), 255, np.uint8)
    rgba[:, :, :array.shape[2]] = array
    return _trivet.encode_png(rgba)


def num_faces(scene: Scene) -> int:
    """Triangles of all shapes in the scene, each shape once."""
    return sum(len(shape.faces) for shape in {one.shape for one in scene if one.placed})


def view_of(scene: Scene, show: Iterable[str], highlight: Iterable[Any], height: int, max_faces: int) -> View:
    accepted = "a sequence of " + ", ".join(_PARTS)
    wanted = sorted(_arrays.text("show", part) for part in _arrays.listed("show", show, accepted))
    for part in wanted:
        if part not in _PARTS:
            raise _arrays.refuse("show", repr(part), ", ".join(_PARTS))
    marked = set(highlighted(highlight, scene))
    for name in marked:
        scene[name]  # raises for what is not there
    faces = num_faces(scene)
    if faces > max_faces:
        raise _arrays.refuse("the scene", f"{faces} faces", f"at most {max_faces}, or more with max_faces")
    text = json.dumps({**_page_of(scene, marked), "show": wanted}, separators=(",", ":"), ensure_ascii=False)
    return View(_template().replace("@SCENE@", text.replace("<", "\\u003c")), height)


@lru_cache(maxsize=1)
def _template() -> str:
    return (Path(__file__).parent / "viewer.html").read_text(encoding="utf-8")


def _page_of(scene: Scene, marked: set[str]) -> dict[str, Any]:
    """The data that viewer.html shows: metres about the scene's middle, so that float32 is enough."""
    placed = [one for one in scene if one.placed]
    boxes = np.array([one.bounds for one in placed]).reshape(-1, 2, 3)
    low, high = (boxes[:, 0].min(0), boxes[:, 1].max(0)) if placed else (np.full(3, -0.5), np.full(3, 0.5))
    middle = (low + high) / 2
    shapes: dict[Shape, int] = {}
    objects = [_object(one, middle, shapes, one.name in marked) for one in placed]
    contacts, graph = scene.contacts(), scene.support_graph()
    number = {graph.names.index(one.name): i for i, one in enumerate(placed)}
    number[-1] = -1
    return {
        "meshes": [_mesh(shape) for shape in shapes], "objects": objects,
        "radius": float(np.linalg.norm(high - low) / 2) or 1.0, "grid": middle[:2].tolist(),
        "floor": -float(middle[2]) if scene.floor else None,
        "contacts": {"point": _text(contacts.point - middle, np.float32), "normal": _text(contacts.normal, np.float32)},
        "edges": [[number[a], number[b]] for a, b in graph.edges.tolist() if a in number and b in number],
    }


def _object(one: Any, middle: Floats, shapes: dict[Shape, int], marked: bool) -> dict[str, Any]:
    shape = one.shape
    matrix = one.matrix
    matrix[:3, 3] = matrix[:3, :3] @ shape.bounds.mean(0) + matrix[:3, 3] - middle
    return {"name": one.name, "state": one.state, "mesh": shapes.setdefault(shape, len(shapes)), "highlight": marked,
            "matrix": matrix.T.ravel().tolist(), "center": (one.bounds.mean(0) - middle).tolist()}


def _mesh(shape: Shape) -> dict[str, Any]:
    palette, color = np.unique(shape.face_colors(), axis=0, return_inverse=True)
    if len(palette) > 1 << 16:  # 4 bits of each are enough then
        palette, color = np.unique(shape.face_colors() & 0xF0, axis=0, return_inverse=True)
    return {"vertices": _text(shape.vertices - shape.bounds.mean(0), np.float32), "faces": _text(shape.faces, np.uint32),
            "palette": palette.tolist(), "color": _text(color, np.uint16), "hull": _text(_hull_edges(shape), np.uint32)}


def _hull_edges(shape: Shape) -> NDArray[np.int32]:
    """(2 k,): rows of vertices, two for each edge of the convex hull that is one."""
    faces = shape.hull_faces()
    if len(faces) == 0:
        return np.zeros(0, np.int32)
    a, b, c = (shape.vertices[faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.finfo(float).tiny)
    edges: NDArray[np.int32] = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    order = np.lexsort(edges.T)
    sides = normals[np.repeat(np.arange(len(faces)), 3)[order]]
    edges = edges[order]
    twins = np.nonzero((edges[1:] == edges[:-1]).all(1))[0]
    drawn = np.ones(len(edges), bool)
    drawn[twins + 1] = False
    drawn[twins[np.abs((sides[twins] * sides[twins + 1]).sum(1)) > _FLAT]] = False
    out: NDArray[np.int32] = edges[drawn].ravel()
    return out


def _text(values: Any, dtype: Any) -> str:
    return base64.b64encode(np.ascontiguousarray(values, dtype=dtype).tobytes()).decode()
