#!/usr/bin/env python3
"""Computer-aided layout, measured: seeds of the demos, and growth with the number of things. Markdown.

    perf/arrange.py TRIVET demos [--seeds 20] [--only NAME ...]
    perf/arrange.py TRIVET growth [--things 20 50 100 200]
    perf/arrange.py TRIVET beside [--things 5 10 15 20 25] [--seeds 10]

Processor time is of the whole program in one thread, reading models and checking the scene included; the share of
PUT is of the solver's wall time. A scene counts as true when `trivet arrange` ends with 0: all hard relations hold,
the exact check finds nothing crossing, and it stands as a whole.

`beside` fills a board of 0.7 x 0.7 m with crockery of `trivet demo table-for-six`, once by `trivet arrange` and once by
a baseline, boxes and rejection: each thing upright, turned by quarters, its box seen from above apart from all others
and on the board, 100 tries a thing, 10 of the whole, 2 mm over the board, as generators of scenes do that let a simulator settle.
Its time is of the tries alone; the models' boxes are known. Drift is MuJoCo's: 5 s of `trivet export --simulate`.
"""
import argparse
import json
import math
import os
import random
import statistics
import subprocess
import tempfile
import time

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
TRIES, ATTEMPTS = 100, 10  # of a thing, and of the whole, by rejection


def board_layout(folder, count):
    """Models' boxes seen from above by name, and a layout of a board and so many things without places."""
    with open(os.path.join(folder, "board.obj"), "w") as file:
        file.write(box_obj(BOARD / 2, BOARD / 2, 0.5))
    objects = [{"name": "board", "model": "board.obj", "fixed": True, "position": [0, 0, 1e-5]}]
    names = ["%s_%d" % (CROCKERY[i % len(CROCKERY)], i) for i in range(count)]
    return names, objects + [{"name": n, "model": n.split("_")[0] + ".glb"} for n in names]


def box_of(trivet, model):
    """Lower and upper corner as the model stands, z up."""
    info = json.loads(subprocess.run([trivet, "info", model, "--json"], stdout=subprocess.PIPE, check=True).stdout)
    (ax, ay, az), (bx, by, bz) = info["box"]["lower"], info["box"]["upper"]
    return ((ax, -bz, ay), (bx, -az, by)) if info["up"] == "y" else ((ax, ay, az), (bx, by, bz))


def by_rejection(boxes, seed):
    """Positions and turns of things with these boxes; None: in each attempt one had no place in all its tries."""
    numbers = random.Random(seed)
    return next(filter(None, (attempt(boxes, numbers) for _ in range(ATTEMPTS))), None)


def attempt(boxes, numbers):
    taken, out = [], []
    for (ax, ay, az), (bx, by, _) in boxes:
        for _ in range(TRIES):
            turn = numbers.randrange(4) * math.pi / 2  # boxes of other turns would be larger
            c, s = round(math.cos(turn)), round(math.sin(turn))
            corners = [(c * x - s * y, s * x + c * y) for x in (ax, bx) for y in (ay, by)]
            lower, upper = [min(p[k] for p in corners) for k in (0, 1)], [max(p[k] for p in corners) for k in (0, 1)]
            if any(upper[k] - lower[k] > BOARD for k in (0, 1)):
                continue
            at = [numbers.uniform(-BOARD / 2 - lower[k], BOARD / 2 - upper[k]) for k in (0, 1)]
            box = [at[k] + lower[k] for k in (0, 1)] + [at[k] + upper[k] for k in (0, 1)]
            if all(box[0] > t[2] or box[2] < t[0] or box[1] > t[3] or box[3] < t[1] for t in taken):
                break
        else:
            return None
        taken.append(box)
        out.append((at + [0.5 + 1e-5 + 0.002 - az], [math.cos(turn / 2), 0, 0, math.sin(turn / 2)]))
    return out


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


def baseline(trivet, names, objects, boxes, seed, folder):
    """Whether boxes and rejection found places, processor seconds of that, and the scene."""
    begin = time.process_time()
    places = by_rejection(boxes, seed)
    seconds = time.process_time() - begin
    if places is None:
        return False, seconds, None
    stands = [{"op": "stand", "object": n, "position": at, "rotation": turn}
              for n, (at, turn) in zip(names, places)]
    layout, scene = os.path.join(folder, "layout.json"), os.path.join(folder, "scene.glb")
    with open(layout, "w") as file:
        json.dump({"trivet": 1, "objects": objects, "operations": stands}, file)
    subprocess.run([trivet, "run", layout, "-o", scene, "--quiet"], stdout=subprocess.DEVNULL, check=False)
    return True, seconds, scene


def beside(trivet, counts, seeds):
    row("things", "by", "all placed, of %d" % seeds, "processor time, s: median", "crossing pairs", "not at rest",
        "moved by over 1 cm in MuJoCo", "most, m")
    row(*["---"] * 8)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([trivet, "demo", "table-for-six", "--export", folder, "-o",
                        os.path.join(folder, "scene.glb"), "--quiet"], stdout=subprocess.DEVNULL, check=False)
        sizes = {model: box_of(trivet, os.path.join(folder, model + ".glb")) for model in CROCKERY}
        for count in counts:
            names, objects = board_layout(folder, count)
            problem = os.path.join(folder, "board.json")
            with open(problem, "w") as file:
                json.dump({"trivet": 1, "objects": objects, "arrange": {
                    "things": [{"object": n, "yaw": "any"} for n in names],
                    "relations": [{"is": "on", "a": "*", "b": "board"}]}}, file)
            boxes = [sizes[n.split("_")[0]] for n in names]
            for by in ("boxes and rejection", "arrange"):
                runs = []
                for seed in range(1, seeds + 1):
                    if by == "arrange":
                        done, seconds, _, _ = arrange(trivet, problem, seed, folder)
                        scene = os.path.join(folder, "scene.glb")
                    else:
                        done, seconds, scene = baseline(trivet, names, objects, boxes, seed, folder)
                    runs.append((done, seconds) + (judged(trivet, scene, folder) if done else (0, 0, [])))
                moved = [m for r in runs for m in r[4]]
                row(count, by, sum(r[0] for r in runs), "%.3f" % statistics.median(r[1] for r in runs),
                    sum(r[2] for r in runs), "%d of %d" % (sum(r[3] for r in runs), len(moved)),
                    "%d of %d" % (sum(m > 0.01 for m in moved), len(moved)), "%.3f" % max(moved, default=0))


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
        beside(os.path.abspath(arguments.trivet), arguments.things or [5, 10, 15, 20, 25], arguments.seeds or 10)
    else:
        growth(os.path.abspath(arguments.trivet), arguments.things or [20, 50, 100, 200], arguments.seeds or 3)


if __name__ == "__main__":
    main()
