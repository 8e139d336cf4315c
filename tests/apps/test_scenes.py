"""Scenes from file to file: runs, refusals, outputs, and round trips."""
import json
import os
import signal
import subprocess
import time
import unittest

from program import PROGRAM, SLAB, Case, grid_obj, main, put, without_times


class Refusals(Case):
    def test_start_inside_another_object(self):
        layout = self.layout(
            [SLAB, {"name": "in", "model": "cube.obj", "position": [0, 0, 0.06]},
             {"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}],
            [put("a", 0, 0, 0.1), put("b", 0, 0, 1)])
        out, _ = self.trivet("run", layout, "-o", "s.glb", "--report", "r.json", status=1)
        self.assertIn('put "a": refused', out)
        operations = self.read_json("r.json")["operations"]
        self.assertEqual([(o["op"], o["object"], o["status"]) for o in operations],
                         [("stand", "in", "refused"), ("put", "a", "refused"), ("put", "b", "ok")])
        for operation in operations[:2]:
            self.assertIn('"slab"', operation["reason"])
            self.assertIn('"%s"' % operation["object"], operation["reason"])
        states = {o["name"]: o["state"] for o in self.read_json("r.json")["objects"]}
        self.assertEqual(states, {"slab": "fixed", "in": "unplaced", "a": "unplaced", "b": "stable"})
        self.trivet("check", "s.glb")

    def test_stop_at_refusal(self):
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"},
                              {"name": "b", "model": "cube.obj"}],
                             [put("a", 0, 0, 0.1), put("b", 0, 0, 1)])
        self.trivet("run", layout, "-o", "s.glb", "--report", "r.json", "--stop-at-refusal", status=1)
        last = self.read_json("r.json")["operations"][1]
        self.assertEqual(last["status"], "refused")
        self.assertIn("not tried", last["reason"])

    def test_refuses_fall_without_support(self):
        layout = self.layout([{"name": "a", "model": "cube.obj"}], [put("a", 0, 0, 1)], floor=False)
        out, _ = self.trivet("run", layout, "-o", "s.glb", status=1)
        self.assertIn('put "a": refused: nothing is below "a"', out)

    def test_refused_put_keeps_the_scene(self):
        self.trivet("run", self.two_cubes(), "-o", "s.glb", "--report", "r.json")
        self.trivet("put", "s.glb", "cube.obj", "--position", 0, 0, 0.1, "-o", "t.glb",
                    "--report", "t.json", status=1)
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))
        self.assertEqual(self.read_json("t.json")["operations"][0]["status"], "refused")
        self.assertEqual(self.read_json("t.json")["objects"], self.read_json("r.json")["objects"])

    def test_check_of_a_layout_names_pairs(self):
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj", "position": [0, 0, 0.1]},
                              {"name": "b", "model": "cube.obj", "position": [0, 0.07, 0.13]}])
        out, _ = self.trivet("check", layout, status=1)
        self.assertIn('"slab" and "a"', out)
        self.assertIn('"a" and "b"', out)
        self.trivet("check", self.two_cubes(), "--friction", "5")


