"""Operators that put: Put, Put here, Separate."""

from __future__ import annotations

import math

import bpy
import numpy as np

from .bodies import translation
from .layouts import Layout, Outcome
from .moves import Separate, put_at
from .pointing import Pointing, surface_below
from .running import Working
from .stage import Stage
from .work import Put, Report

OBJECT_MODE = "Works in Object Mode"
_GAP = 8.0  # clearances above the point to which the mouse points


def selected_in_object_mode(operator, context) -> bool:
    """Whether it can run; tells why not by the operator's button."""
    if in_object_mode(operator, context) and context.selected_objects:
        return True
    operator.poll_message_set("Select objects first" if context.mode == "OBJECT" else OBJECT_MODE)
    return False


def in_object_mode(operator, context) -> bool:
    operator.poll_message_set(OBJECT_MODE)
    return context.mode == "OBJECT"


class TRIVET_OT_put(Working, bpy.types.Operator):
    """Lets the selected objects fall from where they are, the lowest first; they come to rest, and nothing interpenetrates"""

    bl_idname = "trivet.put"
    bl_label = "Put"
    bl_options = {"REGISTER", "UNDO"}
    falls = True

    @classmethod
    def poll(cls, context) -> bool:
        return selected_in_object_mode(cls, context)

    def work(self, stage: Stage) -> Put:
        return Put(stage.make, stage.bodies, stage.movers,
                   crossings=lambda: stage.choices.backend.crossings(stage.bodies, stage.movers))


class TRIVET_OT_put_here(Pointing, bpy.types.Operator):
    """Puts the active object where the mouse points; a ghost shows where it would come to rest"""

    bl_idname = "trivet.put_here"
    bl_label = "Put Here"
    bl_options = {"REGISTER", "UNDO"}
    hint = "Click: put   Wheel: turn by 15 degrees (Shift: 1)   Esc: leave it"

    point: bpy.props.FloatVectorProperty(name="Point", size=3, subtype="TRANSLATION", precision=4)
    turn: bpy.props.FloatProperty(name="Turn", subtype="ANGLE", description="About the vertical")

    @classmethod
    def poll(cls, context) -> bool:
        if selected_in_object_mode(cls, context) and context.active_object is not None and context.active_object.select_get():
            return True
        if context.mode == "OBJECT":
            cls.poll_message_set("Select the active object first")
        return False

    def objects(self, context):
        return [context.active_object]

    def out(self, stage: Stage) -> list:
        return stage.movers

    def work(self, stage: Stage) -> Put:
        return Put(stage.make, stage.bodies, stage.movers, lambda layout, body: self._put(stage, layout, body))

    def _put(self, stage: Stage, layout: Layout, body) -> Outcome:
        return put_at(layout, body, tuple(self.point), self.turn, _GAP * stage.clearance)

    def begin(self, context, event) -> None:
        owner = self._stage.reading.owners[self._stage.movers[0]]
        self._excluded = {owner, *owner.children_recursive}
        if owner.instance_collection is not None:
            self._excluded.update(owner.instance_collection.all_objects)
        self.turn = 0.0
        self.follow(context, event)

    def follow(self, context, event) -> None:
        found = surface_below(context, self._view, self._mouse, self._excluded, context.scene.trivet.floor)
        if found is not None:
            self.point = found

    def key(self, context, event) -> bool:
        ways = {"WHEELUPMOUSE": 1, "WHEELDOWNMOUSE": -1}
        if event.type not in ways or event.ctrl:
            return False
        self.turn += math.radians(ways[event.type] * (1 if event.shift else 15))
        return True

    def preview(self, layout: Layout) -> Outcome:
        return self._put(self._stage, layout, self._stage.reading.body(self._stage.movers[0]))

    def held(self) -> dict:
        name = self._stage.movers[0]
        low, high = self._stage.reading.body(name).bounds()
        middle = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
        turn = np.eye(4)
        turn[:2, :2] = [[math.cos(self.turn), -math.sin(self.turn)], [math.sin(self.turn), math.cos(self.turn)]]
        return {name: translation(tuple(self.point)) @ turn @ translation(-middle)}


class TRIVET_OT_separate(Working, bpy.types.Operator):
    """Of the selected objects, takes up those that interpenetrate, and puts each as near to where it was as it is free"""

    bl_idname = "trivet.separate"
    bl_label = "Separate"
    bl_options = {"REGISTER", "UNDO"}
    falls = True

    @classmethod
    def poll(cls, context) -> bool:
        return selected_in_object_mode(cls, context)

    def work(self, stage: Stage) -> Separate:
        return Separate(stage.make, lambda: stage.choices.backend.crossings(stage.bodies, stage.movers), stage.bodies,
                        stage.movers)

    def summary(self, stage: Stage, report: Report) -> str:
        if not report.done and not report.refused:
            return "Nothing that can be moved interpenetrates"
        return super().summary(stage, report)


CLASSES = (TRIVET_OT_put, TRIVET_OT_put_here, TRIVET_OT_separate)
