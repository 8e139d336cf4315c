"""Transactions: all operations of a block, or none of them."""

from __future__ import annotations

from types import TracebackType
from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from ._scene import Scene


class Transaction:
    """See `Scene.transaction`. One that is lost without an end is taken back."""

    __slots__ = ("_scene", "_transaction")

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._transaction = scene._scene.transaction()

    def __enter__(self) -> Scene:
        self._transaction.enter()
        return self._scene

    def __exit__(self, kind: Optional[type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self._transaction.leave(kind is None)
