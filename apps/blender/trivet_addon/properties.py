"""Properties of objects and scenes: what may move, and how it slides."""

from __future__ import annotations

import bpy

ROLES = [
    ("AUTO", "Automatic", "Stays where it is until it is put; then it is free"),
    ("FREE", "Free", "Lies where it lies: it comes along with what carries it, and gives way"),
    ("FIXED", "Fixed", "Never moves, and carries everything"),
    ("IGNORED", "Ignored", "Not there for Trivet, unless it is selected"),
]


class TrivetObject(bpy.types.PropertyGroup):
    """Settings of an object."""

    role: bpy.props.EnumProperty(name="Role", items=ROLES, default="AUTO", description="May Trivet move it?")
    friction: bpy.props.FloatProperty(name="Friction", default=0.5, min=0.001, max=10.0, soft_max=2.0,
                                      description="Coulomb's coefficient; of two surfaces the smaller one holds")
    density: bpy.props.FloatProperty(name="Density", default=1000.0, min=0.001, max=1e5,
                                     description="Kilograms per cubic metre; only ratios matter for rest")


class TrivetScene(bpy.types.PropertyGroup):
    """Settings of a scene."""

    floor: bpy.props.BoolProperty(name="Floor at z = 0", default=True, description="An endless floor at height 0")
    as_one: bpy.props.BoolProperty(name="Selected as one", default=False,
                                   description="Put and Put Here take the selected objects as one thing: they keep their places to each other")
    clearance: bpy.props.FloatProperty(name="Clearance", default=0.0, min=0.0, unit="LENGTH", precision=6,
                                       description="Largest distance at which objects were put; contacts are found by it")
    sources: bpy.props.PointerProperty(name="Scatter", type=bpy.types.Collection,
                                       description="Collection that Scatter copies; none: the other selected objects")
    obstacles: bpy.props.PointerProperty(name="Obstacles", type=bpy.types.Collection,
                                         description="Collection of obstacles, where the preferences say Collection")


def settings_of(owner: bpy.types.Object) -> TrivetObject:
    return owner.trivet


CLASSES = (TrivetObject, TrivetScene)


def register() -> None:
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Object.trivet = bpy.props.PointerProperty(type=TrivetObject)
    bpy.types.Scene.trivet = bpy.props.PointerProperty(type=TrivetScene)


def unregister() -> None:
    del bpy.types.Scene.trivet, bpy.types.Object.trivet
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
