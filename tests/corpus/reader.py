"""A second reader of OBJ, STL, PLY and OFF, written from the formats' descriptions alone: box, area, volume,
triangles.

Plain Python, slow, in doubles; it knows nothing of materials. Polygons keep their vertices: their area is that of
their vector area, which is right for planar ones, and `bent` counts the others.
"""
import math
import re
import struct


class Surface:
    def __init__(self):
        self.triangles = 0
        self.area = 0.0
        self.volume = 0.0  # as wound
        self.bent = 0
        self.lower = [math.inf] * 3
        self.upper = [-math.inf] * 3

    def add(self, corners):
        if len(corners) < 3:
            return
        self.triangles += len(corners) - 2
        for p in corners:
            for i in range(3):
                self.lower[i] = min(self.lower[i], p[i])
                self.upper[i] = max(self.upper[i], p[i])
        first = corners[0]
        total, sizes = [0.0] * 3, 0.0
        for a, b in zip(corners[1:], corners[2:]):
            u = [a[i] - first[i] for i in range(3)]
            v = [b[i] - first[i] for i in range(3)]
            n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            total = [total[i] + n[i] for i in range(3)]
            self.volume += sum(n[i] * first[i] for i in range(3)) / 6
            sizes += math.sqrt(sum(x * x for x in n))
        area = math.sqrt(sum(x * x for x in total)) / 2
        self.area += area
        if len(corners) > 3:
            size = max(max(p[i] for p in corners) - min(p[i] for p in corners) for i in range(3))
            normal = [x / (2 * area) for x in total] if area > 0 else [0, 0, 0]
            off = max(abs(sum(normal[i] * (p[i] - first[i]) for i in range(3))) for p in corners)
            self.bent += not area > 0 or off > 1e-6 * size


def read_obj(data):
    surface, vertices = Surface(), []
    marks = {b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16"}
    text = data.decode(marks.get(data[:2], "utf-8-sig"), "replace")
    text = re.sub(r"\\[ \t]*\r?\n", " ", text)
    for line in re.split(r"\r\n|\r|\n", text):
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] == "v":
            vertices.append(tuple(float(w) for w in words[1:4]))
        elif words[0] in ("f", "fo"):
            ids = [int(w.split("/")[0]) for w in words[1:]]
            surface.add([vertices[i - 1 if i > 0 else i] for i in ids])
    return surface


def read_stl(data):
    surface = Surface()
    if len(data) >= 84 and len(data) >= 84 + 50 * struct.unpack_from("<I", data, 80)[0] and not (
            data.lstrip()[:5].lower() == b"solid" and b"facet" in data[:4096].lower() and b"\0" not in data[:512]):
        for i in range(struct.unpack_from("<I", data, 80)[0]):
            n = struct.unpack_from("<9f", data, 84 + 50 * i + 12)
            surface.add([n[0:3], n[3:6], n[6:9]])
        return surface
    corners = []
    for line in data.decode("latin-1").lower().splitlines():
        words = line.split()
        if words[:1] == ["vertex"]:
            corners.append(tuple(float(w) for w in words[1:4]))
        elif words[:1] == ["endfacet"]:
            surface.add(corners)
            corners = []
    return surface


PLY_TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
             "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f",
             "double": "d", "float64": "d"}


def read_ply(data):
    surface, elements, kind = Surface(), [], ""
    at = 0
    while True:
        end = data.index(b"\n", at)
        words = data[at:end].decode("latin-1").split()
        at = end + 1
        if words[:1] == ["format"]:
            kind = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[1:])
        elif words[:1] == ["end_header"]:
            break
    if kind == "ascii":
        words = iter(data[at:].split())
        take = lambda name: float(next(words))  # noqa: E731
    else:
        order, place = "<" if "little" in kind else ">", [at]

        def take(name):
            form = order + PLY_TYPES[name]
            value = struct.unpack_from(form, data, place[0])[0]
            place[0] += struct.calcsize(form)
            return value
    vertices = []
    for name, count, properties in elements:
        for _ in range(count):
            item = {}
            for p in properties:
                item[p[-1]] = [take(p[2]) for _ in range(int(take(p[1])))] if p[0] == "list" else take(p[0])
            if name == "vertex":
                vertices.append((item["x"], item["y"], item["z"]))
            elif name == "face":
                ids = item.get("vertex_indices", item.get("vertex_index", []))
                surface.add([vertices[int(i)] for i in ids])
    return surface


def read_off(data):
    surface = Surface()
    lines = [line.split("#")[0].split() for line in data.decode("latin-1").splitlines()]
    words = iter([word for line in lines for word in line][1:])
    num_vertices, num_faces, _ = (int(next(words)) for _ in range(3))
    vertices = [tuple(float(next(words)) for _ in range(3)) for _ in range(num_vertices)]
    for _ in range(num_faces):
        surface.add([vertices[int(next(words))] for _ in range(int(next(words)))])
    return surface


READERS = {".obj": read_obj, ".stl": read_stl, ".ply": read_ply, ".off": read_off}
