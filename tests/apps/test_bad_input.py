"""Bad models and layouts: a clear message, status 2, no output, no crash."""
import json
import struct
import subprocess
import unittest

from program import PROGRAM, SLAB, Case, box_obj, main, put, random_bytes

BOX = box_obj(0.05, 0.05, 0.05)


def binary_stl(corner):
    """A binary STL of two triangles, one with this corner."""
    def triangle(*corners):
        return struct.pack("<12f", 0, 0, 1, *sum(corners, ())) + b"\0\0"
    flat = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    return b"\0" * 80 + struct.pack("<I", 2) + triangle(*flat) + triangle(flat[0], flat[1], corner)


class BadModels(Case):
    def check_model(self, name, *says):
        """info, run and put reject and name the file; run also names the place in the layout."""
        self.refused("info", name, says=[name, *says])
        layout = self.layout([SLAB, {"name": "bad", "model": name}], [put("bad", 0, 0, 1)])
        self.refused("run", layout, "-o", "s.glb", "--report", "r.json",
                     says=["layout.json: /objects/1/model: ", name, *says])

    def test_missing(self):
        self.check_model("none.obj", "no such file")

    def test_a_folder(self):
        self.write("folder.obj/x.txt", "")
        self.check_model("folder.obj", "folder")

    def test_empty(self):
        for name in ("empty.obj", "empty.glb", "empty.stl", "empty.ply"):
            self.write(name, "")
            self.check_model(name, "empty")

    def test_unknown_extension(self):
        self.write("model.xyz1", BOX)
        self.check_model("model.xyz1", "accepted")

    def test_truncated(self):
        self.trivet("run", self.layout([SLAB], name="slab.json"), "-o", "whole.glb")
        self.trivet("run", "slab.json", "-o", "whole.stl")
        self.trivet("run", "slab.json", "-o", "whole.ply")
        for extension in ("glb", "stl", "ply"):
            whole = self.read("whole." + extension)
            for i, length in enumerate((10, len(whole) // 2, len(whole) - 30)):
                self.check_model(self.write("cut%d.%s" % (i, extension), whole[:length]))

    def test_random_bytes(self):
        for extension in ("obj", "glb", "gltf", "stl", "ply", "dae", "fbx", "3ds"):
            for seed, count in enumerate((1, 100, 20_000)):
                name = "random%d.%s" % (seed, extension)
                self.check_model(self.write(name, random_bytes(count, seed)))

    def test_oversized(self):
        self.write("large.obj", BOX + "# padding\n" * 100_000)
        self.refused("info", "large.obj", "--max-file-mb", "0.5", says=["large.obj", "500000"])
        self.trivet("info", "large.obj")

    def test_non_finite_coordinates(self):
        for i, number in enumerate(("nan", "inf", "-inf", "1e39", "1e999")):
            self.write("bad%d.obj" % i, BOX.replace("v 0.05", "v " + number, 1))
            self.check_model("bad%d.obj" % i)
        for i, number in enumerate((float("nan"), float("inf"))):
            self.write("bad%d.stl" % i, binary_stl((0.0, 0.0, number)))
            self.check_model("bad%d.stl" % i, "not finite")

    def test_no_faces(self):
        self.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")
        self.check_model("points.obj")
        self.write("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")
        self.check_model("line.obj", "no triangle")

    def test_index_out_of_range(self):
        for i, index in enumerate(("9", "-10", "0", "4000000000", "99999999999999999999")):
            self.write("index%d.obj" % i, BOX + "f 1 2 %s\n" % index)
            self.check_model("index%d.obj" % i)

    def test_put_rejects_them(self):
        self.trivet("run", self.two_cubes(), "-o", "s.glb")
        self.write("random.obj", random_bytes(1000))
        for name in ("none.obj", "random.obj", "layout.json"):
            self.refused("put", "s.glb", name, "--position", 0, 0, 1, "-o", "t.glb", says=name)


class BadLayouts(Case):
    def check_text(self, text, *says):
        self.write("bad.json", text)
        self.refused("run", "bad.json", "-o", "s.glb", "--report", "r.json",
                     says=["bad.json: ", *says])
        self.refused("check", "bad.json", says=["bad.json: ", *says])

    def check_object(self, says, **more):
        self.check_text(json.dumps({"trivet": 1, "objects": [
            SLAB, {"name": "a", "model": "cube.obj", **more}]}), "/objects/1", says)

    def test_missing(self):
        self.refused("run", "none.json", "-o", "s.glb", says="none.json: cannot be opened")

    def test_invalid_json(self):
        self.check_text("", "is empty")
        self.check_text('{"trivet": 1,\n "objects": [', "line 2, column 14")
        self.check_text(random_bytes(1000), "line 1, column 1")
        self.check_text("[" * 1_000_000)

    def test_oversized(self):
        layout = self.layout([SLAB])
        self.write(layout, self.read(layout) + b" " * 100_000)
        self.refused("run", layout, "-o", "s.glb", "--max-file-mb", 0.05,
                     says="larger than the limit of 50000 bytes")

    def test_values(self):
        self.check_object("/scale: 0 is not accepted; accepted: a number from", scale=0)
        self.check_object("/scale: -1 is not accepted", scale=-1)
        self.check_object("/scale: \"1\" is not accepted", scale="1")
        self.check_object("/colour: unknown key; accepted: name, model", colour="red")
        self.check_object('/name: "slab" is already the name of /objects/0', name="slab")
        self.check_object('/name: "floor" is not accepted', name="floor")
        self.check_object("a quaternion [w, x, y, z] whose length is not zero",
                          position=[0, 0, 1], rotation=[0, 0, 0, 0])

    def test_non_finite_numbers(self):
        for number in ("NaN", "Infinity", "1e999"):
            self.check_text('{"trivet": 1, "objects": [{"name": "a", "model": "cube.obj", '
                            '"scale": %s}]}' % number, "line 1, column")

    def test_operations(self):
        self.check_text(json.dumps({"trivet": 1, "objects": [SLAB],
                                    "operations": [{"op": "throw", "object": "slab"}]}),
                        '/operations/0/op: "throw" is not accepted; accepted: "put", "push"')
        for op, key in (("turn", "angle_deg"), ("pick_up", "distance"),
                        ("translate", "by"), ("rotate", "axis"), ("append", "model"),
                        ("duplicate", "as"), ("rename", "to"), ("group", "group")):
            self.check_text(json.dumps({"trivet": 1, "objects": [SLAB],
                                        "operations": [{"op": op, "object": "slab"}]}),
                            '/operations/0: the key "%s" is missing' % key)
        for op, what in (("push", "target"), ("put", "place")):
            self.check_text(json.dumps({"trivet": 1, "objects": [SLAB],
                                        "operations": [{"op": op, "object": "slab"}]}),
                            '/operations/0: a %s is missing' % what)
        self.check_text(json.dumps({"trivet": 1, "objects": [SLAB],
                                    "operations": [put("spoon", 0, 0, 1)]}),
                        '/operations/0/object: "spoon" is not accepted')

    def test_object_beyond_coordinate_limit(self):
        self.write("huge.obj", box_obj(1e6, 1e6, 1e6))
        layout = self.layout([{"name": "a", "model": "huge.obj", "scale": 1e12}])
        self.refused("run", layout, "-o", "s.glb", says=['/objects/0: "a" reaches', "accepted: up to"])


class DeepNesting(Case):
    """200,000 levels in every file of JSON: a sentence, not the end of the stack."""

    def refuse(self, *arguments, status=2):
        out, err = self.trivet(*arguments, status=status)
        self.assertIn("nested too deep", out + err)
        self.assertLess(len(out + err), 1000)

    def test_all_readers(self):
        for kind, text in (("array", "[" * 200_000), ("object", '{"a":' * 200_000), ("whole", "[" * 200_000 + "]" * 200_000)):
            layout = self.write("l.json", '{"trivet": 1, "objects": ' + text)
            self.refuse("run", layout, "-o", "s.glb")
            self.refuse("check", layout)
            self.refuse("arrange", layout, "-o", "s.glb")
            self.refuse("session", layout, "--journal", "j")
            self.refuse("serve", layout)
            self.refuse("batch", self.write("r.json", '{"trivet_recipe": 1, "objects": ' + text), "--count", 1, "--out", "b")
            self.refuse("info", self.write("m.gltf", '{"asset": ' + text))
            length = (len(text) + 3) // 4 * 4
            glb = struct.pack("<4sIII4s", b"glTF", 2, 20 + length, length, b"JSON") + text.encode().ljust(length)
            self.refuse("info", self.write("m.glb", glb))
            self.refuse("check", "m.glb")
            self.trivet("run", self.layout([SLAB]), "-o", "s.glb")
            self.refuse("render", "s.glb", "--cameras", self.write("c.json", text), "--ids", "i_{}.png")
            # A line of a journal that cannot be read is damaged.
            self.refused("replay", self.write("j", text + "\n"), "-o", "t.glb", says="is no journal")
            out, _ = self.session_of("s.glb", text)
            self.assertIn("nested too deep", out)
            self.write("b/run.json", text)
            for verb in (("status", "b"), ("merge", "b", "-o", "m.csv")):
                self.refuse("batch", *verb)

    def session_of(self, scene, line):
        result = subprocess.run([PROGRAM, "session", scene], cwd=self.folder, input=line + "\n", text=True, capture_output=True,
                                timeout=100)
        self.assertEqual(result.returncode, 0)
        return result.stdout, result.stderr


class BadScenes(Case):
    def test_foreign_scenes(self):
        self.write("random.glb", random_bytes(1000))
        self.write("empty.glb", b"")
        for name in ("none.glb", "random.glb", "empty.glb", "cube.obj"):
            self.refused("check", name, says=name)
            self.refused("put", name, "cube.obj", "--position", 0, 0, 1, "-o", "t.glb", says=name)

    def test_truncated_scenes(self):
        self.trivet("run", self.two_cubes(), "-o", "s.glb")
        whole = self.read("s.glb")
        for length in (4, 30, len(whole) // 3, len(whole) - 1):
            self.write("cut.glb", whole[:length])
            self.refused("check", "cut.glb", says="cut.glb")
            self.refused("render", "cut.glb", "-o", "p.png", says="cut.glb")


if __name__ == "__main__":
    main()
