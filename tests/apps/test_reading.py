"""Model files as they come, end to end: units, polygons, parts and their mass, what is no model."""
import json

from program import Case, box_obj, main, put

FBX = """; FBX 7.4.0 project file
FBXHeaderExtension:  {{
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}}
GlobalSettings:  {{
	Version: 1000
	Properties70:  {{
		P: "UpAxis", "int", "Integer", "",2
		P: "UpAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",{unit}
	}}
}}
Objects:  {{
	Geometry: 1, "Geometry::g", "Mesh" {{
		Vertices: *24 {{
			a: -{h},-{h},-{h},{h},-{h},-{h},{h},{h},-{h},-{h},{h},-{h},-{h},-{h},{h},{h},-{h},{h},{h},{h},{h},-{h},{h},{h}
		}}
		PolygonVertexIndex: *24 {{
			a: 0,3,2,-2,4,5,6,-8,0,1,5,-5,1,2,6,-6,2,3,7,-7,3,0,4,-8
		}}
		GeometryVersion: 124
	}}
	Model: 2, "Model::m", "Mesh" {{
		Version: 232
		Properties70:  {{
			P: "Lcl Scaling", "Lcl Scaling", "", "A",{mirror},1,1
		}}
	}}
}}
Connections:  {{
	C: "OO",2,0
	C: "OO",1,2
}}
"""


def moved(obj, x, y, z):
    """OBJ text moved; faces keep their ids."""
    lines = []
    for line in obj.splitlines():
        words = line.split()
        if words[0] == "v":
            line = "v %r %r %r" % tuple(float(w) + d for w, d in zip(words[1:], (x, y, z)))
        lines.append(line)
    return "\n".join(lines) + "\n"


def joined(*objs):
    """OBJ texts as one, each with the ids of its own vertices."""
    out, first = [], 0
    for obj in objs:
        count = 0
        for line in obj.splitlines():
            words = line.split()
            count += words[0] == "v"
            if words[0] == "f":
                line = "f " + " ".join(str(int(w) + first) for w in words[1:])
            out.append(line)
        first += count
    return "\n".join(out) + "\n"


def turned(obj):
    """Inside out."""
    return "\n".join(" ".join(["f", *reversed(line.split()[1:])]) if line.startswith("f") else line
                     for line in obj.splitlines()) + "\n"


L = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
L_OBJ = "".join("v %g %g %g\n" % (x, y, z) for z in (0, 1) for x, y in L) + "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n" + \
    "".join("f %d %d %d %d\n" % (i + 1, (i + 1) % 6 + 1, (i + 1) % 6 + 7, i + 7) for i in range(6))


