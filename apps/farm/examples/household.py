#!/usr/bin/env python3
"""Household objects of our own making, of the sizes, masses and frictions that such objects have, and a recipe of tables with them.

    apps/farm/examples/household.py FOLDER      then: trivet batch FOLDER/household.json --count 200 --seed 7 --out scenes

They are like those of robotics benchmarks such as the YCB set: cartons, cans, bottles, dishes, fruit, blocks. Metres, z up.
"""
import json
import math
import pathlib
import struct
import sys
import zlib

SIDES = 24


class Mesh:
    """Corners, and faces of corner numbers by material; with places in an image where there is one."""

    def __init__(self):
        self.points, self.places, self.faces = [], [], []

    def face(self, material, corners, places=None):
        self.faces.append((material, corners, places))

    def quad(self, material, a, b, c, d):
        self.face(material, (a, b, c))
        self.face(material, (a, c, d))

    def box(self, material, half, middle=(0, 0, 0), image=False):
        """Closed; with an image each side shows all of it."""
        first = len(self.points)
        self.points += [tuple(m + (h if i >> k & 1 else -h) for k, (m, h) in enumerate(zip(middle, half))) for i in range(8)]
        if image and not self.places:
            self.places = [(0, 0), (1, 0), (1, 1), (0, 1)]
        for side in ((0, 4, 6, 2), (3, 7, 5, 1), (1, 5, 4, 0), (2, 6, 7, 3), (2, 3, 1, 0), (4, 5, 7, 6)):
            at = [first + i for i in side]
            for corners in ((0, 1, 2), (0, 2, 3)):
                self.face(material, tuple(at[i] for i in corners), corners if image else None)
        return self

    def lathe(self, profile, flat=1.0):
        """A surface of revolution about z of (radius, z, material up to the next), from the axis to the axis; `flat` times as deep."""
        rings = []
        for r, z, _ in profile:
            turns = range(SIDES) if r > 0 else range(1)
            rings.append([len(self.points) + i for i in turns])
            self.points += [(r * math.cos(2 * math.pi * i / SIDES), flat * r * math.sin(2 * math.pi * i / SIDES), z) for i in turns]
        for below, above, (_, _, material) in zip(rings, rings[1:], profile):
            for i in range(SIDES):
                a, b = below[i % len(below)], below[(i + 1) % len(below)]
                c, d = above[(i + 1) % len(above)], above[i % len(above)]
                if a != b:
                    self.face(material, (a, b, c))
                if c != d:
                    self.face(material, (a, c, d))
        return self

    def tube(self, material, path, radii, sides=8):
        """A closed tube along a path in the plane of x and z, with points at both ends."""
        rings = []
        for k, ((x, z), r) in enumerate(zip(path, radii)):
            (x0, z0), (x1, z1) = path[max(k - 1, 0)], path[min(k + 1, len(path) - 1)]
            length = math.hypot(x1 - x0, z1 - z0)
            u, w = (x1 - x0) / length, (z1 - z0) / length
            rings.append([len(self.points) + i for i in range(sides)])
            for i in range(sides):
                s, t = r * math.cos(2 * math.pi * i / sides), r * math.sin(2 * math.pi * i / sides)
                self.points.append((x - w * s, t, z + u * s))
        for one, two in zip(rings, rings[1:]):
            for i in range(sides):
                j = (i + 1) % sides
                self.quad(material, one[j], one[i], two[i], two[j])
        for ring, order in ((rings[0], 1), (rings[-1], -1)):
            for i in range(1, sides - 1):
                self.face(material, (ring[0], ring[i], ring[i + 1])[::order])
        return self

    def obj(self, name):
        lines = ["mtllib %s.mtl" % name] + ["v %.6f %.6f %.6f" % p for p in self.points] + ["vt %g %g" % p for p in self.places]
        last = None
        for material, corners, places in self.faces:
            if material != last:
                lines.append("usemtl " + material)
            last = material
            words = ["%d/%d" % (c + 1, p + 1) for c, p in zip(corners, places)] if places else [str(c + 1) for c in corners]
            lines.append("f " + " ".join(words))
        return "\n".join(lines) + "\n"


def png(pixels):
    rows = b"".join(b"\0" + bytes(c for pixel in row for c in pixel) for row in pixels)
    out = b"\x89PNG\r\n\x1a\n"
    for kind, data in ((b"IHDR", struct.pack(">IIBBBBB", len(pixels[0]), len(pixels), 8, 2, 0, 0, 0)), (b"IDAT", zlib.compress(rows)),
                       (b"IEND", b"")):
        out += struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return out


def label(ground, band, spots):
    """The label of a carton: a ground, a band across, and a pattern that has no symmetry."""
    def pixel(x, y):
        if 10 <= y < 22:
            return band
        return spots if (x - 20) ** 2 + (y - 38) ** 2 < 60 or (x < 12 and y % 6 < 2) else ground
    return png([[pixel(x, y) for x in range(48)] for y in range(64)])


