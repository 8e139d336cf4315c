"""The history of a scene: steps taken back and done again, and states to which it returns."""

from __future__ import annotations

from . import _arrays, _trivet
from ._snapshot import Snapshot


class History:
    """History of a scene; see `trivet.Scene`."""

    __slots__ = ()
    _scene: _trivet.Scene

    def undo(self) -> bool:
        """Take back the last step, to the bit; False when there is none."""
        return self._scene.undo()

    def redo(self) -> bool:
        """Do again what was undone; False when there is nothing."""
        return self._scene.redo()

    @property
    def can_undo(self) -> bool:
        """True if there is a step to take back."""
        return self._scene.can_undo

    @property
    def can_redo(self) -> bool:
        """True if there is a step to do again."""
        return self._scene.can_redo

    @property
    def steps(self) -> list[str]:
        """Names of the operations that are done."""
        return self._scene.steps()

    def snapshot(self) -> Snapshot:
        """The scene as it is now."""
        return Snapshot(self._scene.snapshot())

    def restore(self, snapshot: Snapshot) -> None:
        """As it was then, to the bit; its history begins anew.

        Parameters
        ----------
        snapshot : Snapshot
            Of this scene or of another one.
        """
        if not isinstance(snapshot, Snapshot):
            raise _arrays.refuse("snapshot", repr(snapshot), "a trivet.Snapshot")
        self._scene.restore(snapshot._snapshot)

    @property
    def fingerprint(self) -> int:
        """64 bits: the same for scenes of the same bits, their shapes apart."""
        return self._scene.fingerprint()
