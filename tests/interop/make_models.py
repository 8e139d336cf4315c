"""Models with every supported feature, and a layout of them.

    make_models.py FOLDER

lamp.gltf: hierarchy, cameras, lights, several materials, textures in a file, in a buffer and in a
data URI, two sets of texture coordinates, vertex colours, extensions, extras. crate.obj: an MTL, a
texture beside it, two groups. shelf.dae: nodes that turn and scale. far.gltf: far from its origin.
"""
import base64
import json
import struct
import sys
import zlib
from pathlib import Path


def png(rgb_rows):
    """A PNG of rows of (r, g, b)."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    height, width = len(rgb_rows), len(rgb_rows[0])
    raw = b"".join(b"\0" + bytes(c for pixel in row for c in pixel) for row in rgb_rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def chequers(a, b, size=8):
    return png([[a if (x + y) % 2 else b for x in range(size)] for y in range(size)])


# Faces of a box: corners as bits x, y, z; counter-clockwise from outside.
BOX_FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
BOX_NORMALS = [(0, 0, -1), (0, 0, 1), (0, -1, 0), (0, 1, 0), (-1, 0, 0), (1, 0, 0)]


def box(size, centre=(0, 0, 0)):
    """Positions, normals, texture coordinates (4 per face) and indices of a box."""
    positions, normals, uv, indices = [], [], [], []
    for face, normal in zip(BOX_FACES, BOX_NORMALS):
        first = len(positions)
        for corner, t in zip(face, [(0, 0), (1, 0), (1, 1), (0, 1)]):
            bits = (corner & 1, corner >> 1 & 1, corner >> 2)
            positions.append([c + (b - 0.5) * s for b, s, c in zip(bits, size, centre)])
            normals.append(normal)
            uv.append(t)
        indices += [first, first + 1, first + 2, first, first + 2, first + 3]
    return positions, normals, uv, indices


class Gltf:
    def __init__(self):
        self.json = {"asset": {"version": "2.0", "generator": "a test", "copyright": "nobody"},
                     "accessors": [], "bufferViews": [], "meshes": []}
        self.binary = b""

    def view(self, data, **more):
        self.binary += b"\0" * (-len(self.binary) % 4)
        self.json["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data), **more})
        self.binary += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, values, kind, code="f", component=5126, **more):
        flat = [x for v in values for x in v] if kind != "SCALAR" else list(values)
        target = 34963 if kind == "SCALAR" else 34962
        entry = {"bufferView": self.view(struct.pack(f"<{len(flat)}{code}", *flat), target=target),
                 "componentType": component, "count": len(values), "type": kind, **more}
        self.json["accessors"].append(entry)
        return len(self.json["accessors"]) - 1

    def positions(self, values):
        values = [struct.unpack("<3f", struct.pack("<3f", *v)) for v in values]
        return self.accessor(values, "VEC3", min=[min(v[i] for v in values) for i in range(3)],
                             max=[max(v[i] for v in values) for i in range(3)])

    def box(self, size, centre, material, colours=False, second_uv=False):
        positions, normals, uv, indices = box(size, centre)
        attributes = {"POSITION": self.positions(positions),
                      "NORMAL": self.accessor(normals, "VEC3"),
                      "TEXCOORD_0": self.accessor(uv, "VEC2")}
        if second_uv:
            attributes["TEXCOORD_1"] = self.accessor([(v, u) for u, v in uv], "VEC2")
        if colours:
            attributes["COLOR_0"] = self.accessor(
                [(i * 9 % 255, 40, 200, 255) for i in range(len(uv))], "VEC4", "B", 5121,
                normalized=True)
        return {"attributes": attributes, "material": material,
                "indices": self.accessor(indices, "SCALAR", "H", 5123)}

    def write(self, path, buffer_name):
        self.json["buffers"] = [{"uri": buffer_name, "byteLength": len(self.binary)}]
        (path.parent / buffer_name).write_bytes(self.binary)
        path.write_text(json.dumps(self.json, indent=1))


def lamp(folder):
    g = Gltf()
    (folder / "lamp base.png").write_bytes(chequers((200, 40, 40), (240, 220, 200)))
    in_view = g.view(chequers((20, 20, 90), (90, 90, 250)))
    data_uri = base64.b64encode(chequers((128, 128, 255), (140, 120, 250))).decode()
    g.json |= {
        "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_clearcoat",
                           "KHR_texture_transform", "KHR_materials_emissive_strength"],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "spot", "name": "bulb", "color": [1, 0.9, 0.7], "intensity": 12.5,
             "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.7}}]}},
        "images": [{"uri": "lamp%20base.png"},
                   {"bufferView": in_view, "mimeType": "image/png", "name": "arm"},
                   {"uri": "data:image/png;base64," + data_uri, "name": "bumps"}],
        "samplers": [{"magFilter": 9728, "wrapS": 33071, "wrapT": 33648}],
        "textures": [{"source": 0, "sampler": 0}, {"source": 1}, {"source": 2, "name": "normals"}],
        "materials": [
            {"name": "lacquer", "pbrMetallicRoughness": {
                "baseColorTexture": {"index": 0, "extensions": {
                    "KHR_texture_transform": {"scale": [2, 3], "offset": [0.25, 0]}}},
                "metallicFactor": 0.125, "roughnessFactor": 0.3},
             "normalTexture": {"index": 2, "scale": 0.5, "texCoord": 1},
             "extensions": {"KHR_materials_clearcoat": {
                 "clearcoatFactor": 1, "clearcoatTexture": {"index": 1}}},
             "extras": {"paint": [1, {"deep": None}]}},
            {"name": "glass", "alphaMode": "BLEND", "doubleSided": True,
             "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.4]},
             "emissiveFactor": [1, 0.8, 0.5], "emissiveTexture": {"index": 1},
             "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}}],
        "cameras": [{"type": "perspective", "name": "from the bulb",
                     "perspective": {"yfov": 0.7, "znear": 0.01, "aspectRatio": 1.5}}],
    }
    g.json["meshes"] = [
        {"name": "foot", "primitives": [
            g.box((0.2, 0.05, 0.2), (0, 0.025, 0), 0, second_uv=True),
            g.box((0.03, 0.3, 0.03), (0, 0.2, 0), 1, colours=True)], "extras": {"id": 7}},
        {"name": "shade", "primitives": [g.box((0.1, 0.08, 0.1), (0, 0.04, 0), 1)]}]
    g.json["nodes"] = [
        {"name": "lamp", "mesh": 0, "children": [1, 3], "extras": {"maker": "ACME"}},
        {"name": "arm", "translation": [0, 0.36, 0],
         "rotation": [0, 0, 0.3826834323650898, 0.9238795325112867], "children": [2]},
        {"name": "shade", "mesh": 1, "scale": [1.5, 1, 1.5],
         "translation": [0, 0.02, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "eye", "camera": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0.5, 1, 1]}]
    g.json |= {"scene": 0, "scenes": [{"name": "lamp scene", "nodes": [0]}]}
    g.write(folder / "lamp.gltf", "lamp.bin")


def far(folder):
    g = Gltf()
    g.json["materials"] = [{"name": "marble"}]
    g.json["meshes"] = [{"name": "block", "primitives": [g.box((1, 1, 1), (500, 0.5, -300), 0)]}]
    g.json |= {"nodes": [{"name": "block", "mesh": 0}], "scene": 0, "scenes": [{"nodes": [0]}]}
    g.write(folder / "far.gltf", "far.bin")


def crate(folder):
    (folder / "crate.png").write_bytes(chequers((120, 80, 30), (180, 130, 60)))
    (folder / "crate.mtl").write_text(
        "newmtl wood\nKd 0.9 0.9 0.9\nmap_Kd crate.png\nnewmtl iron\nKd 0.2 0.2 0.25\nNs 200\n"
        "Ks 0.5 0.5 0.5\n")
    lines, first = ["mtllib crate.mtl"], 1
    for name, material, size, centre in [("body", "wood", (0.4, 0.4, 0.4), (0, 0, 0.2)),
                                         ("handle", "iron", (0.2, 0.02, 0.02), (0, 0, 0.41))]:
        positions, _, uv, indices = box(size, centre)
        lines.append(f"o {name}")
        lines += ["v %.9g %.9g %.9g" % tuple(p) for p in positions]
        lines += ["vt %g %g" % t for t in uv]
        lines.append(f"usemtl {material}")
        for i in range(0, len(indices), 3):
            lines.append("f " + " ".join(f"{first + k}/{first + k}" for k in indices[i:i + 3]))
        first += len(positions)
    (folder / "crate.obj").write_text("\n".join(lines) + "\n")


def shelf(folder):
    positions, _, _, indices = box((1, 1, 1))
    floats = " ".join("%g" % x for p in positions for x in p)
    (folder / "shelf.dae").write_text(f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="metre" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert>
<diffuse><color>0.5 0.3 0.1 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="oak"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g" name="board"><mesh>
<source id="p"><float_array id="pa" count="{3 * len(positions)}">{floats}</float_array>
<technique_common><accessor source="#pa" count="{len(positions)}" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="{len(indices) // 3}" material="m"><input semantic="VERTEX" source="#v" offset="0"/>
<p>{" ".join(map(str, indices))}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">
<node id="low" name="low"><matrix>0.8 0 0 0  0 0.3 0 0  0 0 0.02 0.1  0 0 0 1</matrix>
<instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="m" target="#m"/>
</technique_common></bind_material></instance_geometry>
<node id="leg" name="leg"><matrix>0.05 0 0 0  0 0.1 0 0  0 0 5 -2.51  0 0 0 1</matrix>
<instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="m" target="#m"/>
</technique_common></bind_material></instance_geometry></node></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
""")


def layout(folder):
    objects, operations = [], []
    for name, model, x, y in [("lamp 1", "lamp.gltf", 0, 0), ("lamp 2", "lamp.gltf", 1, 0),
                              ("crate", "crate.obj", 0, 1), ("crate again", "crate.obj", 1, 1),
                              ("shelf", "shelf.dae", -1.5, 0), ("block", "far.gltf", -503, -299)]:
        objects.append({"name": name, "model": model})
        operations.append({"op": "put", "object": name, "position": [x, y, 1],
                           "rotation": [0.9, 0.1, 0.05, 0.3 * x] if abs(x) < 9 else [1, 0, 0, 0]})
    (folder / "layout.json").write_text(json.dumps(
        {"trivet": 1, "floor": True, "objects": objects, "operations": operations}, indent=1))


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for make in (lamp, far, crate, shelf, layout):
        make(folder)


if __name__ == "__main__":
    main()
