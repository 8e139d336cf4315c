"""trivet batch pictures: images of scenes that are there, resumed, verified, and those of trivet render."""
import glob
import json
import os
import signal
import subprocess
import tarfile
import time

from batches import BatchCase
from label_files import read_png
from program import PROGRAM, main, needs_memory_bounds

VIEWS = {"width": 48, "height": 32, "samples": 1, "dome": {"count": 2},
         "images": ["picture", "depth", "instances", "classes", "normals"]}
ENDINGS = [".png", ".depth.png", ".instances.png", ".classes.png", ".normals.png", ".labels.json"]


class Pictures(BatchCase):
    COUNT = 12

    def setUp(self):
        super().setUp()
        self.write_recipe(views=VIEWS)
        self.batch("scenes", count=self.COUNT)

    def pictures(self, out, *more, scenes="scenes", status=0):
        return self.trivet("batch", "pictures", scenes, "--out", out, "--quiet", *more, status=status)

    def members(self, out, unit=0):
        with tarfile.open(self.path("%s/0000/scenes-%06d.tar" % (out, unit))) as tar:
            return {name: tar.extractfile(name).read() for name in tar.getnames()}

    def test_every_ok_scene_has_all_images_of_all_views(self):
        self.pictures("p")
        found = 0
        for unit in range(3):
            members = self.members("p", unit)
            for name in [n for n in members if n.count(".") == 1 and n.endswith(".json")]:
                scene = json.loads(members[name])
                names = [view["name"] for view in scene["views"]]
                self.assertEqual(names, ["000000", "000001"] if scene["status"] == "ok" else [])
                for view in names:
                    for ending in ENDINGS:
                        self.assertIn("%09d.%s%s" % (scene["k"], view, ending), members)
                    found += 1
        self.assertGreaterEqual(found, 2 * (self.COUNT - 2))
        status = self.trivet("batch", "status", "p")[0]
        self.assertTrue(status.startswith("units: 3 of 3; scenes: %d of %d" % (self.COUNT, self.COUNT)), status)
        self.assertEqual(self.trivet("batch", "merge", "p", "-o", "all.jsonl")[0], "%d scenes\n" % self.COUNT)

    def opengl(self, out, *more, status=0, **env):
        return self.trivet("batch", "pictures", "scenes", "--out", out, "--renderer", "opengl", *more,
                           status=status, env=env)

    def test_opengl_draws_what_rays_draw(self):
        err = self.opengl("gl")[1]
        if "EGL device" not in err and "surfaceless" not in err:
            self.skipTest("no OpenGL: " + err)
        self.pictures("p")
        rays, opengl = self.members("p"), self.members("gl")
        self.assertEqual(sorted(rays), sorted(opengl))
        num_pictures = 0
        for name in rays:
            if not name.endswith(".png") or name.count(".") != 2:
                if name != "manifest.jsonl":
                    self.assertEqual(rays[name], opengl[name], name)
                continue
            a, b = read_png(rays[name]), read_png(opengl[name])
            self.assertEqual(a[:3], b[:3])
            self.assertEqual(len(a[3]), len(b[3]))
            self.assertLess(sum(abs(x - y) for x, y in zip(a[3], b[3])) / len(a[3]), 25, name)
            num_pictures += 1
        self.assertGreater(num_pictures, 4)
        self.assertIn("0 findings", self.trivet("batch", "verify", "gl", "--scenes", "scenes")[0])
        err = self.pictures("gl", status=2)[1]
        self.assertIn("with_opengl is true, here false", err)

    def test_opengl_on_a_device_that_is_not_there(self):
        for device, says in (("99", "device 99"), ("two", 'TRIVET_EGL_DEVICE is "two"; accepted:')):
            err = self.opengl("gl", status=3, TRIVET_EGL_DEVICE=device)[1]
            if "has no OpenGL" in err or "no EGL:" in err:
                self.skipTest(err)
            self.assertIn(says, err)
            self.assertFalse(os.path.exists(self.path("gl")))

    def test_images_are_those_of_render(self):
        """Pictures equal those of a materialised scene, by the cameras that the labels tell."""
        self.pictures("p")
        members = self.members("p")
        scene = json.loads(members["000000001.json"])
        self.trivet("batch", "materialise", "scenes", 1, "-o", "k.glb")
        self.write("cameras.json", json.dumps({"cameras": [{"name": v["name"], **{key: v["camera"][key] for key in (
            "width", "height", "K", "camera_from_world")}} for v in scene["views"]]}))
        self.trivet("render", "k.glb", "--cameras", "cameras.json", "--depth", "{}.d.png", "--ids", "{}.i.png",
                    "--classes", "{}.c.png", "--normals", "{}.n.png", "--boxes", "{}.json", "--visibility")
        for view in scene["views"]:
            ours = json.loads(members["000000001.%s.labels.json" % view["name"]])
            theirs = self.read_json(view["name"] + ".json")
            self.assertEqual([o["name"] for o in ours["objects"]], [o["name"] for o in theirs["objects"]])
            self.assertEqual([o["class"] for o in ours["objects"]], [o["class"] for o in theirs["objects"]])
            for ending, file in ((".depth.png", ".d.png"), (".instances.png", ".i.png"), (".classes.png", ".c.png")):
                a = read_png(members["000000001.%s%s" % (view["name"], ending)])[3]
                b = read_png(self.read_bytes(view["name"] + file))[3]
                self.assertEqual(len(a), 48 * 32)
                # The eye of a matrix, and float32 of files, are rounded: pixels at edges may differ.
                self.assertLessEqual(sum(x != y and abs(x - y) > 1 for x, y in zip(a, b)), 8, ending)
            self.assertGreater(len(set(read_png(members["000000001.%s.instances.png" % view["name"]])[3])), 1)

    def read_bytes(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_shards_jobs_and_kills_change_nothing(self):
        self.pictures("one", "--jobs", 1)
        one = self.hashes("one")
        for shard in range(2):
            self.pictures("two", "--shard", "%d/2" % shard, "--jobs", 2, "--recycle", 2)
        self.assertEqual(self.hashes("two"), one)
        process = self.start_pictures("killed")
        self.wait_for(process, "killed/0000/scenes-*.tar")
        process.kill()
        process.wait()
        self.assert_no_process_left()
        self.pictures("killed")
        self.assertEqual(self.hashes("killed"), one)
        process = self.start_pictures("stopped")
        self.wait_for(process, "stopped/run.json")
        process.send_signal(signal.SIGTERM)
        self.assertIn(process.wait(timeout=60), (75, 0))
        self.assertEqual(self.temporaries("stopped"), [])
        self.pictures("stopped")
        self.assertEqual(self.hashes("stopped"), one)

    def start_pictures(self, out):
        return subprocess.Popen([PROGRAM, "batch", "pictures", "scenes", "--out", out, "--quiet", "--jobs", "1"],
                                cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def wait_for(self, process, pattern):
        while not glob.glob(self.path(pattern)) and process.poll() is None:
            time.sleep(0.002)

    def test_verify_makes_a_sample_again_and_finds_a_flipped_bit(self):
        self.pictures("p")
        verified = self.trivet("batch", "verify", "p", "--scenes", "scenes", "--sample", 1)[0]
        self.assertIn("%d made again: 0 findings" % self.COUNT, verified)
        self.assertIn("--scenes", self.trivet("batch", "verify", "p", status=2)[1])
        path = self.path("p/0000/scenes-000001.tar")
        with open(path, "r+b") as file:
            file.seek(os.path.getsize(path) // 2)
            byte = file.read(1)[0]
            file.seek(-1, 1)
            file.write(bytes([byte ^ 4]))
        self.trivet("batch", "verify", "p", "--scenes", "scenes", "--sample", 0, status=1)

    @needs_memory_bounds
    def test_failed_scenes_have_none_and_are_no_failure_here(self):
        self.write_large_recipe(views=VIEWS)
        self.batch("bad", "--scene-memory-mb", 1, "--with", "scene", count=6, status=1)
        for _ in range(2):  # made, and there before
            self.assertIn("0 failed, 6 without", self.pictures("p", scenes="bad")[0])
        self.assertIn("failed: ", self.trivet("batch", "status", "p")[0])

    def test_units_wait_for_their_scenes(self):
        os.remove(self.path("scenes/0000/scenes-000001.tar"))
        out = self.trivet("batch", "pictures", "scenes", "--out", "p", "--quiet", status=75)[0]
        self.assertIn("not there yet: 1", out)
        self.batch("scenes", count=self.COUNT)
        self.pictures("p")
        self.assertEqual(len([n for n in self.hashes("p") if n.endswith(".tar")]), 3)

    def test_views_change_no_scene_and_others_may_be_given(self):
        self.write_recipe("other.json", views={**VIEWS, "width": 64})
        self.batch("again", count=self.COUNT, recipe="other.json")
        of_scenes = {name: value for name, value in self.hashes("scenes").items() if name != "run.json"}
        self.assertEqual({name: value for name, value in self.hashes("again").items() if name != "run.json"}, of_scenes)
        self.write("views.json", json.dumps({"views": {
            "cameras": [{"name": "top", "eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "width": 20, "height": 10}],
            "images": ["instances"]}}))
        self.pictures("top", "--views", "views.json", "--format", "dir")
        name = "top/0000/scenes-000000/000000001.top"
        self.assertEqual(read_png(self.read_bytes(name + ".instances.png"))[:2], (20, 10))
        self.assertFalse(os.path.exists(self.path(name + ".png")) or os.path.exists(self.path(name + ".depth.png")))
        self.trivet("batch", "verify", "top", "--scenes", "scenes", "--sample", 1)
        self.assertIn("views", self.pictures("top", "--format", "dir", status=2)[1])  # others are in that folder
        self.assertIn("pictures", self.pictures("x", scenes="top", status=2)[1])
        self.assertIn("pictures", self.trivet("batch", "materialise", "top", 1, "-o", "k.glb", status=2)[1])

    def test_bad_input(self):
        self.write_recipe("plain.json")
        self.batch("plain", count=5, recipe="plain.json")
        self.assertIn("views", self.pictures("x", scenes="plain", status=2)[1])
        self.write("bad.json", json.dumps({"views": {"images": ["flow"]}}))
        self.assertIn("/views/images/0", self.pictures("x", "--views", "bad.json", status=2)[1])
        self.write("none.json", "{}")
        self.assertIn("views", self.pictures("x", "--views", "none.json", status=2)[1])
        self.assertFalse(os.path.exists(self.path("x/run.json")))


class Contacts(BatchCase):
    def test_contacts_are_those_of_the_report(self):
        for form in ("tar", "dir"):
            self.batch(form, "--with", "contacts,report,scene", "--format", form, count=5)
            self.assertIn(" 0 findings", self.trivet("batch", "verify", form, "--sample", 1)[0])
        touching = 0
        for k in range(5):
            stem = "dir/0000/scenes-000000/%09d" % k
            contacts = self.read_json(stem + ".contacts.json")["contacts"]
            report = self.read_json(stem + ".report.json")
            self.assertEqual(contacts, {o["name"]: o["contacts"] for o in report["objects"] if o["world_from_file"]})
            touching += sum(len(one) for one in contacts.values())
        self.assertGreater(touching, 10)
        self.assertIn("with_contacts", self.batch("dir", "--format", "dir", "--with", "report,scene", count=5, status=2)[1])


if __name__ == "__main__":
    main()
