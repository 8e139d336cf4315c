"""Films: what moves, as an animated scene for viewers."""

from __future__ import annotations

from types import TracebackType
from typing import TYPE_CHECKING, Optional

from . import _trivet
from ._errors import SceneBusy
from ._shape import PathLike, write_file

if TYPE_CHECKING:
    from ._scene import Scene


class Film:
    """Film of all that moves while the block runs, as an animated .glb.

    The object of an operation goes the way that was executed, motion by motion, and its loads with it; what gave way or
    settled then goes to where it came to rest. Of several operations at once, of drags and of undo only the ends are known.
    A motion takes as long as a fall of its length. Objects are hidden while they are out of the scene.

    >>> with scene.film() as film:                    # doctest: +SKIP
    ...     cup.put([0.1, 0.2, 1.5])
    >>> film.save("put.glb")                          # doctest: +SKIP
    """

    __slots__ = ("_scene", "_film")

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._film: Optional[_trivet.Film] = None

    def __enter__(self) -> Film:
        self._scene._scene.begin_film()
        return self

    def __exit__(self, kind: Optional[type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self._film = self._scene._scene.end_film()

    def _made(self) -> _trivet.Film:
        if self._film is None:
            raise SceneBusy("the film has not been made; accepted: after its block")
        return self._film

    @property
    def seconds(self) -> float:
        """Length, seconds."""
        return self._made().seconds

    def to_glb(self) -> bytes:
        """A binary glTF file with one animation, "motion", for viewers; it is no scene of Trivet."""
        return self._made().to_glb()

    def save(self, path: PathLike) -> None:
        """Write the same to a file.

        Parameters
        ----------
        path : path
            .glb, in a folder that is there.

        Raises
        ------
        EnvironmentFailure
            It cannot be written.
        """
        write_file(path, self.to_glb())
