"""Objects that are judged by another mesh than the one that is drawn: in layouts, scene files, exports and batches."""
import json
import re
import shutil
import xml.etree.ElementTree as ElementTree

from batches import BatchCase
from program import SLAB, box_obj, main

# A thin cross is drawn; its box, 10 cm wide and 6 cm high, is judged.
BALL = {"name": "ball", "model": "cross.obj", "collision": "box.obj"}
PUT = [{"op": "put", "object": "ball", "position": [0.1, 0.1, 1]}]


class CollisionMeshes(BatchCase):
    def setUp(self):
        super().setUp()
        self.write("cross.obj", box_obj(0.002, 0.05, 0.03) + "".join(
            "f %d %d %d\n" % tuple(8 + int(v) for v in line.split()[1:]) if line[0] == "f" else line + "\n"
            for line in box_obj(0.05, 0.002, 0.03).splitlines()))
        self.write("box.obj", box_obj(0.05, 0.05, 0.06))

    def laid_out(self, name="scene.glb"):
        self.trivet("run", self.layout([SLAB, BALL], PUT), "-o", name, "--report", "report.json")
        return [o for o in self.read_json("report.json")["objects"] if o["name"] == "ball"][0]

    def test_it_rests_and_weighs_as_what_is_judged(self):
        ball = self.laid_out()
        self.assertAlmostEqual(ball["centre_of_mass"][2], 0.1 + 0.06, places=4)
        self.assertEqual(ball["triangles"], 12)
        self.assertAlmostEqual(ball["kilograms"], 0.1 * 0.1 * 0.12 * 1000, places=6)

    def test_a_scene_file_keeps_both(self):
        self.laid_out()
        for name in ("cross.obj", "box.obj"):
            shutil.move(self.path(name), self.path("gone-" + name))
        self.trivet("check", "scene.glb")
        self.trivet("push", "scene.glb", "ball", "--direction", 1, 0, "--distance", 0.05, "-o", "pushed.glb")
        self.trivet("check", "pushed.glb")
        drawn = self.read("scene.glb")
        header = json.loads(drawn[20:20 + int.from_bytes(drawn[12:16], "little")])
        counts = [header["accessors"][primitive["indices"]]["count"]
                  for mesh in header["meshes"] for primitive in mesh["primitives"]]
        self.assertEqual(sorted(counts), [36, 72], "the cross of 24 triangles is drawn")

    def test_objects_of_one_model_may_be_judged_by_several(self):
        plain = {"name": "plain", "model": "cross.obj"}
        puts = PUT + [{"op": "put", "object": "plain", "position": [-0.2, -0.2, 1]}]
        self.trivet("run", self.layout([SLAB, BALL, plain], puts), "-o", "two.glb", "--report", "report.json")
        self.trivet("check", "two.glb")
        heights = {o["name"]: o["centre_of_mass"][2] for o in self.read_json("report.json")["objects"]}
        self.assertAlmostEqual(heights["plain"], 0.13, places=4)
        self.assertAlmostEqual(heights["ball"], 0.16, places=4)
        self.trivet("export", "two.glb", "-o", "two.xml")
        root = ElementTree.fromstring(self.read("two.xml"))
        parts = {body.get("name"): len([g for g in body.iter("geom") if g.get("class") == "collision"]) for body in root.iter("body")}
        self.assertEqual((parts["ball"], parts["plain"]), (1, 2))

    def test_an_export_draws_one_and_lets_the_other_collide(self):
        self.laid_out()
        self.trivet("export", "scene.glb", "-o", "scene.urdf")
        link = [l for l in ElementTree.fromstring(self.read("scene.urdf")).iter("link") if l.get("name") == "ball"][0]
        sizes = {kind: [self.read(mesh.get("filename")).count(b"\nf ") for mesh in part.iter("mesh")]
                 for kind in ("visual", "collision") for part in link.iter(kind)}
        self.assertEqual(sizes["visual"], [24])
        self.assertEqual(sizes["collision"], [12])

    def test_a_recipe_has_them_too(self):
        self.write_recipe(groups=[{"name": "thing", "count": 2, "on": "slab",
                                   "models": [{"model": "cross.obj", "collision": "box.obj"}]}])
        self.batch("out", count=2)
        self.trivet("batch", "verify", "out")
        scene = json.loads(self.trivet("batch", "recipe.json", "--count", 2, "--only", 1)[0])
        things = [o for o in scene["objects"] if o["name"].startswith("thing")]
        for thing in things:
            self.assertTrue(re.fullmatch("models/[0-9a-f]{64}/box.obj", thing["collision"]), thing)
            self.assertAlmostEqual(thing["position"][2], 0.16, places=4)
        self.trivet("batch", "materialise", "out", 1, "-o", "one.glb")
        self.trivet("check", "one.glb")
        self.trivet("batch", "export", "out", "--out", "files", "--as", "mjcf", "--quiet")
        self.assertIn("units: 1 of 1", self.trivet("batch", "status", "files")[0])

    def test_wrong_ones(self):
        self.refused("run", self.layout([SLAB, {**BALL, "collision": 3}], PUT), "-o", "a.glb", says="/objects/1/collision")
        self.refused("run", self.layout([SLAB, {**BALL, "collision": "none.obj"}], PUT), "-o", "a.glb",
                     says="/objects/1/collision")
        self.refused("run", self.layout([SLAB, {**BALL, "collision": "box.obj"}], PUT), "-o", "box.obj", says="box.obj")


if __name__ == "__main__":
    main()
