#!/usr/bin/env python3
"""Lays out hundreds of scenes of real models; the independent referee judges each.

    tests/referee/campaign.py --trivet build/release/apps/trivet --referee PATH/referee \\
        --shared ../shared [--set floor,pair,pile,bin] [--out DIR] [--same-as OTHER_TRIVET] [--threads 1,2]
        [--backends software,gpu] [--match REGEX] [--friction MU [--whole]] [--every N] [--heaps 4x50] [--bins 50x10]
        [--tries 3] [--solids 20x8] [--simulate 5]

floor: every model in 5 random orientations, put onto the floor.
pair:  every model in 5 random orientations, put onto one of 10 other models that stand there fixed.
pile:  heaps, 4 of 50 objects.
bin:   bins, open boxes of 60 x 40 x 25 cm that stand fixed, each with 10 objects of up to 30 cm.
solid: heaps of convex solids, 20 of 8: bricks, slabs, bars, wedges and prisms, which are their own
       collision shapes. No real models are needed.
--simulate: every scene is exported, and MuJoCo runs on it for so many seconds; how many objects moved
by more than a millimetre and a centimetre is printed. It does not count for the exit status.
--friction: settled with this coefficient, by the referee judged at it. --whole: every operation leaves
the whole scene at rest, or is refused; the referee judges the whole scene, too.
--tries: what a heap or a bin refuses is put again in the end, from another place above all, up to so
many times in all; "placed" counts objects, "PUTs ok" PUTs.
--same-as, --threads and --backends run each layout again, by another build, with other numbers of
threads or other sources of candidates: reports (apart from milliseconds, and what a backend says of
itself) and scenes must be the same bytes. Without --referee, no other check is made.
Prints a table; exit status 1 if a scene is not true, a result differs, a backend is not the one asked
for, or under 98 % are placed.
"""
import argparse
import concurrent.futures
import json
import math
import os
import random
import re
import statistics
import subprocess
import sys
import threading
import types


def read_models(shared, out):
    sys.path.insert(0, os.path.join(shared, "tools", "referee"))
    sys.dont_write_bytecode = True
    import layouts
    args = types.SimpleNamespace(
        models=os.path.join(shared, "data", "models"),
        csv=os.path.join(shared, "data", "models.csv"), out=out, absolute=True, kinds=None,
        min_size=0, max_size=float("inf"), max_triangles=sys.maxsize, drop=0.1)
    return layouts, layouts.read_models(args), args


def floor_layouts(layouts, models):
    for i, model in enumerate(models):
        for k in range(5):
            rng = random.Random(f"floor {i} {k}")
            layout = layouts.Layout()
            layout.put("object", model, layouts.random_rotation(rng), 0, 0, layouts.CLEAR + 0.1)
            yield f"floor_{i:02d}_{k}", layout.json, None


def pair_layouts(layouts, models):
    supports = random.Random(7).sample(models, 10)
    for i, model in enumerate(models):
        for k in range(5):
            rng = random.Random(f"pair {i} {k}")
            support = rng.choice([s for s in supports if s is not model])
            lower, upper = support.box()
            half = [(b - a) / 2 for a, b in zip(lower, upper)]
            layout = layouts.Layout()
            layout.add("support", support, fixed=True,
                       position=support.position(layouts.IDENTITY, 0, 0, layouts.CLEAR),
                       rotation=list(layouts.IDENTITY))
            x, y = (0.7 * h * rng.uniform(-1, 1) for h in half[:2])
            layout.put("load", model, layouts.random_rotation(rng), x, y,
                       2 * half[2] + 2 * layouts.CLEAR + 0.1)
            yield f"pair_{i:02d}_{k}", layout.json, None


def pile_layouts(layouts, models, args, heaps):
    count, args.objects = map(int, heaps.split("x"))
    args.radius = None
    for k in range(count):
        layout = layouts.make_pile(models, random.Random(f"pile {k}"), args)
        yield f"pile_{k}", layout.json, turned_about_centre(f"again {k}")


