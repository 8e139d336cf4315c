"""Data sets of batches: trivet batch pictures --bop and --coco, in shards that are killed; and sets that grow.

TRIVET_SET_SCENES: so many scenes of household objects, of 160 x 120 pixels, with figures."""
import glob
import json
import math
import os
import signal
import subprocess
import sys
import time

from batches import BatchCase
from program import PROGRAM, SOURCE_DIR, box_obj, main
from set_readers import BopSet, CocoSet, calc_2d_bbox, group_of, pixels_of, projected, silhouette
from textured_boxes import png, textured_box_obj

SCENES = int(os.environ.get("TRIVET_SET_SCENES", "0"))
SHARDS = 3


def lathe_obj(profile, sides):
    """OBJ text of a closed surface of revolution about z: (radius, z) from below."""
    rings = [[(r * math.cos(2 * math.pi * i / sides), r * math.sin(2 * math.pi * i / sides), z) for i in range(sides)]
             for r, z in profile]
    points = [p for ring in rings for p in ring] + [(0, 0, profile[0][1]), (0, 0, profile[-1][1])]
    faces, low, high = [], len(points) - 1, len(points)
    for j in range(len(profile) - 1):
        for i in range(sides):
            a, b = j * sides + i + 1, j * sides + (i + 1) % sides + 1
            faces += [(a, b, b + sides), (a, b + sides, a + sides)]
    last = (len(profile) - 1) * sides
    for i in range(sides):
        j = (i + 1) % sides
        faces += [(low, j + 1, i + 1), (high, last + i + 1, last + j + 1)]
    return "".join("v %.7f %.7f %.7f\n" % p for p in points) + "".join("f %d %d %d\n" % f for f in faces)


