"""More forms of the faults of reading_forms.py: other formats, and files that programs write oddly."""
import codecs
import json
import struct

import model_files as mf
from model_files import box, prism
from reading_forms import CUBE, FLOAT, TOLERANCE, refused, row

LFS = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n"
PRISM = prism(mf.L)


def text_formats(s):
    return (("obj", mf.obj(s)), ("stl", mf.stl(s)), ("ply", mf.ply(s)), ("off", mf.off(s)))


def odd_rotations():
    """Quaternions of any length turn and do not scale."""
    s = box(1, 2, 4)
    for name, q in (("two", [0, 0, 1, 1]), ("half", [0, 0, 0.1, 0.1]), ("large", [0, 0, 3e4, 3e4])):
        parts = mf.with_nodes(mf.gltf_parts(s), {"mesh": 0, "rotation": q})
        yield row(name + ".gltf", mf.gltf(parts), "brought to length 1", s, FLOAT)
        yield row(name + ".glb", mf.glb(mf.with_nodes(mf.gltf_parts(s), {"children": [1], "rotation": q}, {"mesh": 0}, roots=[0])),
                  "brought to length 1", s, FLOAT)
    near = mf.with_nodes(mf.gltf_parts(s), {"mesh": 0, "rotation": [0, 0, 0.70710677, 0.70710677]})
    yield row("near.gltf", mf.gltf(near), "", s, FLOAT)
    for q in ([0, 0, 0, 0], [1, 2, 3], ["a", 0, 0, 1]):
        yield refused("bad.gltf", mf.gltf(mf.with_nodes(mf.gltf_parts(s), {"mesh": 0, "rotation": q})), "rotation")
    root, data = mf.with_nodes(mf.gltf_parts(s), {"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"ROTATION": 2}}}})
    at = len(data) + -len(data) % 4
    root["bufferViews"].append({"buffer": 0, "byteOffset": at, "byteLength": 16})
    root["accessors"].append({"bufferView": 2, "componentType": 5126, "count": 1, "type": "VEC4"})
    root["extensionsUsed"] = root["extensionsRequired"] = ["EXT_mesh_gpu_instancing"]
    data = data.ljust(at, b"\0") + struct.pack("<4f", 0, 0, 2, 2)
    root["buffers"][0]["byteLength"] = len(data)
    yield row("instance.glb", mf.glb((root, data)), "brought to length 1", s, FLOAT)
    flat = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2]
    yield refused("matrix.gltf", mf.gltf(mf.with_nodes(mf.gltf_parts(s), {"mesh": 0, "matrix": flat})), "matrix")


def more_of_off():
    points = "".join(mf.words(p) + "%s\n" for p in CUBE.positions)
    faces = "".join("%d %s\n" % (len(f), " ".join(map(str, f))) for f in CUBE.faces)
    for name, head, behind in (("st", "STOFF\n8 6 0\n", " 0.5 0.5"), ("c", "COFF\n8 6 12\n", " 1 0 0 1"), ("n", "NOFF\n8 6 12\n", " 0 0 1"),
                               ("cn", "CNOFF\n8 6 12\n", " 0 0 1 255 0 0 255"), ("4", "4OFF\n8 6 12\n", " 1"),
                               ("n3", "nOFF\n3\n8 6 12\n", ""), ("n4", "4nOFF 3\n8 6 12\n", " 1")):
        yield row(name + ".off", head + points.replace("%s", behind) + faces, "")
    plane = "nOFF\n2\n4 1 0\n0 0\n1 0\n1 1\n0 1\n4 0 1 2 3\n"
    yield refused("n2.off", plane, "nOFF", "2", "accepted")
    yield refused("n4.off", "nOFF\n4\n4 1 0\n" + "0 0 0 1\n" * 4 + "4 0 1 2 3\n", "nOFF", "4", "accepted")
    yield refused("b.off", b"OFF BINARY\n\0\0\0\x03\0\0\0\1\0\0\0\0", "binary OFF", "accepted")
    yield refused("b.off", b"COFF BINARY\n\0\0\0\x03\0\0\0\1\0\0\0\0", "binary OFF", "accepted")
    yield refused("b.off", b"NOFF\r\n BINARY\n\0\0\0\x03\0\0\0\1\0\0\0\0", "binary OFF", "accepted")
    yield refused("u.off", "XOFF\n8 6 0\n" + mf.off(CUBE), "XOFF", "accepted")


def pointers_beside_models():
    """Pointers of Git LFS, pages and empty files in place of what a model names."""
    for name in ("c.fbx", "c.step", "c.blend", "c.ply", "c.off", "c.x3d", "c.3ds", "c"):
        yield refused(name, LFS, "Git LFS")
    for name in ("c.fbx", "c.step", "c.3ds", "c.iges"):
        yield refused(name, "<html><head></head><body>Not Found</body></html>", "web page")
    text = mf.gltf(mf.gltf_parts(CUBE), "m.bin")
    yield refused("m.gltf", text, "m.bin", "Git LFS", others={"m.bin": LFS})
    yield refused("m.gltf", text, "m.bin", "web page", others={"m.bin": "<!DOCTYPE html><html></html>"})
    yield refused("m.gltf", text, "m.bin", others={"m.bin": b""})
    yield row("m.obj", "mtllib m.mtl\nusemtl m\n" + mf.obj(CUBE), "Git LFS", others={"m.mtl": LFS})
    yield row("m.obj", "mtllib m.mtl\nusemtl m\n" + mf.obj(CUBE), "m.mtl", others={"m.mtl/x": "a folder"})
    yield row("m.obj", "mtllib m.mtl\nusemtl m\nvt 0 0\n" + mf.obj(CUBE, corner="%d/1"), "t.png",
              others={"m.mtl": "newmtl m\nmap_Kd t.png\n", "t.png": LFS})


def more_encodings():
    for kind, text in text_formats(CUBE):
        yield row("le32." + kind, codecs.BOM_UTF32_LE + text.encode("utf-32-le"), "")
        yield row("be32." + kind, codecs.BOM_UTF32_BE + text.encode("utf-32-be"), "")
    yield row("m.obj", "mtllib m.mtl\nusemtl m\n" + mf.obj(CUBE), "", others={"m.mtl": "newmtl m\nKd 1 0 0\n".encode("utf-16")})
    yield row("latin.obj", ("# W\u00fcrfel\no W\u00fcrfel\n" + mf.obj(CUBE)).encode("latin-1"), "")
    root, data = mf.gltf_parts(CUBE)
    text = codecs.BOM_UTF8 + json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(data)) + b"BIN\0" + data
    yield row("bom.glb", b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks, "")
    for encoding in ("utf-8-sig", "utf-16"):
        yield row("p.3mf", recoded_3mf(encoding), "the unit is")


