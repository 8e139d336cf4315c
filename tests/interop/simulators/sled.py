#!/usr/bin/env python3
"""A sled that stands on the edges of two runners, whose tips rise gently: sled.py FOLDER

Writes sled.obj and layout.json. MuJoCo finds one contact of such an edge (ridge.mjs).
"""
import json
import sys
from pathlib import Path

# A runner along x: its edge on the floor, the tips at both ends, the upper side. Metres.
CORNERS = [(-0.2, 0, 0), (0.2, 0, 0), (-0.25, -0.01, 0.002), (-0.25, 0.01, 0.002), (0.25, -0.01, 0.002),
           (0.25, 0.01, 0.002), (-0.25, -0.02, 0.02), (-0.25, 0.02, 0.02), (0.25, -0.02, 0.02), (0.25, 0.02, 0.02)]
FACES = [(1, 4, 2, 0), (3, 5, 1, 0), (5, 4, 1), (2, 3, 0), (4, 8, 6, 2), (7, 9, 5, 3), (5, 9, 8, 4), (6, 7, 3, 2), (8, 9, 7, 6)]


def sled_obj():
    lines = []
    for side in (-0.1, 0.1):
        first = sum(line.startswith("v") for line in lines) + 1
        lines += ["v %g %g %g" % (x, y + side, z) for x, y, z in CORNERS]
        lines += ["f " + " ".join(str(first + corner) for corner in face) for face in FACES]
    return "\n".join(lines) + "\n"


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "sled.obj").write_text(sled_obj())
    layout = {"trivet": 1, "objects": [{"name": "sled", "model": "sled.obj"}],
              "operations": [{"op": "put", "object": "sled", "position": [0, 0, 0.1]}]}
    (folder / "layout.json").write_text(json.dumps(layout))


if __name__ == "__main__":
    main()
