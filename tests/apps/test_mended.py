"""Scenes of boxes and heaps of solids, perturbed and mended: each is true by Trivet's check and by the referee of ../shared/tools,
which shares no code with it, or names what has no place. TRIVET_MENDED scenes; perf/mend_noise.py measures models."""
import json
import math
import os
import random
import subprocess
import unittest

from program import Case, box_obj, main, put

REFEREE = os.environ.get("TRIVET_REFEREE", "")
SCENES = int(os.environ.get("TRIVET_MENDED", 9))
NOISES = ((1, 1), (5, 3), (20, 10))  # millimetres and degrees of normal deviates
BOOK, SHELF = (0.015, 0.07, 0.1), {"name": "shelf", "model": "slab.obj", "fixed": True, "position": [0, 0, 0.5]}


def turned(quaternion, axis, degrees):
    """The quaternion, then the turn."""
    half = math.radians(degrees) / 2
    length = math.sqrt(sum(a * a for a in axis))
    w, (x, y, z) = math.cos(half), (math.sin(half) * a / length for a in axis)
    a, b, c, d = quaternion
    return [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a]


def quaternion_of(m):
    """The quaternion of a matrix of 16 numbers, row by row."""
    w = math.sqrt(max(0.0, 1 + m[0] + m[5] + m[10])) / 2
    x = math.copysign(math.sqrt(max(0.0, 1 + m[0] - m[5] - m[10])) / 2, m[9] - m[6])
    y = math.copysign(math.sqrt(max(0.0, 1 - m[0] + m[5] - m[10])) / 2, m[2] - m[8])
    z = math.copysign(math.sqrt(max(0.0, 1 - m[0] - m[5] + m[10])) / 2, m[4] - m[1])
    return [w, x, y, z]


def is_true(report):
    check = report["check"]
    return check["pairs_passing_through"] == 0 and check["all_at_rest"] and report["stability"]["status"] != "unstable"


class Mended(Case):
    def setUp(self):
        super().setUp()
        self.counts = dict.fromkeys(("scenes", "judged", "objects", "unable", "meant", "kept"), 0)

    def box(self, name, half):
        self.write(name + ".obj", box_obj(*half))
        return {"name": name, "model": name + ".obj"}

    def row(self, generator):
        """Books on a shelf, side by side."""
        books = [self.box("book%d" % i, (BOOK[0], BOOK[1], BOOK[2] * generator.uniform(0.8, 1))) for i in range(8)]
        return [SHELF, *books], [put(b["name"], 0.031 * i - 0.11, 0, 1) for i, b in enumerate(books)]

    def stacks(self, generator):
        """Three stacks of three on the shelf."""
        objects, operations = [SHELF], []
        for s in range(3):
            for k in range(3):
                objects.append(self.box("s%d%d" % (s, k), (0.06 - 0.015 * k, 0.05 - 0.01 * k, generator.uniform(0.01, 0.03))))
                operations.append(put(objects[-1]["name"], 0.2 * s - 0.2, 0, 2))
        return objects, operations

    def heap(self, generator):
        """Bricks, slabs and bars in any orientation, let fall onto each other."""
        objects, operations = [], []
        for i in range(6):
            objects.append(self.box("h%d" % i, [generator.uniform(0.02, 0.06) for _ in range(3)]))
            operations.append(put(objects[-1]["name"], generator.uniform(-0.06, 0.06), generator.uniform(-0.06, 0.06), 2,
                                  [generator.gauss(0, 1) for _ in range(4)]))
        return objects, operations

    def report_of(self, name, objects, operations, status=0):
        self.write(name, json.dumps({"trivet": 1, "objects": objects, "operations": operations}))
        self.trivet("run", name, "-o", "s.glb", "--report", "r.json", "--quiet", status=status)
        return self.read_json("r.json")

    def perturbed(self, report, objects, noise, generator):
        out, there = [], {o["name"]: o for o in report["objects"]}
        for one in objects:
            m = there[one["name"]].get("world_from_file")
            if one.get("fixed") or m is None:
                out.append(one)
                continue
            shift = [generator.gauss(0, noise[0] / 1000) for _ in range(3)]
            rotation = turned(quaternion_of(m), [generator.gauss(0, 1) for _ in range(3)], generator.gauss(0, noise[1]))
            out.append({**one, "position": [m[3] + shift[0], m[7] + shift[1], m[11] + shift[2]], "rotation": rotation})
        return [one for one in out if "position" in one]

    def edges(self, report):
        return {(o["name"], below) for o in report["objects"] for below in o.get("supported_by", ()) if o["state"] != "fixed"}

    def one(self, seed):
        generator = random.Random(seed)
        noise = NOISES[seed % len(NOISES)]
        kind = (self.row, self.stacks, self.heap)[seed // len(NOISES) % 3]
        objects, operations = kind(generator)
        true = self.report_of("true.json", objects, operations, status=(0, 1))
        bad = self.perturbed(true, objects, noise, generator)
        mended = self.report_of("bad.json", bad, [{"op": "mend"}], status=(0, 1))
        repaired = mended["operations"][0]["repaired"]
        self.counts["scenes"] += 1
        self.counts["objects"] += len(bad) - sum(one.get("fixed", False) for one in bad)
        self.counts["meant"] += len(self.edges(true))
        self.counts["kept"] += len(self.edges(true) & self.edges(mended))
        if repaired["unable"]:  # named, with the reason
            self.counts["unable"] += len(repaired["unable"])
            self.assertTrue(all(one["why"] for one in repaired["unable"]))
            return
        self.assertTrue(is_true(mended), (seed, mended["check"]))
        if os.path.exists(REFEREE):
            self.write("state.json", json.dumps({"objects": [o for o in mended["objects"] if o["state"] != "unplaced"]}))
            done = subprocess.run([REFEREE, "state.json"], cwd=self.folder, capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 0, (seed, done.stdout + done.stderr))
            self.counts["judged"] += 1

    def test_perturbed_scenes_become_true(self):
        for seed in range(SCENES):
            with self.subTest(seed=seed):
                self.one(seed)
        print(json.dumps(self.counts))
        self.assertEqual(self.counts["scenes"], SCENES)
        self.assertLessEqual(self.counts["unable"], 0.02 * self.counts["objects"])
        self.assertGreater(self.counts["kept"], 0.7 * self.counts["meant"])

    @unittest.skipUnless(os.path.exists(REFEREE), "no referee: nobody else judged the scenes (../shared/tools/referee)")
    def test_the_referee_was_there(self):
        self.one(0)
        self.assertEqual(self.counts["judged"], 1)

    def test_two_that_lean_on_each_other_stay(self):
        """Each board of a tent holds the other: neither can be put first."""
        self.write("board.obj", box_obj(0.01, 0.1, 0.15))
        tent = [{"name": "left", "model": "board.obj", "position": [-0.0641, 0, 0.1453], "rotation": turned([1, 0, 0, 0], [0, 1, 0], 20)},
                {"name": "right", "model": "board.obj", "position": [0.0641, 0, 0.1453], "rotation": turned([1, 0, 0, 0], [0, 1, 0], -20)}]
        mended = self.report_of("tent.json", tent, [{"op": "mend", "tolerance": 0.005}], status=(0, 1))
        repaired = mended["operations"][0]["repaired"]
        self.assertEqual(repaired["unable"], [])
        self.assertTrue(is_true(mended))
        for one in repaired["moved"]:
            self.assertLess(one["metres"], 0.01, one)
            self.assertLess(one["degrees"], 4, one)


if __name__ == "__main__":
    main()
