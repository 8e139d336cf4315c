"""Trivet in Blender: puts objects down so that they never interpenetrate and always lie at rest."""

bl_info = {
    "name": "Trivet",
    "author": "The Trivet authors",
    "version": (0, 0, 0),  # by make_zip.py
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Trivet",
    "description": "Lays objects out so that they never interpenetrate and always lie at rest",
    "category": "Object",
}


def _parts():
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        raise ImportError("Trivet needs NumPy in Blender's Python. Builds of blender.org have it; for Debian's: "
                          "apt install python3-numpy") from error
    from . import op_check, op_export, op_moves, op_paint, op_put, op_scatter, overlay, preferences, properties, ui

    operators = (op_put, op_moves, op_scatter, op_paint, op_check, op_export)
    return (properties, preferences), [one for module in operators for one in module.CLASSES], (ui, op_export, overlay)


def register() -> None:
    import bpy

    before, classes, after = _parts()
    for module in before:
        module.register()
    for one in classes:
        bpy.utils.register_class(one)
    for module in after:
        module.register()


def unregister() -> None:
    import bpy

    before, classes, after = _parts()
    for module in reversed(after):
        module.unregister()
    for one in reversed(classes):
        bpy.utils.unregister_class(one)
    for module in reversed(before):
        module.unregister()
