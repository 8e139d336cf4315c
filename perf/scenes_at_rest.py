#!/usr/bin/env python3
"""Start states before and after `trivet settle` or `mend`, as Trivet and MuJoCo judge them.

    perf/scenes_at_rest.py FOLDER [--program trivet] [--verb mend] [--node FOLDER_OF_node_modules] [--seconds 5]

Every .xml below FOLDER that is a whole MJCF scene with free bodies is judged, written beside itself in a temporary folder, and judged
again. With --node, MuJoCo of npm (@mujoco/mujoco) moves both for some seconds. Prints a table in Markdown; the last line has the sums."""
import argparse
import json
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

MOVED = 1e-3  # metres that count as moved


def run_json(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    lines = [line for line in done.stdout.splitlines() if line.startswith('{"')]
    if lines:
        return json.loads(lines[-1])
    # A refusal has several lines.
    return {"error": json.loads(done.stdout)["error"]["message"] if done.stdout else done.stderr.strip()}


def moved_by_mujoco(arguments, scene):
    if not arguments.node:
        return None
    script = Path(__file__).with_name("rest.mjs")
    done = subprocess.run(["node", str(Path(arguments.node) / script.name), str(arguments.seconds), str(scene)],
                          capture_output=True, text=True, timeout=600)
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    return json.loads(lines[-1]) if lines else {"error": done.stderr.strip()[-200:]}


def counted(answer):
    """Bodies that move by more than MOVED, and the farthest way in mm."""
    if answer is None or "moved" not in answer:
        return None, None
    ways = list(answer["moved"].values())
    return sum(way > MOVED for way in ways), 1000 * max(ways, default=0)


def kinds(verdict):
    found = [finding["kind"] for finding in verdict.get("findings", [])]
    return found.count("passes through"), len(found) - found.count("passes through")


def row(arguments, scene, work):
    before = run_json(arguments.program, "check", scene, "--json")
    if "error" in before or not before.get("free"):
        return None
    folder = work / "scene"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(scene.parent, folder)
    out = folder / ("after " + scene.name)
    begin = time.monotonic()
    report = run_json(arguments.program, arguments.verb, scene, "-o", out, "--seconds", 60, "--json")
    took = time.monotonic() - begin
    after = report.get("verdict", {})
    one = {"scene": scene.name, "free": before["free"], "in": kinds(before)[0], "else": kinds(before)[1],
           "ok": "yes" if after.get("ok") else "no: %d and %d" % kinds(after) if after else report.get("error", "?")[:60],
           "s": "%.2f" % took}
    if arguments.node:
        for when, file in (("before", scene), ("after", out)):
            one["moved " + when], way = counted(moved_by_mujoco(arguments, file) if file.exists() else None)
            one["mm " + when] = None if way is None else round(way, 2)
    return one


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--program", default="trivet")
    parser.add_argument("--verb", default="settle", choices=("settle", "mend"))
    parser.add_argument("--node", help="folder with node_modules/@mujoco/mujoco and a copy of rest.mjs")
    parser.add_argument("--seconds", type=float, default=5)
    arguments = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as work:
        for scene in sorted(arguments.folder.rglob("*.xml")):
            one = row(arguments, scene, Path(work))
            if one:
                rows.append(one)
    if not rows:
        sys.exit("no scenes with free bodies")
    names = list(rows[0])
    print("| " + " | ".join(names) + " |\n|" + " --- |" * len(names))
    for one in rows:
        print("| " + " | ".join("-" if one[name] is None else str(one[name]) for name in names) + " |")
    sums = {name: sum(one[name] or 0 for one in rows) for name in names if isinstance(rows[0][name], int)}
    print("\n%d scenes; " % len(rows) + ", ".join("%s %d" % item for item in sums.items()))


if __name__ == "__main__":
    main()
