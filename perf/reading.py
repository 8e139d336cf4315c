"""Time and memory of reading 1,000,000 triangles, beside assimp: reading.py TRIVET_IMPORT [FORMAT...]

Formats of own readers come first; Collada, FBX and 3DS are read by assimp in both. Both read the same files in turn, RUNS times each; the least processor time and the largest resident set count.
trivet-import reads, cuts polygons, joins vertices, finds normals and hands the model over; assimp reads, triangulates
and joins identical vertices, in this Python. Prints a table.
"""
import ctypes
import io
import os
import struct
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/apps"))
import model_files  # noqa: E402

SIDE = 708  # squares of the height field: 2 x 708 x 708 triangles
RUNS = 3
ANSWERS = 3  # descriptor of trivet-import
BY_ASSIMP = """
import ctypes, resource, sys
library = ctypes.CDLL("libassimp.so.5")
library.aiImportFile.restype = ctypes.c_void_p
before = resource.getrusage(resource.RUSAGE_SELF)
scene = library.aiImportFile(sys.argv[1].encode(), 0x2 | 0x8)
after = resource.getrusage(resource.RUSAGE_SELF)
print(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, after.ru_maxrss / 1024, bool(scene))
"""


def field():
    """Positions of a bent square, and its triangles."""
    n = SIDE + 1
    positions = [(i / SIDE, j / SIDE, (i * j % 97) / 1000) for j in range(n) for i in range(n)]
    triangles = []
    for j in range(SIDE):
        for i in range(SIDE):
            a = j * n + i
            triangles += [(a, a + 1, a + n + 1), (a, a + n + 1, a + n)]
    return positions, triangles


def obj(positions, triangles):
    return "".join("v %.6f %.6f %.6f\n" % p for p in positions) + "".join("f %d %d %d\n" % (a + 1, b + 1, c + 1) for a, b, c in triangles)


def off(positions, triangles):
    return "OFF\n%d %d 0\n" % (len(positions), len(triangles)) + "".join("%.6f %.6f %.6f\n" % p for p in positions) + "".join(
        "3 %d %d %d\n" % t for t in triangles)


def stl(positions, triangles):
    return b"".ljust(80) + struct.pack("<I", len(triangles)) + b"".join(
        struct.pack("<12f", 0, 0, 1, *positions[a], *positions[b], *positions[c]) + b"\0\0" for a, b, c in triangles)


def ply(positions, triangles):
    head = ("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (len(positions), len(triangles)))
    return head.encode() + b"".join(struct.pack("<3f", *p) for p in positions) + b"".join(struct.pack("<B3i", 3, *t) for t in triangles)


def threemf(positions, triangles):
    model = ('<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1"><mesh><vertices>'
             + "".join('<vertex x="%.6f" y="%.6f" z="%.6f"/>' % p for p in positions) + "</vertices><triangles>"
             + "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % t for t in triangles)
             + '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>')
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("_rels/.rels", '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" '
                         'Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
        archive.writestr("3D/3dmodel.model", model)
    return out.getvalue()


def glb(positions, triangles):
    data = b"".join(struct.pack("<3f", *p) for p in positions) + b"".join(struct.pack("<3I", *t) for t in triangles)
    split = 12 * len(positions)
    text = ('{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":'
            '{"POSITION":0},"indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":%d,"type":"VEC3","min":[0,0,0],'
            '"max":[1,1,0.096]},{"bufferView":1,"componentType":5125,"count":%d,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":%d},'
            '{"buffer":0,"byteOffset":%d,"byteLength":%d}],"buffers":[{"byteLength":%d}]}' % (
                len(positions), 3 * len(triangles), split, split, len(data) - split, len(data))).encode()
    text += b" " * (-len(text) % 4)
    return (b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(data)) + struct.pack("<I", len(text)) + b"JSON" + text +
            struct.pack("<I", len(data)) + b"BIN\0" + data)


def solid(positions, triangles):
    return model_files.Solid(positions, triangles, 0, 0, None)


def dae(positions, triangles):
    return model_files.dae(solid(positions, triangles), kind="triangles")


def fbx(positions, triangles):
    return model_files.fbx(solid(positions, triangles))


def three_ds(positions, triangles):
    """Objects of up to 60,000 corners, as ids have 16 bits."""
    def chunk(kind, data):
        return struct.pack("<HI", kind, 6 + len(data)) + data
    objects, most = [], 20_000
    for begin in range(0, len(triangles), most):
        part = triangles[begin:begin + most]
        corners = b"".join(struct.pack("<3f", *positions[i]) for t in part for i in t)
        ids = b"".join(struct.pack("<4H", 3 * i, 3 * i + 1, 3 * i + 2, 7) for i in range(len(part)))
        mesh = chunk(0x4110, struct.pack("<H", 3 * len(part)) + corners) + chunk(0x4120, struct.pack("<H", len(part)) + ids)
        objects.append(chunk(0x4000, b"a%d\0" % begin + chunk(0x4100, mesh)))
    return chunk(0x4D4D, chunk(0x3D3D, b"".join(objects)))


def by_trivet(program, path):
    read, write = os.pipe()
    os.set_inheritable(write, True)
    arguments = [program, path, str(1 << 32), "50000000", str(4 << 30), "600", "0", "0"]
    pid = os.posix_spawn(program, arguments, os.environ, file_actions=[(os.POSIX_SPAWN_DUP2, write, ANSWERS)])
    os.close(write)
    with os.fdopen(read, "rb") as answer:
        num_bytes = sum(len(piece) for piece in iter(lambda: answer.read(1 << 20), b""))
    _, status, usage = os.wait4(pid, 0)
    assert status == 0 and num_bytes > 10_000_000, (path, status, num_bytes)
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def by_assimp(path):
    words = subprocess.run([sys.executable, "-c", BY_ASSIMP, path], capture_output=True, text=True, check=True).stdout.split()
    assert words[2] == "True", path
    return float(words[0]), float(words[1])


def names():
    return sys.argv[2:] or list(FORMATS)


def write_files(folder):
    """In a process that ends: the memory of its children would count its own."""
    if os.fork() == 0:
        mesh = field()
        for name in names():
            content = FORMATS[name](*mesh)
            (folder / ("m." + name)).write_bytes(content if isinstance(content, bytes) else content.encode())
        os._exit(0)
    assert os.wait()[1] == 0


def main():
    ctypes.CDLL("libassimp.so.5")
    print("| format | Trivet, s | assimp, s | ratio | Trivet, MB | assimp, MB |\n|---|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        write_files(Path(folder))
        for name in names():
            path = str(Path(folder) / ("m." + name))
            own, other = [], []
            for _ in range(RUNS):
                own.append(by_trivet(sys.argv[1], path))
                other.append(by_assimp(path))
            (own_s, own_mb), (other_s, other_mb) = (map(min, zip(*runs)) for runs in (own, other))
            print("| .%s | %.2f | %.2f | %.2f | %.0f | %.0f |" % (name, own_s, other_s, own_s / other_s, own_mb, other_mb))


FORMATS = {"obj": obj, "stl": stl, "ply": ply, "off": off, "3mf": threemf, "glb": glb, "dae": dae, "fbx": fbx, "3ds": three_ds}

if __name__ == "__main__":
    main()