def recoded_3mf(encoding):
    files = {}
    with mf.zipfile.ZipFile(mf.io.BytesIO(mf.threemf(CUBE))) as packed:
        for name in packed.namelist():
            files[name] = packed.read(name).decode().replace("UTF-8", encoding.replace("-sig", "")).encode(encoding)
    return mf.archive(files)


def more_lines():
    blank = "\u00a0"
    yield row("vt.obj", mf.obj(CUBE, v="v\v%s", f="f\f%s"), "")
    yield refused("nbsp.obj", mf.obj(CUBE, f=blank + "f %s"), "unknown kinds", "6")
    yield row("object.ply", mf.ply(CUBE).replace("element vertex", "comment a\nobj_info b\nelement vertex"), "")
    yield row("blank.ply", mf.ply(CUBE).replace("\n4 ", "\n\n4 "), "")
    yield row("d.ply", mf.ply(CUBE).replace("0.5", "5D-1"), "")
    yield row("d.off", mf.off(CUBE).replace("0.5", "5d-1"), "")
    yield row("d.stl", mf.stl(CUBE).replace("0.5", "5D-01"), "")
    yield row("two.stl", mf.stl(CUBE, "a") + mf.stl(CUBE.moved(3, 0, 0), "b"), "", mf.joined(CUBE, CUBE.moved(3, 0, 0)))
    yield row("noend.stl", mf.stl(CUBE).replace("endsolid a\n", ""), "")
    yield row("quad.stl", "solid a\n" + "".join("facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n" % "".join(
        "vertex %s\n" % mf.words(CUBE.positions[i]) for i in f) for f in CUBE.faces) + "endsolid\n", "")
    yield row("z.stl", mf.stl(CUBE) + "\x1a\0\0", "")
    yield row("nowhere.obj", mf.obj(CUBE) + "v nan nan nan\nv inf 0 0\n", "")
    yield row("nowhere.ply", mf.ply(CUBE).replace("vertex 8", "vertex 9").replace("\n4 ", "\nnan nan nan\n4 ", 1), "")
    yield row("closed.obj", "".join("v %s\n" % mf.words(p) for p in CUBE.positions) + "".join(
        "f %s\n" % " ".join(str(i + 1) for i in (*f, f[0])) for f in CUBE.faces), "")
    yield row("repeated.obj", "".join("v %s\n" % mf.words(p) for p in CUBE.positions) + "".join(
        "f %s\n" % " ".join(str(i + 1) for i in (f[0], *f)) for f in CUBE.faces), "")
    yield row("commas.3mf", mf.threemf(CUBE, items='<item objectid="1" transform=" 1 0 0  0 1 0 0 0 1\n0 0 0 "/>'), "")
    short = mf.stl_binary(CUBE)
    yield refused("short.stl", short[:-2], "truncated")
    yield refused("short.ply", mf.ply(CUBE, "binary_little_endian")[:-1], "truncated")
    yield refused("short.off", mf.off(CUBE).rstrip("\n").rsplit("\n", 1)[0], "truncated")
    yield refused("short.glb", mf.glb(mf.gltf_parts(CUBE))[:-10], "bytes")


