#!/usr/bin/env python3
"""Lays out hundreds of scenes of real models; the independent referee judges each.

    tests/referee/campaign.py --trivet build/release/apps/trivet --referee PATH/referee \\
        --shared ../shared [--set floor,pair,pile,bin] [--out DIR] [--same-as OTHER_TRIVET] [--threads 1,2]
        [--backends software,compute] [--match REGEX] [--friction MU [--whole]] [--every N] [--heaps 4x50] [--bins 50x10]
        [--tries 3] [--starts 12] [--solids 20x8] [--simulate 5 [--rest 95,99]] [--placed 98] [--keep]

floor: every model in 5 random orientations, put onto the floor.
pair:  every model in 5 random orientations, put onto one of 10 other models that stand there fixed.
pile:  heaps, 4 of 50 objects.
bin:   bins, open boxes of 60 x 40 x 25 cm that stand fixed, each with 10 objects of up to 30 cm.
solid: heaps of convex solids, 20 of 8: bricks, slabs, bars, wedges and prisms, which are their own
       collision shapes. No real models are needed.
--simulate: every scene is exported, and MuJoCo runs on it for so many seconds; how many objects moved
by more than a millimetre and a centimetre is printed. --rest: of each 100 objects so many must move
by less than a millimetre, and so many by less than a centimetre, else the exit status is 1. Scenes whose
convex parts would overlap are not simulated, but named.
--friction: settled with this coefficient, by the referee judged at it. --whole: every operation leaves
the whole scene at rest, or is refused; the referee judges the whole scene, too.
--tries: what a heap or a bin refuses is put again in the end, from another place above all, up to so
many times in all; "placed" counts objects, "PUTs ok" PUTs.
--starts: every PUT may try so many starts near its own ("tries" of layouts). The processor time of all runs is printed.
--same-as, --threads and --backends run each layout again, by another build, with other numbers of
threads or other sources of candidates: reports (apart from milliseconds, and what a backend says of
itself) and scenes must be the same bytes. Without --referee, no other check is made.
They are named as --detector has them; "five" is short for all but gpu.
Prints a table; exit status 1 if a scene is not true, a result differs, a backend is not the one asked
for, or fewer are placed than --placed says, 98 % by default.
"""
import argparse
import concurrent.futures
import json
import os
import re
import resource
import statistics
import subprocess
import sys
import threading

import campaign_sets


def read_report(path):
    with open(path) as file:
        return json.load(file)


def comparable(report):
    """Part of a report that must be the same in every run."""
    report = {key: value for key, value in report.items()
              if key not in ("backend", "device", "gpu_method", "gpu_lists", "confirmation", "work")}
    report["operations"] = [{key: value for key, value in operation.items()
                             if key != "milliseconds"} for operation in report["operations"]]
    return json.dumps(report)


FIVE_WAYS = "bvh,software,framebuffer,compute,auto"


def is_as_asked(detector, report):
    """True if a report is of the detector that was asked for."""
    if detector in ("framebuffer", "compute"):
        return report["backend"] == "gpu" and report["gpu_method"] == detector
    return detector == "auto" or report["backend"] == detector


