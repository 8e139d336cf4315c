#!/usr/bin/env python3
"""The cloths of drape_scenes.py by Trivet and by Blender's cloth, in one run.

drape_blender.py TRIVET [--only NAME,...] [--frames N]
  TRIVET    the program
  --frames  that Blender computes, 24 a second; default: 120
Needs blender. Prints a row for each: processor time, pairs of faces that cross, motion that is left.
"""
import argparse
import json
import math
import os
import re
import subprocess
import sys
import tempfile

import drape_scenes

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = "peg", "table", "laid"
THICKNESS = {"peg": 0.002}  # others: Blender's least that holds, 1 mm


def by_blender(folder, frames, name, meshes, operation):
    paths = []
    for i, mesh in enumerate(meshes):
        paths.append(os.path.join(folder, f"b{i}.obj"))
        mesh.write(paths[-1])
    cells = [4 * math.ceil(round(length / operation["cell"], 6) / 4) for length in operation["size"]]
    numbers = [frames, *cells, *operation["size"], *operation["position"], THICKNESS.get(name, 0.001)]
    done = subprocess.run(["blender", "-b", "--factory-startup", "-P", os.path.join(HERE, "blender", "cloth.py"), "--",
                           *map(str, numbers), *paths], capture_output=True, text=True, check=False)
    found = re.search(r"^RESULT (.*)", done.stdout, re.MULTILINE)
    return json.loads(found[1]) if found else {"failed": (done.stderr or done.stdout)[-300:]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trivet")
    parser.add_argument("--only", default=",".join(SCENES))
    parser.add_argument("--frames", type=int, default=120)
    options = parser.parse_args()
    for name in options.only.split(","):
        meshes, operation, _ = drape_scenes.scenes()[name]
        with tempfile.TemporaryDirectory() as folder:
            ours = drape_scenes.ours(os.path.abspath(options.trivet), folder, meshes, operation)
            print(name, "trivet", f"{ours['cpu s']:.1f} s", ours["result"], f"check {ours.get('check')}", sep="\t", flush=True)
            print(name, "blender", json.dumps(by_blender(folder, options.frames, name, meshes, operation)), sep="\t",
                  flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
