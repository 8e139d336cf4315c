"""The add-on reads scenes inside Blender: instances, hidden and linked objects, families, and broken meshes."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import bpy
from mathutils import Matrix

import scenes
import support

ZIP, MODULE, PROGRAM = support.arguments()[:3]
CHOSEN = support.enable(ZIP, MODULE, PROGRAM)
import trivet
from trivet_addon import memory

ADD = bpy.ops.mesh


def cube(name, at, size=(1, 1, 1)):
    return scenes.new(ADD.primitive_cube_add, name, at, scale=size, size=1)


def height(one):
    bpy.context.view_layer.update()
    return one.matrix_world.translation.z


def put(*objects):
    support.select(list(objects))
    support.put()
    return memory.last


def into_collection(name, objects):
    collection = bpy.data.collections.new(name)
    for one in objects:
        for old in list(one.users_collection):
            old.objects.unlink(one)
        collection.objects.link(one)
    return collection


def instance_of(collection, name, at=(0, 0, 0)):
    one = scenes.empty(name, at)
    one.instance_type, one.instance_collection = "COLLECTION", collection
    bpy.context.view_layer.update()
    return one


def cubes_on_points(name, at):
    """A grid of which geometry nodes show cubes on its corners, and nothing else."""
    ADD.primitive_grid_add(x_subdivisions=1, y_subdivisions=1, size=1, location=at)
    one = bpy.context.object
    one.name = name
    group = bpy.data.node_groups.new("cubes", "GeometryNodeTree")
    group.inputs.new("NodeSocketGeometry", "Geometry")
    group.outputs.new("NodeSocketGeometry", "Geometry")
    begin, end = group.nodes.new("NodeGroupInput"), group.nodes.new("NodeGroupOutput")
    place, made = group.nodes.new("GeometryNodeInstanceOnPoints"), group.nodes.new("GeometryNodeMeshCube")
    made.inputs["Size"].default_value = (.2, .2, .2)
    group.links.new(begin.outputs[0], place.inputs["Points"])
    group.links.new(made.outputs["Mesh"], place.inputs["Instance"])
    group.links.new(place.outputs["Instances"], end.inputs[0])
    one.modifiers.new("nodes", "NODES").node_group = group
    bpy.context.view_layer.update()
    return one


class Instances(unittest.TestCase):
    def setUp(self):
        support.clear()

    def test_of_geometry_nodes_move_as_one_and_are_in_the_way(self):
        nodes, lid = cubes_on_points("nodes", (0, 0, 2)), cube("lid", (0, 0, 4), (2, 2, .1))
        self.assertEqual(put(nodes).done, ["nodes"])
        self.assertAlmostEqual(height(nodes), .1, 4)
        self.assertEqual(put(lid).done, ["lid"])
        self.assertAlmostEqual(height(lid), .25, 4)

    def test_of_collections_in_collections_move_as_one(self):
        inner = into_collection("inner", [cube("leg", (.4, 0, .25), (.1, .1, .5)), cube("leg 2", (-.4, 0, .25), (.1, .1, .5))])
        outer = into_collection("outer", [cube("board", (0, 0, .55), (1, .4, .1)), instance_of(inner, "legs")])
        bench, box = instance_of(outer, "bench", (0, 0, 3)), cube("box", (0, 0, 6), (.2, .2, .2))
        self.assertEqual(put(bench, box).done, ["bench", "box"])
        self.assertAlmostEqual(height(bench), 0, 4)
        self.assertAlmostEqual(height(box), .7, 4)

    def test_of_one_mesh_share_a_shape(self):
        from trivet_addon import module, preferences, reading

        first = cube("first", (0, 0, 2))
        for k in range(20):
            copy = first.copy()
            copy.location = (2.0 * k, 5, 2)
            bpy.context.collection.objects.link(copy)
        bpy.context.view_layer.update()
        bodies = reading.read(bpy.context, [first]).bodies
        cache = module.ShapeCache()
        self.assertEqual(len(bodies), 21)
        self.assertEqual(len({cache.shape(trivet, *body.arrays()).vertices.ctypes.data for body in bodies}), 1)


class Seen(unittest.TestCase):
    def setUp(self):
        support.clear()

    def falls_to(self, bottom):
        one = cube("falling", (0, 0, 5))
        put(one)
        self.assertAlmostEqual(height(one), bottom + .5, 3)

    def test_is_what_is_visible(self):
        hidden, off, shelf = cube("hidden", (0, 0, 3)), cube("off", (0, 0, 2)), cube("shelf", (0, 0, .5))
        hidden.hide_set(True)
        off.hide_viewport = True
        self.falls_to(1.0)

    def test_is_not_what_is_drawn_as_wires_or_ignored(self):
        cube("cutter", (0, 0, 3)).display_type = "WIRE"
        cube("ignored", (0, 0, 2)).trivet.role = "IGNORED"
        self.falls_to(0.0)

    def test_is_the_obstacles_collection_where_that_is_chosen(self):
        cube("other", (0, 0, 3))
        collection = into_collection("obstacles", [cube("shelf", (0, 0, .5))])
        bpy.context.scene.collection.children.link(collection)
        bpy.context.scene.trivet.obstacles = collection
        CHOSEN.obstacles = "COLLECTION"
        try:
            self.falls_to(1.0)
        finally:
            CHOSEN.obstacles = "VISIBLE"

    def test_is_the_evaluated_mesh(self):
        block, cutter = cube("block", (0, 0, 1), (2, 2, 2)), cube("cutter", (0, 0, 2), (1.5, 1.5, 2))
        cutter.display_type = "WIRE"
        modifier = block.modifiers.new("hole", "BOOLEAN")
        modifier.object, modifier.operation = cutter, "DIFFERENCE"
        self.falls_to(1.0)

    def test_are_metaballs_and_curves(self):
        bpy.ops.object.metaball_add(type="BALL", radius=1, location=(0, 0, 3))
        ball = bpy.context.object
        bpy.ops.curve.primitive_bezier_circle_add(radius=.5, location=(3, 0, 3), rotation=(.2, .1, 0))
        ring = bpy.context.object
        ring.data.bevel_depth = .1
        self.assertEqual(sorted(put(ball, ring).done), sorted([ball.name, ring.name]))
        self.assertLess(height(ring), .3)
        self.assertEqual(support.pairs_that_cross(trivet, support.shown_bodies())[1], [])


class Families(unittest.TestCase):
    def setUp(self):
        support.clear()

    def test_move_by_the_outermost_that_is_selected(self):
        parent, child = cube("parent", (0, 0, 3)), cube("child", (0, 0, 4))
        bpy.context.view_layer.update()
        child.parent, child.matrix_parent_inverse = parent, parent.matrix_world.inverted()
        local = child.matrix_local.copy()
        self.assertEqual(put(parent, child).done, ["parent"])
        self.assertEqual(child.matrix_local, local)
        self.assertAlmostEqual(height(child), 1.5, 4)

    def test_a_free_child_stays_where_it_is_when_its_parent_alone_moves(self):
        """A cup, parented to a tray, stands on the floor; the tray gives way to a weight."""
        post, tray, cup = cube("post", (0, 0, .5), (.5, .5, 1)), cube("tray", (0, 0, 1.2), (3, .5, .1)), cube("cup", (6, 0, .7))
        tray.data.transform(Matrix.Diagonal((3, .5, .1, 1)))
        tray.scale = (1, 1, 1)
        put(tray, cup)
        self.assertEqual(memory.last.done, ["cup", "tray"])
        cup.parent, cup.matrix_parent_inverse = tray, tray.matrix_world.inverted()
        bpy.context.view_layer.update()
        before = cup.matrix_world.copy()
        weight = cube("weight", (1.2, 0, 3), (.4, .4, .4))
        weight.trivet.density = 8000
        put(weight)
        self.assertEqual(memory.last.done, ["weight"])
        self.assertNotAlmostEqual(tray.matrix_world.to_euler().y, 0, 2)
        bpy.context.view_layer.update()
        self.assertLess(max(abs(a - b) for x, y in zip(cup.matrix_world, before) for a, b in zip(x, y)), 1e-5)

    def test_linked_objects_stay_and_overrides_move(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "library.blend")
            bpy.data.libraries.write(path, {cube("vase", (0, 0, 3))})
            support.clear()
            with bpy.data.libraries.load(path, link=True) as (_, here):
                here.objects = ["vase"]
            vase = here.objects[0]
            bpy.context.collection.objects.link(vase)
            self.assertIn("linked from another file", put(vase).refused[vase.name_full])
            own = vase.override_create()
            bpy.context.collection.objects.link(own)
            bpy.context.collection.objects.unlink(vase)
            self.assertEqual(put(own).done, [own.name_full])
            self.assertAlmostEqual(height(own), .5, 4)
            support.clear()


class Broken(unittest.TestCase):
    def setUp(self):
        support.clear()

    def test_meshes_are_refused_or_put_and_never_crash(self):
        good = cube("floor", (0, 0, 3))
        flat = cube("flat", (4, 0, 3), (1, 1, 0))
        point = cube("point", (8, 0, 3), (0, 0, 0))
        nan = cube("nan", (12, 0, 3))
        nan.data.vertices[0].co.x = float("nan")
        huge = cube("huge", (0, 30, 3), (1e18, 1, 1))
        mesh = bpy.data.meshes.new("loose")
        mesh.from_pydata([(0, 0, 0), (1, 0, 0)], [(0, 1)], [])
        loose = bpy.data.objects.new("loose", mesh)
        bpy.context.collection.objects.link(loose)
        for one in (flat, point, nan, huge, loose):
            one.hide_set(True)
        last = put(good)
        self.assertEqual(last.done, ["floor"])
        for one in (flat, point, nan, huge, loose):
            for other in (flat, point, nan, huge, loose):
                other.hide_set(other != one)
            before = support.matrices()[one.name]
            try:
                last = put(one)
            except RuntimeError as error:
                self.assertGreater(len(str(error)), 20)
                self.assertEqual(support.matrices()[one.name], before)
            else:
                self.assertEqual(len(last.done) + len(last.refused), 1, one.name)
                print(one.name, last.done, last.refused)

    def test_scenes_of_kilometres_are_put_or_refused(self):
        for far in (1e3, 1e4, 1e5):
            support.clear()
            one = cube("one", (far, far, 3), (.3, .3, .3))
            ADD.primitive_plane_add(size=1, location=(far, far, 1))
            last = put(one)
            self.assertEqual(len(last.done) + len(last.refused), 1)
            self.assertEqual("too far from the origin" in str(last.refused), far > 5e3)
            print(far, last.done, last.refused)
            bodies = support.shown_bodies()
            self.assertEqual(support.pairs_that_cross(trivet, bodies)[1], [])


result = unittest.main(argv=["test_reading"] + support.arguments()[3:], exit=False, verbosity=2).result
sys.stdout.flush()
sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
