#!/usr/bin/env python3
"""Raw real models, open and self-crossing ones, under a cloth and under a cable: at rest, or what is left.

drape_models.py TRIVET FOLDER [--every N] [--cells N] [--only cloth|cable] [--judge PROGRAM] [--csv FILE]
  TRIVET     the program
  FOLDER     with models/ and models.csv: file, scale_to_m, size_m, bbox_min, bbox_max, up_axis, defects
  --every    of the models, in the order of the list; default: all
  --judge    trivet_perf_drape, which drapes once more, and judges each step
Prints a row for each. Models stand on the floor as they are, 0.3 m large. A cloth of 0.6 m starts level above them, a cable
of 1 m across them.
"""
import argparse
import csv
import json
import os
import resource
import subprocess
import sys
import tempfile

SIZE = 0.3  # m, the model's longest side


def placed(row, folder):
    """The object of a layout, and the height of its top."""
    low, high = ([float(v) for v in row[key].split()] for key in ("bbox_min", "bbox_max"))
    scale = SIZE / max(h - l for l, h in zip(low, high))
    middle = [scale * (l + h) / 2 for l, h in zip(low, high)]
    if row["up_axis"] == "y":
        x, y, bottom, height = middle[0], -middle[2], scale * low[1], scale * (high[1] - low[1])
    else:
        x, y, bottom, height = middle[0], middle[1], scale * low[2], scale * (high[2] - low[2])
    return {"name": "model", "model": os.path.join(os.path.abspath(folder), "models", row["file"]),
            "up": row["up_axis"], "scale": scale, "fixed": True, "position": [-x, -y, 1e-4 - bottom]}, height


def operation(kind, top, cells):
    if kind == "cloth":
        return {"op": "drape", "object": "it", "size": [0.6, 0.6], "cell": 0.6 / cells, "position": [0, 0, top + 0.01]}
    return {"op": "drape", "object": "it", "path": [[-0.5, 0.02, top + 0.02], [0.5, -0.02, top + 0.02]]}


def run(program, layout, folder):
    with open(os.path.join(folder, "layout.json"), "w", encoding="utf-8") as file:
        json.dump(layout, file)
    report = os.path.join(folder, "report.json")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "run", "layout.json", "-o", "scene.glb", "--report", "report.json"], cwd=folder,
                          capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if not os.path.exists(report):
        return seconds, (done.stderr or done.stdout).strip()[:200], ""
    with open(report, encoding="utf-8") as file:
        content = json.load(file)
    it = next((o for o in content["objects"] if o["name"] == "it" and "flexible" in o), None)
    if it is None:
        return seconds, content["operations"][0].get("reason", "not loaded"), ""
    f, check = it["flexible"], content["check"]
    return seconds, "at rest" if check["all_at_rest"] else "not at rest by check", \
        f"{f['net_force']:.1e}, {f['steps']} steps, {check['interpenetrating_pairs']} crossings"


def judged(program, folder):
    """The numbers of states that were judged, and that crossed; all but the last are steps."""
    done = subprocess.run([program, os.path.join(folder, "layout.json"), "1", "judge"], capture_output=True, text=True,
                          check=False)
    return ", ".join(done.stdout.strip().split("\t")[-2:]) or done.stderr.strip()[:100]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trivet")
    parser.add_argument("folder")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--cells", type=int, default=50)
    parser.add_argument("--only", choices=("cloth", "cable"))
    parser.add_argument("--judge", metavar="PROGRAM")
    parser.add_argument("--csv")
    options = parser.parse_args()
    with open(os.path.join(options.folder, "models.csv"), encoding="utf-8") as file:
        models = list(csv.DictReader(file))[::options.every]
    rows = []
    for kind in [options.only] if options.only else ("cloth", "cable"):
        for row in models:
            thing, height = placed(row, options.folder)
            with tempfile.TemporaryDirectory() as folder:
                seconds, result, rest = run(os.path.abspath(options.trivet), {
                    "trivet": 1, "objects": [thing], "operations": [operation(kind, height, options.cells)]}, folder)
                steps = judged(os.path.abspath(options.judge), folder) if options.judge else ""
            rows.append((kind, row["file"], row["defects"], f"{seconds:.1f}", result, rest, steps))
            print(*rows[-1], sep="\t", flush=True)
        done = sum(r[0] == kind and r[4] == "at rest" for r in rows)
        print(f"{kind}: {done} of {len(models)} at rest", flush=True)
    if options.csv:
        with open(options.csv, "w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([("kind", "model", "defects", "cpu s", "result", "rest", "steps"), *rows])
    return 0


if __name__ == "__main__":
    sys.exit(main())