def boards():
    def pixel(x, y):
        shade = x // 16 * 13 % 30 + (x // 16 * 7 + y) * y % 5 - (40 if x % 16 == 0 or (y + 20 * (x // 16)) % 64 == 0 else 0)
        return 140 + shade, 105 + shade, 70 + shade
    return png([[pixel(x, y) for x in range(64)] for y in range(64)])


def can(radius, height):
    rim = 0.96 * radius
    return Mesh().lathe([(0, 0, "metal"), (rim, 0, "metal"), (radius, 0.04 * height, "paper"), (radius, 0.96 * height, "metal"),
                         (rim, height, "metal"), (0, height, "metal")])


def bottle(width, depth, height):
    r = width / 2
    return Mesh().lathe([(0, 0, "body"), (0.92 * r, 0, "body"), (r, 0.05 * height, "body"), (r, 0.6 * height, "body"),
                         (0.45 * r, 0.82 * height, "cap"), (0.4 * r, height, "cap"), (0, height, "cap")], depth / width)


def dish(foot, rim, height, wall):
    """Hollow: a bowl, a mug without its handle, a pitcher."""
    return Mesh().lathe([(0, 0, "glaze"), (foot, 0, "glaze"), (rim, height, "glaze"), (rim - wall, height, "glaze"), (foot - wall, wall, "glaze"),
                         (0, wall, "glaze")])


def with_handle(mesh, radius, height):
    turns = [math.pi * (k / 8 - 0.5) for k in range(9)]
    path = [(radius - 0.002 + 0.3 * height * math.cos(t), 0.5 * height + 0.32 * height * math.sin(t)) for t in turns]
    return mesh.tube("glaze", path, [0.05 * height] * 9)


def ball(radius, dent):
    steps = [math.pi * k / 10 for k in range(11)]
    return Mesh().lathe([(0 if k in (0, 10) else radius * math.sin(t), -radius * math.cos(t) * (1 - dent * math.cos(t) ** 8), "skin")
                         for k, t in enumerate(steps)])


def banana():
    turns = [-1.1 + 2.2 * k / 10 for k in range(11)]
    return Mesh().tube("skin", [(0.1 * math.sin(t), 0.1 - 0.1 * math.cos(t)) for t in turns],
                       [0.017 * max(0.25, 1 - (t / 1.1) ** 4) for t in turns])


def table():
    out = Mesh().box("wood", (0.6, 0.4, 0.02), (0, 0, 0.73))
    for x in (-0.55, 0.55):
        for y in (-0.35, 0.35):
            out.box("wood", (0.03, 0.03, 0.355), (x, y, 0.355))
    return out


def carton(x, y, z):
    return Mesh().box("print", (x / 2, y / 2, z / 2), image=True)


def block(x, y, z):
    return Mesh().box("wood", (x / 2, y / 2, z / 2))


