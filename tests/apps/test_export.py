"""Scenes for simulators and as tables: output of `trivet export` and `trivet run -o`."""
import csv
import io
import json
import os
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile

from program import SLAB, Case, box_obj, main, put

HERE = os.path.dirname(os.path.abspath(__file__))
NODE_MODULES = os.environ.get("TRIVET_NODE_MODULES", "")


class Exports(Case):
    def scene(self):
        self.write("half/cube.obj", box_obj(0.025, 0.025, 0.025))
        objects = [SLAB, {"name": "a cube, \"red\"", "model": "cube.obj"},
                   {"name": "a_cube___red_", "model": "cube.obj"},
                   {"name": "2", "model": "half/cube.obj", "up": "y", "scale": 1.5},
                   {"name": "away", "model": "cube.obj"}]
        operations = [put(objects[1]["name"], 0, 0, 1), put("a_cube___red_", 0.3, 0.02, 1, [3, 1, 0, 2]),
                      put("2", 0.01, 0.02, 2)]
        layout = self.layout(objects, operations)
        self.trivet("run", layout, "-o", "s.glb", "--report", "r.json")
        return self.read_json("r.json")


class Simulators(Exports):
    def test_every_format_names_all_objects_and_existing_meshes(self):
        self.scene()
        for name in ("s.xml", "s.urdf", "s.sdf", "s.usda"):
            out, _ = self.trivet("export", "s.glb", "-o", name, "--json", "--density", 500,
                                 "--report", "export.json")
            report = json.loads(out)
            self.assertEqual(out.encode(), self.read("export.json"))
            self.assertEqual(len(report["objects"]), 4)  # without the unplaced one
            names = [o["file_name"] for o in report["objects"]]
            self.assertEqual(len(set(names)), 4)
            self.assertEqual(names[2], "a_cube___red_")  # valid already
            self.assertAlmostEqual(report["objects"][1]["mass"], 0.5, places=6)
            self.assertEqual(report["overlaps"], [])
            text = self.read(name).decode()
            for file in report["files"]:
                self.assertTrue(os.path.exists(self.path(file)), file)
            for file in report["files"][1:]:
                if not file.endswith(".mtl"):
                    self.assertIn(os.path.basename(file), text)
            for exported in names:
                self.assertIn('"%s"' % exported, text)

    def test_run_writes_the_same_files(self):
        self.scene()
        self.trivet("run", "layout.json", "-o", "one/../t.xml")
        self.trivet("export", "s.glb", "-o", "t2.xml", "--meshes", "t_meshes")
        one, two = (ElementTree.fromstring(self.read(n)) for n in ("t.xml", "t2.xml"))
        two.set("model", one.get("model"))
        self.assertEqual(ElementTree.tostring(one), ElementTree.tostring(two))

    def test_poses_equal_those_of_the_report(self):
        report = self.scene()
        self.trivet("export", "s.glb", "-o", "s.xml")
        self.trivet("export", "s.glb", "-o", "s.csv", "--table", "poses")
        root = ElementTree.fromstring(self.read("s.xml"))
        bodies = {b.get("name"): b for b in root.find("worldbody").findall("body")}
        self.assertEqual(len(bodies), 4)
        rows = {r["name"]: r for r in csv.DictReader(io.StringIO(self.read("s.csv").decode()))}
        body, row = bodies["a_cube___red_"], rows["a_cube___red_"]
        self.assertEqual([float(v) for v in body.get("pos").split()],
                         [float(row[k]) for k in "xyz"])
        self.assertEqual([float(v) for v in body.get("quat").split()],
                         [float(row["q" + k]) for k in "wxyz"])
        self.assertIsNone(bodies["slab"].find("freejoint"))
        self.assertIsNotNone(body.find("freejoint"))
        self.assertEqual(len(report["objects"]), len(rows))

    def test_mesh_prefix(self):
        self.scene()
        self.trivet("export", "s.glb", "-o", "s.urdf", "--mesh-prefix", "package://here/")
        self.assertIn(b'"package://here/s_meshes/', self.read("s.urdf"))

    def test_wrong_usage(self):
        self.scene()
        self.refused("export", "s.glb", "-o", "s.abc", says=[".abc", ".urdf", ".csv"])
        self.refused("export", "s.glb", "-o", "s.xml", "--collision", "mesh", says="hulls")
        self.refused("export", "s.glb", "-o", "s.xml", "--collision", "spheres",
                     says=["spheres", "components", "fitted"])
        self.refused("export", "s.glb", "-o", "s.sdf", "--simulate", 1, says="--simulate")
        self.refused("export", "s.glb", "-o", "s.xml", "--report", "s.xml", says="two outputs")
        self.refused("export", "cube.obj", "-o", "s.xml", says="cube.obj")
        self.refused("export", "s.glb", "-o", "/proc/nowhere/s.xml", says="nowhere", status=3)
        self.refused("export", "s.glb", "-o", "s.csv", "--density", "500", says="--density")


