"""Running: work of an operator at once, or in a thread while the window shows how far it is and Esc stops it."""

from __future__ import annotations

import threading
import time
from typing import Any, Optional

import bpy

from . import backends, memory, preferences
from .layouts import LayoutError
from .reading import TooLarge
from .stage import MOST_ROUNDS, Stage, finish, is_shown
from .work import Report, Stopped

_AT_ONCE = 0.25  # seconds that work may take before the window shows it
_VIEW = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "MOUSEMOVE", "INBETWEEN_MOUSEMOVE", "TIMER_REPORT"}
_MOST_LINES = 5
_EXPECTED = (backends.NoBackend, LayoutError, TooLarge)


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
    falls = False  # what moves stays near
    as_one = False  # objects keep their places to each other
    judges_all = False  # obstacles, too

    def objects(self, context):
        return context.selected_objects

    def stage(self, context) -> Stage:
        return Stage(context, self.objects(context), preferences.choices(context), moves=self.moves, falls=self.falls,
                     as_one=self.as_one)

    def execute(self, context):
        try:
            stage = self.stage(context)
        except _EXPECTED as error:
            return self._failed(error)
        try:
            report = self.work(stage).run()
            self.ran(stage, report)
            return self._end(context, stage, finish(stage, report, lambda: self._again(stage)))
        except _EXPECTED as error:
            self.undone(stage)
            return self._failed(error)

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        try:
            self._stage = self.stage(context)
        except _EXPECTED as error:
            return self._failed(error)
        result = self._go(context)
        if "RUNNING_MODAL" in result:
            context.window_manager.modal_handler_add(self)
        return result

    def _go(self, context):
        """Works on the stage, in a thread; shows how far it is if that takes longer."""
        self._rounds = 0
        self._launch()
        result = self._wait(context, _AT_ONCE)
        if result is not None:
            return result
        manager = context.window_manager
        manager.progress_begin(0, 1)
        self._timer = manager.event_timer_add(0.05, window=context.window)
        memory.running = self.bl_idname
        return {"RUNNING_MODAL"}

    def _launch(self) -> None:
        self._work = self.work(self._stage)
        self._thread = _Thread(self._work)
        self._thread.start()

    def modal(self, context, event):
        if event.type in _VIEW:
            return {"PASS_THROUGH"}
        progress = self._work.progress
        if event.type == "ESC":
            progress.stop()
        if event.type == "TIMER":
            try:
                result = self._wait(context, 0.0)
            except BaseException:
                self._hide(context)
                raise
            if result is not None:
                self._hide(context)
                return result
            context.window_manager.progress_update(progress.done / max(progress.total, 1))
            context.workspace.status_text_set(
                f"Trivet: {progress.done} of {progress.total}, {progress.what}   "
                + ("stopping" if progress.stopped else "Esc: stop, and leave all as it was"))
        return {"RUNNING_MODAL"}

    def _wait(self, context, seconds: float):
        """The operator's answer, once it is done; None if it is not within these seconds."""
        end = time.monotonic() + seconds
        while True:
            self._thread.join(max(0.0, end - time.monotonic()))
            if self._thread.is_alive():
                return None
            result = self._collect(context)
            if result is not None:
                return result

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
        """The operator's answer; None if the work has begun again, see `finish`."""
        error = self._thread.error
        if isinstance(error, Stopped) or self._work.progress.stopped:
            self.report({"INFO"}, "Stopped; all is as it was")
            return {"CANCELLED"}
        if isinstance(error, _EXPECTED):
            return self._failed(error)
        if error is not None:
            raise error
        try:
            return self._shown(context, self._thread.report)
        except _EXPECTED as failure:
            return self._failed(failure)

    def _shown(self, context, report: Report):
        self.ran(self._stage, report)
        self._rounds += 1
        try:
            if is_shown(self._stage, report):
                return self._end(context, self._stage, report)
        except BaseException:
            self.undone(self._stage)
            raise
        if self._rounds >= MOST_ROUNDS:
            return self._end(context, self._stage, Report(refused=report.refused))
        self.undone(self._stage)
        self._launch()
        return None

    def _failed(self, error: Exception):
        memory.remember_failure(str(error))
        self.report({"ERROR"}, str(error))
        return {"CANCELLED"}

    def _end(self, context, stage: Stage, report: Report):
        self.written(context, stage, report)
        memory.remember(self.bl_label, stage, report, self.judges_all)
        for line in [*memory.last.lines[:_MOST_LINES], *memory.last.notes]:
            self.report({"WARNING"}, line)
        self.report({"INFO"}, self.summary(stage, report))
        return self.result(report)

    def result(self, report: Report):
        return {"FINISHED"} if report.motions else {"CANCELLED"}

    def _again(self, stage: Stage) -> Report:
        """The same work, after something was held or the clearance grew."""
        self.undone(stage)
        report = self.work(stage).run()
        self.ran(stage, report)
        return report

    def ran(self, stage: Stage, report: Report) -> None:
        """After work, before its result is written."""

    def undone(self, stage: Stage) -> None:
        """After a result was taken back."""

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
