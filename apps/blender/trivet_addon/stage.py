"""The stage: a scene of Blender's as read, work done on it, and the result written, looked at and judged."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Callable, Iterable, Mapping, Optional, Sequence

import numpy as np

from .bodies import Body, holds, moved, reach_of, usual_clearance
from .layouts import Layout, Outcome, Settings, few
from .reading import Reading, TooLarge, read, root_among
from .work import Report
from .writing import Writer, misplaced, probe, why_it_stays

MOST_ROUNDS = 20
_PRECISIONS = 4.0  # what Blender's matrices are off, in a clearance
_COARSEST = 1.0 / 64  # clearance of a body's size, as Trivet has it
_WIDER = 4.0
_WIDEST = 2.0 ** -12  # of the smallest body that moves
_CHANGED = 1e-3  # of a body's size: no rounding


@dataclass(frozen=True)
class Choices:
    """Choices of the preferences and of the scene."""

    backend: object  # backends.Backend
    settings: Settings
    obstacles: str = "VISIBLE"
    most_faces: int = 0


class Stage:
    """Objects that an operator moves, and what is around them.

    `refused` has an Outcome for each of them that cannot be moved, by the object's name.
    falls : what moves stays near; then instances further away are left out if there are too many
    as_one : they keep their places to each other, and move by the active one, or the first by name
    """

    def __init__(self, context, objects: Iterable, choices: Choices, *, moves: bool = True, falls: bool = False,
                 as_one: bool = False) -> None:
        self.context, self.choices = context, choices
        objects = set(objects)
        movers = {root_among(one, objects) for one in objects}
        active = root_among(context.active_object, objects) if context.active_object else None
        self._together = sorted(movers, key=lambda one: (one != active, one.name_full)) if as_one else []
        self.reach: Optional[np.ndarray] = None  # (k, 2, 3) boxes; beyond, instances were not read
        self.reading = self._read(movers, falls)
        self.refused: dict = {one.name_full: _because(one.name_full, why) for one, why in self.reading.faults.items()}
        self._held: set = set()
        precision = self._hold_what_stays(movers) if moves else 0.0
        self.clearance = choices.settings.clearance or max(
            usual_clearance([self.reading.body(name) for name in self.movers]), _PRECISIONS * precision,
            context.scene.trivet.clearance)

    def _read(self, movers: set, falls: bool) -> Reading:
        asked = {"together": self._together, "obstacles": self.choices.obstacles, "most_faces": self.choices.most_faces}
        try:
            return read(self.context, movers, **asked)
        except TooLarge:
            if not falls:
                raise
        bodies = read(self.context, movers, only=movers, **asked).bodies
        self.reach = np.array([reach_of(body) for body in bodies]).reshape(-1, 2, 3)
        return read(self.context, movers, reach=self.reach, **asked)

    def hold_what_left(self, report: Report) -> bool:
        """Holds each body that came to rest where instances were left out. Returns true if there was one."""
        if self.reach is None:
            return False
        gone = []
        for name, motion in report.motions.items():
            points = moved(self.reading.body(name).world(), motion)
            if not holds(self.reach, points.min(axis=0), points.max(axis=0)):
                gone.append(name)
        for name in gone:
            self.hold(name, "would come to rest beyond what was read of so many instances; accepted: more triangles in the "
                      "preferences, or fewer obstacles")
        return bool(gone)

    @property
    def notes(self) -> list:
        """Notes for the user about the objects that were read."""
        out = []
        if self.reading.left_out:
            out.append(f"Left out, with coordinates that are not finite: {few(self.reading.left_out)}")
        if self.reading.rendered_otherwise:
            out.append("Judged as the view shows it; renders have other levels or modifiers of: "
                       + few(self.reading.rendered_otherwise))
        return out

    def _hold_what_stays(self, movers: set) -> float:
        """Returns metres by which Blender is off in what it can move."""
        auto_key = self.context.scene.tool_settings.use_keyframe_insert_auto
        for name, owner in self.reading.owners.items():
            if owner in movers or not self.reading.body(name).fixed:
                for one in self.reading.all_of(name):
                    if why := why_it_stays(one, auto_key):
                        self.hold(name, why, one)
        for name in self.movers:
            if usual_clearance([self.reading.body(name)]) > _COARSEST * _size(self.reading.body(name)):
                self.hold(name, "is too far from the origin: Blender's numbers there are too coarse for it")
        stuck, precision = probe(self.context, self.reading, self.movers)
        for name, (one, why) in stuck.items():
            self.hold(name, why, one)
        return precision

    @property
    def movers(self) -> list:
        """Names of bodies that the operator may move."""
        return [name for name, owner in self.reading.owners.items()
                if owner in self.reading.movers and name not in self._held]

    @property
    def bodies(self) -> list:
        return [replace(body, fixed=True) if body.name in self._held else body for body in self.reading.bodies]

    def hold(self, name: str, why: str, because_of=None) -> None:
        """This one stays from now on, because of its owner or of one that is together with it."""
        self._held.add(name)
        owner = self.reading.owners[name]
        if owner in self.reading.movers:
            self.refused[owner.name_full] = _because((because_of or owner).name_full, why)

    def widen(self) -> bool:
        """A larger clearance from now on; false if that would be seen, or the user asked for one."""
        sizes = [_size(self.reading.body(name)) for name in self.movers]
        if self.choices.settings.clearance or not sizes or _WIDER * self.clearance > _WIDEST * min(sizes):
            return False
        self.clearance *= _WIDER
        return True

    def make(self, bodies: Sequence[Body], out: Sequence[str]) -> Layout:
        """A layout of these; see `work.MakeLayout`."""
        return self.choices.backend.layout(bodies, out, self.settings)

    @property
    def settings(self) -> Settings:
        return replace(self.choices.settings, clearance=self.clearance)

    def object_name(self, name: str) -> str:
        return self.reading.owners[name].name_full if name in self.reading.owners else name


def finish(stage: Stage, report: Report, again: Callable[[], Report]) -> Report:
    """Shows the result, after as many rounds as that takes; see `is_shown`.

    The report is empty, with reasons, if nothing could be done; Blender is then as it was.
    """
    for _ in range(MOST_ROUNDS):
        if is_shown(stage, report):
            return report
        report = again()
    return Report(refused=report.refused)


def is_shown(stage: Stage, report: Report) -> bool:
    """Writes the result and judges what Blender shows, by its own float32 matrices; true if it may stay.

    Else Blender is as it was, and the work is to be done again: what Blender shows elsewhere stays from then on; where
    anything interpenetrates, or what stands in the layout does not where Blender shows it, the clearance is larger.
    The report's verdict is of what Blender shows.
    """
    if not report.motions:
        return True
    if stage.hold_what_left(report):
        return False
    writer = Writer(stage.context, stage.reading)
    try:
        written = writer.write(report.motions)
        wrong, shown = misplaced(stage.context, stage.reading, written, 0.5 * stage.clearance)
        bodies = _shown_bodies(stage, report, shown)
        pairs = [] if wrong else stage.choices.backend.crossings(bodies, list(written))
        verdict = None if wrong or pairs else stage.choices.backend.judge(bodies, stage.settings)[0]
    except BaseException:
        writer.put_back()
        raise
    if verdict is not None and (verdict.stands or not report.verdict.stands or not stage.widen()):
        report.verdict = verdict
        _remember(stage, report)
        return True
    writer.put_back()
    if verdict is not None:
        return False
    changed = [name for name, metres in wrong.items() if metres > _CHANGED * _size(stage.reading.body(name))]
    for name in changed:
        stage.hold(name, "changes its shape as it moves, by a modifier or what it hangs on")
    if not changed and not stage.widen():
        for name in {*wrong, *(name for pair in pairs for name in pair)} & set(stage.movers):
            stage.hold(name, "is not where it should be once it is moved: Blender's numbers are too coarse here")
    return False


def _shown_bodies(stage: Stage, report: Report, shown: Reading) -> list:
    """All bodies where Blender shows them; what was refused stands still, as what did in the work."""
    there = {stage.reading.name_of(shown.owners[body.name]): body for body in shown.bodies}
    still = {*report.refused, *report.still}
    return [replace(there.get(body.name, body), name=body.name, fixed=body.fixed or body.name in still)
            for body in stage.bodies]


def _remember(stage: Stage, report: Report) -> None:
    """Marks what was put as free, keeps the clearance, and inserts keys where that is on."""
    stage.context.scene.trivet.clearance = max(stage.context.scene.trivet.clearance, stage.clearance)
    auto_key = stage.context.scene.tool_settings.use_keyframe_insert_auto
    for name in report.motions:
        objects = stage.reading.all_of(name)
        for owner in objects:
            # Things that were put as one may not stand each alone.
            if len(objects) == 1 and owner.trivet.role == "AUTO" and not _is_passive(owner):
                owner.trivet.role = "FREE"
            if auto_key:
                _insert_keys(owner)


def _insert_keys(owner) -> None:
    owner.keyframe_insert("location")
    owner.keyframe_insert({"QUATERNION": "rotation_quaternion", "AXIS_ANGLE": "rotation_axis_angle"}.get(
        owner.rotation_mode, "rotation_euler"))


def _is_passive(owner) -> bool:
    """True if an object stands still in Blender's own simulation."""
    return owner.rigid_body is not None and owner.rigid_body.type == "PASSIVE"


def _size(body: Body) -> float:
    return float(np.linalg.norm(np.ptp(body.bounds(), axis=0)))


def _because(name: str, why: str) -> Outcome:
    return Outcome(False, "immovable", f'"{name}" {why}', (name,))
