"""Shapes: triangles as they are, and where they come from."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays, _paths, _trivet
from ._errors import BadInputError, EnvironmentFailure

PathLike = Union[str, "os.PathLike[str]"]


def find_importer() -> str:
    """The program trivet-import: named by TRIVET_IMPORTER, or where the package was installed with it."""
    named = os.environ.get("TRIVET_IMPORTER")
    found = Path(named) if named else Path(__file__).parent / _paths.IMPORTER
    if not found.is_file():
        raise EnvironmentFailure(f"{found}: the program trivet-import is missing; accepted: its path in TRIVET_IMPORTER")
    return str(found.resolve())


def write_file(path: PathLike, data: bytes) -> None:
    """Bytes as a file, or an EnvironmentFailure that names it."""
    name = _arrays.path("path", path)
    try:
        Path(name).write_bytes(data)
    except OSError as error:
        raise EnvironmentFailure(f"{name}: cannot be written: {error.strerror}") from error


class Shape:
    """Triangles in a frame of their own: open or closed, concave, self-crossing, as they are.

    Immutable; objects share it. Pickles, with its arrays out of band under protocol 5.

    Parameters
    ----------
    vertices : (n, 3) array, or a mesh
        Any unit (`Scene.add` has a scale), up to 1e30. Or anything with `.vertices` and `.faces` (or `.triangles`), such as a
        trimesh.Trimesh; then without `faces`.
    faces : (m, 3) array of whole numbers
        Counter-clockwise seen from outside.

    Raises
    ------
    BadInputError
        Another shape or type of array, a coordinate that is not finite or beyond 1e30, a vertex that there is not, no face.

    Notes
    -----
    Vertices of equal coordinates become one, and those that no face uses are left out: see `vertex_map`. Faces keep
    their order. Arrays are copied; float64 and int32 in C order cost least.
    """

    __slots__ = ("_shape", "__weakref__")

    def __init__(self, vertices: Any, faces: Optional[ArrayLike] = None) -> None:
        if faces is None:
            mesh = vertices
            faces = getattr(mesh, "faces", None)
            if faces is None:
                faces = getattr(mesh, "triangles", None)
            vertices = getattr(mesh, "vertices", None)
            if faces is None or vertices is None:
                raise BadInputError(f"a mesh of type {type(mesh).__name__} is not accepted; accepted: arrays of vertices "
                                    "and faces, or something with .vertices and .faces")
        points = _arrays.vertices("vertices", vertices)
        self._shape = _trivet.Shape.of(points, _arrays.faces("faces", faces, len(points)))

    @classmethod
    def _of(cls, shape: _trivet.Shape) -> Shape:
        out = cls.__new__(cls)
        out._shape = shape
        return out

    @classmethod
    def _of_state(cls, state: tuple[Any, ...]) -> Shape:
        return cls._of(_trivet.Shape.of_state(state))

    @classmethod
    def load(cls, path: PathLike, *, chord: float = 0.0, max_triangles: int = 50_000_000, max_seconds: float = 0.0,
             isolated: bool = True) -> Shape:
        """Read a model: OBJ, glTF, PLY, STL, FBX, DAE, 3DS; STEP, IGES and BREP where trivet-import-cad is.

        Parameters
        ----------
        path : path
            Its look (materials, textures) comes along.
        chord : float
            Units of the file; largest distance of triangles from curved surfaces. 0: by the model's size.
        max_triangles, max_seconds : int, float
            Limits for files that are not trusted; 0 seconds: 60, plus one for each MB.
        isolated : bool
            Read in a process of its own, so that a file on which the reader crashes gives an error.

        Returns
        -------
        Shape

        Raises
        ------
        BadInputError
            Missing, unreadable, without a triangle, beyond the limits.
        EnvironmentFailure
            The program trivet-import is missing.
        """
        name = _arrays.path("path", path)
        importer = find_importer() if _arrays.flag("isolated", isolated) else ""
        return cls._of(_trivet.Shape.load(name, importer, _arrays.whole("max_triangles", max_triangles, 1, 2 ** 31 - 1),
                                          _arrays.number("max_seconds", max_seconds, "seconds, 0 to 1e9", 0.0, 1e9),
                                          _arrays.number("chord", chord)))

    def colored(self, rgba: ArrayLike) -> Shape:
        """The same geometry in one colour.

        Parameters
        ----------
        rgba : (3,) or (4,) array
            0 to 1: linear RGB, and opacity.

        Returns
        -------
        Shape
        """
        given = _arrays.vector("rgba", rgba, 3, 4)
        if not all(0 <= x <= 1 for x in given):
            raise _arrays.refuse("rgba", _arrays.short(rgba), "3 or 4 numbers from 0 to 1")
        return Shape._of(self._shape.coloured([*given, 1.0][:4]))

    @property
    def vertices(self) -> NDArray[np.float64]:
        """(n, 3) read-only view: vertices after merging, in the shape's units."""
        return self._shape.vertices

    @property
    def faces(self) -> NDArray[np.int32]:
        """(m, 3) read-only view: rows of `vertices`, faces in the order in which they were given."""
        return self._shape.faces

    @property
    def vertex_map(self) -> Optional[NDArray[np.int32]]:
        """(number of given vertices,): the row of `vertices` of each, -1 if no face uses it; None for files."""
        return self._shape.vertex_map

    def face_colors(self) -> NDArray[np.uint8]:
        """(m, 4): sRGB and opacity of each face as a whole: of its material, means of textures and vertex colours."""
        return self._shape.face_colors()

    def hull_faces(self) -> NDArray[np.int32]:
        """(k, 3): triangles of the convex hull, rows of `vertices`, in no particular orientation; none if it is flat."""
        return self._shape.hull_faces()

    @property
    def bounds(self) -> NDArray[np.float64]:
        """(2, 3): lower and upper corner, in the shape's units."""
        return self._shape.bounds

    @property
    def volume(self) -> float:
        """Volume of the solid if closed (`mass_rule` is "volume"), of the hull by "hull", 0 by "surface"; units cubed."""
        return self._shape.volume

    @property
    def area(self) -> float:
        """Area of all faces, units squared."""
        return self._shape.area

    @property
    def center_mass(self) -> NDArray[np.float64]:
        """(3,): centre of mass by `mass_rule`, in the shape's units."""
        return self._shape.center_mass

    @property
    def mass_rule(self) -> str:
        """"volume": closed and consistently oriented; "surface": by area; "hull": by the convex hull."""
        return self._shape.mass_rule

    @property
    def up(self) -> str:
        """"y" or "z": the axis that points up, as the file's format says."""
        return self._shape.up

    @property
    def notes(self) -> tuple[str, ...]:
        """Parts of the file that were left out."""
        return tuple(self._shape.notes)

    @property
    def name(self) -> str:
        """Name of the file; empty for arrays."""
        return self._shape.name

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Shape) and self._shape.id == other._shape.id

    def __hash__(self) -> int:
        return hash(self._shape.id)

    def __reduce__(self) -> Any:
        return Shape._of_state, (self._shape.state(),)

    def __copy__(self) -> Shape:
        return self

    def __repr__(self) -> str:
        name = f"{self.name!r}, " if self.name else ""
        return f"<trivet.Shape {name}{len(self.faces)} faces, {len(self.vertices)} vertices, {self.mass_rule}>"