class Reading(Case):
    def info(self, name):
        return json.loads(self.trivet("info", name, "--json")[0])

    def box_after(self, objects, operations, *options):
        """The last object with its position, scale and w of its rotation, and the notes."""
        self.layout(objects, operations)
        _, err = self.trivet("run", "layout.json", "-o", "s.glb", "--report", "r.json", *options)
        found = self.read_json("r.json")["objects"][-1]
        m = found["world_from_file"]
        found["position"] = [m[3], m[7], m[11]]
        found["scale"] = sum(m[4 * row] ** 2 for row in range(3)) ** 0.5
        found["w"] = (1 + (m[0] + m[5] + m[10]) / found["scale"]) ** 0.5 / 2
        return found, err

    def test_units(self):
        for unit, half in ((1, 50), (100, 0.5), (2.54, 19.6850393700787), (0.1, 500)):
            self.write("cube.fbx", FBX.format(unit=unit, h=half, mirror=1))
            info = self.info("cube.fbx")
            self.assertAlmostEqual(info["metres_per_unit"], unit / 100, 12)
            found, err = self.box_after([{"name": "a", "model": "cube.fbx"}], [put("a", 0, 0, 2)])
            self.assertAlmostEqual(found["position"][2], 0.5, 4)
            self.assertAlmostEqual(found["scale"], unit / 100, 12)
            self.assertEqual("the unit is" in err, unit != 100, err)

    def test_scale_and_unit_override(self):
        self.write("cube.fbx", FBX.format(unit=1, h=50, mirror=1))
        wanted = [put("a", 0, 0, 200)]
        found, _ = self.box_after([{"name": "a", "model": "cube.fbx", "scale": 1}], wanted)
        self.assertAlmostEqual(found["position"][2], 50, 2)
        found, err = self.box_after([{"name": "a", "model": "cube.fbx"}], wanted, "--unit", "mm")
        self.assertAlmostEqual(found["position"][2], 0.05, 4)
        self.assertIn("as given", err)
        found, _ = self.box_after([{"name": "a", "model": "cube.obj"}], wanted, "--unit", "in")
        self.assertAlmostEqual(found["position"][2], 0.05 * 0.0254, 5)
        append = {"op": "append", "object": "b", "model": "cube.fbx"}
        found, _ = self.box_after([{"name": "a", "model": "cube.obj"}], [append, put("b", 0, 0, 2)])
        self.assertAlmostEqual(found["position"][2], 0.5, 4)

    def test_mirrored(self):
        for mirror in (1, -1):
            self.write("cube.fbx", FBX.format(unit=100, h=0.5, mirror=mirror))
            info = self.info("cube.fbx")
            self.assertAlmostEqual(info["volume"], 1, 6)
            self.assertEqual([part["turned"] for part in info["parts"]], [False])
            self.assertEqual(any("mirrored" in note for note in info["notes"]), mirror < 0)

    def test_notch(self):
        self.write("l.obj", L_OBJ)
        info = self.info("l.obj")
        self.assertAlmostEqual(info["area"], 14, 9)
        self.assertAlmostEqual(info["volume"], 3, 9)
        self.write("c.obj", box_obj(0.25, 0.25, 0.25))
        found, _ = self.box_after([{"name": "l", "model": "l.obj", "fixed": True, "position": [0, 0, 1e-5]},
                                   {"name": "c", "model": "c.obj"}], [put("c", 1.5, 1.5, 3)])
        self.assertAlmostEqual(found["position"][0], 1.5, 6)
        self.assertAlmostEqual(found["position"][1], 1.5, 6)
        self.assertAlmostEqual(found["position"][2], 0.25, 4)
        self.assertAlmostEqual(found["w"], 1, 6)

    def test_parts(self):
        big, small = box_obj(0.05, 0.1, 0.15), moved(box_obj(0.05, 0.05, 0.05), 1, 0, 0)
        for text in (joined(big, small), joined(big, turned(small)), joined(turned(big), small),
                     joined(turned(big), turned(small)), joined(big, big, turned(small))):
            self.write("p.obj", text)
            info = self.info("p.obj")
            self.assertEqual(info["mass_rule"], "volume")
            self.assertAlmostEqual(info["volume"], 0.007, 11)
            self.assertAlmostEqual(info["centre"][0], 1 / 7, 10)
            self.assertEqual([round(part["volume"], 9) for part in info["parts"]], [0.006, 0.001])
        self.write("hollow.obj", joined(big, box_obj(0.025, 0.05, 0.05)))
        info = self.info("hollow.obj")
        self.assertAlmostEqual(info["volume"], 0.0055, 11)
        self.assertEqual([part["cavity"] for part in info["parts"]], [False, True])
        self.assertTrue(any("turned round" in note for note in info["notes"]))

    # A rod whose one end is inside out tips where its mass says.
    def test_tips(self):
        rod = joined(box_obj(0.5, 0.05, 0.05), turned(moved(box_obj(0.1, 0.2, 0.2), 0.6, 0, 0)))
        self.write("rod.obj", rod)
        self.write("post.obj", box_obj(0.1, 0.1, 0.25))
        found, _ = self.box_after(
            [{"name": "post", "model": "post.obj", "fixed": True, "position": [0, 0, 0.25001]},
             {"name": "rod", "model": "rod.obj"}], [put("rod", 0, 0, 0.9)])
        self.assertLess(found["w"], 0.99)

    def test_far(self):
        text = moved(box_obj(0.05, 0.05, 0.05), 500000, 5000000, 100)
        self.write("survey.obj", text)
        info = self.info("survey.obj")
        for size in info["size"]:
            self.assertAlmostEqual(size, 0.1, 8)
        self.assertAlmostEqual(info["volume"], 0.001, 9)

    def test_no_models(self):
        self.write("chair.glb", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n")
        self.refused("info", "chair.glb", says=["chair.glb", "Git LFS"])
        self.write("page.obj", "<!DOCTYPE html><html></html>")
        self.refused("info", "page.obj", says=["page.obj", "web page"])

    def test_importer_at_fault(self):
        env = self.importer("kill -ABRT $$")
        _, err = self.trivet("info", "cube.obj", status=2, env=env)
        self.assertIn("the reader for .obj files stopped with", err)
        self.assertNotIn("broken", err)


if __name__ == "__main__":
    main()