class Outputs(Case):
    def test_unwritable_output_fails_before_the_work(self):
        self.write("file", "")
        run = ("run", self.two_cubes())
        for output in ("file/s.glb", "/proc/s.glb", "/proc/no/s.glb"):
            self.refused(*run, "-o", output, status=3, says=[output, "cannot be written"])
            self.refused(*run, "-o", "s.glb", "--report", output, status=3, says=output)
            self.refused("demo", "spoon-saucer", "-o", output, status=3, says=output)
        os.mkdir(self.path("folder.glb"))
        self.refused(*run, "-o", "folder.glb", status=3, says="folder.glb")
        self.refused("demo", "spoon-saucer", "-o", "s.glb", "--export", "file/x", status=3,
                     says="file/x")

    def test_folders_are_checked_before_the_work(self):
        self.write("file", "")
        for command in (("render", "none.glb", "--coco", "file"), ("render", "none.glb", "--bop", "file"),
                        ("demo", "spoon-saucer", "-o", "s.glb", "--export", "file"),
                        ("batch", "none.json", "--count", "1", "--out", "file"),
                        ("batch", "pictures", "none", "--out", "file"),
                        ("batch", "export", "none", "--as", "mjcf", "--out", "file")):
            self.refused(*command, says="file: is a file; accepted: a folder")
        self.assertEqual(os.listdir(self.folder).count("s.glb"), 0)
        job = ("batch", "none.json", "--count", "1", "--template", "slurm", "--out")
        self.assertIn("file", self.trivet(*job, "file")[0])

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_without_permission(self):
        os.mkdir(self.path("closed"), 0o500)
        self.refused("run", self.two_cubes(), "-o", "closed/s.glb", status=3,
                     says=["closed/s.glb", "Permission denied"])

    def test_a_full_disk(self):
        out, err = self.trivet("run", self.two_cubes(), "-o", "s.glb", "--report", "/dev/full",
                               status=3)
        self.assertIn("/dev/full: cannot be written", err)

    def test_wrong_names(self):
        layout = self.two_cubes()
        self.refused("run", layout, "-o", "s.xyz", says=[".xyz", "accepted: .glb, .gltf, .obj, .ply, .stl"])
        self.refused("run", layout, "-o", "scene", says="accepted: .glb")
        self.refused("run", layout, "-o", "s.glb", "--picture", "p.bmp", says="accepted: .png")
        self.refused("run", layout, "-o", "s.glb", "--report", "./s.glb", says="two outputs")
        self.refused("run", layout, "-o", "s.glb", "--report", layout, says="would be overwritten")

    def test_writes_every_format(self):
        layout = self.two_cubes()
        for extension in ("glb", "obj", "ply", "stl", "GLB"):
            self.trivet("run", layout, "-o", "s." + extension)
            info = json.loads(self.trivet("info", "s." + extension, "--json")[0])
            self.assertEqual(info["triangles"], 36)

    def size_if_there(self, name):
        try:
            return os.path.getsize(self.path(name))
        except FileNotFoundError:  # renamed in the meantime
            return 0

    def test_kill_during_write_keeps_the_old_file(self):
        self.write("grid.obj", grid_obj(250))
        layout = self.layout([{"name": "g", "model": "grid.obj", "fixed": True,
                               "position": [0, 0, 0]}], floor=False)
        old = b"the old scene"
        num_killed = 0
        for _ in range(20):
            self.write("s.glb", old)
            before = set(os.listdir(self.folder))
            process = subprocess.Popen([PROGRAM, "run", layout, "-o", "s.glb", "--quiet"],
                                       cwd=self.folder)
            # A non-empty hidden file beside the target: it is being written.
            while process.poll() is None:
                new = [n for n in set(os.listdir(self.folder)) - before if n.startswith(".s.glb")]
                if new and self.size_if_there(new[0]) > 0:
                    process.kill()
                    break
            killed = process.wait() == -signal.SIGKILL
            content = self.read("s.glb")
            if killed and content == old:
                num_killed += 1
            elif content != old:  # renamed just before
                self.write("whole.glb", content)
                self.trivet("check", "whole.glb")
            if num_killed >= 3:
                return
        self.assertGreater(num_killed, 0)


class Determinism(Case):
    def test_threads_change_only_times(self):
        layout = self.two_cubes()
        for source in (("run", layout), ("demo", "breakfast")):
            reports, scenes = set(), set()
            for threads in (1, 2, 8):
                self.trivet(*source, "-o", "s.glb", "--report", "r.json", "--threads", threads)
                report = self.read("r.json")
                self.assertEqual(report.count(b'"milliseconds"'),
                                 len(self.read_json("r.json")["operations"]))
                reports.add(without_times(report))
                scenes.add(self.read("s.glb"))
            self.assertEqual((len(reports), len(scenes)), (1, 1), source)

    def test_exported_demo_runs_to_the_same_bits(self):
        self.trivet("demo", "spoon-saucer", "-o", "s.glb", "--report", "r.json", "--export", "d")
        self.trivet("run", "d/layout.json", "-o", "t.glb", "--report", "t.json")
        self.assertEqual(without_times(self.read("t.json")), without_times(self.read("r.json")))
        self.assertEqual(self.read("t.glb"), self.read("s.glb"))
        self.trivet("demo", "spoon-saucer", "-o", "u.glb", "--report", "u.json")
        self.assertEqual(without_times(self.read("u.json")), without_times(self.read("r.json")))


