"""Scattering: copies of things put on another, in places that a seed selects. Without bpy."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Sequence

import numpy as np

from .bodies import Body
from .layouts import Layout, Outcome
from .moves import put_at
from .work import MakeLayout, Progress, Report, motions_in

_MOST_TRIES = 12  # places for a copy that is dropped


@dataclass(frozen=True)
class Recipe:
    """A way to scatter objects.

    pile : dropped from above, onto each other too; else each in a free place of its own, `keep` metres from others
    turn : "NONE", "UP" (about the vertical), "ANY"
    """

    number: int = 10
    seed: int = 0
    pile: bool = False
    keep: float = 0.0
    turn: str = "UP"


def random_rotation(random: np.random.Generator, turn: str) -> list:
    """w x y z: none, about the vertical, or uniform among all."""
    if turn == "NONE":
        return [1.0, 0.0, 0.0, 0.0]
    while True:
        q = random.uniform(-1.0, 1.0, 4)
        if turn == "UP":
            q[1] = q[2] = 0.0
        length = float(np.sqrt(q @ q))
        if 0.01 < length <= 1.0:
            return [float(x) / length for x in q]


class Scatter:
    """Puts copies of sources on a target.

    sources : names of bodies, copied in turn as the seed says; target : name of a body; copies are called "NAME #1", ...
    """

    def __init__(self, make: MakeLayout, bodies: Sequence[Body], sources: Sequence[str], target: str, recipe: Recipe) -> None:
        self._make, self._bodies, self._target, self._recipe = make, list(bodies), target, recipe
        by_name = {body.name: body for body in bodies}
        random = np.random.default_rng([recipe.seed, 0])
        chosen = [by_name[sources[int(k)]] for k in random.integers(len(sources), size=recipe.number)] if sources else []
        self.source_of = {f"{body.name} #{k + 1}": body.name for k, body in enumerate(chosen)}
        self.copies = [replace(by_name[source], name=name, fixed=False) for name, source in self.source_of.items()]
        self.progress = Progress()

    def run(self) -> Report:
        """Raises Stopped. Copies for which there is no place are refused, and are not made."""
        names = [body.name for body in self.copies]
        layout = self._make([*self._bodies, *self.copies], names)
        self.progress.watch(layout)
        report = Report(still={body.name for body in self._bodies if body.fixed})
        try:
            for number, body in enumerate(self.copies):
                self.progress.at(number, len(names), body.name)
                outcome = self.put(layout, body, number)
                self.progress.at(number, len(names), body.name)
                if outcome:
                    report.done.append(body.name)
                else:
                    report.refused[body.name] = outcome
            self.progress.at(len(names), len(names), "the scene as a whole")
            report.verdict = layout.verdict()
            report.motions = motions_in(layout, [*self._bodies, *self.copies], report.done)
            report.gave_way = [name for name in report.motions if name not in names]
            report.statuses = {name: layout.status(name) for name in report.motions}
            return report
        finally:
            layout.close()

    def put(self, layout: Layout, body: Body, number: int) -> Outcome:
        return self._drop(layout, body, number) if self._recipe.pile else self._place(layout, body, number)

    def _place(self, layout: Layout, body: Body, number: int) -> Outcome:
        """In a free place of its own."""
        random = np.random.default_rng([self._recipe.seed, 1, number])
        operation = {"op": "put", "object": body.name, "on": self._target, "at": "anywhere",
                     "seed": int(random.integers(2 ** 31)), "rotation": random_rotation(random, self._recipe.turn)}
        if self._recipe.keep > 0:
            operation["keep"] = self._recipe.keep
        return layout.perform(operation)

    def _drop(self, layout: Layout, body: Body, number: int) -> Outcome:
        """From above, again elsewhere if it is refused or falls off."""
        random = np.random.default_rng([self._recipe.seed, 2, number])
        low, high = next(one.bounds() for one in self._bodies if one.name == self._target)
        radius = float(np.linalg.norm(body.arrays()[0], axis=1).max())
        outcome = Outcome(False, "no_free_place", f'"{body.name}" fell off "{self._target}" wherever it was dropped')
        for _ in range(_MOST_TRIES):
            at = random.uniform(low[:2], high[:2])
            operation = {"op": "put", "object": body.name, "rotation": random_rotation(random, self._recipe.turn),
                         "position": [float(at[0]), float(at[1]), self._top(layout, high[2]) + radius]}
            tried = layout.perform(operation)
            if tried and self._is_over(layout.pose(body.name), low, high):
                return tried
            if tried:
                layout.undo()
            else:
                outcome = tried
        return outcome

    def _top(self, layout: Layout, height: float) -> float:
        """Height above all copies that were put."""
        tops = [height]
        for body in self.copies:
            pose = layout.pose(body.name)
            if pose is not None:
                tops.append(float(pose[2, 3] + np.linalg.norm(body.arrays()[0], axis=1).max()))
        return max(tops)

    def _is_over(self, pose: np.ndarray, low: np.ndarray, high: np.ndarray) -> bool:
        at = pose[:3, 3]
        return bool((low[:2] <= at[:2]).all() and (at[:2] <= high[:2]).all() and at[2] > low[2])


MOST_OF_A_STROKE = 100  # copies


def along(path: Sequence, spacing: float) -> list:
    """Points at most MOST_OF_A_STROKE, this far apart along a path: its first one, and so on. A longer path has the same first ones."""
    out, left = [np.array(point, float) for point in path[:1]], spacing
    for a, b in zip(path[:-1], path[1:]):
        a, b = np.array(a, float), np.array(b, float)
        length = float(np.linalg.norm(b - a))
        at = left
        while at <= length and len(out) < MOST_OF_A_STROKE:
            out.append(a + at / length * (b - a))
            at += spacing
        left = at - length
    return out


class Paint(Scatter):
    """Puts copies of sources along a stroke, onto what is there, and onto each other.

    points : (3,) where the foot of each copy is wanted
    gap : metres above a point at which a copy is let go
    """

    def __init__(self, make: MakeLayout, bodies: Sequence[Body], sources: Sequence[str], recipe: Recipe, points: Sequence,
                 gap: float) -> None:
        super().__init__(make, bodies, sources, "", replace(recipe, number=MOST_OF_A_STROKE))
        self._points, self._gap = list(points), gap
        self.copies = self.copies[:len(self._points)]

    def put(self, layout: Layout, body: Body, number: int) -> Outcome:
        return self.put_at(layout, body, number, self._points[number])

    def put_at(self, layout: Layout, body: Body, number: int, point: Sequence[float]) -> Outcome:
        """At a point that is not known before."""
        random = np.random.default_rng([self._recipe.seed, 3, number])
        return put_at(layout, body, point, random_rotation(random, self._recipe.turn), self._gap)
