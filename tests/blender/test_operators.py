"""All other operators, inside Blender, without a window: as their redo panels run them."""
import math
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy

import scenes
import support

ZIP, MODULE, PROGRAM = support.arguments()[:3]
CHOSEN = support.enable(ZIP, MODULE, PROGRAM)
import trivet
from trivet_addon import memory

ADD = bpy.ops.mesh
RUN = ("EXEC_DEFAULT", True)


def cube(name, at, size=(1, 1, 1)):
    return scenes.new(ADD.primitive_cube_add, name, at, scale=size, size=1)


def table_with_plate_and_cup():
    """All put; the table as it stands on the floor."""
    support.clear()
    table = cube("table", (0, 0, .5), (2, 2, 1))
    plate, cup = cube("plate", (0, 0, 1.2), (.5, .5, .05)), cube("cup", (.05, 0, 1.6), (.1, .1, .2))
    support.select([plate, cup])
    support.put()
    return table, plate, cup


def nothing_crosses(test):
    test.assertEqual(support.pairs_that_cross(trivet, support.shown_bodies())[1], [])


class Here(unittest.TestCase):
    def test_puts_the_active_object_onto_the_point(self):
        table, plate, cup = table_with_plate_and_cup()
        support.select([cup])
        self.assertEqual(bpy.ops.trivet.put_here(*RUN, point=(.7, .6, 1.0), turn=math.radians(30)), {"FINISHED"})
        self.assertAlmostEqual(cup.matrix_world.translation.x, .7, 4)
        self.assertAlmostEqual(cup.matrix_world.translation.y, .6, 4)
        self.assertAlmostEqual(cup.matrix_world.translation.z, 1.1, 3)
        self.assertAlmostEqual(cup.rotation_euler.z, math.radians(30), 4)
        nothing_crosses(self)

    def test_lies_on_its_sides_and_upside_down(self):
        for way, height in enumerate((.2, .1, .1, .1, .1, .2)):
            table, plate, cup = table_with_plate_and_cup()
            support.select([cup])
            self.assertEqual(bpy.ops.trivet.put_here(*RUN, point=(.7, .6, 1.0), way=way), {"FINISHED"})
            z = support.shown_bodies()["cup"][0][:, 2]
            self.assertAlmostEqual(float(z.max() - z.min()), height, 3)
            self.assertAlmostEqual(cup.matrix_world.translation.x, .7, 3)
            nothing_crosses(self)

    def test_starts_higher_where_it_would_cross(self):
        table, plate, cup = table_with_plate_and_cup()
        wide = cube("wide", (5, 5, 5), (1.5, 1.5, .1))
        support.select([wide])
        self.assertEqual(bpy.ops.trivet.put_here(*RUN, point=(0, 0, 1.0)), {"FINISHED"})
        self.assertGreater(wide.matrix_world.translation.z, 1.05)
        nothing_crosses(self)

    def test_refuses_what_would_fall_for_ever(self):
        support.clear()
        bpy.context.scene.trivet.floor = False
        lone = cube("lone", (0, 0, 3))
        support.select([lone])
        before = support.matrices()
        self.assertEqual(bpy.ops.trivet.put_here(*RUN, point=(0, 0, 0)), {"CANCELLED"})
        self.assertIn("nothing is below", memory.last.refused["lone"])
        self.assertEqual(support.matrices(), before)
        bpy.context.scene.trivet.floor = True