class Usd(Exports):
    def test_three_reads_it(self):
        reader = os.path.join(NODE_MODULES, "three", "examples", "jsm", "loaders", "USDLoader.js")
        if not shutil.which("node") or not os.path.exists(reader):
            self.skipTest("needs Node.js and the npm package three (TRIVET_NODE_MODULES)")
        report = self.scene()
        out, _ = self.trivet("export", "s.glb", "-o", "s.usda", "--json")
        done = json.loads(out)
        # three follows references only inside a package: a ZIP without compression.
        with zipfile.ZipFile(self.path("s.usdz"), "w", zipfile.ZIP_STORED) as package:
            for file in done["files"]:
                package.write(self.path(file), file)
        result = subprocess.run(["node", os.path.join(HERE, "read_usd.mjs"), reader,
                                 self.path("s.usdz")], capture_output=True, timeout=120)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        seen = {}  # outermost node of a name: three keeps the layers' own roots below
        for node in json.loads(result.stdout):
            seen.setdefault(node["name"], node)
        self.trivet("export", "s.glb", "-o", "s.csv")
        rows = {r["name"]: r for r in csv.DictReader(io.StringIO(self.read("s.csv").decode()))}
        triangles = 0
        for entry in done["objects"]:
            node = seen[entry["file_name"]]
            row = rows[entry["name"]]
            self.assertGreater(node["meshes"], 0, node)
            triangles += node["triangles"]
            for axis in "xyz":
                self.assertAlmostEqual(node["position"][axis], float(row[axis]), delta=1e-6)
            dot = sum(node["quaternion"][k] * float(row["q" + k]) for k in "wxyz")
            self.assertAlmostEqual(abs(dot), 1, delta=1e-6)
        self.assertEqual(len(report["objects"]), len(done["objects"]) + 1)  # one is unplaced
        self.assertGreaterEqual(triangles, 4 * 12)


class Tables(Exports):
    def rows(self, name):
        return list(csv.DictReader(io.StringIO(self.read(name).decode(), newline="")))

    def test_poses_equal_those_of_the_report_bitwise(self):
        report = self.scene()
        self.trivet("export", "s.glb", "-o", "poses.csv")
        rows = self.rows("poses.csv")
        self.assertEqual([r["name"] for r in rows], [o["name"] for o in report["objects"]])
        for row, entry in zip(rows, report["objects"]):
            self.assertEqual(row["state"], entry["state"])
            matrix = entry["world_from_file"]
            if matrix is None:
                self.assertEqual((row["x"], row["m00"], row["com_z"]), ("", "", ""))
                continue
            self.assertEqual([float(row["m%d%d" % (r, c)]) for r in range(3) for c in range(4)],
                             matrix[:12])
            self.assertEqual([float(row["com_" + k]) for k in "xyz"], entry["centre_of_mass"])
            for key in ("stability_margin", "least_friction"):
                self.assertEqual(float(row[key]) if row[key] else None, entry[key])

    def test_contacts_equal_those_of_the_report_bitwise(self):
        report = self.scene()
        self.trivet("export", "s.glb", "-o", "c.csv", "--table", "contacts")
        rows = self.rows("c.csv")
        wanted = [(o["name"], c["with"], i, c["type"], *p) for o in report["objects"]
                  for i, c in enumerate(o["contacts"]) for p in c["points"]]
        self.assertGreater(len(wanted), 8)
        self.assertEqual([(r["object"], r["with"], int(r["contact"]), r["type"],
                           *(float(r[k]) for k in "xyz")) for r in rows], wanted)
        gaps = {}
        for row in rows:
            key = row["object"], int(row["contact"])
            gaps[key] = min(gaps.get(key, 1), float(row["gap"]))
            self.assertAlmostEqual(sum(float(row[k]) ** 2 for k in ("nx", "ny", "nz")), 1)
        for entry in report["objects"]:
            for i, contact in enumerate(entry["contacts"]):
                self.assertEqual(gaps[entry["name"], i], contact["gap"])

    def test_json_lines_equal_csv(self):
        self.scene()
        for table in ("poses", "contacts"):
            self.trivet("export", "s.glb", "-o", "t.csv", "--table", table)
            self.trivet("export", "s.glb", "-o", "t.jsonl", "--table", table)
            lines = [json.loads(line) for line in self.read("t.jsonl").decode().splitlines()]
            rows = self.rows("t.csv")
            self.assertEqual(len(lines), len(rows))
            for line, row in zip(lines, rows):
                self.assertEqual(list(line), list(row))
                for key, value in line.items():
                    if value is None:
                        self.assertIn(row[key], ("", "inf"))
                    elif isinstance(value, bool):
                        self.assertEqual(row[key], str(value).lower())
                    elif isinstance(value, (int, float)):
                        self.assertEqual(float(row[key]), value)
                    else:
                        self.assertEqual(row[key], value)


if __name__ == "__main__":
    main()
