"""Pointing: operators that follow the mouse with a ghost, and are done by a click."""

from __future__ import annotations

from dataclasses import replace

import bpy
from bpy_extras import view3d_utils
from mathutils import Vector

from . import backends, memory
from .ghost import REFUSED, WELL, Ghost
from .layouts import LayoutError
from .reading import TooLarge
from .running import Working
from .work import motions_in

_PREVIEW_SECONDS = 0.5


class Pointing(Working):
    """Mixin: `follow(context, event)` sets the operator's properties by the mouse, `preview(layout)` performs them.

    `hint` is what the status line says of keys and mouse.
    """

    hint = ""

    def bodies(self, stage) -> list:
        """Bodies of the preview."""
        return stage.bodies

    def out(self, stage) -> list:
        """Names of bodies that are out of the scene while the mouse moves."""
        return []

    def key(self, context, event) -> bool:
        """True if a key or the wheel changed the operator's properties."""
        return False

    def invoke(self, context, event):
        if bpy.app.background or context.area is None or context.area.type != "VIEW_3D":
            return self.execute(context)
        self._view = View(context.area)
        try:
            self._stage = self.stage(context)
            if not self._stage.movers:
                return self.execute(context)
            settings = replace(self._stage.settings, seconds=_PREVIEW_SECONDS)
            self._layout = self._stage.choices.backend.layout(self.bodies(self._stage), self.out(self._stage), settings)
        except (backends.NoBackend, LayoutError, TooLarge) as error:
            return self._failed(error)
        self._mouse = self._view.mouse(event)
        self._ghost, self._stale, self._text = Ghost(self.bodies(self._stage)), True, ""
        self.begin(context, event)
        self._points = True
        manager = context.window_manager
        self._timer = manager.event_timer_add(0.03, window=context.window)
        manager.modal_handler_add(self)
        memory.running = self.bl_idname
        return {"RUNNING_MODAL"}

    def begin(self, context, event) -> None:
        """Before the first `follow`."""

    def left(self, context) -> None:
        """After the user has left without a click."""

    def modal(self, context, event):
        if not self._points:
            return super().modal(context, event)
        if event.type == "MOUSEMOVE":
            self._mouse = self._view.mouse(event)
            self.follow(context, event)
            self._stale = True
        elif event.type in {"LEFTMOUSE", "RET", "NUMPAD_ENTER"} and event.value == "PRESS":
            return self._confirm(context)
        elif event.type in {"RIGHTMOUSE", "ESC"} and event.value == "PRESS":
            self._leave(context)
            self.left(context)
            return {"CANCELLED"}
        elif self.key(context, event):
            self.follow(context, event)
            self._stale = True
        elif event.type == "TIMER" and self._stale:
            self._stale = False
            self._show(context)
        elif event.type in {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "INBETWEEN_MOUSEMOVE"}:
            return {"PASS_THROUGH"}
        return {"RUNNING_MODAL"}

    def cancel(self, context) -> None:
        if self._points:
            self._leave(context)
        else:
            super().cancel(context)

    def _show(self, context) -> None:
        try:
            outcome = self.preview(self._layout)
        except LayoutError as error:
            self._ghost.show({}, REFUSED)
            self._text = str(error)
        else:
            if outcome:
                self._ghost.show(motions_in(self._layout, self._stage.bodies), WELL)
                self._layout.undo()
                self._text = self.told(outcome)
            else:
                self._ghost.show(self.held(), REFUSED)
                self._text = outcome.reason
        self._tell(context)

    def _tell(self, context) -> None:
        memory.ghost = (self._ghost.names, self._text)
        context.workspace.status_text_set(f"{self.bl_label}: {self._text}   {self.hint}")
        for area in context.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()

    def told(self, outcome) -> str:
        """Text of the status line about the end of the preview."""
        return "comes to rest" + (f"; {', '.join(outcome.gave_way)} gives way" if outcome.gave_way else "")

    def held(self) -> dict:
        """{name: motion} where the ghost is shown when it is refused."""
        return {}

    def _confirm(self, context):
        self._leave(context)
        return self._go(context)

    def _leave(self, context) -> None:
        self._points = False
        self._ghost.end()
        self._layout.close()
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)
        memory.running, memory.ghost = "", ((), "")
        if context.area is not None:
            context.area.tag_redraw()


class View:
    """The region of a 3D view that shows the scene; the operator may have been started from the sidebar's."""

    def __init__(self, area) -> None:
        self.area = area
        self.region = next(region for region in area.regions if region.type == "WINDOW")
        self.data = area.spaces.active.region_3d

    def mouse(self, event) -> tuple:
        """(x, y) pixels in the region."""
        return event.mouse_x - self.region.x, event.mouse_y - self.region.y

    def ray(self, mouse):
        """(origin, direction) under the mouse, world."""
        return (view3d_utils.region_2d_to_origin_3d(self.region, self.data, mouse),
                view3d_utils.region_2d_to_vector_3d(self.region, self.data, mouse))

    def seen_at(self, location: Vector):
        """Where a point of the world is, pixels; None behind the eye."""
        return view3d_utils.location_3d_to_region_2d(self.region, self.data, location)

    def beside(self, mouse, location: Vector) -> Vector:
        """The point under the mouse that is as deep as `location`."""
        return view3d_utils.region_2d_to_location_3d(self.region, self.data, mouse, location)

    def on_plane(self, mouse, point: Vector, normal: Vector):
        """Where the ray under the mouse meets a plane; None if it does not."""
        origin, direction = self.ray(mouse)
        slope = direction.dot(normal)
        if abs(slope) < 1e-6:
            return None
        distance = (point - origin).dot(normal) / slope
        return origin + distance * direction if distance > 0 else None


def surface_below(context, view: View, mouse, excluded, floor: bool):
    """The point seen under the mouse, but for excluded objects; else the floor; None where there is neither."""
    origin, direction = view.ray(mouse)
    depsgraph = context.evaluated_depsgraph_get()
    start = origin
    for _ in range(100):
        hit, location, _, _, owner, _ = context.scene.ray_cast(depsgraph, start, direction)
        if not hit:
            break
        if owner.original not in excluded:
            return location
        start = location + 1e-4 * max(1.0, location.length) * direction
    return view.on_plane(mouse, Vector((0, 0, 0)), Vector((0, 0, 1))) if floor else None
