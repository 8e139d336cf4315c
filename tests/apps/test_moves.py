"""Verbs that move an object of a scene, and the same operations in a layout."""
import json
import unittest

from program import SLAB, Case, main, put


class Moves(Case):
    def setUp(self):
        super().setUp()
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"},
                              {"name": "b", "model": "cube.obj"},
                              {"name": "on_a", "model": "cube.obj", "scale": 0.5}],
                             [put("a", 0, 0, 1), put("b", 0.3, 0, 1), put("on_a", 0, 0, 1)])
        self.trivet("run", layout, "-o", "s.glb")

    def move(self, *arguments, status=0):
        """Returns the report's entry of the operation, and the objects' positions."""
        verb, scene, *rest = arguments
        out, _ = self.trivet(verb, scene, *rest, "-o", "t.glb", "--report", "t.json", status=status)
        report = self.read_json("t.json")
        places = {o["name"]: [o["world_from_file"][i] for i in (3, 7, 11)]
                  for o in report["objects"]}
        return report["operations"][0], places, report, out

    def test_push_into_another_and_back(self):
        operation, places, _, out = self.move("push", "s.glb", "a", "--direction", 1, 0,
                                              "--distance", 0.4, "--no-slide", "--step-up", 0)
        self.assertEqual((operation["op"], operation["status"]), ("push", "ok"))
        self.assertIn(operation["ended"], ("blocked", "step"))
        self.assertEqual(operation["blocked_by"], "b")
        self.assertEqual(operation["carried"], ["on_a"])
        self.assertAlmostEqual(places["a"][0], 0.2, 5)
        self.assertAlmostEqual(places["on_a"][0], 0.2, 5)
        self.assertIn('"b"', out)
        operation, places, report, _ = self.move("push", "t.glb", "a", "--to", -0.1, 0.2)
        self.assertEqual(operation["ended"], "reached")
        self.assertAlmostEqual(places["on_a"][1], 0.2, 5)
        self.assertTrue(report["check"]["all_at_rest"])
        self.trivet("check", "t.glb")

    def test_together_and_unfix(self):
        operation, places, report, _ = self.move("push", "s.glb", "a", "--direction", 0, 1,
                                                 "--distance", 0.1, "--together", "b")
        self.assertEqual(operation["carried"], ["b", "on_a"])
        for name, x in (("a", 0), ("on_a", 0), ("b", 0.3)):
            self.assertAlmostEqual(places[name][0], x, 5)
            self.assertAlmostEqual(places[name][1], 0.1, 5)
        self.assertTrue(report["check"]["all_at_rest"])
        _, error = self.trivet("push", "--together", "b", "--together", "nobody", "s.glb", "a",
                               "--to", 0, 0, "-o", "v.glb", status=2)
        self.assertIn('there is no object "nobody"', error)
        self.trivet("fix", "t.glb", "a", "-o", "u.glb")
        out = self.move("push", "u.glb", "a", "--to", 0, 0.2, status=1)[3]
        self.assertIn("unfix it first", out)
        self.trivet("unfix", "u.glb", "a", "-o", "u.glb")
        operation, places, _, _ = self.move("push", "u.glb", "a", "--to", 0, 0.2)
        self.assertEqual(operation["carried"], ["on_a"])
        self.assertAlmostEqual(places["on_a"][1], 0.2, 5)

    def test_materials(self):
        self.trivet("material", "s.glb", "a", "--material", "wood", "-o", "m.glb")
        self.trivet("material", "m.glb", "b", "--material", "steel", "--friction", 0.3, "-o", "m.glb")
        self.trivet("put", "m.glb", "cube.obj", "--position", 0.7, 0, 1, "--material", "ice",
                    "--name", "ice", "-o", "m.glb", "--report", "m.json")
        report = self.read_json("m.json")
        materials = {o["name"]: o["material"] for o in report["objects"]}
        self.assertEqual(materials["a"], {"name": "wood", "friction": 0.45, "density": 700,
                                          "restitution": 0.6})
        self.assertEqual(materials["b"], {"name": None, "friction": 0.3, "density": 7850,
                                          "restitution": 0.6})
        self.assertEqual(materials["slab"], {"name": None, "friction": 0.5, "density": 1000,
                                             "restitution": 0})
        self.assertEqual(materials["ice"]["name"], "ice")
        self.assertEqual(report["stability"]["friction"], "materials")
        self.assertEqual(report["stability"]["friction_of_a_pair"], "smaller")
        friction = {o["name"]: o["friction"] for o in report["stability"]["objects"]}
        self.assertEqual(friction, {"a": 0.45, "b": 0.3, "on_a": 0.45, "ice": 0.1})
        out, _ = self.trivet("check", "m.glb", "--object", "b", "--json")
        self.assertEqual(json.loads(out)["with_all_free"]["friction"], 0.3)
        for arguments, says in ((("--material", "wod"), "did you mean \"wood\""),
                                (("--friction", 0), "accepted: numbers from 0.001 to 10"),
                                (("--restitution", 2), "accepted: numbers from 0 to 1"), ((), "--material NAME")):
            self.refused("material", "s.glb", "a", *arguments, "-o", "x.glb", says=says)

    def test_turn(self):
        operation, _, report, _ = self.move("turn", "s.glb", "a", "--angle-deg", -30)
        self.assertEqual((operation["ended"], operation["turned_deg"]), ("reached", -30))
        self.assertTrue(report["check"]["all_at_rest"])

    def test_pick_up_holds(self):
        operation, places, report, out = self.move("pick-up", "s.glb", "b", "--distance", 0.2,
                                                   status=1)
        self.assertEqual((operation["op"], operation["ended"]), ("pick_up", "reached"))
        states = {o["name"]: o["state"] for o in report["objects"]}
        self.assertEqual(states["b"], "held")
        self.assertEqual(report["check"]["not_at_rest"], ["b"])
        self.trivet("check", "t.glb", status=1)
        operation, places, report, _ = self.move("translate", "t.glb", "b", "--by", 0, 0.2, 0,
                                                 "--settle")
        self.assertAlmostEqual(places["b"][1], 0.2, 5)
        self.assertTrue(report["check"]["all_at_rest"])

    def test_interpenetrating_object_is_not_stable(self):
        _, _, report, out = self.move("translate", "s.glb", "on_a", "--by", 0, 0, -0.02, "--free",
                                      status=1)
        self.assertEqual(report["stability"]["status"], "unknown")
        self.assertIn('"on_a" interpenetrates', report["stability"]["why_unknown"])
        self.assertIn("stability: unknown", out)
        for arguments in ((), ("--object", "on_a"), ("--object", "b")):
            out, _ = self.trivet("check", "t.glb", *arguments, status=1)
            self.assertNotIn("stable, margin", out)

    def test_free_moves_are_marked(self):
        operation, _, report, out = self.move("rotate", "s.glb", "a", "--axis", 0, 1, 0,
                                              "--angle-deg", 30, "--free", status=1)
        self.assertEqual(operation["interpenetrates"], ["slab"])
        states = {o["name"]: o["state"] for o in report["objects"]}
        self.assertEqual(states["a"], "invalid")
        self.assertIn("passes through", out)

    def test_refusals_keep_the_scene(self):
        _, _, _, out = self.move("translate", "s.glb", "slab", "--by", 1, 0, 0, status=1)
        self.assertIn('"slab" is fixed', out)
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))

    def test_wrong_usage(self):
        for arguments, says in (
                (("push", "s.glb", "a"), "accepted: --to, or --direction and --distance"),
                (("push", "s.glb", "a", "--direction", 0, 0, "--distance", 1),
                 "a direction whose length is not zero"),
                (("push", "s.glb", "c", "--to", 0, 0), 'there is no object "c"'),
                (("turn", "s.glb", "a", "--angle-deg", 4000), "accepted: numbers from -3600"),
                (("turn", "s.glb", "a", "--angle-deg", 1, "--axis", 0, 0, 1), "--about normal"),
                (("rotate", "s.glb", "a", "--axis", 0, 0, 0, "--angle-deg", 1),
                 "a direction whose length is not zero"),
                (("pick-up", "s.glb", "a"), "--distance"),
                (("translate", "s.glb", "a"), "--by")):
            self.refused(*arguments, "-o", "t.glb", says=says)

    def test_a_layout_of_all_operations(self):
        layout = self.layout(
            [SLAB, {"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}],
            [put("a", 0, 0, 1), put("b", 0.3, 0, 1),
             {"op": "push", "object": "a", "direction": [0, 1], "distance": 0.1},
             {"op": "turn", "object": "a", "about": "normal", "angle_deg": 30},
             {"op": "pick_up", "object": "b", "distance": 0.1},
             {"op": "translate", "object": "b", "by": [0, -0.2, 0.1]},
             {"op": "rotate", "object": "b", "axis": [0, 0, 1], "angle_deg": 45, "settle": True}])
        self.trivet("run", layout, "-o", "all.glb", "--report", "all.json")
        operations = self.read_json("all.json")["operations"]
        self.assertEqual([o["ended"] for o in operations], ["at_rest"] * 2 + ["reached"] * 5)


if __name__ == "__main__":
    main()
