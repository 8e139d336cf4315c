"""Operators that move what lies, with all that lies on it: Push, Turn, Move."""

from __future__ import annotations

import math

import bpy
from mathutils import Vector

from .layouts import Layout, Outcome
from .moves import Move, push_operation, translate_operation, turn_operation
from .op_put import selected_in_object_mode
from .pointing import Pointing
from .stage import Stage
from .work import Report


class Moving(Pointing):
    """Mixin: `operation(stage)` is what is done with the active object and the others that are selected."""

    @classmethod
    def poll(cls, context) -> bool:
        return selected_in_object_mode(cls, context)

    def names(self, stage: Stage) -> list:
        """The active object's body first."""
        active = stage.context.active_object
        return sorted(stage.movers, key=lambda name: (stage.reading.owners[name] != active, name))

    def work(self, stage: Stage) -> Move:
        names = self.names(stage)
        return Move(stage.make, stage.bodies, names, self.operation(names) if names else None)

    def preview(self, layout: Layout) -> Outcome:
        operation = self.operation(self.names(self._stage))
        return Outcome(False, "", "move the mouse") if operation is None else layout.perform(operation)

    def begin(self, context, event) -> None:
        body = self._stage.reading.body(self.names(self._stage)[0])
        self._centre = Vector(body.bounds().mean(axis=0))
        self._first = self.grip()
        self._axis = ""
        self.reset()

    def key(self, context, event) -> bool:
        if event.type not in {"X", "Y", "Z"} or event.value != "PRESS":
            return False
        self._axis = "" if self._axis == event.type else event.type
        return True

    def limited(self, by: Vector) -> Vector:
        """Along the axis that was chosen by key."""
        return Vector(x if self._axis in {"", name} else 0.0 for x, name in zip(by, "XYZ"))

    def told(self, outcome: Outcome) -> str:
        return _told(outcome)

    def summary(self, stage: Stage, report: Report) -> str:
        if not report.done:
            return "Nothing moved"
        return f"{self.bl_label}: {_told(report.outcome, stage.object_name)}"


def _told(outcome: Outcome, named=lambda name: name) -> str:
    parts = [{"blocked": f"blocked by {named(outcome.blocked_by)}", "step": "ends at a step", "edge": "ends at an edge",
              "limit": "ends at its limit"}.get(
        outcome.end, "done")]
    if outcome.carried:
        parts.append(f"{len(outcome.carried)} come along")
    if outcome.gave_way:
        parts.append(f"{', '.join(map(named, outcome.gave_way))} gives way")
    return ", ".join(parts)


class TRIVET_OT_push(Moving, bpy.types.Operator):
    """Pushes the active object along what it lies on, with what lies on it; others that are selected go along"""

    bl_idname = "trivet.push"
    bl_label = "Push"
    bl_options = {"REGISTER", "UNDO"}
    hint = "Click: push   X, Y: along an axis   Esc: leave it"

    by: bpy.props.FloatVectorProperty(name="By", size=2, unit="LENGTH", precision=4, description="Seen from above")

    def operation(self, names):
        return push_operation(names, self.by) if any(self.by) else None

    def reset(self) -> None:
        self.by = (0.0, 0.0)

    def grip(self):
        return self._view.on_plane(self._mouse, self._centre, Vector((0, 0, 1)))

    def follow(self, context, event) -> None:
        there = self.grip()
        if there is not None and self._first is not None:
            self.by = self.limited(there - self._first)[:2]


class TRIVET_OT_turn(Moving, bpy.types.Operator):
    """Turns the active object about the contact on which it lies, with what lies on it"""

    bl_idname = "trivet.turn"
    bl_label = "Turn"
    bl_options = {"REGISTER", "UNDO"}
    hint = "Click: turn   Ctrl: steps of 15 degrees   Esc: leave it"

    angle: bpy.props.FloatProperty(name="Angle", subtype="ANGLE", description="About the normal of the contact")

    def operation(self, names):
        return turn_operation(names, math.degrees(self.angle)) if self.angle else None

    def reset(self) -> None:
        self.angle = 0.0

    def grip(self):
        """Angle of the mouse about the object, as the view shows it."""
        centre = self._view.seen_at(self._centre)
        if centre is None:
            return None
        away = Vector(self._mouse) - centre
        return math.atan2(away.y, away.x)

    def follow(self, context, event) -> None:
        there = self.grip()
        if there is None or self._first is None:
            return
        from_below = self._view.data.view_rotation @ Vector((0, 0, 1))
        angle = (there - self._first) * (1 if from_below.z >= 0 else -1)
        angle = math.remainder(angle, 2 * math.pi)
        step = math.radians(15)
        self.angle = round(angle / step) * step if event.ctrl else angle


class TRIVET_OT_move(Moving, bpy.types.Operator):
    """Moves the selected objects straight, with all that lies on them, up to a collision; then lets go"""

    bl_idname = "trivet.move"
    bl_label = "Move with Loads"
    bl_options = {"REGISTER", "UNDO"}
    hint = "Click: move   X, Y, Z: along an axis   Esc: leave it"

    by: bpy.props.FloatVectorProperty(name="By", size=3, subtype="TRANSLATION", precision=4)
    let_go: bpy.props.BoolProperty(name="Let go", default=True, description="At the end it falls and settles; else it is held there")

    def operation(self, names):
        return translate_operation(names, self.by, self.let_go) if any(self.by) else None

    def reset(self) -> None:
        self.by = (0.0, 0.0, 0.0)

    def grip(self):
        return self._view.beside(self._mouse, self._centre)

    def follow(self, context, event) -> None:
        self.by = self.limited(self.grip() - self._first)


CLASSES = (TRIVET_OT_push, TRIVET_OT_turn, TRIVET_OT_move)
