"""Operator Scatter."""

from __future__ import annotations

import bpy

from .bodies import Body
from .copies import copy_tree, home_of, remove_tree
from .op_put import selected_in_object_mode
from .running import Working
from .scattering import Recipe, Scatter
from .stage import Stage
from .work import Report


TURNS = [("NONE", "None", "As they are"), ("UP", "About the vertical", "Upright"), ("ANY", "Any", "Every way")]


class Copying:
    """Mixin of operators that put linked copies: `scatter` is the work, with its copies."""

    done_word = "copies at rest"
    scatter = None

    def ran(self, stage: Stage, report: Report) -> None:
        collection = home_of(stage.context.active_object, stage.context)
        self._copies = {}
        for body in self.scatter.copies:
            if body.name in report.done:
                copy = copy_tree(stage.reading.owners[self.scatter.source_of[body.name]], collection)
                self._copies[body.name] = copy
                stage.reading.add(body, copy)
        stage.context.view_layer.update()

    def undone(self, stage: Stage) -> None:
        self._remove_copies(stage, list(getattr(self, "_copies", ())))

    def written(self, context, stage: Stage, report: Report) -> None:
        self._remove_copies(stage, [name for name in self._copies if name not in report.done])

    def _remove_copies(self, stage: Stage, names) -> None:
        for name in names:
            stage.reading.remove(name)
            remove_tree(self._copies.pop(name))


class TRIVET_OT_scatter(Copying, Working, bpy.types.Operator):
    """Puts linked copies of the other selected objects, or of a collection's, on the active object"""

    bl_idname = "trivet.scatter"
    bl_label = "Scatter"
    bl_options = {"REGISTER", "UNDO"}

    collection: bpy.props.StringProperty(name="Collection",
                                         description="Collection to copy; empty: that of the panel, or the other selected objects")
    number: bpy.props.IntProperty(name="Number", default=10, min=1, max=10000)
    seed: bpy.props.IntProperty(name="Seed", default=0, min=0, description="The same seed gives the same scene")
    pile: bpy.props.BoolProperty(name="Pile", default=False,
                                 description="Drop them from above, onto each other too; else each in a free place of its own")
    keep: bpy.props.FloatProperty(name="Keep", default=0.0, min=0.0, unit="LENGTH",
                                  description="Distance from everything but what they are put on; not for piles")
    turn: bpy.props.EnumProperty(name="Turn", default="UP", items=TURNS)

    @classmethod
    def poll(cls, context) -> bool:
        if not selected_in_object_mode(cls, context):
            return False
        cls.poll_message_set("Make an object active first: copies are put on it")
        return context.active_object is not None

    def draw(self, context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.prop_search(self, "collection", bpy.data, "collections")
        for name in ("number", "seed", "pile", "keep", "turn"):
            layout.prop(self, name)

    def sources(self, context) -> list:
        named = bpy.data.collections.get(self.collection) or context.scene.trivet.sources
        found = context.selected_objects if named is None else outermost(named)
        return [one for one in found if one != context.active_object]

    def objects(self, context):
        return [*self.sources(context), context.active_object]

    def execute(self, context):
        if self.collection and self.collection not in bpy.data.collections:
            return self._failed(ValueError(f'there is no collection "{self.collection}"'))
        if not self.sources(context):
            return self._failed(ValueError("nothing to copy; accepted: other selected objects, or a collection"))
        return super().execute(context)

    def invoke(self, context, event):
        return super().invoke(context, event) if self.sources(context) else self.execute(context)

    def work(self, stage: Stage) -> Scatter:
        target = stage.reading.name_of(stage.context.active_object)
        sources = [name for name in stage.movers if name != target]
        bodies = [still(body) if body.name == target or body.name in sources else body for body in stage.bodies]
        recipe = Recipe(self.number, self.seed, self.pile, self.keep, self.turn)
        self.scatter = Scatter(stage.make, bodies, sources if target else [], target, recipe)
        return self.scatter


def outermost(collection) -> list:
    """Objects of a collection that do not hang on others in it."""
    below = set(collection.all_objects)
    return [one for one in collection.all_objects if one.parent not in below]


def still(body: Body) -> Body:
    return Body(body.name, body.parts, body.matrix, True, body.friction, body.density)


CLASSES = (TRIVET_OT_scatter,)
