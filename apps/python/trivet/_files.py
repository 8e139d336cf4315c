"""Scenes from files and from other libraries, and as files."""

from __future__ import annotations

import os
import warnings
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional

from numpy.typing import ArrayLike

from . import _arrays, _foreign, _trivet
from ._properties import Material
from ._results import Export, Overlap
from ._shape import PathLike, find_importer
from ._snapshot import Snapshot, TrivetWarning, material_of, settings

if TYPE_CHECKING:
    from ._scene import Scene

Progress = Callable[[str, str, int, int], Any]


class Files:
    """How a scene comes and goes; see `trivet.Scene`."""

    __slots__ = ()
    _scene: _trivet.Scene

    if TYPE_CHECKING:
        @classmethod
        def _of(cls, scene: _trivet.Scene) -> Scene: ...

    @classmethod
    def from_poses(cls, names: Iterable[str], shapes: Iterable[Any], poses: Iterable[ArrayLike], *,
                   fixed: Iterable[str] = (), materials: Optional[Mapping[str, Material]] = None, floor: bool = True,
                   floor_material: Optional[Material] = None, clearance: float = 0.0, **options: Any) -> Scene:
        """Objects exactly where they are said to be, whether they may or not: to be judged by `check`.

        Parameters
        ----------
        names, shapes, poses
            One of each for every object: a name; a Shape or a mesh; (4, 4), a rotation times one positive scale and a
            translation.
        fixed : names
        materials : dict of names
        """
        entries = _foreign.entries(names, shapes, poses, fixed, materials or {})
        return cls._of(_trivet.Scene.standing(entries, bool(floor), material_of(floor_material),
                                              settings(clearance, options)))

    @classmethod
    def from_trimesh(cls, scene: Any, **options: Any) -> Scene:
        """The same of a trimesh.Scene: z up, metres; one object for each node that has geometry."""
        names, shapes, poses = _foreign.parts_of_trimesh(scene)
        return cls.from_poses(names, shapes, poses, **options)

    @classmethod
    def load(cls, path: PathLike, *, progress: Optional[Progress] = None, clearance: float = 0.0, **options: Any) -> Scene:
        """A scene that Trivet wrote (.glb), or a layout (.json), which is run.

        Parameters
        ----------
        path : path
        progress : callable, optional
            ``progress(stage, item, done, total)``, from threads of Trivet's too, one at a time; what it raises stops the
            work and is raised here.
        clearance, **options
            As for `Scene`; of rules that are left out, those of the file hold.

        Warns
        -----
        TrivetWarning
            For each of `notes`: operations of a layout that were refused, and what a file lost.
        """
        scene = cls._of(_trivet.Scene.open(os.fspath(path), find_importer(), settings(clearance, options),
                                             options.get("perfect_friction"), options.get("whole_at_rest"), progress))
        for note in scene.notes:
            warnings.warn(note, TrivetWarning, stacklevel=2)
        return scene

    @classmethod
    def from_bytes(cls, data: bytes, *, clearance: Optional[float] = None, **options: Any) -> Scene:
        """A scene from what `to_glb` gave; options as those of `Scene`, what is left out as the file says."""
        return Snapshot.from_bytes(data).scene(clearance=clearance, **options)

    def to_glb(self) -> bytes:
        """A binary glTF file that every program shows and Trivet reads back whole."""
        return Snapshot(self._scene.snapshot()).to_bytes()

    def save(self, path: PathLike) -> None:
        """By extension: .glb, which Trivet reads back whole; .gltf, .obj, .ply, .stl. Replaced atomically."""
        self._scene.save(os.fspath(path))

    def export(self, path: PathLike, *, collision: str = "fitted", friction: Optional[float] = None,
               density: Optional[float] = None, max_overlap: float = 0.0) -> Export:
        """For a simulator, by extension: .xml or .mjcf (MuJoCo), .urdf, .sdf, .usda.

        Parameters
        ----------
        collision : "fitted", "hull", "components", "decomposition" or "mesh"
        friction, density : float, optional
            Of everything, kg/m3; nothing: of the materials.
        max_overlap : float
            Metres by which parts of two objects may overlap; 0: 1e-4 of the smaller one.

        Raises
        ------
        BadInputError
            Parts overlap by more: a simulator would push them apart.
        """
        values = self._scene.export(os.fspath(path), collision, friction, density,
                                    _arrays.number("max_overlap", max_overlap))
        return Export(tuple(values["files"]), tuple(values["notes"]),
                      tuple(Overlap(*one) for one in values["overlaps"]), values["masses"])
