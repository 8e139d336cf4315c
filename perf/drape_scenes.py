#!/usr/bin/env python3
"""Cloths and cables brought to rest: processor time, memory, certificate of each scene.

drape_scenes.py TRIVET [--prototype PROGRAM] [--only NAME,...] [--csv FILE]
  TRIVET     the program
  PROGRAM    another one that takes the names below and prints "TOTAL cpu" and "peak memory"
Prints a row for each scene. Scenes are made here, of boxes and surfaces of revolution.
"""
import argparse
import json
import math
import os
import re
import subprocess
import sys
import tempfile


class Mesh:
    def __init__(self):
        self.vertices, self.faces = [], []

    def add(self, vertices, faces):
        first = len(self.vertices)
        self.vertices += vertices
        self.faces += [[first + v for v in face] for face in faces]
        return self

    def box(self, low, high):
        corners = [[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)]
        sides = (0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)
        return self.add(corners, [f for s in sides for f in ((s[0], s[1], s[2]), (s[0], s[2], s[3]))])

    def lathe(self, profile, sides, at=(0, 0, 0), along_y=False):
        """A closed surface: the profile of (radius, height) begins and ends on the axis."""
        rings, vertices = [], []
        for radius, height in profile:
            count = sides if radius > 0 else 1
            rings.append(range(len(vertices), len(vertices) + count))
            for i in range(count):
                angle = 2 * math.pi * i / sides
                x, y, z = radius * math.cos(angle), radius * math.sin(angle), height
                vertices.append([a + b for a, b in zip((x, -z, y) if along_y else (x, y, z), at)])
        faces = []
        for low, high in zip(rings, rings[1:]):
            for i in range(sides):
                a, b = (low[k % len(low)] for k in (i, i + 1))
                d, c = (high[k % len(high)] for k in (i, i + 1))
                faces += [f for f in ((a, b, c), (a, c, d)) if len(set(f)) == 3]
        return self.add(vertices, faces)

    def write(self, path):
        with open(path, "w", encoding="utf-8") as file:
            file.writelines("v %r %r %r\n" % tuple(v) for v in self.vertices)
            file.writelines("f %d %d %d\n" % tuple(i + 1 for i in f) for f in self.faces)


PLATE = (0, 0), (0.07, 0), (0.125, 0.018), (0.125, 0.021), (0.07, 0.004), (0, 0.004)
CUP = (0, 0), (0.03, 0), (0.04, 0.02), (0.04, 0.09), (0.037, 0.09), (0.037, 0.022), (0.028, 0.004), (0, 0.004)


def table():
    mesh = Mesh().box((-0.6, -0.35, 0.69), (0.6, 0.35, 0.72))
    for i in range(4):
        x, y = (0.54, -0.54)[i & 1], (0.29, -0.29)[i >> 1]
        mesh.box((x - 0.025, y - 0.025, 1e-5), (x + 0.025, y + 0.025, 0.6899))
    return mesh


def laid():
    meshes = [table()]
    for i in range(4):
        x, y = (-0.32, 0.32)[i & 1], (-0.19, 0.19)[i >> 1]
        meshes.append(Mesh().lathe(PLATE, 64, (x, y, 0.7201)))
        meshes.append(Mesh().lathe(CUP, 48, (x + 0.19, 0.9 * y, 0.7201)))
    return meshes


def sheet(size, cell, position, **more):
    return {"size": size, "cell": cell, "position": position, **more}


def coil():
    """Five turns that lie on top of each other, and their length."""
    path = []
    for i in range(401):
        t = 10 * math.pi * i / 400
        radius = 0.12 - 0.05 * i / 400 + 0.002 * math.sin(2.3 * t)
        path.append([radius * math.cos(t), radius * math.sin(t), 0.75 + 0.0108 * t / (2 * math.pi)])
    return path