class AsOne(unittest.TestCase):
    """A lamp whose shade hangs above its foot, and touches nothing."""

    def lamp(self):
        support.clear()
        self.table = cube("table", (0, 0, .5), (2, 2, 1))
        self.foot, self.shade = cube("foot", (0, 0, 2), (.3, .3, .2)), cube("shade", (.05, 0, 2.4), (.4, .4, .2))
        self.pin = cube("pin", (0, 0, 2.05), (.02, .02, .2))  # passes through the foot
        support.select([self.foot, self.shade, self.pin])
        bpy.ops.ed.undo_push(message="built")
        return support.matrices()

    def apart(self):
        there = self.foot.matrix_world.inverted()
        return [(there @ one.matrix_world).translation for one in (self.shade, self.pin)]

    def is_as_one(self, before):
        for now, was in zip(self.apart(), before):
            self.assertLess((now - was).length, 1e-5)
        self.assertEqual([one.trivet.role for one in (self.foot, self.shade, self.pin)], ["AUTO"] * 3)
        bodies = support.shown_bodies(lambda one: self.foot if one in (self.shade, self.pin) else one)
        self.assertEqual(support.pairs_that_cross(trivet, bodies)[1], [])

    def test_they_fall_and_keep_their_places_to_each_other(self):
        before = self.lamp()
        apart = self.apart()
        self.assertEqual(support.put(as_one=True), {"FINISHED"})
        self.is_as_one(apart)
        self.assertAlmostEqual(self.foot.matrix_world.translation.z, 1.1, 3)
        self.assertEqual(memory.last.done, ["foot"])
        bpy.ops.ed.undo()
        self.assertEqual(support.matrices(), before)

    def test_they_are_laid_where_the_mouse_points(self):
        self.lamp()
        apart = self.apart()
        self.assertEqual(bpy.ops.trivet.put_here(*RUN, point=(.4, .3, 1.0), way=5, turn=.5, as_one=True), {"FINISHED"})
        self.is_as_one(apart)
        self.assertLess(self.shade.matrix_world.translation.z, self.foot.matrix_world.translation.z)

    def test_what_holds_one_of_them_holds_all_and_is_named(self):
        before = self.lamp()
        self.shade.lock_location[0] = True
        support.put(as_one=True)
        self.assertIn('"shade" has locked', memory.last.refused["foot"])
        self.assertEqual(support.matrices(), before)

    def test_each_alone_would_not_keep_its_place(self):
        self.lamp()
        apart = self.apart()
        support.put()
        self.assertGreater((self.apart()[0] - apart[0]).length, .05)


class Locked(unittest.TestCase):
    """Euler angles nearly lock where the second one is 90 degrees; Blender's own are off there."""

    def test_what_lies_on_a_slight_slope_is_where_it_should_be(self):
        for order in ("XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX", "QUATERNION"):
            for slope in (1e-5, 2e-4, 3e-3, .03):
                support.clear()
                slab = cube("slab", (0, 0, .1), (2, 2, .1))
                slab.rotation_euler = (.4 * slope, slope, 0)
                book = cube("book", (0, 0, 1), (.3, .2, .1))
                book.rotation_euler = (.2, math.pi / 2, .3)
                book.rotation_mode = order
                support.select([book])
                self.assertEqual(bpy.ops.trivet.put_here(*RUN, point=(.2, .1, .2), turn=.7), {"FINISHED"}, (order, slope))
                self.assertLess(bpy.context.scene.trivet.clearance, 1e-5, (order, slope))


class Obstacles(unittest.TestCase):
    def test_that_cross_each_other_are_no_obstacle_and_named_once(self):
        support.clear()
        cube("wall", (0, 0, .5), (2, .2, 1))
        cube("other wall", (0, 0, .5), (.2, 2, 1))
        book = cube("book", (.5, .5, 1), (.2, .2, .2))
        support.select([book])
        self.assertEqual(support.put(), {"FINISHED"})
        self.assertEqual((memory.last.done, memory.last.crossings), (["book"], []))
        self.assertIn("pass through each other: other wall and wall", " ".join(memory.last.notes))
        book.location.z = 2
        bpy.context.view_layer.update()
        self.assertEqual(support.put(), {"FINISHED"})
        self.assertEqual(memory.last.notes, [])
        self.assertEqual(bpy.ops.trivet.check(*RUN), {"FINISHED"})
        self.assertEqual([set(pair) for pair in memory.last.crossings], [{"wall", "other wall"}])