def ac3d(s):
    return ("AC3Db\nMATERIAL \"m\" rgb 1 1 1 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 10 trans 0\nOBJECT world\nkids 1\nOBJECT poly\n"
            "name \"a\"\n%snumvert " + "%d\n" % len(s.positions) + "".join(mf.words(p) + "\n" for p in s.positions) +
            "numsurf %d\n" % len(s.faces) + "".join("SURF 0x20\nmat 0\nrefs %d\n%s" % (len(f), "".join("%d 0 0\n" % i for i in f))
                                                    for f in s.faces) + "kids 0\n")


def direct_x(s, matrix="1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0"):
    return ("xof 0303txt 0032\nFrame a {\n FrameTransformMatrix {\n %s;;\n }\n Mesh m {\n %d;\n%s;\n %d;\n%s;\n }\n}\n" % (
        matrix, len(s.positions), ",\n".join("%s;%s;%s;" % tuple(map(mf.number, p)) for p in s.positions), len(s.faces),
        ",\n".join("%d;%s;" % (len(f), ",".join(map(str, f))) for f in s.faces)))


def lwo(s):
    def part(name, body):
        return name + struct.pack(">I", len(body)) + body + b"\0" * (len(body) % 2)
    points = b"".join(struct.pack(">3f", *p) for p in s.positions)
    faces = b"FACE" + b"".join(struct.pack(">H%dH" % len(f), len(f), *f) for f in s.faces)
    tags = b"".join(struct.pack(">2H", i, 0) for i in range(len(s.faces)))
    body = b"LWO2" + part(b"TAGS", b"m\0") + part(b"LAYR", struct.pack(">2H3f", 0, 0, 0, 0, 0) + b"\0\0") + part(b"PNTS", points) + \
        part(b"POLS", faces) + part(b"PTAG", b"SURF" + tags) + part(b"SURF", b"m\0\0\0")
    return b"FORM" + struct.pack(">I", len(body)) + body


def three_ds(s, matrix=(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0)):
    def chunk(kind, data):
        return struct.pack("<HI", kind, 6 + len(data)) + data
    mesh = chunk(0x4110, struct.pack("<H", len(s.positions)) + b"".join(struct.pack("<3f", *p) for p in s.positions)) + \
        chunk(0x4120, struct.pack("<H", len(s.triangles())) + b"".join(struct.pack("<4H", *f, 7) for f in s.triangles())) + \
        chunk(0x4160, struct.pack("<12f", *matrix))
    return chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, b"a\0" + chunk(0x4100, mesh))))


def amf(s, unit="meter"):
    return ('<?xml version="1.0"?><amf unit="%s"><object id="1"><mesh><vertices>%s</vertices><volume>%s</volume></mesh></object></amf>' % (
        unit, "".join("<vertex><coordinates><x>%s</x><y>%s</y><z>%s</z></coordinates></vertex>" % tuple(map(mf.number, p)) for p in s.positions),
        "".join("<triangle><v1>%d</v1><v2>%d</v2><v3>%d</v3></triangle>" % t for t in s.triangles())))


