"""Forms of the faults that people report of readers, by kinds: functions of KINDS yield them.

A row is a form: its name, its files (the first is the model), and what `trivet info` must say. Right values are
computed from the numbers in the file (model_files.py), not by Trivet; docs/design/forms-of-files.md has the list.
"""
import codecs
import os
import struct

import model_files as mf
from model_files import box, joined, prism

CUBE = box()
TOLERANCE = 1e-9
FLOAT = 3e-7  # of what a file has in float32, or assimp reads so


def row(name, content, says, solid=CUBE, within=TOLERANCE, notes=(), others=None, **also):
    """@param says: part of a note, "" for none asked, or a list of them"""
    return {"file": name, "content": content, "others": others or {}, "solid": solid, "within": within,
            "says": [says] if isinstance(says, str) else list(says), "also": also}


def refused(name, content, *says, others=None):
    return {"file": name, "content": content, "others": others or {}, "refused": says}


def quantized():
    u = box().moved(0.5, 0.5, 0.5)
    for kind, most in (("b", 100), ("B", 200), ("h", 30000), ("H", 60000)):
        signed = kind in "bh"
        s = (box(2, 2, 2) if signed else u).scaled(most)
        node = {"mesh": 0, "scale": [1 / most] * 3}
        yield row("q_%s.gltf" % kind, mf.gltf(mf.with_nodes(mf.gltf_parts(s, kind), node)), "", (box(2, 2, 2) if signed else u), FLOAT)
        n = box(2, 2, 2) if signed else u
        yield row("n_%s.glb" % kind, mf.glb(mf.gltf_parts(n, kind, normalized=True)), "", n, FLOAT)
        yield row("strided_%s.glb" % kind, mf.glb(mf.gltf_parts(n, kind, normalized=True, strided=True)), "", n, FLOAT)
        yield row("sparse_%s.gltf" % kind, mf.gltf(mf.gltf_parts(n, kind, normalized=True, sparse=True)), "", n, FLOAT)


