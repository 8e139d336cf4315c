#!/usr/bin/env python3
"""Judges poses by `trivet check`: exact crossings of the models' own triangles, rest within two clearances, balance.

    perf/field/judge.py --trivet TRIVET START.json POSES.json

START.json is a layout; POSES.json has anybody's poses of its objects, {NAME: {"position": [x, y, z], "rotation": [w, x, y,
z]}}. Prints the verdict as JSON. The same judge serves perf/field/field.py.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile


CLOSE = 1e-4  # metres: crossings and gaps that many would let pass


def check(trivet, layout):
    """The report of `trivet check` on a layout."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "poses.json")
        with open(path, "w") as file:
            json.dump(layout, file)
        done = subprocess.run([trivet, "check", path, "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"trivet check: status {done.returncode}: {done.stderr}{done.stdout}")
    return json.loads(done.stdout)


def verdict(trivet, layout, wanted):
    """Numbers of the moving objects, and metres. `true`: no crossing, and at rest; `close`: no crossing or gap over 0.1 mm.

    `wanted`: how many objects were to be set down.
    """
    report = check(trivet, layout)
    moving = {o["name"] for o in layout["objects"] if not o.get("fixed")}
    deep = dict.fromkeys(moving, 0.0)
    for pair in report["check"]["pairs"]:
        for name in {pair["a"], pair["b"]} & moving:
            deep[name] = max(deep[name], pair["depth"])
    crossing = {name for name in moving if deep[name] > 0}
    high = {h["name"]: h["height"] or 0.0 for h in report["check"].get("hovering", [])}
    restless = (set(report["check"]["not_at_rest"]) | set(report["stability"].get("topples", []))) & moving
    close = {name for name in moving if deep[name] <= CLOSE and high.get(name, 0.0) <= CLOSE}
    return {"objects": wanted, "true": len(moving - crossing - restless), "close": len(close),
            "interpenetrating": len(crossing), "deepest_m": max(deep.values(), default=0.0), "not_at_rest": len(restless),
            "hovering_m": max(high.values(), default=0.0), "missing": wanted - len(moving)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trivet", default="trivet")
    parser.add_argument("start")
    parser.add_argument("poses")
    arguments = parser.parse_args()
    with open(arguments.start) as file:
        layout = json.load(file)
    with open(arguments.poses) as file:
        poses = json.load(file)
    folder = os.path.dirname(os.path.abspath(arguments.start))
    wanted = sum(not o.get("fixed") for o in layout["objects"])
    layout["objects"] = [dict(o, model=os.path.join(folder, o["model"]), **poses.get(o["name"], {}))
                         for o in layout["objects"] if o.get("fixed") or o["name"] in poses]
    print(json.dumps(verdict(arguments.trivet, layout, wanted)))


if __name__ == "__main__":
    sys.exit(main())
