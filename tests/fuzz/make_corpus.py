"""Small models in many formats, for fuzzing: make_corpus.py FOLDER [others]

others: of the formats that assimp reads alone, and small files of Debian's assimp-testmodels if that is installed.
"""
import base64
import json
import struct
import sys
import zlib
from pathlib import Path

TESTS = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TESTS / "interop"), str(TESTS / "apps")]
import make_models  # noqa: E402
import model_files  # noqa: E402
import reading_more_forms  # noqa: E402

V = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
F = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def obj():
    return ("mtllib x.mtl\no a\n" + "".join("v %g %g %g\n" % v for v in V) +
            "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nusemtl m\ns 1\n" +
            "".join("f %d/1/1 %d/2/1 %d/3/1\n" % tuple(i + 1 for i in f) for f in F) +
            "g b\nf 1 2 3 4\nl 1 2\n")


def ply(binary):
    head = ("ply\nformat %s 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty float y\n"
            "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n")
    if not binary:
        return (head % "ascii" + "".join("%g %g %g 9 99 255\n" % v for v in V) +
                "".join("3 %d %d %d\n" % f for f in F)).encode()
    return (head % "binary_little_endian").encode() + b"".join(
        struct.pack("<fffBBB", *v, 9, 99, 255) for v in V) + b"".join(
        struct.pack("<Biii", 3, *f) for f in F)


def rich_obj():
    """An OBJ file with all else that the format has: continued lines, negative ids, weights, colours, polygons, curves."""
    return ("# c\nmtllib x.mtl y z.mtl\nv 0 0 0 1\nv 1 0 0 0.5\nv 1 1 0 1 0 0\nv 0 1 0\nv .5 .25 0\n"
            "vt 0 0 0\nvn 0 0 1\no a\ng b c\ns off\nusemtl m\nf 1/1 2/1 3/1 5 4/1 # five\n"
            "f -5//1 \\\n-4//1 -3//1\nl 1 2 3\np 1\ncstype bezier\ncurv 0 1 1 2\nend\ncall q.obj\nf 5 1 2\n")


def rich_ply(order):
    """Doubles, a camera, colours of faces, coordinates of corners and strips."""
    head = ("ply\nformat binary_%s_endian 1.0\ncomment TextureFile t.png\nelement camera 1\nproperty list uchar short v\n"
            "element vertex 4\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\n"
            "property float ny\nproperty float nz\nelement face 2\nproperty list uchar uint vertex_index\n"
            "property list uchar float texcoord\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" % ("little" if order == "<" else "big"))
    return head.encode() + struct.pack(order + "Bhh", 2, 7, 8) + b"".join(
        struct.pack(order + "dddfff", *v, 0, 0, 1) for v in V) + struct.pack(
        order + "B4IB8f3B", 4, 0, 1, 2, 3, 8, *range(8), 1, 2, 3) + struct.pack(
        order + "B3IB6f3B", 3, *F[0], 6, *range(6), 1, 2, 3) + struct.pack(order + "i6i", 6, 0, 1, 2, -1, 1, 3)


def model_3mf():
    """The XML of a 3MF; fuzz_import packs it."""
    vertices = "".join('<vertex x="%g" y="%g" z="%g"/>\n' % v for v in V)
    triangles = "".join('<triangle v1="%d" v2="%d" v3="%d" pid="1" p1="0"/>\n' % f for f in F)
    return ('<?xml version="1.0" encoding="UTF-8"?>\n<model unit="inch" requiredextensions="p" xmlns:p="http://x/production/1">\n'
            '<resources>\n<basematerials id="1"><base name="a" displaycolor="#FF8800"/></basematerials>\n'
            '<object id="2" name="n"><mesh>\n<vertices>\n' + vertices + '</vertices><triangles>\n' + triangles +
            '</triangles></mesh></object>\n<object id="3"><components>\n<component objectid="2" transform="1 0 0 0 1 0 0 0 1 0 0 5"/>\n'
            '<component objectid="2" p:path="/3D/3dmodel.model"/>\n</components></object>\n</resources>\n'
            '<build>\n<item objectid="3" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>\n</build></model>\n')


def stl(binary):
    if binary:
        return b"x" * 80 + struct.pack("<I", 4) + b"".join(
            struct.pack("<12f", 0, 0, 1, *V[a], *V[b], *V[c]) + b"\0\0" for a, b, c in F)
    facets = "".join("facet normal 0 0 1\nouter loop\n" +
                     "".join("vertex %g %g %g\n" % V[i] for i in f) + "endloop\nendfacet\n" for f in F)
    return ("solid a\n" + facets + "endsolid a\n").encode()