def scenes():
    """Name: meshes, the operation, arguments of the other program."""
    ball = [(0 if i in (0, 48) else 0.15 * math.sin(math.pi * i / 48), -0.15 * math.cos(math.pi * i / 48))
            for i in range(49)]
    peg = (0, -0.15), (0.012, -0.15), (0.012, 0.15), (0, 0.15)
    cloth = "--layer 0.0005 --pressure 500"
    return {
        "cable-edge": ([table()], {"path": [[-0.56, 0.1, 0.75], [1.44, 0.1, 0.75]], "cell": 2 / 256},
                       "--cells 256 --levels 4 --layer 0.0005"),
        "cable-coil": ([table()], {"path": coil(), "cell": 0.0075, "bending": 2e-6}, "--cells 400 --layer 0.0005"),
        "sphere": ([Mesh().lathe(ball, 96, (0, 0, 0.5))], sheet([0.8, 0.8], 0.8 / 24, [0, 0, 0.655]),
                   "--cells 24 --layer 0.002 --pressure 50"),
        "box": ([Mesh().box((-0.15, -0.15, 0.3), (0.15, 0.15, 0.6))], sheet([0.8, 0.8], 0.8 / 24, [0, 0, 0.605]),
                "--cells 24 --layer 0.002 --pressure 50"),
        "paper": ([Mesh().box((-0.1, -0.1, 1e-5), (0.1, 0.1, 0.05))],
                  sheet([0.297, 0.21], 0.297 / 48, [0.0885, 0.005, 0.0505], material="paper"),
                  "--cells 48 --levels 3 --layer 0.0005"),
        "peg": ([Mesh().lathe(peg, 32, (0, 0, 0.8), True)],
                sheet([1, 0.5], 1 / 64, [0.03, 0, 0.816], material="towel"), "--cells 64 --levels 3 --layer 0.0005"),
        "table": ([table()], sheet([1.6, 1.1], 1.6 / 64, [0, 0, 0.725]), "--cells 64 --levels 3 --layer 0.0005"),
        "laid": (laid(), sheet([1.6, 1.1], 1.6 / 64, [0, 0, 0.815]), "--cells 64 --levels 3 " + cloth),
        "laid-fine": (laid(), sheet([1.6, 1.1], 1.6 / 128, [0, 0, 0.815]), ""),
    }


def run(command, folder):
    """(output, seconds of processor time, megabytes)."""
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    output = process.stdout.read()
    usage = os.wait4(process.pid, 0)[2]
    return output, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def ours(program, folder, meshes, operation):
    objects = []
    for i, mesh in enumerate(meshes):
        mesh.write(os.path.join(folder, f"m{i}.obj"))
        objects.append({"name": f"m{i}", "model": f"m{i}.obj", "up": "z", "fixed": True, "position": [0, 0, 0]})
    layout = {"trivet": 1, "objects": objects, "operations": [{"op": "drape", "object": "it", **operation}]}
    with open(os.path.join(folder, "layout.json"), "w", encoding="utf-8") as file:
        json.dump(layout, file)
    output, seconds, megabytes = run(
        [program, "run", "layout.json", "-o", "scene.glb", "--report", "report.json"], folder)
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
        report = json.load(file)
    it = next((o for o in report["objects"] if o["name"] == "it" and "flexible" in o), None)
    if it is None:
        return {"cpu s": seconds, "MB": megabytes, "result": report["operations"][0].get("reason", output)}
    f = it["flexible"]
    rest = f"{f['net_force']:.1e}, {'stable' if f['stable'] else 'not stable'}"
    return {"cpu s": seconds, "MB": megabytes, "vertices": f["vertices"], "steps": f["steps"], "result": rest,
            "balance": f["balance"], "stretch": f["stretch"], "own contacts": f["own_contacts"],
            "check": report["check"]["all_at_rest"] and report["check"]["interpenetrating_pairs"] == 0}


def theirs(program, folder, name, arguments):
    output, _, megabytes = run([program, name, *arguments.split(), "--quiet"], folder)
    total = re.search(r"TOTAL cpu ([\d.]+) s, (\d+) steps, (.*)", output)
    if not total:
        return {"result": output[-200:]}
    residual = re.findall(r"residual ([\d.e+-]+)", output)[-1]
    return {"cpu s": float(total[1]), "MB": megabytes, "steps": int(total[2]), "result": f"{residual}, {total[3]}"}


COLUMNS = "scene", "program", "vertices", "steps", "cpu s", "MB", "result", "balance", "stretch", "own contacts", "check"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trivet")
    parser.add_argument("--prototype")
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", metavar="FOLDER", help="write scenes there")
    parser.add_argument("--csv")
    options = parser.parse_args()
    rows, wanted = [], [name for name in options.only.split(",") if name]
    for name, (meshes, operation, arguments) in scenes().items():
        if wanted and name not in wanted:
            continue
        with tempfile.TemporaryDirectory() as temporary:
            folder = os.path.join(options.keep, name) if options.keep else temporary
            os.makedirs(folder, exist_ok=True)
            rows.append({"scene": name, "program": "trivet",
                         **ours(os.path.abspath(options.trivet), folder, meshes, operation)})
            if options.prototype and arguments:
                rows.append({"scene": name, "program": "prototype",
                             **theirs(os.path.abspath(options.prototype), folder, name, arguments)})
        for row in rows[-2:]:
            if row["scene"] == name:
                print(*(f"{row[c]:.6g}" if isinstance(row.get(c), float) else str(row.get(c, "")) for c in COLUMNS),
                      sep="\t", flush=True)
    if options.csv:
        with open(options.csv, "w", encoding="utf-8") as file:
            print(*COLUMNS, sep=",", file=file)
            for row in rows:
                print(*(json.dumps(row[c]) if isinstance(row.get(c), str) else row.get(c, "") for c in COLUMNS),
                      sep=",", file=file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
