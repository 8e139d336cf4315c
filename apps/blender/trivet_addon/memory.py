"""Memory: what the last operator told, for the panel. Not saved, not undone."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from .layouts import Verdict, few


@dataclass
class Last:
    """Names are those of Blender's objects."""

    title: str = ""
    done: list = field(default_factory=list)
    refused: dict = field(default_factory=dict)  # name -> reason
    in_the_way: list = field(default_factory=list)
    verdict: Verdict = field(default_factory=Verdict)
    failure: str = ""
    notes: list = field(default_factory=list)

    @property
    def lines(self) -> list:
        return list(self.refused.values())

    @property
    def crossings(self) -> list:
        return [*self.verdict.crossings, *self.verdict.contained]


last = Last()
statuses: dict = {}  # name -> (Status, where it was)
running = ""  # the operator that shows its progress or a ghost
_named: set = set()  # pairs of obstacles that interpenetrate, of which the user knows
ghost: tuple = ((), "")  # names that the ghost shows, and what is told of it


def status_of(owner):
    """As it was when it was last judged; None if it is elsewhere by now."""
    status, where = statuses.get(owner.name_full, (None, None))
    return status if where == where_is(owner) else None


def where_is(owner) -> tuple:
    """To compare with later."""
    return tuple(map(tuple, owner.matrix_world))


def _renamed(stage, verdict: Verdict) -> Verdict:
    def names(values):
        return tuple(stage.object_name(name) for name in values)

    return replace(verdict, crossings=tuple(map(names, verdict.crossings)), contained=tuple(map(names, verdict.contained)),
                   not_at_rest=names(verdict.not_at_rest), topples=names(verdict.topples))


def _without_obstacles(stage, report) -> tuple:
    """The verdict without pairs of obstacles, which stand as they are; and a note that names new ones."""
    concerned = {*report.motions, *report.refused, *stage.movers}
    found = report.verdict
    kept = [tuple(pair for pair in pairs if set(pair) & concerned) for pairs in (found.crossings, found.contained)]
    file = stage.context.blend_data.filepath
    new = []
    for pair in (*found.crossings, *found.contained):
        key = (file, *sorted(map(stage.object_name, pair)))
        if not set(pair) & concerned and key not in _named:
            _named.add(key)
            new.append(" and ".join(key[1:]))
    note = [f"Stand as they are, though they pass through each other: {few(new, '; ')}"] if new else []
    return replace(found, crossings=kept[0], contained=kept[1]), note


def remember(title: str, stage, report, judges_all: bool = False) -> None:
    """Keeps the result that an operator told. judges_all : pairs of obstacles, too; else these are named once."""
    global last
    verdict, notes = (report.verdict, []) if judges_all else _without_obstacles(stage, report)
    refused = dict(stage.refused)
    refused.update({stage.object_name(name): outcome for name, outcome in report.refused.items()})
    names = {stage.object_name(name) for outcome in refused.values() for name in outcome.objects}
    last = Last(title, [stage.object_name(name) for name in report.done],
                {name: outcome.reason for name, outcome in refused.items()}, sorted(names - set(refused) - {"floor"}),
                _renamed(stage, verdict), notes=[*stage.notes, *notes])
    for name, status in report.statuses.items():
        if name in stage.reading.owners:
            owner = stage.reading.owners[name]
            told = replace(status, supports=tuple(map(stage.object_name, status.supports)),
                           loads=tuple(map(stage.object_name, status.loads)))
            statuses[owner.name_full] = (told, where_is(owner))


def remember_failure(text: str) -> None:
    global last
    last = Last(failure=text)
