#!/usr/bin/env python3
"""Textured models, all computed, and a layout of them, for the picture in the README.

    apps/textured_scene.py FOLDER [SHARE]       SHARE: of the width of its images, by default 1
    trivet run FOLDER/layout.json -o textured.glb
"""
import json
import math
import os
import random
import struct
import sys
import zlib

GRID = 64
KNOTS = [[random.Random(GRID * j + i).random() for i in range(GRID)] for j in range(GRID)]
BOX_SIDES = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 2, 3, 1), (4, 5, 7, 6))


def smooth(t):
    return t * t * (3 - 2 * t)


def noise(x, y):
    """0 to 1, smooth between random values at whole numbers."""
    i, j = math.floor(x), math.floor(y)
    s, t = smooth(x - i), smooth(y - j)
    knot = lambda a, b: KNOTS[(j + b) % GRID][(i + a) % GRID]
    above = knot(0, 0) * (1 - s) + knot(1, 0) * s
    below = knot(0, 1) * (1 - s) + knot(1, 1) * s
    return above * (1 - t) + below * t


def cloud(x, y):
    return sum(noise(x * 2 ** k, y * 2 ** k) / 2 ** k for k in range(4)) / 1.875


def shaded(colour, share):
    return tuple(c * share for c in colour)


def wood(colour, u, v):
    grain = cloud(3 * u, 30 * v) + 0.35 * math.sin(40 * (v + 0.12 * cloud(2 * u, 3 * v)))
    return shaded(colour, 0.75 + 0.3 * grain)


def board(u, v):
    return wood((150, 100, 60), u, v)


def planks(u, v):
    across, along = not 0.08 <= u <= 0.92, not 0.08 <= v <= 0.92
    if across or along:
        return wood((120, 80, 44), v if across else u, u if across else v)
    number = int(5 * v)
    gap = min(5 * v - number, number + 1 - 5 * v) < 0.02
    colour = wood((176 - 8 * (number % 3), 124 - 6 * (number % 2), 72), u + 0.37 * number, v)
    return shaded(colour, 0.35 if gap else 1)


def checker(u, v):
    return ((214, 66, 48), (240, 232, 214))[(int(6 * u) + int(6 * v)) % 2]


def globe(u, v):
    land = cloud(8 * u, 5 * v) + 0.15 * math.sin(4 * math.pi * u)
    if abs(v - 0.5) > 0.43:
        return 238, 242, 246
    return (70 + 60 * land, 122 + 40 * land, 58) if land > 0.56 else (34, 84 + 60 * land, 150 + 50 * land)


def label(u, v):
    if not 0.1 <= v <= 0.9:
        return 190, 192, 198
    if not 0.38 < v < 0.62:
        return 32, 70, 120
    return (246, 240, 226) if abs(v - 0.5) < 0.09 + 0.03 * math.sin(12 * math.pi * u) else (196, 40, 46)


def cover(u, v):
    radius = math.hypot(u - 0.5, v - 0.65)
    gilt = (0.12 < u < 0.88 and 0.15 < v < 0.32) or 0.17 < radius < 0.2 or radius < 0.05
    return (232, 214, 150) if gilt else (38 + 20 * cloud(20 * u, 20 * v), 78, 74)