def write_bin(layouts, out):
    """An open box with walls of 1 cm, as a model."""
    outer, inner, height = (0.3, 0.2), (0.29, 0.19), 0.25
    rings = [(outer, 0), (outer, height), (inner, height), (inner, 0.01)]
    path = os.path.join(out, "bin.obj")
    with open(path, "w") as file:
        for (x, y), z in rings:
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                file.write(f"v {a * x} {b * y} {z}\n")
        for ring in range(3):
            for k in range(4):
                a, b = 4 * ring + k + 1, 4 * ring + (k + 1) % 4 + 1
                file.write(f"f {a} {b} {b + 4}\nf {a} {b + 4} {a + 4}\n")
        file.write("f 3 2 1\nf 4 3 1\nf 13 14 15\nf 13 15 16\n")
    return layouts.Model({"file": "bin.obj", "kind": "bin", "up_axis": "z", "scale_to_m": 1,
                          "size_m": "0.6 0.4 0.25", "bbox_min": "-0.3 -0.2 0",
                          "bbox_max": "0.3 0.2 0.25"}, path)


def place_in_bin(rng):
    return rng.uniform(-0.15, 0.15), rng.uniform(-0.08, 0.08)


def bin_layouts(layouts, models, out, bins):
    count, num_objects = map(int, bins.split("x"))
    box, small = write_bin(layouts, out), [m for m in models if m.size <= 0.3]
    for k in range(count):
        rng = random.Random(f"bin {k}")
        layout, top, centres = layouts.Layout(), 0.35, {}
        layout.add("bin", box, fixed=True, position=[0, 0, layouts.CLEAR],
                   rotation=list(layouts.IDENTITY))
        for i in range(num_objects):
            model = rng.choice(small)
            name, rotation = f"object_{i + 1:02d}", layouts.random_rotation(rng)
            centres[name] = place_in_bin(rng)
            layout.put(name, model, rotation, *centres[name], top)
            top += model.diagonal()
        yield f"bin_{k:02d}", layout.json, shifted_in_bin(f"again {k}", centres)


def prism(layouts, out, name, polygon, depth):
    """A convex polygon in xz, counter-clockwise, drawn out along y, as a model."""
    n, path = len(polygon), os.path.join(out, name + ".obj")
    rings = [list(range(1, n + 1)), list(range(2 * n, n, -1))]
    rings += [[i + 1, n + i + 1, n + (i + 1) % n + 1, (i + 1) % n + 1] for i in range(n)]
    with open(path, "w") as file:
        for y in (-depth / 2, depth / 2):
            for x, z in polygon:
                file.write(f"v {x:.9g} {y:.9g} {z:.9g}\n")
        for ring in rings:
            for k in range(1, len(ring) - 1):
                file.write(f"f {ring[0]} {ring[k]} {ring[k + 1]}\n")
    low, high = ([f(p[k] for p in polygon) for k in (0, 1)] for f in (min, max))
    box = [(low[0], -depth / 2, low[1]), (high[0], depth / 2, high[1])]
    text = [" ".join(map(str, corner)) for corner in box]
    size = " ".join(str(b - a) for a, b in zip(*box))
    return layouts.Model({"file": name + ".obj", "kind": "solid", "up_axis": "z", "scale_to_m": 1,
                          "size_m": size, "bbox_min": text[0], "bbox_max": text[1]}, path)


def solid_models(layouts, out):
    def rectangle(a, b):
        return [(-a / 2, -b / 2), (a / 2, -b / 2), (a / 2, b / 2), (-a / 2, b / 2)]

    def regular(radius, n):
        return [(radius * math.cos(2 * math.pi * k / n), radius * math.sin(2 * math.pi * k / n))
                for k in range(n)]
    wedge = [(-0.1, -0.04), (0.1, -0.04), (-0.1, 0.06)]
    return [prism(layouts, out, *solid) for solid in (
        ("brick", rectangle(0.2, 0.06), 0.1), ("cube", rectangle(0.1, 0.1), 0.1),
        ("slab", rectangle(0.25, 0.02), 0.2), ("hexagon", regular(0.06, 6), 0.12),
        ("wedge", wedge, 0.1), ("bar", rectangle(0.3, 0.03), 0.03),
        ("octagon", regular(0.07, 8), 0.04))]


