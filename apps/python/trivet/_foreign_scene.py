"""Scenes of other programs as files: judged, settled, mended, their joints moved, written back."""

from __future__ import annotations

import json
import os
from typing import Any, Iterable, Optional

import numpy as np
from numpy.typing import NDArray

from . import _arrays, _trivet
from ._named import names as names_of
from ._shape import PathLike, find_importer

Verdict = dict[str, Any]
RULES = ("format", "mujoco", "bullet", "gazebo", "trivet")


class Foreign:
    """A scene of another program: MJCF, URDF, SDF, USD or glTF. Made by `Foreign.load`.

    What is written differs from what was read in the numbers of poses that changed; all other bytes are equal.
    """

    __slots__ = ("_opened",)
    _opened: _trivet.Foreign

    def __init__(self) -> None:
        raise TypeError("Foreign: made by Foreign.load")

    @classmethod
    def load(cls, path: PathLike, *, key: Optional[str] = None, collide: str = "engine", rules: str = "format",
             roots: Iterable[PathLike] = (), fixed: Iterable[str] = (), floor: Optional[float] = None, no_floor: bool = False) -> Foreign:
        """Reads a scene as its engine sees it.

        Parameters
        ----------
        path : path
            .xml or .mjcf, .urdf, .sdf or .world, .usda, .glb or .gltf.
        key : str
            Keyframe of MJCF with the poses; "none": where the bodies stand; a file .npy: an array of qpos. Default: the
            first keyframe, if it has positions.
        collide : "engine" or "raw"
            Colliding meshes as the engine takes them, by their hulls, or as they are.
        rules : "format", "mujoco", "bullet", "gazebo" or "trivet"
            Engine by whose rule the friction of two surfaces counts: the larger one, their product, the smaller one;
            by default that of the format's own engine.
        roots : folders
            Besides its own, those whose files the scene may name.
        fixed : names
            Objects of glTF that never move.
        floor : float
            Height of the floor of glTF, metres; default: the lowest point.
        no_floor : bool
            No floor under glTF.

        Returns
        -------
        Foreign

        Raises
        ------
        BadInputError
            What the file has wrong, with its line; a name or a keyframe that is not there.
        """
        if collide not in ("engine", "raw"):
            raise _arrays.refuse("collide", repr(collide), '"engine" or "raw"')
        if rules not in RULES:
            raise _arrays.refuse("rules", repr(rules), ", ".join(f'"{name}"' for name in RULES))
        scene = object.__new__(cls)
        scene._opened = _trivet.Foreign.open(
            os.fspath(path), find_importer(), key, collide == "raw", rules, [os.fspath(root) for root in roots],
            names_of("fixed", fixed), None if floor is None else _arrays.number("floor", floor),
            _arrays.flag("no_floor", no_floor))
        return scene

    @property
    def format(self) -> str:
        """"MJCF", "URDF", "SDF", "USD" or "glTF"."""
        return self._opened.format

    @property
    def key(self) -> str:
        """Keyframe that the poses are of; empty: none."""
        return self._opened.key

    @property
    def notes(self) -> list[str]:
        """Parts that were taken in another way than they stand, and links that gravity would move."""
        return self._opened.notes

    @property
    def not_judged(self) -> list[str]:
        """Parts that matter and were not read: verdicts then hold for a part."""
        return self._opened.not_judged

    @property
    def joints(self) -> dict[str, dict[str, Any]]:
        """By name: "kind" ("slide" or "hinge"), "value", "lower", "upper" (metres or degrees; None: no limit), "links"."""
        return {one["joint"]: one for one in json.loads(self._opened.joints())}

    def check(self) -> Verdict:
        """Judges the scene as it is now.

        Returns
        -------
        dict
            "ok"; "findings", each with "kind" ("passes through", "floats", "not at rest", "unstable"), "object" and what
            `trivet check --json` has; "touching", "objects", "free", "notes", "not_judged".
        """
        verdict: Verdict = json.loads(self._opened.check())
        return verdict

    def intent(self, tolerance: float = 0.0) -> Verdict:
        """Relations of standing on and in, as the poses mean them, though they may interpenetrate and float.

        Parameters
        ----------
        tolerance : float
            Metres by which poses may be off; 0: found from the poses.

        Returns
        -------
        dict
            "tolerance"; "objects", each with "object", "on" (names and shares), "in", "gap" (metres), "level".
        """
        intent: Verdict = json.loads(self._opened.intent(_arrays.number("tolerance", tolerance)))
        return intent

    def settle(self, only: Iterable[str] = (), lift: float = 0.2, seconds: float = 0.0) -> Verdict:
        """Brings what floats or is sunk to rest; what is at rest stays, to the bit.

        Parameters
        ----------
        only : names
            Objects that may move; none: all that are free.
        lift : float
            Largest height, metres, to lift an object before it is let go.
        seconds : float
            For all; 0: unlimited. What is left then stays where it is.

        Returns
        -------
        dict
            "moved", each with "object", "from", "to", "metres", "degrees"; "unable", each with "object" and "why".
        """
        out: Verdict = json.loads(self._opened.settle(names_of("only", only), _arrays.number("lift", lift),
                                                      _arrays.number("seconds", seconds)))
        return out

    def mend(self, only: Iterable[str] = (), tolerance: float = 0.0, seconds: float = 0.0) -> Verdict:
        """Finds the nearest true scene that keeps what stood on what.

        Parameters
        ----------
        only, seconds
            As for `settle`.
        tolerance : float
            As for `intent`.

        Returns
        -------
        dict
            As of `settle`, and "supports_meant", "supports_kept", "relations" (names lost and gained).
        """
        out: Verdict = json.loads(self._opened.mend(names_of("only", only), _arrays.number("tolerance", tolerance),
                                                    _arrays.number("seconds", seconds)))
        return out

    def move_joint(self, name: str, to: float) -> Verdict:
        """Slides or turns a joint, with what lies in and on its links, up to a limit or the first contact.

        Parameters
        ----------
        name : str
            One of `joints`.
        to : float
            Metres or degrees.

        Returns
        -------
        dict
            As of `joints`, and "end" ("reached", "limit", "blocked"), "blocked_by", "carried".

        Raises
        ------
        BadInputError
            No such joint.
        """
        out: Verdict = json.loads(self._opened.move_joint(name, _arrays.number("to", to)))
        return out

    def poses(self) -> dict[str, NDArray[np.float64]]:
        """Poses by name.

        Returns
        -------
        dict
            (4, 4) of each, metres, in the world of the file.
        """
        return self._opened.poses()

    def save(self, path: PathLike) -> None:
        """Writes the scene with its new poses and values of joints; included files beside it. Inputs stay.

        Parameters
        ----------
        path : path
            Not that of the scene itself.

        Raises
        ------
        BadInputError
            A pose has no place in the file; a file would be overwritten.
        """
        self._opened.save(os.fspath(path))
