"""Panel in the sidebar, pie menu, and entries of the Object menu."""

from __future__ import annotations

import math
import textwrap

import bpy

from . import backends, memory, preferences
from .reading import metres_of_unit

_KEYS: list = []
ICONS = {"put": "TRIA_DOWN_BAR", "put_here": "PIVOT_CURSOR", "scatter": "STICKY_UVS_DISABLE", "paint": "BRUSH_DATA", "push": "FORWARD",
         "turn": "FILE_REFRESH", "move": "ORIENTATION_GLOBAL", "separate": "MOD_EXPLODE", "mend": "TOOL_SETTINGS",
         "check": "CHECKMARK"}
_CHARACTER = 8.0  # pixels, at a scale of 1
_BARELY = 2e-4  # of its size: margins below it are told


def _lines(context, layout, text: str, icon: str = "NONE") -> None:
    """A sentence in as many lines as the sidebar needs."""
    width = context.region.width / (_CHARACTER * context.preferences.system.ui_scale) - 5
    for number, line in enumerate(textwrap.wrap(text, max(12, int(width)))):
        layout.label(text=line, icon=icon if number == 0 else "BLANK1")


def _how_it_rests(context, owner, status) -> str:
    """In words; a margin is a number only where it is small for the object."""
    text = status.state.replace("_", " ").capitalize()
    if status.state != "stable" or not status.margin < _BARELY * owner.dimensions.length:
        return text
    return f"Barely stable, by {_length(context, status.margin)}"


def _length(context, value: float) -> str:
    """A length of the scene in the units that the user reads."""
    system = context.scene.unit_settings.system
    return bpy.utils.units.to_string(system, "LENGTH", value * metres_of_unit(context), precision=3)


class _Panel:
    bl_category, bl_space_type, bl_region_type = "Trivet", "VIEW_3D", "UI"


class TRIVET_PT_main(_Panel, bpy.types.Panel):
    """Operators."""

    bl_label = "Trivet"

    def draw(self, context) -> None:
        layout = self.layout
        try:
            preferences.find_backend(preferences.of(context))
        except backends.NoBackend as error:
            _lines(context, layout.box(), str(error), "ERROR")
        row = layout.row()
        row.scale_y = 1.8
        row.operator("trivet.put", icon="TRIA_DOWN_BAR")
        layout.prop(context.scene.trivet, "as_one")
        for names in (("put_here",), ("scatter", "paint"), ("push", "turn"), ("move", "separate")):
            row = layout.row(align=True)
            for name in names:
                row.operator(f"trivet.{name}", text=name.replace("_", " ").title(), icon=ICONS[name])
        row = layout.row(align=True)
        row.operator("trivet.check", icon=ICONS["check"])
        row.operator("trivet.mend", icon=ICONS["mend"])
        layout.operator("trivet.export", text="Export", icon="EXPORT")
        layout.separator()
        layout.prop(context.scene.trivet, "floor")
        layout.prop(context.scene.trivet, "sources")
        if preferences.of(context).obstacles == "COLLECTION":
            layout.prop(context.scene.trivet, "obstacles")


class TRIVET_PT_object(_Panel, bpy.types.Panel):
    """The active object."""

    bl_label = "Object"
    bl_parent_id = "TRIVET_PT_main"

    @classmethod
    def poll(cls, context) -> bool:
        return context.active_object is not None

    def draw(self, context) -> None:
        layout, owner = self.layout, context.active_object
        layout.use_property_split = True
        layout.prop(owner.trivet, "role")
        layout.prop(owner.trivet, "friction")
        layout.prop(owner.trivet, "density")
        status = memory.status_of(owner)
        box = layout.box()
        box.label(text=owner.name, icon="OBJECT_DATA")
        if status is None:
            box.label(text="Not judged here: Check", icon="QUESTION")
            return
        rests = status.state in {"stable", "fixed"}
        box.label(text=_how_it_rests(context, owner, status), icon="CHECKMARK" if rests else "ERROR")
        if status.supports:
            _lines(context, box, "On " + ", ".join(status.supports))
        if status.loads:
            _lines(context, box, "Carries " + ", ".join(status.loads))
        if math.isfinite(status.margin) and status.state != "fixed":
            box.label(text=f"Least friction {status.least_friction:.2g}")
        row = box.row(align=True)
        row.operator("trivet.select", text="Supports").what = "SUPPORTS"
        row.operator("trivet.select", text="Loads").what = "LOADS"


