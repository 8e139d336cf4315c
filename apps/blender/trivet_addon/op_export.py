"""Operator Export."""

from __future__ import annotations

from dataclasses import replace

import bpy
from bpy_extras.io_utils import ExportHelper

from . import backends, preferences
from .bodies import scaled
from .layouts import LayoutError
from .reading import TooLarge, metres_of_unit
from .stage import Stage


class TRIVET_OT_export(bpy.types.Operator, ExportHelper):
    """Writes what is visible for a simulator: MuJoCo, URDF, SDF or USD; free and selected objects can move there"""

    bl_idname = "trivet.export"
    bl_label = "Export for Simulators"
    bl_options = {"REGISTER"}
    filename_ext = ".xml"
    check_extension = None

    filter_glob: bpy.props.StringProperty(default="*.xml;*.mjcf;*.urdf;*.sdf;*.usda", options={"HIDDEN"})
    collision: bpy.props.EnumProperty(name="Collision", default="fitted", items=[
        ("fitted", "Fitted", "Hulls of components, split where they would cover other objects"),
        ("hull", "Hull", "One hull for each object"),
        ("components", "Components", "A hull for each component"),
        ("decomposition", "Decomposition", "Pieces of a convex decomposition"),
        ("mesh", "Mesh", "The mesh itself")])

    def execute(self, context):
        try:
            stage = Stage(context, context.selected_objects, preferences.choices(context), moves=False)
            metres = metres_of_unit(context)
            settings = replace(stage.settings, clearance=metres * stage.clearance)
            layout = stage.choices.backend.layout([scaled(body, metres) for body in stage.bodies], [], settings)
            try:
                told = layout.export(bpy.path.abspath(self.filepath), self.collision)
            finally:
                layout.close()
        except (backends.NoBackend, LayoutError, TooLarge) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for line in stage.notes:
            self.report({"WARNING"}, line)
        self.report({"INFO"}, f"{len(stage.bodies)} {'object' if len(stage.bodies) == 1 else 'objects'}: {told[0]}")
        return {"FINISHED"}


def _in_export_menu(self, context) -> None:
    self.layout.operator(TRIVET_OT_export.bl_idname, text="Trivet, for simulators (.xml, .urdf, .sdf, .usda)")


CLASSES = (TRIVET_OT_export,)


def register() -> None:
    bpy.types.TOPBAR_MT_file_export.append(_in_export_menu)


def unregister() -> None:
    bpy.types.TOPBAR_MT_file_export.remove(_in_export_menu)