class Moves(unittest.TestCase):
    def test_push_takes_loads_along_and_is_blocked(self):
        table, plate, cup = table_with_plate_and_cup()
        wall = cube("wall", (.9, 0, 1.52), (.1, 2, 1))
        support.select([plate])
        apart = cup.matrix_world.translation - plate.matrix_world.translation
        bpy.ops.ed.undo_push(message="built")
        before = support.matrices()
        self.assertEqual(bpy.ops.trivet.push(*RUN, by=(.3, 0)), {"FINISHED"})
        self.assertAlmostEqual(plate.matrix_world.translation.x, .3, 4)
        self.assertLess((cup.matrix_world.translation - plate.matrix_world.translation - apart).length, 1e-5)
        self.assertEqual(memory.status_of(plate).loads, ("cup",))
        bpy.ops.trivet.push(*RUN, by=(1, 0))
        self.assertAlmostEqual(plate.matrix_world.translation.x, .6, 3)
        nothing_crosses(self)
        bpy.ops.ed.undo()
        bpy.ops.ed.undo()
        self.assertEqual(support.matrices(), before)

    def test_turn_takes_loads_along(self):
        table, plate, cup = table_with_plate_and_cup()
        support.select([plate])
        self.assertEqual(bpy.ops.trivet.turn(*RUN, angle=math.radians(90)), {"FINISHED"})
        self.assertAlmostEqual(abs(plate.rotation_euler.z), math.radians(90), 4)
        self.assertAlmostEqual(cup.matrix_world.translation.y, .05, 3)
        nothing_crosses(self)

    def test_move_lifts_loads_and_lets_go(self):
        table, plate, cup = table_with_plate_and_cup()
        support.select([plate])
        self.assertEqual(bpy.ops.trivet.move(*RUN, by=(.4, .3, .5)), {"FINISHED"})
        self.assertAlmostEqual(plate.matrix_world.translation.x, .4, 3)
        self.assertAlmostEqual(plate.matrix_world.translation.z, 1.025, 3)
        self.assertAlmostEqual(cup.matrix_world.translation.x, .45, 3)
        nothing_crosses(self)

    def test_what_lies_on_nothing_cannot_be_pushed(self):
        support.clear()
        hanging = cube("hanging", (0, 0, 3))
        support.select([hanging])
        self.assertEqual(bpy.ops.trivet.push(*RUN, by=(.3, 0)), {"CANCELLED"})
        self.assertIn("hanging", memory.last.refused)

    def test_fixed_objects_stay(self):
        table, plate, cup = table_with_plate_and_cup()
        plate.trivet.role = "FIXED"
        support.select([plate])
        self.assertEqual(bpy.ops.trivet.push(*RUN, by=(.3, 0)), {"CANCELLED"})
        self.assertIn("marked as fixed", memory.last.refused["plate"])


class Separates(unittest.TestCase):
    def test_what_interpenetrates_by_the_smallest_way(self):
        support.clear()
        shelf, book = cube("shelf", (0, 0, 1), (2, .5, .1)), cube("book", (.2, 0, 1.14), (.1, .3, .2))
        other, apart = cube("other", (.24, 0, 1.2), (.1, .3, .2)), cube("apart", (-.5, 0, 1.5), (.1, .1, .1))
        above = cube("above", (0, 0, 1.6), (2, .5, .1))
        support.select([book, other, apart])
        self.assertEqual(bpy.ops.trivet.separate(*RUN), {"FINISHED"})
        nothing_crosses(self)
        self.assertEqual(apart.location.z, 1.5)
        for one in (book, other):
            self.assertLess(one.matrix_world.translation.z, above.location.z)
            self.assertLess(abs(one.matrix_world.translation.x - .2), .2)
        self.assertEqual(sorted(memory.last.done), ["book", "other"])
        before = support.matrices()
        support.select([book, other])
        self.assertEqual(bpy.ops.trivet.separate(*RUN), {"CANCELLED"})
        self.assertEqual(support.matrices(), before)

    def test_what_is_inside_comes_out(self):
        support.clear()
        rock, coin = cube("rock", (0, 0, 2), (4, 4, 4)), cube("coin", (0, 0, 2), (.1, .1, .02))
        support.select([coin])
        self.assertEqual(bpy.ops.trivet.separate(*RUN), {"FINISHED"})
        self.assertGreater(coin.matrix_world.translation.z, 4)
        nothing_crosses(self)


