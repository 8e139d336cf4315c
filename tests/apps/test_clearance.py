"""Gaps below objects do not grow with the scene: a box of 10 cm, anywhere in scenes of 1 m to 20 km."""
import json
import os
import subprocess
import unittest

from program import Case, box_obj, main, put

REFEREE = os.environ.get("TRIVET_REFEREE", "")
LARGEST_GAP = 1e-5
PLACES = (0, 10, 1e3, 1e4)


class Clearance(Case):
    def setUp(self):
        super().setUp()
        self.write("ground.obj", box_obj(1, 1, 1))

    def lay_out(self, x, size, name, ground=False):
        """A box at x, another object that makes the scene this large (0: none)."""
        objects, height = [{"name": "box", "model": "cube.obj"}], 0.0
        if size:
            objects.append({"name": "far", "model": "slab.obj", "fixed": True,
                            "position": [x - size, 0, 0.0500001]})
        if ground:  # 40 km wide
            objects.append({"name": "ground", "model": "ground.obj", "scale": 2e4, "fixed": True,
                            "position": [0, 0, -2e4]})
        layout = self.layout(objects, [put("box", x, 0.3, height + 1)], name=name + ".json",
                             floor=not ground)
        self.trivet("run", layout, "-o", name + ".glb", "--report", name + "_report.json", "--quiet")
        self.trivet("check", name + ".glb")
        box = next(o for o in self.read_json(name + "_report.json")["objects"] if o["name"] == "box")
        self.assertEqual(box["state"], "stable")
        pose = box["world_from_file"]
        gap = pose[11] - 0.05 - height
        self.assertGreater(gap, 0)
        self.assertLessEqual(gap, LARGEST_GAP, (x, size))
        return pose

    def test_gaps(self):
        for x in PLACES:
            alone = self.lay_out(x, 0, "alone")
            for size in (1, 60, 100, 1e3, 2e4):
                pose = self.lay_out(x, size, "wide")
                if size > 20:
                    self.assertEqual(pose, alone, (x, size))
            self.assertEqual(self.lay_out(x, 1e3, "wide"), self.lay_out(x, 2e4, "wider"))
            self.lay_out(x, 0, "ground", ground=True)

    def test_order(self):
        poses = []
        for order in ("box far", "far box"):
            objects = {"box": {"name": "box", "model": "cube.obj"},
                       "far": {"name": "far", "model": "slab.obj"}}
            layout = self.layout([objects[name] for name in order.split()],
                                 [put(name, 0 if name == "box" else 1e3, 0, 1) for name in order.split()])
            self.trivet("run", layout, "-o", "s.glb", "--report", "r.json", "--quiet")
            report = self.read_json("r.json")["objects"]
            poses.append({o["name"]: o["world_from_file"] for o in report})
        self.assertEqual(poses[0], poses[1])

    @unittest.skipUnless(os.access(REFEREE, os.X_OK), "the referee is missing")
    def test_the_referee_finds_them_true(self):
        for x in PLACES:
            for size in (0, 1e3, 2e4):
                self.lay_out(x, size, "s")
                done = subprocess.run([REFEREE, self.path("s_report.json"), "--layout", self.path("s.json"),
                                       "--scene", self.path("s.glb"), "--eps", "1.1e-5", "--json"],
                                      capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, (x, size, done.stdout, done.stderr))

    # A millimetre above the floor is not at rest, wherever it is and however large the scene.
    def test_what_hovers(self):
        for x in (0, 1e3, 1e4):
            for gap in (1e-3, 2e-3):
                layout = self.layout([
                    {"name": "far", "model": "slab.obj", "fixed": True, "position": [x + 1e3, 0, 0.0500001]},
                    {"name": "box", "model": "cube.obj", "position": [x, 0, 0.05 + gap]}], name="hover.json")
                out, _ = self.trivet("check", layout, status=1)
                self.assertIn('"box" is not at rest', out)

    def test_wide_scenes_are_read_back(self):
        self.lay_out(1e4, 2e4, "s")
        gltf = self.read("s.glb")
        self.assertIn(b'"place"', gltf)
        self.trivet("push", "s.glb", "box", "--direction", 1, 0, "--distance", 0.5, "-o", "t.glb")
        self.trivet("check", "t.glb")
        self.assertIn("was moved", self.trivet("check", self.moved("s.glb"), status=2)[1])

    def moved(self, name):
        """Another program has moved what is below the node of a place by a kilometre."""
        data = self.read(name)
        length = int.from_bytes(data[12:16], "little")
        scene = json.loads(data[20:20 + length])
        node = next(n for n in scene["nodes"] if n.get("name") == "place")
        node["translation"][0] += 1024
        text = json.dumps(scene).encode()
        text += b" " * (-len(text) % 4)
        rest = data[20 + length:]
        self.write("moved.glb", data[:8] + (20 + len(text) + len(rest)).to_bytes(4, "little") +
                   len(text).to_bytes(4, "little") + data[16:20] + text + rest)
        return "moved.glb"

    def test_bounds_of_clearances(self):
        layout = self.layout([{"name": "box", "model": "cube.obj"}], [put("box", 1e4, 0, 1)])
        out, _ = self.trivet("run", layout, "-o", "s.glb", "--clearance", 1e-6, status=1)
        self.assertIn("is not between 1.001e-06 and ", out)
        self.trivet("run", layout, "-o", "s.glb", "--clearance", 1.001e-6)


if __name__ == "__main__":
    main()
