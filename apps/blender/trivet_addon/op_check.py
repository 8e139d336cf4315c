"""Operator Check, and selections by what Trivet last told."""

from __future__ import annotations

import bpy
import numpy as np

from . import memory, overlay
from .op_put import in_object_mode
from .running import Working
from .stage import Stage
from .work import Check, Report


_MOST_PAIRS = 50  # whose faces are drawn


def select(context, names) -> int:
    """Selects these objects alone; the number that there are."""
    wanted = set(names)
    chosen = [one for one in context.view_layer.objects if one.name_full in wanted and one.visible_get()]
    for one in context.view_layer.objects:
        if one.select_get() and one not in chosen:
            one.select_set(False)
    for one in chosen:
        one.select_set(True)
    if chosen:
        context.view_layer.objects.active = chosen[0]
    return len(chosen)


def counted(number: int, one: str, more: str) -> str:
    return f"{number} {one if number == 1 else more}"


class TRIVET_OT_check(Working, bpy.types.Operator):
    """Judges what Blender shows, exactly: what interpenetrates, which of the selected and free objects are at rest, and whether all stand as a whole"""

    bl_idname = "trivet.check"
    bl_label = "Check"
    bl_options = {"REGISTER", "UNDO"}
    moves = False
    judges_all = True

    select: bpy.props.BoolProperty(name="Select", default=True, description="Select what interpenetrates or is not at rest")

    @classmethod
    def poll(cls, context) -> bool:
        return in_object_mode(cls, context)

    def work(self, stage: Stage) -> Check:
        return Check(lambda: stage.choices.backend.judge(stage.bodies, stage.settings))

    def summary(self, stage: Stage, report: Report) -> str:
        verdict = memory.last.verdict
        self._show_faces(stage, report)
        wrong = {*(name for pair in memory.last.crossings for name in pair), *verdict.not_at_rest, *verdict.topples}
        if self.select and wrong:
            select(stage.context, wrong)
        if not wrong:
            what = "None of the others" if stage.reading.left_out else "No object"
            return f"{what} interpenetrates, all are at rest; as a whole {verdict.stability}"
        return (f"{counted(len(memory.last.crossings), 'pair interpenetrates', 'pairs interpenetrate')}, "
                f"{len(verdict.not_at_rest)} not at rest, "
                f"{counted(len(verdict.topples), 'object topples', 'objects topple')}")

    def _show_faces(self, stage: Stage, report: Report) -> None:
        bodies = {body.name: body for body in stage.reading.bodies}
        pairs = report.verdict.crossings[:_MOST_PAIRS]
        faces = [overlay.crossing_faces(bodies[a], bodies[b])[0] for a, b in pairs]
        if faces:
            overlay.show(np.concatenate(faces), {stage.reading.owners[name] for pair in pairs for name in pair})
        else:
            overlay.clear()

    def result(self, report: Report):
        return {"FINISHED"}


class TRIVET_OT_select(bpy.types.Operator):
    """Selects objects that the last operation or check told of"""

    bl_idname = "trivet.select"
    bl_label = "Select"
    bl_options = {"REGISTER", "UNDO"}

    what: bpy.props.EnumProperty(name="What", items=[
        ("IN_THE_WAY", "In the way", "Objects that refused ones would interpenetrate, touch or bring down"),
        ("REFUSED", "Refused", "Objects that could not be put or moved"),
        ("CROSSING", "Interpenetrating", "Objects that interpenetrate"),
        ("NOT_AT_REST", "Not at rest", "Free objects that nothing holds"),
        ("TOPPLES", "Toppling", "Objects that give way as a whole"),
        ("SUPPORTS", "Supports", "Objects that carry the active object"),
        ("LOADS", "Loads", "Objects that lie on the active object")])

    @classmethod
    def poll(cls, context) -> bool:
        return context.mode == "OBJECT"

    def execute(self, context):
        last = memory.last
        status = memory.status_of(context.active_object) if context.active_object else None
        names = {"IN_THE_WAY": last.in_the_way, "REFUSED": list(last.refused),
                 "CROSSING": [name for pair in last.crossings for name in pair],
                 "NOT_AT_REST": last.verdict.not_at_rest, "TOPPLES": last.verdict.topples,
                 "SUPPORTS": status.supports if status else (), "LOADS": status.loads if status else ()}[self.what]
        if self.what in {"SUPPORTS", "LOADS"} and status is None:
            self.report({"WARNING"}, "Not known since the object moved; accepted: after Check")
            return {"CANCELLED"}
        number = select(context, names)
        self.report({"INFO"}, f"{number} selected")
        return {"FINISHED"}


class TRIVET_OT_put_again(bpy.types.Operator):
    """Selects what is not at rest or gives way, and puts it"""

    bl_idname = "trivet.put_again"
    bl_label = "Put Again"
    bl_options = {"INTERNAL"}  # Put has the step of undo

    @classmethod
    def poll(cls, context) -> bool:
        return in_object_mode(cls, context)

    def execute(self, context):
        verdict = memory.last.verdict
        if not select(context, {*verdict.not_at_rest, *verdict.topples}):
            self.report({"WARNING"}, "No object to put; accepted: after Check")
            return {"CANCELLED"}
        bpy.ops.trivet.put("INVOKE_DEFAULT", True)
        return {"FINISHED"}


CLASSES = (TRIVET_OT_check, TRIVET_OT_select, TRIVET_OT_put_again)