class SetCase(BatchCase):
    """Sets of the folder "scenes", and what every one must hold."""
    NUM, SIZE = 7, (64, 48)

    def make(self, *arguments):
        self.trivet("batch", "pictures", "scenes", *arguments)

    def killed_shards(self, *arguments):
        """Each shard is killed once, then goes on."""
        folder = self.path(arguments[1])
        for shard in range(SHARDS):
            there = len(glob.glob(folder + "/*/0*"))
            command = [PROGRAM, "batch", "pictures", "scenes", *arguments, "--shard", "%d/%d" % (shard, SHARDS)]
            process = subprocess.Popen(command, cwd=self.folder, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
            while process.poll() is None and len(glob.glob(folder + "/*/0*")) == there:
                time.sleep(0.001)
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.assert_no_process_left()
            self.make(*arguments, "--shard", "%d/%d" % (shard, SHARDS))
        self.trivet("batch", "merge", arguments[1], "-o", "merged.jsonl")

    def scenes(self):
        return {row["k"]: row for row in self.merged("scenes")}

    def check_bop(self):
        """Makes a set in killed shards and checks it. Returns it, scenes that are ok, targets, pixels unlike own rays, and seconds."""
        start = time.monotonic()
        self.killed_shards("--bop", "bop")
        seconds = time.monotonic() - start
        self.make("--bop", "one", "--jobs", 1)
        self.assertEqual(self.hashes("bop"), self.hashes("one"))
        self.assertIn("0 findings", self.trivet("batch", "verify", "bop", "--scenes", "scenes", "--sample", 1 / self.NUM)[0])
        found = BopSet(self.path("bop"))
        ok = {k for k, row in self.scenes().items() if row["status"] == "ok"}
        self.assertGreater(len(ok), self.NUM // 2)
        self.assertEqual(found.scene_ids(), list(range(self.NUM)))
        counts = [self.check_scene(found, k, k in ok) for k in found.scene_ids()]
        return found, ok, sum(c[0] for c in counts), sum(c[1] for c in counts), seconds

    def check_scene(self, found, k, ok):
        """Returns the targets, and pixels of masks that are not those of own rays."""
        cameras, poses, infos = found.scene(k)
        self.assertEqual(list(poses), list(cameras))
        self.assertEqual(list(poses), list(infos))
        self.assertEqual(list(poses), [0, 1] if ok else [])
        scene = self.read_json("bop/train_pbr/%06d/%09d.json" % (k, k))
        ids = {m["name"]: i for i, m in found.models_info.items()}
        wanted = [ids[o["class"]] for o in scene["objects"] if o["position"] and group_of(o["name"]) in self.TARGETS]
        num, wrong = 0, 0
        for im_id in poses:
            self.assertEqual([p["obj_id"] for p in poses[im_id]], wanted)
            self.assertEqual(found.image(k, "rgb", im_id)[:3], (*self.SIZE, 3))
            depth = found.image(k, "depth", im_id)
            seen = set()
            for gt_id, (pose, info) in enumerate(zip(poses[im_id], infos[im_id])):
                visible = pixels_of(found.image(k, "mask_visib", im_id, gt_id))
                alone = pixels_of(found.image(k, "mask", im_id, gt_id))
                self.assertFalse(seen & set(visible))
                seen |= set(visible)
                self.assertTrue(set(visible) <= set(alone))
                self.assertTrue(all(depth[3][y * self.SIZE[0] + x] for x, y in visible))
                self.assertEqual(info["px_count_visib"], len(visible))
                self.assertEqual(info["px_count_valid"], len(alone))
                self.assertEqual(info["bbox_visib"], calc_2d_bbox(visible))
                if visible and info["px_count_all"] == len(alone):  # wholly in the picture
                    self.assertEqual(info["bbox_obj"], calc_2d_bbox(alone))
                self.assertAlmostEqual(info["visib_fract"], len(visible) / info["px_count_all"] if alone else 0)
                model = found.model(pose["obj_id"])
                corners = projected(cameras[im_id]["cam_K"], pose["cam_R_m2c"], pose["cam_t_m2c"], model["pts"])
                difference = silhouette(corners, model["faces"], *self.SIZE) ^ set(alone)
                self.assertLessEqual(len(difference), 1 + len(alone) // 1000)  # float32 of the PLY
                num, wrong = num + 1, wrong + len(difference)
        return num, wrong

    def check_coco(self):
        self.killed_shards("--coco", "coco")
        self.make("--coco", "one-coco", "--jobs", 2)
        self.assertEqual(self.hashes("coco"), self.hashes("one-coco"))
        found = CocoSet(self.path("coco"))
        ok = [k for k, row in self.scenes().items() if row["status"] == "ok"]
        targets = {i for i, c in found.cats.items() if c["name"] in self.target_classes()}
        self.assertEqual(sorted(found.imgs), list(range(2 * len(ok))))
        self.assertEqual([i["file_name"] for _, i in sorted(found.imgs.items())],
                         ["%06d/%06d.png" % (k, v) for k in ok for v in (0, 1)])
        self.assertEqual(sorted(found.anns), list(range(1, len(found.anns) + 1)))
        self.assertGreater(len(found.anns), 2 * len(ok))
        for image in found.imgs.values():
            self.assertEqual(found.picture(image)[:2], (image["width"], image["height"]))
            seen = set()
            for annotation in found.of_image[image["id"]]:
                mask = {(i % self.SIZE[0], i // self.SIZE[0]) for i, v in enumerate(found.mask(annotation)) if v}
                self.assertEqual(annotation["area"], len(mask))
                x, y, w, h = calc_2d_bbox(mask)
                self.assertEqual(annotation["bbox"], [x, y, w + 1, h + 1])
                self.assertFalse(seen & mask)
                seen |= mask
                self.assertIn(annotation["category_id"], targets)
                self.assertEqual(annotation["camera_from_object"][3], [0, 0, 0, 1])

        return found

    def target_classes(self):
        return {m["class"] for g in self.recipe["groups"] if g["name"] in self.TARGETS for m in g["models"]}


class Sets(SetCase):
    TARGETS = ("ycb", "mug")

    def setUp(self):
        super().setUp()
        self.write("can.obj", lathe_obj([(0.033, -0.05), (0.033, 0.05)], 24))
        self.write("mug.obj", lathe_obj([(0.03, -0.045), (0.04, 0.045)], 16))
        self.write("carton.obj", textured_box_obj(0.03, 0.02, 0.06))
        self.write("carton.mtl", "newmtl paper\nmap_Kd carton.png\n")
        self.write("carton.png", png(8, 8, lambda x, y: (255, 30 * x, 30 * y)))
        self.write("brick.obj", box_obj(0.05, 0.025, 0.0375))
        self.write("ball.obj", lathe_obj([(0.001, -0.03), (0.02, -0.022), (0.03, 0), (0.02, 0.022), (0.001, 0.03)], 12))
        quarter = [0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0.01, 0, 0, 0, 1]
        self.recipe = {"groups": [
            {"name": "ycb", "count": [3, 4], "on": "slab", "region": [[-0.3, -0.3], [0.3, 0.3]], "models": [
                {"model": "can.obj", "class": "can"}, {"model": "carton.obj", "class": "carton", "id": 9},
                {"model": "brick.obj", "class": "brick", "symmetries": {"discrete": [quarter]}}]},
            {"name": "junk", "count": 2, "on": "slab", "target": False, "scale_range": [0.5, 1.5],
             "models": [{"model": "ball.obj", "class": "ball"}]},
            {"name": "mug", "count": [0, 1], "on": "slab", "models": [{"model": "mug.obj", "class": "a mug"}]}],
            "accept": {"min_objects": 5},
            "views": {"width": self.SIZE[0], "height": self.SIZE[1], "samples": 1, "dome": {"count": 2}}}
        self.write_recipe(**self.recipe)

    def test_bop_in_killed_shards(self):
        self.batch("scenes", count=self.NUM)
        found, ok, num, _, _ = self.check_bop()
        self.check_models(found)
        self.assertGreaterEqual(num, 5 * len(ok))

    def check_models(self, found):
        self.assertEqual(sorted(found.models_info), [1, 2, 3, 9])  # in the recipe's order; 9 is given
        names = {i: m["name"] for i, m in found.models_info.items()}
        self.assertEqual(names, {1: "can", 2: "brick", 3: "a mug", 9: "carton"})
        can, brick, mug, carton = (found.models_info[i] for i in (1, 2, 3, 9))
        self.assertAlmostEqual(brick["diameter"], 2 * math.sqrt(50 ** 2 + 25 ** 2 + 37.5 ** 2), 3)
        self.assertAlmostEqual(can["size_z"], 100, 4)
        self.assertEqual(can["symmetries_continuous"][0]["axis"], [0, 0, 1])
        self.assertAlmostEqual(max(map(abs, can["symmetries_continuous"][0]["offset"])), 0, 3)
        self.assertEqual([round(v) for v in can["symmetries_discrete"][0]],
                         [1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1])
        self.assertIn("symmetries_continuous", mug)
        self.assertNotIn("symmetries_discrete", mug)  # it is wider above
        self.assertEqual(brick["symmetries_discrete"], [[0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 10, 0, 0, 0, 1]])
        self.assertFalse([key for key in carton if key.startswith("symm")])  # its image tells sides apart
        model = found.model(9)
        self.assertEqual(model["texture_file"], "obj_000009.png")
        self.assertEqual({(round(u), round(v)) for u, v in zip(model["texture_u"], model["texture_v"])},
                         {(0, 0), (0, 1), (1, 0), (1, 1)})
        self.assertTrue(os.path.exists(self.path("bop/models/obj_000009.png")))
        model = found.model(1)
        self.assertTrue({"nx", "ny", "nz", "red", "green", "blue"} <= set(model))
        for n in zip(model["nx"], model["ny"], model["nz"]):
            self.assertAlmostEqual(sum(v * v for v in n), 1, 4)

    def test_coco_in_killed_shards(self):
        self.batch("scenes", count=self.NUM)
        found = self.check_coco()
        self.assertEqual([(i, c["name"]) for i, c in sorted(found.cats.items())],
                         [(1, "a mug"), (2, "brick"), (3, "can"), (4, "carton"), (5, "ball"), (6, "slab")])
        self.assertGreater(len(found.anns), 4 * len(found.imgs) // 2)

    def test_labels_have_the_same_ids(self):
        self.batch("scenes", count=3)
        self.make("--out", "p", "--format", "dir")
        for name in glob.glob(self.path("p/0000/*/*.labels.json")):
            with open(name, encoding="utf-8") as file:
                labels = json.load(file)
            self.assertEqual([c["name"] for c in labels["classes"]], ["a mug", "brick", "can", "carton", "ball", "slab"])
            for o in labels["objects"]:
                self.assertEqual(o["target"], o["class"] not in ("ball", "slab"))
                self.assertEqual(o.get("model_id"), {"a mug": 3, "brick": 2, "can": 1, "carton": 9}.get(o["class"]))
                self.assertEqual(len(o["rotation"]), 4)

    def test_rooms_with_images_and_surfaces_of_groups(self):
        self.batch("scenes", count=3)
        self.write("floor.png", png(4, 4, lambda x, y: (250, 20, 20)))
        self.write("wall.png", png(4, 4, lambda x, y: (20, 20, 250)))
        self.recipe["views"]["dome"].update(around="targets", elevation_deg=[5, 15], min_pixels=1)
        self.recipe["views"]["look"] = {"room": {"floor_images": ["floor.png"], "wall_images": ["wall.png"]}}
        self.recipe["groups"][0]["look"] = {"roughness": [0.1, 0.9], "colour": [[0.1, 0.1, 0.1], [0.2, 0.2, 0.2]]}
        self.write_recipe("looks.json", **self.recipe)
        self.batch("again", count=3, recipe="looks.json")
        units = [{name: value for name, value in self.hashes(out).items() if name.startswith("0000")} for out in ("scenes", "again")]
        self.assertEqual(*units)
        for name in ("one", "two"):
            self.trivet("batch", "pictures", "again", "--bop", name, "--jobs", len(name))
        self.assertEqual(self.hashes("one"), self.hashes("two"))
        found = BopSet(self.path("one"))
        for k in found.scene_ids():
            for v in found.scene(k)[1]:
                data = found.image(k, "rgb", v)[3]
                red = sum(data[i] > data[i + 2] + 40 for i in range(0, len(data), 3))
                blue = sum(data[i + 2] > data[i] + 40 for i in range(0, len(data), 3))
                self.assertGreater(blue, 50)  # the wall, behind what is there
                self.assertGreater(red, 0)
                self.assertTrue(all(found.image(k, "depth", v)[3]))
        self.assertIn("0 findings", self.trivet("batch", "verify", "one", "--scenes", "again")[0])
        os.remove(self.path("floor.png"))
        self.refused("batch", "looks.json", "--count", 3, "--out", "more", says="floor.png")

    def test_given_classes_and_ids_change_no_scene(self):
        self.batch("scenes", count=3)
        self.recipe["classes"] = ["slab", "can", "brick", "carton", "ball", "a mug"]
        self.recipe["groups"][0]["models"][0]["id"] = 4
        self.write_recipe("other.json", **self.recipe)
        self.batch("again", count=3, recipe="other.json")
        same = {name: value for name, value in self.hashes("scenes").items() if name != "run.json"}
        self.assertEqual({name: value for name, value in self.hashes("again").items() if name != "run.json"}, same)
        self.trivet("batch", "pictures", "again", "--coco", "coco")
        self.assertEqual([c["name"] for c in CocoSet(self.path("coco")).cats.values()], self.recipe["classes"])

    def test_bad_input(self):
        self.batch("scenes", count=3)
        self.refused("batch", "pictures", "scenes", says="0 of --out, --bop and --coco")
        self.refused("batch", "pictures", "scenes", "--out", "a", "--bop", "b", says="2 of --out")
        self.recipe["groups"][1]["target"] = True
        self.write_recipe("sizes.json", **self.recipe)
        self.batch("sizes", count=3, recipe="sizes.json")
        self.refused("batch", "pictures", "sizes", "--bop", "b", says='the group "junk" has a scale_range')
        self.trivet("batch", "pictures", "sizes", "--coco", "c")


class Household(SetCase):
    """The recipe of household objects that is an example: apps/farm/examples/household.py."""
    NUM, SIZE = SCENES or 4, (160, 120) if SCENES else (64, 48)
    TARGETS = ("carton", "can", "bottle", "bowl", "dish", "fruit", "block")

    def setUp(self):
        super().setUp()
        script = os.path.join(SOURCE_DIR, "apps", "farm", "examples", "household.py")
        subprocess.run([sys.executable, script, self.folder], check=True)
        self.recipe = self.read_json("household.json")
        self.recipe["views"].update(width=self.SIZE[0], height=self.SIZE[1], samples=1)
        self.write_recipe("household.json", **self.recipe)
        self.batch("scenes", count=self.NUM, recipe="household.json")

    def test_sets_of_household_objects(self):
        found, ok, num, wrong, seconds = self.check_bop()
        self.assertEqual([m["name"] for _, m in sorted(found.models_info.items())],
                         [m["class"] for g in self.recipe["groups"] if g["name"] in self.TARGETS for m in g["models"]])
        self.assertGreater(num, 5 * len(ok))
        coco = self.check_coco()
        self.assertEqual(len(coco.imgs), 2 * len(ok))
        self.assertEqual(sorted(c["name"] for c in coco.cats.values()), sorted(self.target_classes() | {"peg", "table"}))
        self.check_masses(ok)
        if SCENES:
            files = self.hashes("bop")
            size = sum(os.path.getsize(self.path("bop/" + f)) for f in files)
            print("bop: %d scenes, %d views, %d targets, %d pixels of masks differ from own rays, %d files, %.1f MB, %.0f s"
                  % (len(ok), 2 * len(ok), num, wrong, len(files), size / 1e6, seconds))

    def check_masses(self, ok):
        """Kilograms and friction are in the ranges of their class."""
        ranges = {m["class"]: m for g in self.recipe["groups"] for m in g["models"] if "mass" in m}
        judged = 0
        for k in ok:
            for o in self.read_json("bop/train_pbr/%06d/%09d.json" % (k, k))["objects"]:
                model = ranges.get(o["class"])
                if model and o["position"]:
                    low, high = model["mass"]
                    self.assertTrue(low <= o["kilograms"] <= high, o)
                    low, high = model["material"]["friction"]
                    self.assertTrue(low <= o["material"]["friction"] <= high, o)
                    judged += 1
        self.assertGreater(judged, 5 * len(ok))


class GrowingSets(BatchCase):
    """trivet render --bop, --coco into a set that is there."""

    def scene(self, name, model, **more):
        self.write(name + ".json", json.dumps({"trivet": 1, "objects": [
            {"name": "slab", "model": "slab.obj", "fixed": True, "position": [0, 0, 0.06]},
            {"name": "one", "model": model, **more}], "operations": [
                {"op": "put", "object": "one", "position": [0, 0, 0.5]}]}))
        self.trivet("run", name + ".json", "-o", name + ".glb")

    def setUp(self):
        super().setUp()
        self.scene("a", "cube.obj")
        self.write("brick.obj", box_obj(0.05, 0.025, 0.0375))
        self.scene("b", "brick.obj")

    def render(self, scene, *arguments, status=0):
        return self.trivet("render", scene + ".glb", "--width", 32, "--height", 24, "--samples", 1, *arguments,
                           status=status)

    def test_bop_appends(self):
        for scene in ("a", "b", "a"):
            self.render(scene, "--dome", 2, "--bop", "set")
        found = BopSet(self.path("set"), "")
        self.assertEqual(found.scene_ids(), [0, 1, 2])
        self.assertEqual([found.scene(k)[1][1][0]["obj_id"] for k in range(3)], [1, 2, 1])
        self.assertEqual([len(found.scene(0)[1][v]) for v in (0, 1)], [1, 1])  # the slab is fixed: no target
        self.assertEqual(sorted(found.models_info), [1, 2])
        self.assertEqual(self.read("set/000000/scene_gt.json"), self.read("set/000002/scene_gt.json"))

    def test_coco_appends(self):
        before = None
        for scene in ("b", "a", "b"):
            self.render(scene, "--dome", 2, "--coco", "set")
            now = self.read_json("set/annotations.json")
            if before:
                self.assertEqual(now["images"][:len(before["images"])], before["images"])
                self.assertEqual(now["categories"][:len(before["categories"])], before["categories"])
            before = now
        found = CocoSet(self.path("set"))
        self.assertEqual({i: c["name"] for i, c in found.cats.items()}, {1: "brick", 2: "slab", 3: "cube"})
        self.assertEqual(sorted(found.imgs), list(range(6)))
        self.assertEqual([a["category_id"] for a in found.anns.values()], [1, 1, 3, 3, 1, 1])
        self.assertEqual(len(glob.glob(self.path("set/images/*.png"))), 6)

    def test_other_files_are_not_taken_for_sets(self):
        for text in ("{}", "[", '{"images": [{"id": -1}], "categories": [], "annotations": []}',
                     '{"images": [], "categories": [{"id": 7, "name": "x"}], "annotations": []}',
                     '{"images": [{"id": 1e300}], "categories": [], "annotations": []}'):
            self.write("set/annotations.json", text)
            self.assertIn("annotations.json", self.render("a", "--coco", "set", status=2)[1])
            self.assertEqual(self.read("set/annotations.json").decode(), text)
        for text in ("[]", '{"x": {}}', '{"-1": 3}'):
            self.write("set/models/models_info.json", text)
            self.assertIn("models_info.json", self.render("a", "--bop", "set", status=2)[1])


if __name__ == "__main__":
    main()
