"""Solids of known volume, area and centre, and their files in many formats."""
import base64
import io
import json
import struct
import zipfile

NAN = float("nan")


class Solid:
    """Polygons with positions; `volume`, `area` and `centre` come from numbers, not from triangles."""

    def __init__(self, positions, faces, volume, area, centre):
        self.positions, self.faces = list(positions), list(faces)
        self.volume, self.area, self.centre = volume, area, centre

    def moved(self, *by):
        return Solid([tuple(a + b for a, b in zip(p, by)) for p in self.positions], self.faces, self.volume,
                     self.area, [a + b for a, b in zip(self.centre, by)])

    def turned(self):
        """Inside out."""
        return Solid(self.positions, [tuple(reversed(f)) for f in self.faces], self.volume, self.area, self.centre)

    def rolled(self, by):
        """Each face begins at another corner."""
        return Solid(self.positions, [f[by % len(f):] + f[:by % len(f)] for f in self.faces], self.volume, self.area,
                     self.centre)

    def tilted(self):
        """Its axes x, y, z become y, z, x."""
        return Solid([(z, x, y) for x, y, z in self.positions], self.faces, self.volume, self.area,
                     [self.centre[2], self.centre[0], self.centre[1]])

    def scaled(self, s):
        return Solid([tuple(s * x for x in p) for p in self.positions], self.faces, self.volume * s ** 3,
                     self.area * s ** 2, [s * x for x in self.centre])

    def twice(self, turned=False):
        again = [tuple(reversed(f)) if turned else f for f in self.faces]
        return Solid(self.positions, self.faces + again, self.volume, 2 * self.area, self.centre)

    def triangles(self):
        """Fans: right for convex faces only."""
        return [(f[0], f[i], f[i + 1]) for f in self.faces for i in range(1, len(f) - 1)]


def joined(*solids):
    """Solids apart from each other as one."""
    positions, faces = [], []
    for s in solids:
        faces += [tuple(i + len(positions) for i in f) for f in s.faces]
        positions += s.positions
    volume = sum(s.volume for s in solids)
    return Solid(positions, faces, volume, sum(s.area for s in solids),
                 [sum(s.volume * s.centre[k] for s in solids) / volume for k in range(3)])


def hollow(outer, inner):
    """A solid with a cavity, however the two are wound."""
    out = joined(outer, inner)
    out.volume = outer.volume - inner.volume
    out.centre = [(outer.volume * outer.centre[k] - inner.volume * inner.centre[k]) / out.volume for k in range(3)]
    return out


