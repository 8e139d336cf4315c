"""trivet batch export: simulator files of all scenes, with meshes that they share; and progress of batches."""
import glob
import json
import os
import pty
import re
import select
import signal
import subprocess
import time
import xml.etree.ElementTree as ElementTree

from batches import HEAP, SLAB, BatchCase
from program import PROGRAM, box_obj, main
from textured_boxes import png, textured_box_obj


class Exports(BatchCase):
    COUNT = 10

    def setUp(self):
        super().setUp()
        self.write("brick.obj", box_obj(0.05, 0.025, 0.0375))
        self.write_recipe(groups=[{"name": "brick", "count": 3, "on": "slab", "models": [
            {"model": "brick.obj"}, {"model": "cube.obj"}]}])
        self.batch("scenes", count=self.COUNT)

    def export(self, out, *more, status=0):
        return self.trivet("batch", "export", "scenes", "--out", out, "--quiet", *more, status=status)

    def test_all_kinds_name_meshes_that_are_there(self):
        self.export("e", "--as", "mjcf,urdf,sdf,usd,glb")
        ok = [row["k"] for row in self.merged("scenes") if row["status"] == "ok"]
        self.assertGreaterEqual(len(ok), self.COUNT - 2)
        for k in ok:
            stem = "e/0000/scenes-%06d/%09d" % (k // 5, k)
            for ending in (".xml", ".urdf", ".sdf", ".usda"):
                text = self.read(stem + ending).decode()
                meshes = set(re.findall(r"[\w./-]*meshes/[\w.-]+", text))
                folder = os.path.dirname(stem)
                if ending == ".xml":
                    root = ElementTree.fromstring(text)
                    meshdir = root.find("compiler").get("meshdir") or ""
                    meshes = {os.path.join(meshdir, m.get("file")) for m in root.iter("mesh") if m.get("file")}
                    names = {b.get("name") for b in root.iter("body")}
                    self.assertTrue({"slab", "brick_0"} <= names, names)
                self.assertTrue(meshes, stem + ending)
                for mesh in meshes:
                    self.assertTrue(os.path.exists(os.path.normpath(self.path(os.path.join(folder, mesh)))), mesh)
            self.trivet("check", stem + ".glb")
        # Three models: their meshes and parts once, for all scenes.
        self.assertLess(len(os.listdir(self.path("e/meshes"))), 30)
        self.assertIn("units: 2 of 2", self.trivet("batch", "status", "e")[0])
        self.assertEqual(self.temporaries("e"), [])

    def test_images_are_made_once(self):
        self.write("carton.obj", textured_box_obj(0.03, 0.02, 0.06))
        self.write("carton.mtl", "newmtl paper\nmap_Kd carton.png\n")
        self.write("carton.png", png(8, 8, lambda x, y: (255, 30 * x, 30 * y)))
        self.write_recipe(groups=[{"name": "carton", "count": 2, "on": "slab", "models": [{"model": "carton.obj"}]}])
        self.batch("cartons", count=6)
        self.trivet("batch", "export", "cartons", "--out", "e", "--as", "mjcf,urdf,sdf,usd", "--quiet")
        images = [os.path.basename(name) for name in glob.glob(self.path("e/meshes/*.png"))]
        self.assertEqual(len(images), 1)
        for k in [row["k"] for row in self.merged("cartons") if row["status"] == "ok"]:
            scene = ElementTree.fromstring(self.read("e/0000/scenes-%06d/%09d.xml" % (k // 5, k)).decode())
            self.assertEqual([t.get("file") for t in scene.iter("texture")], images)
        meshes = {name: self.read("e/meshes/" + name).decode("latin-1") for name in os.listdir(self.path("e/meshes"))}
        self.assertEqual(sum("map_Kd " + images[0] in text for name, text in meshes.items() if name.endswith(".mtl")), 1)
        self.assertEqual(sum("inputs:file = @./" + images[0] in text for name, text in meshes.items()), 1)

    def test_shards_and_kills_change_nothing(self):
        self.export("one", "--as", "mjcf,usd", "--jobs", 1)
        for shard in range(2):
            process = subprocess.Popen([PROGRAM, "batch", "export", "scenes", "--out", "two", "--as", "usd,mjcf",
                                        "--shard", "%d/2" % shard], cwd=self.folder, stderr=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL)
            while process.poll() is None and not glob.glob(self.path("two/meshes/*")):
                time.sleep(0.001)
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.assert_no_process_left()
            self.export("two", "--as", "mjcf,usd", "--shard", "%d/2" % shard)

        def files(out):
            return {name: value for name, value in self.hashes(out).items() if "trivet-tmp" not in name}
        self.assertEqual(files("one"), files("two"))
        self.assertIn("0 findings", self.trivet("batch", "verify", "two", "--scenes", "scenes", "--sample", 1)[0])

    def test_bad_input(self):
        self.refused("batch", "export", "scenes", "--out", "e", "--as", "obj", says="mjcf")
        self.refused("batch", "export", "nowhere", "--out", "e", "--as", "usd", says="run.json")
        self.export("e", "--as", "usd")
        self.assertIn("exports", self.export("e", "--as", "sdf", status=2)[1])
        self.assertIn("simulator files", self.trivet("batch", "export", "e", "--out", "f", "--as", "usd", status=2)[1])
        self.assertIn("simulator files", self.trivet("batch", "materialise", "e", 1, "-o", "k.glb", status=2)[1])


class Progress(BatchCase):
    def on_terminal(self, *arguments):
        """The text on a terminal, and the exit status."""
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        shown = b""
        while select.select([ours], [], [], 60)[0]:
            try:
                piece = os.read(ours, 4096)
            except OSError:  # its other end is closed
                break
            shown += piece
        os.close(ours)
        return shown.decode(), process.wait()

    def test_a_bar_shows_every_scene(self):
        shown, status = self.on_terminal("batch", "recipe.json", "--count", "30", "--out", "o", "--jobs", "2")
        self.assertEqual(status, 0)
        steps = [(int(a), int(b)) for a, b in re.findall(r"\[[#.]{24}\] (\d+) of (\d+) scenes, \S+/s, \S+ s left", shown)]
        self.assertEqual(steps, [(i, 30) for i in range(1, 31)])
        self.assertTrue(shown.endswith("\r\x1b[K"))  # the line is clean in the end
        shown, _ = self.on_terminal("batch", "pictures", "o", "--out", "p", "--quiet", "--views", self.views())
        self.assertEqual(shown, "")

    def views(self):
        return self.write("views.json", json.dumps({"views": {"width": 8, "height": 8, "samples": 1}}))

    def test_lines_elsewhere_say_what_is_true(self):
        err = self.trivet("batch", "recipe.json", "--count", 30, "--out", "o")[1]
        self.assertRegex(err, r"^30 of 30 scenes, \S+/s, 0 s left\n$")

    def test_units_are_small(self):
        self.trivet("batch", "recipe.json", "--count", 45, "--out", "o", "--quiet")
        self.assertEqual(len(self.units("o")), 3)

    def test_groups_without_objects_are_told(self):
        wide = {"name": "wide", "models": [{"model": "slab.obj", "scale": 3}], "count": 2, "on": "slab", "region": [[0, 0], [0.1, 0.1]]}
        none = {"name": "none", "models": [{"model": "cube.obj"}], "count": 0, "on": "slab"}
        self.write_recipe(groups=[HEAP, wide, none])
        err = self.trivet("batch", "recipe.json", "--count", 4, "--out", "o", "--quiet")[1]
        self.assertEqual(err, "")
        err = self.trivet("batch", "recipe.json", "--count", 4, "--out", "p")[1]
        self.assertIn('the group "wide": none of 8 objects could be put; most often: ', err)
        self.assertIn('the group "none" has no object: its count was 0 in all scenes', err)
        self.assertNotIn('"heap"', err)

    def test_slurm_gets_tasks_that_make_sense(self):
        def job(count, **env):
            return self.trivet("batch", "recipe.json", "--count", count, "--out", "o", "--template", "slurm", env=env)[0]
        self.assertIn("1 tasks of about 200 scenes", job(200))
        self.assertIn("--array=0-0%", job(200))
        self.assertIn("100 tasks of about 1000 scenes", job(100000))
        self.assertIn("200 tasks of about 50000 scenes", job(10 ** 7))
        self.assertIn("40 tasks of about 25 scenes", job(1000, TRIVET_SHARDS="40"))

    def test_negative_fractions_are_numbers(self):
        self.batch("o", count=5)
        self.trivet("batch", "materialise", "o", 0, "-o", "s.glb")
        self.trivet("render", "s.glb", "-o", "a.png", "--width", 8, "--height", 8, "--samples", 1,
                    "--camera", "-.5", "-.25", ".5", "0", "0", "-.1")
        self.trivet("render", "s.glb", "-o", "b.png", "--width", 8, "--height", 8, "--samples", 1,
                    "--camera", -0.5, -0.25, 0.5, 0, 0, -0.1)
        self.assertEqual(self.read("a.png"), self.read("b.png"))


if __name__ == "__main__":
    main()
