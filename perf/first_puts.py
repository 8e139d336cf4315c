#!/usr/bin/env python3
"""First and next PUTs of real models: a model's first PUT makes its trees.

    perf/first_puts.py --trivet build/release/apps/trivet --shared ../shared [--threads 1] [--every N] [--out DIR]

Every model is put onto the floor in four orientations, 10 sizes apart, in one layout. For each rule (perfect friction, each
object alone; the default, friction 0.5 and the whole at rest) two rows: the first PUT and the other three, milliseconds
by the clock: median, 95 %, longest.
"""
import argparse
import json
import os
import random
import statistics
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "referee"))
import campaign_sets  # noqa: E402

RULES = {"perfect friction": ["--perfect-friction"], "friction 0.5, whole at rest": []}
PUTS = 4


def milliseconds(options, name, model, layouts, rules):
    """Times of all PUTs; none if one was refused."""
    rng, layout = random.Random(name), layouts.Layout()
    for k in range(PUTS):
        layout.put(f"object_{k}", model, layouts.random_rotation(rng), 10 * model.diagonal() * k, 0, 0.1)
    base = os.path.join(options.out, name)
    with open(base + ".json", "w") as file:
        json.dump(layout.json, file)
    subprocess.run([options.trivet, "run", base + ".json", "-o", base + ".glb", "--report", base + ".report.json",
                    "--threads", str(options.threads), "--quiet", *rules], check=False, capture_output=True)
    with open(base + ".report.json") as file:
        operations = json.load(file)["operations"]
    return [o["milliseconds"] for o in operations] if all(o["status"] == "ok" for o in operations) else []


def row(rules, which, times):
    times = sorted(times)
    return (f"| {rules} | {which} | {len(times)} | {statistics.median(times):.2f} | "
            f"{times[int(0.95 * (len(times) - 1))]:.1f} | {times[-1]:.0f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trivet", required=True)
    parser.add_argument("--shared", required=True)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--every", type=int, default=1, help="every N-th model only")
    parser.add_argument("--out", default="out/first_puts")
    options = parser.parse_args()
    options.out = os.path.abspath(options.out)
    os.makedirs(options.out, exist_ok=True)
    layouts, models, _ = campaign_sets.read_models(os.path.abspath(options.shared), options.out)
    print("| rules | PUT | number | ms: median | 95 % | longest |\n|---|---|---|---|---|---|")
    for rules, arguments in RULES.items():
        runs = [milliseconds(options, f"model_{k:02d}", model, layouts, arguments)
                for k, model in enumerate(models[::options.every])]
        done = [times for times in runs if times]
        print(row(rules, "first of a model", [times[0] for times in done]))
        print(row(rules, "next", [t for times in done for t in times[1:]]), flush=True)


if __name__ == "__main__":
    main()