def png(side, colour):
    """Square image of colour(u, v), v down."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b"".join(
        b"\0" + bytes(max(0, min(255, int(c))) for x in range(side) for c in colour(x / side, y / side))
        for y in range(side))
    header = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + \
        chunk(b"IEND", b"")


def box(x, y, z):
    """Half extents; the whole image on each side. Positions, coordinates and faces of ids of both."""
    places = [(x * (1 if i & 1 else -1), y * (1 if i & 2 else -1), z * (1 if i & 4 else -1))
              for i in range(8)]
    faces = []
    for number, side in enumerate(BOX_SIDES):
        corners = list(zip(side, (1, 2, 3, 0) if number == 0 else (0, 1, 2, 3)))
        faces += [corners[:3], [corners[0], corners[2], corners[3]]]
    return places, [(0, 0), (1, 0), (1, 1), (0, 1)], faces


def turned(profile, steps=48):
    """Surface of revolution of (radius, height, v) from the axis to the axis; u runs around."""
    around = [2 * math.pi * i / steps for i in range(steps)]
    places = [(r * math.cos(a) + 0.0, r * math.sin(a) + 0.0, z) for r, z, _ in profile for a in around]
    coordinates = [(i / steps, v) for _, _, v in profile for i in range(steps + 1)]
    faces = []
    for j in range(len(profile) - 1):
        for i in range(steps):
            a, b, c, d = [((j + k) * steps + (i + n) % steps, (j + k) * (steps + 1) + i + n)
                          for k, n in ((0, 0), (0, 1), (1, 1), (1, 0))]
            faces += ([[a, b, c]] if j > 0 else []) + ([[a, c, d]] if j + 2 < len(profile) else [])
    return places, coordinates, faces


def can():
    return turned([(0, -.07, 0), (.038, -.07, .05), (.04, -.065, .1), (.04, .065, .9),
                   (.038, .07, .95), (0, .07, 1)])


def ball(radius, steps=24):
    angles = [math.pi * k / steps for k in range(1, steps)]
    return turned([(0, -radius, 0)] +
                  [(radius * math.sin(a), -radius * math.cos(a), a / math.pi) for a in angles] +
                  [(0, radius, 1)])


def write_model(folder, name, mesh, image):
    places, coordinates, faces = mesh
    lines = ["mtllib %s.mtl" % name, "usemtl skin"]
    lines += ["v %g %g %g" % p for p in places] + ["vt %g %g" % t for t in coordinates]
    lines += ["f " + " ".join("%d/%d" % (a + 1, b + 1) for a, b in face) for face in faces]
    with open(os.path.join(folder, name + ".obj"), "w") as file:
        file.write("\n".join(lines) + "\n")
    with open(os.path.join(folder, name + ".mtl"), "w") as file:
        file.write("newmtl skin\nKd 1 1 1\nKs 0.2 0.2 0.2\nNs 40\nmap_Kd %s.png\n" % image)


def put(name, x, y, z, turn_deg):
    half = math.radians(turn_deg) / 2
    return {"op": "put", "object": name, "position": [x, y, z],
            "rotation": [math.cos(half), 0, 0, math.sin(half)]}


def layout():
    objects = [("crate_a", "crate", -.3, .1, .4, 12), ("crate_b", "crate", -.28, .1, .9, -9),
               ("book", "book", .12, -.08, .4, 28), ("cube", "cube", .1, -.07, .8, 48),
               ("can_a", "can", -.1, -.18, .5, 100), ("can_b", "can", 0, .14, .5, 200),
               ("globe", "globe", .34, .12, .6, 150)]
    shelf = {"name": "shelf", "model": "shelf.obj", "fixed": True, "position": [0, 0, .020001]}
    return {"trivet": 1,
            "objects": [shelf] + [{"name": o[0], "model": o[1] + ".obj"} for o in objects],
            "operations": [put(o[0], *o[2:]) for o in objects]}


def main():
    folder, share = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 1
    os.makedirs(folder, exist_ok=True)
    for colour, side in ((planks, 384), (checker, 192), (globe, 512), (label, 384), (board, 512),
                         (cover, 384)):
        with open(os.path.join(folder, colour.__name__ + ".png"), "wb") as file:
            file.write(png(int(side * share), colour))
    for name, mesh, image in (("crate", box(.12, .12, .12), "planks"), ("cube", box(.06, .06, .06), "checker"),
                              ("shelf", box(.5, .32, .02), "board"), ("book", box(.11, .15, .02), "cover"),
                              ("can", can(), "label"), ("globe", ball(.09), "globe")):
        write_model(folder, name, mesh, image)
    with open(os.path.join(folder, "layout.json"), "w") as file:
        json.dump(layout(), file, indent=1)


if __name__ == "__main__":
    main()
