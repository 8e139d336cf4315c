"""Odd scenes, inside Blender: what cannot be read, units, renders, rigid bodies, lawns, what is driven or linked, and grey buttons."""
import os
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy

import scenes
import support

ZIP, MODULE, PROGRAM = support.arguments()[:3]
CHOSEN = support.enable(ZIP, MODULE, PROGRAM)
import trivet
from trivet_addon import layouts, memory, overlay, stage, ui

ADD = bpy.ops.mesh
RUN = ("EXEC_DEFAULT", True)


def cube(name, at, size=(1, 1, 1)):
    return scenes.new(ADD.primitive_cube_add, name, at, scale=size, size=1)


def put(*objects):
    support.select(list(objects))
    support.put()
    return memory.last


class Told(unittest.TestCase):
    """The user is told of bodies that were not judged, or that will be rendered otherwise."""

    def setUp(self):
        support.clear()

    def test_obstacles_that_are_not_finite_are_left_out_by_name(self):
        one, bad = cube("one", (0, 0, 3)), cube("bad", (0, 0, 1))
        bad.data.vertices[0].co.x = float("nan")
        left_out = ["Left out, with coordinates that are not finite: bad"]
        self.assertEqual(put(one).notes, left_out)
        bpy.ops.trivet.check(*RUN)
        self.assertEqual((memory.last.title, memory.last.notes), ("Check", left_out))
        bad.data.vertices[0].co.x = -.5
        bad.data.update()
        one.location.z = 3
        self.assertEqual(put(one).notes, [])
        self.assertAlmostEqual(one.matrix_world.translation.z, 2, 4)

    def test_other_levels_in_renders_are_named(self):
        one, two = cube("one", (0, 0, 3)), cube("two", (3, 0, 3))
        two.modifiers.new("smooth", "SUBSURF")  # by default 1 in the view, 2 in renders
        self.assertIn("renders have other levels or modifiers of: two", " ".join(put(one, two).notes))
        two.modifiers["smooth"].render_levels = 1
        self.assertEqual(put(one, two).notes, [])
        two.modifiers["smooth"].show_render = False
        self.assertEqual(len(put(one, two).notes), 1)

    def test_many_names_are_cut(self):
        self.assertEqual(layouts.few(list("abcde")), "a, b, c, d, e")
        self.assertEqual(layouts.few(list("abcdefg")), "a, b, c, d, e and 2 more")

    def test_coordinates_beyond_all_bounds_are_told_without_a_traceback(self):
        one, huge = cube("one", (0, 0, 3)), cube("huge", (0, 0, 3), (1e36, 1e36, 1e36))
        for objects in ([one], [huge]):
            support.select(objects)
            before = support.matrices()
            with self.assertRaises(RuntimeError) as raised:
                support.put()
            self.assertIn('"huge"', str(raised.exception))
            self.assertNotIn("Traceback", str(raised.exception))
            self.assertEqual(support.matrices(), before)


