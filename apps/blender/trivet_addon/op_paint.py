"""Operator Paint."""

from __future__ import annotations

import functools
import json

import bpy
import numpy as np

from .layouts import LayoutError
from .op_put import selected_in_object_mode
from .op_scatter import TURNS, Copying, outermost, still
from .ghost import REFUSED, WELL
from .pointing import Pointing, surface_below
from .scattering import MOST_OF_A_STROKE, Paint, Recipe, along
from .stage import Stage
from .work import Report, motions_in

_GAP = 8.0  # clearances above the point to which the mouse points


class TRIVET_OT_paint(Copying, Pointing, bpy.types.Operator):
    """Puts linked copies of the selected objects, or of a collection's, along a stroke of the mouse, onto what is there and onto each other"""

    bl_idname = "trivet.paint"
    bl_label = "Paint"
    bl_options = {"REGISTER", "UNDO"}
    hint = "Drag: paint   Esc: end"
    _by_mouse = None  # window, area
    _paints = False

    path: bpy.props.StringProperty(name="Path", default="[]", options={"HIDDEN", "SKIP_SAVE"})  # JSON: points of the stroke
    spacing: bpy.props.FloatProperty(name="Spacing", default=0.0, min=0.0, unit="LENGTH",
                                     description="Along the stroke; 0: as wide as the widest that is copied")
    seed: bpy.props.IntProperty(name="Seed", default=0, min=0, description="The same seed gives the same scene")
    turn: bpy.props.EnumProperty(name="Turn", default="UP", items=TURNS)

    @classmethod
    def poll(cls, context) -> bool:
        if context.scene.trivet.sources is not None and context.mode == "OBJECT":
            return True
        return selected_in_object_mode(cls, context)

    def draw(self, context) -> None:
        self.layout.use_property_split = True
        for name in ("spacing", "seed", "turn"):
            self.layout.prop(self, name)

    def objects(self, context):
        named = context.scene.trivet.sources
        return context.selected_objects if named is None else outermost(named)

    def bodies(self, stage: Stage) -> list:
        return [*self._still(stage), *self._all(stage).copies]

    def out(self, stage: Stage) -> list:
        return [body.name for body in self._all(stage).copies]

    def work(self, stage: Stage) -> Paint:
        self.scatter = self._paint(stage, along(json.loads(self.path), self._spacing(stage)))
        return self.scatter

    def _still(self, stage: Stage) -> list:
        return [still(body) if body.name in stage.movers else body for body in stage.bodies]

    def _paint(self, stage: Stage, points) -> Paint:
        recipe = Recipe(seed=self.seed, turn=self.turn)
        return Paint(stage.make, self._still(stage), stage.movers, recipe, points, _GAP * stage.clearance)

    def _all(self, stage: Stage) -> Paint:
        """As many as a stroke can have."""
        return self._paint(stage, [(0.0, 0.0, 0.0)] * MOST_OF_A_STROKE)

    def _spacing(self, stage: Stage) -> float:
        widths = [float(np.ptp(stage.reading.body(name).bounds(), axis=0)[:2].max()) for name in stage.movers]
        return self.spacing or max([*widths, stage.clearance])

    # By mouse.

    def begin(self, context, event) -> None:
        self._stroke: list = []
        self._preview, self._num_shown, self._refused = self._all(self._stage), 0, ""
        self._by_mouse = context.window, self._view.area

    def modal(self, context, event):
        if self._points and event.type == "LEFTMOUSE":
            if event.value == "PRESS":
                self._paints = True
                self._mouse = self._view.mouse(event)
                self.follow(context, event)
            elif self._paints and event.value == "RELEASE":
                return self._confirm(context)
            return {"RUNNING_MODAL"}
        return super().modal(context, event)

    def follow(self, context, event) -> None:
        found = surface_below(context, self._view, self._mouse, set(), context.scene.trivet.floor) if self._paints else None
        if found is not None:
            self._stroke.append(list(found))
            self.path = json.dumps(self._stroke)

    def _show(self, context) -> None:
        points = along(self._stroke, self._spacing(self._stage))
        try:
            for number in range(self._num_shown, len(points)):
                outcome = self._preview.put_at(self._layout, self._preview.copies[number], number, points[number])
                self._refused = "" if outcome else outcome.reason
        except LayoutError as error:
            self._refused = str(error)
        self._num_shown = len(points)
        self._ghost.show(motions_in(self._layout, self._preview.copies), REFUSED if self._refused else WELL)
        self._text = self._refused or f"{len(self._ghost.names)} come to rest"
        self._tell(context)

    def result(self, report: Report):
        result = super().result(report)
        if self._by_mouse is not None:
            bpy.app.timers.register(functools.partial(_go_on, *self._by_mouse, self.seed + 1), first_interval=0.0)
        return result


def _go_on(window, area, seed: int) -> None:
    """Another stroke, a step of its own for Undo."""
    region = next(one for one in area.regions if one.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.trivet.paint("INVOKE_DEFAULT", True, seed=seed)


CLASSES = (TRIVET_OT_paint,)