def mirrored():
    c = box(1, 2, 4).moved(2, 0, 0)
    flip = {"x": [-1, 1, 1], "y": [1, -1, 1], "xyz": [-1, -1, -1]}
    m = c.moved(-4, 0, 0)
    note = "mirrored"
    for name, scale in flip.items():
        want = m if "x" in name else c
        yield row("m_%s.gltf" % name, mf.gltf(mf.with_nodes(mf.gltf_parts(c), {"mesh": 0, "scale": scale})), note, want)
        yield row("d_%s.dae" % name, mf.dae(c, node="<scale>%s</scale>" % mf.words(scale)), note, want)
        yield row("x_%s.x3d" % name, mf.x3d(c, 'scale="%s"' % mf.words(scale)), note, want)
        yield row("f_%s.fbx" % name, mf.fbx(c, model=mf.fbx_property("Lcl Scaling", *scale)), note, want)
        yield row("t_%s.3mf" % name, mf.threemf(c, items='<item objectid="1" transform="%g 0 0 0 %g 0 0 0 %g 0 0 0"/>' % tuple(scale)),
                  note, want)
    yield row("matrix.gltf", mf.gltf(mf.with_nodes(mf.gltf_parts(c), {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]})), note, m)
    yield row("matrix.dae", mf.dae(c, node="<matrix>-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"), note, m)
    pair = joined(c, m)
    yield row("pair.gltf", mf.gltf(mf.with_nodes(mf.gltf_parts(c), {"mesh": 0}, {"mesh": 0, "scale": [-1, 1, 1]})), note, pair)
    yield row("pair.3mf", mf.threemf(c, items='<item objectid="2"/>', objects='<object id="2"><components><component objectid="1"/>'
                                     '<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/></components></object>'), note, pair)
    yield row("pair.dae", mf.dae(c, more='<node id="k"><scale>-1 1 1</scale><instance_geometry url="#g"/></node>'), note, pair)
    yield row("pair.fbx", mf.fbx(c, more_models=(
        '\tModel: 3, "Model::k", "Mesh" {\n\t\tVersion: 232\n\t\tProperties70:  {\n%s\t\t}\n\t}\n' % mf.fbx_property("Lcl Scaling", -1, 1, 1),
        '\tC: "OO",3,0\n\tC: "OO",1,3\n')), note, pair)
    nested = [{"children": [1], "scale": [-1, 1, 1]}, {"mesh": 0, "scale": [-1, 1, 1]}]
    yield row("nested.gltf", mf.gltf(mf.with_nodes(mf.gltf_parts(c), *nested, roots=[0])), "", c)
    instances = mf.with_nodes(mf.gltf_parts(c), {"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"SCALE": 2}}}})
    root, data = instances
    at = len(data) + -len(data) % 4
    root["bufferViews"].append({"buffer": 0, "byteOffset": at, "byteLength": 24})
    root["accessors"].append({"bufferView": len(root["bufferViews"]) - 1, "componentType": 5126, "count": 2, "type": "VEC3"})
    root["extensionsUsed"] = root["extensionsRequired"] = ["EXT_mesh_gpu_instancing"]
    data = data.ljust(at, b"\0") + struct.pack("<6f", 1, 1, 1, -1, 1, 1)
    root["buffers"][0]["byteLength"] = len(data)
    yield row("instances.glb", mf.glb((root, data)), note, pair)


def polygons():
    """Concave faces, in any plane, from any corner, either way round."""
    for name, outline in (("L", mf.L), ("U", mf.U), ("arrow", mf.ARROW), ("comb", mf.COMB)):
        for turn, s in enumerate((prism(outline), prism(outline).tilted().rolled(2), prism(outline).tilted().tilted().rolled(3))):
            stem = "%s%d" % (name, turn)
            yield row(stem + ".obj", mf.obj(s), "", s)
            yield row(stem + ".ply", mf.ply(s, "binary_little_endian"), "", s)
            yield row(stem + ".off", mf.off(s), "", s)
            yield row(stem + ".dae", mf.dae(s), "", s)
            yield row(stem + "p.dae", mf.dae(s, kind="polygons"), "", s)
            yield row(stem + ".x3d", mf.x3d(s), "", s)
            yield row(stem + ".fbx", mf.fbx(s), "", s)


def names_of_files():
    parts = lambda: mf.gltf_parts(CUBE)  # noqa: E731
    data = parts()[1]
    for uri, name in (("my%20cube.bin", "my cube.bin"), ("my cube.bin", "my cube.bin"), ("w%C3%BCrfel.bin", "w\u00fcrfel.bin"),
                      ("a%2Bb%23c.bin", "a+b#c.bin"), ("100%25.bin", "100%.bin"), ("raw%20name.bin", "raw%20name.bin"),
                      ("./sub/../b.bin", "b.bin"), ("sub/b%20c.bin", "sub/b c.bin"), ("50%.bin", "50%.bin")):
        yield row("m.gltf", mf.gltf(parts(), uri), "", others={name: data})
    yield refused("m.gltf", mf.gltf(parts(), "gone%20away.bin"), "missing", "gone")
    for name in ("sub/../m.gltf", "sub/../sub/m.gltf", "sub/./../m.gltf"):  # as the model is given
        yield refused(name, mf.gltf(parts(), "gone.bin"), '\\"gone.bin\\", which is missing')
        yield row(name, mf.gltf(parts(), "my%20cube.bin"), "", others={os.path.dirname(name) + "/my cube.bin": data})
    yield row("m.obj", "mtllib my stuff.mtl\n" + mf.obj(CUBE), "", others={"my stuff.mtl": "newmtl m\n"})
    yield row("m.obj", "mtllib w\u00fcrfel.mtl\n" + mf.obj(CUBE), "", others={"w\u00fcrfel.mtl": "newmtl m\n"})


def units():
    for unit in (1, 2.54, 100, 0.1, 30.48, 91.44, 160934.4):
        yield row("u.fbx", mf.fbx(CUBE, unit), "" if unit == 100 else "the unit is", metres_per_unit=unit / 100)
    for unit, metres in (("micron", 1e-6), ("millimeter", 1e-3), ("centimeter", 1e-2), ("inch", 0.0254), ("foot", 0.3048),
                         ("meter", 1), (None, 1e-3)):
        yield row("u.3mf", mf.threemf(CUBE, unit), "" if metres == 1 else "the unit is", metres_per_unit=metres)
    for unit, metres in (('name="centimeter" meter="0.01"', 0.01), ('name="inch" meter="0.0254"', 0.0254), ('meter="1"', 1),
                         ('name="mile" meter="1609.344"', 1609.344)):
        yield row("u.dae", mf.dae(CUBE, unit), "" if metres == 1 else "the unit is", metres_per_unit=metres)
    for unit in ("0", "-1"):
        yield refused("u.dae", mf.dae(CUBE, 'meter="%s"' % unit), "unit is not above 0")
    yield row("u.gltf", mf.gltf(mf.gltf_parts(CUBE)), "", metres_per_unit=1)


def lines():
    """Line ends, blanks, capitals and comments of text formats."""
    texts = (("obj", mf.obj(CUBE)), ("off", mf.off(CUBE)), ("ply", mf.ply(CUBE)), ("stl", mf.stl(CUBE)))
    for kind, text in texts:
        yield row("crlf." + kind, text.replace("\n", "\r\n"), "")
        yield row("tabs." + kind, text.replace(" ", "\t") if kind != "stl" else text.replace("  ", "\t\t"), "")
        yield row("trailing." + kind, text.replace("\n", "  \n"), "")
        yield row("unended." + kind, text.rstrip("\n"), "")
        if kind != "off":
            yield row("cr." + kind, text.replace("\n", "\r"), "")
        if kind != "ply":
            yield row("leading." + kind, text.replace("\n", "\n  ").rstrip(" "), "")
    yield row("first.obj", " \t" + mf.obj(CUBE, v="  v %s", f="\t f %s"), "")
    yield row("upper.stl", mf.stl(CUBE).upper(), "")
    yield row("mixed.stl", mf.stl(CUBE).title(), "")
    yield row("upper.obj", mf.obj(CUBE).upper(), "")
    yield row("side.obj", mf.obj(CUBE, f="f %s # side"), "")
    yield row("glued.obj", mf.obj(CUBE, f="f %s#side"), "")
    yield row("v.obj", mf.obj(CUBE, v="v %s # corner 7"), "")
    yield row("note.off", "# made by hand\n" + mf.off(CUBE, face="%d %s # side"), "")
    yield row("between.off", mf.off(CUBE).replace("OFF\n", "OFF\n# counts\n\n"), "")
    yield row("counts.off", mf.off(CUBE).replace("8 6 0", "8\n6\n0"), "")
    yield row("one.off", mf.off(CUBE).replace("OFF\n", "OFF "), "")
    yield row("coloured.off", mf.off(CUBE, face="%d %s 255 0 0"), "")
    yield row("coff.off", "COFF\n8 6 0\n" + "".join(mf.words(p) + " 255 0 0 255\n" for p in CUBE.positions) +
              "".join("%d %s\n" % (len(f), " ".join(map(str, f))) for f in CUBE.faces), "")


def encodings():
    for kind, text in (("obj", mf.obj(CUBE)), ("stl", mf.stl(CUBE)), ("ply", mf.ply(CUBE)), ("off", mf.off(CUBE)),
                       ("gltf", mf.gltf(mf.gltf_parts(CUBE))), ("dae", mf.dae(CUBE)), ("x3d", mf.x3d(CUBE)), ("fbx", mf.fbx(CUBE))):
        yield row("bom." + kind, codecs.BOM_UTF8 + text.encode(), "")
        plain = text.replace('encoding="utf-8"', 'encoding="utf-16"').replace('encoding="UTF-8"', 'encoding="UTF-16"')
        if kind == "gltf":
            yield refused("le.gltf", codecs.BOM_UTF16_LE + text.encode("utf-16-le"), "UTF-16")
            yield refused("be.gltf", codecs.BOM_UTF16_BE + text.encode("utf-16-be"), "UTF-16")
            continue
        yield row("le." + kind, codecs.BOM_UTF16_LE + plain.encode("utf-16-le"), "")
        yield row("be." + kind, codecs.BOM_UTF16_BE + plain.encode("utf-16-be"), "")


def missing_parts():
    for corner in ("%d/1/1", "%d/1", "%d//1", "%d/", "%d//", "%d/-9/-9", "%d/1/"):
        yield row("c.obj", mf.obj(CUBE, corner=corner), "not there" if corner not in ("%d/", "%d//") else "")
    for weight in ("0.5", "0", "-1", "1", "1e3"):
        yield row("w.obj", mf.obj(CUBE, v="v %s " + weight), "" if weight == "1" else "weights")


def materials():
    head = "mtllib m.mtl\nusemtl m\n"
    for mtl, says in (("newmtl m\nKd 1 0 0\naniso 0.5\nanisor 0.1\n", "aniso"), ("newmtl m\nKd red\nNs many\n", "Kd"),
                      ("newmtl m\nPmagic 3\nKd 0.5\n", "Pmagic"), ("Kd 1 1 1\nnewmtl m\n", "Kd"),
                      ("\ufeffnewmtl m\r\nKd 1 0 0\r\n", ""), ("newmtl m\nmap_Kd gone.png\n", "textures without coordinates")):
        yield row("m.obj", head + mf.obj(CUBE), says, others={"m.mtl": mtl})
    yield row("m.obj", "mtllib m.mtl\nusemtl m\nvt 0 0\n" + mf.obj(CUBE, corner="%d/1"), "gone.png", others={"m.mtl": "newmtl m\nmap_Kd gone.png\n"})
    yield row("m.obj", "mtllib gone.mtl\nusemtl m\n" + mf.obj(CUBE), "gone.mtl")
    yield row("m.obj", "mtllib a.mtl gone.mtl\nusemtl m\n" + mf.obj(CUBE), "gone.mtl", others={"a.mtl": "newmtl m\n"})
    yield row("m.obj", "mtllib a.mtl\nusemtl other\n" + mf.obj(CUBE), "other", others={"a.mtl": "newmtl m\n"})
    png = bytes.fromhex("89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c49444154789c63f8cfc000000301010018"
                        "dd8db00000000049454e44ae426082")
    texture = "usemtl m\nvt 0 0\nvt 1 0\nvt 0 1\n" + mf.obj(CUBE, corner="%d/1")
    for lib, name, place in (("sub/m.mtl", "t.png", "sub/t.png"), ("sub/m.mtl", "tex/t.png", "sub/tex/t.png"), ("m.mtl", "tex\\t.png", "tex/t.png"),
                             ("sub/m.mtl", "t.png", "t.png"), ("m.mtl", "C:\\work\\t.png", "t.png"), ("m.mtl", '"my t.png"', "my t.png")):
        yield row("m.obj", "mtllib %s\n" % lib + texture, "", others={lib: "newmtl m\nmap_Kd %s\n" % name, place: png}, images=1)


def bytes_of_ply():
    """The first byte of the data, and the type that it belongs to."""
    for first in (0x0A, 0x0D, 0x20, 0x00, 0x23):
        for kind in ("little", "big"):
            for type_ in ("float", "double"):
                s = mf.Solid(CUBE.positions, CUBE.faces, 1, 6, [0, 0, 0])
                data = mf.ply(s, "binary_%s_endian" % kind, type_)
                at = data.index(b"end_header\n") + 11
                size = 4 if type_ == "float" else 8
                end = at if kind == "little" else at + size - 1
                if kind == "big":
                    continue
                yield row("b.ply", data[:end] + bytes([first]) + data[end + 1:], "", s, 1e-5)
    yield row("d.ply", mf.ply(CUBE.scaled(1 / 3), "binary_big_endian"), "", CUBE.scaled(1 / 3))
    yield row("t.ply", mf.ply(CUBE, "binary_little_endian") + b"tail", "behind")


def trailing():
    for count in (1, 2, 49, 50, 512):
        yield row("t.stl", mf.stl_binary(CUBE, behind=b"\7" * count), "behind")
    yield row("solid.stl", mf.stl_binary(CUBE, head=b"solid of some program"), "")
    yield row("none.stl", mf.stl_binary(CUBE)[:80] + b"\0\0\0\0" + mf.stl_binary(CUBE)[84:], "not stated")
    parts = lambda: mf.gltf_parts(CUBE)  # noqa: E731
    yield row("tail.glb", mf.glb(parts(), behind=b"tail"), "")
    yield row("unpadded.glb", mf.glb(parts(), pad=False), "")
    yield row("tail.obj", mf.obj(CUBE) + "\x1a", "")
    yield row("tail.off", mf.off(CUBE) + "# end\n\n", "")
    yield row("tail.3mf", mf.threemf(CUBE) + b"\0" * 7, "")


def far():
    """Told, and read about an origin of the model's own; formats that assimp reads are told to have lost digits."""
    for offset in ((500000.12, 5000000.34, 100), (-3e6, 0, 7e6), (1e7, 1e7, 1e7)):
        s = box(0.1, 0.1, 0.1).moved(*offset)
        for name, content in (("s.obj", mf.obj(s)), ("s.stl", mf.stl(s)), ("s.ply", mf.ply(s)), ("b.ply", mf.ply(s, "binary_big_endian")),
                              ("s.3mf", mf.threemf(s)), ("s.off", mf.off(s))):
            yield row(name, content, "origin of its own", s, 1e-7, moved=True)
        for name, content in (("s.dae", mf.dae(s)), ("s.x3d", mf.x3d(s)), ("s.fbx", mf.fbx(s))):
            yield row(name, content, "float32", None)
        yield row("s.gltf", mf.gltf(mf.with_nodes(mf.gltf_parts(box(0.1, 0.1, 0.1)), {"mesh": 0, "translation": list(offset)})),
                  "float32" if offset[0] % 1 else "", box(0.1, 0.1, 0.1), 1e-7, moved=True)


def insides():
    big, small = box(0.1, 0.2, 0.3), box(0.1, 0.1, 0.1).moved(1, 0, 0)
    inner = box(0.05, 0.1, 0.15)
    cases = {"one": joined(big, small.turned()), "other": joined(big.turned(), small), "both": joined(big.turned(), small.turned()),
             "hollow": mf.hollow(big, inner), "cavity": mf.hollow(big, inner.turned()), "all": mf.hollow(big.turned(), inner),
             "twice": big.twice(), "back": big.twice(turned=True), "thrice": mf.Solid(big.positions, big.faces * 3, 0.006, 0.66, [0, 0, 0])}
    for name, places in (("stack", [(0, 0, 0), (0, 0, 1)]), ("row", [(0, 0, 0), (1, 0, 0), (2, 0, 0)]),
                         ("square", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])):
        cases[name] = joined(*[box().moved(*place) for place in places])
    for name, s in cases.items():
        for kind, content in (("obj", mf.obj(s)), ("off", mf.off(s)), ("ply", mf.ply(s)), ("stl", mf.stl(s)), ("3mf", mf.threemf(s)),
                              ("dae", mf.dae(s)), ("fbx", mf.fbx(s)), ("gltf", mf.gltf(mf.gltf_parts(s))), ("x3d", mf.x3d(s))):
            exact = kind in ("obj", "off", "ply", "stl", "3mf")
            yield row(name + "." + kind, content, "", s, TOLERANCE if exact else FLOAT, mass_rule="volume")


def no_models():
    pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n"
    for name in ("c.glb", "c.obj", "c.stl", "c.fbx", "c.dae", "c.gltf", "c.3mf"):
        yield refused(name, pointer, "Git LFS")
        yield refused(name, "<!DOCTYPE html>\n<html><body>404</body></html>", "web page")
        yield refused(name, '<?xml version="1.0"?>\n<Error><Code>AccessDenied</Code></Error>', "web page")
        yield refused(name, b"\x89PNG\r\n\x1a\n" + b"\0" * 100, "picture")
        yield refused(name, "%PDF-1.4\n", "picture or a page")
    yield refused("c.glb", "\ufeff\n  <HTML>", "web page")
    for name in ("c.zip", "c.obj", "c.glb", "c.stl", "c.dae"):
        yield refused(name, mf.archive({"a.obj": mf.obj(CUBE)}), "packed")
    for name in ("c.glb", "c.stl", "c.fbx"):
        yield refused(name, b"\x1f\x8b\x08\0\0\0\0\0\0\3abc", "gzip")
        yield refused(name, b"", "empty")


def extensions():
    for names in (["EXT_not_known_here"], ["KHR_future"], ["KHR_mesh_quantization", "VENDOR_a", "VENDOR_b"]):
        root, data = mf.gltf_parts(CUBE)
        root["extensionsUsed"] = root["extensionsRequired"] = names
        unknown = [n for n in names if "quantization" not in n]
        yield refused("r.gltf", mf.gltf((root, data)), *unknown)
        yield refused("r.glb", mf.glb((root, data)), *unknown)
    root, data = mf.gltf_parts(CUBE)
    root["asset"]["minVersion"] = "2.1"
    yield refused("r.gltf", mf.gltf((root, data)), "2.1")
    root, data = mf.gltf_parts(CUBE)
    root["extensionsUsed"] = ["VENDOR_a"]
    root["nodes"][0]["extensions"] = {"VENDOR_a": {"x": 1}}
    yield row("used.gltf", mf.gltf((root, data)), "VENDOR_a")


def contents():
    """Names that do not say what is in the file."""
    parts = lambda: mf.gltf_parts(CUBE)  # noqa: E731
    yield row("a.glb", mf.gltf(parts()), "")
    yield row("a.gltf", mf.glb(parts()), "")
    yield row("a.obj", mf.glb(parts()), "")
    yield row("a.stl", mf.gltf(parts()), "")
    for kind, content in (("obj", mf.obj(CUBE)), ("stl", mf.stl(CUBE)), ("stl", mf.stl_binary(CUBE)), ("ply", mf.ply(CUBE)),
                          ("3mf", mf.threemf(CUBE)), ("off", mf.off(CUBE)), ("dae", mf.dae(CUBE)), ("fbx", mf.fbx(CUBE)),
                          ("x3d", mf.x3d(CUBE))):
        for name in ("a.obj", "a.stl", "a.ply", "a.glb", "a.gltf", "a.3mf", "a.fbx", "a.dae", "a", "a.bin"):
            if not name.endswith(kind):
                yield row(name, content, "", format=kind)


def packages():
    thumbnail = mf.START + '<Relationship Id="t" Target="/Metadata/t.png" Type="http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"/>'
    first = '<Relationship Id="t" Target="/Metadata/t.png" Type="http://x/thumbnail"/>' + mf.START
    for name, content in (("t", mf.threemf(CUBE, rels=thumbnail, more=[("Metadata/t.png", b"png")])),
                          ("f", mf.threemf(CUBE, rels=first, more=[("Metadata/t.png", b"png")])),
                          ("stored", mf.threemf(CUBE, packed=mf.zipfile.ZIP_STORED)),
                          ("types", mf.threemf(CUBE, more=[("[Content_Types].xml", "<Types/>"), ("3D/_rels/3dmodel.model.rels", mf.RELS % "")])),
                          ("none", mf.threemf(CUBE, rels=""))):
        yield row(name + ".3mf", content, "the unit is")


def numbers():
    for text in ("%.17g", "+%.17g", "%.17gD0", "%.17gd+00", "%.17ge0", "%.17gE+000"):
        spelled = "".join("v %s\n" % " ".join((text % x).replace("+-", "-") for x in p) for p in CUBE.positions)
        faces = "".join("f %s\n" % " ".join(str(i + 1) for i in f) for f in CUBE.faces)
        yield row("n.obj", spelled + faces, "")
    for bad in ("nan", "inf", "-inf", "1.#QNAN", "1e999", "0,5", "x"):
        yield refused("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 %s\nf 1 2 3\n" % bad, "line 3")
        yield refused("b.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 %s\nendloop\nendfacet\n" % bad, "")
        yield refused("b.ply", mf.ply(CUBE).replace("-0.5", bad, 1), "")
        yield refused("b.off", mf.off(CUBE).replace("-0.5", bad, 1), "")


def ranges():
    yield refused("r.obj", mf.obj(CUBE) + "f 1 2 99\n", "line 15", "99")
    yield refused("r.obj", mf.obj(CUBE) + "f 1 2 0\n", "line 15", "0")
    yield refused("r.obj", mf.obj(CUBE) + "f 1 2 -99\n", "line 15", "-99")
    for bad in ("99", "-3", "4294967295"):
        yield refused("r.ply", mf.ply(CUBE).replace("4 0 2 3 1", "4 0 2 3 " + bad), "vertex")
        yield refused("r.off", mf.off(CUBE).replace("4 0 2 3 1", "4 0 2 3 " + bad), "vertex")
    root, data = mf.gltf_parts(CUBE)
    yield refused("r.gltf", mf.gltf((root, data[:-2] + b"\xff\xfe")), "65279", "of 8")


def left_out():
    """Parts that are left out are counted; parts that are not there are not made up."""
    empty = mf.dae(CUBE).replace('<instance_geometry url="#g"/>', "")
    yield refused("e.dae", empty, "no triangle")
    yield row("c.dae", mf.dae(CUBE, more='<node id="k"><node id="l"><translate>5 0 0</translate></node></node>'), "")
    head, tail = mf.dae(CUBE).split('<float_array id="a" count="24">')
    yield row("blank.dae", head + '<float_array id="a" count="24">\n  \t ' + tail, "")
    yield row("node.dae", mf.dae(CUBE, node="<matrix>  1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1  </matrix>"), "")
    root, data = mf.gltf_parts(CUBE)
    root["meshes"][0]["primitives"] += [{"attributes": {"POSITION": 0}, "mode": 0}, {"attributes": {"POSITION": 0}, "mode": 1}]
    yield row("l.gltf", mf.gltf((root, data)), ["points left out: 8", "lines left out: 4"])
    yield row("l.obj", mf.obj(CUBE) + "p 1\np 2\nl 1 2\ncurv 0 1 1 2\n", ["points left out: 2", "lines left out: 1", "curves"])
    yield row("l.off", mf.off(CUBE).replace("8 6 0", "8 8 0") + "2 0 1\n1 3\n", ["points left out: 1", "lines left out: 1"])
    yield row("l.ply", mf.ply(CUBE).replace("element face", "element edge 1\nproperty int vertex1\nproperty int vertex2\nelement face").replace(
        "\n4 0 2 3 1\n", "\n0 1\n4 0 2 3 1\n"), "lines left out: 1")


KINDS = [quantized, mirrored, polygons, names_of_files, units, lines, encodings, missing_parts, materials, bytes_of_ply, trailing, far,
         insides, no_models, extensions, contents, packages, numbers, ranges, left_out]