class Mends(unittest.TestCase):
    def test_what_interpenetrates_and_hangs_by_little(self):
        table, plate, cup = table_with_plate_and_cup()
        jug = cube("jug", (.5, .5, 1.2), (.1, .1, .2))
        support.select([plate, cup, jug])
        support.put()
        stands = jug.matrix_world.copy()
        plate.location.z += .004  # hangs; the cup is in it
        bpy.context.view_layer.update()
        wanted = {one: one.matrix_world.translation.copy() for one in (plate, cup)}
        support.select([plate, cup, jug])
        self.assertEqual(bpy.ops.trivet.mend(*RUN), {"FINISHED"})
        nothing_crosses(self)
        for one in (plate, cup):
            self.assertLess((one.matrix_world.translation - wanted[one]).length, .006, one.name)
        self.assertAlmostEqual(plate.matrix_world.translation.z, 1.025, 3)
        self.assertEqual(jug.matrix_world, stands)
        self.assertEqual(memory.status_of(cup).supports, ("plate",))
        self.assertTrue(memory.last.verdict.stands, memory.last.verdict)
        before = support.matrices()
        self.assertEqual(bpy.ops.trivet.mend(*RUN), {"CANCELLED"})
        self.assertEqual(support.matrices(), before)

    def test_what_has_no_place_is_named_and_stays(self):
        support.clear()
        cube("rock", (0, 0, 2), (4, 4, 4))
        coin = cube("coin", (0, 0, 2), (.1, .1, .02))
        support.select([coin])
        self.assertEqual(bpy.ops.trivet.mend(*RUN), {"CANCELLED"})
        self.assertIn("coin", memory.last.refused)
        self.assertEqual(tuple(coin.location), (0, 0, 2))


class Scatters(unittest.TestCase):
    def scene(self):
        support.clear()
        table = cube("table", (0, 0, .5), (2, 2, 1))
        apple = scenes.new(ADD.primitive_ico_sphere_add, "apple", (3, 0, .2), radius=.06, subdivisions=2)
        mug = scenes.new(ADD.primitive_cylinder_add, "mug", (3, 1, .2), radius=.05, depth=.12, vertices=12)
        handle = scenes.new(ADD.primitive_cube_add, "handle", (3.07, 1, .2), scale=(.06, .01, .06), size=1)
        bpy.context.view_layer.update()
        handle.parent, handle.matrix_parent_inverse = mug, mug.matrix_world.inverted()
        support.select([table, apple, mug])

    def positions(self, **options):
        self.scene()
        self.assertEqual(bpy.ops.trivet.scatter(*RUN, **options), {"FINISHED"})
        copies = [one for one in bpy.data.objects if one.name[:-4] in {"apple", "mug"}]
        self.assertEqual(len(copies), len(memory.last.done))
        self.assertTrue(memory.last.verdict.stands, memory.last.verdict)
        nothing = support.pairs_that_cross(trivet, support.shown_bodies(
            lambda one: one.parent if one.parent is not None else one))[1]
        self.assertEqual(nothing, [])
        self.assertTrue(all(-1.05 < c.location.x < 1.05 and -1.05 < c.location.y < 1.05 and c.location.z > .99 for c in copies))
        self.assertTrue(all(one.data == bpy.data.objects[one.name[:-4]].data for one in copies))
        return {one.name: tuple(map(tuple, one.matrix_world)) for one in copies}

    def test_each_in_a_place_of_its_own_by_the_seed(self):
        first = self.positions(number=8, seed=3, keep=.03)
        self.assertEqual(len(first), 8)
        self.assertEqual(self.positions(number=8, seed=3, keep=.03), first)
        self.assertNotEqual(self.positions(number=8, seed=4, keep=.03), first)

    def test_in_a_pile_and_back_by_undo(self):
        self.scene()
        bpy.ops.ed.undo_push(message="built")
        before = support.matrices()
        self.assertEqual(bpy.ops.trivet.scatter(*RUN, number=6, seed=1, pile=True, turn="ANY"), {"FINISHED"})
        after = support.matrices()
        self.assertGreater(len(after), len(before))
        bpy.ops.ed.undo()
        self.assertEqual(support.matrices(), before)
        bpy.ops.ed.redo()
        self.assertEqual(support.matrices(), after)

    def test_a_collection_that_the_panel_names(self):
        self.scene()
        table, apple = bpy.data.objects["table"], bpy.data.objects["apple"]
        collection = bpy.data.collections.new("fruit")
        bpy.context.scene.collection.children.link(collection)
        collection.objects.link(apple)
        support.select([table])
        bpy.context.scene.trivet.sources = collection
        self.assertEqual(bpy.ops.trivet.scatter(*RUN, number=3), {"FINISHED"})
        self.assertEqual(len([one for one in bpy.data.objects if one.data == apple.data]), 4)
        bpy.context.scene.trivet.sources = None

    def test_of_nothing_says_so(self):
        self.scene()
        support.select([bpy.data.objects["table"]])
        with self.assertRaisesRegex(RuntimeError, "nothing to copy"):
            bpy.ops.trivet.scatter(*RUN)