def other_formats():
    """What assimp reads, by the same kinds: n-gons, mirrors, parts inside out, units."""
    two = mf.joined(box(0.1, 0.2, 0.3), box(0.1, 0.1, 0.1).moved(1, 0, 0).turned())
    for name, s in (("L", PRISM), ("U", prism(mf.U).tilted().rolled(2)), ("parts", two)):
        yield row(name + ".ac", ac3d(s) % "", "", s, FLOAT)
        # The z of both points away from the viewer, and is read with the other sign.
        turned = mf.Solid(s.positions, s.faces, s.volume, s.area, [*s.centre[:2], -s.centre[2]])
        yield row(name + ".x", direct_x(s), "", turned, FLOAT)
        yield row(name + ".lwo", lwo(s), "", turned, FLOAT)
    c = box(1, 2, 4).moved(2, 0, 0)
    m = c.moved(-4, 0, 0)
    yield row("m.ac", ac3d(c) % "rot -1 0 0 0 1 0 0 0 1\n", "mirrored", m, FLOAT)
    yield row("m.x", direct_x(c, "-1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0"), "mirrored", m, FLOAT)
    yield row("parts.3ds", three_ds(two), "", two, FLOAT)
    yield row("m.3ds", three_ds(m, (-1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0)), "", m, FLOAT)
    yield row("parts.amf", amf(two), "", two, FLOAT)
    for unit, metres in (("millimeter", 0.001), ("inch", 0.0254), ("feet", 0.3048), ("meter", 1), ("micron", 1e-6)):
        yield row("u.amf", amf(CUBE, unit), "" if metres == 1 else "the unit is", metres_per_unit=metres)
    geometric = mf.fbx_property("GeometricScaling", -1, 1, 1)
    yield row("geometric.fbx", mf.fbx(c, model=geometric), "mirrored", m, FLOAT)
    both = mf.fbx_property("Lcl Scaling", -1, 1, 1) + mf.fbx_property("Lcl Rotation", 0, 0, 180)
    yield row("turned.fbx", mf.fbx(c, model=both), "mirrored", c, FLOAT)
    null = ('\tModel: 3, "Model::k", "Null" {\n\t\tVersion: 232\n\t\tProperties70:  {\n%s\t\t}\n\t}\n' % mf.fbx_property("Lcl Scaling", -1, 1, 1),
            '\tC: "OO",3,0\n\tC: "OO",2,3\n')
    yield row("null.fbx", mf.fbx(c, more_models=null).replace('C: "OO",2,0\n', ""), "mirrored", m, FLOAT)


def commas():
    """In X3D commas are blanks; numbers may follow at once."""
    for name, solid in (("half", CUBE), ("whole", box(2, 2, 2)), ("placed", CUBE.moved(1, 2, 3))):
        text = mf.x3d(solid)
        points = ", ".join(mf.words(p) for p in solid.positions)
        yield row(name + "_points.x3d", text.replace(points, ",".join(mf.words(p) for p in solid.positions)), "", solid)
        yield row(name + "_numbers.x3d", text.replace(points, ",".join(mf.words(p).replace(" ", ",") for p in solid.positions)), "", solid)
    ids = " ".join(" ".join(map(str, f)) + " -1" for f in CUBE.faces)
    yield row("ids.x3d", mf.x3d(CUBE).replace(ids, ids.replace(" ", ",")), "")
    yield row("last.x3d", mf.x3d(CUBE).replace(ids, ids[:-3]), "")


def cad_by_other_names():
    for name in ("a.obj", "a.stl", "a.glb", "a", "a.fbx"):
        yield refused(name, "ISO-10303-21;\nHEADER;\n", "CAD file")
        yield refused(name, "\nDBRep_DrawableShape\n", "CAD file")


def with_holes():
    """Polygons with holes, which are not read: refused, or told."""
    points = [(x, y, 0.0) for x, y in ((0, 0), (3, 0), (3, 3), (0, 3), (1, 1), (1, 2), (2, 2), (2, 1))]
    s = mf.Solid(points, [(0, 1, 2, 3)], 1, 9, [1.5, 1.5, 0])
    text = mf.dae(s, kind="polygons")
    at, end = text.index("<polygons"), text.index("</polygons>") + 11
    for hole in ("<h>4 5 6 7</h>", "<h>4 5 6 7</h><h>4 5 6</h>", "\n <h> 4 5 6 7 </h>\n"):
        ph = '<polygons count="1"><input semantic="VERTEX" source="#v" offset="0"/><ph><p>0 1 2 3</p>%s</ph></polygons>' % hole
        yield refused("ph.dae", text[:at] + ph + text[end:], "<h>")
    yield row("h.obj", "".join("v %s\n" % mf.words(p) for p in points) + "f 1 2 3 4\nh 5 6 7 8\n", "unknown kinds", None)


