"""Things laid into drawers of Trivet's own scenes by relations and by recipes, and what is no thing to lay."""
import json

from program import Case, box_obj, main
from test_drawers import Body, Cabinet, unit

FORKS = ["fork_%d" % i for i in range(4)]
OPEN = {"op": "move_joint", "object": "drawer", "until": "upper"}
CLOSE = {"op": "move_joint", "object": "drawer", "until": "lower"}
IN_DRAWER = {"things": [{"object": fork, "yaw": [0]} for fork in FORKS] + [{"object": "cup"}],
             "relations": [{"is": "on", "a": "fork_*", "b": "drawer"}, {"is": "on", "a": "cup", "b": "unit"},
                           {"is": "keep", "a": "*", "distance": 0.005}]}


class ArrangedDrawers(Case):
    def setUp(self):
        super().setUp()
        frame = unit()
        frame.boxes.append((0, 0, 0.208, 0.2, 0.19, 0.008))
        drawer = frame.inner[0]
        self.write("unit.obj", frame.obj())
        self.write("drawer.obj", drawer.obj())
        self.write("fork.obj", box_obj(0.012, 0.09, 0.003))
        self.write("cup.obj", box_obj(0.03, 0.03, 0.04))
        low = frame.at[2] + 1e-4
        self.furniture = [
            {"name": "unit", "model": "unit.obj", "fixed": True, "position": [0, 0, low]},
            {"name": "drawer", "model": "drawer.obj", "position": [0, 0, low + drawer.at[2]],
             "joint": {"in": "unit", "slide": [0, -1, 0], "lower": 0, "upper": 0.3}}]
        self.things = [{"name": fork, "model": "fork.obj"} for fork in FORKS] + [{"name": "cup", "model": "cup.obj"}]

    def holders(self, scene):
        """Name of what holds each thing up."""
        self.trivet("check", scene, "--report", "report.json")
        return {one["name"]: one["supported_by"]
                for one in self.read_json("report.json")["objects"] if one["name"] in FORKS + ["cup"]}

    def expect_in_drawer(self, scene, drawer="drawer", under_cup="unit"):
        holders = self.holders(scene)
        for fork in FORKS:
            self.assertEqual(holders[fork], [drawer])
        self.assertEqual(holders["cup"], [under_cup])

    def test_an_operation_arranges_in_an_open_drawer(self):
        self.layout(self.furniture + self.things, [OPEN, {"op": "arrange", **IN_DRAWER}, CLOSE], "layout.json")
        self.trivet("run", "layout.json", "-o", "closed.glb")
        self.expect_in_drawer("closed.glb")
        self.trivet("move-joint", "closed.glb", "drawer", "--to", 0.2, "-o", "open.glb")
        self.expect_in_drawer("open.glb")

    def test_what_is_put_on_a_drawer_lies_in_it(self):
        puts = [{"op": "put", "object": fork, "on": "drawer", "at": "anywhere", "seed": i} for i, fork in enumerate(FORKS)]
        self.layout(self.furniture + self.things, [OPEN, *puts, CLOSE], "layout.json")
        self.trivet("run", "layout.json", "-o", "closed.glb")
        self.assertEqual({self.holders("closed.glb")[fork][0] for fork in FORKS}, {"drawer"})
        # On its rim what is too large, where it is open.
        wide = {"name": "wide", "model": "wide.obj"}
        self.write("wide.obj", box_obj(0.18, 0.1, 0.004))
        put = {"op": "put", "object": "wide", "on": "drawer", "at": "anywhere"}
        self.layout([*self.furniture, wide], [OPEN, put], "wide.json")
        self.trivet("run", "wide.json", "-o", "wide.glb")

    def test_a_problem_has_drawers(self):
        furniture = json.loads(json.dumps(self.furniture))
        furniture[1]["joint"]["value"] = 0.3
        furniture[1]["position"][1] -= 0.3
        self.layout(furniture + self.things, name="problem.json", arrange=IN_DRAWER)
        self.trivet("arrange", "problem.json", "-o", "open.glb")
        self.expect_in_drawer("open.glb")
        self.trivet("move-joint", "open.glb", "drawer", "--until", "lower", "-o", "closed.glb")
        self.expect_in_drawer("closed.glb")

    def test_what_is_in_a_drawer_does_not_lie_on_its_rim(self):
        # Sides of 0.11 m and a front of 0.14 m: on the sides a spoon is lower than the front's top.
        low = Body("low", (0, 0, 0), [(0, 0, 0.005, 0.19, 0.18, 0.005), (-0.185, 0, 0.06, 0.005, 0.18, 0.05), (0.185, 0, 0.06, 0.005, 0.18, 0.05),
                              (0, 0.175, 0.06, 0.18, 0.005, 0.05), (0, -0.185, 0.07, 0.2, 0.005, 0.07)])
        self.write("low.obj", low.obj())
        self.write("spoon.obj", box_obj(0.01, 0.075, 0.005))
        things = [{"name": "spoon %d" % i, "model": "spoon.obj"} for i in range(3)]
        drawer = {"name": "drawer", "model": "low.obj", "fixed": True, "position": [0, 0, 0.24]}
        for seed in range(6):
            self.layout([drawer] + things, [{"op": "arrange", "seed": seed, "things": [{"object": one["name"]} for one in things],
                                             "relations": [{"is": "in", "a": "spoon *", "b": "drawer"}]}])
            self.trivet("run", "layout.json", "-o", "in.glb")
            self.trivet("export", "in.glb", "-o", "poses.jsonl", "--quiet")
            rows = [json.loads(line) for line in self.read("poses.jsonl").splitlines()]
            for row in rows:
                if row["name"] != "drawer":
                    self.assertLess(row["z"], 0.24 + 0.1, "%s by the seed %d" % (row["name"], seed))

    def test_a_drawer_of_another_program(self):
        self.write("unit.xml", Cabinet.text_of(unit(), []))
        name = "kitchen/drawer"
        self.layout([{"name": "kitchen", "articulation": "unit.xml", "position": [1, 0, 0]}] + self.things[:1],
                    [{"op": "move_joint", "object": name, "until": "upper"},
                     {"op": "arrange", "things": [{"object": "fork_0"}],
                      "relations": [{"is": "in", "a": "fork_0", "b": name}]},
                     {"op": "move_joint", "object": name, "until": "lower"}])
        self.trivet("run", "layout.json", "-o", "filled.glb", "--report", "moves.json")
        self.assertEqual(self.holders("filled.glb")["fork_0"], [name])
        # On its floor nothing is in the way.
        self.assertEqual([one["ended"] for one in self.read_json("moves.json")["operations"]], ["reached", "at_rest", "reached"])

    def test_a_recipe_fills_a_drawer(self):
        self.write("recipe.json", json.dumps({
            "trivet_recipe": 1, "objects": self.furniture, "operations": [OPEN],
            "groups": [{"name": "forks", "models": [{"model": "fork.obj"}], "count": [2, 4], "on": "drawer"}]}))
        self.trivet("batch", "recipe.json", "--count", 3, "--out", "batch", "--quiet")
        for number in range(3):
            scene = "%d.glb" % number
            self.trivet("batch", "materialise", "batch", number, "-o", scene)
            self.trivet("check", scene, "--report", "report.json")
            forks = [one for one in self.read_json("report.json")["objects"] if one["name"].startswith("forks")]
            self.assertGreaterEqual(len(forks), 2)
            for one in forks:
                self.assertEqual(one["supported_by"], ["drawer"])

    def test_a_drawer_is_no_thing_to_place(self):
        things = {**IN_DRAWER, "things": IN_DRAWER["things"] + [{"object": "drawer"}]}
        self.layout(self.furniture + self.things, name="problem.json", arrange=things)
        self.refused("arrange", "problem.json", "-o", "out.glb",
                     says='things: "drawer" hangs in a joint; accepted: objects that may move, onto it, too')


if __name__ == "__main__":
    main()
