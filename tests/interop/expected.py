"""Expected content of a scene, from its report and glTF, for the checks of readers."""
import json
import struct
from pathlib import Path


def document(path):
    """The JSON of a .glb or .gltf."""
    data = Path(path).read_bytes()
    if data[:4] == b"glTF":
        return json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])
    return json.loads(data)


def below(root, node):
    """Ids of a node and all nodes below it."""
    yield node
    for child in root["nodes"][node].get("children", []):
        yield from below(root, child)


def expected(scene, report):
    """For each object: name, world_from_file (16 numbers, rows), material names, pivot or None."""
    root, out = document(scene), []
    world = {o["name"]: o["world_from_file"] for o in json.loads(Path(report).read_text())["objects"]
             if "world_from_file" in o}
    for node in root["scenes"][0]["nodes"]:
        materials, counts = set(), {"nodes": 0, "cameras": 0, "lights": 0}
        for id in below(root, node):
            n = root["nodes"][id]
            counts["nodes"] += 1
            counts["cameras"] += "camera" in n
            counts["lights"] += "KHR_lights_punctual" in n.get("extensions", {})
            if "mesh" in n:
                for p in root["meshes"][n["mesh"]]["primitives"]:
                    if "material" in p:
                        materials.add(root["materials"][p["material"]].get("name", ""))
        n = root["nodes"][node]
        children = [root["nodes"][c] for c in n.get("children", [])]
        pivot = children[0]["translation"] if len(children) == 1 and children[0].get("name") == "pivot" else [0, 0, 0]
        out.append({"name": n["name"], "world": world[n["name"]], "materials": sorted(materials),
                    "pivot": pivot, **counts})
    return out


if __name__ == "__main__":
    import sys
    print(json.dumps(expected(sys.argv[1], sys.argv[2])))
