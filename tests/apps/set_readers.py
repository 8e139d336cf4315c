"""Readers of data sets, written anew from what bop_toolkit and pycocotools read, with Python's own library only."""
import json
import os
import re
import struct

from label_files import decoded_mask, read_png


def int_keys(pairs):
    return {int(k) if k.lstrip("-").isdigit() else k: v for k, v in pairs}


class BopSet:
    """A BOP set as bop_toolkit's dataset_params and inout find it."""

    def __init__(self, folder, split="train_pbr"):
        self.folder, self.split = folder, os.path.join(folder, split)
        self.models_info = self.json("models/models_info.json")
        self.camera = self.json("camera.json")

    def json(self, *parts):
        with open(os.path.join(self.folder, *parts), encoding="utf-8") as file:
            return json.load(file, object_pairs_hook=int_keys)

    def bytes(self, *parts):
        with open(os.path.join(self.split, *parts), "rb") as file:
            return file.read()

    def scene_ids(self):
        return sorted(int(name) for name in os.listdir(self.split) if name.isdigit())

    def scene(self, scene_id):
        """(scene_camera, scene_gt, scene_gt_info)"""
        folder = os.path.join(os.path.basename(self.split), "%06d" % scene_id)
        return [self.json(folder, name + ".json") for name in ("scene_camera", "scene_gt", "scene_gt_info")]

    def image(self, scene_id, kind, im_id, gt_id=None):
        name = "%06d" % im_id + ("" if gt_id is None else "_%06d" % gt_id) + ".png"
        return read_png(self.bytes("%06d" % scene_id, kind, name))

    def model(self, obj_id):
        with open(os.path.join(self.folder, "models", "obj_%06d.ply" % obj_id), "rb") as file:
            return load_ply(file)


def load_ply(file):
    """Points, normals, colours or texture coordinates, faces; of the types that the toolkit knows."""
    types = {"float": "f", "double": "d", "int": "i", "uchar": "B"}
    model, section, point, face = {}, None, [], []
    while (line := file.readline().decode().rstrip("\r\n")) != "end_header":
        words = line.split()
        if line.startswith("comment TextureFile"):
            model["texture_file"] = words[-1]
        elif words[0] == "element":
            section = words[1]
            model["num_" + section] = int(words[2])
        elif words[:2] == ["property", "list"]:
            assert words[-1] in ("vertex_indices", "vertex_index")
            face = [types[words[2]]] + 3 * [types[words[3]]]
        elif words[0] == "property":
            point.append((words[2], types[words[1]]))
        elif words[0] == "format":
            assert words[1] == "binary_little_endian"
    rows = struct.Struct("<" + "".join(t for _, t in point))
    values = [rows.unpack(file.read(rows.size)) for _ in range(model["num_vertex"])]
    for i, (name, _) in enumerate(point):
        model[name] = [row[i] for row in values]
    corners = struct.Struct("<" + "".join(face))
    model["faces"] = [corners.unpack(file.read(corners.size)) for _ in range(model["num_face"])]
    assert all(f[0] == 3 for f in model["faces"]) and file.read() == b""
    model["faces"] = [f[1:] for f in model["faces"]]
    model["pts"] = list(zip(model["x"], model["y"], model["z"]))
    return model


def calc_2d_bbox(pixels):
    """Box of (x, y): as bop_toolkit's, whose width is the last minus the first."""
    xs, ys = [p[0] for p in pixels], [p[1] for p in pixels]
    return [min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)] if xs else [-1, -1, -1, -1]


def pixels_of(image):
    """(x, y) of all that are not 0."""
    return [(i % image[0], i // image[0]) for i, v in enumerate(image[3]) if v]


def projected(k, r, t, points):
    """As the toolkit's project_pts(); the depths, too."""
    out = []
    for p in points:
        q = [sum(r[3 * row + c] * p[c] for c in range(3)) + t[row] for row in range(3)]
        out.append((k[0] * q[0] / q[2] + k[2], k[4] * q[1] / q[2] + k[5], q[2]))
    return out


def silhouette(corners, faces, width, height):
    """Pixels whose centre some projected triangle covers; a ray through each centre."""
    out = set()
    for face in faces:
        (ax, ay, _), (bx, by, _), (cx, cy, _) = (corners[v] for v in face)
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area == 0:
            continue
        for y in range(max(0, int(min(ay, by, cy))), min(height - 1, int(max(ay, by, cy)) + 1) + 1):
            for x in range(max(0, int(min(ax, bx, cx))), min(width - 1, int(max(ax, bx, cx)) + 1) + 1):
                u = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area
                v = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area
                if u >= 0 and v >= 0 and u + v <= 1:
                    out.add((x, y))
    return out


class CocoSet:
    """annotations.json as pycocotools' COCO indexes it."""

    def __init__(self, folder):
        self.folder = folder
        with open(os.path.join(folder, "annotations.json"), encoding="utf-8") as file:
            data = json.load(file)
        self.cats = {c["id"]: c for c in data["categories"]}
        self.imgs = {i["id"]: i for i in data["images"]}
        self.anns = {a["id"]: a for a in data["annotations"]}
        assert len(self.imgs) == len(data["images"]) and len(self.anns) == len(data["annotations"])
        self.of_image = {i: [] for i in self.imgs}
        for annotation in data["annotations"]:
            self.of_image[annotation["image_id"]].append(annotation)

    def picture(self, image):
        with open(os.path.join(self.folder, "images", image["file_name"]), "rb") as file:
            return read_png(file.read())

    def mask(self, annotation):
        return decoded_mask(annotation["segmentation"])


def group_of(name):
    return re.sub(r"_\d+$", "", name)
