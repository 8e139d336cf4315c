"""Backends: the Python module where it loads, else the program `trivet`; which one, and why. Without bpy."""

from __future__ import annotations

import importlib
import os
import shutil
import sys
from dataclasses import dataclass
from typing import Any, Optional, Sequence

from . import module as in_process
from . import program as piped
from .bodies import Body
from .layouts import Layout, Settings

KINDS = ("AUTO", "MODULE", "PROGRAM")


class NoBackend(Exception):
    """Neither the module nor the program can be used; says why."""


@dataclass(frozen=True)
class Backend:
    """Where layouts are made."""

    kind: str  # "MODULE" or "PROGRAM"
    where: str  # the module's folder or the program
    version: str
    module: Any = None
    note: str = ""  # why it is not the module

    def layout(self, bodies: Sequence[Body], out: Sequence[str], settings: Settings) -> Layout:
        if self.module is not None:
            return in_process.ModuleLayout(self.module, bodies, out, settings)
        return piped.ProgramLayout(self.where, bodies, out, settings)

    def crossings(self, bodies: Sequence[Body], about: Sequence[str]) -> list:
        """Pairs of names that interpenetrate where these bodies are; those with one of `about`."""
        if self.module is not None:
            return in_process.crossings(self.module, bodies, about)
        return piped.crossings(self.where, bodies, about)

    def judge(self, bodies: Sequence[Body], settings: Settings):
        """(Verdict, {name: Status}) of bodies where they are; nothing is moved."""
        if self.module is not None:
            return in_process.judge(self.module, bodies, settings)
        return piped.judge(self.where, bodies, settings)

    @property
    def text(self) -> str:
        what = "Python module" if self.kind == "MODULE" else "program, over a pipe"
        return f"Trivet {self.version}, {what}: {self.where}"


_found: dict = {}


def find(kind: str = "AUTO", folder: str = "", program: str = "") -> Backend:
    """The backend that can be used; raises NoBackend. Found once for the same arguments."""
    key = (kind, folder, program)
    if key not in _found:
        _found[key] = _find(*key)
    return _found[key]


def _find(kind: str, folder: str, program: str) -> Backend:
    why = ""
    if kind != "PROGRAM":
        try:
            return _module(folder)
        except Exception as error:  # whatever an import may raise
            why = f"the module `trivet` does not load: {error}"
            if kind == "MODULE":
                raise NoBackend(why) from error
    return _program(program, why)


def _module(folder: str) -> Backend:
    if folder:
        if not os.path.isdir(os.path.join(folder, "trivet")):
            raise NoBackend(f"{folder}: there is no package `trivet` in it")
        if folder not in sys.path:
            sys.path.insert(0, folder)
    trivet = importlib.import_module("trivet")
    return Backend("MODULE", os.path.dirname(trivet.__file__), trivet.__version__, trivet)


def _program(program: str, why: str) -> Backend:
    found: Optional[str] = shutil.which(program or "trivet")
    if found is None:
        missing = f"the program {program or 'trivet'} is missing"
        raise NoBackend(f"{why}; {missing}" if why else missing)
    try:
        return Backend("PROGRAM", found, piped.ProgramLayout.version(found), note=why)
    except piped.ProgramError as error:
        raise NoBackend(f"{why}; {error}" if why else str(error)) from error
