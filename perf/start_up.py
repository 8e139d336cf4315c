#!/usr/bin/env python3
"""Measures `trivet put` of a cube by backend, start-up included: CPU and wall milliseconds, runs in turn.

Usage: start_up.py RUNS PROGRAM...        such as: start_up.py 25 build/before/apps/trivet build/release/apps/trivet
"""
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

CUBE = "".join("v %g %g %g\n" % (x, y, z) for x in (-.05, .05) for y in (-.05, .05) for z in (-.05, .05)) + \
    "".join("f %d %d %d %d\n" % f for f in ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)))
LAYOUT = {"trivet": 1, "floor": True, "objects": [{"name": "a", "model": "cube.obj"}],
          "operations": [{"op": "put", "object": "a", "position": [0, 0, 1], "rotation": [1, 0, 0, 0]}]}


def run(*command):
    """CPU milliseconds of the program and its children, and wall milliseconds."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(command, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return 1e3 * cpu, 1e3 * (time.monotonic() - start)


def main():
    runs, programs = int(sys.argv[1]), [os.path.abspath(program) for program in sys.argv[2:]]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        os.environ["XDG_CACHE_HOME"] = folder
        with open("cube.obj", "w") as file:
            file.write(CUBE)
        with open("layout.json", "w") as file:
            json.dump(LAYOUT, file)
        run(programs[0], "run", "layout.json", "-o", "scene.glb")
        found = {}
        for _ in range(runs):
            for program in programs:
                for backend in ("auto", "bvh"):
                    found.setdefault((program, backend), []).append(run(
                        program, "put", "scene.glb", "cube.obj", "--position", "0.5", "0", "1", "-o",
                        "out.glb", "--detector", backend))
        for (program, backend), times in found.items():
            cpu, wall = (sorted(column) for column in zip(*times))
            print("%s --detector %s: CPU least %.1f median %.1f, wall least %.1f median %.1f ms"
                  % (program, backend, cpu[0], cpu[runs // 2], wall[0], wall[runs // 2]))


if __name__ == "__main__":
    main()
