#!/usr/bin/env python3
"""Six textured models, all computed, one kind of texture each, for pictures beside those of Blender.

Usage: six_models.py FOLDER
"""
import math
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "apps"), str(ROOT / "tests" / "interop")]
import make_models  # noqa: E402
import textured_scene  # noqa: E402

SIDE = 256


def image(colour, side=SIDE):
    """PNG of colour(u, v), v down."""
    return textured_scene.png(side, lambda u, v: colour(u + 0.5 / side, v + 0.5 / side))


def ball(g, steps=48, colours=None):
    """A ball of radius 0.1 on the floor, u around its axis, v down; y is up."""
    places, coordinates, indices = [], [], []
    for j in range(steps + 1):
        for i in range(2 * steps + 1):
            a, b = math.pi * i / steps, math.pi * j / steps
            places.append((math.sin(b) * math.cos(a), math.cos(b), -math.sin(b) * math.sin(a)))
            coordinates.append((i / (2 * steps), j / steps))
    row = 2 * steps + 1
    for j in range(steps):
        for i in range(2 * steps):
            k = j * row + i
            indices += [k, k + row, k + row + 1] if j + 1 < steps else []
            indices += [k, k + row + 1, k + 1] if j > 0 else []
            if j + 1 == steps:
                indices += [k, k + row, k + 1]
    attributes = {"POSITION": g.positions([(0.1 * x, 0.1 + 0.1 * y, 0.1 * z) for x, y, z in places]),
                  "NORMAL": g.accessor(places, "VEC3"), "TEXCOORD_0": g.accessor(coordinates, "VEC2")}
    if colours:
        attributes["COLOR_0"] = g.accessor([colours(*p) for p in places], "VEC4")
    return {"attributes": attributes, "material": 0, "indices": g.accessor(indices, "SCALAR", "I", 5125)}


def textures(g, *images):
    g.json["images"] = [{"bufferView": g.view(each), "mimeType": "image/png"} for each in images]
    g.json["textures"] = [{"source": i} for i in range(len(images))]


def waves(u, v):
    """Normals of bumps, in the frame of the texture."""
    x, y = 0.5 * math.cos(40 * math.pi * u), 0.5 * math.cos(20 * math.pi * v)
    length = math.sqrt(x * x + y * y + 1)
    return tuple(127.5 + 127.5 * c / length for c in (x, y, 1))


def stripes(u, v):
    """Green: roughness, blue: metallic."""
    return 0, 40 + 180 * (int(16 * u) % 2), 255 * (int(8 * v) % 2)


def lit(u, v):
    return (255, 180, 60) if (int(8 * u) + int(8 * v)) % 2 else (0, 0, 0)


def fence(u, v):
    open_here = 0.12 < (6 * u) % 1 < 0.88 and 0.12 < (6 * v) % 1 < 0.88
    return 70, 110, 70, 0 if open_here else 255


def rgba_png(colour, side=SIDE):
    import struct
    import zlib

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b"".join(b"\0" + bytes(c for x in range(side) for c in colour((x + .5) / side, (y + .5) / side))
                    for y in range(side))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 6, 0, 0, 0)) + \
        chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def written(folder, name, make):
    g = make_models.Gltf()
    mesh, material, more = make(g)
    g.json |= {"scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": name, "mesh": 0}],
               "meshes": [{"name": name, "primitives": [mesh]}], "materials": [{"name": name, **material}], **more}
    g.write(pathlib.Path(folder) / (name + ".gltf"), name + ".bin")


def bumps(g):
    textures(g, image(textured_scene.globe), image(waves))
    return ball(g), {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": .6},
                     "normalTexture": {"index": 1}}, {}


def metal(g):
    textures(g, image(stripes))
    return ball(g), {"pbrMetallicRoughness": {"baseColorFactor": [.9, .6, .3, 1],
                                              "metallicRoughnessTexture": {"index": 0}}}, {}


def lantern(g):
    textures(g, image(lit))
    return g.box((.16, .2, .16), (0, .1, 0), 0), {
        "pbrMetallicRoughness": {"baseColorFactor": [.2, .2, .25, 1], "metallicFactor": 0, "roughnessFactor": .7},
        "emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}, {}


def lattice(g):
    textures(g, rgba_png(fence))
    return g.box((.18, .18, .18), (0, .09, 0), 0), {
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": .8},
        "alphaMode": "MASK", "doubleSided": True}, {}


def painted(g):
    return ball(g, colours=lambda x, y, z: (.5 + .5 * x, .5 + .5 * y, .5 + .5 * z, 1)), {
        "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": .5}}, {}


def tiled(g):
    textures(g, image(textured_scene.label))
    transform = {"offset": [.1, .2], "rotation": .5, "scale": [3, 2]}
    return g.box((.2, .16, .2), (0, .08, 0), 0), {
        "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": .6, "baseColorTexture": {
            "index": 0, "extensions": {"KHR_texture_transform": transform}}}}, {"extensionsUsed": ["KHR_texture_transform"]}


MODELS = {"bumps": bumps, "metal": metal, "lantern": lantern, "lattice": lattice, "painted": painted, "tiled": tiled}


def main():
    os.makedirs(sys.argv[1], exist_ok=True)
    for name, make in MODELS.items():
        written(sys.argv[1], name, make)


if __name__ == "__main__":
    main()
