#!/usr/bin/env python3
"""Computer-aided layout, measured: seeds of the demos, and growth with the number of things. Markdown.

    perf/arrange.py TRIVET demos [--seeds 20] [--only NAME ...]
    perf/arrange.py TRIVET growth [--things 20 50 100 200]
    perf/arrange.py TRIVET beside [--things 4 6 8 10 12] [--seeds 10]

Processor time is of the whole program in one thread, reading models and checking the scene included; the share of
PUT is of the solver's wall time. A scene counts as true when `trivet arrange` ends with 0: all hard relations hold,
the exact check finds nothing crossing, and it stands as a whole.

`beside` lays crockery of `trivet demo table-for-six` on a board of 0.7 x 0.7 m, every second thing by relations to the one
before it, once by `trivet arrange` and once by a baseline, boxes and rejection (boxes_and_rejection.py), 2 mm over the
board. The baseline's time is of the tries alone; the models' boxes are known. Relations are judged again by outlines of
the meshes where they stand. Drift is MuJoCo's: 5 s of `trivet export --simulate`.
"""
import argparse
import itertools
import json
import math
import os
import statistics
import struct
import subprocess
import tempfile
import time

from boxes_and_rejection import by_rejection, holds, placed

DEMOS = ["table-for-six", "tight-table", "bookcase", "market", "office3", "workshop"]


