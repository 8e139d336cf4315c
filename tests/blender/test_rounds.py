"""Work that begins again, and work that fails, inside Blender: in threads as in a window, without one."""
import os
import sys
import threading
import unittest
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy

import scenes
import support

ZIP, MODULE, PROGRAM = support.arguments()[:3]
CHOSEN = support.enable(ZIP, MODULE, PROGRAM)
from trivet_addon import memory, op_put, preferences, running, stage
from trivet_addon.layouts import LayoutError

ADD = bpy.ops.mesh
RUN = ("EXEC_DEFAULT", True)


def cube(name, at, size=(1, 1, 1)):
    return scenes.new(ADD.primitive_cube_add, name, at, scale=size, size=1)


class Rounds(unittest.TestCase):
    """Rounds of an operator that a window would run."""

    def operator(self, kind):
        """As an operator of a window, without one."""
        one = type("Fake", (running.Working,), {"work": kind.work, "falls": kind.falls, "bl_label": kind.bl_label,
                                                "objects": running.Working.objects})()
        one.report, one.told = lambda kinds, text: one.said.append(text), None
        one.said = []
        return one

    def run_in_rounds(self, refuse):
        """Puts a cube; Blender's numbers are said to be wrong for the first `refuse` rounds."""
        support.clear()
        support.select([cube("one", (0, 0, 3))])
        one, threads = self.operator(op_put.TRIVET_OT_put), []
        shown, work = stage.misplaced, one.work

        def misplaced(*given):
            wrong, there = shown(*given)
            return ({"one": 1e-5} if len(threads) <= refuse else wrong), there

        def noted(given):
            out = work(given)
            run = out.run
            out.run = lambda: (threads.append(threading.current_thread()), run())[1]
            return out

        one.work = noted
        one._stage = one.stage(bpy.context)
        one._rounds = 0
        with mock.patch.object(stage, "misplaced", misplaced):
            one._launch()
            result = one._wait(bpy.context, 60.0)
        return one, result, threads

    def test_each_is_in_a_thread(self):
        one, result, threads = self.run_in_rounds(2)
        self.assertEqual((result, memory.last.done), ({"FINISHED"}, ["one"]))
        self.assertEqual(len(set(threads)), 3)
        self.assertNotIn(threading.main_thread(), threads)

    def test_end_and_leave_all_as_it_was(self):
        one, result, threads = self.run_in_rounds(1000)
        self.assertEqual(result, {"CANCELLED"})
        self.assertEqual(bpy.data.objects["one"].location.z, 3.0)
        self.assertIn("too coarse", memory.last.refused["one"])
        self.assertLessEqual(len(threads), stage.MOST_ROUNDS)

    def test_esc_between_rounds_stops(self):
        support.clear()
        support.select([cube("one", (0, 0, 3))])
        one = self.operator(op_put.TRIVET_OT_put)
        one._stage, one._rounds = one.stage(bpy.context), 0
        one._launch()
        one._thread.join()
        one._work.progress.stop()
        self.assertEqual(one._wait(bpy.context, 1.0), {"CANCELLED"})
        self.assertEqual(one.said, ["Stopped; all is as it was"])
        self.assertEqual(bpy.data.objects["one"].location.z, 3.0)

    def test_an_error_while_judging_puts_everything_back(self):
        support.clear()
        one = cube("one", (0, 0, 3))
        support.select([one])
        before = support.matrices()
        backend = preferences.find_backend(CHOSEN)
        seen = []

        def crossings(self, bodies, about):
            seen.append(about)
            if len(seen) == 1:
                return []
            raise LayoutError("the judge is out")

        with mock.patch.object(type(backend), "crossings", crossings):
            with self.assertRaisesRegex(RuntimeError, "the judge is out"):
                support.put()
        self.assertEqual(support.matrices(), before)
        table, apple = cube("table", (0, 0, .5), (2, 2, 1)), cube("apple", (5, 0, 1), (.1, .1, .1))
        one.hide_set(True)
        support.select([table, apple])
        number = len(bpy.data.objects)
        with mock.patch.object(type(backend), "crossings", lambda *given: (_ for _ in ()).throw(LayoutError("the judge is out"))):
            with self.assertRaisesRegex(RuntimeError, "the judge is out"):
                bpy.ops.trivet.scatter(*RUN, number=3)
        self.assertEqual(len(bpy.data.objects), number)


result = unittest.main(argv=["test_rounds"] + support.arguments()[3:], exit=False, verbosity=2).result
sys.stdout.flush()
sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