class RoundTrips(Case):
    def objects(self, report):
        return [{**o, "model": ""} for o in self.read_json(report)["objects"]]

    def test_scene_round_trip(self):
        self.trivet("run", self.two_cubes(), "-o", "s.glb", "--report", "r.json")
        self.trivet("check", "s.glb", "--friction", "5", "--report", "c.json")
        self.assertEqual(self.objects("c.json"), self.objects("r.json"))
        self.assertEqual(self.read_json("c.json")["check"], self.read_json("r.json")["check"])
        # In another folder, without the models:
        self.write("moved/s.glb", self.read("s.glb"))
        out, err = self.trivet("check", "moved/s.glb", "--friction", "5", "--report", "c.json")
        self.assertEqual(self.objects("c.json"), self.objects("r.json"))
        self.assertEqual(err, "")

    def test_sequence_of_puts_equals_a_layout(self):
        """The same scene from one layout and from several puts."""
        self.trivet("run", self.layout([SLAB]), "-o", "s.glb")
        self.trivet("put", "s.glb", "cube.obj", "--name", "a", "--position", 0, 0, 1, "-o", "s.glb")
        self.trivet("put", "s.glb", "cube.obj", "--name", "b", "--position", 0.01, 0.02, 1,
                    "--rotation", 3, 1, 0, 2, "-o", "s.glb", "--report", "p.json")
        self.trivet("run", self.two_cubes(), "-o", "t.glb", "--report", "r.json")
        self.assertEqual(self.read_json("p.json")["objects"], self.read_json("r.json")["objects"])
        self.assertEqual(self.read("s.glb"), self.read("t.glb"))

    def test_model_paths_follow_the_files(self):
        self.write("models/m.obj", self.read("cube.obj"))
        self.write("layouts/l.json", json.dumps({
            "trivet": 1, "objects": [{"name": "a", "model": "../models/m.obj"}],
            "operations": [put("a", 0, 0, 1)]}))
        os.mkdir(self.path("out"))
        os.mkdir(self.path("reports"))
        self.trivet("run", "layouts/l.json", "-o", "out/s.glb", "--report", "reports/r.json")
        self.assertEqual(self.read_json("reports/r.json")["objects"][0]["model"], "../models/m.obj")
        self.trivet("put", "out/s.glb", "models/m.obj", "--position", 1, 0, 1, "-o", "t.glb",
                    "--report", "reports/p.json")
        report = self.read_json("reports/p.json")
        self.assertEqual([o["model"] for o in report["objects"]], ["../models/m.obj"] * 2)
        self.assertEqual([o["name"] for o in report["objects"]], ["a", "m"])
        self.trivet("check", "t.glb", "--report", "c.json")
        self.assertEqual([o["model"] for o in self.read_json("c.json")["objects"]],
                         ["models/m.obj"] * 2)

    def test_names(self):
        self.trivet("run", self.two_cubes(), "-o", "s.glb")
        self.trivet("put", "s.glb", "cube.obj", "--position", 0.3, 0, 1, "-o", "s.glb")
        self.trivet("put", "s.glb", "cube.obj", "--position", -0.3, 0, 1, "-o", "s.glb",
                    "--report", "r.json")
        self.assertEqual([o["name"] for o in self.read_json("r.json")["objects"]],
                         ["slab", "a", "b", "cube", "cube_2"])
        for name, says in (("a", '"a" is taken'), ("floor", '"floor" is not accepted'),
                           ("a\tb", "without control characters")):
            self.refused("put", "s.glb", "cube.obj", "--position", 0, 0, 2, "--name", name,
                         "-o", "t.glb", says=["--name: ", says])

    def test_a_model_is_stored_once(self):
        self.trivet("run", self.two_cubes(), "-o", "s.glb")
        sizes = []
        for x in (0.2, 0.3, 0.4):
            self.trivet("put", "s.glb", "cube.obj", "--position", x, 0.3, 1, "-o", "s.glb")
            sizes.append(len(self.read("s.glb")))
        mesh_bytes = 24 * 24 + 12 * 12  # corners with normals, indices
        with open(self.path("s.glb"), "rb") as file:
            file.seek(12)
            length = int.from_bytes(file.read(4), "little")
            file.seek(20)
            scene = json.loads(file.read(length))
        self.assertEqual(len(scene["meshes"]), 2)
        self.assertEqual(len(scene["nodes"]), 6)
        self.assertLess(scene["buffers"][0]["byteLength"], 3 * mesh_bytes)


if __name__ == "__main__":
    main()
