"""Computer-aided layout end to end: poses and surfaces of models, arrangements, conflicts."""
import copy
import glob
import json
import math
import os
import random
import unittest

from program import SOURCE_DIR, Case, box_obj, main, without_times
from test_sessions import Live

try:
    import jsonschema
except ImportError:
    jsonschema = None


def shelf_obj(boards, half_x=0.4, half_y=0.15, thick=0.02):
    """OBJ text of boards at these heights of their upper sides, between two sides."""
    text, count = "", 0
    sides = [((x, 0, boards[-1] / 2), (0.01, half_y, boards[-1] / 2))
             for x in (-half_x - 0.01, half_x + 0.01)]
    for centre, half in sides + [((0, 0, z - thick / 2), (half_x, half_y, thick / 2)) for z in boards]:
        for line in box_obj(*half).splitlines():
            kind, *values = line.split()
            values = [float(v) + c for v, c in zip(values, centre)] if kind == "v" else \
                [int(v) + count for v in values]
            text += kind + "".join(" %r" % v for v in values) + "\n"
        count += 8
    return text


class Info(Case):
    def text(self, *arguments):
        return self.trivet("info", *arguments)[0]

    def info(self, *arguments):
        return json.loads(self.text(*arguments, "--json"))

    def test_poses(self):
        self.write("book.obj", box_obj(0.015, 0.08, 0.11))
        info = self.info("book.obj", "--poses")
        self.assertEqual(len(info["poses"]), 6)
        self.assertAlmostEqual(sum(p["probability"] for p in info["poses"]), 1, places=14)
        upright = info["poses"][info["upright"]]
        self.assertEqual(upright["rotation"], [1, 0, 0, 0])
        self.assertAlmostEqual(upright["margin"], 0.015, places=9)
        for pose in info["poses"]:
            self.assertTrue(pose["settled"]["stays"])
            self.assertLess(pose["settled"]["turned_deg"], 1e-3)
        self.assertNotIn("surfaces", info)
        self.assertIn("upright", self.text("book.obj", "--poses"))

    def test_poses_are_where_things_rest(self):
        """Feet of nine corners that are not quite level: their poses are on three of them, and PUT leaves them."""
        draw, turned = random.Random(3), []
        for _ in range(6):
            corners = [(0.1 * math.cos(k * math.pi / 4.5), 0.1 * math.sin(k * math.pi / 4.5), 3e-4 * draw.random())
                       for k in range(9)]
            text = "".join("v %r %r %r\n" % c for c in corners) + "v 0 0 0.3\nv 0 0 0.001\n"
            for k in range(9):
                text += "f %d %d 10\nf %d %d 11\n" % (k + 1, (k + 1) % 9 + 1, (k + 1) % 9 + 1, k + 1)
            self.write("foot.obj", text)
            info = self.info("foot.obj", "--poses")
            settled = info["poses"][info["upright"]]["settled"]
            self.assertTrue(settled["stays"])
            turned.append(settled["turned_deg"])
        self.assertLess(max(turned), 1e-3)

    def test_poses_without_an_upright_one(self):
        self.write("top.obj", "v 0 0 0\nv 1 0 2\nv -0.5 0.9 2\nv -0.5 -0.9 2\n"
                              "f 1 2 4\nf 1 4 3\nf 1 3 2\nf 2 3 4\n")
        info = self.info("top.obj", "--poses")
        self.assertIsNone(info["upright"])
        self.assertIn("does not stand upright: its nearest stable pose is tilted by",
                      info["upright_reason"])

    def test_surfaces(self):
        self.write("shelf.obj", shelf_obj([0.1, 0.4, 0.75]))
        info = self.info("shelf.obj", "--surfaces")
        self.assertEqual([round(s["height"], 6) for s in info["surfaces"]], [0.1, 0.4, 0.75])
        self.assertAlmostEqual(info["surfaces"][0]["head_room"], 0.28, places=6)
        self.assertIsNone(info["surfaces"][2]["head_room"])
        self.assertAlmostEqual(info["surfaces"][1]["area"], 0.24, places=6)
        self.assertIn("open above", self.text("shelf.obj", "--surfaces"))


