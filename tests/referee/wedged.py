#!/usr/bin/env python3
"""PUTs of real models that are refused as wedged, or as what would topple, although they rest there.

    tests/referee/wedged.py --trivet build/release/apps/trivet --referee PATH/referee --shared ../shared
        [--set floor,pair,bin] [--bins 20x10] [--friction 0.5,0.3] [--every N] [--out DIR]

Every PUT of the campaign's sets (1,000 by default) is made from exactly its start. Where it is refused as wedged, the
layout is run again up to it with --accept-wedged: the object then stays at the very pose that was refused. `trivet check`
and the referee judge that scene as a whole at the same friction. Exit status 1 if a refused pose is accepted by both.
"""
import argparse
import json
import os
import subprocess
import sys

import campaign_sets


def run(trivet, layout, base, *options):
    with open(base + ".json", "w") as file:
        json.dump(layout, file)
    subprocess.run([trivet, "run", base + ".json", "-o", base + ".glb", "--report", base + ".report.json", "--quiet",
                    "--threads", "1", *options], check=False, capture_output=True)
    with open(base + ".report.json") as file:
        return json.load(file)


def accepts(options, base, friction):
    """Verdicts of check and of the referee on the scene of `base`: true if accepted."""
    check = subprocess.run([options.trivet, "check", base + ".glb", "--quiet", "--friction", str(friction)],
                           check=False, capture_output=True)
    referee = subprocess.run([options.referee, base + ".report.json", "--layout", base + ".json", "--scene",
                              base + ".glb", "--mu", str(friction), "--whole"], check=False, capture_output=True)
    return check.returncode == 0, referee.returncode == 0


def judge(options, name, layout, friction):
    """Numbers of PUTs, of those refused as wedged, and of these accepted by check, by the referee, by both."""
    puts = [o for o in layout["operations"] if o["op"] == "put"]
    layout = {**layout, "material": {"friction": friction}, "operations": [{**o, "tries": 1} for o in puts]}
    base = os.path.join(options.out, f"{name}-{friction}")
    report = run(options.trivet, layout, base)
    counts = [len(puts), 0, 0, 0, 0]
    for k, done in enumerate(report["operations"]):
        if done.get("cause") != "wedged":
            continue
        before = [o for o, r in zip(layout["operations"][:k], report["operations"]) if r["status"] == "ok"]
        operations = before + [layout["operations"][k]]
        names = {o["object"] for o in operations}
        objects = [o for o in layout["objects"] if "position" in o or o["name"] in names]
        again = f"{base}-{k}"
        redone = run(options.trivet, {**layout, "objects": objects, "operations": operations}, again, "--accept-wedged")
        by_check, by_referee = accepts(options, again, friction)
        if redone["operations"][-1]["status"] != "ok":
            by_check = by_referee = False
        counts = [a + b for a, b in zip(counts, [0, 1, by_check, by_referee, by_check and by_referee])]
        print(f"  {name}: {done['reason']}; check {by_check}, referee {by_referee}", file=sys.stderr)
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trivet", required=True)
    parser.add_argument("--referee", required=True)
    parser.add_argument("--shared", required=True)
    parser.add_argument("--set", default="floor,pair,bin")
    parser.add_argument("--bins", default="20x10")
    parser.add_argument("--friction", default="0.5")
    parser.add_argument("--every", type=int, default=1, help="every N-th scene only")
    parser.add_argument("--out", default="out/wedged")
    options = parser.parse_args()
    options.shared, options.out = os.path.abspath(options.shared), os.path.abspath(options.out)
    options.heaps, options.solids = "1x30", "1x8"
    os.makedirs(options.out, exist_ok=True)
    print("| scenes | friction | PUTs | refused as wedged | accepted by check | by the referee | by both |\n" + "|---" * 7 + "|")
    good = True
    for friction in map(float, options.friction.split(",")):
        sets = campaign_sets.sets_of(options)
        for kind in options.set.split(","):
            title, layouts = sets[kind]
            rows = [judge(options, name, layout, friction) for name, layout, _ in list(layouts)[::options.every]]
            sums = [sum(column) for column in zip(*rows)]
            print(f"| {title} | {friction} | " + " | ".join(map(str, sums)) + " |", flush=True)
            good = good and sums[4] == 0
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