def run_trivet(trivet, base, suffix, *options):
    scene, report = f"{base}{suffix}.glb", f"{base}{suffix}.report.json"
    done = subprocess.run([trivet, "run", base + ".json", "-o", scene, "--report", report,
                           "--quiet", *options], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{base}: status {done.returncode}: {done.stderr}")
    return scene, report


class BackendWork:
    """Work of the candidate finders in all runs together."""
    def __init__(self):
        self.lock, self.sums, self.devices = threading.Lock(), {}, {}

    def add(self, backend, report):
        with self.lock:
            self.devices[backend] = report["device"]
            sums = self.sums.setdefault(backend, {})
            for key, value in report["work"].items():
                sums[key] = sums.get(key, 0) + value

    def print(self):
        for backend, sums in sorted(self.sums.items()):
            print(f"{backend} ({self.devices[backend]}): " +
                  ", ".join(f"{value} {key}" for key, value in sums.items()))


def differences(options, base, scene, report):
    """Other runs that did not give the same bytes."""
    others = [(options.trivet, f"-{n}-threads", ["--threads", n], "")
              for n in filter(None, options.threads.split(","))]
    others += [(options.trivet, "-" + name, ["--detector", name], name)
               for name in filter(None, options.backends.split(","))]
    if options.same_as:
        others.append((options.same_as, "-other-build", [], ""))
    found = []
    for trivet, suffix, arguments, backend in others:
        other_scene, path = run_trivet(trivet, base, suffix, *options.rules, *arguments)
        other = read_report(path)
        with open(scene, "rb") as a, open(other_scene, "rb") as b:
            same = a.read() == b.read() and comparable(report) == comparable(other)
        if backend:
            options.work.add(backend, other)
            same = same and is_as_asked(backend, other)
        if not same:
            found.append(os.path.basename(base) + suffix)
        os.remove(other_scene)
    return found


def verdict_of(options, base, scene, report):
    if not options.referee:
        return {"verdict": True}
    rules = (["--mu", str(options.friction)] if options.friction else []) + \
        (["--whole"] if options.whole else [])
    done = subprocess.run([options.referee, report, "--layout", base + ".json", "--scene",
                           scene, "--json", *rules], capture_output=True, text=True)
    return json.loads(done.stdout) if done.returncode in (0, 1) else {}


def simulate(options, base, scene):
    """Ways of the objects, in metres, while MuJoCo runs; none where parts would overlap."""
    if not options.simulate:
        return []
    report = base + ".exported.json"
    done = subprocess.run([options.trivet, "export", scene, "-o", base + ".xml", "--report", report,
                           "--simulate", str(options.simulate), "--quiet"],
                          capture_output=True, text=True)
    if done.returncode not in (0, 1):
        print(f"  not simulated: {done.stderr.strip()}", file=sys.stderr)
        return []
    return [o["moved"] for o in read_report(report)["simulated"]["objects"]]


def put_again(options, base, layout, again):
    """Appends further PUTs of what was refused, above all; runs anew after each round: what was done
    before is done the same again."""
    for _ in range(options.tries - 1 if again else 0):
        operations = read_report(base + ".report.json")["operations"]
        done = {o["object"] for o in operations if o["status"] == "ok"}
        top = max(o["position"][2] for o in layout["operations"])
        left = {o["object"]: o for o in layout["operations"] if o["object"] not in done}
        if not left:
            return
        for put in map(again, left.values()):
            put["position"][2] = top
            layout["operations"].append(put)
        with open(base + ".json", "w") as file:
            json.dump(layout, file)
        run_trivet(options.trivet, base, "", *options.rules)


def judge(options, name, layout, again):
    base = os.path.join(options.out, name)
    if options.starts > 1:
        layout["operations"] = [{**o, "tries": options.starts} if o["op"] == "put" and "position" in o else o
                                for o in layout["operations"]]
    if options.friction:
        layout = {**layout, "material": {"friction": options.friction}}
    with open(base + ".json", "w") as file:
        json.dump(layout, file)
    scene, path = run_trivet(options.trivet, base, "", *options.rules)
    put_again(options, base, layout, again)
    report = read_report(path)
    totals = verdict_of(options, base, scene, path)
    different = differences(options, base, scene, report)
    moved = simulate(options, base, scene)
    if not options.keep:
        os.remove(scene)
    placed = {o["object"] for o in report["operations"] if o["status"] == "ok"}
    num = len({o["object"] for o in layout["operations"]})
    return name, report["operations"], totals, different, (len(placed), num), moved


TOTALS = ["interpenetrating_pairs", "float32_interpenetrating_pairs", "below_floor",
          "float32_below_floor", "contained", "hovering", "unstable", "false_supports",
          "not_rigid", "scene_mismatch", "layout_mismatch", "unstable_as_a_whole"]


def run_set(options, title, layouts):
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        chosen = [item for item in layouts if re.search(options.match, item[0])][::options.every]
        results = list(pool.map(lambda item: judge(options, *item), chosen))
    operations = [o for _, ops, *_ in results for o in ops]
    placed, objects = (sum(r[4][k] for r in results) for k in (0, 1))
    done = [o for o in operations if o["status"] == "ok"]
    times = sorted(o["milliseconds"] for o in done)
    true = sum(1 for _, _, totals, *_ in results if totals.get("verdict"))
    sums = {k: sum(t.get(k) or 0 for _, _, t, *_ in results) for k in TOTALS}
    different = [d for _, _, _, found, *_ in results for d in found]
    print(f"| {title} | {len(results)} | {placed} of {objects} | {len(done)} of {len(operations)} | {true} | "
          f"{sum(sums.values())} | {statistics.median(times):.2f} | "
          f"{times[int(0.95 * (len(times) - 1))]:.1f} | {times[-1]:.0f} | {len(different)} |",
          flush=True)
    moved = [way for r in results for way in r[5]]
    if options.simulate:
        print(f"  in MuJoCo, {options.simulate} s: {sum(way > 1e-3 for way in moved)} of "
              f"{len(moved)} objects moved by more than 1 mm, {sum(way > 1e-2 for way in moved)} by "
              "more than 1 cm", flush=True)
    for o in operations:
        if o["status"] != "ok":
            print(f"  refused: {o['reason']}", file=sys.stderr)
    for name, _, totals, *_ in results:
        if not totals.get("verdict"):
            print(f"  not true: {name} {totals}", file=sys.stderr)
    for name in different:
        print(f"  differs: {name}", file=sys.stderr)
    rest = all(100 * sum(way < limit for way in moved) >= percent * len(moved)
               for percent, limit in zip(map(float, options.rest.split(",")), (1e-3, 1e-2)))
    return (true == len(results) and not different and rest and
            100 * placed >= options.placed * objects)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trivet", required=True)
    parser.add_argument("--referee", help="program of ../shared; default: scenes are not judged")
    parser.add_argument("--shared", required=True)
    parser.add_argument("--set", default="floor,pair,pile")
    parser.add_argument("--out", default="out/campaign")
    parser.add_argument("--jobs", type=int, default=1, help="parallel jobs; 1 for fair times")
    parser.add_argument("--match", default="", help="regular expression: only scenes with matching names, "
                        "such as pair_6[89]")
    parser.add_argument("--friction", type=float, help="Coulomb's coefficient; default: perfect friction")
    parser.add_argument("--whole", action="store_true", help="every operation leaves the whole at rest")
    parser.add_argument("--every", type=int, default=1, help="every N-th scene only")
    parser.add_argument("--heaps", default="4x50", help="number and size of the heaps")
    parser.add_argument("--bins", default="50x10", help="number of bins and of objects in each")
    parser.add_argument("--solids", default="20x8", help="number of heaps of solids and of objects in each")
    parser.add_argument("--simulate", type=float, default=0, help="seconds of MuJoCo")
    parser.add_argument("--rest", default="0,0", help="percent that must rest in MuJoCo, within a "
                        "millimetre and a centimetre")
    parser.add_argument("--placed", type=float, default=98, help="percent that must be placed")
    parser.add_argument("--tries", type=int, default=1, help="PUTs of an object that heaps and bins refuse")
    parser.add_argument("--starts", type=int, default=1, help="starts that a PUT may try")
    parser.add_argument("--keep", action="store_true", help="leave the scenes in --out, for interop/simulators/matrix.py")
    parser.add_argument("--same-as", help="another build of trivet to compare with")
    parser.add_argument("--threads", default="", help="numbers of threads to compare, comma-separated")
    parser.add_argument("--backends", default="", help="as --detector has them, with commas; or five")
    options = parser.parse_args()
    if options.backends == "five":
        options.backends = FIVE_WAYS
    options.work = BackendWork()
    options.rules = ["--perfect-friction"] if not options.friction else \
        [] if options.whole else ["--objects-alone"]
    options.shared, options.out = os.path.abspath(options.shared), os.path.abspath(options.out)
    os.makedirs(options.out, exist_ok=True)
    sets = campaign_sets.sets_of(options)
    print("| scenes | number | placed | PUTs ok | true | findings | PUT ms median | p95 | max | differ |\n"
          "|---|---|---|---|---|---|---|---|---|---|")
    ok = [run_set(options, *sets[name]) for name in options.set.split(",")]
    options.work.print()
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"processor time: {used.ru_utime + used.ru_stime:.1f} s")
    sys.exit(0 if all(ok) else 1)


if __name__ == "__main__":
    main()
