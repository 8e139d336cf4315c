#!/usr/bin/env python3
"""Tells which scenes rest in which simulator: exported scenes, for some seconds, in each engine.

    matrix.py --trivet TRIVET --work DIR --engines mujoco2,mujoco,rapier,jolt,bullet
              [--programs DIR] [--scenes DIR | --demos NAME,...] [--seconds 5] [--csv FILE] [--bars] [--settled 8]

The folder of --work has the modules of ../package.json, that of --programs bullet_rest and
mujoco2_rest, which is Debian's MuJoCo. --scenes takes all scenes (*.glb) of a folder instead of the demos. A row says how many
objects stayed within 1 mm, within 2 mm and 2 degrees, and within 1 cm, by the farthest corner of
their parts; how deep parts overlap at the start; and steps per CPU second, of the engine alone. Warnings are those that an
engine counts, and all lines that it and its loader print. A scene that is not exported counts with its objects, none of which
stays. --settled: beside them the same objects, lifted by LIFT and settled by the engine itself for so many seconds first, and
the CPU seconds of that. The last lines are sums, a table in Markdown.
--bars: exit status 1 if an engine does not start from given poses (test_starts.py), warns, or keeps fewer than it must (BARS), over all scenes.
"""
import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

HERE = os.path.dirname(os.path.abspath(__file__))
DEMOS = ("spoon-saucer,breakfast,office1,office2,office3,table-for-six,tight-table,bookcase,market,"
         "workshop,kitchen").split(",")
BARS = (98, 100)  # percent of objects within 1 mm, and within 2 mm and 2 degrees
IN_CPP = ("bullet", "mujoco2")
LIFT = 0.005  # metres
COLUMNS = ("simulator", "scene", "objects", "parts", "within_1mm", "within_2mm_2deg", "within_1cm", "farthest_mm",
           "farthest", "penetration_um", "steps_per_cpu_second", "settle_cpu_seconds", "warnings")


def run(*command, cwd=None):
    done = subprocess.run(command, capture_output=True, text=True, cwd=cwd)
    if done.returncode != 0:
        raise SystemExit("%s: %s" % (" ".join(command), done.stderr))
    return done


def scenes_of(arguments):
    """Paths of .glb scenes, by name."""
    if arguments.scenes:
        return {name[:-4]: os.path.join(arguments.scenes, name)
                for name in sorted(os.listdir(arguments.scenes)) if name.endswith(".glb")}
    out = {}
    for name in arguments.demos.split(","):
        out[name] = os.path.join(arguments.work, name + ".glb")
        run(arguments.trivet, "demo", name, "-o", out[name], "--quiet")
    return out


written = set()  # by this run: engines share files


def exported(arguments, glb, name, *options):
    file = os.path.join(arguments.work, name)
    if file not in written:
        run(arguments.trivet, "export", glb, "-o", file, "--quiet", *options)
    written.add(file)
    return file


def program_of(arguments, engine):
    return ["node", "rest.mjs", engine] if engine not in IN_CPP else [os.path.join(arguments.programs, engine + "_rest")]


def in_engine(arguments, engine, glb, name):
    """Lines of an engine's program, which rest.mjs describes."""
    try:
        file = (exported(arguments, glb, name + ".mujoco2.xml", "--mujoco", "2") if engine == "mujoco2"
                else exported(arguments, glb, name + ".xml"))
    except SystemExit as refused:
        print(refused, file=sys.stderr)
        rows = list(csv.DictReader(open(exported(arguments, glb, name + ".csv"), newline="")))
        lost = [{"name": r["name"], "moved": float("inf"), "turned_deg": 180} for r in rows if r["fixed"] == "false" and r["x"]]
        return [{"simulator": engine, "scene": name + ", not exported", "objects": lost, "hulls": 0, "penetration": 0,
                 "steps_per_cpu_second": 0, "warnings": 0}]
    lines = [in_program(arguments, engine, file, arguments.seconds)]
    if arguments.settled:
        lifted = starts_file(arguments, [lifted_starts(file)])
        rest = in_program(arguments, engine, file, arguments.settled, "--starts", lifted)
        own = starts_file(arguments, [{o["name"]: {"position": o["position"], "rotation": o["rotation"]} for o in rest["objects"]}])
        line = in_program(arguments, engine, file, arguments.seconds, "--starts", own)
        lines.append(dict(line, simulator=line["simulator"] + ", settled by itself", settle_cpu_seconds=rest["cpu_seconds"]))
    return [dict(line, scene=name) for line in lines]


def in_program(arguments, engine, file, seconds, *starts):
    done = run(*program_of(arguments, engine), seconds, *starts, file, cwd=arguments.work)
    *printed, last = done.stdout.splitlines()
    printed += done.stderr.splitlines()
    for text in printed:
        print("%s: %s" % (engine, text), file=sys.stderr)
    line = json.loads(last)
    return dict(line, warnings=line["warnings"] + len(printed))


def starts_file(arguments, worlds):
    path = os.path.join(arguments.work, "starts.jsonl")
    with open(path, "w") as file:
        file.writelines(json.dumps(world) + "\n" for world in worlds)
    return path