GREY, WOOD, YELLOW = (0.7, 0.7, 0.72), (0.62, 0.42, 0.22), (0.9, 0.75, 0.1)
HALF_TURN = [-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
QUARTER_TURN = [0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
# Group, name, mesh, colours of materials or the label, kilograms, friction, and symmetries that the mesh has beside its own.
OBJECTS = (
    ("carton", "cracker_box", carton(0.06, 0.16, 0.21), label((170, 30, 25), (240, 220, 160), (250, 190, 60)), 0.41, 0.4, None),
    ("carton", "sugar_box", carton(0.04, 0.09, 0.175), label((245, 230, 60), (30, 60, 150), (255, 255, 255)), 0.51, 0.4, None),
    ("carton", "pudding_box", carton(0.11, 0.09, 0.035), label((90, 50, 30), (240, 240, 230), (200, 150, 90)), 0.19, 0.4, None),
    ("carton", "gelatin_box", carton(0.085, 0.073, 0.028), label((200, 30, 60), (250, 240, 240), (255, 120, 130)), 0.1, 0.4, None),
    ("can", "coffee_can", can(0.051, 0.139), {"metal": GREY, "paper": (0.1, 0.15, 0.4)}, 0.41, 0.35, None),
    ("can", "soup_can", can(0.033, 0.101), {"metal": GREY, "paper": (0.8, 0.1, 0.08)}, 0.35, 0.35, None),
    ("can", "fish_can", can(0.0425, 0.033), {"metal": GREY, "paper": (0.1, 0.3, 0.7)}, 0.17, 0.35, None),
    ("bottle", "mustard_bottle", bottle(0.095, 0.058, 0.19), {"body": YELLOW, "cap": (0.8, 0.2, 0.1)}, 0.6, 0.3, [HALF_TURN]),
    ("bottle", "bleach_bottle", bottle(0.1, 0.068, 0.25), {"body": (0.9, 0.9, 0.88), "cap": (0.1, 0.3, 0.8)}, 1.13, 0.3, [HALF_TURN]),
    ("bowl", "bowl", dish(0.045, 0.08, 0.055, 0.004), {"glaze": (0.75, 0.1, 0.1)}, 0.15, 0.45, None),
    ("dish", "mug", with_handle(dish(0.038, 0.042, 0.082, 0.004), 0.041, 0.082), {"glaze": (0.8, 0.15, 0.1)}, 0.12, 0.45, None),
    ("dish", "pitcher", dish(0.048, 0.054, 0.235, 0.003), {"glaze": (0.2, 0.35, 0.75)}, 0.18, 0.4, None),
    ("fruit", "apple", ball(0.0375, 0.1), {"skin": (0.7, 0.12, 0.1)}, 0.07, 0.5, None),
    ("fruit", "plum", ball(0.026, 0.02), {"skin": (0.35, 0.1, 0.3)}, 0.025, 0.5, None),
    ("block", "banana", banana(), {"skin": YELLOW}, 0.066, 0.5, None),
    ("block", "wood_block", block(0.085, 0.085, 0.2), {"wood": WOOD}, 0.73, 0.5, [QUARTER_TURN]),
    ("block", "foam_brick", block(0.05, 0.075, 0.05), {"wood": (0.7, 0.25, 0.2)}, 0.028, 0.8, [HALF_TURN]),
)
TOP = [[-0.5, -0.32], [0.5, 0.32]]


def group(name, count, **more):
    models = []
    for of, model, _, _, kilograms, friction, turns in OBJECTS:
        if of == name:
            models.append({"model": model + ".obj", "class": model, "mass": [round(0.95 * kilograms, 4), round(1.05 * kilograms, 4)],
                           "material": {"friction": [round(friction - 0.05, 2), round(friction + 0.05, 2)]},
                           **({"symmetries": {"discrete": turns}} if turns else {})})
    return {"name": name, "models": models, "count": count, **({"on": "table", "region": TOP, "keep": 0.01} if "in" not in more else {}),
            **more}


def recipe():
    look = {"key": {"azimuth_deg": [0, 360], "elevation_deg": [25, 80], "strength": [0.3, 1], "temperature": [2700, 7500]},
            "lamps": {"kind": ["bulb", "panel"], "count": [1, 2], "strength": [0.1, 0.5], "temperature": [2700, 7500]},
            "sky": {"strength": [0.4, 1]}, "room": {"floor_images": ["boards.png"], "walls": [[0.4, 0.4, 0.4], [0.9, 0.88, 0.85]]},
            "exposure": [0.8, 1.2], "noise": [0, 0.02]}
    return {"trivet_recipe": 1, "objects": [{"name": "table", "model": "table.obj", "fixed": True, "position": [0, 0, 1e-6]}],
            "groups": [group("carton", [1, 3]), group("can", [1, 3]), group("bottle", [0, 2]), group("bowl", 1), group("dish", [1, 2]),
                       group("fruit", [0, 2], **{"in": "bowl", "above": 0.02}, rotation="any"), group("block", [1, 2]),
                       {"name": "clutter", "target": False, "count": [1, 3], "on": "table", "region": TOP, "keep": 0.01,
                        "scale_range": [0.5, 1.5], "models": [{"model": "peg.obj", "class": "peg"}],
                        "look": {"colour": [[0.2, 0.2, 0.2], [1, 1, 1]]}}],
            "accept": {"min_objects": 5},
            "views": {"width": 640, "height": 480, "look": look,
                      "dome": {"count": 2, "around": "targets", "fov_deg": [30, 45], "elevation_deg": [20, 65], "roll_deg": [-10, 10]}}}


def write_model(folder, name, mesh, colours):
    text = ""
    if isinstance(colours, bytes):
        (folder / (name + ".png")).write_bytes(colours)
        colours, text = {}, "newmtl print\nKd 1 1 1\nmap_Kd %s.png\n" % name
    text += "".join("newmtl %s\nKd %g %g %g\n" % (material, *colour) for material, colour in colours.items())
    (folder / (name + ".obj")).write_text(mesh.obj(name))
    (folder / (name + ".mtl")).write_text(text)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for _, name, mesh, colours, _, _, _ in OBJECTS:
        write_model(folder, name, mesh, colours)
    write_model(folder, "table", table(), {"wood": WOOD})
    write_model(folder, "peg", Mesh().lathe([(0, 0, "wood"), (0.012, 0, "wood"), (0.012, 0.03, "wood"), (0, 0.03, "wood")]), {"wood": (1, 1, 1)})
    (folder / "boards.png").write_bytes(boards())
    (folder / "household.json").write_text(json.dumps(recipe(), indent=1) + "\n")


if __name__ == "__main__":
    main()
