"""Work: what an operator does with a layout, step by step, in any thread. Without bpy."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Mapping, Sequence

import numpy as np

from .bodies import Body, motion_of
from .layouts import Layout, Outcome, Verdict

MakeLayout = Callable[[Sequence[Body], Sequence[str]], Layout]  # bodies, those that are out of the scene


class Stopped(Exception):
    """The user stopped the work; nothing is to be written."""


@dataclass
class Report:
    """The end of the work: how far each body moved, and why others did not."""

    done: list = field(default_factory=list)  # names, in order
    refused: dict = field(default_factory=dict)  # name -> Outcome
    motions: dict = field(default_factory=dict)  # name -> (4, 4), of all that moved, gave way included
    gave_way: list = field(default_factory=list)
    verdict: Verdict = field(default_factory=Verdict)
    statuses: dict = field(default_factory=dict)  # name -> Status
    outcome: Outcome = Outcome(True)  # of a move
    still: set = field(default_factory=set)  # names of bodies that stood still, though the operator was given them


class Progress:
    """Progress of the work; shared by the thread that works and the one that shows it."""

    def __init__(self) -> None:
        self.done, self.total, self.what = 0, 0, ""
        self.stopped = False
        self._layout: Any = None

    def watch(self, layout: Layout) -> None:
        self._layout = layout

    def stop(self) -> None:
        self.stopped = True
        if self._layout is not None:
            self._layout.cancel()

    def at(self, done: int, total: int, what: str) -> None:
        """Raises Stopped once the user wants no more."""
        self.done, self.total, self.what = done, total, what
        if self.stopped:
            raise Stopped


def lowest_first(bodies: Sequence[Body]) -> list:
    return sorted(bodies, key=lambda body: (float(body.bounds()[0, 2]), body.name))


def put_operation(body: Body) -> Mapping[str, Any]:
    """Let go where it is, as it is."""
    return {"op": "put", "object": body.name, "position": body.origin.tolist()}


class Put:
    """Takes bodies out of the scene and lets each go where it was, the lowest first.

    Refused ones stay where they were, and are in the way: if others came to lie there meanwhile, all begins again with
    them standing from the start.

    movers : names of bodies
    operation : puts a body in a layout
    crossings : () -> pairs that interpenetrate where they are; saves beginning again for each of them
    """

    def __init__(self, make: MakeLayout, bodies: Sequence[Body], movers: Sequence[str],
                 operation: Callable[[Layout, Body], Outcome] = lambda layout, body: layout.perform(put_operation(body)),
                 crossings: Callable[[], Sequence] = lambda: ()) -> None:
        self._make, self._bodies, self._movers, self._operation = make, list(bodies), set(movers), operation
        self._crossings = crossings
        self.progress = Progress()

    def run(self) -> Report:
        """Raises Stopped."""
        self.progress.at(0, len(self._movers), "reading")
        staying = stuck_from_the_start(self._crossings(), self._movers)
        while True:
            bodies = [_held(body) if body.name in staying else body for body in self._bodies]
            out = [name for name in self._movers if name not in staying]
            layout = self._make(bodies, out)
            self.progress.watch(layout)
            try:
                again = self._round(layout, [body for body in bodies if body.name in out], staying)
                if not again:
                    return self._report(layout, staying)
            finally:
                layout.close()

    def _round(self, layout: Layout, movers: Sequence[Body], staying: dict) -> bool:
        """Performs the operation for each mover. Returns true if all must begin again."""
        for number, body in enumerate(lowest_first(movers)):
            self.progress.at(number, len(movers), body.name)
            outcome = self._operation(layout, body)
            self.progress.at(number, len(movers), body.name)  # cancelled is not refused
            if outcome:
                continue
            staying[body.name] = outcome
            stands = layout.perform({"op": "stand", "object": body.name, "position": body.origin.tolist()})
            if not stands or not layout.perform({"op": "fix", "object": body.name}):
                return True
        return False

    def _report(self, layout: Layout, staying: dict) -> Report:
        self.progress.at(len(self._movers), len(self._movers), "the scene as a whole")
        report = Report(refused=staying, verdict=layout.verdict())
        report.motions = motions_in(layout, self._bodies, self._movers - set(staying))
        report.done = [body.name for body in lowest_first(self._bodies) if body.name in self._movers - set(staying)]
        report.gave_way = [name for name in report.motions if name not in self._movers]
        report.statuses = {name: layout.status(name) for name in report.motions}
        return report


def stuck_from_the_start(pairs: Sequence, movers: Sequence[str]) -> dict:
    """{name: Outcome} of movers that pass through what stays, or through movers that for that reason stay, too."""
    out: dict = {}
    links: dict = {}
    for a, b in pairs:
        links.setdefault(a, []).append(b)
        links.setdefault(b, []).append(a)
    waiting = sorted(name for name in links if name not in movers)
    while waiting:
        stays = waiting.pop(0)
        for name in sorted(links[stays]):
            if name in movers and name not in out:
                out[name] = Outcome(False, "crossing", f'at its start position "{name}" passes through "{stays}"', (name, stays))
                waiting.append(name)
    return out


class Mend:
    """Brings bodies that interpenetrate or hang to rest near where they are; all others stay, to the bit."""

    def __init__(self, make: MakeLayout, bodies: Sequence[Body], movers: Sequence[str]) -> None:
        self._make, self._bodies, self._movers = make, list(bodies), list(movers)
        self.progress = Progress()

    def run(self) -> Report:
        """Raises Stopped."""
        self.progress.at(0, 1, "looking for places")
        layout = self._make(self._bodies, [])
        self.progress.watch(layout)
        try:
            unable = layout.mend()
            self.progress.at(1, 1, "the scene as a whole")  # cancelled is not unable
            return self._report(layout, unable)
        finally:
            layout.close()

    def _report(self, layout: Layout, unable: Mapping[str, str]) -> Report:
        motions = motions_in(layout, self._bodies)
        report = Report(motions=motions, verdict=layout.verdict())
        report.done = [name for name in self._movers if name in motions]
        report.gave_way = [name for name in motions if name not in self._movers]
        report.refused = {name: Outcome(False, "no_place", f'"{name}": {why}', (name,)) for name, why in unable.items()}
        report.statuses = {name: layout.status(name) for name in motions}
        return report


class Check:
    """Judges bodies where they are.

    judge : () -> (Verdict, {name: Status})
    """

    def __init__(self, judge: Callable[[], tuple]) -> None:
        self._judge = judge
        self.progress = Progress()

    def run(self) -> Report:
        self.progress.at(0, 1, "judging")
        verdict, statuses = self._judge()
        self.progress.at(1, 1, "judging")
        return Report(verdict=verdict, statuses=statuses)


def motions_in(layout: Layout, bodies: Sequence[Body], always: Sequence[str] = ()) -> dict:
    """{name: (4, 4)} of bodies that are elsewhere than where they were read, and of `always`."""
    out = {}
    for body in bodies:
        pose = layout.pose(body.name)
        if pose is None or body.fixed:
            continue
        motion = motion_of(body, pose)
        if body.name in always or not np.array_equal(motion, np.eye(4)):
            out[body.name] = motion
    return out


def _held(body: Body) -> Body:
    return Body(body.name, body.parts, body.matrix, True, body.friction, body.density)
