"""Scenes from files and from other libraries, and as files."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Union, cast

from numpy.typing import ArrayLike

from . import _arrays, _foreign, _trivet
from ._properties import Material, material_of
from ._results import Export, Overlap, Simulated
from ._settle import detection, settings
from ._shape import PathLike, find_importer, write_file
from ._snapshot import Snapshot, TrivetWarning

if TYPE_CHECKING:
    from ._scene import Scene

Progress = Callable[[str, str, int, int], Any]


class Files:
    """Reading and writing of scenes; see `trivet.Scene`."""

    __slots__ = ()
    _scene: _trivet.Scene

    if TYPE_CHECKING:
        @classmethod
        def _of(cls, scene: _trivet.Scene) -> Scene: ...

    @classmethod
    def from_poses(cls, names: Iterable[str], shapes: Iterable[Any], poses: Iterable[ArrayLike], *,
                   fixed: Iterable[str] = (), materials: Optional[Mapping[str, Material]] = None,
                   masses: Optional[Mapping[str, Any]] = None, floor: bool = True,
                   floor_material: Optional[Material] = None, clearance: float = 0.0, **options: Any) -> Scene:
        """Objects exactly where they are said to be, whether they may or not: to be judged by `check`.

        Parameters
        ----------
        names, shapes, poses
            One of each for every object: a name; a Shape or a mesh; (4, 4), a rotation times one positive scale and a
            translation.
        fixed : names
            Of those that never move.
        materials : dict
            As `Object.material`, by names; of others the default.
        masses : dict
            Kilograms by names, or a dict with ``kilograms`` and, where they are known, ``centre`` (3,), metres in the
            object's frame, and ``inertia`` (6,) about it, kg m^2: xx, yy, zz, xy, xz, yz. Of others density times volume.
        floor, floor_material, clearance, **options
            As for `Scene`.

        Returns
        -------
        Scene

        Raises
        ------
        BadInputError
            Not one of each, names twice, a pose that is sheared, mirrored or unequally scaled.
        """
        entries = _foreign.entries(names, shapes, poses, fixed, {} if materials is None else materials,
                                   {} if masses is None else masses)
        return cls._of(_trivet.Scene.standing(entries, _arrays.flag("floor", floor), material_of(floor_material),
                                              settings(clearance, options)))

    @classmethod
    def from_trimesh(cls, scene: Any, **options: Any) -> Scene:
        """The same of a trimesh.Scene: z up, metres; one object for each node that has geometry.

        Parameters
        ----------
        scene : trimesh.Scene
        **options
            As for `from_poses`.

        Returns
        -------
        Scene
        """
        names, shapes, poses = _foreign.parts_of_trimesh(scene)
        return cls.from_poses(names, shapes, poses, **options)

    @classmethod
    def load(cls, path: PathLike, *, progress: Optional[Progress] = None, clearance: float = 0.0, detector: str = "auto",
             device: Union[int, str] = "auto", **options: Any) -> Scene:
        """A scene that Trivet wrote (.glb), or a layout (.json), which is run.

        Parameters
        ----------
        path : path
        progress : callable, optional
            ``progress(stage, item, done, total)``, from threads of Trivet's too, one at a time; what it raises stops the
            work and is raised here.
        clearance, detector, device, **options
            As for `Scene`; of rules that are left out, those of the file hold.

        Returns
        -------
        Scene

        Raises
        ------
        BadInputError
            Missing, or not a scene or layout.
        EnvironmentFailure
            The program trivet-import is missing.

        Warns
        -----
        TrivetWarning
            For each of `notes`: operations of a layout that were refused, and what a file lost.
        """
        scene = cls._of(_trivet.Scene.open(_arrays.path("path", path), find_importer(), settings(clearance, options),
                                           options.get("perfect_friction"), options.get("whole_at_rest"), options.get("robust"),
                                           _arrays.callback("progress", progress), *detection(detector, device)))
        for note in scene.notes:
            warnings.warn(note, TrivetWarning, stacklevel=2)
        return scene

    @classmethod
    def from_bytes(cls, data: bytes, *, clearance: Optional[float] = None, **options: Any) -> Scene:
        """A scene from what `to_glb` gave.

        Parameters
        ----------
        data : bytes
        clearance, **options
            As for `Scene`; what is left out is as the file says.

        Returns
        -------
        Scene

        Raises
        ------
        BadInputError
            Other bytes.
        """
        return Snapshot.from_bytes(data).scene(clearance=clearance, **options)

    def to_trimesh(self) -> Any:
        """A trimesh.Scene: metres, z up, a node for each object that is in the scene, by its name. Needs trimesh.

        Each shape is one geometry, in its own units, with the colours of its faces; `from_trimesh` reads it back.
        """
        return _foreign.trimesh_of(cast("Scene", self))

    def to_glb(self) -> bytes:
        """A binary glTF file that every program shows and Trivet reads back whole."""
        return Snapshot(self._scene.snapshot()).to_bytes()

    def save(self, path: PathLike) -> None:
        """By extension: .glb, which Trivet reads back whole; .gltf, .obj, .ply, .stl.

        A file that is there is replaced atomically; folders that are not there are made.

        Parameters
        ----------
        path : path

        Raises
        ------
        BadInputError
            Another extension.
        EnvironmentFailure
            It cannot be written.
        """
        self._scene.save(_arrays.path("path", path))

    def export(self, path: PathLike, *, collision: str = "fitted", friction: Optional[float] = None,
               density: Optional[float] = None, max_overlap: float = 0.0, hull_clearance: float = 0.0, mujoco: int = 3,
               meshes: Optional[PathLike] = None, simulate: Optional[float] = None,
               report: Optional[PathLike] = None) -> Export:
        """For a simulator, by extension: .xml or .mjcf (MuJoCo), .urdf, .sdf, .usda.

        Parameters
        ----------
        path : path
        collision : "fitted", "hull", "components", "decomposition" or "mesh"
        friction, density : float, optional
            Of everything, 0 to 1e3, and 1e-6 to 1e6 kg/m3; nothing: of the materials.
        max_overlap : float
            Metres by which parts of two objects may overlap, up to 1e3; 0: 1e-4 of the smaller one.
        hull_clearance : float
            Metres by which faces of convex parts are moved inwards, up to 1e3.
        mujoco : int
            Version of MuJoCo that reads the .xml or .mjcf: 3, or 2.
        meshes : path, optional
            Folder of meshes and images, relative to that of the file; scenes may share one, in which equal ones are one file.
            Nothing: beside the file, with its name.
        simulate : float, optional
            Seconds that MuJoCo lets the written .xml or .mjcf go: `Export.simulated` tells what moved.
        report : path, optional
            File for all of it as JSON, as ``--report`` of the program.

        Returns
        -------
        Export

        Raises
        ------
        BadInputError
            Parts overlap by more: a simulator would push them apart. To simulate: no MuJoCo here, or another format.
        """
        if simulate is not None:
            simulate = _arrays.number("simulate", simulate, "seconds, 1e-3 to 1e4", 1e-3, 1e4)
            if not _arrays.path("path", path).lower().endswith((".xml", ".mjcf")):
                raise _arrays.refuse("path", _arrays.short(path), "what MuJoCo reads: .xml or .mjcf, with simulate")
        if friction is not None:
            friction = _arrays.number("friction", friction, "a number from 0 to 1e3", 0.0, 1e3)
        if density is not None:
            density = _arrays.number("density", density, "kilograms per cubic metre, 1e-6 to 1e6", 1e-6, 1e6)
        values = self._scene.export(_arrays.path("path", path), _arrays.text("collision", collision), friction, density,
                                    _arrays.number("max_overlap", max_overlap, "metres, 0 to 1e3", 0.0, 1e3),
                                    _arrays.number("hull_clearance", hull_clearance, "metres, 0 to 1e3", 0.0, 1e3),
                                    _arrays.whole("mujoco", mujoco, 2, 3),
                                    "" if meshes is None else _arrays.path("meshes", meshes), simulate)
        if report is not None:
            write_file(report, values["report"].encode())
        moved = values["simulated"]
        return Export(tuple(values["files"]), tuple(values["notes"]),
                      tuple(Overlap(*one) for one in values["overlaps"]), values["masses"],
                      None if moved is None else Simulated(**moved))
