"""Operator Put."""

from __future__ import annotations

import bpy

from .running import Working
from .stage import Stage
from .work import Put


class TRIVET_OT_put(Working, bpy.types.Operator):
    """Lets the selected objects fall from where they are, the lowest first; they come to rest, and nothing interpenetrates"""

    bl_idname = "trivet.put"
    bl_label = "Put"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context) -> bool:
        return context.mode == "OBJECT" and bool(context.selected_objects)

    def work(self, stage: Stage) -> Put:
        return Put(stage.make, stage.bodies, stage.movers)


CLASSES = (TRIVET_OT_put,)
