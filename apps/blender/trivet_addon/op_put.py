"""Operators that put: Put, Put here, Separate, Mend."""

from __future__ import annotations

import functools
import json
import math

import bpy
import numpy as np

from .bodies import translation
from .copies import copy_tree, home_of, remove_tree
from .layouts import Layout, Outcome
from .moves import WAYS_TO_LIE, Separate, laid, put_at, rotation_of
from .pointing import Pointing, surface_below
from .running import Working
from .stage import Stage
from .work import Mend, Put, Report

OBJECT_MODE = "Works in Object Mode"
_GAP = 8.0  # clearances above the point to which the mouse points


def selected_in_object_mode(operator, context) -> bool:
    """True if the operator can run; tells why not by its button."""
    if in_object_mode(operator, context) and context.selected_objects:
        return True
    operator.poll_message_set("Select objects first" if context.mode == "OBJECT" else OBJECT_MODE)
    return False


def in_object_mode(operator, context) -> bool:
    operator.poll_message_set(OBJECT_MODE)
    return context.mode == "OBJECT"


class AsOne:
    """Mixin: by mouse the panel says whether the selected objects are one thing."""

    as_one: bpy.props.BoolProperty(name="As One", default=False, options={"SKIP_SAVE"},
                                   description="The selected objects keep their places to each other, as one thing")

    def invoke(self, context, event):
        if not self.properties.is_property_set("as_one"):
            self.as_one = context.scene.trivet.as_one
        return super().invoke(context, event)


class TRIVET_OT_put(AsOne, Working, bpy.types.Operator):
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


class TRIVET_OT_put_here(AsOne, Pointing, bpy.types.Operator):
    """Puts the active object, or the selected ones as one, where the mouse points; a ghost shows where it would come to rest"""

    bl_idname = "trivet.put_here"
    bl_label = "Put Here"
    bl_options = {"REGISTER", "UNDO"}
    _by_mouse = None  # window, area, names of what is put
    point: bpy.props.FloatVectorProperty(name="Point", size=3, subtype="TRANSLATION", precision=4)
    turn: bpy.props.FloatProperty(name="Turn", subtype="ANGLE", description="About the vertical")
    way: bpy.props.IntProperty(name="Way to Lie", min=0, max=len(WAYS_TO_LIE) - 1,
                               description="From which it falls: 0 as it is, 1 to 4 on a side, 5 upside down")
    copies: bpy.props.BoolProperty(name="Copies", default=False, options={"HIDDEN", "SKIP_SAVE"},
                                   description="Goes on with a linked copy of what was put, until Esc")
    waiting: bpy.props.StringProperty(default="[]", options={"HIDDEN", "SKIP_SAVE"})  # JSON: names of what is put after it
    goes_on: bpy.props.BoolProperty(options={"HIDDEN", "SKIP_SAVE"})  # after another one
    is_copy: bpy.props.BoolProperty(options={"HIDDEN", "SKIP_SAVE"})  # made for this; it goes if it is not put

    @property
    def hint(self) -> str:
        then = "copies" if self.copies else "the next selected" if json.loads(self.waiting) else "end"
        return f"Click: put   Wheel: turn by 15 degrees (Shift: 1)   L: next way to lie   C: copies   Esc: leave it   Then: {then}"

    @classmethod
    def poll(cls, context) -> bool:
        if selected_in_object_mode(cls, context) and context.active_object is not None and context.active_object.select_get():
            return True
        if context.mode == "OBJECT":
            cls.poll_message_set("Select the active object first")
        return False

    def objects(self, context):
        return context.selected_objects if self.as_one else [context.active_object]

    def out(self, stage: Stage) -> list:
        return stage.movers

    def work(self, stage: Stage) -> Put:
        return Put(stage.make, stage.bodies, stage.movers, lambda layout, body: self._put(stage, layout, body))

    def _put(self, stage: Stage, layout: Layout, body) -> Outcome:
        return put_at(layout, body, tuple(self.point), laid(self.turn, self.way), _GAP * stage.clearance)

    def begin(self, context, event) -> None:
        owners = list(self._stage.reading.all_of(self._stage.movers[0]))
        self._excluded = {one for owner in owners for one in (owner, *owner.children_recursive)}
        for owner in owners:
            if owner.instance_collection is not None:
                self._excluded.update(owner.instance_collection.all_objects)
        self.turn, self.way = 0.0, 0
        if not self.goes_on and not self.as_one:
            self.waiting = json.dumps([one.name for one in context.selected_objects if one not in owners])
        self._by_mouse = context.window, self._view.area, [owner.name for owner in owners]
        self.follow(context, event)

    def follow(self, context, event) -> None:
        found = surface_below(context, self._view, self._mouse, self._excluded, context.scene.trivet.floor)
        if found is not None:
            self.point = found

    def key(self, context, event) -> bool:
        if event.type == "C" and event.value == "PRESS":
            self.copies = not self.copies
            return True
        if event.type == "L" and event.value == "PRESS":
            self.way = (self.way + 1) % len(WAYS_TO_LIE)
            return True
        ways = {"WHEELUPMOUSE": 1, "WHEELDOWNMOUSE": -1}
        if event.type not in ways or event.ctrl:
            return False
        self.turn += math.radians(ways[event.type] * (1 if event.shift else 15))
        return True

    def left(self, context) -> None:
        if self.is_copy:
            for one in self.objects(context):
                remove_tree(one)

    def result(self, report: Report):
        result = super().result(report)
        if "FINISHED" in result and self._by_mouse is not None:
            then = functools.partial(_go_on, *self._by_mouse, self.waiting, self.copies, self.as_one)
            bpy.app.timers.register(then, first_interval=0.0)
        return result

    def preview(self, layout: Layout) -> Outcome:
        return self._put(self._stage, layout, self._stage.reading.body(self._stage.movers[0]))

    def held(self) -> dict:
        name = self._stage.movers[0]
        body = self._stage.reading.body(name)
        turn = np.eye(4)
        turn[:3, :3] = rotation_of(laid(self.turn, self.way))
        turned = body.world() @ turn[:3, :3].T
        low, high = turned.min(axis=0), turned.max(axis=0)
        foot = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
        return {name: translation(np.array(self.point) - foot) @ turn}


