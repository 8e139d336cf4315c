"""Scenes for simulators and as tables: output of `trivet export` and `trivet run -o`."""
import ast
import csv
import io
import json
import math
import os
import re
import shutil
import struct
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile

from label_files import read_png
from program import SLAB, Case, box_obj, main, put
from test_textures import checker, textured_box

HERE = os.path.dirname(os.path.abspath(__file__))
NODE_MODULES = os.environ.get("TRIVET_NODE_MODULES", "")
READ_SDF = os.environ.get("TRIVET_READ_SDF", "")  # prints what libsdformat reads


def cup_obj():
    """A box without lid, of one surface: 0.22 m wide, 0.1 m high, walls of 1 cm."""
    rings = [(0.11, 0), (0.11, 0.1), (0.1, 0.1), (0.1, 0.01)]
    lines = ["v %g %g %g" % (a * half, b * half, z) for half, z in rings for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    for ring in range(3):
        for k in range(4):
            a, b = 4 * ring + k + 1, 4 * ring + (k + 1) % 4 + 1
            lines.append("f %d %d %d %d" % (a, b, b + 4, a + 4))
    return "\n".join(lines + ["f 4 3 2 1", "f 13 14 15 16", ""])


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
        self.assertIn('displayName = "a cube, \\"red\\""', self.read("s.usda").decode())

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

    def test_urdf_of_each_object(self):
        self.scene()
        out, _ = self.trivet("export", "s.glb", "-o", "s.urdf", "--per-object", "--mesh-prefix", "package://x/", "--json")
        done = json.loads(out)
        links = {e.get("name"): e for e in ElementTree.fromstring(self.read("s.urdf")).iter("link")}
        for entry in done["objects"]:
            self.assertIn(entry["own_file"], done["files"])
            robot = ElementTree.fromstring(self.read(entry["own_file"]))
            link, = robot.iter("link")
            self.assertEqual((robot.get("name"), link.get("name")), (entry["file_name"], entry["file_name"]))
            self.assertEqual(ElementTree.tostring(link), ElementTree.tostring(links[entry["file_name"]]))
            self.assertEqual(list(robot.iter("joint")), [])
        out, _ = self.trivet("export", "s.glb", "-o", "s.urdf", "--json")
        self.assertNotIn("own_file", json.loads(out)["objects"][0])
        self.refused("export", "s.glb", "-o", "s.sdf", "--per-object", says=".urdf")

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


class Textures(Exports):
    """A box whose sides show a picture each, beside a plain cube."""

    def textured(self):
        obj, mtl = textured_box()
        self.write("box.obj", obj)
        self.write("box.mtl", mtl)
        self.write("checker.png", checker())
        layout = self.layout([{"name": "box", "model": "box.obj"}, {"name": "cube", "model": "cube.obj"}],
                             [put("box", 0, 0, 1), put("cube", 1, 0, 1)])
        self.trivet("run", layout, "-o", "s.glb")

    def export(self, name):
        """Text of the scene, of all its files by ending, and the picture's name."""
        out, _ = self.trivet("export", "s.glb", "-o", name, "--json")
        files = json.loads(out)["files"]
        pictures = [f for f in files if f.endswith(".png")]
        self.assertEqual(len(pictures), 1, files)
        width, height, channels, texels = read_png(self.read(pictures[0]))
        expected = read_png(checker())[3]
        self.assertEqual((width, height, channels), (32, 32, 3))  # all of it is opaque
        self.assertEqual(list(texels), [v for i, v in enumerate(expected) if i % 4 < 3])
        return self.read(name).decode(), {f: self.read(f).decode() for f in files if f not in pictures}, \
            os.path.basename(pictures[0])

    def shown(self, obj):
        """Corners of the faces as (position, texture coordinates)."""
        points, coordinates, corners = [], [], set()
        for line in obj.splitlines():
            word, *values = line.split(" ")
            if word == "v":
                points.append(tuple(map(float, values)))
            elif word == "vt":
                coordinates.append(tuple(map(float, values)))
            elif word == "f":
                for at, texel in (map(int, value.split("/")) for value in values):
                    corners.add((points[at - 1], coordinates[texel - 1]))
        return corners

    def test_obj_of_simulators_has_coordinates_and_pictures(self):
        self.textured()
        rounded = {tuple(round(v, 6) for v in p + t) for p, t in self.shown(textured_box()[0])}
        for name in ("s.urdf", "s.sdf"):
            _, files, picture = self.export(name)
            whole = [t for f, t in files.items() if f.endswith(".obj") and "\nvt " in t]
            self.assertEqual(len(whole), 1)
            self.assertEqual({tuple(round(v, 6) for v in p + t) for p, t in self.shown(whole[0])}, rounded)
            materials = [t for f, t in files.items() if f.endswith(".mtl") and "map_Kd" in t]
            self.assertEqual(len(materials), 1)
            self.assertIn("map_Kd " + picture + "\n", materials[0])

    def test_formats_in_one_folder_leave_each_others_files(self):
        self.textured()
        _, before, _ = self.export("s.urdf")
        self.export("s.xml")
        for name, text in before.items():
            self.assertEqual(self.read(name).decode(), text, name)

    def test_mujoco_has_textures(self):
        self.textured()
        text, _, picture = self.export("s.xml")
        root = ElementTree.fromstring(text)
        texture, = root.iter("texture")
        self.assertEqual((texture.get("type"), texture.get("file")), ("2d", picture))
        self.assertEqual(root.find("compiler").get("texturedir"), root.find("compiler").get("meshdir"))
        users = [m.get("name") for m in root.iter("material") if m.get("texture") == texture.get("name")]
        self.assertEqual(len(users), 1)
        box = next(b for b in root.iter("body") if b.get("name") == "box")
        self.assertEqual([g.get("material") for g in box.iter("geom") if g.get("class") == "visual"], users)

    def test_usd_has_textures(self):
        self.textured()
        _, files, picture = self.export("s.usda")
        layer, = (t for f, t in files.items() if "UsdUVTexture" in t)
        self.assertIn("inputs:file = @./%s@" % picture, layer)
        self.assertIn("color3f inputs:diffuseColor.connect = </box/Looks/Material0/Image.outputs:rgb>", layer)
        values = layer.split("primvars:st = [")[1].split("]")[0]
        self.assertEqual(len(values.split("), (")), 36)  # corners of 12 triangles
        self.assertIn('interpolation = "faceVarying"', layer)


class Mujoco(Exports):
    def test_version_3_has_no_words_of_version_2(self):
        layout = self.layout([{"name": "cube", "model": "cube.obj"}], [put("cube", 0, 0, 1)])
        self.trivet("run", layout, "-o", "s.glb")
        self.trivet("export", "s.glb", "-o", "new.xml")
        self.trivet("export", "s.glb", "-o", "old.xml", "--mujoco", 2)
        new, old = (ElementTree.fromstring(self.read(name)) for name in ("new.xml", "old.xml"))
        self.assertIsNone(new.find("size"))
        self.assertIsNotNone(old.find("size"))
        corners = [[g for g in root.iter("geom") if g.get("class") == "corner"] for root in (new, old)]
        self.assertEqual(corners[0], [])
        self.assertGreaterEqual(len(corners[1]), 4)

    def test_version_3_holds_ends_of_edges_on_floor(self):
        runner = [(-0.1, 0, 0), (0.1, 0, 0), (-0.1, -0.02, 0.02), (-0.1, 0.02, 0.02), (0.1, -0.02, 0.02), (0.1, 0.02, 0.02)]
        faces = [(0, 2, 4, 1), (0, 1, 5, 3), (2, 3, 5, 4), (0, 3, 2), (1, 4, 5)]
        lines = ["v %g %g %g" % (x, y + side, z) for side in (-0.1, 0.1) for x, y, z in runner]
        lines += ["f " + " ".join(str(1 + first + k) for k in reversed(face)) for first in (0, 6) for face in faces]
        self.write("sled.obj", "\n".join(lines) + "\n")
        self.trivet("run", self.layout([{"name": "sled", "model": "sled.obj"}], [put("sled", 0, 0, 0.1)]), "-o", "s.glb")
        self.trivet("export", "s.glb", "-o", "s.xml")
        root = ElementTree.fromstring(self.read("s.xml"))
        ends = [g for g in root.iter("geom") if g.get("class") == "corner" and g.get("pos")]
        self.assertEqual(sorted((round(x, 4), round(y, 4)) for x, y, _ in (map(float, g.get("pos").split()) for g in ends)),
                         [(-0.1, -0.1), (-0.1, 0.1), (0.1, -0.1), (0.1, 0.1)])
        part, = {g.get("margin") for g in root.iter("geom") if g.get("mesh") and g.get("margin")}
        self.assertEqual({g.get("margin") for g in ends}, {part})

    def test_keyframe_has_all_poses(self):
        self.scene()
        out, _ = self.trivet("export", "s.glb", "-o", "s.xml", "--json")
        root = ElementTree.fromstring(self.read("s.xml"))
        key, = root.findall("keyframe/key")
        positions = [float(v) for v in key.get("qpos").split()]
        free = [b for b in root.iter("body") if b.find("freejoint") is not None]
        self.assertEqual(positions, [float(v) for b in free for k in ("pos", "quat") for v in b.get(k).split()])
        given = {o["file_name"]: o.get("qpos") for o in json.loads(out)["objects"]}
        for k, body in enumerate(free):
            self.assertEqual(given[body.get("name")], positions[7 * k:7 * k + 7])
        self.assertEqual(sum(q is None for q in given.values()), 1)  # the slab is fixed

    def test_heavy_loads_get_stiffer_contacts(self):
        self.write("half/cube.obj", box_obj(0.025, 0.025, 0.025))
        steps = {}
        for scale in (1, 2):
            layout = self.layout([{"name": "small", "model": "half/cube.obj"},
                                  {"name": "big", "model": "half/cube.obj", "scale": 2 * scale}],
                                 [put("small", 0, 0, 1), put("big", 0, 0, 2)])
            self.trivet("run", layout, "-o", "s.glb")
            self.trivet("export", "s.glb", "-o", "s.xml")
            root = ElementTree.fromstring(self.read("s.xml"))
            option, contacts = root.find("option"), root.find("default/default/geom")
            steps[scale] = option.get("timestep"), option.get("tolerance"), contacts.get("solimp")
        self.assertEqual(steps, {1: ("0.002", None, "0.995 0.9995 0.0001"), 2: ("0.001", "1e-14", "0.9 0.9999 0.000002")})

    def test_free_objects_sleep_on_request(self):
        self.scene()
        for options, sleeping, flag in (((), [None] * 4, None), (("--asleep",), [None, "init", "init", "init"], "enable")):
            self.trivet("export", "s.glb", "-o", "s.xml", *options)
            root = ElementTree.fromstring(self.read("s.xml"))
            self.assertEqual([b.get("sleep") for b in root.iter("body")], sleeping)
            self.assertEqual(root.find("option/flag").get("sleep"), flag)
        self.refused("export", "s.glb", "-o", "s.sdf", "--asleep", says="--asleep")
        self.refused("export", "s.glb", "-o", "s.xml", "--asleep", "--mujoco", 2, says="--asleep")


class Programs(Exports):
    """Simulators of others, run on what was written."""

    ENGINE = """#!/usr/bin/env python3
import json, sys
import xml.etree.ElementTree as ElementTree
seconds, file = sys.argv[1:]
shift = SHIFT
objects = []
for body in ElementTree.parse(file).getroot().iter("body"):
    x, y, z = map(float, body.get("pos").split())
    objects.append({"name": body.get("name"), "position": [x, y, z - shift], "rotation": list(map(float, body.get("quat").split()))})
print("warming up")
print(json.dumps({"simulator": "Engine of " + seconds + " s", "objects": objects, "contacts": []}))
"""

    def engine(self, text):
        self.write("engine.py", text)
        os.chmod(self.path("engine.py"), 0o755)
        return self.path("engine.py")

    def simulated(self, shift, status):
        engine = self.engine(self.ENGINE.replace("SHIFT", str(shift)))
        out, _ = self.trivet("export", "s.glb", "-o", "s.xml", "--simulate", 2.5, "--simulator", engine, "--json",
                             status=status)
        return json.loads(out)["simulated"]

    def test_program_is_asked_and_objects_counted(self):
        self.scene()
        for shift, status, counts in ((0, 0, (3, 3, 3)), (1.5e-3, 0, (0, 3, 3)), (0.004, 0, (0, 0, 3)), (0.02, 1, (0, 0, 0))):
            said = self.simulated(shift, status)
            self.assertEqual(said["simulator"], "Engine of 2.5 s")
            self.assertEqual(tuple(said[k] for k in ("within_1mm", "within_2mm_2deg", "within_1cm")), counts)
            for entry in said["objects"]:
                self.assertAlmostEqual(entry["moved"], shift, places=6)
                self.assertEqual("why" in entry, shift > 1e-3)
                if shift > 1e-3:  # the program reports no contact at all
                    self.assertTrue(any("finds no contact with" in why for why in entry["why"]), entry)

    def test_programs_that_fail(self):
        self.scene()
        self.trivet("export", "s.glb", "-o", "s.xml")  # the scene is written before a program fails
        command = ("export", "s.glb", "-o", "s.xml", "--simulate", 1, "--simulator")
        self.refused(*command, self.path("none"), says="does not start", status=3)
        self.refused(*command, self.engine("#!/bin/sh\necho no such scene >&2\nexit 3\n"),
                     says=["status 3", "no such scene"], status=3)
        self.refused(*command, self.engine("#!/bin/sh\necho done\n"), says="prints no line of JSON")
        self.refused("export", "s.glb", "-o", "s.xml", "--simulator", "true", says="--simulate")


class Surfaces(Exports):
    """The report tells how far parts stand out of surfaces, which can be bounded."""

    def test_report_tells_where(self):
        self.write("cup.obj", cup_obj())
        self.trivet("run", self.layout([{"name": "cup", "model": "cup.obj"}], [put("cup", 1, 2, 1)]), "-o", "s.glb")
        out, _ = self.trivet("export", "s.glb", "-o", "s.xml", "--json")
        cup = json.loads(out)["objects"][0]
        self.assertEqual(cup["parts"], 1)
        self.assertAlmostEqual(cup["stands_out"]["distance"], 0.1, delta=0.03)  # of the middle of the lid from the walls
        for at, middle in zip(cup["stands_out"]["at"], (1, 2, 0.1)):
            self.assertAlmostEqual(at, middle, delta=0.04)
        out, _ = self.trivet("export", "s.glb", "-o", "s.xml", "--json", "--max-error", 0.002)
        hollow = json.loads(out)
        self.assertEqual(hollow["max_error"], 0.002)
        self.assertLessEqual(hollow["objects"][0]["stands_out"]["distance"], 0.002)
        self.assertGreater(hollow["objects"][0]["parts"], 1)
        self.refused("export", "s.glb", "-o", "s.xml", "--max-error", 0.002, "--collision", "hull", says="fitted")


class Usd(Exports):
    def colliders(self, files):
        """Prims with PhysicsCollisionAPI: (type, other APIs, the prim's lines up to the next one)."""
        for file in files:
            prims = re.split(r"^ *def ", self.read(file).decode(), flags=re.M)[1:]
            for prim in prims:
                apis = re.search(r"apiSchemas = \[(.*)\]", prim)
                names = re.findall(r'"(\w+)"', apis[1]) if apis else []
                if "PhysicsCollisionAPI" in names:
                    yield prim.split()[0], names, prim

    def test_colliders_have_what_newton_and_mujoco_ask_for(self):
        """Rules NEWTON.COL.001, MUJOCO.COL.001 and 002 of NVIDIA's SimReady Foundation."""
        self.scene()
        out, _ = self.trivet("export", "s.glb", "-o", "s.usda", "--json")
        found = list(self.colliders(f for f in json.loads(out)["files"] if f.endswith(".usda")))
        self.assertEqual({kind for kind, _, _ in found}, {"Plane", "Mesh"})
        for kind, names, prim in found:
            self.assertIn("NewtonMeshCollisionAPI" if kind == "Mesh" else "NewtonCollisionAPI", names)
            self.assertIn("MjcCollisionAPI", names)
            self.assertRegex(prim, r"uniform int mjc:condim = \d+\n")
            for word, count in (("solref", 2), ("solimp", 5)):
                values = re.search(r"uniform double\[\] mjc:%s = \[(.*)\]" % word, prim)[1]
                self.assertEqual(len([float(v) for v in values.split(", ")]), count)
            if kind == "Mesh":
                self.assertIn("PhysicsMeshCollisionAPI", names)
                self.assertIn('physics:approximation = "convexHull"', prim)

    def test_groups_have_all_that_collide(self):
        self.scene()
        out, _ = self.trivet("export", "s.glb", "-o", "s.usda", "--json")
        groups = re.findall(r'def PhysicsCollisionGroup "(\w+)" \(\s*prepend apiSchemas = \["CollectionAPI:colliders"\]\s*\)'
                            r'\s*\{\s*rel collection:colliders:includes = \[(.*)\]\s*\}', self.read("s.usda").decode())
        found = {name: re.findall(r"</World/(\w+)>", paths) for name, paths in groups}
        objects = json.loads(out)["objects"]
        self.assertEqual(found, {"Fixed": ["floor"] + [o["file_name"] for o in objects if o["fixed"]],
                                 "Moving": [o["file_name"] for o in objects if not o["fixed"]]})

    def test_triangles_are_none_of_mujocos(self):
        self.scene()
        out, _ = self.trivet("export", "s.glb", "-o", "s.usda", "--collision", "mesh", "--json")
        meshes = [names for kind, names, _ in self.colliders(f for f in json.loads(out)["files"] if f.endswith(".usda")) if kind == "Mesh"]
        self.assertEqual(len(meshes), 3)  # a slab and cubes of two sizes
        for names in meshes:
            self.assertIn("NewtonMeshCollisionAPI", names)
            self.assertNotIn("MjcCollisionAPI", names)

    def test_triangles_of_free_bodies_are_cut_into_convex_pieces(self):
        self.scene()
        out, _ = self.trivet("export", "s.glb", "-o", "s.usda", "--collision", "mesh", "--json")
        kinds = {}
        for file in json.loads(out)["files"][1:]:
            text = self.read(file).decode()
            if "physics:approximation" in text:
                kinds[os.path.basename(file).split("_")[0]] = text.split('physics:approximation = "')[1].split('"')[0]
        self.assertEqual(kinds, {"slab": "none", "cube": "convexDecomposition"})

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


class Readers(Exports):
    """Programs of others read the same poses and masses, whatever the names are."""

    NAMES = ["gr\u00fcne Tasse", "\u8336\u7897", "\u043a\u0443\u0431\u043e\u043a \u2615", "2\u00bd <cups> & \"more\""]

    def laid_out(self):
        objects = [SLAB] + [{"name": name, "model": "cube.obj"} for name in self.NAMES]
        layout = self.layout(objects, [put(name, -0.6 + 0.4 * k, 0.02 * k, 1, [3, 1, 0, 2]) for k, name in enumerate(self.NAMES)])
        self.trivet("run", layout, "-o", "s.glb")
        return self.rows_of_scene()

    def rows_of_scene(self):
        self.trivet("export", "s.glb", "-o", "poses.csv")
        return {r["name"]: r for r in csv.DictReader(io.StringIO(self.read("poses.csv").decode()))}

    def read_by(self, script, file):
        """Objects by their names in the file, as the program of npm reads them."""
        folder = os.path.dirname(NODE_MODULES)
        path = os.path.join(folder, script)
        if not shutil.which("node") or not os.path.exists(path):
            self.skipTest("needs Node.js and the packages of tests/interop (TRIVET_NODE_MODULES)")
        shutil.copy(os.path.join(HERE, "..", "interop", "simulators", "mujoco.mjs"), folder)
        return self.printed_by(["node", path], file)

    def printed_by(self, program, file):
        done = subprocess.run([*program, self.path(file)], capture_output=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        return {o["name"]: o for o in json.loads(done.stdout)["objects"]}

    def same_as_written(self, script, file, fixed_have_mass=True):
        return self.same_rows(self.laid_out(), script, file, fixed_have_mass, "--density", 730)

    def same_rows(self, rows, script, file, fixed_have_mass, *options):
        out, _ = self.trivet("export", "s.glb", "-o", file, "--json", *options)
        seen = self.read_by(script, file) if script.endswith(".mjs") else self.printed_by([script], file)
        for entry in json.loads(out)["objects"]:
            self.assertIn(entry["file_name"], seen)
            found, row = seen[entry["file_name"]], rows[entry["name"]]
            for axis in "xyz":
                self.assertAlmostEqual(found["position"][axis], float(row[axis]), delta=1e-6)
            dot = sum(found["quaternion"][k] * float(row["q" + k]) for k in "wxyz")
            self.assertAlmostEqual(abs(dot), 1, delta=1e-9)
            if fixed_have_mass or not entry["fixed"]:
                self.assertAlmostEqual(found["mass"] / entry["mass"], 1, delta=1e-6)
        return seen

    def check_letters(self, seen):
        self.assertLessEqual({"gr\u00fcne_Tasse", "\u8336\u7897", "\u043a\u0443\u0431\u043e\u043a_\u2615"}, set(seen))

    def test_mujoco(self):
        self.check_letters(self.same_as_written("read_mjcf.mjs", "s.xml"))

    def test_urdf_loader(self):
        self.check_letters(self.same_as_written("read_urdf.mjs", "s.urdf"))

    def test_libsdformat(self):
        if not READ_SDF:
            self.skipTest("needs libsdformat (Debian: libsdformat-dev; TRIVET_READ_SDF)")
        self.check_letters(self.same_as_written(READ_SDF, "s.sdf"))

    def test_tinyusdz(self):
        seen = self.same_as_written("read_usda.mjs", "s.usda", fixed_have_mass=False)
        self.assertLessEqual(set(self.NAMES), {o["given"] for o in seen.values()})

    def test_demos(self):
        """Each program reads each body of the demos."""
        for demo in os.environ.get("TRIVET_DEMOS", "breakfast").split(","):
            self.trivet("demo", demo, "-o", "s.glb")
            rows, files = self.rows_of_scene(), {"read_mjcf.mjs": "s.xml", "read_urdf.mjs": "s.urdf", "read_usda.mjs": "s.usda"}
            if READ_SDF:
                files[READ_SDF] = "s.sdf"
            for script, file in files.items():
                seen = self.same_rows(rows, script, file, script != "read_usda.mjs")
                self.assertGreaterEqual(len(seen), len(rows))


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

    def records(self, name):
        """Rows of an array of records in NumPy's format, read as the format says."""
        data = self.read(name)
        self.assertEqual(data[:8], b"\x93NUMPY\x01\x00")
        begin = 10 + struct.unpack("<H", data[8:10])[0]
        self.assertEqual(begin % 64, 0)
        header = ast.literal_eval(data[10:begin].decode("ascii"))
        self.assertIs(header["fortran_order"], False)
        rows, at = [], begin
        for _ in range(header["shape"][0]):
            row = {}
            for key, kind in header["descr"]:
                size = {"<f8": 8, "|b1": 1}.get(kind) or 4 * int(kind[2:])
                piece, at = data[at:at + size], at + size
                row[key] = struct.unpack("<d", piece)[0] if kind == "<f8" else piece != b"\0" if kind == "|b1" else \
                    piece.decode("utf-32-le").rstrip("\0")
            rows.append(row)
        self.assertEqual(at, len(data))
        return rows

    def test_numpy_equals_csv(self):
        self.scene()
        for table in ("poses", "contacts"):
            self.trivet("export", "s.glb", "-o", "t.csv", "--table", table)
            self.trivet("export", "s.glb", "-o", "t.npy", "--table", table)
            rows, records = self.rows("t.csv"), self.records("t.npy")
            self.assertEqual(len(rows), len(records))
            for row, record in zip(rows, records):
                self.assertEqual(list(row), list(record))
                for key, value in record.items():
                    if isinstance(value, bool):
                        self.assertEqual(row[key], str(value).lower())
                    elif isinstance(value, str):
                        self.assertEqual(row[key], value)
                    elif math.isnan(value):
                        self.assertEqual(row[key], "")
                    else:
                        self.assertEqual(float(row[key]), value)

    def test_numpy_keeps_letters_of_all_scripts(self):
        names = ["gr\u00fcne Tasse", "\u8336\u7897 \U0001f375", "a"]
        layout = self.layout([{"name": n, "model": "cube.obj"} for n in names],
                             [put(n, 0.4 * k, 0, 1) for k, n in enumerate(names)])
        self.trivet("run", layout, "-o", "s.glb")
        self.trivet("export", "s.glb", "-o", "t.npy")
        self.assertEqual([r["name"] for r in self.records("t.npy")], names)
        try:
            import numpy
        except ImportError:
            return
        loaded = numpy.load(self.path("t.npy"))
        self.assertEqual(list(loaded["name"]), names)

    def test_layout_for_arena_has_poses_of_free_objects(self):
        self.scene()
        self.trivet("export", "s.glb", "-o", "layout 7.jsonl", "--table", "arena")
        self.trivet("export", "s.glb", "-o", "t.csv")
        lines = self.read("layout 7.jsonl").decode().splitlines()
        self.assertEqual(len(lines), 1)
        placement = json.loads(lines[0])["variations"]["scene.relation_placement"]
        self.assertEqual((placement["layout_id"], placement["source"]), ("layout 7", "trivet"))
        rows = {r["name"]: r for r in self.rows("t.csv") if r["fixed"] == "false" and r["x"]}
        self.assertEqual(set(placement["poses"]), set(rows))
        self.assertEqual(len(rows), 3)
        for name, pose in placement["poses"].items():
            self.assertEqual(set(pose), {"position_xyz", "rotation_xyzw"})
            self.assertEqual(pose["position_xyz"], [float(rows[name][k]) for k in "xyz"])
            self.assertEqual(pose["rotation_xyzw"], [float(rows[name]["q" + k]) for k in "xyzw"])
            self.assertAlmostEqual(sum(v * v for v in pose["rotation_xyzw"]), 1)
        self.refused("export", "s.glb", "-o", "t.npy", "--table", "arena", says=".jsonl")
        layout = self.layout([SLAB], [])
        self.trivet("run", layout, "-o", "fixed.glb")
        self.refused("export", "fixed.glb", "-o", "t.jsonl", "--table", "arena", says="free")

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
