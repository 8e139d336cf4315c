"""The scene: objects, what rests on what, history and files."""

from __future__ import annotations

from typing import Any, Iterable, Iterator, Mapping, Optional, Union

from numpy.typing import ArrayLike

from . import _arrays, _trivet
from ._drag import Drag
from ._errors import NoSuchObject
from ._files import Files
from ._history import History
from ._named import name_of
from ._object import Object
from ._pictures import Pictures
from ._pour import Pours
from ._properties import Material, material_of
from ._questions import Questions
from ._repairs import Repairs
from ._results import Result, done
from ._settle import Settle, detection, settings
from ._shape import Shape
from ._snapshot import Snapshot
from ._transaction import Transaction


class Scene(Files, History, Pictures, Pours, Questions, Repairs):
    """Objects that never interpenetrate and lie at rest; gravity along -z.

    A mapping of names to objects, in the order of their addition. Any number of threads may use one scene: one at a time
    does, the others wait with the GIL released. Pickles like its `snapshot`, without history.

    Parameters
    ----------
    floor : bool
        Whether there is one, at z = 0.
    floor_material : str or dict, optional
        A name of `materials`, or "friction", "density", "restitution"; nothing: friction 0.5.
    clearance : float
        Metres that objects stay apart; 0: 2^-20 of the size of what is within 10 m, at most 0.0095 mm (more for large objects).
    detector : "auto", "bvh", "software", "gpu", "framebuffer" or "compute"
        Detector of candidates for contact, as ``--detector`` of the program; results do not depend on it.
    device : int or "auto"
        Number of the EGL device of a GPU, from 1, as ``--device`` of the program.
    **options
        How to settle: `perfect_friction`, `whole_at_rest`, `robust`, `accept_wedged` (bool), `max_motions` (int); what is
        left out is as in the program `trivet`.
    """

    __slots__ = ("_scene", "__weakref__")

    def __init__(self, floor: bool = True, *, floor_material: Optional[Material] = None, clearance: float = 0.0,
                 detector: str = "auto", device: Union[int, str] = "auto", **options: Any) -> None:
        self._scene = _trivet.Scene.empty(_arrays.flag("floor", floor), material_of(floor_material),
                                          settings(clearance, options))
        self._scene.choose_detector(*detection(detector, device))

    @classmethod
    def _of(cls, scene: _trivet.Scene) -> Scene:
        out = cls.__new__(cls)
        out._scene = scene
        return out

    # Objects.

    def add(self, name: str, shape: Union[Shape, Any], *, pose: Optional[ArrayLike] = None, scale: Optional[float] = None,
            fixed: bool = False, up: Optional[str] = None, material: Optional[Material] = None,
            collision: Optional[Union[Shape, Any]] = None) -> Object:
        """A new object; out of the scene until it is put, or standing exactly at `pose`.

        Parameters
        ----------
        name : str
            Not "floor", not taken.
        shape : Shape, or a mesh as `Shape` takes one
        pose : (4, 4) array, optional
            World from shape: rotation, translation, and a uniform scale. Tested for interpenetration, not settled.
        scale : float, optional
            Metres for each unit of the shape; nothing: what the shape's file states, else 1.
        fixed : bool
            It never moves and carries everything.
        up : "y" or "z", optional
            Axis of the shape that points up; nothing: `shape.up`.
        material : str or dict, optional
            As `Object.material`.
        collision : Shape or mesh, optional
            Judged instead of `shape`, in its coordinates; `shape` is what is drawn and seen.

        Returns
        -------
        Object

        Raises
        ------
        Refused
            "name_taken", "crossing", "inside", "below_floor", ...
        BadInputError
            A name that none can have; a pose that is sheared, mirrored or unequally scaled; a scale out of range.
        """
        _arrays.text("name", name)
        if up not in (None, "y", "z"):
            raise _arrays.refuse("up", _arrays.short(up), '"y" or "z"')
        given = shape if isinstance(shape, Shape) else Shape(shape)
        judged = collision if collision is None or isinstance(collision, Shape) else Shape(collision)
        matrix = None if pose is None else _arrays.matrix(f'pose of "{name}"', pose)
        metres = None
        if scale is not None:
            metres = _arrays.number("scale", scale, "a number from 1e-15 to 1e15", 1e-15, 1e15)
        done(self._scene.add(name, given._shape, matrix, metres, _arrays.flag("fixed", fixed), up, material_of(material),
                             None if judged is None else judged._shape))
        return self[name]

    def __getitem__(self, name: str) -> Object:
        key = self._find(name)
        if key is None:
            raise NoSuchObject(f"there is no object {_quoted(name)}")
        return Object(self, key, name)

    def __contains__(self, item: object) -> bool:
        if isinstance(item, Object):
            return item.scene is self and self._scene.find(item.name) == item._key
        return self._find(item) is not None

    def _find(self, name: object) -> Optional[int]:
        """The key of what has this name; no object has one that UTF-8 has not."""
        if not isinstance(name, str) or name != name.encode(errors="replace").decode():
            return None
        return self._scene.find(name)

    def __iter__(self) -> Iterator[Object]:
        return iter([Object(self, key, name) for key, name in self._scene.entries()])

    def __len__(self) -> int:
        return len(self._scene)

    @property
    def names(self) -> list[str]:
        """Names of all objects, in the scene's order."""
        return [name for _, name in self._scene.entries()]

    @property
    def floor(self) -> bool:
        """True if there is one."""
        return self._scene.floor

    @property
    def settle(self) -> Settle:
        """Rules of settling: `clearance`, `perfect_friction`, `whole_at_rest`, `robust`, `accept_wedged`, `max_motions`."""
        return Settle(self._scene.settle)

    @property
    def detector(self) -> str:
        """Detector of candidates for contact, from the next operation on; results do not depend on it."""
        return self._scene.detector

    @detector.setter
    def detector(self, name: str) -> None:
        self._scene.choose_detector(*detection(name, self.device))

    @property
    def device(self) -> Union[int, str]:
        """Number of the EGL device of a GPU; "auto": the first that works, or that of ``TRIVET_EGL_DEVICE``."""
        return self._scene.device or "auto"

    @device.setter
    def device(self, number: Union[int, str]) -> None:
        self._scene.choose_detector(*detection(self.detector, number))

    @property
    def time_budget(self) -> float:
        """Seconds that an operation may take, where it has no budget of its own; 0: unlimited."""
        return self._scene.time_budget

    @time_budget.setter
    def time_budget(self, seconds: float) -> None:
        self._scene.time_budget = _arrays.seconds("time_budget", seconds)

    @property
    def notes(self) -> list[str]:
        """Losses of the scene's file, or refused operations of a layout."""
        return self._scene.notes

    # Operations.

    def perform(self, operations: Iterable[Mapping[str, Any]], *, budget: float = 0.0) -> Result:
        """Operations as a layout has them, as one step: all or none.

        Parameters
        ----------
        operations : list of dict
            ``[{"op": "put", "object": "cup", "on": "table"}]``. Values may be NumPy's numbers and arrays, and objects stand
            for their names.
        budget : float
            Seconds of each; 0: those of `time_budget`.

        Returns
        -------
        Result
            Of the last one.

        Raises
        ------
        Refused
            For the first that is refused; none is done.
        """
        accepted = 'a list of dicts, such as {"op": "put", "object": "cup", "on": "table"}'
        given = []
        for number, one in enumerate(_arrays.listed("operations", operations, accepted)):
            what = f"operations: {number}"
            given.append(_arrays.plain(what, _arrays.mapping(what, one, accepted), self._name_of))
        return done(self._scene.perform_all(given, _arrays.seconds("budget", budget)))

    def _name_of(self, what: str, value: Any) -> Any:
        return name_of(what, value, self) if isinstance(value, Object) else value

    def drape(self, name: str, *, size: Optional[ArrayLike] = None, path: Optional[ArrayLike] = None,
              of: Optional[Union[Object, str]] = None, position: Optional[ArrayLike] = None,
              wxyz: Optional[ArrayLike] = None, pins: Optional[ArrayLike] = None, budget: float = 0.0,
              **options: Any) -> Object:
        """A sheet, a cable or an open mesh comes down on what is there, and to rest: a new object, which is fixed.

        It passes through nothing, nor through itself. What lies under it stays where it is.

        Parameters
        ----------
        name : str
            Not taken.
        size : (2,) array, optional
            Of a sheet: metres along warp and weft.
        path : (n, 3) array, optional
            Of a cable: corners of the line along which it starts.
        of : Object or str, optional
            Of a mesh: the object that has it, in the scene or not.
        position, wxyz : (3,) and (4,) array, optional
            Where the middle of the sheet or the mesh's origin starts; without `wxyz` level.
        pins : (n, 3) array, optional
            The vertices nearest to these points stay where they start.
        budget : float
            Seconds; 0: those of `time_budget`.
        **options
            `material` ("cotton", "felt", "paper", "towel", "wool", of cables "lead"); `cell`, `thickness` (metres),
            `density` (kg/m2, of cables kg/m), `bending` (N m, of cables N m2) and `friction` instead of the
            material's; `held_by` (names of objects, one for each pin: when they move, it is draped again with its ends
            there); `again=True` (alone: `name` was draped before, and is once more from its first start); `net_force` and
            `steps`, by which it is at rest.

        Returns
        -------
        Object
            `Object.flexible` has the certificate of its rest, `Object.middle` its shape.

        Raises
        ------
        Refused
            "already_touches", "crosses_itself", "not_at_rest", "overstretched", "no_sheet", "name_taken", ...
        """
        given: dict[str, Any] = {"op": "drape", "object": _arrays.text("name", name), "size": size, "path": path,
                                 "of": of, "position": position, "rotation": wxyz, "pins": pins, **options}
        self.perform([{key: value for key, value in given.items() if value is not None}], budget=budget)
        return self[name]

    def cancel(self) -> None:
        """Stop the operation that another thread has under way; it raises `Cancelled` there."""
        self._scene.cancel()

    def transaction(self) -> Transaction:
        """All operations in the block, or none of them when it raises; one step of history. Gives the scene.

        The scene belongs to this thread until the block ends. Another thread that ends it, or a block that ends before one
        within it, gets `SceneBusy`, and the transaction goes on.
        """
        return Transaction(self)

    def drag(self, what: Union[Object, str], op: str = "push", **options: Any) -> Drag:
        """Follow a hand; see `Drag`.

        Parameters
        ----------
        what : Object or str
        op : "push", "turn", "pick_up", "translate" or "rotate"
        **options
            Of the operation, as `Object` has them.

        Returns
        -------
        Drag
            For a ``with`` block.
        """
        return Drag(self, name_of("what", what, self), op, options)

    def __reduce__(self) -> Any:
        settle = self._scene.settle
        options = {key: getattr(settle, key) for key in dir(settle) if not key.startswith("_")}
        return _unpickled, (self.snapshot(), options, self.detector, self.device)

    def __repr__(self) -> str:
        return f"<trivet.Scene of {len(self)} objects>"


def _quoted(name: object) -> str:
    return f'"{name}"' if isinstance(name, str) and name.isprintable() else _arrays.short(name)


def _unpickled(snapshot: Snapshot, options: dict[str, Any], detector: str = "auto", device: Union[int, str] = "auto") -> Scene:
    scene = snapshot.scene(**options)
    scene._scene.choose_detector(*detection(detector, device))
    return scene


def materials() -> dict[str, dict[str, Any]]:
    """Materials by name: "friction", "density" (kg/m3), "restitution"; of everyday things, dry and clean."""
    return _trivet.materials()