def glb():
    binary = struct.pack("<12f", *sum(V, ())) + struct.pack("<12H", *sum(F, ()))
    text = ('{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,'
            '"scale":[1,2,3],"name":"n"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},'
            '"indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":'
            '"VEC3","min":[0,0,0],"max":[1,1,1]},{"bufferView":1,"componentType":5123,"count":12,'
            '"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset"'
            ':48,"byteLength":24}],"buffers":[{"byteLength":72}]}').encode()
    text += b" " * (-len(text) % 4)
    return (b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(binary)) +
            struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(binary)) +
            b"BIN\0" + binary)


def png(width, height):
    """RGBA, each texel of its own colour."""
    def part(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b"".join(b"\0" + bytes((60 * x + 7 * y + c) % 256 for x in range(width) for c in range(4))
                    for y in range(height))
    return b"\x89PNG\r\n\x1a\n" + part(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) + \
        part(b"IDAT", zlib.compress(rows)) + part(b"IEND", b"")


# 16 x 16 and 4 x 2 texels, as in tests/core/io/test_decoded_image.cpp.
JPEG = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAIBAQEBAQIBAQECAgICAgQDAgICAgUEBAMEBgUGBgYFBgYGBwkIBgcJBwYGCAsICQoKCgoKBggL"
    "DAsKDAkKCgr/2wBDAQICAgICAgUDAwUKBwYHCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgr/"
    "wAARCAAQABADAREAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAABwj/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/8QAFQEBAQAAAAAAAAAAAAAA"
    "AAAACQf/xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oADAMBAAIRAxEAPwCX0TKABzWCLPAUy6Ac1gi3/9k=")
WEBP = base64.b64decode(
    "UklGRkoAAABXRUJQVlA4TD4AAAAvA0AAED9AmG20g7jv/C2nQSZtk38e6t/lCLJtdpHdn3IEkzR1+djlBQiRsUP695maQSBAxmKUOFAjov+BDQ==")


def textured_glb():
    """A tetrahedron with texture coordinates, colours and an image of each kind."""
    parts = [struct.pack("<12f", *sum(V, ())), struct.pack("<8f", 0, 0, 1, 0, 0, 1, 1, 1),
             struct.pack("<12H", *sum(F, ())), png(4, 3), JPEG, WEBP]
    views, binary = [], b""
    for part in parts:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(part)})
        binary += part + b"\0" * (-len(part) % 4)
    def texture(i):
        return {"index": i, "extensions": {"KHR_texture_transform": {"scale": [2, 3], "rotation": 0.5}}}
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "extensionsUsed": ["KHR_texture_transform", "EXT_texture_webp"],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "COLOR_0": 0},
                                    "indices": 2, "material": 0}]}],
        "materials": [{"alphaMode": "MASK", "emissiveTexture": texture(2), "emissiveFactor": [1, 1, 1],
                       "normalTexture": texture(1),
                       "pbrMetallicRoughness": {"baseColorTexture": texture(0)}}],
        "textures": [{"source": 0, "sampler": 0}, {"source": 1},
                     {"extensions": {"EXT_texture_webp": {"source": 2}}}],
        "samplers": [{"wrapS": 33071, "wrapT": 33648}],
        "images": [{"bufferView": 3, "mimeType": "image/png"}, {"bufferView": 4, "mimeType": "image/jpeg"},
                   {"bufferView": 5, "mimeType": "image/webp"}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 1]},
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5123, "count": 12, "type": "SCALAR"}],
        "bufferViews": views, "buffers": [{"byteLength": len(binary)}]}).encode()
    text += b" " * (-len(text) % 4)
    return (b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(binary)) +
            struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(binary)) +
            b"BIN\0" + binary)


def chunk(kind, data):
    return struct.pack("<HI", kind, 6 + len(data)) + data


def three_ds():
    mesh = chunk(0x4110, struct.pack("<H12f", 4, *sum(V, ()))) + \
        chunk(0x4120, struct.pack("<H", 4) + b"".join(struct.pack("<4H", *f, 7) for f in F))
    return chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, b"tetra\0" + chunk(0x4100, mesh))))


def fbx():
    faces = ",".join("%d,%d,%d" % (a, b, ~c) for a, b, c in F)
    return f"""; FBX 7.4.0 project file
FBXHeaderExtension:  {{
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}}
Objects:  {{
	Geometry: 1001, "Geometry::g", "Mesh" {{
		Vertices: *12 {{
			a: {",".join("%g" % x for v in V for x in v)}
		}}
		PolygonVertexIndex: *12 {{
			a: {faces}
		}}
		GeometryVersion: 124
	}}
	Model: 1002, "Model::n", "Mesh" {{
		Version: 232
	}}
}}
Connections:  {{
	C: "OO",1002,0
	C: "OO",1001,1002
}}
"""


def off():
    return "OFF\n4 4 6\n" + "".join("%g %g %g\n" % v for v in V) + "".join("3 %d %d %d\n" % f for f in F)


