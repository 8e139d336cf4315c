"""The first hour of two new users, as the guide has it: a robotics engineer, and one who trains vision models.

TRIVET_FIRST_HOUR: so many scenes instead of a few."""
import json
import os
import re
import shlex

from batches import BatchCase
from program import SOURCE_DIR, box_obj, main
from set_readers import BopSet, CocoSet

NUM = int(os.environ.get("TRIVET_FIRST_HOUR", "4"))


def commands(page):
    """Lines of the page's blocks of code that call the program, as lists of words."""
    with open(os.path.join(SOURCE_DIR, "docs", "guide", page), encoding="utf-8") as file:
        lines = file.read().replace("\\\n", " ").splitlines()
    return [shlex.split(line)[1:] for line in lines if re.match(r" *trivet ", line)]


class FirstHours(BatchCase):
    def follow(self, page, *begins, status=(0, 1)):
        """Runs the page's commands that begin so, with few scenes."""
        done = 0
        for words in commands(page):
            if words[:len(begins)] != list(begins):
                continue
            if "--count" in words:
                words[words.index("--count") + 1] = str(NUM)
            self.trivet(*words, status=status)
            done += 1
        self.assertGreater(done, 0, page)

    def test_a_robotics_engineer(self):
        """The demo's table, laid anew in every scene, as files for simulators."""
        self.trivet("demo", "breakfast", "-o", "breakfast.glb", "--export", ".", "--quiet")
        with open(os.path.join(SOURCE_DIR, "apps", "farm", "examples", "breakfast.json"), encoding="utf-8") as file:
            self.write("recipe.json", file.read())
        self.follow("data-sets.md", "batch", "recipe.json")
        self.assertIn("%d of %d" % (NUM, NUM), self.trivet("batch", "status", "scenes")[0])
        self.follow("data-sets.md", "batch", "export")
        status = self.trivet("batch", "status", "files")[0]
        self.assertIn("%d of %d" % (NUM, NUM), status)
        rows = self.merged("files")
        ok = [row["k"] for row in rows if row["status"] == "ok"]
        self.assertGreaterEqual(len(ok), 0.99 * sum(row["status"] == "ok" for row in self.merged("scenes")))
        for k in ok:
            for ending in (".xml", ".sdf", ".usda"):
                self.assertTrue(os.path.exists(self.path("files/0000/scenes-%06d/%09d%s" % (k // 20, k, ending))))
        self.trivet("batch", "materialise", "scenes", ok[0], "-o", "one.glb")
        self.trivet("check", "one.glb")
        self.trivet("export", "one.glb", "-o", "one.csv")
        os.mkdir(self.path("below"))
        self.trivet("export", "one.glb", "-o", "below/one.xml", "--meshes", "shared", "--quiet")
        self.assertEqual(sorted(os.listdir(self.path("below"))), ["one.xml", "shared"])
        self.assertFalse(os.path.exists(self.path("shared")))
        # A hovering object is unsupported, in reports and in notes of exports alike.
        self.write("air.json", json.dumps({"trivet": 1, "objects": [{"name": "a", "model": "apple.glb", "position": [0, 0, 1]}]}))
        self.trivet("run", "air.json", "-o", "air.glb", "--report", "air-report.json", status=1)
        self.assertEqual(self.read_json("air-report.json")["objects"][0]["state"], "unsupported")
        self.trivet("export", "air.glb", "-o", "air.xml", "--report", "notes.json")
        self.assertIn('"a" is unsupported: it will move', self.read_json("notes.json")["notes"])

    def test_one_who_trains_vision_models(self):
        """Models of their own, a table, distractors, and another light in every scene."""
        self.write("box.obj", box_obj(0.05, 0.03, 0.02))
        self.write("brick.obj", box_obj(0.03, 0.03, 0.05))
        self.write_recipe(groups=[
            {"name": "thing", "count": [2, 4], "on": "slab",
             "models": [{"model": "box.obj", "class": "carton", "mass": [0.1, 0.2], "material": {"friction": [0.3, 0.6]}},
                        {"model": "brick.obj", "collision": "brick.obj"}]},
            {"name": "clutter", "models": [{"model": "cube.obj"}], "count": 2, "on": "slab", "target": False,
             "scale_range": [0.3, 0.6]}],
            views={"width": 64, "height": 48, "samples": 1,
                   "dome": {"count": 2, "around": "targets", "fov_deg": [25, 40], "roll_deg": [-20, 20]},
                   "look": {"key": {"azimuth_deg": [0, 360], "elevation_deg": [30, 80], "temperature": [2700, 7500]},
                            "floor": [[0.2, 0.2, 0.2], [0.9, 0.8, 0.7]], "exposure": [0.8, 1.2], "noise": [0, 0.02]}})
        self.follow("data-sets.md", "batch", "recipe.json")
        self.follow("data-sets.md", "batch", "pictures")
        bop, coco = BopSet(self.path("set")), CocoSet(self.path("set2"))
        self.assertEqual({m["name"] for m in bop.models_info.values()}, {"carton", "brick"})
        self.assertEqual([c["name"] for c in coco.cats.values()], ["brick", "carton", "cube", "slab"])
        views = [(k, v, gts) for k in bop.scene_ids() for v, gts in bop.scene(k)[1].items()]
        self.assertEqual(len(views), len(coco.imgs))
        self.assertTrue(all(2 <= len(gts) <= 4 for _, _, gts in views))
        # Cameras look at the targets: most are seen whole.
        shares = [info["visib_fract"] for k in bop.scene_ids() for infos in bop.scene(k)[2].values() for info in infos]
        self.assertGreater(sum(share > 0.5 for share in shares), 0.7 * len(shares))
        # Each scene has a light and floor of its own.
        means = {k: sum(bop.image(k, "rgb", 0)[3]) // (64 * 48) for k in bop.scene_ids() if bop.scene(k)[1]}
        self.assertGreater(len(set(means.values())), len(means) // 2)
        self.assertIn("0 findings", self.trivet("batch", "verify", "set", "--scenes", "scenes")[0])
        cartons = [o for k in range(NUM) for o in self.scene(k)["objects"] if o.get("class") == "carton"]
        for carton in cartons:
            self.assertTrue(0.1 <= carton["kilograms"] <= 0.2 and 0.3 <= carton["material"]["friction"] <= 0.6, carton)
            self.assertTrue(carton["position"] is None or carton["supports"], carton)
        for row in self.merged("scenes"):
            self.assertEqual(sum(row["classes"].values()), row["objects"])
        self.other_looks(means)

    def scene(self, k):
        return json.loads(self.trivet("batch", "recipe.json", "--count", NUM, "--seed", 7, "--only", k)[0])

    def other_looks(self, means):
        """The same scenes by lamps through a lens, and in surroundings of a Radiance file."""
        sky = b"".join(bytes((40, 60, 120, 129)) if y < 4 else bytes((60, 50, 40, 128)) for y in range(8) for x in range(16))
        self.write("sky.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n" + sky)
        for name, look in (("lamps", {"lamps": {"kind": ["sun", "bulb", "panel"], "count": [1, 3], "temperature": [2500, 9000]},
                                      "lens": {"f_number": [1, 4]}}), ("sky", {"environments": ["sky.hdr"]}),
                           ("all", {"environments": ["sky.hdr"], "environment_turn_deg": [-30, 30], "key": {"strength": [0.3, 0.6]},
                                    "lamps": {"kind": "panel", "strength": [0.3, 0.6]}})):
            self.write(name + ".json", json.dumps({"views": {"width": 64, "height": 48, "samples": 1, "dome": {"count": 1},
                                                             "look": look}}))
            self.trivet("batch", "pictures", "scenes", "--views", name + ".json", "--bop", name, "--quiet")
            bop = BopSet(self.path(name))
            shown = {k: sum(bop.image(k, "rgb", 0)[3]) // (64 * 48) for k in bop.scene_ids() if bop.scene(k)[1]}
            self.assertEqual(sorted(shown), sorted(means))
            self.assertTrue(all(shown[k] > 0 for k in shown), shown)
            if name == "all":  # lamps and key lamp beside the same sky
                self.assertTrue(all(shown[k] > before[k] for k in shown), (before, shown))
            before = shown
        self.write("none.json", json.dumps({"views": {"look": {"environments": ["none.hdr"]}}}))
        self.trivet("batch", "pictures", "scenes", "--views", "none.json", "--bop", "none", status=2)


if __name__ == "__main__":
    main()
