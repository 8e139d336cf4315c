#!/usr/bin/env python3
"""How full containers get: PUT with one start each, and with several.

    perf/fill_rates.py --trivet build/release/apps/trivet [--tries 1,12] [--seeds 5] [--count 40] [--referee PATH/referee]
        [--out DIR]

Balls of three sizes, cubes and cans are let go over a box of 0.3 m that is open above, one after another, at places that
a seed draws; friction 0.5, the whole at rest. For each kind and number of tries a row: objects placed, beside the box,
scenes that the referee finds true as a whole, processor time (user and system) and the longest PUT by the clock.
Exit status 1 if anything lies beside the box, a scene is not true, or with several tries less than 98 % are placed.
"""
import argparse
import json
import math
import os
import random
import resource
import subprocess
import sys

EDGE, HEIGHT, WALL = 0.3, 0.4, 0.01


def write_obj(path, vertices, faces):
    with open(path, "w") as file:
        file.writelines("v %.9g %.9g %.9g\n" % tuple(v) for v in vertices)
        file.writelines("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def box(lower, upper):
    vertices = [[(lower, upper)[i >> k & 1][k] for k in range(3)] for i in range(8)]
    return vertices, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]




def bin_mesh():
    """Of one closed surface: an outer and an inner box, joined at the rim."""
    o, i = EDGE / 2 + WALL, EDGE / 2
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    rings = [[(x * r, y * r, z) for x, y in corners] for r, z in ((o, 0), (o, HEIGHT), (i, HEIGHT), (i, WALL))]
    vertices = [p for ring in rings for p in ring]
    faces = [(3, 2, 1, 0), (12, 13, 14, 15)]
    faces += [(4 * k + j, 4 * k + (j + 1) % 4, 4 * k + 4 + (j + 1) % 4, 4 * k + 4 + j) for k in range(3) for j in range(4)]
    return vertices, faces


def turned(outline, n):
    """A closed outline (radius, height) about z; radius 0 at both ends."""
    rings = [[(r * math.cos(2 * math.pi * j / n), r * math.sin(2 * math.pi * j / n), z) for j in range(n)]
             for r, z in outline[1:-1]]
    vertices = [(0, 0, outline[0][1])] + [p for ring in rings for p in ring] + [(0, 0, outline[-1][1])]
    last, top = len(vertices) - 1, 1 + n * (len(rings) - 1)
    faces = [(0, 1 + (j + 1) % n, 1 + j) for j in range(n)] + [(last, top + j, top + (j + 1) % n) for j in range(n)]
    faces += [(1 + n * k + j, 1 + n * k + (j + 1) % n, 1 + n * (k + 1) + (j + 1) % n, 1 + n * (k + 1) + j)
              for k in range(len(rings) - 1) for j in range(n)]
    return vertices, faces


def ball(radius):
    return turned([(radius * math.sin(math.pi * k / 10), -radius * math.cos(math.pi * k / 10)) for k in range(11)], 20)


KINDS = {"balls of 6 cm": ball(0.03), "balls of 7 cm": ball(0.035), "balls of 8 cm": ball(0.04),
         "cubes of 6 cm": box([-0.03] * 3, [0.03] * 3),
         "cans of 5 x 8 cm": turned([(0, -0.04), (0.025, -0.04), (0.025, 0.04), (0, 0.04)], 24)}


def random_rotation(rng):
    q = [rng.gauss(0, 1) for _ in range(4)]
    length = math.sqrt(sum(x * x for x in q))
    return [x / length for x in q]


def layout_of(count, seed, tries):
    rng = random.Random(seed)
    names = [f"o{k}" for k in range(count)]
    places = [[rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), HEIGHT + 0.1 + 0.01 * k] for k in range(count)]
    return {"trivet": 1,
            "objects": [{"name": "bin", "model": "bin.obj", "fixed": True, "position": [0, 0, 1e-5]}] +
                       [{"name": name, "model": "object.obj"} for name in names],
            "operations": [{"op": "put", "object": name, "position": at, "rotation": random_rotation(rng), "tries": tries}
                           for name, at in zip(names, places)]}


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(options, folder, seed, tries):
    layout, scene, report = (os.path.join(folder, f"{seed}-{tries}.{end}") for end in ("json", "glb", "report.json"))
    with open(layout, "w") as file:
        json.dump(layout_of(options.count, seed, tries), file)
    before = processor_seconds()
    subprocess.run([options.trivet, "run", layout, "-o", scene, "--report", report, "--threads", "1", "--quiet"],
                   check=False, stdout=subprocess.DEVNULL)
    seconds = processor_seconds() - before
    with open(report) as file:
        result = json.load(file)
    true = True
    if options.referee:
        true = subprocess.run([options.referee, report, "--layout", layout, "--scene", scene, "--mu", "0.5", "--whole"],
                              stdout=subprocess.DEVNULL, check=False).returncode == 0
    return result, seconds, true


def row(options, kind, mesh, tries):
    folder = os.path.join(options.out, kind.replace(" ", "_"))
    os.makedirs(folder, exist_ok=True)
    write_obj(os.path.join(folder, "bin.obj"), *bin_mesh())
    write_obj(os.path.join(folder, "object.obj"), *mesh)
    placed = beside = num_true = 0
    seconds = longest = 0.0
    most = 1
    for seed in range(options.seeds):
        result, used, true = run(options, folder, seed, tries)
        centres = [o["centre_of_mass"] for o in result["objects"] if o["name"] != "bin" and o["state"] != "unplaced"]
        placed += len(centres)
        beside += sum(max(abs(c[0]), abs(c[1])) > EDGE / 2 for c in centres)
        most = max([most] + [o.get("try", 1) for o in result["operations"]])
        longest = max([longest] + [o["milliseconds"] for o in result["operations"]])
        seconds += used
        num_true += true
    total = options.count * options.seeds
    print(f"| {kind} | {tries} | {placed} of {total} | {beside} | {num_true} of {options.seeds} | {seconds:.1f} | "
          f"{longest:.0f} | {most} |", flush=True)
    return beside == 0 and num_true == options.seeds and (tries == 1 or placed >= 0.98 * total)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trivet", required=True)
    parser.add_argument("--referee")
    parser.add_argument("--tries", default="1,12", help="numbers of tries, comma-separated")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--kinds", default="", help="part of a kind's name")
    parser.add_argument("--out", default="out/fill")
    options = parser.parse_args()
    print("| kind | tries | placed | beside | true | processor s | longest PUT, ms | latest start |\n" + "|---" * 8 + "|")
    good = [row(options, kind, mesh, int(tries)) for kind, mesh in KINDS.items() if options.kinds in kind
            for tries in options.tries.split(",")]
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