def _go_on(window, area, put: list, waiting: str, copies: bool, as_one: bool) -> None:
    """Puts the next one: a copy, or of those that wait the first that is still there. A step of its own for Undo."""
    names = [one for one in json.loads(waiting) if one in bpy.data.objects]
    done = [bpy.data.objects[name] for name in put if name in bpy.data.objects]
    if not done or not (copies or names):
        return
    region = next(one for one in area.regions if one.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        context = bpy.context
        following = [copy_tree(one, home_of(one, context)) for one in done] if copies else [bpy.data.objects[names[0]]]
        for one in done:
            one.select_set(not copies and one.select_get())
        for one in following:
            one.select_set(True)
        context.view_layer.objects.active = following[0]
        bpy.ops.trivet.put_here("INVOKE_DEFAULT", True, waiting=json.dumps(names if copies else names[1:]), goes_on=True,
                                copies=copies, is_copy=copies, as_one=as_one)


class TRIVET_OT_separate(Working, bpy.types.Operator):
    """Takes up those of the selected objects that interpenetrate, and puts each as near to where it was as it is free"""

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


class TRIVET_OT_mend(Working, bpy.types.Operator):
    """Moves those of the selected and free objects that interpenetrate or hang, as little as possible; what stood on what still does"""

    bl_idname = "trivet.mend"
    bl_label = "Mend"
    bl_options = {"REGISTER", "UNDO"}
    falls = True

    @classmethod
    def poll(cls, context) -> bool:
        return selected_in_object_mode(cls, context)

    def work(self, stage: Stage) -> Mend:
        return Mend(stage.make, stage.bodies, stage.movers)

    def summary(self, stage: Stage, report: Report) -> str:
        if not report.done and not report.refused and not report.gave_way:
            return "No object interpenetrates, and all are at rest"
        return super().summary(stage, report)


CLASSES = (TRIVET_OT_put, TRIVET_OT_put_here, TRIVET_OT_separate, TRIVET_OT_mend)
