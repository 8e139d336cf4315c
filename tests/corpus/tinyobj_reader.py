"""Models as tinyobjloader reads them: tinyobj_reader.py < PATHS. A line of JSON for each path: triangles, area, volume and box, or the error."""
import json
import sys

import tinyobjloader
from reader import Surface


def read(path):
    config, reader = tinyobjloader.ObjReaderConfig(), tinyobjloader.ObjReader()
    config.triangulate = False
    if not reader.ParseFromFile(path, config):
        raise ValueError(reader.Error().strip() or "refused")
    flat, surface = reader.GetAttrib().vertices, Surface()
    for shape in reader.GetShapes():
        ids, at = [i.vertex_index for i in shape.mesh.indices], 0
        for count in shape.mesh.num_face_vertices:
            surface.add([flat[3 * i:3 * i + 3] for i in ids[at:at + count]])
            at += count
    return surface


def main():
    for path in sys.stdin.read().splitlines():
        try:
            s = read(path)
            found = {"triangles": s.triangles, "area": s.area, "volume": s.volume, "bent": s.bent, "lower": s.lower, "upper": s.upper}
        except Exception as error:  # of a reader that trusts its files
            found = {"error": str(error)}
        print(json.dumps({"reader": "tinyobjloader", "file": path, **found}), flush=True)


if __name__ == "__main__":
    main()
