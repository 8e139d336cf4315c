"""Exceptions that Trivet raises."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._results import Result


class TrivetError(Exception):
    """Base of all that Trivet raises on purpose."""


class BadInputError(TrivetError, ValueError):
    """An argument or a file that is not accepted; says what, its value, and what is accepted."""


class EnvironmentFailure(TrivetError, OSError):
    """A file that cannot be written, a program that is missing."""


class NoSuchObject(TrivetError, KeyError):
    """The scene has no such object, or no longer."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class SceneBusy(TrivetError, RuntimeError):
    """The scene cannot be used here: from a callback of its own work, while an object is dragged, or in another
    thread than the one to which a drag or a transaction belongs."""


class NotDone(TrivetError):
    """Base of what is raised when an operation was not done; the scene is as it was.

    Attributes
    ----------
    result : Result
    """

    def __init__(self, result: Result) -> None:
        super().__init__(result.reason)
        self.result = result

    def __reduce__(self) -> Any:
        return type(self), (self.result,)

    @property
    def code(self) -> str:
        """Cause of the refusal: ``"wedged"``, ``"crossing"``, ...; see ``trivet.CAUSES``."""
        return self.result.code

    @property
    def objects(self) -> tuple[str, ...]:
        """Names of the objects that the reason names, the one of the operation first."""
        return self.result.objects


class Refused(NotDone):
    """The operation cannot be done."""


class Cancelled(NotDone):
    """`Scene.cancel` stopped the operation."""


class OutOfTime(NotDone, TimeoutError):
    """The operation did not end within its budget."""
