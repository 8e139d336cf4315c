"""Preferences of the add-on: what it works with, and what is in the way."""

from __future__ import annotations

import bpy

from . import backends
from .layouts import Settings
from .stage import Choices

PACKAGE = __package__


class TrivetPreferences(bpy.types.AddonPreferences):
    """Shown in Edit, Preferences, Add-ons."""

    bl_idname = PACKAGE

    backend: bpy.props.EnumProperty(name="Works by", default="AUTO", items=[
        ("AUTO", "Automatic", "The Python module where it loads, else the program"),
        ("MODULE", "Module", "The Python module `trivet`, in Blender's own process"),
        ("PROGRAM", "Program", "The program `trivet session`, a process of its own, over a pipe")])
    folder: bpy.props.StringProperty(name="Module's folder", subtype="DIR_PATH",
                                     description="Where the package `trivet` is; empty: where Python looks")
    program: bpy.props.StringProperty(name="Program", subtype="FILE_PATH",
                                      description="Path of the program `trivet`; empty: as the shell finds it")
    obstacles: bpy.props.EnumProperty(name="In the way", default="VISIBLE", items=[
        ("VISIBLE", "All that is visible", "All surfaces that the view shows"),
        ("COLLECTION", "A collection", "The objects of the collection that the scene names"),
        ("SELECTED", "Selected objects only", "The selected objects and the floor")])
    detector: bpy.props.EnumProperty(name="Detector", default="auto", items=[
        ("auto", "Automatic", "The fastest here for each query"),
        ("bvh", "BVHs", "Trees of boxes"),
        ("software", "z-lists in software", "On the processor"),
        ("gpu", "z-lists on the GPU", "By the faster of the two ways"),
        ("framebuffer", "Framebuffers", "z-lists on the GPU, rasterised"),
        ("compute", "Compute shaders", "z-lists on the GPU, computed")],
        description="Detector of candidates for contact; results do not depend on it")
    device: bpy.props.IntProperty(name="Device", default=0, min=0, description="EGL device of a GPU, from 1; 0: automatic")
    clearance: bpy.props.FloatProperty(name="Clearance", default=0.0, min=0.0, unit="LENGTH", precision=6,
                                       description="Distance that objects keep; 0: a millionth of the scene's size")
    seconds: bpy.props.FloatProperty(name="Seconds for each object", default=30.0, min=0.0,
                                     description="Time limit; longer work is refused; 0: none")
    most_millions: bpy.props.FloatProperty(name="Most triangles, millions", default=5.0, min=0.001,
                                           description="Scenes with more are not read")

    def draw(self, context) -> None:
        layout = self.layout
        layout.use_property_split = True
        for name in ("backend", "folder", "program"):
            layout.prop(self, name)
        try:
            backend = find_backend(self)
            layout.label(text=backend.text, icon="CHECKMARK")
            if backend.note:
                layout.label(text=backend.note, icon="INFO")
        except backends.NoBackend as error:
            layout.label(text=str(error), icon="ERROR")
        for name in ("detector", "device", "obstacles", "clearance", "seconds", "most_millions"):
            layout.prop(self, name)
        layout.label(text="Pie menu: Shift Alt D in the 3D view; change it in Keymap, 3D View, Trivet")


def of(context) -> TrivetPreferences:
    return context.preferences.addons[PACKAGE].preferences


def find_backend(chosen: TrivetPreferences) -> backends.Backend:
    return backends.find(chosen.backend, bpy.path.abspath(chosen.folder), bpy.path.abspath(chosen.program))


def choices(context) -> Choices:
    """Raises backends.NoBackend."""
    chosen = of(context)
    settings = Settings(context.scene.trivet.floor, chosen.clearance, chosen.seconds, chosen.detector,
                        chosen.device)
    return Choices(find_backend(chosen), settings, chosen.obstacles, round(chosen.most_millions * 1e6))


def register() -> None:
    bpy.utils.register_class(TrivetPreferences)


def unregister() -> None:
    bpy.utils.unregister_class(TrivetPreferences)
