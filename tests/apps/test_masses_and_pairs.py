"""Masses that a layout gives, and rules for pairs: in what is judged, in files, in errors."""
import json
import unittest

from program import SLAB, Case, main, put

OVER_THE_EDGE = {"name": "a", "model": "cube.obj", "position": [0.52, 0, 0.150002]}
INSIDE = {"name": "b", "model": "cube.obj", "position": [0.05, 0, 0.150002]}
BESIDE = {"name": "a", "model": "cube.obj", "position": [0, 0, 0.150002]}


class Masses(Case):
    def test_the_centre_decides_over_an_edge(self):
        self.trivet("check", self.layout([SLAB, OVER_THE_EDGE]), status=1)
        given = {**OVER_THE_EDGE, "mass": {"kilograms": 2, "centre": [-0.04, 0, 0]}}
        layout = self.layout([SLAB, given])
        self.trivet("check", layout)
        self.trivet("run", layout, "-o", "scene.glb", "--report", "report.json")
        self.trivet("check", "scene.glb")
        a = [o for o in self.read_json("report.json")["objects"] if o["name"] == "a"][0]
        self.assertEqual(a["mass"], {"kilograms": 2, "centre": [-0.04, 0, 0]})
        self.trivet("export", "scene.glb", "-o", "scene.xml")
        self.assertIn(b'mass="2"', self.read("scene.xml"))

    def test_a_mass_alone_is_weight(self):
        self.trivet("run", self.layout([SLAB, {**BESIDE, "mass": 3}]), "-o", "scene.glb")
        answer = json.loads(self.trivet("check", "scene.glb", "--json")[0])
        weights = {o["name"]: o["weight"] for o in answer["stability"]["objects"]}
        self.assertAlmostEqual(weights["a"], 3 * 9.80665, places=9)

    def test_a_copy_has_the_mass(self):
        layout = self.layout([SLAB, {**BESIDE, "mass": {"kilograms": 3, "centre": [0.01, 0, 0]}}],
                             [{"op": "duplicate", "object": "a", "as": "b"}, put("b", 0.2, 0, 1)])
        self.trivet("run", layout, "-o", "scene.glb", "--report", "report.json")
        masses = {o["name"]: o.get("mass") for o in self.read_json("report.json")["objects"]}
        self.assertEqual(masses["b"], {"kilograms": 3, "centre": [0.01, 0, 0]})
        answer = json.loads(self.trivet("check", "scene.glb", "--json")[0])
        weights = {o["name"]: o["weight"] for o in answer["stability"]["objects"]}
        self.assertAlmostEqual(weights["b"], 3 * 9.80665, places=9)

    def test_wrong_masses(self):
        for mass, says in ((0, "/objects/1/mass"), ({"centre": [0, 0, 0]}, "kilograms"),
                           ({"kilograms": 1, "inertia": [1, 1, 10, 0, 0, 0]}, "/objects/1/mass")):
            self.refused("check", self.layout([SLAB, {**BESIDE, "mass": mass}]), says=says)


class Pairs(Case):
    def test_they_may_pass(self):
        objects = [SLAB, BESIDE, INSIDE]
        self.trivet("check", self.layout(objects), status=1)
        layout = self.layout(objects, pairs=[{"objects": ["b", "a"], "may_pass": True}])
        self.trivet("check", layout)
        self.trivet("run", layout, "-o", "scene.glb")
        self.trivet("check", "scene.glb")

    def test_rules_for_others_do_not_count(self):
        self.trivet("check", self.layout([SLAB, BESIDE, INSIDE], pairs=[{"objects": ["b", "floor"], "may_pass": True}]),
                    status=1)

    def test_wrong_pairs(self):
        for pair, says in ({"objects": ["a", "a"]}, "/pairs/0/objects/1"), ({"objects": ["a"]}, "/pairs/0/objects"), \
                ({"objects": ["a", "b"], "friction": -1}, "/pairs/0/friction"):
            self.refused("check", self.layout([SLAB, BESIDE, INSIDE], pairs=[pair]), says=says)


if __name__ == "__main__":
    main()
