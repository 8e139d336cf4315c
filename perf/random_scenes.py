#!/usr/bin/env python3
"""Processor seconds of heaps, bins and random scenes by several builds in turn, and whether they give the same bytes.

    perf/random_scenes.py --shared ../shared PROGRAM... [--only heap,friction,bin,breakfast,cubes] [--runs 1] [--heaps 4] ...

heap:      `trivet run` of heaps of 50 real models as tests/referee/campaign.py makes them, perfect friction.
friction:  the same heaps with friction 0.5, at rest as a whole.
bin:       bins of ten real models, friction 0.5, at rest as a whole.
breakfast: `trivet batch` of scenes like BREAKFAST, the recipe of apps/farm/examples.
cubes:     `trivet batch` of heaps of 60 cubes: flat contacts.

One thread, user and system time of all processes, models read each time; of several runs the least. Reports are compared
without milliseconds and work, scenes and tars as they are.
"""
import argparse
import hashlib
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "tests", "referee"))
sys.dont_write_bytecode = True
import campaign  # noqa: E402
import campaign_sets  # noqa: E402

SETS = {"heap": ("pile", ["--perfect-friction"]), "friction": ("pile", []), "bin": ("bin", [])}
CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, .1) for y in (0, .1) for z in (0, .1)) + \
    "".join("f %d %d %d %d\n" % f for f in ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)))


def cpu_seconds(*command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{' '.join(command)}: status {done.returncode}: {done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def digest(*parts):
    out = hashlib.sha256()
    for part in parts:
        out.update(part)
    return out.hexdigest()


def read(path):
    with open(path, "rb") as file:
        return file.read()


def run_layout(program, layout, rules, folder):
    """Seconds, a hash of report and scene, and how many objects are placed of how many."""
    scene, report = os.path.join(folder, "scene.glb"), os.path.join(folder, "report.json")
    seconds = cpu_seconds(program, "run", layout, "-o", scene, "--report", report, "--quiet", "--threads", "1", *rules)
    found = campaign.read_report(report)
    puts = [o["status"] == "ok" for o in found["operations"]]
    return seconds, digest(campaign.comparable(found).encode(), read(scene)), f"{sum(puts)} of {len(puts)}"


def run_batch(program, recipe, count, folder):
    out = os.path.join(folder, "batch")
    seconds = cpu_seconds(program, "batch", recipe, "--count", str(count), "--per-tar", str(count), "--jobs", "1", "--out", out)
    tar = read(os.path.join(out, "0000", "scenes-000000.tar"))
    shutil.rmtree(out)
    return seconds, digest(tar), f"{count} scenes"


def layouts(name, options, folder):
    """Names and jobs: functions of a program."""
    kind, rules = SETS[name]
    chosen = argparse.Namespace(shared=os.path.abspath(options.shared), out=folder, heaps=f"{options.heaps}x50",
                                bins=f"{options.bins}x10", solids="1x8")
    for title, layout, _ in campaign_sets.sets_of(chosen)[kind][1]:
        if name != "heap":
            layout = {**layout, "material": {"friction": 0.5}}
        path = os.path.join(folder, f"{name}_{title}.json")
        with open(path, "w") as file:
            json.dump(layout, file)
        yield f"{title}, {name}", lambda program, path=path: run_layout(program, path, rules, folder)


def breakfast(options, folder):
    subprocess.run([options.programs[0], "demo", "breakfast", "-o", os.path.join(folder, "b.glb"), "--export", folder, "--quiet"],
                   check=True, stdout=subprocess.DEVNULL)
    recipe = os.path.join(folder, "recipe.json")
    shutil.copy(os.path.join(HERE, "..", "apps", "farm", "examples", "breakfast.json"), recipe)
    yield "like BREAKFAST", lambda program: run_batch(program, recipe, options.scenes, folder)


def cubes(options, folder):
    recipe = os.path.join(folder, "cubes.json")
    with open(os.path.join(folder, "cube.obj"), "w") as file:
        file.write(CUBE)
    group = {"name": "cube", "models": [{"model": "cube.obj"}], "count": 60, "rotation": "any",
             "heap": {"radius": 0.3, "height": 0.1, "rise": 0.1}}
    with open(recipe, "w") as file:
        json.dump({"trivet_recipe": 1, "groups": [group]}, file)
    yield "60 cubes", lambda program: run_batch(program, recipe, options.cubes, folder)


def jobs(options, folder):
    for name in options.only.split(","):
        if name in SETS:
            yield from layouts(name, options, folder)
        elif name in ("breakfast", "cubes"):
            yield from (breakfast if name == "breakfast" else cubes)(options, folder)
        else:
            raise SystemExit(f"--only {name}: unknown; accepted: heap, friction, bin, breakfast, cubes")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--shared", required=True)
    parser.add_argument("--only", default="heap,breakfast")
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--heaps", type=int, default=4)
    parser.add_argument("--bins", type=int, default=3)
    parser.add_argument("--scenes", type=int, default=8, help="like BREAKFAST")
    parser.add_argument("--cubes", type=int, default=1, help="heaps of cubes")
    options = parser.parse_args()
    options.programs = [os.path.abspath(program) for program in options.programs]
    print("| scene | done | CPU s by " + ", ".join(f"program {i + 1}" for i in range(len(options.programs))) + " | bytes |\n"
          "|---|---|---|---|")
    differ = False
    with tempfile.TemporaryDirectory() as folder:
        for title, job in jobs(options, folder):
            runs = [[job(program) for program in options.programs] for _ in range(options.runs)]
            seconds = [min(run[i][0] for run in runs) for i in range(len(options.programs))]
            same = len({found[1] for run in runs for found in run}) == 1
            differ |= not same
            print(f"| {title} | {runs[0][0][2]} | " + ", ".join(f"{s:.2f}" for s in seconds) +
                  f" | {'the same' if same else 'differ'} |", flush=True)
    sys.exit(1 if differ else 0)


if __name__ == "__main__":
    main()
