#!/usr/bin/env python3
"""A contact sheet of pictures with varied looks: environments, lamps, rooms, surfaces, lenses; six breakfast tables of each kind.

    perf/contact_sheet.py TRIVET FOLDER [SIDE]      needs python3-numpy; writes FOLDER/contact-sheet.png

All images it needs are computed here: two surroundings as Radiance and OpenEXR files, and four surfaces.
"""
import json
import pathlib
import struct
import subprocess
import sys
import zlib

import numpy

NUM, COLUMNS, SEED = 6, 6, 11
SURFACES = {"roughness": [0.1, 0.9], "colour": [[0.7, 0.7, 0.7], [1, 1, 1]]}
DOME = {"count": 1, "around": "targets", "fov_deg": [28, 42], "elevation_deg": [18, 60], "roll_deg": [-8, 8], "min_visible": 0.3}


def looks():
    """One for each row."""
    exposure = {"exposure": [0.8, 1.2]}
    yield "key lamp", {"key": {"azimuth_deg": [0, 360], "elevation_deg": [20, 80], "strength": [0.6, 1.4], "temperature": [2500, 9000]},
                       "sky": {"strength": [0.4, 1.2]}, "floor": [[0.1, 0.1, 0.15], [0.9, 0.8, 0.7]],
                       "background": [[0.2, 0.2, 0.3], [1, 1, 1]], "noise": [0, 0.03], **exposure}
    yield "lamps in rooms", {"lamps": {"kind": ["bulb", "panel", "sun"], "count": [1, 4], "strength": [0.3, 0.9],
                                       "temperature": [2500, 9000], "distance": [0.8, 2], "size": [0.02, 0.6]},
                             "sky": {"strength": [0.1, 0.6]}, "noise": [0, 0.02], **exposure,
                             "room": {"floor_images": ["boards.png", "tiles.png"], "wall_images": ["plaster.png", "stripes.png"],
                                      "tile": [0.5, 1.5]}}
    yield "surroundings", {"environments": ["court.hdr", "hall.hdr"], "environment_strength": [0.7, 1.2],
                           "floor": [[0.2, 0.2, 0.2], [0.8, 0.75, 0.7]], **exposure}
    yield "lenses", {"lamps": {"kind": "panel", "count": [2, 3], "strength": [0.4, 0.9], "temperature": [3000, 7500]},
                     "lens": {"f_number": [0.6, 1.8], "focus": [0.85, 1.15]}, "noise": [0, 0.02], **exposure,
                     "room": {"floor_images": ["boards.png", "tiles.png"], "walls": [[0.3, 0.35, 0.4], [0.9, 0.85, 0.8]]}}


def write_png(file, pixels):
    height, width, _ = pixels.shape
    rows = b"".join(b"\0" + row.tobytes() for row in pixels.astype("uint8"))
    parts = [b"\x89PNG\r\n\x1a\n"]
    for kind, data in ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b"")):
        parts.append(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))
    file.write_bytes(b"".join(parts))


def read_png(file):
    """Reads a PNG of 8 bits, RGB or RGBA, as Trivet writes them."""
    data, at, packed = file.read_bytes(), 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        packed += body if kind == b"IDAT" else b""
        at += size + 12
    step = 4 if colour == 6 else 3
    raw = numpy.frombuffer(zlib.decompress(packed), "uint8").reshape(height, width * step + 1)
    out = numpy.zeros((height, width * step), "int16")
    for y in range(height):
        line, above = raw[y, 1:].astype("int16"), out[y - 1] if y else numpy.zeros(width * step, "int16")
        if raw[y, 0] in (0, 2):
            out[y] = line + (above if raw[y, 0] == 2 else 0) & 255
            continue
        for x in range(width * step):
            left, corner = (out[y, x - step], above[x - step]) if x >= step else (0, 0)
            guess = {1: left, 3: (left + above[x]) // 2, 4: paeth(left, above[x], corner)}[raw[y, 0]]
            out[y, x] = line[x] + guess & 255
    return out.reshape(height, width, step)[:, :, :3]


def paeth(a, b, c):
    return min((abs(int(b) - c), 0, a), (abs(int(a) - c), 1, b), (abs(int(a) + b - 2 * int(c)), 2, c))[2]


def noise(random, size, cells):
    """Smooth, about 0, that tiles."""
    grid = random.normal(size=(cells, cells))
    at = numpy.arange(size) * cells / size
    low, share = at.astype(int), (at % 1)[:, None]
    rows = grid[low] * (1 - share) + grid[(low + 1) % cells] * share
    return (rows[:, low].T * (1 - share) + rows[:, (low + 1) % cells].T * share).T


def write_surfaces(folder):
    random = numpy.random.default_rng(1)
    n = 256
    y, x = numpy.mgrid[:n, :n] / n
    rough = noise(random, n, 64) + noise(random, n, 16)
    grain = numpy.sin(40 * numpy.pi * y + 2 * noise(random, n, 8)) + 0.5 * rough
    boards = (1 - 0.55 * ((x * 5) % 1 < 0.02)) * (0.8 + 0.06 * grain.T)
    tiles = numpy.where(((x * 4) % 1 < 0.03) | ((y * 4) % 1 < 0.03), 0.55, 0.85 + 0.02 * rough)
    stripes = numpy.where((x * 8) % 1 < 0.5, 0.92, 0.7)
    for name, shade, colour in (("boards", boards, (170, 120, 75)), ("tiles", tiles, (200, 205, 210)),
                                ("plaster", 0.92 + 0.02 * rough, (235, 230, 220)), ("stripes", stripes, (190, 205, 215))):
        write_png(folder / (name + ".png"), numpy.clip(shade[:, :, None] * numpy.array(colour), 0, 255))


def write_hdr(file, light):
    """Radiance's RGBE, pixel by pixel."""
    height, width, _ = light.shape
    most = numpy.maximum(light.max(axis=2), 1e-30)
    exponent = numpy.ceil(numpy.log2(most * 256 / 255)).astype(int)
    bytes_ = numpy.empty((height, width, 4), "uint8")
    bytes_[:, :, :3] = numpy.clip(light / numpy.exp2(exponent - 8.0)[:, :, None], 0, 255)
    bytes_[:, :, 3] = exponent + 128
    file.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width) + bytes_.tobytes())