def box(x=1.0, y=1.0, z=1.0):
    """A box of these sizes, about the origin."""
    p = [(a * x / 2, b * y / 2, c * z / 2) for c in (-1, 1) for b in (-1, 1) for a in (-1, 1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return Solid(p, faces, x * y * z, 2 * (x * y + y * z + z * x), [0.0, 0.0, 0.0])


def prism(outline, height=1.0):
    """Over a polygon in the plane that runs counter-clockwise."""
    n = len(outline)
    positions = [(x, y, z) for z in (0.0, height) for x, y in outline]
    faces = [tuple(reversed(range(n))), tuple(range(n, 2 * n))]
    faces += [(i, (i + 1) % n, (i + 1) % n + n, i + n) for i in range(n)]
    cross = [outline[i - 1][0] * outline[i][1] - outline[i][0] * outline[i - 1][1] for i in range(n)]
    area = sum(cross) / 2
    middle = [sum((outline[i - 1][k] + outline[i][k]) * cross[i] for i in range(n)) / (6 * area) for k in (0, 1)]
    around = sum(((outline[i][0] - outline[i - 1][0]) ** 2 + (outline[i][1] - outline[i - 1][1]) ** 2) ** 0.5
                 for i in range(n))
    return Solid(positions, faces, area * height, 2 * area + around * height, [*middle, height / 2])


L = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
U = [(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]
ARROW = [(0, 0), (2, 0.5), (0, 1), (0.5, 0.5)]
COMB = [(0, 0), (7, 0), (7, 3), (6, 3), (6, 1), (5, 1), (5, 3), (4, 3), (4, 1), (3, 1), (3, 3), (2, 3), (2, 1), (1, 1),
        (1, 3), (0, 3)]


def archive(files):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as packed:
        for name, content in files.items():
            packed.writestr(name, content)
    return out.getvalue()


def number(x):
    return "%.17g" % x


def words(numbers):
    return " ".join(map(number, numbers))


def obj(s, v="v %s", f="f %s", corner="%d"):
    return "".join(v % words(p) + "\n" for p in s.positions) + "".join(
        f % " ".join(corner.replace("%d", str(i + 1)) for i in face) + "\n" for face in s.faces)


def off(s, head="OFF", face="%d %s"):
    return "%s\n%d %d 0\n" % (head, len(s.positions), len(s.faces)) + "".join(
        words(p) + "\n" for p in s.positions) + "".join(
            face % (len(f), " ".join(map(str, f))) + "\n" for f in s.faces)


def ply(s, kind="ascii", type_="double"):
    head = "ply\nformat %s 1.0\nelement vertex %d\n%selement face %d\nproperty list uchar int vertex_indices\nend_header\n" % (
        kind, len(s.positions), "".join("property %s %s\n" % (type_, c) for c in "xyz"), len(s.faces))
    if kind == "ascii":
        return head + "".join(words(p) + "\n" for p in s.positions) + "".join(
            "%d %s\n" % (len(f), " ".join(map(str, f))) for f in s.faces)
    order = "<" if "little" in kind else ">"
    form = order + ("3d" if type_ == "double" else "3f")
    return head.encode() + b"".join(struct.pack(form, *p) for p in s.positions) + b"".join(
        struct.pack(order + "B%di" % len(f), len(f), *f) for f in s.faces)


def stl(s, name="a"):
    return "solid %s\n" % name + "".join(
        "facet normal 0 0 0\n outer loop\n%s endloop\nendfacet\n" % "".join(
            "  vertex %s\n" % words(s.positions[i]) for i in t) for t in s.triangles()) + "endsolid %s\n" % name


def stl_binary(s, head=b"", behind=b""):
    return head.ljust(80, b" ") + struct.pack("<I", len(s.triangles())) + b"".join(
        struct.pack("<12f", 0, 0, 0, *sum((s.positions[i] for i in t), ())) + b"\0\0" for t in s.triangles()) + behind


def dae(s, unit='name="meter" meter="1"', node="", up="Y_UP", kind="polylist", more=""):
    """Collada; `node` is a transform of the only node."""
    if kind == "polylist":
        faces = '<polylist count="%d"><input semantic="VERTEX" source="#v" offset="0"/><vcount>%s</vcount><p>%s</p></polylist>' % (
            len(s.faces), " ".join(str(len(f)) for f in s.faces), " ".join(str(i) for f in s.faces for i in f))
    elif kind == "polygons":
        faces = '<polygons count="%d"><input semantic="VERTEX" source="#v" offset="0"/>%s</polygons>' % (
            len(s.faces), "".join("<p>%s</p>" % " ".join(map(str, f)) for f in s.faces))
    else:
        faces = '<triangles count="%d"><input semantic="VERTEX" source="#v" offset="0"/><p>%s</p></triangles>' % (
            len(s.triangles()), " ".join(str(i) for f in s.triangles() for i in f))
    return ('<?xml version="1.0" encoding="utf-8"?>\n<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
            "<asset><created>2026-01-01T00:00:00</created><modified>2026-01-01T00:00:00</modified><unit %s/><up_axis>%s</up_axis></asset>"
            '<library_geometries><geometry id="g" name="g"><mesh><source id="p"><float_array id="a" count="%d">%s</float_array>'
            '<technique_common><accessor source="#a" count="%d" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>'
            '<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>'
            "</vertices>%s</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">"
            '<node id="n">%s<instance_geometry url="#g"/></node>%s</visual_scene></library_visual_scenes>'
            '<scene><instance_visual_scene url="#s"/></scene></COLLADA>\n') % (
                unit, up, 3 * len(s.positions), " ".join(words(p) for p in s.positions), len(s.positions), faces, node, more)


def x3d(s, transform=""):
    return ('<?xml version="1.0" encoding="UTF-8"?>\n<X3D profile="Interchange" version="3.0"><Scene><Transform %s><Shape>'
            '<IndexedFaceSet solid="true" convex="false" coordIndex="%s"><Coordinate point="%s"/></IndexedFaceSet></Shape></Transform>'
            "</Scene></X3D>\n") % (transform, " ".join(" ".join(map(str, f)) + " -1" for f in s.faces),
                                   ", ".join(words(p) for p in s.positions))


def fbx(s, unit=100, up=2, model="", more_models=""):
    """FBX as text; `model` are properties of its node."""
    ends = [i if k + 1 < len(f) else -i - 1 for f in s.faces for k, i in enumerate(f)]
    return ("; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7400\n}\nGlobalSettings:  {\n"
            "\tVersion: 1000\n\tProperties70:  {\n\t\tP: \"UpAxis\", \"int\", \"Integer\", \"\",%d\n\t\tP: \"UpAxisSign\", \"int\", \"Integer\", \"\",1\n"
            "\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\",%s\n\t}\n}\nObjects:  {\n\tGeometry: 1, \"Geometry::g\", \"Mesh\" {\n"
            "\t\tVertices: *%d {\n\t\t\ta: %s\n\t\t}\n\t\tPolygonVertexIndex: *%d {\n\t\t\ta: %s\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n"
            "\tModel: 2, \"Model::m\", \"Mesh\" {\n\t\tVersion: 232\n\t\tProperties70:  {\n%s\t\t}\n\t}\n%s}\nConnections:  {\n\tC: \"OO\",2,0\n\tC: \"OO\",1,2\n%s}\n") % (
                up, number(unit), 3 * len(s.positions), ",".join(number(x) for p in s.positions for x in p), len(ends),
                ",".join(map(str, ends)), model, *(more_models or ("", "")))


def fbx_property(name, *numbers):
    kind = '"%s", ""' % name if name.startswith("Lcl") else '"Vector3D", "Vector"'
    return '\t\t\tP: "%s", %s, "A",%s\n' % (name, kind, ",".join(map(number, numbers)))


RELS = '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">%s</Relationships>'
START = '<Relationship Id="r" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>'


def threemf(s, unit="millimeter", items='<item objectid="1"/>', objects="", rels=START, more=(), packed=zipfile.ZIP_DEFLATED):
    mesh = '<object id="1" type="model"><mesh><vertices>%s</vertices><triangles>%s</triangles></mesh></object>' % (
        "".join('<vertex x="%s" y="%s" z="%s"/>' % tuple(map(number, p)) for p in s.positions),
        "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % t for t in s.triangles()))
    model = ('<?xml version="1.0" encoding="UTF-8"?><model %s xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
             "<resources>%s%s</resources><build>%s</build></model>") % ('unit="%s"' % unit if unit else "", mesh, objects, items)
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", packed) as archive:
        archive.writestr("_rels/.rels", RELS % rels)
        archive.writestr("3D/3dmodel.model", model)
        for name, content in more:
            archive.writestr(name, content)
    return out.getvalue()


# Components of glTF, and what one step is if they are normalized.
KINDS = {"b": (5120, 127), "B": (5121, 255), "h": (5122, 32767), "H": (5123, 65535), "I": (5125, 0), "f": (5126, 0)}


def gltf_parts(s, kind="f", normalized=False, sparse=False, strided=False, ids="H"):
    """JSON and bytes of one mesh without nodes; integers stand for positions of -1 to 1 (signed), or 0 to 1."""
    component, most = KINDS[kind]
    scale = most if normalized else 1
    flat = [x * scale if kind == "f" else round(x * scale) for p in s.positions for x in p]
    size = 3 * struct.calcsize(kind)
    stride = (size + 3) // 4 * 4 + (8 if strided else 0)
    rows = b"".join(struct.pack("<3" + kind, *flat[i:i + 3]).ljust(stride, b"\x7f") for i in range(0, len(flat), 3))
    triangles = [i for t in s.triangles() for i in t]
    tail = struct.pack("<%d%s" % (len(triangles), ids), *triangles)
    views = [{"buffer": 0, "byteLength": len(rows), "byteStride": stride}, {"buffer": 0, "byteOffset": len(rows), "byteLength": len(tail)}]
    position = {"bufferView": 0, "componentType": component, "count": len(s.positions), "type": "VEC3",
                "min": [min(flat[k::3]) for k in range(3)], "max": [max(flat[k::3]) for k in range(3)]}
    data = rows + tail
    if normalized:
        position["normalized"] = True
    if sparse:
        count, at = len(s.positions), (len(data) + 3) // 4 * 4
        data = data.ljust(at, b"\0") + b"".join(struct.pack("<I", i) for i in range(count))
        packed = b"".join(struct.pack("<3" + kind, *flat[i:i + 3]) for i in range(0, len(flat), 3))
        views += [{"buffer": 0, "byteOffset": at, "byteLength": 4 * count}, {"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)}]
        data += packed
        del position["bufferView"]
        position["sparse"] = {"count": count, "indices": {"bufferView": 2, "componentType": 5125}, "values": {"bufferView": 3}}
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [position, {"bufferView": 1, "componentType": KINDS[ids][0], "count": len(triangles), "type": "SCALAR"}],
            "bufferViews": views, "buffers": [{"byteLength": len(data)}]}
    if kind != "f":
        root["extensionsUsed"] = root["extensionsRequired"] = ["KHR_mesh_quantization"]
    return root, data


def with_nodes(parts, *nodes, roots=None):
    root, data = parts
    root["nodes"] = list(nodes)
    root["scenes"] = [{"nodes": roots or list(range(len(nodes)))}]
    return root, data


def gltf(parts, uri=None):
    """Text; the buffer is within it, or in a file of this name."""
    root, data = parts
    root["buffers"][0]["uri"] = uri or "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps(root)


def glb(parts, pad=True, behind=b"", length=None):
    root, data = parts
    text = json.dumps(root).encode()
    if pad:
        text += b" " * (-len(text) % 4)
        data += b"\0" * (-len(data) % 4)
    size = 28 + len(text) + len(data)
    return (b"glTF" + struct.pack("<II", 2, length if length is not None else size) + struct.pack("<I", len(text)) + b"JSON" + text +
            struct.pack("<I", len(data)) + b"BIN\0" + data + behind)
