"""Every backend gives the same report, apart from its own name and statistics."""
import json
import os
import subprocess
import unittest

from program import PROGRAM, SLAB, SOURCE_DIR, Case, main, put

MODELS = os.path.join(SOURCE_DIR, "..", "shared", "data", "models")
OWN_KEYS = ("backend", "device", "gpu_method", "gpu_lists", "work")


def common_part(report):
    report = {key: value for key, value in report.items() if key not in OWN_KEYS}
    for operation in report["operations"]:
        operation.pop("milliseconds")
    return json.dumps(report)


BACKENDS = ("bvh", "software", "gpu")


class Backends(Case):
    @classmethod
    def setUpClass(cls):
        """If pictures work, there is a GPU or its software emulation, and it must be used."""
        case = cls("test_cubes")
        case.setUp()
        out, _ = case.trivet("render", "cube.obj", "-o", "p.png", "--samples", 1, status=(0, 3))
        case.doCleanups()
        cls.has_gpu = out == ""

    def reports(self, *arguments, statuses=(0,), scenes=True):
        """Returns each backend's report; the common part must be the same."""
        found, texts = {}, set()
        for backend in BACKENDS:
            output = ["-o", backend + ".glb"] if scenes else []
            _, err = self.trivet(*arguments, *output, "--report", "r.json", "--detector", backend,
                                 status=statuses)
            report = self.read_json("r.json")
            found[backend] = {key: report[key] for key in OWN_KEYS}
            texts.add(common_part(report))
            if backend == "gpu" and not self.has_gpu:
                self.assertEqual(report["backend"], "bvh")
                self.assertIn("used instead of the GPU", err)
            else:
                self.assertEqual(report["backend"], backend)
        self.assertEqual(len(texts), 1)
        if not scenes:
            return found
        self.assertEqual(self.read("bvh.glb"), self.read("software.glb"))
        self.assertEqual(self.read("bvh.glb"), self.read("gpu.glb"))
        return found

    def test_demo(self):
        found = self.reports("demo", "spoon-saucer")
        self.assertEqual(found["bvh"]["device"], "cpu")
        for backend in ("bvh", "software"):
            self.assertEqual((found[backend]["gpu_method"], found[backend]["gpu_lists"]), ("", ""))
        self.assertGreater(found["bvh"]["work"]["node_pairs"], 0)
        self.assertEqual(found["software"]["work"]["fallbacks"], 0)
        self.assertLess(found["software"]["work"]["node_pairs"],  # of the floor
                        found["bvh"]["work"]["node_pairs"])
        self.assertGreater(found["software"]["work"]["doubtful_pixels"], 0)
        queries = {f["work"]["queries"] for f in found.values()}
        self.assertEqual(len(queries), 1)
        if self.has_gpu:
            self.assert_ran_on_gpu(found["gpu"])

    def assert_ran_on_gpu(self, found):
        for key in ("body_pairs", "pixels", "doubtful_pixels", "proposed_face_pairs",
                    "bytes_read_back"):
            self.assertGreater(found["work"][key], 0, key)
        self.assertEqual(found["work"]["fallbacks"], 0)
        self.assertNotEqual(found["device"], "cpu")

    def test_cubes(self):
        found = self.reports("run", self.two_cubes())
        if self.has_gpu:
            self.assert_ran_on_gpu(found["gpu"])

    def test_check(self):
        layout = self.two_cubes()
        # Settled with perfect friction, b leans on an edge that holds at 5, not at 0.5.
        found = self.reports("check", layout, "--friction", "5", scenes=False)
        self.assertGreater(found["software"]["work"]["pixels"], 0)
        self.trivet("run", layout, "-o", "s.glb")
        self.reports("check", "s.glb", "--friction", "5", scenes=False)

    def test_session_and_replay(self):
        """A journal written with one backend is replayed with all."""
        self.two_cubes()
        lines = [json.dumps(put("a", 0.2, 0.2, 0.6)), json.dumps(put("b", -0.2, -0.1, 0.9)),
                 json.dumps({"undo": True}), json.dumps({"redo": True})]
        answers = set()
        for backend in BACKENDS:
            result = subprocess.run(
                [PROGRAM, "session", "layout.json", "--journal", backend + ".journal", "--detector",
                 backend, "--verbose"], cwd=self.folder, input="\n".join(lines), text=True,
                capture_output=True, timeout=300)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("work of ", result.stderr)
            if backend != "gpu" or self.has_gpu:
                self.assertIn("work of " + backend, result.stderr)
            answers.add(result.stdout)
        self.assertEqual(len(answers), 1)
        found = self.reports("replay", "software.journal")
        if self.has_gpu:
            self.assert_ran_on_gpu(found["gpu"])

    def places_layout(self):
        cube = {"op": "put", "rotation": [1, 0, 0, 0], "on": "slab"}
        return self.layout(
            [SLAB] + [{"name": name, "model": "cube.obj"} for name in "abcd"],
            [{**cube, "object": "a", "at": "anywhere", "seed": 3},
             {**cube, "object": "b", "at": "anywhere", "seed": 4, "keep": 0.1},
             {**cube, "object": "c", "at": "anywhere", "seed": 5, "keep": 0.05},
             {**cube, "object": "d", "at": [0.1, -0.2]}])

    def on_gpu_with(self, **env):
        """Requests the GPU in this environment: report and messages; results must not change."""
        layout = self.places_layout()
        self.trivet("run", layout, "-o", "bvh.glb", "--report", "bvh.json")
        _, err = self.trivet("run", layout, "-o", "gpu.glb", "--report", "gpu.json", "--detector",
                             "gpu", env=env)
        report = self.read_json("gpu.json")
        self.assertEqual(common_part(self.read_json("bvh.json")), common_part(dict(report)))
        self.assertEqual(self.read("bvh.glb"), self.read("gpu.glb"))
        return report, err

    def test_without_egl(self):
        report, err = self.on_gpu_with(__EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
        if report["backend"] == "gpu":
            self.skipTest("the drivers cannot be hidden here")
        self.assertEqual(report["backend"], "bvh")
        self.assertEqual(err.count("trivet: note:"), 1, err)
        self.assertIn("BVHs are used instead of the GPU", err)

    def test_without_opengl_4_3(self):
        """z-lists work with framebuffers; places need compute shaders."""
        report, err = self.on_gpu_with(MESA_GL_VERSION_OVERRIDE="3.3")
        if not self.has_gpu or "OpenGL 3.3" not in report["device"]:
            self.skipTest("no GPU here, or its driver does not obey MESA_GL_VERSION_OVERRIDE")
        self.assertEqual(report["backend"], "gpu")
        self.assertGreater(report["work"]["pixels"], 0)
        self.assertEqual(report["work"]["places_on_gpu"], 0)
        self.assertEqual(err.count("trivet: note:"), 1, err)
        self.assertIn("places are judged in software instead", err)

    def test_methods(self):
        """The report names the one that was asked for; results do not depend on it."""
        layout = self.two_cubes()
        self.trivet("run", layout, "-o", "bvh.glb", "--report", "bvh.json")
        for method, name in (("framebuffer", "framebuffers"), ("compute", "compute shaders")):
            _, err = self.trivet("run", layout, "-o", "gpu.glb", "--report", "gpu.json", "--detector", method,
                                 "--verbose")
            report = self.read_json("gpu.json")
            self.assertEqual(self.read("bvh.glb"), self.read("gpu.glb"))
            if self.has_gpu:
                self.assert_listed(method, name, report, err)

    def assert_listed(self, method, name, report, err):
        self.assertIn(name, report["device"])
        self.assertIn(name, err)
        self.assertEqual((report["gpu_method"], report["gpu_lists"]), (method, "auto"))
        work = report["work"]
        self.assertIn(f"by the GPU ({method}) in {work['lists_by_gpu']} queries, "
                      f"in software in {work['lists_in_software']} (auto)", err)
        self.assertIn(f"{work['draws']} draws, {work['read_backs']} read-backs", err)
        self.assertGreater(work["lists_by_gpu"] + work["lists_in_software"], 0)

    def test_devices(self):
        """A device that is not there is an error where OpenGL may be used, and no concern of BVHs."""
        run = ("run", self.two_cubes(), "-o", "s.glb")
        self.trivet(*run, "--detector", "bvh", "--device", 99)
        self.trivet(*run, "--detector", "bvh", "--device", "auto")
        for device in ("0", "-1", "two", "1.5", ""):
            self.refused(*run, "--device", device, says="accepted: auto, or the number of an EGL device, from 1")
        if not self.has_gpu:
            self.skipTest("no OpenGL here")
        self.refused(*run, "--detector", "gpu", "--device", 99, "--quiet", says="device 99 is not accepted; accepted: auto")
        self.trivet(*run, "--detector", "compute", "--device", 1, "--report", "r.json")
        self.assertEqual(self.read_json("r.json")["gpu_method"], "compute")
        _, err = self.trivet(*run, "--quiet", env={"TRIVET_EGL_DEVICE": "two"}, status=3)
        self.assertIn('TRIVET_EGL_DEVICE is "two"; accepted', err)
        out, _ = self.trivet("doctor", "--detector", "compute", "--device", 1, "--memory-mb", 1)
        self.assertRegex(out, "ok +detector +compute: gpu, .*compute")

    def test_places(self):
        """--detector selects the evaluation of places; results do not depend on it."""
        found = self.reports("run", self.places_layout())
        places = {f["work"]["places"] for f in found.values()}
        self.assertEqual(len(places), 1)
        self.assertGreater(min(places), 1000)
        self.assertEqual(found["software"]["work"]["places_on_gpu"], 0)
        if self.has_gpu:
            self.assertEqual(found["gpu"]["work"]["places_on_gpu"], min(places))

    @unittest.skipUnless(os.path.isdir(MODELS), "no models beside the project")
    def test_real_models(self):
        names = sorted(name for name in os.listdir(MODELS) if name.endswith((".obj", ".stl", ".ply"))
                       and os.path.getsize(os.path.join(MODELS, name)) < 200000)[:6]
        self.assertGreater(len(names), 3)
        objects, operations = [], []
        for i, name in enumerate(names):
            objects.append({"name": "o%d" % i, "model": os.path.join(MODELS, name)})
            operations.append(put("o%d" % i, 0.02 * i, 0.01 * i, 5 + 5 * i, [1, 0.2 * i, 0.1, 0.3]))
        layout = self.layout(objects, operations)
        self.reports("run", layout, statuses=(0, 1))

    def test_verbose_prints_work_of_stages(self):
        _, err = self.trivet("run", self.two_cubes(), "-o", "s.glb", "--detector", "software",
                             "--verbose")
        for words in ("stage 1, boxes:", "stage 2, depths:", "stage 3, lists:", "narrow phase:"):
            self.assertIn(words, err)


class Calibration(Case):
    """`trivet backends`, and what it keeps in the user's cache folder."""

    def backends(self, *arguments, **env):
        out, err = self.trivet("backends", "--json", *arguments,
                               env={"XDG_CACHE_HOME": self.path("cache"), **env})
        return json.loads(out), err

    def without_drivers(self, *arguments, **env):
        """Software renderers are slow to start."""
        return self.backends(*arguments, __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent", **env)

    def test_measures_and_keeps(self):
        first, err = self.backends()
        self.assertEqual(err, "")
        self.assertEqual(first["file"], self.path("cache/trivet/backends.json"))
        self.assertEqual([s["name"] for s in first["sources"]][:2], ["bvh", "software"])
        self.assertEqual([c["triangles"] for c in first["choices"]], [1000, 15000, 150000, 1500000])
        usable = {"bvh", "software"} | {s["name"] for s in first["sources"] if not s["on_cpu"]}
        for choice in first["choices"]:
            self.assertLessEqual({choice["fall"], choice["turn"]}, usable)
            if not first["hardware"]:
                self.assertEqual({choice["fall"], choice["turn"]}, {"bvh"})
        self.assertEqual(self.files().count("cache/trivet/backends.json"), 1)
        second, _ = self.backends()
        self.assertEqual(second, first)
        third, err = self.without_drivers("--recalibrate")
        self.assertEqual(err, "")
        self.assertNotEqual(third["seconds"], first["seconds"])
        text, _ = self.trivet("backends", env={"XDG_CACHE_HOME": self.path("cache")})
        self.assertIn("auto takes", text)

    def test_a_file_of_another_build_or_device_is_measured_again(self):
        """A build without OpenGL must not hide a GPU from one that has it."""
        kept, _ = self.without_drivers()
        self.assertEqual(self.without_drivers("--device", 1)[0]["device"], 1)
        for key, value in (("build", ""), ("device", 7), ("cpu", "another")):
            self.write("cache/trivet/backends.json", json.dumps({**kept, key: value}))
            found, err = self.without_drivers()
            self.assertIn("it is of another version, build, processor, driver or device", err)
            self.assertEqual(found[key], kept[key])

    def test_the_rule_of_auto_is_a_line(self):
        found, _ = self.without_drivers()
        self.assertTrue(found["rule"].startswith("auto: BVHs, unless"), found["rule"])
        text, _ = self.trivet("backends", env={"XDG_CACHE_HOME": self.path("cache")})
        self.assertIn("\nauto: BVHs, unless", text)

    def test_damaged_file_is_replaced_with_a_note(self):
        self.write("cache/trivet/backends.json", "{")
        found, err = self.without_drivers()
        self.assertEqual(err.count("trivet: note:"), 1, err)
        self.assertIn("measured again", err)
        self.assertEqual(self.without_drivers(), (found, ""))

    def test_goes_on_where_nothing_can_be_kept(self):
        self.write("file", "")
        _, err = self.without_drivers(XDG_CACHE_HOME=self.path("file"))
        self.assertEqual(err.count("trivet: note:"), 1, err)
        self.assertIn("cannot be kept", err)

    def test_auto_without_hardware_reads_and_writes_nothing(self):
        hardware = self.without_drivers()[0]["hardware"]
        self.write("cache/trivet/backends.json", "{")
        _, err = self.trivet("run", self.two_cubes(), "-o", "s.glb", "--report", "r.json",
                             env={"XDG_CACHE_HOME": self.path("cache")})
        if hardware:
            self.skipTest("there is graphics hardware here")
        self.assertEqual(err, "")
        self.assertEqual(self.read("cache/trivet/backends.json"), b"{")
        self.assertEqual(self.read_json("r.json")["backend"], "bvh")


if __name__ == "__main__":
    main()
