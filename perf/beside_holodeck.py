#!/usr/bin/env python3
"""The same rooms by Holodeck's solver and by `trivet arrange`. Markdown.

    perf/beside_holodeck.py TRIVET .../ai2holodeck/generation/floor_objects.py [--desks 1 2 3 4 5] [--seeds 10]

Holodeck [Yang 2024] is not part of this repository: of the file that is named, the class DFS_Solver_Floor is run as it is,
with its own settings (30 s, a grid of a 20th of the room, boxes 10 cm larger than the objects), for which Debian has
python3-shapely, python3-rtree and python3-scipy. Its bonuses are what relations are to `trivet arrange`.

A room of 5 x 4 m with four walls: so many desks at walls, a chair in front of each, near it and facing it, a waste
basket near each, a bookcase at a wall. Models of `trivet demo office3`. Relations are judged by the outlines of the meshes,
as Holodeck means them: at a wall: the back is 10 cm or less from one and turned to it; near: 80 cm or less apart; in front:
the centre is beyond the front and between the sides; facing: the line from the centre along the front meets the other.
"""
import argparse
import ast
import contextlib
import io
import json
import math
import os
import random
import subprocess
import tempfile
import time

import numpy
from rtree import index
from scipy.interpolate import interp1d
from shapely.geometry import LineString, Point, Polygon, box

from arrange import HOVER, Model, arrange, judged, poses, row, spread
from boxes_and_rejection import centre, distance, extent, front, placed, right

LENGTH, WIDTH, THICK, HIGH = 5.0, 4.0, 0.1, 2.2  # of the room, inside; of its walls, metres
AT_WALL, NEAR = 0.1, 0.8
WALLS = {"south": (0, 1), "north": (0, -1), "west": (1, 0), "east": (-1, 0)}  # and into the room


def solver_class(path):
    """DFS_Solver_Floor and SolutionFound of the file, without what else it imports."""
    import copy  # noqa: the class's own
    with open(path) as file:
        tree = ast.parse(file.read())
    wanted = [n for n in tree.body if isinstance(n, ast.ClassDef) and n.name in ("DFS_Solver_Floor", "SolutionFound")]
    names = {"copy": copy, "random": random, "time": time, "np": numpy, "index": index, "interp1d": interp1d,
             "Polygon": Polygon, "Point": Point, "box": box, "LineString": LineString}
    exec(compile(ast.Module(wanted, []), path, "exec"), names)
    return names["DFS_Solver_Floor"]


def things(desks):
    """Name, model and wishes: what, to what."""
    out = [("desk_%d" % i, "desk", [("at_wall", None)]) for i in range(desks)]
    out.append(("bookcase", "bookcase", [("at_wall", None)]))
    for i in range(desks):
        out.append(("chair_%d" % i, "chair", [("in_front", "desk_%d" % i), ("facing", "desk_%d" % i),
                                              ("near", "desk_%d" % i)]))
    return out + [("basket_%d" % i, "waste_basket", [("near", "desk_%d" % i)]) for i in range(desks)]