def more_parts_of_gltf():
    root, data = mf.gltf_parts(CUBE)
    root["extensionsUsed"] = ["KHR_mesh_quantization"]
    yield row("used.gltf", mf.gltf((root, data)), "")
    quantized = mf.gltf_parts(box().moved(0.5, 0.5, 0.5), "H", normalized=True)
    quantized[0].pop("extensionsRequired")
    yield row("unrequired.gltf", mf.gltf(quantized), "", box().moved(0.5, 0.5, 0.5), FLOAT)
    text = json.loads(mf.gltf(mf.gltf_parts(CUBE)))
    uri = text["buffers"][0]["uri"]
    for name, head in (("plain", "data:;base64,"), ("upper", "data:application/gltf-buffer;BASE64,"), ("charset", "data:application/octet-stream;charset=utf-8;base64,")):
        text["buffers"][0]["uri"] = head + uri.split(",")[1]
        yield row(name + ".gltf", json.dumps(text), "")
    text["buffers"][0]["uri"] = "data:application/octet-stream," + "".join("%%%02X" % b for b in data)
    yield row("percent.gltf", json.dumps(text), "")
    text["buffers"][0]["uri"] = "https://example.org/m.bin"
    yield refused("net.gltf", json.dumps(text), "https://example.org/m.bin")
    text["buffers"][0]["uri"] = "file:///etc/passwd"
    yield refused("file.gltf", json.dumps(text), "passwd")
    root, data = mf.with_nodes(mf.gltf_parts(CUBE), {"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}, roots=[0])
    yield row("other.gltf", mf.gltf((root, data)), "", CUBE)
    root, data = mf.gltf_parts(CUBE)
    root["scenes"].append({"nodes": [0]})
    yield row("scenes.gltf", mf.gltf((root, data)), "other scenes")
    root, data = mf.gltf_parts(CUBE)
    del root["scene"]
    yield row("unsaid.gltf", mf.gltf((root, data)), "")
    del root["scenes"]
    yield refused("none.gltf", mf.gltf((root, data)), "no scene")
    root, data = mf.gltf_parts(CUBE)
    root["images"] = [{"uri": "gone.png"}]
    root["textures"] = [{"source": 0}]
    root["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
    root["meshes"][0]["primitives"][0]["material"] = 0
    yield row("image.gltf", mf.gltf((root, data)), "gone")
    hidden = mf.with_nodes(mf.gltf_parts(CUBE), {"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0], "extensions": {"KHR_node_visibility": {"visible": False}}})
    hidden[0]["extensionsUsed"] = ["KHR_node_visibility"]
    yield row("hidden.gltf", mf.gltf(hidden), "hidden", None)


def more_packages():
    with mf.zipfile.ZipFile(mf.io.BytesIO(mf.threemf(CUBE))) as packed:
        model = packed.read("3D/3dmodel.model")
    def package(target, name):
        return mf.archive({"_rels/.rels": mf.RELS % mf.START.replace("/3D/3dmodel.model", target), name: model})
    for target, name in (("/3D/my%20model.model", "3D/my model.model"), ("3D/a.model", "3D/a.model"), ("/3d/3DMODEL.model", "3D/3dmodel.model"),
                         ("/3D/./a.model", "3D/a.model"), ("/3D/a.model", "3D\\a.model")):
        yield row("p.3mf", package(target, name), "the unit is")
    for unit in ("Millimeter", "MICRON", "furlong", ""):
        yield row("u.3mf", mf.threemf(CUBE, unit or None), "the unit is", metres_per_unit={"MICRON": 1e-6}.get(unit, 1e-3))
    yield refused("doc.3mf", mf.archive({"word/document.xml": "<w/>", "[Content_Types].xml": "<Types/>"}), "without a model")
    yield refused("item.3mf", mf.threemf(CUBE, items='<item objectid="7"/>'), "7")
    yield refused("own.3mf", mf.threemf(CUBE, items='<item objectid="2"/>', objects='<object id="2"><components><component objectid="2"/></components></object>'), "nested")


KINDS = [odd_rotations, more_of_off, pointers_beside_models, more_encodings, more_lines, other_formats, commas, cad_by_other_names, with_holes,
         more_parts_of_gltf, more_packages]