class TRIVET_PT_last(_Panel, bpy.types.Panel):
    """Panel of the last operation's result."""

    bl_label = "Last result"
    bl_parent_id = "TRIVET_PT_main"

    @classmethod
    def poll(cls, context) -> bool:
        return bool(memory.last.title or memory.last.failure)

    def draw(self, context) -> None:
        layout, last = self.layout, memory.last
        if last.failure:
            _lines(context, layout, last.failure, "ERROR")
            return
        verdict = last.verdict
        if last.done:
            layout.label(text=f"{last.title}: {len(last.done)} done", icon="CHECKMARK")
        for reason in list(last.refused.values())[:5]:
            _lines(context, layout.box(), reason, "CANCEL")
        if last.in_the_way:
            layout.operator("trivet.select", text="Show what is in the way").what = "IN_THE_WAY"
        for pair in last.crossings[:5]:
            _lines(context, layout.box(), f"{pair[0]} interpenetrates {pair[1]}", "ERROR")
        if last.crossings:
            layout.operator("trivet.select", text="Select what interpenetrates").what = "CROSSING"
        if verdict.not_at_rest:
            _lines(context, layout, "Not at rest: " + ", ".join(verdict.not_at_rest[:8]), "ERROR")
            layout.operator("trivet.select", text="Select what is not at rest").what = "NOT_AT_REST"
        layout.label(text=f"As a whole: {verdict.stability}", icon="CHECKMARK" if verdict.stands else "ERROR")
        if verdict.topples:
            _lines(context, layout, "Gives way: " + ", ".join(verdict.topples[:8]))
            layout.operator("trivet.select", text="Select what gives way").what = "TOPPLES"
        if verdict.not_at_rest or verdict.topples:
            layout.operator("trivet.put_again", icon=ICONS["put"])
        for line in last.notes:
            _lines(context, layout, line, "INFO")


class TRIVET_MT_pie(bpy.types.Menu):
    """By its key, about the mouse."""

    bl_label = "Trivet"

    def draw(self, context) -> None:
        pie = self.layout.menu_pie()
        for name in ("push", "turn", "put", "put_here", "scatter", "move", "separate", "check"):
            pie.operator(f"trivet.{name}", icon=ICONS[name])


class TRIVET_MT_object(bpy.types.Menu):
    """In the Object menu."""

    bl_label = "Trivet"

    def draw(self, context) -> None:
        for name, icon in ICONS.items():
            self.layout.operator(f"trivet.{name}", icon=icon)


def _in_object_menu(self, context) -> None:
    self.layout.separator()
    self.layout.menu("TRIVET_MT_object")


CLASSES = (TRIVET_PT_main, TRIVET_PT_object, TRIVET_PT_last, TRIVET_MT_pie, TRIVET_MT_object)


def register() -> None:
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.VIEW3D_MT_object.append(_in_object_menu)
    config = bpy.context.window_manager.keyconfigs.addon
    if config:  # none in the background
        keymap = config.keymaps.new(name="3D View", space_type="VIEW_3D")
        item = keymap.keymap_items.new("wm.call_menu_pie", "D", "PRESS", alt=True, shift=True)
        item.properties.name = "TRIVET_MT_pie"
        _KEYS.append((keymap, item))


def unregister() -> None:
    for keymap, item in _KEYS:
        keymap.keymap_items.remove(item)
    _KEYS.clear()
    bpy.types.VIEW3D_MT_object.remove(_in_object_menu)
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
