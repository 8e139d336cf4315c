"""Scenes of other programs, laid out in place: only transforms of nodes change."""
import copy
import json
import os
import struct
import sys
import unittest
from pathlib import Path

from program import SOURCE_DIR, Case, main, put

sys.path.insert(0, str(Path(SOURCE_DIR) / "tests" / "interop"))
import make_models  # noqa: E402


def room(wrapped=False):
    """A room as written by another program: a floor, a table in parts, cups, a camera, a light, an
    animated fan, unknown extensions."""
    g = make_models.Gltf()
    g.json |= {
        "extensionsUsed": ["KHR_lights_punctual", "ACME_unknown"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 3}]},
                       "ACME_unknown": {"node": 3, "deep": [1, {"x": None}]}},
        "extras": {"author": "somebody", "number": 0.1},
        "materials": [{"name": "wood"}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
        "animations": [{"name": "turn", "channels": [
            {"sampler": 0, "target": {"node": 6, "path": "rotation"}}],
            "samplers": [{"input": 0, "output": 1}]}],
    }
    g.accessor([0.0, 1.0], "SCALAR", min=[0], max=[1])
    g.json["bufferViews"][-1].pop("target")
    g.accessor([(0, 0, 0, 1), (0, 1, 0, 0)], "VEC4")
    g.json["bufferViews"][-1].pop("target")
    for name, size, centre in [("floor", (6, 0.1, 6), (0, -0.05, 0)),
                               ("top", (1, 0.04, 0.6), (0, 0.721, 0)),
                               ("leg", (0.05, 0.7, 0.05), (0, 0.35, 0)),
                               ("cup", (0.08, 0.1, 0.08), (0, 0.05, 0))]:
        g.json["meshes"].append({"name": name, "primitives": [g.box(size, centre, 0)]})
    legs = [{"name": "leg", "mesh": 2, "translation": [x, 0, z]}
            for x in (-0.4, 0.4) for z in (-0.2, 0.2)]
    g.json["nodes"] = [
        {"name": "floor", "mesh": 0},
        {"name": "table", "children": [2, 7, 8, 9, 10], "translation": [0, 0.0001, 0]},
        {"name": "top", "mesh": 1, "extensions": {"ACME_unknown": {"keep": [1, 2]}}},
        {"name": "cup", "mesh": 3, "translation": [0.1, 0.8, 0.1],
         "rotation": [0, 0.3826834323650898, 0, 0.9238795325112867], "extras": {"tea": True}},
        {"name": "cup", "mesh": 3, "matrix": [1, 0, 0, 0, 0, 1.5, 0, 0, 0, 0, 2, 0, -0.2, 0.8, 0, 1]},
        {"name": "view", "camera": 0, "translation": [3, 2, 3],
         "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "fan", "mesh": 3, "translation": [0, 2.5, 0]}, *legs]
    roots = [0, 1, 3, 4, 5, 6]
    if wrapped:
        g.json["nodes"].append({"name": "Sketchfab_model", "children": roots,
                                "rotation": [0, 0.1736481776669303, 0, 0.984807753012208],
                                "scale": [2, 2, 2]})
        roots = [len(g.json["nodes"]) - 1]
    g.json |= {"scene": 0, "scenes": [{"name": "room", "nodes": roots}]}
    return g


def glb(g):
    """The binary form, with an unknown third chunk."""
    g.json["buffers"] = [{"byteLength": len(g.binary)}]
    text = json.dumps(g.json).encode()
    text += b" " * (-len(text) % 4)
    binary = g.binary + b"\0" * (-len(g.binary) % 4)
    chunks = b"".join(struct.pack("<I4s", len(data), kind) + data for kind, data in
                      [(b"JSON", text), (b"BIN\0", binary), (b"ACME", b"what is this?123")])
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def chunks(data):
    out, at = [], 12
    while at < len(data):
        length, kind = struct.unpack("<I4s", data[at:at + 8])
        out.append((kind, data[at + 8:at + 8 + length]))
        at += 8 + length
    return out


class InPlace(Case):
    def run_scene(self, scene, picked, operations, status=0, output="out.glb", **more):
        layout = self.write("layout.json", json.dumps(
            {"trivet": 1, "scene": scene, **more,
             "objects": [p if isinstance(p, dict) else {"name": p} for p in picked],
             "operations": operations}))
        return self.trivet("run", layout, "-o", output, "--report", "report.json", status=status)

    def changed_nodes(self, before, after):
        """Indices of differing nodes; all else must be equal."""
        before, after = copy.deepcopy(before), copy.deepcopy(after)
        self.assertEqual(len(before["nodes"]), len(after["nodes"]))
        changed = []
        for i, (a, b) in enumerate(zip(before["nodes"], after["nodes"])):
            if a != b:
                changed.append(i)
            for node in (a, b):
                for key in ("matrix", "translation", "rotation", "scale"):
                    node.pop(key, None)
        self.assertEqual(before, after)
        self.assertEqual(list(before), list(after))  # the order of members, too
        return changed

    def test_changes_only_laid_out_transforms(self):
        g = room()
        self.write("room.glb", glb(g))
        self.run_scene("room.glb", ["cup", "cup_2"], [
            put("cup", 0.1, 0.1, 1.5, [0.8, 0.1, 0.2, 0.3]),
            put("cup_2", -0.2, 0, 1.2)])
        before, after = chunks(self.read("room.glb")), chunks(self.read("out.glb"))
        self.assertEqual([k for k, _ in before], [k for k, _ in after])
        self.assertEqual(before[1:], after[1:])
        document = json.loads(after[0][1])
        self.assertEqual(self.changed_nodes(json.loads(before[0][1]), document), [3, 4])
        cup, second = document["nodes"][3], document["nodes"][4]
        self.assertNotIn("matrix", cup)
        self.assertNotIn("scale", cup)
        self.assertIn("matrix", second)  # non-uniform scale is preserved
        columns = [second["matrix"][4 * c:4 * c + 3] for c in range(3)]
        lengths = sorted(sum(x * x for x in c) ** 0.5 for c in columns)
        for length, expected in zip(lengths, (1, 1.5, 2)):
            self.assertAlmostEqual(length, expected, places=6)
        check = self.read_json("report.json")["check"]
        self.assertEqual(check["interpenetrating_pairs"], 0)
        self.assertTrue(check["all_at_rest"])

    def test_result_is_stable_when_read_again(self):
        self.write("room.glb", glb(room()))
        self.run_scene("room.glb", ["cup"], [put("cup", 0.1, 0.1, 1.5)])
        first = self.read_json("report.json")["objects"]
        self.run_scene("out.glb", ["cup"], [], output="again.glb")
        self.assertEqual(chunks(self.read("out.glb"))[1:], chunks(self.read("again.glb"))[1:])
        self.assertEqual(self.changed_nodes(json.loads(chunks(self.read("out.glb"))[0][1]),
                                            json.loads(chunks(self.read("again.glb"))[0][1])), [])
        for a, b in zip(first, self.read_json("report.json")["objects"]):
            for x, y in zip(a["world_from_file"], b["world_from_file"]):
                self.assertAlmostEqual(x, y, places=6)

    def test_a_table_carries_its_cups(self):
        self.write("room.glb", glb(room()))
        self.run_scene("room.glb", ["table", "cup"], [
            put("table", 0, 0, 0.01), put("cup", 0.1, 0.1, 1.5),
            {"op": "push", "object": "table", "direction": [1, 0], "distance": 0.3}])
        after = json.loads(chunks(self.read("out.glb"))[0][1])
        before = json.loads(chunks(self.read("room.glb"))[0][1])
        self.assertEqual(self.changed_nodes(before, after), [1, 3])
        self.assertGreater(after["nodes"][1]["translation"][0], 0.2)
        self.assertGreater(after["nodes"][3]["translation"][0], 0.3)

    def test_objects_inside_wrapper_nodes(self):
        self.write("room.glb", glb(room(wrapped=True)))
        self.run_scene("room.glb", ["cup"], [put("cup", 0.1, 0.1, 3)])
        before, after = (json.loads(chunks(self.read(f))[0][1]) for f in ("room.glb", "out.glb"))
        self.assertEqual(self.changed_nodes(before, after), [3])
        # On the table, scaled by 2 in the wrapper: 0.74 in its own units.
        self.assertAlmostEqual(after["nodes"][3]["translation"][1], 0.74, delta=0.01)

    def test_rules(self):
        self.write("room.glb", glb(room()))
        for rule, name in (("roots", "table"), ("groups", "table"), ("meshes", "leg_3")):
            self.run_scene("room.glb", [{"name": name, "fixed": True}], [], scene_objects=rule)
        self.run_scene("room.glb", ["nothing"], [], status=2, scene_objects="meshes")

    def test_child_meshes_stay_with_parents(self):
        g = room()
        g.json["nodes"][3]["children"] = [4]
        g.json["nodes"][4]["matrix"][12:15] = [0.9, 0, 0]
        g.json["scenes"][0]["nodes"].remove(4)
        self.write("room.glb", glb(g))
        self.run_scene("room.glb", ["cup"], [put("cup", 0.1, 0.1, 1.5)], scene_objects="meshes")
        before, after = (json.loads(chunks(self.read(f))[0][1]) for f in ("room.glb", "out.glb"))
        self.assertEqual(self.changed_nodes(before, after), [3, 4])

    def test_gltf_with_companion_files(self):
        g = room()
        (Path(self.folder) / "in").mkdir()
        (Path(self.folder) / "out").mkdir()
        g.write(Path(self.path("in/room.gltf")), "room.bin")
        way = ("in/room.gltf", ["cup"], [put("cup", 0.1, 0.1, 1.5)])
        self.write("out/room.bin", "somebody's")
        self.says(*way, "out/room.bin", "accepted: another name", output="out/room.gltf")
        self.assertEqual(self.read("out/room.bin"), b"somebody's")
        os.remove(self.path("out/room.bin"))
        for _ in range(2):  # the second time over its own files
            self.run_scene(*way, output="out/room.gltf")
        self.assertEqual(self.read("in/room.bin"), self.read("out/room.bin"))
        self.assertEqual(self.changed_nodes(self.read_json("in/room.gltf"),
                                            self.read_json("out/room.gltf")), [3])

    def test_content_tells_binary_scenes_from_text_whatever_their_names(self):
        put_down = [put("cup", 0.1, 0.1, 1.5)]
        room().write(Path(self.path("text.glb")), "room.bin")
        self.run_scene("text.glb", ["cup"], put_down, output="out.glb")
        self.assertEqual(self.changed_nodes(self.read_json("text.glb"), self.read_json("out.glb")), [3])
        self.run_scene("out.glb", ["cup"], [], output="again.glb")
        self.assertEqual(self.changed_nodes(self.read_json("out.glb"), self.read_json("again.glb")), [])
        self.write("binary.gltf", glb(room()))
        self.run_scene("binary.gltf", ["cup"], put_down, output="out.gltf")
        before, after = chunks(self.read("binary.gltf")), chunks(self.read("out.gltf"))
        self.assertEqual(before[1:], after[1:])
        self.assertEqual(self.changed_nodes(json.loads(before[0][1]), json.loads(after[0][1])), [3])

    def test_companion_files_with_points_in_their_names(self):
        for folder in ("in", "out"):
            (Path(self.folder) / folder).mkdir()
        room().write(Path(self.path("in/room.gltf")), "..room.bin")
        self.run_scene("in/room.gltf", ["cup"], [put("cup", 0.1, 0.1, 1.5)], output="out/room.gltf")
        self.assertEqual(self.read("in/..room.bin"), self.read("out/..room.bin"))
        document = self.read_json("in/room.gltf")
        document["images"] = [{"uri": "../\u0085" + 200 * "x"}]
        self.write("in/room.gltf", json.dumps(document))
        self.says("in/room.gltf", ["cup"], [put("cup", 0.1, 0.1, 1.5)], 'the scene names "../?x',
                  'x...", which lies outside its folder', output="out/other.gltf")

    def says(self, scene, picked, operations, *parts, **more):
        before = self.files()
        out, err = self.run_scene(scene, picked, operations, status=2, **more)
        for part in parts:
            self.assertIn(part, err)
        self.assertEqual([f for f in self.files() if f not in before and f != "layout.json"], [])

    def test_refusals(self):
        g = room()
        g.json["nodes"].append({"name": "uneven", "children": [3], "scale": [1, 3, 1]})
        g.json["scenes"][0]["nodes"].remove(3)
        g.json["scenes"][0]["nodes"].append(11)
        self.write("room.glb", glb(g))
        self.says("room.glb", ["saucer"], [], "/objects/0/name", "saucer", "accepted", "table")
        self.says("room.glb", ["fan"], [], "fan", "animated")
        self.says("room.glb", ["cup"], [{"op": "delete", "object": "cup"}], "delete", "keeps its nodes")
        self.says("room.glb", ["cup"], [], "accepted: .glb", output="out.gltf")
        self.says("room.glb", ["cup_2"],  # in the order of the tree
                  [{"op": "translate", "object": "cup_2", "by": [0, 0, 0.3]},
                   {"op": "rotate", "object": "cup_2", "axis": [1, 0, 0], "angle_deg": 20}], "shear",
                  scene_objects="meshes")
        self.says("room.glb", [{"name": "cup", "model": "x.obj"}], [], "model")
        self.says("none.glb", ["cup"], [], "none.glb")
        self.says("room.glb", ["cup"], [], "would be overwritten", output="room.glb")

    def test_float32_positions_match_the_layout(self):
        """An independent reader, in double: the report's matrices and the file's agree."""
        self.write("room.glb", glb(room(wrapped=True)))
        self.run_scene("room.glb", ["cup", "cup_2"], [put("cup", 0.3, 0.1, 3, [0.8, 0.1, 0.2, 0.3]),
                                                      put("cup_2", -0.2, 0, 3, [1, 0, 0, 2])])
        document = json.loads(chunks(self.read("out.glb"))[0][1])
        report = {o["name"]: o for o in self.read_json("report.json")["objects"]}
        wrapper = local_matrix(document["nodes"][-1])
        for name, node in (("cup", 3), ("cup_2", 4)):
            world = product(wrapper, local_matrix(document["nodes"][node]))
            origin = [world[0][3], -world[2][3], world[1][3]]
            for i in range(3):
                self.assertAlmostEqual(origin[i], report[name]["world_from_file"][4 * i + 3], delta=3e-7)


def product(a, b):
    return [[sum(a[r][k] * b[k][c] for k in range(4)) for c in range(4)] for r in range(4)]


def local_matrix(node):
    if "matrix" in node:
        m = node["matrix"]
        return [[m[4 * c + r] for c in range(4)] for r in range(4)]
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    t, s = node.get("translation", [0, 0, 0]), node.get("scale", [1, 1, 1])
    r = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return [[r[i][k] * s[k] for k in range(3)] + [t[i]] for i in range(3)] + [[0, 0, 0, 1]]


if __name__ == "__main__":
    main()
