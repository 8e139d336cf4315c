"""Films of operations: animated .glb files."""
import json
import math
import os
import struct

from program import SLAB, Case, main, put


def parts_of(glb):
    """JSON and binary chunk of a .glb."""
    magic, version, size = struct.unpack("<4sII", glb[:12])
    assert (magic, version, size) == (b"glTF", 2, len(glb))
    length, kind = struct.unpack("<I4s", glb[12:20])
    assert kind == b"JSON"
    return json.loads(glb[20:20 + length]), glb[28 + length:]


def rotated(q, v):
    """A vector by a quaternion x y z w."""
    x, y, z, w = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0]]


class Film:
    """The motions of an animated .glb: by object and path lists of times and values."""

    def __init__(self, glb):
        self.json, self.binary = parts_of(glb)
        self.nodes = {node["name"]: node for node in self.json["nodes"]}
        self.paths = {}
        animations = self.json.get("animations", [])
        assert len(animations) <= 1
        for channel in animations[0]["channels"] if animations else []:
            sampler = animations[0]["samplers"][channel["sampler"]]
            name = self.json["nodes"][channel["target"]["node"]]["name"]
            times = [row[0] for row in self.rows(sampler["input"])]
            assert times == sorted(set(times)) and times[0] >= 0
            values = self.rows(sampler["output"])
            assert len(values) == len(times)
            self.paths[name, channel["target"]["path"]] = times, values
            assert sampler["interpolation"] == ("STEP" if channel["target"]["path"] == "scale" else "LINEAR")

    def rows(self, accessor):
        a = self.json["accessors"][accessor]
        view = self.json["bufferViews"][a["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[a["type"]]
        values = struct.unpack_from("<%df" % (a["count"] * width), self.binary, view["byteOffset"])
        return [values[i:i + width] for i in range(0, len(values), width)]

    def position(self, name, time):
        """Position of the object's origin, z up."""
        times, values = self.paths[name, "translation"]
        k = max([i for i, t in enumerate(times) if t <= time], default=0)
        x, y, z = values[k]
        if k + 1 < len(times):
            part = (time - times[k]) / (times[k + 1] - times[k])
            x, y, z = (a + max(0, part) * (b - a) for a, b in zip(values[k], values[k + 1]))
        return x, -z, y

    def end(self, name):
        """Rows of the matrix of a node's last key, z up."""
        if (name, "translation") not in self.paths:
            return None
        x, y, z = self.paths[name, "translation"][1][-1]
        q = self.paths[name, "rotation"][1][-1]
        scale = self.nodes[name].get("scale", [1, 1, 1])[0] or self.paths[name, "scale"][1][-1][0]
        columns = [[scale * c for c in rotated(q, e)] for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        y_up = [[columns[c][r] for c in range(3)] + [(x, y, z)[r]] for r in range(3)]
        return [y_up[0], [-v for v in y_up[2]], y_up[1]]

    def seconds(self):
        return max(times[-1] for times, _ in self.paths.values())


class Animation(Case):
    def run_layout(self, objects, operations, **more):
        layout = self.layout(objects, operations, **more)
        self.trivet("run", layout, "-o", "s.glb", "--report", "r.json", "--animation", "f.glb")
        return Film(self.read("f.glb")), {o["name"]: o for o in self.read_json("r.json")["objects"]}

    def check_ends(self, film, report):
        """The last keys are the poses of the report, to float32."""
        for name, entry in report.items():
            end = film.end(name)
            if end is None or not entry["world_from_file"]:
                continue
            for got, wanted in zip(sum(end, []), entry["world_from_file"]):
                self.assertAlmostEqual(got, wanted, 5, name)

    def test_a_fall_and_what_is_hidden_before(self):
        film, report = self.run_layout(
            [SLAB, {"name": "a", "model": "cube.obj", "scale": 0.5}, {"name": "b", "model": "cube.obj"}],
            [put("a", 0.2, 0, 1), put("b", 0.2, 0.02, 1, [3, 1, 0, 2])])
        self.check_ends(film, report)
        self.assertNotIn(("slab", "translation"), film.paths)  # it stands still
        self.assertIn("matrix", film.nodes["slab"])
        self.assertNotIn("matrix", film.nodes["a"])
        times, scales = film.paths["a", "scale"]
        self.assertEqual(scales[0], (0, 0, 0))
        shown = times[[s[0] > 0 for s in scales].index(True)]
        self.assertAlmostEqual(film.position("a", shown)[2], 1, 5)
        self.assertAlmostEqual(scales[-1][0], 0.5, 6)
        # Down all the way, faster and faster.
        heights = [film.position("a", shown + 0.05 * k)[2] for k in range(9)]
        drops = [a - b for a, b in zip(heights, heights[1:])]
        self.assertTrue(all(0 < a < b for a, b in zip(drops, drops[1:])), drops)
        # b comes after a.
        later = film.paths["b", "scale"]
        self.assertGreater(later[0][[s[0] > 0 for s in later[1]].index(True)], shown + 0.4)
        for (_, path), (_, values) in film.paths.items():
            if path == "rotation":
                for q, r in zip(values, values[1:]):
                    self.assertAlmostEqual(math.hypot(*q), 1, 5)
                    self.assertGreater(sum(a * b for a, b in zip(q, r)), 0.9)

    def test_loads_go_with_what_carries_them(self):
        film, report = self.run_layout(
            [SLAB, {"name": "plate", "model": "slab.obj", "scale": 0.2}, {"name": "cup", "model": "cube.obj", "scale": 0.3}],
            [put("plate", 0, 0, 1), put("cup", 0, 0.02, 1),
             {"op": "push", "object": "plate", "direction": [1, 0], "distance": 0.3}])
        self.check_ends(film, report)
        begin = film.paths["plate", "translation"][0][-1] - 0.2
        apart = [[a - b for a, b in zip(film.position("cup", t), film.position("plate", t))]
                 for t in (begin + 0.02 * k for k in range(11))]
        for way in apart:
            for a, b in zip(way, apart[0]):
                self.assertAlmostEqual(a, b, 5)
        self.assertGreater(film.position("cup", begin + 0.2)[0], film.position("cup", begin)[0] + 0.1)

    def test_a_turn_goes_round(self):
        film, report = self.run_layout(
            [SLAB, {"name": "a", "model": "cube.obj"}],
            [put("a", 0.2, 0, 1), {"op": "rotate", "object": "a", "axis": [0, 0, 1], "centre": [0, 0, 0], "angle_deg": 170,
                                   "free": True}])
        self.check_ends(film, report)
        end = film.seconds()
        for k in range(10):
            x, y, _ = film.position("a", end - 0.02 * k)
            self.assertAlmostEqual(math.hypot(x, y), 0.2, 3)

    def test_hides_removed_objects(self):
        film, _ = self.run_layout([SLAB, {"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}],
                                  [put("a", 0, 0, 1), put("b", 0.3, 0, 1), {"op": "delete", "object": "a"},
                                   {"op": "unplace", "object": "b"}])
        for name in ("a", "b"):
            scales = film.paths[name, "scale"][1]
            self.assertEqual([scales[0][0], scales[-1][0]], [0, 0])
            self.assertTrue(any(s[0] == 1 for s in scales))

    def test_names_are_those_of_the_end(self):
        film, report = self.run_layout(
            [SLAB, {"name": "a", "model": "cube.obj"}],
            [put("a", 0, 0, 1), {"op": "rename", "object": "a", "to": "b"},
             {"op": "duplicate", "object": "b", "as": "a"}, put("a", 0.3, 0, 1)])
        self.assertEqual(sorted(film.nodes), ["a", "b", "slab"])
        self.check_ends(film, report)
        self.assertAlmostEqual(film.position("b", film.seconds())[0], 0, 5)

    def test_the_scene_is_the_same_and_far_ones_keep_their_digits(self):
        layout = self.layout([dict(SLAB, position=[4000, -2000, 0.050001]), {"name": "a", "model": "cube.obj"}],
                             [put("a", 4000.1, -2000, 1)])
        for threads in (1, 3):
            self.trivet("run", layout, "-o", "s%d.glb" % threads, "--animation", "f%d.glb" % threads, "--threads", threads)
        self.trivet("run", layout, "-o", "plain.glb")
        self.assertEqual(self.read("s1.glb"), self.read("plain.glb"))
        self.assertEqual(self.read("f1.glb"), self.read("f3.glb"))
        film = Film(self.read("f1.glb"))
        self.assertIn("origin", film.nodes)
        x, y, _ = film.position("a", film.seconds())
        origin = film.nodes["origin"]["translation"]
        self.assertAlmostEqual(x + origin[0], 4000.1, 4)
        self.assertAlmostEqual(y - origin[2], -2000, 4)

    def test_nothing_moves(self):
        film, _ = self.run_layout([SLAB], [])
        self.assertEqual(film.paths, {})
        self.assertEqual(list(film.nodes), ["slab"])
        self.trivet("run", self.layout([], []), "-o", "e.glb", "--animation", "e2.glb")
        self.assertEqual(Film(self.read("e2.glb")).nodes if "nodes" in parts_of(self.read("e2.glb"))[0] else {}, {})

    def test_bad_input(self):
        self.two_cubes()
        run = ("run", "layout.json", "-o", "s.glb", "--animation")
        self.refused(*run, "f.gltf", says=["f.gltf", ".glb"])
        self.refused(*run, "s.glb", says="s.glb")
        self.refused(*run, "cube.obj", says="cube.obj")
        self.refused(*run, "/proc/missing/f.glb", says="/proc/missing/f.glb", status=3)
        self.trivet("run", "layout.json", "-o", "room.glb")
        self.write("in.json", json.dumps({"trivet": 1, "scene": "room.glb", "objects": [{"name": "a"}], "operations": []}))
        self.refused("run", "in.json", "-o", "o.glb", "--animation", "f.glb", says=["--animation", "layouts of models"])


def webp_chunks(data):
    """Names and contents."""
    assert data[:4] == b"RIFF" and data[8:12] == b"WEBP" and len(data) == 8 + struct.unpack("<I", data[4:8])[0]
    at, out = 12, []
    while at < len(data):
        name, size = data[at:at + 4].decode(), struct.unpack("<I", data[at + 4:at + 8])[0]
        out.append((name, data[at + 8:at + 8 + size]))
        at += 8 + size + size % 2
    return out


class Frames(Case):
    """trivet render LAYOUT --animation."""
    VIEW = ("--width", 64, "--height", 48, "--samples", 1, "--renderer", "path", "--camera", 1.5, -1.5, 1, 0, 0, 0.2)

    def start(self):
        return self.layout([SLAB, {"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}],
                           [put("a", 0.2, 0, 1), put("b", -0.2, 0, 0.6)])

    def seconds(self, layout):
        self.trivet("run", layout, "-o", "s.glb", "--animation", "f.glb")
        return Film(self.read("f.glb")).seconds()

    def test_numbered_pictures(self):
        layout = self.start()
        seconds = self.seconds(layout)
        self.trivet("render", layout, "--animation", "frames/{}.png", "--fps", 10, *self.VIEW)
        names = sorted(os.listdir(self.path("frames")))
        self.assertEqual(names, ["%04d.png" % (k + 1) for k in range(len(names))])
        self.assertGreaterEqual(len(names), 10 * seconds)
        self.assertLess(len(names), 10 * (seconds + 0.3) + 2)
        frames = [self.read("frames/" + name) for name in names]
        self.assertGreater(len(set(frames)), len(frames) // 2)
        # The first has no cube yet, the last is the scene.
        self.trivet("render", "s.glb", "-o", "end.png", *self.VIEW)
        self.assertEqual(frames[-1], self.read("end.png"))
        self.trivet("run", self.layout([SLAB], []), "-o", "slab.glb")
        self.trivet("render", "slab.glb", "-o", "begin.png", *self.VIEW)
        self.assertEqual(frames[0], self.read("begin.png"))

    def test_animated_webp(self):
        layout = self.start()
        seconds = self.seconds(layout)
        for name in ("a.webp", "b.webp"):
            self.trivet("render", layout, "--animation", name, "--fps", 8, *self.VIEW)
        self.assertEqual(self.read("a.webp"), self.read("b.webp"))
        chunks = webp_chunks(self.read("a.webp"))
        self.assertEqual([name for name, _ in chunks[:2]], ["VP8X", "ANIM"])
        header = dict(chunks)["VP8X"]
        self.assertTrue(header[0] & 2)
        self.assertEqual([1 + int.from_bytes(header[k:k + 3], "little") for k in (4, 7)], [64, 48])
        shown = [int.from_bytes(frame[12:15], "little") for name, frame in chunks if name == "ANMF"]
        self.assertGreater(len(shown), 5)
        self.assertGreaterEqual(sum(shown), 1000 * seconds)
        self.assertLess(sum(shown), 1000 * (seconds + 0.6))

    def test_refused_operations_are_told(self):
        layout = self.layout([SLAB, {"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"}],
                             [put("a", 0.2, 0, 1), put("b", 0, 0, 0.05)])
        out, err = self.trivet("render", layout, "--animation", "f.webp", "--fps", 4, *self.VIEW, status=1)
        self.assertEqual(out, "")
        self.assertIn('put "b": refused: ', err)
        self.assertIn("1 refused", err)
        self.assertGreater(len(self.read("f.webp")), 100)

    def test_bad_input(self):
        layout = self.start()
        self.trivet("run", layout, "-o", "s.glb")
        render = ("render", layout, "--animation")
        self.refused(*render, "f.png", says=["f.png", "{}"])
        self.refused(*render, "f.gif", says=["f.gif", ".webp"])
        self.refused(*render, "f.webp", "-o", "p.png", says=["--animation", "alone"])
        self.refused(*render, "f.webp", "--dome", 3, says=["--animation", "--dome", "--camera"])
        self.refused(*render, "f.webp", "--cameras", "c.json", says=["--animation", "--cameras"])
        self.refused("render", layout, "-o", "p.png", "--fps", 10, says=["--fps", "--animation"])
        self.refused(*render, "f.webp", "--fps", 0, says="--fps")
        self.refused(*render, "f{}.png", "--fps", 1000, "--width", 0, says="--width")
        self.refused("render", "s.glb", "--animation", "f.webp", says=["s.glb", "layout"])
        self.write("in.json", json.dumps({"trivet": 1, "scene": "s.glb", "objects": [{"name": "a"}], "operations": []}))
        self.refused("render", "in.json", "--animation", "f.webp", says=["--animation", "layouts of models"])


if __name__ == "__main__":
    main()
