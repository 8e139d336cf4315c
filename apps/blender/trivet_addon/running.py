"""Running: work of an operator at once, or in a thread while the window shows how far it is and Esc stops it."""

from __future__ import annotations

import threading
from typing import Any, Optional

import bpy

from . import backends, memory, preferences
from .layouts import LayoutError
from .reading import TooLarge
from .stage import Stage, finish
from .work import Report, Stopped

_AT_ONCE = 0.25  # seconds that work may take before the window shows it
_VIEW = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "MOUSEMOVE", "INBETWEEN_MOUSEMOVE", "TIMER_REPORT"}
_MOST_LINES = 5


class _Thread(threading.Thread):
    """Runs work, and keeps what it gives or raises."""

    def __init__(self, work: Any) -> None:
        super().__init__(daemon=True)
        self._work = work
        self.report: Optional[Report] = None
        self.error: Optional[BaseException] = None

    def run(self) -> None:
        try:
            self.report = self._work.run()
        except BaseException as error:  # raised again in the thread of the window
            self.error = error


class Working:
    """Mixin of operators: `stage(context)` reads, `work(stage)` is what is done with it.

    `done_word` is what the last line says of the objects.
    """

    done_word = "at rest"
    moves = True  # Blender's objects

    def objects(self, context):
        return context.selected_objects

    def stage(self, context) -> Stage:
        return Stage(context, self.objects(context), preferences.choices(context), moves=self.moves)

    def execute(self, context):
        try:
            stage = self.stage(context)
            return self._end(context, stage, self.work(stage).run())
        except (backends.NoBackend, LayoutError, TooLarge) as error:
            return self._failed(error)

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        try:
            self._stage = self.stage(context)
            self._work = self.work(self._stage)
        except (backends.NoBackend, LayoutError, TooLarge) as error:
            return self._failed(error)
        self._thread = _Thread(self._work)
        self._thread.start()
        self._thread.join(_AT_ONCE)
        if not self._thread.is_alive():
            return self._collect(context)
        manager = context.window_manager
        manager.progress_begin(0, 1)
        self._timer = manager.event_timer_add(0.05, window=context.window)
        manager.modal_handler_add(self)
        memory.running = self.bl_idname
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type in _VIEW:
            return {"PASS_THROUGH"}
        progress = self._work.progress
        if event.type == "ESC":
            progress.stop()
        if event.type == "TIMER":
            if not self._thread.is_alive():
                self._hide(context)
                return self._collect(context)
            context.window_manager.progress_update(progress.done / max(progress.total, 1))
            context.workspace.status_text_set(
                f"Trivet: {progress.done} of {progress.total}, {progress.what}   "
                + ("stopping" if progress.stopped else "Esc: stop, and leave all as it was"))
        return {"RUNNING_MODAL"}

    def cancel(self, context) -> None:
        """Blender ends: so does the thread."""
        self._work.progress.stop()
        self._thread.join(5.0)

    def _hide(self, context) -> None:
        memory.running = ""
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)

    def _collect(self, context):
        error = self._thread.error
        if isinstance(error, Stopped):
            self.report({"INFO"}, "Stopped; all is as it was")
            return {"CANCELLED"}
        if isinstance(error, (backends.NoBackend, LayoutError)):
            return self._failed(error)
        if error is not None:
            raise error
        return self._end(context, self._stage, self._thread.report)

    def _failed(self, error: Exception):
        memory.remember_failure(str(error))
        self.report({"ERROR"}, str(error))
        return {"CANCELLED"}

    def _end(self, context, stage: Stage, report: Report):
        report = finish(stage, report, lambda: self.again(stage))
        self.written(context, stage, report)
        memory.remember(self.bl_label, stage, report)
        for line in memory.last.lines[:_MOST_LINES]:
            self.report({"WARNING"}, line)
        self.report({"INFO"}, self.summary(stage, report))
        return self.result(report)

    def result(self, report: Report):
        return {"FINISHED"} if report.motions else {"CANCELLED"}

    def again(self, stage: Stage) -> Report:
        """The same work, after something was held or the clearance grew."""
        return self.work(stage).run()

    def written(self, context, stage: Stage, report: Report) -> None:
        """After the result was written."""

    def summary(self, stage: Stage, report: Report) -> str:
        total = len(set(report.done)) + len(memory.last.refused)
        text = f"{len(report.done)} of {total} {self.done_word}"
        if report.gave_way:
            text += f", {len(report.gave_way)} gave way"
        if not report.verdict.stands:
            text += f"; as a whole {report.verdict.stability}: {', '.join(memory.last.verdict.topples)}"
        return text
