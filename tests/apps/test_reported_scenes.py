"""Scenes of which people report that programs place them wrongly: heaps, flush walls, heights rounded to float32, boxes that hover."""
import math

from program import Case, box_obj, main, put
from random import Random

BALL, SIDE, WALL, HEIGHT = 0.03, 0.3, 0.01, 0.25


def ball_obj(radius, rings=10, around=20):
    """A ball of triangles about the origin, as modellers make them."""
    points, faces = [(0, 0, -radius)], []
    for i in range(1, rings):
        polar = math.pi * i / rings
        points += [(radius * math.sin(polar) * math.cos(2 * math.pi * k / around), radius * math.sin(polar) * math.sin(2 * math.pi * k / around),
                    -radius * math.cos(polar)) for k in range(around)]
    points.append((0, 0, radius))
    top = len(points) - 1
    for k in range(around):
        n = (k + 1) % around
        faces.append((0, 1 + n, 1 + k))
        faces.append((top, top - around + k, top - around + n))
        for i in range(rings - 2):
            a, b = 1 + i * around, 1 + (i + 1) * around
            faces += [(a + k, a + n, b + n), (a + k, b + n, b + k)]
    return "".join("v %r %r %r\n" % p for p in points) + "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in faces)


def bin_obj():
    """A box without a lid: a bottom and four walls, each a box of its own, which overlap at their corners."""
    out, count, far = [], 0, (SIDE - WALL) / 2
    for x, y, z, cx, cy, cz in ((SIDE, SIDE, WALL, 0, 0, WALL / 2), (WALL, SIDE, HEIGHT, -far, 0, HEIGHT / 2), (WALL, SIDE, HEIGHT, far, 0, HEIGHT / 2),
                                (SIDE, WALL, HEIGHT, 0, -far, HEIGHT / 2), (SIDE, WALL, HEIGHT, 0, far, HEIGHT / 2)):
        for line in box_obj(x / 2, y / 2, z / 2).splitlines():
            words = line.split()
            if words[0] == "v":
                out.append("v %r %r %r" % tuple(float(w) + d for w, d in zip(words[1:], (cx, cy, cz))))
            else:
                out.append("f " + " ".join(str(int(w) + count) for w in words[1:]))
        count += 8
    return "\n".join(out) + "\n"


class Reported(Case):
    def run_layout(self, objects, operations=(), status=0):
        """The report's objects by name, and what the program says."""
        self.layout(objects, operations)
        out, err = self.trivet("run", "layout.json", "-o", "s.glb", "--report", "r.json", status=status)
        return {o["name"]: o for o in self.read_json("r.json")["objects"]}, out + err

    def heap(self, model, count, seed):
        self.write("bin.obj", bin_obj())
        random = Random(seed)
        names = ["o%d" % i for i in range(count)]
        drops = [put(name, random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08), 0.8, [random.gauss(0, 1) for _ in range(4)]) for name in names]
        objects = [{"name": "bin", "model": "bin.obj", "fixed": True, "position": [0, 0, 1e-5]}]
        self.layout(objects + [{"name": name, "model": model} for name in names], drops)
        self.trivet("run", "layout.json", "-o", "s.glb", "--report", "r.json", status=(0, 1))
        out, _ = self.trivet("check", "s.glb")
        self.assertIn("all at rest", out)
        self.assertIn("stable at the materials' friction", out)
        return sum(o["state"] == "stable" for o in self.read_json("r.json")["objects"])

    def test_heap_of_balls(self):
        self.write("ball.obj", ball_obj(BALL))
        self.assertGreaterEqual(self.heap("ball.obj", 40, 1), 38)

    def test_heap_of_boxes(self):
        self.write("brick.obj", box_obj(0.03, 0.02, 0.015))
        self.assertGreaterEqual(self.heap("brick.obj", 24, 2), 22)

    def test_flush_neighbours_stand(self):
        self.write("cube.obj", box_obj(0.05, 0.05, 0.05))
        turn = [math.cos(math.pi / 8), 0, 0, math.sin(math.pi / 8)]
        far = 0.1 * math.sqrt(0.5)
        rows = {"square": [(0, 0, 0.05), (0.1, 0, 0.05), (0, 0.1, 0.05), (0.1, 0.1, 0.05)],
                "rounded": [(0.1 * i, 0, 0.05) for i in range(4)],
                "tower": [(0, 0, 0.05), (0, 0, 0.15), (0, 0, 0.25)],
                "edges": [(0, 0, 0.05), (0.1, 0.1, 0.05)],
                "turned": [(0, 0, 0.05), (far, far, 0.05)]}
        for name, places in rows.items():
            with self.subTest(name):
                found, said = self.run_layout([{"name": "c%d" % i, "model": "cube.obj", "position": list(p), "rotation": turn if name == "turned" else [1, 0, 0, 0]}
                                               for i, p in enumerate(places)])
                self.assertEqual([o["state"] for o in found.values()], ["stable"] * len(places), said)
                for o, p in zip(found.values(), places):
                    m = o["world_from_file"]
                    self.assertLess(math.dist((m[3], m[7], m[11]), p), 2e-5)

    def test_room_with_flush_walls(self):
        self.write("slab.obj", box_obj(2, 2, 0.1))
        self.write("wall.obj", box_obj(2, 0.1, 1))
        walls = [{"name": n, "model": m, "fixed": True, "position": p} for n, m, p in (
            ("ground", "slab.obj", [0, 0, 0.1]), ("north", "wall.obj", [0, 1.9, 1.2]), ("south", "wall.obj", [0, -1.9, 1.2]))]
        _, said = self.run_layout(walls + [{"name": "c", "model": "cube.obj", "position": [0, 1.75, 0.25]}])
        self.assertIn("check: ok, 0 interpenetrating", said)

    def test_stands_at_rounded_height(self):
        for edge, z in ((0.05, 0.05), (0.05, 0.0499999), (0.15, 0.15), (0.35, 0.35)):
            self.write("box.obj", "".join("v %.9g %.9g %.9g\n" % (x, y, h) for h in (-edge, edge) for y in (-edge, edge) for x in (-edge, edge)) +
                       "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")
            found, said = self.run_layout([{"name": "b", "model": "box.obj", "position": [0, 0, z]}])
            self.assertEqual(found["b"]["state"], "stable", said)

    def test_depth_is_told(self):
        _, said = self.run_layout([{"name": "a", "model": "cube.obj", "position": [0, 0, 0.05]},
                                   {"name": "b", "model": "cube.obj", "position": [0.099, 0, 0.05]}], status=1)
        self.assertIn('passes through "a", by 0.001 m', said)
        _, said = self.run_layout([{"name": "a", "model": "cube.obj", "position": [0, 0, 0.03]}], status=1)
        self.assertIn("reaches below the floor, by 0.02 m", said)

    def test_hovering_is_unsupported(self):
        for height in (1e-4, 1e-3, 0.1):
            found, said = self.run_layout([{"name": "a", "model": "cube.obj", "position": [0, 0, 0.05 + height]},
                                           {"name": "b", "model": "cube.obj", "position": [0, 0, 0.15 + 2 * height]}], status=1)
            self.assertEqual([o["state"] for o in found.values()], ["unsupported"] * 2)
            self.assertIn("hovers", said)


if __name__ == "__main__":
    main()