def lifted_starts(file):
    """Poses of free bodies of an exported scene, all higher."""
    out = {}
    for body in ElementTree.parse(file).getroot().find("worldbody").findall("body"):
        if body.find("freejoint") is not None:
            x, y, z = map(float, body.get("pos").split())
            out[body.get("name")] = {"position": [x, y, z + LIFT], "rotation": list(map(float, body.get("quat").split()))}
    return out


def check_starts(arguments):
    """The small demo, from other poses."""
    for engine in arguments.engines.split(","):
        file = os.path.join(arguments.work, "spoon-saucer" + (".mujoco2.xml" if engine == "mujoco2" else ".xml"))
        run("python3", "-B", os.path.join(HERE, "test_starts.py"), file, "1", *program_of(arguments, engine),
            cwd=arguments.work)


def row_of(line):
    objects = line["objects"]
    farthest = max(objects, key=lambda o: o["moved"], default={"moved": 0, "name": ""})
    return {"simulator": line["simulator"], "scene": line["scene"], "objects": len(objects), "parts": line["hulls"],
            "within_1mm": sum(o["moved"] <= 1e-3 for o in objects),
            "within_2mm_2deg": sum(o["moved"] <= 2e-3 and o["turned_deg"] <= 2 for o in objects),
            "within_1cm": sum(o["moved"] <= 1e-2 for o in objects),
            "farthest_mm": "%.3f" % (1e3 * farthest["moved"]), "farthest": farthest["name"],
            "penetration_um": "%.2f" % (1e6 * line["penetration"]),
            "steps_per_cpu_second": line["steps_per_cpu_second"],
            "settle_cpu_seconds": "%.2f" % line["settle_cpu_seconds"] if "settle_cpu_seconds" in line else "",
            "warnings": line["warnings"]}


def print_sums(rows):
    """A table in Markdown, a row for each simulator; steps are the median of the scenes."""
    print("| engine | scenes | objects | within 1 mm | within 2 mm and 2 degrees | within 1 cm | deepest, um | steps per CPU s | "
          "settled in CPU s | warnings |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
    for simulator in dict.fromkeys(row["simulator"] for row in rows):
        of = [row for row in rows if row["simulator"] == simulator]
        steps = sorted(row["steps_per_cpu_second"] for row in of)
        settling = sum(float(row["settle_cpu_seconds"] or 0) for row in of)
        print("| %s | %d | %s | %.1f | %d | %s | %d |" % (
            simulator, len(of),
            " | ".join(str(sum(row[c] for row in of)) for c in ("objects", "within_1mm", "within_2mm_2deg", "within_1cm")),
            max(float(row["penetration_um"]) for row in of), steps[len(steps) // 2], "%.1f" % settling if settling else "",
            sum(row["warnings"] for row in of)))


def missed_bars(by_engine):
    """Sentences about engines that keep too little."""
    for rows in by_engine.values():
        num = sum(row["objects"] for row in rows)
        for column, least in zip(("within_1mm", "within_2mm_2deg"), BARS):
            kept = sum(row[column] for row in rows)
            if 100 * kept < least * num:
                yield "%s: %d of %d objects %s, less than %d %%" % (rows[0]["simulator"], kept, num, column, least)
        if any(row["warnings"] for row in rows):
            yield "%s warned" % rows[0]["simulator"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trivet", required=True, type=os.path.abspath)
    parser.add_argument("--work", required=True, type=os.path.abspath)
    parser.add_argument("--engines", required=True)
    parser.add_argument("--programs", type=os.path.abspath)
    parser.add_argument("--scenes")
    parser.add_argument("--demos", default=",".join(DEMOS))
    parser.add_argument("--seconds", default="5")
    parser.add_argument("--csv")
    parser.add_argument("--settled", help="seconds")
    parser.add_argument("--bars", action="store_true")
    arguments = parser.parse_args()
    for name in os.listdir(HERE):
        if name.endswith(".mjs"):  # modules are resolved relative to scripts
            shutil.copy(os.path.join(HERE, name), arguments.work)
    by_engine, rows, names = {}, [], {}
    for name, glb in scenes_of(arguments).items():
        for engine in arguments.engines.split(","):
            for row in map(row_of, in_engine(arguments, engine, glb, name)):
                print("%(simulator)s: %(scene)s: of %(objects)d objects %(within_1mm)d within 1 mm, %(within_2mm_2deg)d "
                      "within 2 mm and 2 degrees, %(within_1cm)d within 1 cm; farthest %(farthest)s %(farthest_mm)s mm; "
                      "%(parts)d parts, %(penetration_um)s um deep, %(steps_per_cpu_second)d steps per CPU second" % row,
                      flush=True)
                if "settled by itself" not in row["simulator"]:
                    by_engine.setdefault(engine, []).append(row)
                if row["parts"]:
                    names.setdefault(engine, row["simulator"])
                rows.append(row)
    for row in rows:  # of scenes that were not exported
        row["simulator"] = names.get(row["simulator"], row["simulator"])
    print_sums(rows)
    if arguments.csv:
        with open(arguments.csv, "w", newline="") as file:
            writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    if arguments.bars:
        check_starts(arguments)
    missed = list(missed_bars(by_engine)) if arguments.bars else []
    print("\n".join(missed), file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
