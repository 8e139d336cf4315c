#!/usr/bin/env python3
"""Computer-aided layout, measured: seeds of the demos, and growth with the number of things. Markdown.

    perf/arrange.py TRIVET demos [--seeds 20] [--only NAME ...]
    perf/arrange.py TRIVET growth [--things 20 50 100 200]

Processor time is of the whole program in one thread, reading models and checking the scene included; the share of
PUT is of the solver's wall time. A scene counts as true when `trivet arrange` ends with 0: all hard relations hold,
the exact check finds nothing crossing, and it stands as a whole.
"""
import argparse
import json
import os
import statistics
import subprocess
import tempfile

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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trivet")
    parser.add_argument("what", choices=["demos", "growth"])
    parser.add_argument("--seeds", type=int)
    parser.add_argument("--only", nargs="+", default=DEMOS)
    parser.add_argument("--things", nargs="+", type=int, default=[20, 50, 100, 200])
    arguments = parser.parse_args()
    if arguments.what == "demos":
        demos(os.path.abspath(arguments.trivet), arguments.seeds or 20, arguments.only)
    else:
        growth(os.path.abspath(arguments.trivet), arguments.things, arguments.seeds or 3)


if __name__ == "__main__":
    main()
