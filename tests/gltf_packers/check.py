"""Packs models of known volume and compares what Trivet reads of them: check.py TRIVET WORK_FOLDER

The folder has node_modules. Each model is read plain and packed in every way; triangles, box, volume, area and centre
agree within the quantum of the packer.
"""
import json
import math
import struct
import subprocess
import sys
from pathlib import Path

# Step to which a packer rounds positions, as a share of the model's size.
BITS_14 = 1 / (2 ** 14 - 1)
BITS_11 = 1 / (2 ** 11 - 1)
PLAIN = 1e-6


def ring(n, m):
    """Closed and smooth: positions, normals, triangles."""
    positions, normals, triangles = [], [], []
    for i in range(n):
        for j in range(m):
            a, b = 2 * math.pi * i / n, 2 * math.pi * j / m
            positions.append(((2 + math.cos(b)) * math.cos(a), math.sin(b), (2 + math.cos(b)) * math.sin(a)))
            normals.append((math.cos(b) * math.cos(a), math.sin(b), math.cos(b) * math.sin(a)))
            q = [i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m]
            triangles += [(q[0], q[2], q[1]), (q[0], q[3], q[2])]
    return positions, normals, triangles


def cube():
    """Twelve triangles whose corners have the normals of their faces."""
    positions, normals, triangles = [], [], []
    for axis in range(3):
        for side in (-1, 1):
            first = len(positions)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = [0.0, 0.0, 0.0]
                corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = side / 2, u / 2, v / 2
                positions.append(tuple(corner))
                normals.append(tuple(side if k == axis else 0 for k in range(3)))
            for a, b, c in ((0, 1, 2), (0, 2, 3)):
                triangles.append((first + a, first + b, first + c) if side > 0 else (first + a, first + c, first + b))
    return positions, normals, triangles


def glb(meshes, nodes):
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
            "meshes": [], "accessors": [], "bufferViews": []}
    data = b""

    def add(part, component, kind, count, **more):
        nonlocal data
        root["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
        data += part + b"\0" * (-len(part) % 4)
        root["accessors"].append({"bufferView": len(root["bufferViews"]) - 1, "componentType": component,
                                  "count": count, "type": kind, **more})
        return len(root["accessors"]) - 1

    for positions, normals, triangles in meshes:
        bounds = {"min": [min(p[k] for p in positions) for k in range(3)],
                  "max": [max(p[k] for p in positions) for k in range(3)]}
        at = add(b"".join(struct.pack("<3f", *p) for p in positions), 5126, "VEC3", len(positions), **bounds)
        up = add(b"".join(struct.pack("<3f", *n) for n in normals), 5126, "VEC3", len(normals))
        ids = add(b"".join(struct.pack("<3I", *t) for t in triangles), 5125, "SCALAR", 3 * len(triangles))
        root["meshes"].append({"primitives": [{"attributes": {"POSITION": at, "NORMAL": up}, "indices": ids}]})
    root["buffers"] = [{"byteLength": len(data)}]
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    return (b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(data)) + struct.pack("<I", len(text)) + b"JSON" + text +
            struct.pack("<I", len(data)) + b"BIN\0" + data)


def models():
    """Name, bytes, and the volume of the solids that a node shows."""
    turned = [0, math.sin(0.3), 0, math.cos(0.3)]
    yield "ring", glb([ring(64, 32)], [{"mesh": 0, "translation": [0.5, 1, 0]}])
    yield "mirrored", glb([ring(32, 16), cube()], [
        {"mesh": 0, "translation": [-5, 0, 0]}, {"mesh": 0, "translation": [5, 0, 0], "scale": [-1, 1, 1]},
        {"mesh": 1, "rotation": turned}, {"mesh": 1, "translation": [0, 3, 0], "scale": [-1, 2, 1], "rotation": turned}])
    yield "row", glb([cube()], [{"mesh": 0, "translation": [2 * i, 0, i % 3], "rotation": turned} for i in range(12)])


def packers(work):
    """Name, command of an input and an output, ending of the output, quantum, whether triangles may be merged."""
    folder = Path(work) / "node_modules" / ".bin"
    transform, pack = str(folder / "gltf-transform"), str(folder / "gltfpack")
    for name, options, quantum in (("copy", [], PLAIN), ("quantize", [], BITS_14), ("meshopt", [], BITS_14),
                                   ("draco", [], BITS_14), ("draco", ["--quantize-position", "11"], BITS_11),
                                   ("draco", ["--method", "sequential"], BITS_14), ("instance", ["--min", "2"], PLAIN),
                                   ("sparse", [], PLAIN)):
        for ending in (".glb", ".gltf"):
            yield ("transform " + " ".join([name, *options]),
                   lambda a, b, n=name, o=options: [transform, n, a, b, *o], ending, quantum)
    for options, quantum in ((["-noq"], PLAIN), ([], BITS_14), (["-c"], BITS_14), (["-cc"], BITS_14), (["-c", "-vpf"], 1e-4),
                             (["-c", "-vpn"], BITS_14), (["-vp", "11"], BITS_11), (["-vi"], BITS_14), (["-mi"], BITS_14),
                             (["-c", "-mi"], BITS_14), (["-c", "-cf"], BITS_14), (["-c", "-vn", "16"], BITS_14)):
        for ending in (".glb", ".gltf"):
            yield ("pack " + " ".join(options), lambda a, b, o=options: [pack, "-i", a, "-o", b, *o], ending, quantum)


def described(trivet, file):
    done = subprocess.run([trivet, "info", file, "--json"], capture_output=True, text=True, check=False)
    if done.returncode:
        raise AssertionError(f"{file}: {done.stderr}")
    return json.loads(done.stdout)


def differences(plain, packed, quantum):
    """Yields all that differs by more than the quantum allows."""
    size = max(plain["size"])
    error = 2 * quantum * size
    if packed["triangles"] != plain["triangles"]:
        yield f"{packed['triangles']} of {plain['triangles']} triangles"
    for end in ("lower", "upper"):
        if max(abs(a - b) for a, b in zip(plain["box"][end], packed["box"][end])) > error:
            yield f"box {packed['box']} of {plain['box']}"
    if packed["mass_rule"] != plain["mass_rule"] or not packed["closed"]:
        yield f"mass by {packed['mass_rule']}"
    if abs(packed["volume"] - plain["volume"]) > error * plain["area"]:
        yield f"volume {packed['volume']} of {plain['volume']}"
    if abs(packed["area"] - plain["area"]) > 20 * error / size * plain["area"]:
        yield f"area {packed['area']} of {plain['area']}"
    if max(abs(a - b) for a, b in zip(plain["centre"], packed["centre"])) > 2 * error:
        yield f"centre {packed['centre']} of {plain['centre']}"


def main():
    trivet, work = sys.argv[1:]
    count = num_bad = 0
    for name, content in models():
        source = Path(work) / f"{name}.glb"
        source.write_bytes(content)
        plain = described(trivet, source)
        assert plain["mass_rule"] == "volume" and plain["volume"] > 0, plain
        for number, (packer, command, ending, quantum) in enumerate(packers(work)):
            folder = Path(work) / name / str(number)
            folder.mkdir(parents=True)
            output = folder / ("m" + ending)
            subprocess.run(command(str(source), str(output)), check=True, capture_output=True)
            found = list(differences(plain, described(trivet, output), quantum))
            count += 1
            num_bad += bool(found)
            for what in found:
                print(f"{name}, {packer} as {ending}: {what}")
    print(f"{count} packed models, {num_bad} differ")
    return 0 if count >= 100 and num_bad == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
