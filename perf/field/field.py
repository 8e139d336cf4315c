#!/usr/bin/env python3
"""Sets down the same objects by several engines and has `trivet check` judge where they lie. Prints Markdown.

    perf/field/field.py --trivet TRIVET --work DIR [--engines trivet,mujoco,bullet,NAME=COMMAND] [--kinds single,pair]

Engines: trivet; mujoco, rapier and jolt of npm; bullet and mujoco2, Debian's, which are programs of a build with tests; blender;
any other, see README.md. Cases: single objects, pairs, bins, heaps, a laid table, start states with errors; see cases.py.
Poses are judged after --seconds of simulation.
True: objects free of crossings, at rest within two clearances; within 0.1 mm: no crossing deeper, no gap below higher.
Drift: how far the farthest object moves in two more seconds, in the engine itself; for Trivet in MuJoCo, as it exports
the scene. CPU seconds include reading the models.
"""
import argparse
import json
import math
import os
import sys

import cases
import engines
import judge

sys.dont_write_bytecode = True
MORE_SECONDS = 2


def farthest_move(before, after):
    """Metres between the origins of the object that moved most."""
    return max((math.dist(before[name]["position"], after[name]["position"]) for name in before if name in after), default=0.0)


def drift(engine, case, folder, poses, watcher):
    """Metres; None where no engine can tell."""
    if isinstance(engine, engines.Trivet):
        if not watcher:
            return None
        file = os.path.join(folder, "rest", "scene.xml")
        os.makedirs(os.path.dirname(file), exist_ok=True)
        cases.run(engine.program, "export", os.path.join(folder, "trivet.glb"), "-o", file)
        after = watcher.running(MORE_SECONDS).settle(case, os.path.dirname(file))[0]
    else:
        after = engine.running(engine.seconds + MORE_SECONDS).settle(case, folder)[0]
    return farthest_move(poses, after)


def judged(engine, case, folder, arguments, watcher):
    poses, cpu = engine.settle(case, folder)
    engines.write_json(os.path.join(folder, engine.key + ".poses.json"), poses)
    wanted = sum(not o.get("fixed") for o in case.objects)
    row = judge.verdict(arguments.trivet, case.layout_with(poses), wanted)
    return dict(row, kind=case.kind, case=case.name, engine=engine.name, cpu_s=cpu,
                drift_m=drift(engine, case, folder, poses, watcher))


def total(rows):
    """A line of the table: of one engine and one kind."""
    add = {key: sum(r[key] for r in rows) for key in ("objects", "true", "close", "missing", "interpenetrating", "not_at_rest", "cpu_s")}
    drifts = [r["drift_m"] for r in rows if r["drift_m"] is not None]
    return (f"| {rows[0]['kind']} | {rows[0]['engine']} | {add['true']} of {add['objects']} | {add['close']} "
            f"| {add['interpenetrating']} "
            f"| {1e3 * max(r['deepest_m'] for r in rows):.3g} | {add['not_at_rest']} | {add['missing']} "
            f"| {f'{1e3 * max(drifts):.2g}' if drifts else '-'} | {add['cpu_s'] / len(rows):.2g} |")


def print_table(rows):
    print("| cases | engine | true | within 0.1 mm | interpenetrate | deepest, mm | not at rest | not set down | drift in 2 s, mm "
          "| CPU s per case |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|")
    for kind in dict.fromkeys(r["kind"] for r in rows):
        for engine in dict.fromkeys(r["engine"] for r in rows):
            found = [r for r in rows if (r["kind"], r["engine"]) == (kind, engine)]
            if found:
                print(total(found))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trivet", required=True, type=os.path.abspath)
    parser.add_argument("--work", required=True, type=os.path.abspath, help="folder for models, cases and poses")
    parser.add_argument("--engines", default="trivet,mujoco,rapier,jolt", type=lambda text: text.split(","))
    parser.add_argument("--programs", type=os.path.abspath, help="folder of bullet_rest and mujoco2_rest; default: tests of the build")
    parser.add_argument("--blender", default="blender", help="command that starts Blender")
    parser.add_argument("--kinds", default=",".join(cases.KINDS), type=lambda text: text.split(","))
    parser.add_argument("--most", type=int, help="most cases of each kind; default: all")
    parser.add_argument("--seconds", default=8, type=float, help="simulated, at most")
    parser.add_argument("--json", help="write all verdicts, too")
    arguments = parser.parse_args()
    unknown = set(arguments.kinds) - set(cases.KINDS)
    if unknown:
        raise SystemExit(f"--kinds: there is no '{min(unknown)}'; accepted: {', '.join(cases.KINDS)}")
    arguments.programs = arguments.programs or os.path.join(os.path.dirname(arguments.trivet), "..", "tests")
    os.makedirs(os.path.join(arguments.work, "models"), exist_ok=True)
    tried = list(engines.engines_of(arguments))
    watcher = next((e for e in tried if e.key == "mujoco"), None)
    rows = []
    for case in cases.all_cases(arguments.trivet, os.path.join(arguments.work, "models"), arguments.kinds):
        if arguments.most and int(case.name[-2:]) >= arguments.most:
            continue
        folder = os.path.join(arguments.work, case.name)
        os.makedirs(folder, exist_ok=True)
        engines.write_start(arguments.trivet, case, folder)
        for engine in tried:
            rows.append(judged(engine, case, folder, arguments, watcher))
            print(json.dumps(rows[-1]), file=sys.stderr)
    print_table(rows)
    if arguments.json:
        engines.write_json(arguments.json, rows)


if __name__ == "__main__":
    main()
