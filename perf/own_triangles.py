"""A scene's own triangles as models, for judges that would cut faces of many corners, which are not flat, into others.

written(report, scene, folder) writes a model in world coordinates for each object of a GLB scene into the folder, and a
report that names these; returns its path.
"""
import json
import os
import struct

FORMATS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
ONE = [[float(i == k) for k in range(4)] for i in range(4)]


class Glb:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.blob = memoryview(data)[28 + length:]

    def values(self, number):
        """Tuples of an accessor."""
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        form = "<%d%s" % ({"SCALAR": 1, "VEC3": 3}[accessor["type"]], FORMATS[accessor["componentType"]])
        step = view.get("byteStride", struct.calcsize(form))
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return [struct.unpack_from(form, self.blob, start + k * step) for k in range(accessor["count"])]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def matrix(node):
    if "matrix" in node:
        return [[node["matrix"][4 * j + i] for j in range(4)] for i in range(4)]
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    scale, offset = node.get("scale", [1, 1, 1]), node.get("translation", [0, 0, 0])
    turn = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [[turn[i][j] * scale[j] for j in range(3)] + [offset[i]] for i in range(3)] + [[0, 0, 0, 1]]


def moved(point, world):
    """To the world, and from y up to z up."""
    x, y, z = (sum(row[k] * point[k] for k in range(3)) + row[3] for row in world[:3])
    return x, -z, y


def meshes(glb, names):
    """Vertices and triangles of each named node with all that is below it."""
    out = {}

    def visit(number, above, name):
        node = glb.json["nodes"][number]
        world = product(above, matrix(node))
        if name is None and node.get("name") in names:
            name = node["name"]
        if "mesh" in node and name is not None:
            vertices, triangles = out.setdefault(name, ([], []))
            for part in glb.json["meshes"][node["mesh"]]["primitives"]:
                first = len(vertices)
                vertices += [moved(p, world) for p in glb.values(part["attributes"]["POSITION"])]
                corners = [first + k for k, in glb.values(part["indices"])]
                triangles += [corners[k:k + 3] for k in range(0, len(corners), 3)]
        for child in node.get("children", []):
            visit(child, world, name)

    for root in glb.json["scenes"][0]["nodes"]:
        visit(root, ONE, None)
    return out


def written(report, scene, folder):
    with open(report) as file:
        result = json.load(file)
    os.makedirs(folder, exist_ok=True)
    found = meshes(Glb(scene), {o["name"] for o in result["objects"]})
    for number, entry in enumerate(result["objects"]):
        if entry["name"] not in found:
            continue
        vertices, triangles = found[entry["name"]]
        entry["model"] = os.path.join(os.path.abspath(folder), "%d.obj" % number)
        entry["world_from_file"] = [value for row in ONE for value in row]
        entry["triangles"] = len(triangles)
        with open(entry["model"], "w") as file:
            file.writelines("v %.9g %.9g %.9g\n" % v for v in vertices)
            file.writelines("f %d %d %d\n" % tuple(k + 1 for k in t) for t in triangles)
    path = os.path.join(folder, "report.json")
    with open(path, "w") as file:
        json.dump(result, file)
    return path