def rich_off():
    """Weights, normals, colours of both kinds, an edge, a point, comments."""
    return ("# c\nCN4OFF # d\n4 6 0\n" + "".join("%g %g %g 1 0 0 1 255 128 0 255\n" % v for v in V) +
            "".join("3 %d %d %d 1.0 0.5 0 # e\n" % f for f in F) + "2 0 1\n1 3 7\n")


def mtl():
    """fuzz_readers puts it beside an OBJ."""
    return ("newmtl m\nKa 1 1 1\nKd 0.8 0.5 .25\nKs 0.5\nKe 0 0 0\nNs 250\nNi 1.45\nd 0.5\nTr 0.5\nillum 2\n"
            "map_Kd -s 1 1 1 -o 0.5 0 -bm 0.1 -clamp on t.png\nbump -bm 1 b.png\nPr 0.5\nPm 1\nmap_Ke \"e f.png\"\n"
            "Kf spectral x.rfl 1\n# c\nnewmtl n o\nKd xyz 1 2 3\naniso 0.5\n")


def x3d():
    index = " ".join("%d %d %d -1" % f for f in F)
    points = " ".join("%g %g %g" % v for v in V)
    return (f'<?xml version="1.0"?><X3D version="3.0"><Scene><Transform translation="1 0 0"><Shape>'
            f'<IndexedFaceSet coordIndex="{index}"><Coordinate point="{points}"/></IndexedFaceSet>'
            f'</Shape></Transform></Scene></X3D>')


def make_others(folder):
    """A prism with n-gons in each format; what else formats have is in the files of Debian's package, of up to 20 KB."""
    solid = reading_more_forms.PRISM
    made = {"p.ac": reading_more_forms.ac3d(solid) % "rot 0 1 0 -1 0 0 0 0 1\n", "p.x": reading_more_forms.direct_x(solid),
            "p.lwo": reading_more_forms.lwo(solid), "p.3ds": reading_more_forms.three_ds(solid), "p.amf": reading_more_forms.amf(solid),
            "p.fbx": model_files.fbx(solid), "p.dae": model_files.dae(solid, kind="polygons"), "p.x3d": model_files.x3d(solid)}
    for name, content in made.items():
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    for path in sorted(Path("/usr/share/assimp/models").rglob("*")):
        if path.suffix.lower() in OTHERS and path.is_file() and path.stat().st_size <= 20_000:
            (folder / (path.parent.name + "_" + path.stem + path.suffix.lower())).write_bytes(path.read_bytes())


OTHERS = {".fbx", ".dae", ".3ds", ".ac", ".x", ".lwo", ".lws", ".amf", ".x3d", ".ase", ".dxf", ".ms3d", ".b3d", ".md2", ".md3", ".nff", ".cob",
          ".smd", ".raw", ".q3o", ".irr", ".irrmesh", ".csm", ".bvh", ".xgl", ".zgl", ".hmp", ".ifc", ".blend", ".assbin", ".m3d", ".sib", ".ter",
          ".q3s", ".mdl", ".md5mesh"}


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    if sys.argv[2:] == ["others"]:
        make_others(folder)
        return
    made = {"t.obj": obj(), "ascii.ply": ply(False), "binary.ply": ply(True), "ascii.stl": stl(False),
            "binary.stl": stl(True), "rich.obj": rich_obj(), "little.ply": rich_ply("<"), "big.ply": rich_ply(">"),
            "t.3mf": model_3mf(), "t.glb": glb(), "textured.glb": textured_glb(), "t.3ds": three_ds(), "t.fbx": fbx(),
            "t.off": off(), "rich.off": rich_off(), "m.mtl": mtl(),
            "wide.obj": b"\xff\xfe" + obj().encode("utf-16-le"), "t.x3d": x3d()}
    for name, content in made.items():
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    for packed in (Path(__file__).resolve().parent.parent / "support/gltf").glob("*.glb"):
        (folder / packed.name).write_bytes(packed.read_bytes())
    scenes = folder / "scenes"
    scenes.mkdir(exist_ok=True)
    for case in (Path(__file__).resolve().parent.parent / "core/io/foreign/cases").glob("*"):
        if case.suffix in (".xml", ".urdf", ".sdf", ".usda"):
            (scenes / case.name).write_bytes(case.read_bytes())
    models = folder / "models"
    models.mkdir(exist_ok=True)
    make_models.lamp(models)
    make_models.shelf(models)
    (models / "shelf.dae").rename(folder / "shelf.dae")
    # A mutated copy lies elsewhere, so its buffer must be embedded.
    text = (models / "lamp.gltf").read_text()
    data = base64.b64encode((models / "lamp.bin").read_bytes()).decode()
    (folder / "lamp.gltf").write_text(
        text.replace('"lamp.bin"', '"data:application/octet-stream;base64,' + data + '"'))
    for left in models.iterdir():
        left.unlink()
    models.rmdir()


if __name__ == "__main__":
    main()
