"""trivet batch by every detector: the same bytes, whatever becomes of the GPU."""
import json
import os
import signal

from batches import BatchCase, build_preload
from program import main

NO_DRIVER = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"}
WAYS = ("software", "framebuffer", "compute")
# As in llvmpipe a scene takes a second or more, there are few.
COUNT = 10


class Detectors(BatchCase):
    @classmethod
    def setUpClass(cls):
        case = BatchCase("setUp")
        case.setUp()
        out, _ = case.trivet("render", "cube.obj", "-o", "p.png", "--samples", 1, status=(0, 3))
        case.doCleanups()
        cls.has_gpu = out == ""

    def units_of(self, out):
        """SHA-256 of every unit."""
        return {name: value for name, value in self.hashes(out).items() if name.endswith(".tar")}

    def totals(self, out, *more, count=COUNT, env=None):
        return json.loads(self.batch(out, "--json", *more, count=count, env=env)[0])

    def assert_same(self, *outs):
        first = self.units_of(outs[0])
        self.assertEqual(len(first), COUNT // 5)
        for out in outs[1:]:
            self.assertEqual(self.units_of(out), first, out)

    def test_every_detector_gives_the_same_bytes(self):
        self.batch("bvh", "--detector", "bvh", count=COUNT)
        for way in WAYS:
            found = self.totals(way, "--detector", way, "--jobs", 2)
            if way == "software" or self.has_gpu:
                self.assertEqual(found["notes"], [])
            if way != "software" and self.has_gpu:
                self.assertGreater(found["draws"], 0)
                # Scenes of a worker and candidate motions of a step share draws.
                self.assertLess(found["draws"], 0.7 * (found["queries"] + found["early_queries"]))
        self.assert_same("bvh", *WAYS)
        self.assertIn("0 findings", self.trivet("batch", "verify", "bvh", "--detector", "compute", "--sample", 0.3)[0])

    def test_without_a_driver_a_note_is_kept(self):
        self.batch("bvh", "--detector", "bvh", count=COUNT)
        found = self.totals("gpu", "--detector", "gpu", "--jobs", 2, env=NO_DRIVER)
        if not found["notes"]:
            self.skipTest("the drivers cannot be hidden here")
        self.assertEqual(len(found["notes"]), 1)
        self.assertIn("BVHs are used instead of the GPU", found["notes"][0])
        self.assert_same("bvh", "gpu")
        lines = self.read("gpu/notes.jsonl").splitlines()
        self.assertEqual(len(lines), 1)
        self.assertEqual(json.loads(lines[0])["note"], found["notes"][0])
        self.assertEqual(json.loads(self.trivet("batch", "status", "gpu", "--json")[0])["notes"],
                         [json.loads(lines[0])])
        self.assertIn("note at scene", self.trivet("batch", "status", "gpu")[0])
        self.assertIn("0 findings", self.trivet("batch", "verify", "gpu")[0])

    def test_killed_workers_change_nothing(self):
        self.batch("one", "--detector", "bvh", count=COUNT)
        process = self.start("shot", "--detector", "framebuffer", "--jobs", "2", count=COUNT)
        self.wait_until(lambda: os.path.exists(self.path("shot/run.json")), process)
        self.wait_until(lambda: process.poll() is not None or self.workers_of(process.pid))
        for signum in (signal.SIGKILL, signal.SIGSEGV):
            for worker in self.workers_of(process.pid)[:1]:
                os.kill(int(worker), signum)
        self.assertEqual(process.wait(300), 0)
        self.assert_same("one", "shot")

    def test_lost_devices_change_nothing(self):
        """One of two workers loses its device, for good or until there is a new context; see lost_gpu.c."""
        if not self.has_gpu:
            self.skipTest("no OpenGL here")
        self.batch("bvh", "--detector", "bvh", count=COUNT)
        library = build_preload("lost_gpu", self.folder)
        for again, says in (({}, "BVHs and software answer"), ({"LOST_GPU_AGAIN": "1"}, "a new OpenGL context goes on")):
            out = "again" if again else "lost"
            env = {**library, "LOST_GPU_DRAW": "40", "LOST_GPU_ONCE": self.path(out + ".once"), **again}
            found = self.totals(out, "--detector", "framebuffer", "--jobs", 2, env=env)
            self.assertTrue(os.path.exists(self.path(out + ".once")))
            self.assertEqual(len(found["notes"]), 1)
            self.assertIn(says, found["notes"][0])
            self.assertGreater(found["draws"], 0)
            self.assert_same("bvh", out)

    def test_two_batches_at_once(self):
        self.batch("bvh", "--detector", "bvh", count=COUNT)
        both = [self.start(out, "--detector", "compute", "--jobs", "1", count=COUNT) for out in ("a", "b")]
        self.assertEqual([process.wait(300) for process in both], [0, 0])
        self.assert_same("bvh", "a", "b")

    def test_devices_that_are_not_there(self):
        if not self.has_gpu:
            self.skipTest("no OpenGL here")
        err = self.batch("none", "--detector", "gpu", "--device", 99, status=2)[1]
        self.assertIn("device 99 is not accepted", err)
        err = self.batch("none", "--detector", "gpu", status=3, env={"TRIVET_EGL_DEVICE": "two"})[1]
        self.assertIn("TRIVET_EGL_DEVICE", err)
        self.assertFalse(os.path.exists(self.path("none")))

    def test_every_verb_takes_every_detector(self):
        self.batch("out", count=5)
        for detector in ("auto", "bvh", "software", "gpu"):
            for verb in (["status", "out"], ["merge", "out", "-o", detector + ".csv"],
                         ["materialise", "out", 1, "-o", detector + ".glb"]):
                self.trivet("batch", *verb, "--detector", detector)
            self.trivet("batch", "recipe.json", "--count", 5, "--only", "1", "--detector", detector)
            self.trivet("batch", "recipe.json", "--count", 5, "--dry-run", "--detector", detector)


if __name__ == "__main__":
    main()
