"""STEP, IGES and BREP through the program: info, PUT, scenes, errors; and the referee's verdict."""
import json
import os
import shutil
import subprocess
import tempfile
import unittest

from program import SLAB, Case, main, put

MAKE_CAD = os.environ.get("TRIVET_MAKE_CAD", "none")
REFEREE = os.environ.get("TRIVET_REFEREE", "")
FACES = {"ball": 1, "ring": 1, "spoon": 3, "bottle": 5}


@unittest.skipIf(MAKE_CAD == "none", "this build has no Open CASCADE (TRIVET_OCCT)")
class CadCase(Case):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.mkdtemp(prefix="trivet_cad_")
        cls.addClassCleanup(shutil.rmtree, cls.made, ignore_errors=True)
        subprocess.run([MAKE_CAD, cls.made], check=True, stdout=subprocess.DEVNULL)

    def setUp(self):
        super().setUp()
        for name in os.listdir(self.made):
            shutil.copy(os.path.join(self.made, name), self.folder)

    def info(self, *arguments):
        return json.loads(self.trivet("info", *arguments, "--json")[0])

    def table_layout(self):
        """A bottle and a spoon on the floor, a ring on a slab, a ball on the ring."""
        return self.layout(
            [SLAB, {"name": "bottle", "model": "bottle.step"},
             {"name": "ring", "model": "ring.step", "chord": 1e-4, "facet_angle_deg": 15},
             {"name": "ball", "model": "ball.step", "chord": 2e-4},
             {"name": "spoon", "model": "spoon.step"}],
            [put("bottle", 0.8, 0, 0.5), put("ring", 0, 0, 0.5), put("ball", 0, 0, 0.6),
             put("spoon", -0.9, 0, 0.4, [0.9, 0.1, 0.2, 0])])


