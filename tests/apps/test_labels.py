"""Labelled images, written and read back. Their content is tested in tests/raster/labels."""
import json
import math
import os

from label_files import decoded_mask, read_exr, read_png
from program import Case, main

W, H = 96, 64
SIZE = ("--width", W, "--height", H)
CAMERA = ("--camera", 0.3, -0.9, 0.5, 0, 0, 0.05, "--fov", 40)
FLOOR = 65535


def floats(values, digits=6):
    return [round(v, digits) for v in values]


class Labels(Case):
    def setUp(self):
        super().setUp()
        layout = {"trivet": 1, "objects": [
            {"name": "slab", "model": "slab.obj", "scale": 0.5, "fixed": True,
             "position": [0, 0, 0.03], "class": "table"},
            {"name": "one", "model": "cube.obj", "position": [0.05, -0.1, 0.2],
             "class": "die", "attributes": {"colour": "red", "sides": 6}},
            {"name": "two", "model": "cube.obj"},
            {"name": "out", "model": "cube.obj"}],
            "operations": [{"op": "put", "object": "two", "position": [-0.1, 0, 0.5]},
                           {"op": "put", "object": "one", "position": [0.05, -0.1, 0.5]}]}
        layout["objects"][1].pop("position")
        self.write("l.json", json.dumps(layout))
        self.trivet("run", "l.json", "-o", "s.glb")

    def png(self, name):
        width, height, channels, values = read_png(self.read(name))
        self.assertEqual((width, height), (W, H))
        return values if channels == 1 else [values[i:i + channels]
                                             for i in range(0, len(values), channels)]

    def exr(self, name):
        return read_exr(self.read(name))

    def test_all_files_of_a_view(self):
        self.trivet("render", "s.glb", *SIZE, *CAMERA, "--depth", "d.exr", "--ids", "i.png",
                    "--classes", "c.png", "--normals", "n.exr", "--boxes", "b.json", "--visibility")
        depth, ids, classes = self.exr("d.exr")["Z"], self.png("i.png"), self.png("c.png")
        normals, boxes = self.exr("n.exr"), self.read_json("b.json")
        self.assertEqual(set(ids) - {0}, {1, 2, 3, FLOOR})
        self.assertEqual([o["name"] for o in boxes["objects"]], ["slab", "one", "two"])
        self.assertEqual([c["name"] for c in boxes["classes"]], ["cube", "die", "table"])
        self.assertEqual(boxes["objects"][1]["attributes"], {"colour": "red", "sides": 6})
        for instance, wanted in ((1, 3), (2, 2), (3, 1), (FLOOR, 0)):
            self.assertEqual({c for c, i in zip(classes, ids) if i == instance}, {wanted})
        for i, instance in enumerate(ids):
            n = [normals[c][i] for c in "XYZ"]
            self.assertEqual(depth[i] > 0, instance != 0)
            self.assertAlmostEqual(sum(v * v for v in n), 1 if instance else 0, 5)
        for o in boxes["objects"]:
            at = [i for i, v in enumerate(ids) if v == o["instance"]]
            xs, ys = [i % W for i in at], [i // W for i in at]
            self.assertEqual(o["box_visible"], [min(xs), min(ys), max(xs) - min(xs) + 1,
                                                max(ys) - min(ys) + 1])
            self.assertEqual(o["pixels_visible"], len(at))
            self.assertLessEqual(o["pixels_visible"], o["pixels_alone"])
            self.assertLessEqual(o["visible_share"], 1)
        self.check_depth_by_camera(boxes["camera"], ids, depth)

    def check_depth_by_camera(self, camera, ids, depth):
        """Points of the floor, back in the world, are at height 0."""
        k, m, num = camera["K"], camera["camera_from_world"], 0
        for i, instance in enumerate(ids):
            if instance != FLOOR:
                continue
            x, y, z = i % W, i // W, depth[i]
            p = [(x - k[0][2]) / k[0][0] * z, (y - k[1][2]) / k[1][1] * z, z]
            q = [p[r] - m[r][3] for r in range(3)]
            self.assertAlmostEqual(sum(m[r][2] * q[r] for r in range(3)), 0, 5)
            num += 1
        self.assertGreater(num, 100)

    def test_png_depth_and_normals(self):
        self.trivet("render", "s.glb", *SIZE, *CAMERA, "--depth", "d.png", "--normals", "n.png",
                    "--depth-unit", 0.0001)
        self.trivet("render", "s.glb", *SIZE, *CAMERA, "--depth", "d.exr", "--normals", "n.exr")
        depth, exact = self.png("d.png"), self.exr("d.exr")["Z"]
        normals, exact_normals = self.png("n.png"), self.exr("n.exr")
        for i, z in enumerate(exact):
            if z <= 6.5535:
                self.assertEqual(depth[i], math.floor(z / 0.0001 + 0.5))
            if z > 0:
                for c, v in zip("XYZ", normals[i]):
                    self.assertAlmostEqual((v - 32767) / 32767, exact_normals[c][i], 4)

    def test_far_depths_are_noted(self):
        _, err = self.trivet("render", "s.glb", *SIZE, *CAMERA, "--depth", "d.png",
                             "--depth-unit", 1e-5)
        self.assertIn("--depth-unit", err)
        self.assertIn(0, self.png("d.png"))

    def test_camera_from_a_file_as_written(self):
        self.trivet("render", "s.glb", *SIZE, *CAMERA, "--depth", "d.exr", "--boxes", "b.json")
        camera = self.read_json("b.json")["camera"]
        aimed = {"name": "aimed", "eye": [0.3, -0.9, 0.5], "target": [0, 0, 0.05], "fov_deg": 40}
        self.write("cams.json", json.dumps({"cameras": [camera, dict(aimed, width=W, height=H)]}))
        self.trivet("render", "s.glb", "--cameras", "cams.json", "--depth", "d_{}.exr")
        self.assertEqual(self.read("d_aimed.exr"), self.read("d.exr"))
        one, two = self.exr("d_000000.exr")["Z"], self.exr("d.exr")["Z"]
        self.assertEqual(floats(one, 5), floats(two, 5))

    def test_a_dome_is_reproducible(self):
        for name, seed in (("a", 7), ("b", 7), ("c", 8)):
            self.trivet("render", "s.glb", *SIZE, "--dome", 3, "--dome-seed", seed,
                        "--dome-elevation", 20, 60, "--boxes", name + "{}.json")
        for i in range(3):
            self.assertEqual(self.read("a%06d.json" % i), self.read("b%06d.json" % i))
            self.assertNotEqual(self.read("a%06d.json" % i), self.read("c%06d.json" % i))
            labels = self.read_json("a%06d.json" % i)
            for o in labels["objects"]:
                x, y, w, h = o["box_whole"]
                self.assertTrue(0 <= x and x + w <= W and 0 <= y and y + h <= H)
            m = labels["camera"]["camera_from_world"]
            height = -m[2][2]  # of the direction from the scene to the camera
            self.assertTrue(math.sin(math.radians(20)) - 1e-9 <= height <= math.sin(math.radians(60)))

    def test_same_bytes_for_any_number_of_threads(self):
        for threads in (1, 2, 5):
            self.trivet("render", "s.glb", *SIZE, *CAMERA, "--threads", threads, "--depth",
                        "d%d.exr" % threads, "--ids", "i%d.png" % threads, "--boxes",
                        "b%d.json" % threads, "--visibility")
        for name in ("d%d.exr", "i%d.png", "b%d.json"):
            self.assertEqual(self.read(name % 1), self.read(name % 2))
            self.assertEqual(self.read(name % 1), self.read(name % 5))

    def test_coco(self):
        self.trivet("render", "s.glb", *SIZE, "--dome", 2, "--coco", "set", "--ids", "i{}.png")
        coco = self.read_json("set/annotations.json")
        self.assertEqual([i["id"] for i in coco["images"]], [0, 1])
        names = {c["id"]: c["name"] for c in coco["categories"]}
        num = 0
        for image in coco["images"]:
            ids = self.png("i%06d.png" % image["id"])
            seen = [a for a in coco["annotations"] if a["image_id"] == image["id"]]
            self.assertEqual({a["instance"] for a in seen}, set(ids) - {0, FLOOR, 1})  # the slab is fixed
            for a in seen:
                mask = decoded_mask(a["segmentation"])
                self.assertEqual(mask, [int(i == a["instance"]) for i in ids])
                self.assertEqual(a["area"], sum(mask))
                x, y, w, h = a["bbox"]
                inside = [(i % W, i // W) for i, v in enumerate(mask) if v]
                self.assertEqual([x, y, x + w - 1, y + h - 1],
                                 [min(i for i, _ in inside), min(j for _, j in inside),
                                  max(i for i, _ in inside), max(j for _, j in inside)])
                self.assertEqual(names[a["category_id"]],
                                 {1: "table", 2: "die", 3: "cube"}[a["instance"]])
                num += 1
        self.assertGreaterEqual(num, 3)
        self.assertEqual(len({a["id"] for a in coco["annotations"]}), num)

    def test_bop(self):
        self.trivet("render", "s.glb", *SIZE, "--dome", 2, "--bop", "set", "--ids", "i{}.png",
                    "--depth", "d{}.exr")
        cameras = self.read_json("set/000000/scene_camera.json")
        poses = self.read_json("set/000000/scene_gt.json")
        infos = self.read_json("set/000000/scene_gt_info.json")
        models = self.read_json("set/models/models_info.json")
        self.assertEqual(sorted(models), ["1"])  # the slab is fixed, and no target
        self.assertAlmostEqual(models["1"]["diameter"], 100 * math.sqrt(3), 3)
        self.assertEqual(self.read("set/models/obj_000001.ply")[:3], b"ply")
        for view in ("0", "1"):
            ids = self.png("i%06d.png" % int(view))
            self.assertEqual([p["obj_id"] for p in poses[view]], [1, 1])
            depth = self.png("set/000000/depth/%06d.png" % int(view))
            scale, exact = cameras[view]["depth_scale"], self.exr("d%06d.exr" % int(view))["Z"]
            for d, z in zip(depth, exact):
                if z < 65:
                    self.assertAlmostEqual(d * scale / 1000, z, 3)
            for k, (pose, info) in enumerate(zip(poses[view], infos[view])):
                visible = self.png("set/000000/mask_visib/%06d_%06d.png" % (int(view), k))
                alone = self.png("set/000000/mask/%06d_%06d.png" % (int(view), k))
                self.assertEqual(visible, tuple(255 * (i == k + 2) for i in ids))
                self.assertTrue(all(a or not v for a, v in zip(alone, visible)))
                self.assertEqual(info["px_count_visib"], sum(v > 0 for v in visible))
                self.assertEqual(info["px_count_valid"], sum(v > 0 for v in alone))
                self.check_pose(cameras[view], pose, models[str(pose["obj_id"])], info)

    def check_pose(self, camera, pose, model, info):
        """The corners of the model's box, by its pose and the camera, have the box of the view."""
        r, t, k, points = pose["cam_R_m2c"], pose["cam_t_m2c"], camera["cam_K"], []
        for i in range(8):
            p = [model["min_" + c] + (model["size_" + c] if i >> b & 1 else 0)
                 for b, c in enumerate("xyz")]
            q = [sum(r[3 * row + c] * p[c] for c in range(3)) + t[row] for row in range(3)]
            points.append((k[0] * q[0] / q[2] + k[2], k[4] * q[1] / q[2] + k[5]))
        x, y, w, h = info["bbox_obj"]
        box = [math.ceil(min(p[0] for p in points)), math.ceil(min(p[1] for p in points)),
               math.floor(max(p[0] for p in points)), math.floor(max(p[1] for p in points))]
        for ours, corner in zip([x, y, x + w, y + h], box):  # a tip may be on no pixel's centre
            self.assertLessEqual(abs(ours - corner), 1)

    def test_labels_follow_names_but_not_refusals(self):
        layout = self.read_json("l.json")
        layout["objects"][2] |= {"class": "stone", "attributes": {"sides": 1}}
        layout["operations"] += [
            {"op": "rename", "object": "one", "to": "uno"},
            {"op": "duplicate", "object": "uno", "as": "one"},
            {"op": "put", "object": "one", "position": [0.1, 0.3, 0.5]},
            {"op": "lock", "object": "slab"},
            {"op": "delete", "object": "slab"},                    # refused: it is locked,
            {"op": "rename", "object": "two", "to": "slab"}]       # so that the name is taken
        self.write("l.json", json.dumps(layout))
        self.trivet("run", "l.json", "-o", "t.glb", status=1)
        self.trivet("render", "t.glb", *SIZE, *CAMERA, "--boxes", "b.json")
        found = {o["name"]: (o["class"], o.get("attributes")) for o in self.read_json("b.json")["objects"]}
        die = ("die", {"colour": "red", "sides": 6})
        self.assertEqual(found, {"slab": ("table", None), "uno": die, "one": die, "two": ("stone", {"sides": 1})})
        # A refused operation is no part of what made the scene, so that more can be done with it.
        self.trivet("push", "t.glb", "two", "--direction", -1, 0, "--distance", 0.01, "-o", "u.glb")
        self.trivet("check", "u.glb")

    def test_a_model_alone(self):
        self.trivet("render", "cube.obj", *SIZE, "--ids", "i.png", "--boxes", "b.json")
        self.assertEqual(set(self.png("i.png")), {0, 1})
        self.assertEqual(self.read_json("b.json")["objects"][0]["class"], "cube")

    def test_bad_input(self):
        def refused(*arguments, says):
            self.refused("render", "s.glb", *SIZE, *arguments, says=says)
        refused(says="nothing is asked for")
        refused("--depth", "d.jpg", says=".exr")
        refused("--ids", "i.exr", says=".png")
        refused("--dome", 2, "--ids", "i.png", says="{}")
        refused("--depth", "a.png", "--ids", "a.png", says="two outputs")
        refused("--dome", 0, "--ids", "{}.png", says="1 to")
        refused("--ids", "{}.png", "--dome", 2, "--dome-elevation", 50, 20, says="lowest first")
        for cameras, says in (
                ('{"cameras": []}', "at least one camera"),
                ('{"cameras": [{"eye": [0, 0, 1]}]}', "target"),
                ('{"cameras": [{"eye": [0, 0, 1], "target": [0, 0, 1]}]}', "/cameras/0"),
                ('{"cameras": [{"eye": [0, 0, 1], "target": [0, 0, 0], "name": "a/b"}]}', "digits, _ and -"),
                ('{"cameras": [{"eye": [0, 0, 1], "target": [0, 0, 0], "name": "a.depth"}]}', "/cameras/0/name"),
                (json.dumps({"cameras": [{"eye": [0, 0, 1], "target": [0, 0, 0], "name": 65 * "a"}]}), "1 to 64"),
                ('{"cameras": [{"K": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "camera_from_world": '
                 '[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 2]]}]}', "[0, 0, 0, 1] as fourth row"),
                ('{"cameras": [{"K": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "camera_from_world": [[1, 0, 0, 0]]}]}',
                 "3 or 4 rows"),
                ('{"cameras": [{"eye": [0, 0, 1], "target": [0, 0, 0], "width": 0}]}', "width"),
                ('{"cameras": [{"K": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "camera_from_world": '
                 '[[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}]}', "rotation"),
                ('{"cameras": [{"K": [[1, 9, 0], [0, 1, 0], [0, 0, 1]], "camera_from_world": '
                 '[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}]}', "fx")):
            self.write("cams.json", cameras)
            refused("--cameras", "cams.json", "--ids", "i.png", says=says)


if __name__ == "__main__":
    main()