def write_surroundings(folder):
    height = 128
    polar, azimuth = numpy.mgrid[:height, :2 * height] * numpy.pi / height
    up = numpy.cos(polar)[:, :, None]
    sky = numpy.where(up > 0, numpy.array([0.35, 0.5, 0.9]) + (1 - up) ** 4 * 0.6, numpy.array([0.25, 0.22, 0.2]))
    walls = ((numpy.abs(up) < 0.35) & (numpy.sin(4 * azimuth)[:, :, None] > -0.2)) * numpy.array([0.55, 0.4, 0.3])
    court = numpy.where(walls > 0, walls, sky)
    sun = numpy.exp(-((polar - 0.8) ** 2 + (azimuth - 2) ** 2) / 0.001)[:, :, None]
    write_hdr(folder / "court.hdr", court + 180 * sun * numpy.array([1, 0.9, 0.75]))
    windows = (numpy.abs(polar - 1.1) < 0.28) & (numpy.abs((azimuth * 5 / numpy.pi) % 1 - 0.5) < 0.3) & (azimuth < numpy.pi)
    write_hdr(folder / "hall.hdr", 0.12 + 0.1 * up.clip(0) + windows[:, :, None] * numpy.array([4, 4.4, 5]))


def write_recipe(program, folder):
    subprocess.run([program, "demo", "breakfast", "-o", "b.glb", "--export", ".", "--quiet"], cwd=folder, check=True)
    source = pathlib.Path(__file__).resolve().parent.parent / "apps/farm/examples/breakfast.json"
    recipe = json.loads(source.read_text())
    for group in recipe["groups"]:
        group["look"] = SURFACES
    (folder / "recipe.json").write_text(json.dumps(recipe))


def main():
    program, folder = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    width = int(sys.argv[3]) if len(sys.argv) > 3 else 200
    folder.mkdir(parents=True, exist_ok=True)
    write_surfaces(folder), write_surroundings(folder), write_recipe(program, folder)
    subprocess.run([program, "batch", "recipe.json", "--count", str(4 * NUM), "--seed", str(SEED), "--per-tar", str(NUM), "--format", "dir",
                    "--out", "scenes", "--quiet"], cwd=folder, check=True)
    rows = []
    for row, (name, look) in enumerate(looks()):
        views = {"width": width, "height": 3 * width // 4, "samples": 32, "images": ["picture"], "dome": DOME, "look": look}
        (folder / ("views%d.json" % row)).write_text(json.dumps({"views": views}))
        out = "pictures%d" % row
        subprocess.run([program, "batch", "pictures", "scenes", "--out", out, "--views", "views%d.json" % row, "--shard", "%d/4" % row,
                        "--format", "dir", "--quiet"], cwd=folder, check=True)
        files = sorted((folder / out / "0000").rglob("*.png"))
        print(name, len(files))
        rows.append(numpy.concatenate([read_png(file) for file in files[:COLUMNS]], axis=1))
    write_png(folder / "contact-sheet.png", numpy.concatenate(rows))


if __name__ == "__main__":
    main()