class Units(unittest.TestCase):
    """A cube of 100 mm in a scene whose unit is a millimetre."""

    def setUp(self):
        support.clear()
        bpy.context.scene.unit_settings.scale_length = 0.001
        self.one = cube("one", (0, 0, 300), (100, 100, 100))
        put(self.one)

    def tearDown(self):
        bpy.context.scene.unit_settings.scale_length = 1.0

    def test_export_is_in_metres_and_kilograms(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.xml")
            bpy.ops.trivet.export(filepath=path)
            body = xml.etree.ElementTree.parse(path).find("./worldbody/body")
        self.assertAlmostEqual(float(body.get("pos").split()[2]), 0.05, 6)
        self.assertAlmostEqual(float(body.find("inertial").get("mass")), 1.0, 6)

    def test_panel_has_lengths_as_the_user_reads_them(self):
        margin = memory.status_of(self.one).margin
        self.assertAlmostEqual(margin, 50, 3)
        self.assertIn(ui._length(bpy.context, margin), {"5 cm", "50 mm", "5.000 cm", "0.05 m"})


class RigidBodies(unittest.TestCase):
    def setUp(self):
        support.clear()
        bpy.ops.rigidbody.world_add()
        self.ground, self.one = cube("ground", (0, 0, .7), (4, 4, 1)), cube("one", (0, 0, 3))
        for owner, kind in ((self.ground, "PASSIVE"), (self.one, "ACTIVE")):
            support.select([owner])
            bpy.ops.rigidbody.object_add(type=kind)

    def tearDown(self):
        bpy.context.scene.frame_set(1)
        bpy.ops.rigidbody.world_remove()

    def test_passive_ones_stay_fixed_and_active_ones_start_at_rest(self):
        self.assertEqual(put(self.ground, self.one).done, ["ground", "one"])
        self.assertEqual((self.ground.trivet.role, self.one.trivet.role), ("AUTO", "FREE"))
        before = self.one.matrix_world.translation.copy()
        for frame in range(1, 25):
            bpy.context.scene.frame_set(frame)
        moved = (self.one.matrix_world.translation - before).length
        self.assertLess(moved, 0.002)
        print(f"after a second of Blender's own simulation {moved * 1000:.2f} mm away")

    def test_later_frames_are_refused_by_name(self):
        for frame in range(1, 9):
            bpy.context.scene.frame_set(frame)
        self.assertIn("is moved by its rigid body", put(self.one).refused["one"])


class Lawns(unittest.TestCase):
    """More instances than the preferences accept: those near what falls are read."""

    def setUp(self):
        support.clear()
        CHOSEN.most_millions = 0.02
        ADD.primitive_grid_add(x_subdivisions=60, y_subdivisions=60, size=30)
        self.lawn = bpy.context.object
        self.blade = scenes.new(ADD.primitive_cone_add, "blade", (0, 0, .2), vertices=8, radius1=.05, depth=.4)
        self.blade.parent, self.lawn.instance_type = self.lawn, "VERTS"
        self.all_faces = 14 * len(self.lawn.data.vertices)
        bpy.context.view_layer.update()

    def tearDown(self):
        CHOSEN.most_millions = 5.0

    def test_objects_come_to_rest_on_what_is_near(self):
        self.assertGreater(self.all_faces, 20_000)
        one = cube("one", (.1, .2, 3))
        self.assertEqual(put(one).done, ["one"])
        CHOSEN.most_millions = 5.0
        there = support.shown_bodies(lambda one: self.lawn if one == self.blade else one)
        self.assertEqual(support.pairs_that_cross(trivet, there)[1], [])
        self.assertAlmostEqual(one.matrix_world.translation.z, .9, 3)  # on the tips
        bpy.ops.trivet.check(*RUN)
        self.assertEqual((memory.last.crossings, memory.last.verdict.not_at_rest), ([], ()))

    def test_the_same_pose_as_with_all_of_them(self):
        one = cube("one", (.1, .2, 3))
        before = one.location.copy()
        put(one)
        near = support.matrices()["one"][0]
        one.location, one.trivet.role = before, "AUTO"
        CHOSEN.most_millions = 5.0
        put(one)
        self.assertLess(max(abs(a - b) for x, y in zip(near, support.matrices()["one"][0]) for a, b in zip(x, y)), 1e-4)

    def test_what_would_end_beyond_them_stays(self):
        ramp = cube("ramp", (0, 0, 2), (3, 8, .1))
        ramp.rotation_euler.y = 1.0
        ball = scenes.new(ADD.primitive_ico_sphere_add, "ball", (0, 0, 3.5), subdivisions=4, radius=.2)
        before = ball.matrix_world.copy()
        ball.trivet.friction = ramp.trivet.friction = 0.01
        last = put(ball)
        self.assertEqual(list(last.refused), ["ball"])
        self.assertEqual(ball.matrix_world, before)
        print(last.refused)

    def test_too_much_that_is_no_instance_is_told(self):
        ADD.primitive_grid_add(x_subdivisions=120, y_subdivisions=120, size=3, location=(0, 0, -1))
        with self.assertRaisesRegex(RuntimeError, "million triangles"):
            put(cube("one", (0, 0, 3)))


class Driven(unittest.TestCase):
    """Objects that something else in Blender takes elsewhere."""

    def setUp(self):
        support.clear()
        self.one = cube("one", (0, 0, 3))

    def test_by_strips_of_animation(self):
        self.one.keyframe_insert("location")
        animation = self.one.animation_data
        track = animation.nla_tracks.new()
        track.strips.new("strip", 1, animation.action)
        animation.action = None
        self.assertIn("is animated", put(self.one).refused["one"])
        track.mute = True
        self.assertEqual(put(self.one).done, ["one"])

    def test_by_a_modifier_that_follows_another_object(self):
        bpy.ops.object.armature_add(location=(.2, 0, 0))
        bones = bpy.context.object
        self.one.parent = bones
        self.one.modifiers.new("bones", "ARMATURE").object = bones
        self.one.vertex_groups.new(name="Bone").add(range(8), 1, "REPLACE")
        bones.pose.bones[0].rotation_mode = "XYZ"
        bones.pose.bones[0].rotation_euler[0] = .5
        bpy.context.view_layer.update()
        before = support.matrices()
        self.assertIn("changes its shape as it moves", put(self.one).refused["one"])
        self.assertEqual(support.matrices(), before)
        self.assertEqual(put(bones, self.one).done, [bones.name])


class Buttons(unittest.TestCase):
    def test_say_why_they_are_grey(self):
        support.clear()
        one = cube("one", (0, 0, 3))
        support.select([])
        for name in ("put", "separate", "push", "turn", "move", "scatter", "paint", "put_here", "mend"):
            with self.assertRaisesRegex(RuntimeError, "Select (objects|the active object) first"):
                getattr(bpy.ops.trivet, name)(*RUN)
        support.select([one])
        bpy.ops.object.mode_set(mode="EDIT")
        try:
            for name in ("put", "check", "put_here", "scatter", "paint"):
                with self.assertRaisesRegex(RuntimeError, "Object Mode"):
                    getattr(bpy.ops.trivet, name)(*RUN)
        finally:
            bpy.ops.object.mode_set(mode="OBJECT")


class Again(unittest.TestCase):
    def test_what_hangs_is_put_again_in_one_step(self):
        support.clear()
        cube("table", (0, 0, .5), (2, 2, 1))
        well, hangs = cube("well", (.5, .5, 2), (.2, .2, .2)), cube("hangs", (0, 0, 3), (.3, .3, .3))
        put(well, hangs)
        hangs.location.z += .4
        well_at = well.matrix_world.copy()
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="lifted")
        before = support.matrices()
        bpy.ops.trivet.check(*RUN)
        self.assertEqual(memory.last.verdict.not_at_rest, ("hangs",))
        self.assertEqual(bpy.ops.trivet.put_again(), {"FINISHED"})
        self.assertEqual((memory.last.done, well.matrix_world), (["hangs"], well_at))
        self.assertAlmostEqual(hangs.matrix_world.translation.z, 1.15, 4)
        bpy.ops.ed.undo()
        self.assertEqual(support.matrices(), before)
        self.assertEqual(bpy.ops.trivet.put_again(), {"CANCELLED"})


class Linked(unittest.TestCase):
    def test_faces_that_cross_what_is_linked_are_drawn(self):
        support.clear()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "library.blend")
            bpy.data.libraries.write(path, {cube("vase", (0, 0, .5))})
            support.clear()
            with bpy.data.libraries.load(path, link=True) as (_, here):
                here.objects = ["vase"]
            bpy.context.collection.objects.link(here.objects[0])
            support.select([cube("vase", (.3, .2, .7))])
            bpy.ops.trivet.check(*RUN)
            self.assertEqual(len(memory.last.crossings), 1)
            self.assertTrue(overlay.is_shown())
            support.clear()


result = unittest.main(argv=["test_cases"] + support.arguments()[3:], exit=False, verbosity=2).result
sys.stdout.flush()
sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
