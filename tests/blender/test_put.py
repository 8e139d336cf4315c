"""Put, inside Blender: blender -b --factory-startup --python-exit-code 9 -P test_put.py -- ZIP MODULE_FOLDER"""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
from mathutils import Vector

import scenes
import support

support.enable(*support.arguments()[:2])
import trivet
from trivet_addon import memory

CHILDREN = {"mug handle": "mug"}


def owner(one):
    return bpy.data.objects.get(CHILDREN.get(one.name, one.name), one)


def expect_exact_undo(case, before):
    """Undo and redo of the last operator, from what it left: every matrix, to the bit."""
    after = support.matrices()
    case.assertNotEqual(before, after)
    bpy.ops.ed.undo()
    case.assertEqual(support.matrices(), before)
    bpy.ops.ed.redo()
    case.assertEqual(support.matrices(), after)
    bpy.ops.ed.undo()
    case.assertEqual(support.matrices(), before)


class AwkwardTen(unittest.TestCase):
    def test_are_put_or_refused_with_a_reason_and_nothing_crosses(self):
        ten = scenes.awkward_ten()
        before = {one.name: one.matrix_world.copy() for one in ten}
        self.assertEqual(support.put(), {"FINISHED"})
        self.assertEqual(len(memory.last.done) + len(memory.last.refused), 10)
        self.assertEqual(list(memory.last.refused), ["cube (sheared parent)"])
        self.assertIn("scaled unequally", memory.last.refused["cube (sheared parent)"])
        for one in ten:
            self.assertEqual(one.matrix_world == before[one.name], one.name in memory.last.refused, one.name)
        bodies = support.shown_bodies(owner)
        pairs, crossing = support.pairs_that_cross(trivet, bodies)
        self.assertEqual(pairs, 78)
        self.assertEqual(crossing, [])
        stay = {"table", "foot", "bowl", "cube (sheared parent)"}
        verdict = support.scene_of(trivet, bodies, stay, True).check()
        self.assertEqual((verdict.crossings, verdict.not_at_rest), ((), ()))
        self.assertTrue(verdict.stable, verdict.topples)
        self.assertTrue(all(one.trivet.role == "FREE" for one in ten if one.name in memory.last.done))

    def test_undo_and_redo_are_exact(self):
        scenes.awkward_ten()
        bpy.ops.ed.undo_push(message="built")
        before = support.matrices()
        support.put()
        expect_exact_undo(self, before)


class Checks(unittest.TestCase):
    def test_tell_what_hangs_what_crosses_and_that_all_is_well(self):
        ten = scenes.awkward_ten()
        apple = bpy.data.objects["apple"]
        apple.location = (0.7, 0, 0.72)  # in the table's edge
        bpy.context.view_layer.update()
        before = support.matrices()
        self.assertEqual(bpy.ops.trivet.check("EXEC_DEFAULT", True), {"FINISHED"})
        self.assertEqual(support.matrices(), before)
        self.assertEqual([set(pair) for pair in memory.last.crossings], [{"apple", "table"}])
        self.assertEqual(set(memory.last.verdict.not_at_rest), {one.name for one in ten})
        self.assertEqual({one.name for one in bpy.context.selected_objects}, {one.name for one in ten} | {"table"})
        apple.location = (0.36, 0.16, 1.3)
        support.select(ten)
        support.put()
        done = [one for one in ten if one.name in memory.last.done]
        support.select(done)
        bpy.ops.trivet.check("EXEC_DEFAULT", True)
        self.assertEqual((memory.last.crossings, memory.last.verdict.not_at_rest), ([], ()))
        self.assertTrue(memory.last.verdict.stands)
        self.assertEqual({one.name for one in bpy.context.selected_objects}, {one.name for one in done})
        status = memory.status_of(bpy.data.objects["apple"])
        self.assertEqual(status.state, "stable")
        apple.location.x += 0.01
        bpy.context.view_layer.update()
        self.assertIsNone(memory.status_of(apple))


class Overlay(unittest.TestCase):
    def test_draws_the_faces_that_cross_until_something_moves(self):
        from trivet_addon import overlay, reading

        scenes.awkward_ten()
        monkey, bowl = bpy.data.objects["monkey (subdivided)"], bpy.data.objects["bowl"]
        monkey.location = bowl.location + Vector((0.15, -0.1, 0))
        bpy.context.view_layer.update()
        support.select([monkey])
        bpy.ops.trivet.check("EXEC_DEFAULT", True)
        self.assertTrue(overlay.is_shown())
        bodies = {body.name: body for body in reading.read(bpy.context, [monkey]).bodies}
        corners, pairs = overlay.crossing_faces(bodies[monkey.name], bodies["bowl"])
        shapes = [trivet.Shape(*bodies[name].arrays()) for name in (monkey.name, "bowl")]
        poses = [[[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]] for x, y, z in
                 (bodies[name].origin for name in (monkey.name, "bowl"))]
        exact = trivet.interpenetrations(shapes, poses)[0].crossings
        print(f"{pairs} pairs of faces drawn, {exact} cross")
        self.assertLess(abs(pairs - exact), 0.02 * exact)
        self.assertGreater(len(corners), 20)
        monkey.location.z += 1
        bpy.context.view_layer.update()
        self.assertFalse(overlay.is_shown())


class Heaps(unittest.TestCase):
    def test_of_twenty_scenes_are_put_or_refused_nothing_crosses_and_undo_is_exact(self):
        put = refused = pairs_judged = 0
        for seed in range(20):
            with self.subTest(seed=seed):
                num_objects = len(scenes.heap(seed))
                bpy.ops.ed.undo_push(message="built")
                before = support.matrices()
                support.put()
                self.assertEqual(len(memory.last.done) + len(memory.last.refused), num_objects)
                self.assertTrue(all(memory.last.refused.values()))
                bodies = support.shown_bodies()
                pairs, crossing = support.pairs_that_cross(trivet, bodies)
                self.assertEqual(crossing, [])
                stay = {"Plane", *memory.last.refused}
                verdict = support.scene_of(trivet, bodies, stay, False).check()
                self.assertEqual((verdict.crossings, verdict.contained), ((), ()))
                self.assertEqual(verdict.not_at_rest, ())
                self.assertEqual(verdict.stable, memory.last.verdict.stands)
                put += len(memory.last.done)
                refused += len(memory.last.refused)
                pairs_judged += pairs
                print(seed, len(memory.last.done), verdict.stability, list(memory.last.refused.values()), flush=True)
                expect_exact_undo(self, before)
        print(f"{put} of {put + refused} put, {pairs_judged} pairs judged where Blender shows them")
        self.assertGreater(put, 0.9 * (put + refused))


result = unittest.main(argv=["test_put"] + support.arguments()[3:], exit=False, verbosity=2).result
sys.stdout.flush()
sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