def solid_layouts(layouts, out, solids):
    count, num_objects = map(int, solids.split("x"))
    models = solid_models(layouts, out)
    for k in range(count):
        rng, layout = random.Random(f"solid {k}"), layouts.Layout()
        for i in range(num_objects):
            layout.put(f"object_{i + 1:02d}", rng.choice(models), layouts.random_rotation(rng),
                       rng.uniform(-0.12, 0.12), rng.uniform(-0.12, 0.12), 0.3 * (i + 1))
        yield f"solid_{k:02d}", layout.json, None


def turned_about_centre(seed):
    """Puts an object of a heap again, with its start turned about the heap's axis."""
    rng = random.Random(seed)

    def again(put):
        half = math.pi * rng.random()
        c, s = math.cos(half), math.sin(half)
        x, y, z = put["position"]
        w, i, j, k = put["rotation"]
        cos, sin = c * c - s * s, 2 * c * s
        return {**put, "position": [cos * x - sin * y, sin * x + cos * y, z],
                "rotation": [c * w - s * k, c * i - s * j, c * j + s * i, c * k + s * w]}
    return again


def shifted_in_bin(seed, centres):
    """Puts an object of a bin again, elsewhere above the bin."""
    rng = random.Random(seed)

    def again(put):
        x, y, z = put["position"]
        old = centres[put["object"]]
        centres[put["object"]] = new = place_in_bin(rng)
        return {**put, "position": [x + new[0] - old[0], y + new[1] - old[1], z]}
    return again


def read_report(path):
    with open(path) as file:
        return json.load(file)


def comparable(report):
    """Part of a report that must be the same in every run."""
    report = {key: value for key, value in report.items()
              if key not in ("backend", "device", "work")}
    report["operations"] = [{key: value for key, value in operation.items()
                             if key != "milliseconds"} for operation in report["operations"]]
    return json.dumps(report)


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
    others += [(options.trivet, f"-{name}", ["--backend", name], name)
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
            same = same and other["backend"] == backend
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
    """Ways of the objects, in metres, while MuJoCo runs."""
    if not options.simulate:
        return []
    report = base + ".exported.json"
    done = subprocess.run([options.trivet, "export", scene, "-o", base + ".xml", "--report", report,
                           "--simulate", str(options.simulate), "--quiet"],
                          capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{base}: status {done.returncode}: {done.stderr}")
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
    return true == len(results) and not different and placed >= 0.98 * objects


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
    parser.add_argument("--tries", type=int, default=1, help="PUTs of an object that heaps and bins refuse")
    parser.add_argument("--same-as", help="another build of trivet to compare with")
    parser.add_argument("--threads", default="", help="numbers of threads to compare, comma-separated")
    parser.add_argument("--backends", default="", help="bvh, software, gpu, with commas")
    options = parser.parse_args()
    options.work = BackendWork()
    options.rules = ["--perfect-friction"] if not options.friction else \
        [] if options.whole else ["--objects-alone"]
    options.shared, options.out = os.path.abspath(options.shared), os.path.abspath(options.out)
    os.makedirs(options.out, exist_ok=True)
    layouts, models, args = read_models(options.shared, options.out)
    sets = {"floor": lambda: floor_layouts(layouts, models),
            "pair": lambda: pair_layouts(layouts, models),
            "pile": lambda: pile_layouts(layouts, models, args, options.heaps),
            "bin": lambda: bin_layouts(layouts, models, options.out, options.bins),
            "solid": lambda: solid_layouts(layouts, options.out, options.solids)}
    titles = {"floor": "80 models x 5 on the floor", "pair": "80 models x 5 on another model",
              "pile": f"heaps, {options.heaps} objects",
              "bin": f"bins, {options.bins} objects",
              "solid": f"solids, {options.solids} objects"}
    print("| scenes | number | placed | PUTs ok | true | findings | PUT ms median | p95 | max | differ |\n"
          "|---|---|---|---|---|---|---|---|---|---|")
    ok = [run_set(options, titles[name], sets[name]()) for name in options.set.split(",")]
    options.work.print()
    sys.exit(0 if all(ok) else 1)


if __name__ == "__main__":
    main()