def arrange(trivet, problem, seed, folder):
    """Status, processor seconds, megabytes at most and the report's section of one run."""
    report = os.path.join(folder, "report.json")
    if os.path.exists(report):  # of the seed before
        os.remove(report)
    process = subprocess.Popen([trivet, "arrange", problem, "--seed", str(seed), "--threads", "1", "--quiet",
                                "-o", os.path.join(folder, "scene.glb"), "--report", report],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = status
    if not os.path.exists(report):
        raise SystemExit("trivet arrange %s --seed %d gave no report: status %d"
                         % (problem, seed, os.waitstatus_to_exitcode(status)))
    with open(report) as file:
        section = json.load(file)["arrange"]
    return status == 0, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, section


def row(*cells):
    print("| " + " | ".join(str(c) for c in cells) + " |", flush=True)


def summary(runs):
    seconds = sorted(r[1] for r in runs)
    shares = [r[3]["put"]["milliseconds"] / r[3]["milliseconds"] for r in runs if r[3]["milliseconds"] > 0]
    return (sum(r[0] for r in runs), "%.2f, %.2f, %.2f" % (seconds[0], statistics.median(seconds), seconds[-1]),
            "%.0f %%" % (100 * (1 - statistics.median(shares))), "%.0f" % max(r[2] for r in runs),
            "%d; %d; %d; %d" % tuple(max(r[3][key] for r in runs)
                                     for key in ("puts", "refused_puts", "evictions", "improvements")))


def head(first, seeds):
    row(first, "true of %d" % seeds, "processor time, s: least, median, most", "solver outside of PUT, median",
        "MB, most", "PUTs; not kept; evictions; improvements, most")
    row(*["---"] * 6)


def demos(trivet, seeds, names):
    head("scene", seeds)
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([trivet, "demo", name, "--export", folder, "-o", os.path.join(folder, "scene.glb"),
                            "--quiet"], stdout=subprocess.DEVNULL, check=False)
            problem = os.path.join(folder, "problem.json")
            row(name, *summary([arrange(trivet, problem, seed, folder) for seed in range(1, seeds + 1)]))


def box_obj(half_x, half_y, height):
    text = "".join("v %g %g %g\n" % (x, y, z) for z in (0, height) for y in (-half_y, half_y)
                   for x in (-half_x, half_x))
    return text + "".join("f %s\n" % f for f in ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"))


def grown(count, folder):
    """A board with so many boxes; every tenth next to the one before it, all 5 mm apart. A third of the board is full."""
    with open(os.path.join(folder, "box.obj"), "w") as file:
        file.write(box_obj(0.04, 0.03, 0.08))
    width = (count * 0.0048 * 3) ** 0.5
    with open(os.path.join(folder, "board.obj"), "w") as file:
        file.write(box_obj(width / 2, width / 2, 0.5))
    names = ["box_%d" % i for i in range(count)]
    relations = [{"is": "on", "a": "*", "b": "board"}, {"is": "keep", "a": "*", "distance": 0.005}]
    relations += [{"is": "near", "a": names[i], "b": names[i - 1], "distance": 0.05} for i in range(1, count, 10)]
    problem = os.path.join(folder, "problem.json")
    with open(problem, "w") as file:
        json.dump({"trivet": 1,
                   "objects": [{"name": "board", "model": "board.obj", "fixed": True, "position": [0, 0, 1e-5]}] +
                   [{"name": n, "model": "box.obj"} for n in names],
                   "arrange": {"relations": relations, "things": [{"objects": "box_*", "yaw": [0, 90]}]}}, file)
    return problem


def growth(trivet, counts, seeds):
    head("things", seeds)
    for count in counts:
        with tempfile.TemporaryDirectory() as folder:
            problem = grown(count, folder)
            row(count, *summary([arrange(trivet, problem, seed, folder) for seed in range(1, seeds + 1)]))


CROCKERY = ["plate", "cup", "bowl", "glass", "saucer", "jug", "apple", "toast"]
BOARD = 0.7  # metres
HOVER = 0.002  # of the baseline, metres over the board
PAIRS = [[{"is": "right_of", "gap": [0.005, 0.03]}], [{"is": "near", "distance": 0.02}],
         [{"is": "near", "distance": 0.04}, {"is": "facing", "tolerance": 10}]]


def board_layout(folder, count):
    """Names of things, a layout of a board and these without places, and relations of every second to the one before."""
    with open(os.path.join(folder, "board.obj"), "w") as file:
        file.write(box_obj(BOARD / 2, BOARD / 2, 0.5))
    objects = [{"name": "board", "model": "board.obj", "fixed": True, "position": [0, 0, 1e-5]}]
    names = ["%s_%d" % (CROCKERY[i % len(CROCKERY)], i) for i in range(count)]
    relations = [dict(r, a=names[i], b=names[i - 1]) for i in range(1, count, 2) for r in PAIRS[i // 2 % 3]]
    return names, objects + [{"name": n, "model": n.split("_")[0] + ".glb"} for n in names], relations


def vertices_of(path):
    """Vertices of a binary glTF file whose nodes have a mesh and a matrix: z up, in its model's frame."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack_from("<I", data, 12)[0]
    gltf, binary = json.loads(data[20:20 + length]), 28 + length
    out = []
    for node in gltf["nodes"]:
        m = node.get("matrix", [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
        for primitive in gltf["meshes"][node["mesh"]]["primitives"]:
            accessor = gltf["accessors"][primitive["attributes"]["POSITION"]]
            view = gltf["bufferViews"][accessor["bufferView"]]
            begin = binary + view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            for i in range(accessor["count"]):
                p = struct.unpack_from("<fff", data, begin + i * view.get("byteStride", 12)) + (1,)
                x, y, z = (sum(m[4 * k + row] * p[k] for k in range(4)) for row in range(3))
                out.append((x, -z, y))
    return out


def outline(points):
    """Corners of the convex hull, counter-clockwise [Andrew 1979]."""
    def half(ordered):
        out = []
        for p in ordered:
            while len(out) > 1 and ((out[-1][0] - out[-2][0]) * (p[1] - out[-2][1]) <=
                                    (out[-1][1] - out[-2][1]) * (p[0] - out[-2][0])):
                out.pop()
            out.append(p)
        return out[:-1]
    ordered = sorted(set(points))
    return half(ordered) + half(ordered[::-1])


class Model:
    """Seen from above, as it stands: its outline, its box's corners; z of its lowest point."""

    def __init__(self, path):
        vertices = vertices_of(path)
        self.outline = outline([v[:2] for v in vertices])
        (ax, ay), (bx, by) = ([f(v[k] for v in vertices) for k in (0, 1)] for f in (min, max))
        self.box = [(ax, ay), (bx, ay), (bx, by), (ax, by)]
        self.bottom = min(v[2] for v in vertices)


def judged(trivet, scene, folder):
    """Crossing pairs, things that are not at rest (both by the exact check), and metres that MuJoCo moves each by."""
    found = json.loads(subprocess.run([trivet, "check", scene, "--json"], stdout=subprocess.PIPE, check=False).stdout)
    report = os.path.join(folder, "export.json")
    subprocess.run([trivet, "export", scene, "-o", os.path.join(folder, "scene.xml"), "--simulate", "5",
                    "--max-overlap", "0.02", "--quiet", "--report", report], stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL, check=False)
    with open(report) as file:
        moved = [o["moved"] for o in json.load(file)["simulated"]["objects"]]
    return found["check"]["interpenetrating_pairs"], len(found["check"]["not_at_rest"]), moved


def poses(report):
    """Angle about z and position of each object of a report, by name."""
    with open(report) as file:
        matrices = {o["name"]: o["world_from_file"] for o in json.load(file)["objects"]}
    return {name: (math.atan2(m[4], m[0]), m[3:12:4]) for name, m in matrices.items()}


def baseline(trivet, names, objects, relations, models, seed, folder):
    """The answer of boxes and rejection: found or not, processor seconds, and places by name."""
    boxes = {n: models[n.split("_")[0]].box for n in names}
    begin = time.process_time()
    found = by_rejection(boxes, relations, BOARD / 2, seed)
    seconds = time.process_time() - begin
    if found is None:
        return False, seconds, {}
    stands = []
    for name, (angle, at) in zip(names, found):
        height = 0.5 + 1e-5 + HOVER - models[name.split("_")[0]].bottom
        stands.append({"op": "stand", "object": name, "position": at + [height],
                       "rotation": [math.cos(angle / 2), 0, 0, math.sin(angle / 2)]})
    layout = os.path.join(folder, "layout.json")
    with open(layout, "w") as file:
        json.dump({"trivet": 1, "objects": objects, "operations": stands}, file)
    subprocess.run([trivet, "run", layout, "-o", os.path.join(folder, "scene.glb"), "--quiet"],
                   stdout=subprocess.DEVNULL, check=False)
    return True, seconds, {n: (angle, at) for n, (angle, at) in zip(names, found)}


def by_arrange(trivet, names, objects, relations, seed, folder):
    problem = os.path.join(folder, "board.json")
    with open(problem, "w") as file:
        json.dump({"trivet": 1, "objects": objects, "arrange": {
            "things": [{"object": n, "yaw": "any"} for n in names],
            "relations": [{"is": "on", "a": "*", "b": "board"}] + relations}}, file)
    done, seconds, _, _ = arrange(trivet, problem, seed, folder)
    return done, seconds, poses(os.path.join(folder, "report.json")) if done else {}


def num_kept(relations, models, places):
    """Relations that hold of the outlines of the meshes where they stand, to a tenth of a millimetre over the tolerance."""
    def seen(name):
        angle, at = places[name]
        return placed(models[name.split("_")[0]].outline, angle, at), angle
    return sum(holds(r, seen(r["a"]), seen(r["b"]), 1.1e-3) for r in relations)


def spread(solutions, names):
    """Metres by which the things of two solutions are apart, in the mean over things and pairs of solutions."""
    pairs = list(itertools.combinations(solutions, 2))
    return sum(math.dist(p[n][1][:2], q[n][1][:2]) for p, q in pairs for n in names) / max(1, len(pairs) * len(names))


def beside(trivet, counts, seeds):
    row("things; relations", "by", "all placed, of %d" % seeds, "processor time, s: median", "relations kept by meshes",
        "crossing pairs", "not at rest", "moved by over 1 cm in MuJoCo; most, m", "apart in two seeds, mean, m")
    row(*["---"] * 9)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([trivet, "demo", "table-for-six", "--export", folder, "-o",
                        os.path.join(folder, "scene.glb"), "--quiet"], stdout=subprocess.DEVNULL, check=False)
        models = {model: Model(os.path.join(folder, model + ".glb")) for model in CROCKERY}
        for count in counts:
            names, objects, relations = board_layout(folder, count)
            for by in ("boxes and rejection", "arrange"):
                runs = []
                for seed in range(1, seeds + 1):
                    if by == "arrange":
                        done, seconds, places = by_arrange(trivet, names, objects, relations, seed, folder)
                    else:
                        done, seconds, places = baseline(trivet, names, objects, relations, models, seed, folder)
                    found = judged(trivet, os.path.join(folder, "scene.glb"), folder) if done else (0, 0, [])
                    runs.append((done, seconds, places) + found)
                row("%d; %d" % (count, len(relations)), by, *told(runs, names, relations, models))


def told(runs, names, relations, models):
    """The row of these runs."""
    solutions = [r[2] for r in runs if r[0]]
    moved = [m for r in runs for m in r[5]]
    return (len(solutions), "%.3f" % statistics.median(r[1] for r in runs),
            "%d of %d" % (sum(num_kept(relations, models, p) for p in solutions), len(relations) * len(solutions)),
            sum(r[3] for r in runs), "%d of %d" % (sum(r[4] for r in runs), len(moved)),
            "%d of %d; %.3f" % (sum(m > 0.01 for m in moved), len(moved), max(moved, default=0)),
            "%.3f" % spread(solutions, names) if len(solutions) > 1 else "-")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trivet")
    parser.add_argument("what", choices=["demos", "growth", "beside"])
    parser.add_argument("--seeds", type=int)
    parser.add_argument("--only", nargs="+", default=DEMOS)
    parser.add_argument("--things", nargs="+", type=int)
    arguments = parser.parse_args()
    if arguments.what == "demos":
        demos(os.path.abspath(arguments.trivet), arguments.seeds or 20, arguments.only)
    elif arguments.what == "beside":
        beside(os.path.abspath(arguments.trivet), arguments.things or [4, 6, 8, 10, 12], arguments.seeds or 10)
    else:
        growth(os.path.abspath(arguments.trivet), arguments.things or [20, 50, 100, 200], arguments.seeds or 3)


if __name__ == "__main__":
    main()