def by_holodeck(solver, models, wanted, seed):
    """Seconds of processor time, and angle and position of the centre of each box that was placed."""
    random.seed(seed)
    numpy.random.seed(seed)
    kinds = {"at_wall": ("global", "edge"), "in_front": ("relative", "in front of"), "facing": ("direction", "face to"),
             "near": ("distance", "near")}
    constraints, sizes = {}, []
    for name, model, wishes in wanted:
        entries = [dict(zip(("type", "constraint", "target"), kinds[w] + ((to,) if to else ()))) for w, to in wishes]
        if wishes[0][0] != "at_wall":
            entries.insert(0, {"type": "global", "constraint": "middle"})
        if wishes[0][0] == "in_front":  # as its own parser reads it
            entries.append({"type": "alignment", "constraint": "center aligned", "target": wishes[0][1]})
        constraints[name] = entries
        (ax, ay), _, (bx, by), _ = models[model].box
        sizes.append((name, (100 * (bx - ax) + 10, 100 * (by - ay) + 10)))
    room = Polygon([(0, 0), (100 * LENGTH, 0), (100 * LENGTH, 100 * WIDTH), (0, 100 * WIDTH)])
    run = solver(grid_size=int(max(100 * LENGTH // 20, 100 * WIDTH // 20)), max_duration=30, constraint_bouns=1)
    begin = time.process_time()
    with contextlib.redirect_stdout(io.StringIO()):
        solution = run.get_solution(room, sizes, constraints, {})
    seconds = time.process_time() - begin
    return seconds, {name: (math.radians(180 - s[1]), (s[0][0] / 100 - LENGTH / 2, s[0][1] / 100 - WIDTH / 2))
                     for name, s in solution.items()}


def walls_obj(folder):
    for name, (x, y) in (("wall_long", (LENGTH / 2 + THICK, THICK / 2)), ("wall_short", (THICK / 2, WIDTH / 2 - 0.001))):
        with open(os.path.join(folder, name + ".obj"), "w") as file:
            for z in (0, HIGH):
                file.write("".join("v %g %g %g\n" % (sx * x, sy * y, z) for sy in (-1, 1) for sx in (-1, 1)))
            file.write("f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")


def walls():
    """Objects of the layout; the fronts of walls look into the room."""
    x, y = (LENGTH + THICK) / 2, (WIDTH + THICK) / 2
    at = {"south": (0, -y), "north": (0, y), "west": (-x, 0), "east": (x, 0)}
    return [{"name": w, "model": "wall_long.obj" if w in ("south", "north") else "wall_short.obj", "fixed": True,
             "position": list(at[w]) + [1e-5]} for w in WALLS]


def stand(trivet, models, wanted, found, folder):
    """The scene of what Holodeck found; its boxes are about the objects' own boxes."""
    operations = []
    for name, model, _ in wanted:
        if name not in found:
            continue
        angle, at = found[name]
        (ax, ay), _, (bx, by), _ = models[model].box
        (x, y), = placed([(-(ax + bx) / 2, -(ay + by) / 2)], angle, at)
        operations.append({"op": "stand", "object": name, "position": [x, y, HOVER - models[model].bottom],
                           "rotation": [math.cos(angle / 2), 0, 0, math.sin(angle / 2)]})
        found[name] = (angle, (x, y))
    layout = os.path.join(folder, "layout.json")
    with open(layout, "w") as file:
        json.dump({"trivet": 1, "objects": walls() + [{"name": n, "model": m + ".glb"} for n, m, _ in wanted],
                   "operations": operations}, file)
    subprocess.run([trivet, "run", layout, "-o", os.path.join(folder, "scene.glb"), "--quiet"],
                   stdout=subprocess.DEVNULL, check=False)


def by_arrange(trivet, wanted, seed, folder):
    """Each desk at a wall that the seed draws: relations have one object; all else as Holodeck has it."""
    draw = random.Random(seed)
    relations = [{"is": "within", "a": "*", "region": [[-LENGTH / 2, -WIDTH / 2], [LENGTH / 2, -WIDTH / 2],
                                                       [LENGTH / 2, WIDTH / 2], [-LENGTH / 2, WIDTH / 2]]}]
    order = draw.sample(list(WALLS), 4)
    for i, (name, _, wishes) in enumerate(wanted):
        for wish, to in wishes:
            relations.append({
                "at_wall": {"is": "against", "a": name, "b": order[i % 4], "gap": [0.005, AT_WALL]},
                "in_front": {"is": "in_front_of", "a": name, "b": to, "overlap": 1},
                "facing": {"is": "facing", "a": name, "b": to, "tolerance": 20},
                "near": {"is": "near", "a": name, "b": to, "distance": NEAR}}[wish])
    problem = os.path.join(folder, "room.json")
    with open(problem, "w") as file:
        json.dump({"trivet": 1, "objects": walls() + [{"name": n, "model": m + ".glb"} for n, m, _ in wanted],
                   "arrange": {"things": [{"object": n} for n, _, _ in wanted], "relations": relations}}, file)
    done, seconds, _, _ = arrange(trivet, problem, seed, folder)
    return done, seconds, poses(os.path.join(folder, "report.json")) if done else {}


def at_wall(polygon, angle):
    back = (-front(angle)[0], -front(angle)[1])
    half = {(0, 1): WIDTH / 2, (1, 0): LENGTH / 2}
    for inwards in WALLS.values():
        outwards = (-inwards[0], -inwards[1])
        gap = half[tuple(map(abs, inwards))] - extent(polygon, outwards)
        if back[0] * outwards[0] + back[1] * outwards[1] > 0.99 and gap <= AT_WALL + 1.1e-3:
            return True
    return False


def met(wish, a, b):
    if wish == "at_wall":
        return at_wall(*a)
    if wish == "near":
        return distance(a[0], b[0]) <= NEAR + 1.1e-3
    at = centre(*a)
    if wish == "facing":
        f = front(a[1])
        return LineString([at, (at[0] + 100 * f[0], at[1] + 100 * f[1])]).intersects(Polygon(b[0]))
    f, r = front(b[1]), right(b[1])
    beside = at[0] * r[0] + at[1] * r[1]
    return at[0] * f[0] + at[1] * f[1] > extent(b[0], f) and \
        -extent(b[0], (-r[0], -r[1])) <= beside <= extent(b[0], r)


def num_met(wanted, models, found):
    seen = {n: (placed(models[m].outline, *found[n]), found[n][0]) for n, m, _ in wanted if n in found}
    return sum(n in seen and (to is None or to in seen) and met(wish, seen[n], seen.get(to))
               for n, _, wishes in wanted for wish, to in wishes)


def compare(trivet, solver, desks, seeds, folder, models):
    wanted = things(desks)
    wishes = sum(len(w) for _, _, w in wanted)
    for by in ("Holodeck", "arrange"):
        runs = []
        for seed in range(1, seeds + 1):
            if by == "Holodeck":
                seconds, found = by_holodeck(solver, models, wanted, seed)
                stand(trivet, models, wanted, found, folder)
            else:
                done, seconds, found = by_arrange(trivet, wanted, seed, folder)
            checked = judged(trivet, os.path.join(folder, "scene.glb"), folder) if found else (0, 0, [])
            runs.append((len(found) >= len(wanted), seconds, found, num_met(wanted, models, found)) + checked)
        whole = [r[2] for r in runs if r[0]]
        seconds = sorted(r[1] for r in runs)
        moved = [m for r in runs for m in r[6]]
        row("%d; %d" % (len(wanted), wishes), by, len(whole), "%d of %d" % (sum(r[3] for r in runs), wishes * seeds),
            "%.2f, %.2f" % (seconds[len(seconds) // 2], seconds[-1]), sum(r[4] for r in runs),
            "%d of %d; %.3f" % (sum(m > 0.01 for m in moved), len(moved), max(moved, default=0)),
            "%.2f" % spread(whole, [n for n, _, _ in wanted]) if len(whole) > 1 else "-")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trivet")
    parser.add_argument("floor_objects")
    parser.add_argument("--desks", nargs="+", type=int, default=[1, 2, 3, 4, 5])
    parser.add_argument("--seeds", type=int, default=10)
    arguments = parser.parse_args()
    trivet, solver = os.path.abspath(arguments.trivet), solver_class(arguments.floor_objects)
    row("things; relations", "by", "all placed, of %d" % arguments.seeds, "relations met by meshes",
        "processor time, s: median, most", "crossing pairs", "moved by over 1 cm in MuJoCo; most, m",
        "apart in two seeds, mean, m")
    row(*["---"] * 8)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([trivet, "demo", "office3", "--export", folder, "-o", os.path.join(folder, "scene.glb"),
                        "--quiet"], stdout=subprocess.DEVNULL, check=False)
        walls_obj(folder)
        models = {m: Model(os.path.join(folder, m + ".glb")) for m in ("desk", "bookcase", "chair", "waste_basket")}
        for desks in arguments.desks:
            compare(trivet, solver, desks, arguments.seeds, folder, models)


if __name__ == "__main__":
    main()