class Cad(CadCase):
    def test_info_reports_polygonisation(self):
        for name, faces in FACES.items():
            for extension in ("step", "igs", "brep"):
                with self.subTest(name + "." + extension):
                    info = self.info(name + "." + extension)
                    found = info["polygonised"]
                    if extension != "igs":  # IGES has seams as separate faces
                        self.assertEqual(found["faces"], faces)
                    self.assertEqual(found["failed_faces"], 0)
                    self.assertEqual(found["facet_angle_deg"], 20)
                    self.assertLessEqual(found["deviation"], found["chord"])
                    self.assertTrue(found["within_chord"])
                    self.assertTrue(info["closed"] and info["oriented"])
                    self.assertEqual(info["mass_rule"], "volume")
                    self.assertEqual(info["metres_per_unit"], 1)
        self.assertIsNone(self.info("cube.obj")["polygonised"])

    def test_smaller_chord_gives_more_triangles(self):
        coarse = self.info("ball.step", "--chord", "1e-3", "--facet-angle-deg", "45")
        fine = self.info("ball.step", "--chord", "2e-5")
        self.assertEqual(coarse["polygonised"]["chord"], 1e-3)
        self.assertEqual(coarse["polygonised"]["facet_angle_deg"], 45)
        self.assertGreater(fine["triangles"], 4 * coarse["triangles"])
        exact = 4 / 3 * 3.141592653589793 * 0.04 ** 3
        self.assertLess(abs(fine["volume"] / exact - 1), 1e-3)
        self.assertGreater(abs(coarse["volume"] / exact - 1), 1e-3)
        self.assertIn("polygonised 1 face,", self.trivet("info", "ball.step")[0])

    def test_layout(self):
        self.trivet("run", self.table_layout(), "-o", "s.glb", "--report", "r.json")
        report = self.read_json("r.json")
        self.assertEqual(report["check"]["interpenetrating_pairs"], 0)
        self.assertTrue(report["check"]["all_at_rest"])
        objects = {o["name"]: o for o in report["objects"]}
        self.assertEqual({o["state"] for o in objects.values()}, {"fixed", "stable"})
        self.assertEqual(objects["bottle"]["supported_by"], ["floor"])
        self.assertEqual(objects["spoon"]["supported_by"], ["floor"])
        self.assertEqual(objects["ring"]["supported_by"], ["slab"])
        self.assertEqual(objects["ball"]["supported_by"], ["ring"])
        self.trivet("check", "s.glb")

    def test_two_tolerances_for_one_file(self):
        layout = self.layout(
            [{"name": "fine", "model": "ball.step", "chord": 1e-4},
             {"name": "coarse", "model": "ball.step", "chord": 1e-3, "facet_angle_deg": 60},
             {"name": "fine too", "model": "ball.step", "chord": 1e-4},
             {"name": "out", "model": "ball.step", "chord": 2e-4}],
            [put("fine", 0, 0, 1), put("coarse", 0.2, 0, 1), put("fine too", 0.4, 0, 1)])
        self.trivet("run", layout, "-o", "s.glb", "--report", "r.json")

        def triangles(report):
            return {o["name"]: o["triangles"] for o in self.read_json(report)["objects"]}
        before = triangles("r.json")
        self.assertEqual(before["fine"], before["fine too"])
        self.assertGreater(before["fine"], before["out"])
        self.assertGreater(before["out"], before["coarse"])
        # The scene stores how its models were read, also for the unplaced one.
        self.trivet("put", "s.glb", "ball.step", "--name", "new", "--chord", "3e-4",
                    "--position", 0.6, 0, 1, "-o", "t.glb")
        self.trivet("translate", "t.glb", "new", "--by", 0, 0, 0.1, "-o", "u.glb", "--report",
                    "u.json", status=1)  # held
        after = triangles("u.json")
        self.assertEqual({name: after[name] for name in before}, before)
        self.assertGreater(before["out"], after["new"])

    def test_append_in_a_session(self):
        layout = self.layout([SLAB])
        lines = [{"op": "append", "object": "a", "model": "ball.step", "chord": 1e-4},
                 {"op": "append", "object": "b", "model": "ball.step", "chord": 1e-3},
                 put("a", 0, 0, 1), put("b", 0.2, 0, 1)]
        self.write("lines", "".join(json.dumps(line) + "\n" for line in lines))
        with open(self.path("lines")) as lines_file:
            subprocess.run([os.environ["TRIVET_PROGRAM"], "session", layout, "--journal", "j",
                            "--quiet"], cwd=self.folder, stdin=lines_file, check=True,
                           capture_output=True, timeout=300)
        self.trivet("replay", "j", "-o", "s.glb", "--report", "r.json")
        triangles = {o["name"]: o["triangles"] for o in self.read_json("r.json")["objects"]}
        self.assertGreater(triangles["a"], triangles["b"])

    def test_output_is_deterministic(self):
        layout = self.table_layout()
        for name in ("a", "b"):
            self.trivet("run", layout, "-o", name + ".glb", "--threads", 1 if name == "a" else 4)
        self.assertEqual(self.read("a.glb"), self.read("b.glb"))

    def test_refusals(self):
        with open(self.path("spoon.step"), "rb") as file:
            self.write("half.step", file.read()[:9000])
        self.refused("info", "half.step", says=["half.step: "])
        self.write("not.brep", "nothing of the kind\n")
        self.refused("info", "not.brep", says=["not.brep: cannot be read"])
        self.refused("info", "ball.step", "--chord", "0", says=["--chord", "accepted: numbers from"])
        self.refused("info", "ball.step", "--chord", "1e-9", says=["chord of 1e-09 m is too small"])
        self.refused("info", "ball.step", "--facet-angle-deg", "0.1", says=["accepted: numbers from 1"])
        self.refused("info", "cube.obj", "--chord", "1e-3",
                     says=["--chord", "cube.obj", "no curved surfaces"])
        self.refused("info", "ball.step", "--import-in-process",
                     says=["ball.step: STEP files are read only by the program trivet-import-cad"])
        self.refused("info", "ball.step", "--chord", "2e-6", "--import-seconds", "0.05",
                     says=["ball.step", "longer than the limit"])
        layout = self.layout([{"name": "a", "model": "half.step", "chord": 1e-3}])
        self.refused("run", layout, "-o", "s.glb", says=["/objects/0/model", "half.step"])


@unittest.skipUnless(os.access(REFEREE, os.X_OK), "the referee of ../shared is not built")
class Referee(CadCase):
    """The referee cannot read STEP: it gets the same triangles as STL, with the same float32 numbers."""

    def test_verdict(self):
        layout = json.loads(self.read(self.table_layout()))
        self.trivet("run", "layout.json", "-o", "s.glb", "--report", "r.json")
        report = self.read_json("r.json")
        for entry in layout["objects"]:
            if not entry["model"].endswith(".step"):
                continue
            model = {k: v for k, v in entry.items() if k in ("name", "model", "chord",
                                                             "facet_angle_deg")}
            alone = self.layout([{**model, "fixed": True, "position": [0, 0, 0]}],
                                name="alone.json", floor=False)
            stl = entry["name"] + ".stl"
            self.trivet("run", alone, "-o", stl, status=(0, 1))
            entry["model"] = stl
            entry.pop("chord", None)
            entry.pop("facet_angle_deg", None)
            for o in report["objects"]:
                if o["name"] == entry["name"]:
                    o["model"] = stl
                    self.assertEqual(len(self.read(stl)), 84 + 50 * o["triangles"])
        self.write("judged.json", json.dumps(layout))
        self.write("r.json", json.dumps(report))
        result = subprocess.run([REFEREE, "r.json", "--layout", "judged.json", "--scene", "s.glb"],
                                cwd=self.folder, capture_output=True, timeout=300)
        self.assertEqual(result.returncode, 0, result.stdout.decode() + result.stderr.decode())
        print(result.stdout.decode())


if __name__ == "__main__":
    main()
