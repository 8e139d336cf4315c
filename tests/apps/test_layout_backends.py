"""Layouts give the same scene, to the byte, by every detector."""
import json
import os
import unittest

from program import Case, main

WAYS = ("bvh", "software", "framebuffer", "compute")
PUSHES = [{"op": "push", "object": "spoon", "direction": [1, 0.3], "distance": 0.02},
          {"op": "push", "object": "spoon", "direction": [-1, 0.4], "distance": 0.03},
          {"op": "push", "object": "saucer", "direction": [0.2, 1], "distance": 0.05}]


class Layouts(Case):
    @classmethod
    def setUpClass(cls):
        """If pictures work, there is a GPU or its software emulation, and it must be used."""
        case = Case("setUp")
        case.setUp()
        out, _ = case.trivet("render", "cube.obj", "-o", "p.png", "--samples", 1, status=(0, 3))
        case.doCleanups()
        cls.has_gpu = out == ""

    def check_all_ways(self, *arguments):
        scenes = set()
        for way in WAYS:
            with self.subTest(detector=way):
                self.trivet(*arguments, "-o", "s.glb", "--report", "r.json", "--detector", way)
                self.check_report(self.read_json("r.json"), way)
                scenes.add(self.read("s.glb"))
        self.assertEqual(len(scenes), 1)

    def check_report(self, report, way):
        """The detector that was asked for has answered."""
        on_gpu = way in ("framebuffer", "compute")
        self.assertEqual(report["backend"], way if not on_gpu else "gpu" if self.has_gpu else "bvh")
        self.assertEqual(report["gpu_method"], way if on_gpu and self.has_gpu else "")
        work = report["work"]
        self.assertEqual(work["fallbacks"], 0)
        if on_gpu and self.has_gpu:
            self.assertGreater(work["draws"], 0)
            # Candidate motions of a step share draws.
            self.assertLess(work["draws"], work["queries"] + work["early_queries"])
        self.assertEqual({operation["status"] for operation in report["operations"]}, {"ok"})


class Small(Layouts):
    def test_spoon_saucer(self):
        self.check_all_ways("demo", "spoon-saucer")

    def test_push(self):
        """PUSH after the PUTs of SPOON-SAUCER."""
        self.trivet("demo", "spoon-saucer", "-o", "demo.glb", "--export", "demo")
        layout = self.read_json("demo/layout.json")
        layout["operations"] += PUSHES
        self.write("demo/layout.json", json.dumps(layout))
        self.check_all_ways("run", os.path.join("demo", "layout.json"))


class Demos(Layouts):
    def test_breakfast(self):
        self.check_all_ways("demo", "breakfast")

    def test_office1(self):
        self.check_all_ways("demo", "office1")

    def test_office2(self):
        self.check_all_ways("demo", "office2")


if __name__ == "__main__":
    main()
