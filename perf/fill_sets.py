"""Layouts for fill_rates.py: boxes, bowls, bins and heaps that are filled by one PUT after another.

sets_of(options) gives each set as a FillSet. Models of its own are written into the folder it is asked for; real ones
come from the shared data, by the sets of tests/referee/campaign_sets.py.
"""
import dataclasses
import math
import os
import random
import sys
import types

EDGE, HEIGHT, WALL = 0.3, 0.4, 0.01
LARGE_EDGE, LARGE_HEIGHT = 0.45, 0.5


@dataclasses.dataclass
class FillSet:
    name: str
    layouts: object          # folder -> iterable of (name, layout)
    is_inside: object        # (x, y) of a centre -> bool
    least: float             # share that must be placed by default tries


def write_obj(path, vertices, faces):
    with open(path, "w") as file:
        file.writelines("v %.9g %.9g %.9g\n" % tuple(v) for v in vertices)
        file.writelines("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def box(lower, upper):
    vertices = [[(lower, upper)[i >> k & 1][k] for k in range(3)] for i in range(8)]
    return vertices, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def bin_mesh(edge, height):
    """A bin of one closed surface: an outer and an inner box, joined at the rim."""
    o, i = edge / 2 + WALL, edge / 2
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    rings = [[(x * r, y * r, z) for x, y in corners] for r, z in ((o, 0), (o, height), (i, height), (i, WALL))]
    vertices = [p for ring in rings for p in ring]
    faces = [(3, 2, 1, 0), (12, 13, 14, 15)]
    faces += [(4 * k + j, 4 * k + (j + 1) % 4, 4 * k + 4 + (j + 1) % 4, 4 * k + 4 + j) for k in range(3) for j in range(4)]
    return vertices, faces


def turned(outline, n):
    """A closed outline (radius, height) about z; radius 0 at both ends."""
    rings = [[(r * math.cos(2 * math.pi * j / n), r * math.sin(2 * math.pi * j / n), z) for j in range(n)]
             for r, z in outline[1:-1]]
    vertices = [(0, 0, outline[0][1])] + [p for ring in rings for p in ring] + [(0, 0, outline[-1][1])]
    last, top = len(vertices) - 1, 1 + n * (len(rings) - 1)
    faces = [(0, 1 + (j + 1) % n, 1 + j) for j in range(n)] + [(last, top + j, top + (j + 1) % n) for j in range(n)]
    faces += [(1 + n * k + j, 1 + n * k + (j + 1) % n, 1 + n * (k + 1) + (j + 1) % n, 1 + n * (k + 1) + j)
              for k in range(len(rings) - 1) for j in range(n)]
    return vertices, faces


def ball(radius, height=None):
    """A sphere, or a spheroid of another half height."""
    return turned([(radius * math.sin(math.pi * k / 10), -(height or radius) * math.cos(math.pi * k / 10))
                   for k in range(11)], 20)


def pear():
    return turned([(0, -0.045), (0.022, -0.042), (0.035, -0.025), (0.034, -0.005), (0.022, 0.022), (0.015, 0.04),
                   (0.008, 0.048), (0, 0.05)], 20)


def bowl():
    """A spherical bowl, 34 cm wide, its wall 8 mm thick, on a flat foot."""
    outer = [(0.06, 0)] + [(0.06 + 0.11 * math.sin(a), 0.09 * (1 - math.cos(a))) for a in (0.3, 0.6, 0.9, 1.2, 1.5)]
    inner = [(max(r - 0.008, 0.02), z + 0.008) for r, z in reversed(outer[:-1])]
    return turned([(0, 0)] + outer + [(0.162, 0.084)] + inner + [(0, 0.008)], 32)


BALLS = {"balls of 6 cm": ball(0.03), "balls of 7 cm": ball(0.035), "balls of 8 cm": ball(0.04)}
CUBE = box([-0.03] * 3, [0.03] * 3)
CAN = turned([(0, -0.04), (0.025, -0.04), (0.025, 0.04), (0, 0.04)], 24)
BRICK = box([-0.05, -0.025, -0.02], [0.05, 0.025, 0.02])
FRUITS = [ball(0.04, 0.036), ball(0.037), pear(), ball(0.026, 0.036), ball(0.024)]


def random_rotation(rng):
    q = [rng.gauss(0, 1) for _ in range(4)]
    length = math.sqrt(sum(x * x for x in q))
    return [x / length for x in q]


def poured(folder, name, container, shapes, count, seeds, reach, height):
    """Layouts in which objects are let go one after another at drawn places over a container."""
    folder = os.path.join(folder, name.replace(" ", "_"))
    os.makedirs(folder, exist_ok=True)
    write_obj(os.path.join(folder, "container.obj"), *container)
    for k, shape in enumerate(shapes):
        write_obj(os.path.join(folder, f"object{k}.obj"), *shape)
    for seed in range(seeds):
        rng = random.Random(seed)
        layout = {"trivet": 1, "operations": [],
                  "objects": [{"name": "container", "model": "container.obj", "fixed": True, "position": [0, 0, 1e-5]}]}
        for k in range(count):
            layout["objects"].append({"name": f"o{k}", "model": f"object{k % len(shapes)}.obj"})
            at = [rng.uniform(-reach, reach), rng.uniform(-reach, reach), height + 0.1 + 0.01 * k]
            layout["operations"].append({"op": "put", "object": f"o{k}", "position": at, "rotation": random_rotation(rng)})
        yield os.path.join(folder, str(seed)), layout


def in_square(edge):
    return lambda x, y: max(abs(x), abs(y)) <= edge / 2


def poured_set(options, name, shapes, container, inside, count, seeds, reach, height, least=0.98):
    return FillSet(name, lambda folder: poured(folder, name, container, shapes, count, seeds, reach, height), inside, least)


def real_sets(options):
    """Bins and heaps of the campaign."""
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "referee"))
    import campaign_sets

    def of(kind, size, scenes):
        def layouts(folder):
            folder = os.path.join(folder, f"{kind}_{size}")
            os.makedirs(folder, exist_ok=True)
            asked = types.SimpleNamespace(shared=options.shared, out=folder, heaps=f"{scenes}x{size}",
                                          bins=f"{scenes}x{size}", solids="1x1")
            for name, layout, _ in campaign_sets.sets_of(asked)[kind][1]:
                yield os.path.join(folder, name), layout
        return layouts

    def in_bin(x, y):
        return abs(x) <= 0.3 and abs(y) <= 0.2

    bins, heaps = (max(1, round(n * options.part)) for n in (50, 20))
    return [FillSet("bins of 8 real models", of("bin", 8, bins), in_bin, 0.995),
            FillSet("bins of 10 real models", of("bin", 10, bins), in_bin, 0.995),
            FillSet("heaps of 30 real models", of("pile", 30, heaps), lambda x, y: True, 0.99),
            FillSet("heaps of 50 real models", of("pile", 50, heaps), lambda x, y: True, 0.99)]


def sets_of(options):
    small, large = bin_mesh(EDGE, HEIGHT), bin_mesh(LARGE_EDGE, LARGE_HEIGHT)
    shapes = {**{name: [mesh] for name, mesh in BALLS.items()}, "cubes of 6 cm": [CUBE], "cans of 5 x 8 cm": [CAN]}
    sets = [poured_set(options, name, meshes, small, in_square(EDGE), options.count, options.seeds, 0.1, HEIGHT)
            for name, meshes in shapes.items()]
    sets.append(poured_set(options, "fruit in a bowl", FRUITS, bowl(), lambda x, y: math.hypot(x, y) <= 0.17, 20,
                           options.seeds, 0.07, 0.1))
    sets.append(poured_set(options, "box of 120 things", [CUBE, CAN, BRICK, BALLS["balls of 6 cm"]], large,
                           in_square(LARGE_EDGE), 120, 2 * options.seeds, 0.17, LARGE_HEIGHT))
    return sets + (real_sets(options) if options.shared else [])