class Paints(unittest.TestCase):
    PATH = "[[-0.6, 0, 1], [0.1, 0, 1], [0.6, 0.3, 1]]"

    def scene(self):
        support.clear()
        self.table = cube("table", (0, 0, .5), (2, 2, 1))
        self.pebble = scenes.new(ADD.primitive_ico_sphere_add, "pebble", (3, 0, .2), radius=.06, subdivisions=2)
        self.tile = cube("tile", (3, 1, .2), (.12, .12, .03))
        support.select([self.pebble, self.tile])
        bpy.ops.ed.undo_push(message="built")
        return support.matrices()

    def painted(self, **options):
        self.assertEqual(bpy.ops.trivet.paint(*RUN, path=self.PATH, **options), {"FINISHED"})
        nothing_crosses(self)
        copies = [one for one in bpy.data.objects if one.name[:-4] in {"pebble", "tile"}]
        self.assertEqual(len(copies), len(memory.last.done))
        self.assertTrue(memory.last.verdict.stands, memory.last.verdict)
        self.assertTrue(all(one.data == bpy.data.objects[one.name[:-4]].data for one in copies))
        return {one.name: tuple(map(tuple, one.matrix_world)) for one in copies}

    def test_copies_along_the_stroke_by_the_seed_and_back_by_undo(self):
        before = self.scene()
        first = self.painted(spacing=.2, seed=5, turn="NONE")
        self.assertEqual(len(first), 7)  # 1.28 m
        self.assertTrue(all(rows[2][3] > 1 for rows in first.values()))
        bpy.ops.ed.undo()
        self.assertEqual(support.matrices(), before)
        self.scene()
        self.assertEqual(self.painted(spacing=.2, seed=5, turn="NONE"), first)
        self.scene()
        self.assertNotEqual(self.painted(spacing=.2, seed=6, turn="NONE"), first)

    def test_on_each_other_where_the_stroke_is_dense(self):
        self.scene()
        heights = [rows[2][3] for rows in self.painted(spacing=.05, seed=1).values()]
        self.assertGreater(max(heights), 1.08)

    def test_as_far_apart_as_they_are_wide_and_never_more_than_a_hundred(self):
        from trivet_addon.scattering import along
        self.scene()
        self.assertEqual(len(self.painted(seed=2)), 11)
        path = [(0, 0, 0), (.25, 0, 0), (.25, .3, 0)]
        self.assertEqual([tuple(map(float, one.round(9))) for one in along(path, .2)], [(0, 0, 0), (.2, 0, 0), (.25, .15, 0)])
        self.assertEqual(len(along([(0, 0, 0), (9, 0, 0)], 1e-3)), 100)
        self.assertEqual(along([], 1), [])