class Arrange(Case):
    def problem(self, relations, things=None, **more):
        """A shelf, two mugs and a book."""
        self.write("shelf.obj", shelf_obj([0.1, 0.4, 0.75]))
        self.write("mug.obj", box_obj(0.04, 0.04, 0.05))
        self.write("book.obj", box_obj(0.015, 0.08, 0.11))
        arrange = {"relations": relations, **more}
        if things is not None:
            arrange["things"] = things
        document = {"trivet": 1, "objects": [
            {"name": "shelf", "model": "shelf.obj", "fixed": True, "position": [0, 0, 1e-5]},
            {"name": "mug_1", "model": "mug.obj"}, {"name": "mug_2", "model": "mug.obj"},
            {"name": "book", "model": "book.obj"}], "arrange": arrange}
        return self.write("problem.json", json.dumps(document))

    ON = [{"is": "on", "a": "mug_*", "b": "shelf", "level": 1},
          {"is": "on", "a": "book", "b": "shelf", "level": "top"},
          {"is": "right_of", "a": "mug_2", "b": "mug_1", "gap": [0.05, 0.1]},
          {"is": "aligned", "a": "mug_*", "b": "shelf"},
          {"is": "keep", "a": "*", "distance": 0.01}]

    def positions(self, report):
        return {o["name"]: o["world_from_file"][3:12:4] for o in report["objects"]}

    def test_arranges_the_same_with_any_threads(self):
        self.problem(self.ON)
        out, _ = self.trivet("arrange", "problem.json", "-o", "a.glb", "--report", "a.json")
        self.assertIn("arrange: done", out)
        self.assertIn("3 hard relations hold", out)
        report = self.read_json("a.json")
        self.assertEqual(report["arrange"]["status"], "done")
        self.assertTrue(all(r["cost"] <= 1 for r in report["arrange"]["relations"]))
        at = self.positions(report)
        self.assertAlmostEqual(at["mug_1"][2], 0.45, places=3)
        self.assertAlmostEqual(at["book"][2], 0.86, places=3)
        self.trivet("check", "a.glb")
        self.trivet("put", "a.glb", "mug.obj", "--position", 2, 2, 1, "-o", "more.glb")
        # Other threads, the same bytes; another seed, another scene.
        for name, arguments in (("b", ["--threads", 1]), ("c", ["--threads", 2]),
                                ("d", ["--seed", 9])):
            self.trivet("arrange", "problem.json", "-o", name + ".glb", "--report", name + ".json",
                        *arguments)
        self.assertEqual(self.read("b.glb"), self.read("a.glb"))
        self.assertEqual(self.read("c.glb"), self.read("a.glb"))
        self.assertEqual(without_times(self.read("b.json")), without_times(self.read("c.json")))
        self.assertNotEqual(self.positions(self.read_json("d.json")), at)

    def test_conflict_leaves_the_scene_as_it_was(self):
        self.problem(self.ON + [{"is": "left_of", "a": "mug_2", "b": "mug_1"}])
        out, _ = self.trivet("arrange", "problem.json", "-o", "a.glb", "--report", "a.json",
                             status=1)
        self.assertIn('"mug_2" right_of "mug_1"; "mug_2" left_of "mug_1"', out)
        report = self.read_json("a.json")
        self.assertEqual(report["arrange"]["status"], "conflict")
        self.assertEqual(len(report["arrange"]["conflict"]["constraints"]), 2)
        placed = [o["name"] for o in report["objects"] if o["state"] != "unplaced"]
        self.assertEqual(placed, ["shelf"])

    def test_operation_of_layouts_and_sessions(self):
        self.problem([])
        document = self.read_json("problem.json")
        del document["arrange"]
        operation = {"op": "arrange", "seed": 5, "relations": self.ON}
        document["operations"] = [operation]
        self.write("layout.json", json.dumps(document))
        self.trivet("run", "layout.json", "-o", "a.glb", "--report", "a.json")
        report = self.read_json("a.json")
        self.assertEqual([(o["op"], o["object"], sorted(o["settled"])) for o in report["operations"]],
                         [("arrange", "*", ["book", "mug_1", "mug_2"])])
        # Relations that contradict each other: told as data, and the scene stays as it was.
        document["operations"] = []
        self.write("start.json", json.dumps(document))
        bad = {**operation, "relations": self.ON + [{"is": "left_of", "a": "mug_2", "b": "mug_1"}]}
        live = Live(self.folder, "start.json", "--journal", "j")
        refused, done = live.ask(**bad), live.ask(**operation)
        undone, redone = live.ask(undo=True), live.ask(redo=True)
        self.assertEqual(live.ask(save="b.glb")["status"], "ok")
        self.assertEqual(live.end(), 0)
        self.assertEqual((refused["status"], refused["cause"]), ("refused", "no_arrangement"))
        self.assertEqual(refused["objects"], ["mug_2", "mug_1"])
        self.assertGreater(refused["numbers"]["missing"], 0.1)
        self.assertEqual(done["done"], 1)
        self.assertEqual(sorted(p["object"] for p in done["poses"]), ["book", "mug_1", "mug_2"])
        self.assertEqual(undone["state"], live.start["state"])
        self.assertEqual(redone["state"], done["state"])
        self.trivet("replay", "j", "-o", "c.glb")
        self.assertEqual(self.read("c.glb"), self.read("b.glb"))

    def test_marks_beside_objects_join_the_section(self):
        """All programs solve the same problem, wherever its fronts and zones are written."""
        zone = {"name": "way", "box": [[-0.4, -0.9, 0], [0.4, -0.15, 1]]}
        other = {"name": "side", "box": [[0.42, -0.15, 0], [0.9, 0.15, 1]]}
        relations = [{"is": "facing", "a": "mug_1", "point": [3, 0]}, {"is": "keep", "a": "*", "distance": 0.01}]
        scenes = []
        for beside in (False, True):
            self.problem(relations, fronts={} if beside else {"mug_1": "x"},
                         zones={"shelf": [other] if beside else [other, zone]})
            document = self.read_json("problem.json")
            if beside:
                document["objects"][0]["zones"] = [zone]
                document["objects"][1]["front"] = "x"
                self.write("problem.json", json.dumps(document))
            self.trivet("arrange", "problem.json", "-o", "a.glb", "--report", "a.json")
            scenes.append(self.positions(self.read_json("a.json")))
            self.trivet("run", "problem.json", "-o", "run.glb")  # laid out without the section
        self.assertEqual(scenes[0], scenes[1])
        document["arrange"]["fronts"] = {"mug_1": "y"}
        self.write("problem.json", json.dumps(document))
        self.refused("arrange", "problem.json", "-o", "x.glb", says="/objects/1/front: /arrange/fronts has one")
        del document["arrange"]
        self.write("problem.json", json.dumps(document))
        self.refused("run", "problem.json", "-o", "x.glb", says="/objects/0/zones: there is no section")

    def test_surfaces_have_names(self):
        on = [{"is": "on", "a": "mug_1", "b": "shelf", "level": "middle"},
              {"is": "row", "of": ["mug_2"], "on": "shelf", "level": "low"}]
        self.problem(on, surfaces={"sh*": {"low": 0, "middle": 1}})
        self.trivet("arrange", "problem.json", "-o", "a.glb", "--report", "a.json")
        at = self.positions(self.read_json("a.json"))
        self.assertAlmostEqual(at["mug_1"][2], 0.45, places=3)
        self.assertAlmostEqual(at["mug_2"][2], 0.15, places=3)
        # The same problem, given beside the object.
        self.problem(on)
        document = self.read_json("problem.json")
        document["objects"][0]["surfaces"] = {"low": "bottom", "middle": -2}
        self.write("problem.json", json.dumps(document))
        self.trivet("arrange", "problem.json", "-o", "b.glb", "--report", "b.json")
        self.assertEqual(self.positions(self.read_json("b.json")), at)
        document["arrange"]["surfaces"] = {"shelf": {"low": 0}}
        self.write("problem.json", json.dumps(document))
        self.refused("arrange", "problem.json", "-o", "x.glb", says="/objects/0/surfaces: /arrange/surfaces has some")
        self.problem([{**on[0], "level": "midle"}], surfaces={"shelf": {"middle": 1}})
        self.refused("arrange", "problem.json", "-o", "x.glb", says=["/arrange/relations/0/level", '"middle", "top"'])
        self.problem(on[:1])
        self.refused("arrange", "problem.json", "-o", "x.glb", says="/arrange/relations/0/level")
        self.problem(on, surfaces={"shelf": {"low": "cellar"}})
        self.refused("arrange", "problem.json", "-o", "x.glb", says="/arrange/surfaces/shelf/low")

    def test_contradictions_are_told_at_once(self):
        near = {"is": "near", "a": "mug_1", "b": "mug_2", "distance": 0.1}
        self.problem([near, {"is": "keep", "a": "*", "distance": 1e9}])
        out, _ = self.trivet("arrange", "problem.json", "-o", "a.glb", "--report", "a.json", status=1)
        self.assertIn("0 PUTs", out)
        self.assertIn("1e+09 m are asked for", out)
        placed = [o["name"] for o in self.read_json("a.json")["objects"] if o["state"] != "unplaced"]
        self.assertEqual(placed, ["shelf"])
        self.problem([{"is": "on", "a": "mug_1", "b": "shelf", "level": 99}])
        out, _ = self.trivet("arrange", "problem.json", "-o", "a.glb", status=1)
        self.assertIn('"shelf" has 3 surfaces, none of which is 99; accepted: -3 to 2', out)

    def test_names_mean_what_the_operations_left(self):
        self.problem([{"is": "near", "a": "cup", "b": "twin", "distance": 0.5},
                      {"is": "at", "a": "twin", "point": [0.2, 1]}],
                     things=[{"objects": "cup"}, {"object": "twin"}])
        document = self.read_json("problem.json")
        document["operations"] = [{"op": "rename", "object": "mug_1", "to": "cup"},
                                  {"op": "duplicate", "object": "mug_2", "as": "twin"}]
        self.write("problem.json", json.dumps(document))
        self.trivet("arrange", "problem.json", "-o", "a.glb", "--report", "a.json")
        placed = [o["name"] for o in self.read_json("a.json")["objects"] if o["state"] == "stable"]
        self.assertEqual(sorted(placed), ["cup", "twin"])
        document["arrange"]["relations"][0]["a"] = "mug_1"
        self.write("problem.json", json.dumps(document))
        self.refused("arrange", "problem.json", "-o", "x.glb", says=["/arrange/relations/0/a", '"mug_1"'])

    def test_bad_problems(self):
        def refused(relation, says, **more):
            self.problem([relation], **more)
            self.refused("arrange", "problem.json", "-o", "x.glb", says=says)
        refused({"is": "on", "a": "mug_1", "b": "shelff"},
                ["/arrange/relations/0/b", 'did you mean "shelf"'])
        refused({"is": "above", "a": "mug_1", "b": "shelf"}, "accepted: one of next_to, row")
        refused({"is": "rigth_of", "a": "mug_1", "b": "shelf"}, 'did you mean "right_of"')
        refused({"is": "on", "a": "mug_1", "b": "mug_1"}, "another object than a")
        refused({"is": "near", "a": "mug_1", "b": "shelf", "distance": -1}, "/distance")
        refused({"is": "left_of", "a": "mug_1", "b": "shelf", "gap": [2, 1]}, "least first")
        refused({"is": "within", "a": "mug_1", "region": [[0, 0], [0, 1], [1, 0]]}, "convex")
        refused({"is": "facing", "a": "mug_1"}, 'either "b" or "point"')
        refused({"is": "at", "a": "mug_1", "point": [0, 0]}, "is named before",
                things=[{"objects": "mug_*"}, {"object": "mug_1"}])
        refused({"is": "at", "a": "mug_1", "point": [0, 0]}, "is fixed",
                things=[{"object": "shelf"}, {"object": "mug_1"}])
        refused({"is": "on", "a": "shelf", "b": "mug_1"}, "none of the things to arrange")
        refused({"is": "at", "a": "mug_1", "point": [0, 0]}, "has no stable pose 99",
                things=[{"object": "mug_1", "pose": 99}])
        self.problem([{"is": "on", "a": "mug_1", "b": "mug_2"},
                      {"is": "on", "a": "mug_2", "b": "mug_1"}])
        self.refused("arrange", "problem.json", "-o", "x.glb", says="have to carry itself")
        self.write("plain.json", '{"trivet": 1, "objects": []}')
        self.refused("arrange", "plain.json", "-o", "x.glb", says="arrange")

    @unittest.skipIf(jsonschema is None, "Python has no jsonschema (Debian: python3-jsonschema)")
    def test_schema_and_reader_agree(self):
        schema = json.loads(self.trivet("schema", "arrange")[0])
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        good = [{"is": "on", "a": "book", "b": "floor"},
                {"is": "against", "a": "book", "b": "shelf", "side": "left", "gap": [0, 0.1]},
                {"is": "next_to", "a": "book", "b": "shelf"},
                {"is": "behind", "a": "book", "b": "shelf", "overlap": 0, "weight": 2},
                {"is": "facing", "a": "book", "point": [1, 2]},
                {"is": "away", "a": "book", "b": "shelf", "tolerance": 10},
                {"is": "centred", "a": "book", "b": "shelf", "along": "x", "offset": [0, 1]},
                {"is": "within", "a": "book", "region": [[0, 0], [1, 0], [0, 1]]},
                {"is": "row", "of": ["mug_*"], "on": "shelf", "align": "left", "order": "any"},
                {"is": "grid", "of": "mug_*", "on": "shelf", "columns": 2, "level": -1},
                {"is": "keep", "a": "*", "distance": 0.1, "except": [["mug_1", "book"]]}]
        good += [{"is": "symmetric", "a": "mug_1", "b": "mug_2", "about": "shelf"},
                 {"is": "symmetric", "a": "mug_1", "b": "mug_2", "point": [0, 0], "axis": [0, 2]},
                 {"is": "circle", "of": "mug_*", "on": "floor", "radius": 0.5, "middle": [1, 1], "outwards": True},
                 {"is": "facings", "of": [{"things": "mug_*", "wide": 2}, {"things": ["book"]}], "on": "shelf",
                  "level": "top", "align": "spread", "inset": 0.01},
                 {"is": "stack", "of": ["mug_1", "mug_2"], "on": "shelf", "level": 1, "tolerance": 0.02}]
        good += [{"is": "perpendicular", "a": "book", "b": "shelf"},
                 {"is": "at_edge", "a": "mug_1", "b": "shelf", "side": "front", "gap": [0, 0.02]},
                 {"is": "under", "a": "mug_1", "b": "shelf", "part": 0.8},
                 {"is": "view", "a": "mug_1", "b": "shelf", "height": 1.5, "part": 0.25},
                 {"is": "view", "a": "mug_1", "point": [0, -2, 1.6], "weight": 1},
                 {"is": "reach", "a": "mug_1", "point": [0, -2, 1.6], "distance": 3},
                 {"is": "near", "a": "mug_1", "b": "shelf", "distance": [0.5, 2]},
                 {"is": "along", "of": "mug_*", "on": "floor", "points": [[1, 1], [2, 1], [2, 2]],
                  "spacing": 0.5, "front": "onwards"},
                 {"is": "stack", "of": ["mug_1", "mug_2"], "on": "shelf", "level": 1, "jitter": 0.02},
                 {"is": "stands", "a": "mug_*", "margin": 0.01, "friction": 0.4}]
        bad = [({"is": "view", "a": "mug_1"}, None),
               ({"is": "view", "a": "mug_1", "point": [0, 0]}, None),
               ({"is": "view", "a": "mug_1", "point": [0, 0, 1], "height": 1}, None),
               ({"is": "view", "a": "mug_1", "b": "shelf", "part": 2}, None),
               ({"is": "reach", "a": "mug_1", "b": "shelf", "distance": -1}, None),
               ({"is": "under", "a": "mug_1"}, None),
               ({"is": "at_edge", "a": "mug_1", "b": "shelf", "side": "top"}, None),
               ({"is": "along", "of": "mug_*", "on": "floor", "points": [[1, 1]]}, None),
               ({"is": "along", "of": "mug_*", "on": "floor"}, None),
               ({"is": "stands", "a": "mug_1"}, None),
               ({"is": "stands", "a": "mug_1", "margin": -1}, None),
               ({"is": "symmetric", "a": "mug_1", "b": "mug_2"}, None),
               ({"is": "symmetric", "a": "mug_1", "b": "mug_2", "about": "shelf", "axis": [1, 0]}, None),
               ({"is": "circle", "of": "mug_*", "on": "floor"}, None),
               ({"is": "facings", "of": [], "on": "shelf"}, None),
               ({"is": "facings", "of": [{"things": "mug_*", "wide": 0}], "on": "shelf"}, None),
               ({"is": "stack", "of": "mug_*", "on": "shelf"}, "gap"),
               ({"is": "stack", "of": "mug_*", "on": "shelf", "tolerance": 0.01, "jitter": 0.01}, None),
               ({"is": "near", "a": "book", "b": "shelf", "distance": "1 m"}, None),
               ({"is": "on"}, None), ({"is": "row", "of": "mug_*", "on": "shelf"}, "columns"),
               ({"is": "near", "a": "book", "b": "shelf"}, None),
               ({"is": "at", "a": "book", "point": [1]}, None),
               ({"is": "at", "a": "book", "point": [1, 2]}, "gap"),
               ({"is": "in", "a": "book", "b": "shelf"}, "level"),
               ({"is": "same", "a": "book", "b": "shelf", "weight": -1}, None),
               ({"is": "keep", "a": "*", "distance": 1, "except": [["a"]]}, None)]
        for yaw, is_good in (([0, 90], True), ({"step": 15}, True), ("any", True), ("all", False),
                             ({"step": 0}, False), ({}, False)):
            things = [{"object": "mug_1", "yaw": yaw, "pose": "side"}]
            self.assertEqual(validator.is_valid({"things": things}), is_good, yaw)
            self.problem([], things=things)
            if is_good:
                self.trivet("arrange", "problem.json", "-o", "x.glb", status=(0, 1))
            else:
                self.refused("arrange", "problem.json", "-o", "x.glb", says="/arrange/things/0/yaw")
        for relation in good:
            self.assertTrue(validator.is_valid({"relations": [relation]}), relation)
            # Read without complaint: what ends it, if anything, is a conflict.
            self.problem([relation], attempts=1, evictions=0)
            self.trivet("arrange", "problem.json", "-o", "x.glb", status=(0, 1))
        os.remove(self.path("x.glb"))
        for relation, key in bad:
            relation = {**copy.deepcopy(relation), **({key: 1} if key else {})}
            self.assertFalse(validator.is_valid({"relations": [relation]}), relation)
            self.problem([relation])
            self.refused("arrange", "problem.json", "-o", "x.glb", says="/arrange/relations/0")

    def test_zones_and_solutions(self):
        self.problem([{"is": "on", "a": "*", "b": "floor"}, {"is": "in_front_of", "a": "mug_*", "b": "shelf"}],
                     zones={"shelf": [{"name": "reach", "box": [[-0.4, -0.5, 0.05], [0.4, -0.16, 0.7]]}]})
        self.trivet("arrange", "problem.json", "-o", "s{}.glb", "--report", "r{}.json", "--solutions", 3,
                    "--distinct", 0.2)
        scenes = {self.read("s%d.glb" % k) for k in (1, 2, 3)}
        self.assertEqual(len(scenes), 3)
        for k in (1, 2, 3):
            at = self.positions(self.read_json("r%d.json" % k))
            for name in ("mug_1", "mug_2"):
                self.assertFalse(abs(at[name][0]) < 0.43 and -0.54 < at[name][1] < -0.12, (k, at))
        self.trivet("arrange", "problem.json", "-o", "one.glb")
        self.assertEqual(self.read("one.glb"), self.read("s1.glb"))
        self.refused("arrange", "problem.json", "-o", "x.glb", "--solutions", 2, says="with {}")
        self.problem([], zones={"shelf": [{"name": "reach", "box": [[0, 0, 0], [1, 0, 1]]}]})
        self.refused("arrange", "problem.json", "-o", "x.glb", says="/arrange/zones/shelf/0/box")

    def test_a_thousand_relations_and_a_time_limit(self):
        self.problem([{"is": "within", "a": "mug_1", "region": [[0, 0], [1 + k / 1000, 0], [1, 1], [0, 1]]}
                      for k in range(1000)], things=[{"objects": "mug_*", "yaw": [0]}])
        out, _ = self.trivet("arrange", "problem.json", "-o", "a.glb")
        self.assertIn("1000 hard relations hold", out)
        out, _ = self.trivet("arrange", "problem.json", "-o", "b.glb", "--seconds", 1e-6, status=1)
        self.assertIn("did not end in time", out)

    def test_exported_demo(self):
        out, _ = self.trivet("demo", "bookcase", "-o", "a.glb", "--export", "demo", "--seed", 3)
        self.assertIn("arrange: done", out)
        self.trivet("arrange", "demo/problem.json", "-o", "b.glb", "--seed", 3, "--report", "b.json")
        self.trivet("demo", "bookcase", "-o", "c.glb", "--report", "c.json", "--seed", 3)
        self.assertEqual(self.positions(self.read_json("b.json")),
                         self.positions(self.read_json("c.json")))
        self.refused("demo", "breakfast", "-o", "x.glb", "--seed", 3, says="--seed")

    def test_recipes_of_demos(self):
        """Every arranged demo exports a recipe: scenes of a batch are arranged by seeds of their own."""
        for name in ("bookcase", "office3"):
            self.trivet("demo", name, "-o", "a.glb", "--export", name)
            self.trivet("batch", name + "/recipe.json", "--count", 2, "--out", name + "_batch", "--format", "poses")
            with open(glob.glob(self.path(name + "_batch/0000/*.jsonl"))[0]) as file:
                scenes = [json.loads(line) for line in file][:2]
            self.assertEqual([s["status"] for s in scenes], ["ok", "ok"])
            self.assertNotEqual(scenes[0]["objects"], scenes[1]["objects"])

    def test_published_schema_has_the_patterns_of_the_file_behind_the_relations(self):
        with open(os.path.join(SOURCE_DIR, "ops/files/arrange/arrange.schema.in.json")) as file:
            base = json.load(file)
        published = json.loads(self.trivet("schema", "arrange")[0])
        patterns = base["properties"]["relations"]["items"].pop("oneOf")
        kinds = published["properties"]["relations"]["items"].pop("oneOf")
        self.assertEqual(kinds[-len(patterns):], patterns)
        self.assertGreater(len(kinds), len(patterns) + 12)
        self.assertEqual(published, base)


if __name__ == "__main__":
    main()
