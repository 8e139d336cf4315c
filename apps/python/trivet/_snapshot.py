"""Snapshots of scenes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from . import _arrays, _trivet
from ._properties import Material
from ._settle import settings
from ._shape import find_importer

if TYPE_CHECKING:
    from ._scene import Scene


class TrivetWarning(UserWarning):
    """A loss of a scene's file, or a refused operation of a layout."""


class Snapshot:
    """A scene at a moment: a value that can be kept, compared, pickled and given back to `Scene.restore`.

    Pickled it keeps poses and shapes to the bit; what objects touch and how they rest is then found again.
    """

    __slots__ = ("_snapshot",)

    def __init__(self, snapshot: _trivet.Snapshot) -> None:
        self._snapshot = snapshot

    def to_bytes(self) -> bytes:
        """As a binary glTF file (.glb) of Trivet, with the doubles of all shapes."""
        return self._snapshot.to_bytes()

    @classmethod
    def from_bytes(cls, data: bytes) -> Snapshot:
        """The bytes that `to_bytes` gave, or the bytes of a .glb that Trivet wrote.

        Parameters
        ----------
        data : bytes

        Returns
        -------
        Snapshot

        Raises
        ------
        BadInputError
            Other bytes.
        """
        if not isinstance(data, (bytes, bytearray, memoryview)):
            raise _arrays.refuse("data", _arrays.short(data), "bytes, as to_bytes gave them")
        return cls(_trivet.Snapshot.from_bytes(bytes(data), find_importer()))

    def scene(self, *, clearance: Optional[float] = None, **options: Any) -> Scene:
        """A new scene that begins like this.

        Parameters
        ----------
        clearance, **options
            As for `Scene`; what is left out is as it was.

        Returns
        -------
        Scene
        """
        from ._scene import Scene

        return Scene._of(self._snapshot.scene(settings(clearance, options, self._snapshot.settle)))

    @property
    def fingerprint(self) -> int:
        """64 bits: the same for scenes of the same bits, their shapes apart."""
        return self._snapshot.fingerprint()

    def __len__(self) -> int:
        return len(self._snapshot)

    def __reduce__(self) -> Any:
        return Snapshot.from_bytes, (self.to_bytes(),)

    def __repr__(self) -> str:
        return f"<trivet.Snapshot of {len(self)} objects>"