class Exports(unittest.TestCase):
    def test_are_written_and_refused_by_name(self):
        table_with_plate_and_cup()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.xml")
            self.assertEqual(bpy.ops.trivet.export(filepath=path), {"FINISHED"})
            with open(path, encoding="utf-8") as file:
                text = file.read()
            self.assertIn("plate", text)
            with self.assertRaisesRegex(RuntimeError, "scene.what"):
                bpy.ops.trivet.export(filepath=os.path.join(folder, "scene.what"))


class ByProgram(unittest.TestCase):
    """The same without the module."""

    def setUp(self):
        CHOSEN.backend = "PROGRAM"

    def tearDown(self):
        CHOSEN.backend = "AUTO"

    def test_the_awkward_ten_are_put_and_nothing_crosses(self):
        scenes.awkward_ten()
        self.assertEqual(support.put(), {"FINISHED"})
        self.assertEqual((len(memory.last.done), list(memory.last.refused)), (9, ["cube (sheared parent)"]))
        crossing = support.pairs_that_cross(trivet, support.shown_bodies(
            lambda one: one.parent if one.name == "mug handle" else one))[1]
        self.assertEqual(crossing, [])

    def test_push_and_check(self):
        table, plate, cup = table_with_plate_and_cup()
        support.select([plate])
        self.assertEqual(bpy.ops.trivet.push(*RUN, by=(.3, 0)), {"FINISHED"})
        self.assertAlmostEqual(cup.matrix_world.translation.x, .35, 3)
        self.assertEqual(bpy.ops.trivet.check(*RUN), {"FINISHED"})
        self.assertEqual((memory.last.crossings, memory.last.verdict.not_at_rest), ([], ()))

    def test_a_missing_program_is_told(self):
        CHOSEN.program = "/nowhere/trivet"
        table, *_ = scenes.awkward_ten()
        with self.assertRaisesRegex(RuntimeError, "/nowhere/trivet is missing"):
            support.put()
        CHOSEN.program = PROGRAM


class Held(unittest.TestCase):
    """Objects that Blender or the artist holds stay, and are named."""

    def test_by_locks_constraints_drivers_keys_and_links(self):
        support.clear()
        names = {"locked": "locked", "constrained": "constraint", "driven": "driver", "animated": "animated", "none": "no surface"}
        made = {name: cube(name, (2 * k, 0, 2)) for k, name in enumerate(names)}
        made["locked"].lock_location[2] = True
        made["constrained"].constraints.new("LIMIT_LOCATION").use_max_x = True
        made["driven"].driver_add("location", 0)
        made["animated"].keyframe_insert("location")
        made["none"].data.clear_geometry()
        free = cube("free", (-4, 0, 2))
        support.select([*made.values(), free])
        before = support.matrices()
        support.put()
        self.assertEqual(memory.last.done, ["free"])
        for name, word in names.items():
            self.assertIn(word, memory.last.refused[name])
            self.assertEqual(support.matrices()[name][0], before[name][0])

    def test_keys_are_inserted_where_that_is_on(self):
        support.clear()
        one = cube("animated", (0, 0, 2))
        one.keyframe_insert("location")
        support.select([one])
        bpy.context.scene.tool_settings.use_keyframe_insert_auto = True
        support.put()
        bpy.context.scene.tool_settings.use_keyframe_insert_auto = False
        self.assertEqual(memory.last.done, ["animated"])
        bpy.context.scene.frame_set(bpy.context.scene.frame_current)
        self.assertLess(one.matrix_world.translation.z, .51)

    def test_too_many_triangles_are_told(self):
        support.clear()
        support.select([cube("one", (0, 0, 2))])
        CHOSEN.most_millions = 0.001
        ADD.primitive_grid_add(x_subdivisions=50, y_subdivisions=50)
        support.select([bpy.data.objects["one"]])
        with self.assertRaisesRegex(RuntimeError, "more than 0.001 million triangles"):
            support.put()
        CHOSEN.most_millions = 5.0


result = unittest.main(argv=["test_operators"] + support.arguments()[3:], exit=False, verbosity=2).result
sys.stdout.flush()
sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
