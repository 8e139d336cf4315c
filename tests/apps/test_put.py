"""trivet put: where it falls from, or wherever there is room, as layouts have it."""

from program import SLAB, Case, main, put


class Put(Case):
    def setUp(self):
        super().setUp()
        self.objects = [SLAB, {"name": "a", "model": "cube.obj"}]
        self.trivet("run", self.layout(self.objects, [put("a", 0, 0, 1)]), "-o", "s.glb")

    def put(self, *arguments, status=0):
        """The report's entry of the operation, and where the new object is."""
        self.trivet("put", "s.glb", "cube.obj", "--name", "b", *arguments, "-o", "t.glb", "--report", "t.json",
                    status=status)
        report = self.read_json("t.json")
        matrices = {o["name"]: o["world_from_file"] for o in report["objects"]}
        return report["operations"][0], matrices.get("b")

    def in_a_layout(self, **place):
        operations = [put("a", 0, 0, 1), {"op": "put", "object": "b", **place}]
        layout = self.layout([*self.objects, {"name": "b", "model": "cube.obj"}], operations, "l.json")
        self.trivet("run", layout, "-o", "l.glb", "--report", "l.json.report")
        return {o["name"]: o["world_from_file"] for o in self.read_json("l.json.report")["objects"]}["b"]

    def test_places_are_those_of_layouts(self):
        for arguments, place in (
                (("--on", "slab", "--at", 0.2, 0.1), {"on": "slab", "at": [0.2, 0.1]}),
                (("--on", "a", "--at", 0, 0, "--rotation", 0.8, 0, 0, 0.6), {"on": "a", "at": [0, 0], "rotation": [0.8, 0, 0, 0.6]}),
                (("--on", "floor", "--at", 0.5, 0, "--keep", 0.05), {"on": "floor", "at": [0.5, 0], "keep": 0.05}),
                (("--on", "slab", "--seed", 7, "--least-margin", 0.01, "--from", 2),
                 {"on": "slab", "seed": 7, "least_margin": 0.01, "from": 2}),
                (("--on", "slab", "--at", "anywhere", "--region", 0.2, 0.2, 0.45, 0.45, "--most-friction", 1),
                 {"on": "slab", "region": [[0.2, 0.2], [0.45, 0.45]], "most_friction": 1})):
            with self.subTest(arguments=arguments):
                operation, here = self.put(*arguments)
                self.assertEqual((operation["op"], operation["status"]), ("put", "ok"))
                for given, expected in zip(here, self.in_a_layout(**place)):
                    self.assertAlmostEqual(given, expected, 6)

    def test_the_region_holds_it(self):
        _, here = self.put("--on", "slab", "--region", -0.4, -0.4, -0.1, -0.4, -0.1, -0.1)
        x, y = here[3], here[7]
        self.assertTrue(-0.4 < x < -0.1 and -0.4 < y < -0.1 and x > y, here)

    def test_no_room_is_a_refusal(self):
        operation, _ = self.put("--on", "a", "--at", 0, 0, "--keep", 5, status=1)
        self.assertEqual(operation["status"], "refused")
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))

    def test_a_new_object_may_be_fixed(self):
        self.put("--position", 0.3, 0, 1, "--fixed")
        states = {o["name"]: o["state"] for o in self.read_json("t.json")["objects"]}
        self.assertEqual(states["b"], "fixed")

    def test_wrong_usage(self):
        for arguments, says in (
                (("--position", 0, 0, 1, "--keep", 0.1), ["--keep is not accepted with --position", "accepted: --position"]),
                (("--position", 0, 0, 1, "--on", "slab"), "--position is not accepted with --on"),
                (("--at", 0, 0), "--on is missing with --at"),
                (("--on", "table"), 'there is no object "table"'),
                (("--on", "slab", "--at", "here"), ['--at: "here" is not accepted', "anywhere"]),
                (("--on", "slab", "--at", 0.5), "--at"),
                (("--on", "slab", "--region", 0, 0, 0, 1, 1, 1), ["--region: 3 corners", "counter-clockwise"]),
                (("--on", "slab", "--seed", 0.5), "whole numbers"),
                (("--on", "slab", "--least-margin", -1), "numbers from 0"),
                (("--on", "slab", "--chord", 0.1), ["--chord", '"cube.obj" has no curved surfaces'])):
            with self.subTest(arguments=arguments):
                self.refused("put", "s.glb", "cube.obj", *arguments, "-o", "t.glb", says=says)


if __name__ == "__main__":
    main()
