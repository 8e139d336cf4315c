#!/usr/bin/env python3
"""Mending of perturbed scenes: which share of "rests on" comes back, how far objects move. Markdown.

    perf/mend_noise.py TRIVET [--demos breakfast bookcase@3 ...] [--heaps 10 20 ...] [--scenes FILE.glb ...] [--noise 1 5 20]
                       [--runs 1] [--node FOLDER] [--lost]

A demo with a number behind @ is the arrangement by that seed. A heap has so many things of a breakfast in any orientation.

Every free object of a demo is moved by a normal deviate on each axis (mm) and turned about a random axis (1, 3 and 10 degrees at 1, 5
and 20 mm), by itself: not with what carries it. Then the scene is mended, judged, and its supports are compared with those that it had. The scenes are driven by
`trivet mcp`. With --node, a folder with node_modules/@mujoco/mujoco and a copy of rest.mjs, MuJoCo moves the same bad states for 2 s;
there a support counts as kept if the two touch or are in each other at the end. "Near" is the share of objects that are moved by
no more than twice the median length of the noise. --lost names the supports that got lost."""
import argparse
import json
import math
import os
import pathlib
import random
import re
import shutil
import statistics
import subprocess
import sys
import tarfile
import tempfile

DEGREES = {1: 1, 5: 3, 20: 10}
SECONDS = 300  # of a mending, at most
TIPPED = 45  # degrees
IN_THE_AIR = 100  # metres, from one to the next
MEDIAN_LENGTH = 1.54  # of a shift whose three parts are normal with a deviation of 1
IN_HEAPS = ["apple", "banana", "cup", "egg", "egg_cup", "glass", "jug", "loaf", "saucer", "spoon", "toast"]


class Agent:
    def __init__(self, program, folder):
        self.server = subprocess.Popen([program, "mcp", folder, "--operation-seconds", str(SECONDS)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def call(self, tool, **arguments):
        request = {"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": {"name": tool, "arguments": arguments}}
        print(json.dumps(request), file=self.server.stdin, flush=True)
        result = json.loads(self.server.stdout.readline())["result"]
        if result["isError"]:
            raise SystemExit(tool + ": " + result["content"][0]["text"])
        return result.get("structuredContent")

    def processor_seconds(self):
        with open("/proc/%d/stat" % self.server.pid) as file:
            user, system = file.read().rsplit(")", 1)[1].split()[11:13]
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")

    def objects(self):
        out, count = [], 1
        while len(out) < count:
            data = self.call("list", first=len(out))
            out, count = out + data["objects"], data["count"]
        return {one["object"]: one for one in out}


def make_demo(program, name, folder):
    demo, _, seed = name.partition("@")
    subprocess.run([program, "demo", demo, *(["--seed", seed] if seed else []), "-o", f"{folder}/{name}.glb", "--quiet"], check=True)


def make_heap(program, size, folder):
    """Things of the demo BREAKFAST, let fall onto the floor and onto each other."""
    name, models = "heap-%d" % size, pathlib.Path(folder) / "models"
    subprocess.run([program, "demo", "breakfast", "-o", f"{folder}/export.glb", "--export", str(models), "--quiet"], check=True)
    found = [{"model": file.name} for file in sorted(models.iterdir()) if file.stem in IN_HEAPS and file.suffix != ".json"]
    group = {"name": "heap", "models": found, "count": size, "rotation": "any",
             "heap": {"radius": 0.02 * size ** 0.5, "height": 0.1, "rise": 0.1}}
    (models / "heap.json").write_text(json.dumps({"trivet_recipe": 1, "groups": [group]}))
    out = pathlib.Path(folder) / (name + " batch")
    subprocess.run([program, "batch", str(models / "heap.json"), "--count", "1", "--with", "scene", "--jobs", "1", "--out", str(out)],
                   check=True, stdout=subprocess.DEVNULL)
    with tarfile.open(next(out.rglob("*.tar"))) as tar:
        scene = next(member for member in tar.getmembers() if member.name.endswith(".glb"))
        (pathlib.Path(folder) / (name + ".glb")).write_bytes(tar.extractfile(scene).read())
    return name


def perturb(agent, free, noise, generator):
    # Moves take loads along. So all go into the air first, each to a height of its own, where none touches another, and come
    # back one by one: each is moved by its own noise alone.
    for k, name in enumerate(free):
        here = agent.objects()[name]["lower"][2]
        agent.call("translate", object=name, by=[0, 0, IN_THE_AIR * (k + 1) - here], free=True, settle_left=False)
    high = agent.objects()
    for name, one in free.items():
        back = [a - b + generator.gauss(0, noise / 1000) for a, b in zip(one["lower"], high[name]["lower"])]
        axis = [generator.gauss(0, 1) for _ in range(3)]
        agent.call("rotate", object=name, axis=axis, angle_deg=generator.gauss(0, DEGREES.get(noise, noise / 2)),
                   centre=middle_of(high[name]), free=True, settle_left=False)
        agent.call("translate", object=name, by=back, free=True, settle_left=False)


def middle_of(one):
    return [(a + b) / 2 for a, b in zip(one["lower"], one["upper"])]


def edges(objects):
    return {(name, below) for name, one in objects.items() if one["state"] != "fixed" for below in one.get("on", [])}


def poses_of(program, scene):
    """By name: position and quaternion."""
    table = scene.with_suffix(".jsonl")
    subprocess.run([program, "export", str(scene), "-o", str(table), "--quiet"], check=True)
    rows = [json.loads(line) for line in table.read_text().splitlines()]
    return {row["name"]: [row[key] for key in ("x", "y", "z", "qw", "qx", "qy", "qz")] for row in rows if not row["fixed"]}


def with_poses(xml, poses):
    """The same MJCF with bodies elsewhere, and without the keyframe that says where they were laid out."""
    def moved(match):
        pose = poses.get(match.group(2))
        return match.group(0) if pose is None else '%s" pos="%s" quat="%s">' % (
            match.group(1), " ".join(map(repr, pose[:3])), " ".join(map(repr, pose[3:])))
    xml = re.sub(r'(<body name="([^"]*))" pos="[^"]*" quat="[^"]*">', moved, xml)
    return re.sub(r"<keyframe>.*</keyframe>", "", xml, flags=re.DOTALL)


def turned(a, b):
    return 2 * math.degrees(math.acos(min(1, abs(sum(x * y for x, y in zip(a[3:], b[3:]))))))


def by_mujoco(program, node, folder, scene, bad, edges_before):
    """The bad state, moved by MuJoCo for 2 s: supports kept, objects tipped, ways in mm."""
    work = pathlib.Path(folder) / "mujoco"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir()
    subprocess.run([program, "export", str(scene), "-o", str(work / "true.xml"), "--quiet"], check=True)
    xml, start = (work / "true.xml").read_text(), poses_of(program, bad)
    (work / "bad.xml").write_text(with_poses(xml, start))
    answer = subprocess.run(["node", str(pathlib.Path(node) / "rest.mjs"), "2", str(work / "bad.xml")], capture_output=True, text=True)
    end = json.loads(answer.stdout.splitlines()[-1])["end"]
    (work / "end.xml").write_text(with_poses(xml, end))
    check = subprocess.run([program, "check", str(work / "end.xml"), "--json"], capture_output=True, text=True)
    verdict = json.loads(check.stdout.splitlines()[-1])
    near = {frozenset((one["object"], one["other"])) for one in verdict["touching"] + verdict["findings"] if one.get("other")}
    return {"mj kept": sum(frozenset(edge) in near for edge in edges_before),
            "mj tipped": sum(turned(start[name], pose) > TIPPED for name, pose in end.items()),
            "mj ways": [1000 * math.dist(start[name][:3], pose[:3]) for name, pose in end.items()]}


def run(arguments, folder, demo, noise, seed):
    program = arguments.program
    agent = Agent(program, folder)
    agent.call("open", file=demo + ".glb")
    before = agent.objects()
    free = {name: one for name, one in before.items() if one["state"] not in ("fixed", "unplaced")}
    perturb(agent, free, noise, random.Random(seed))
    bad = pathlib.Path(folder) / ("bad %s %d %d.glb" % (demo, noise, seed))
    agent.call("save", file=bad.name)
    begin = agent.processor_seconds()
    mended = agent.call("mend", seconds=SECONDS)
    seconds = agent.processor_seconds() - begin
    verdict = agent.call("check")
    after = agent.objects()
    kept = edges(before) & edges(after)
    if arguments.lost:
        for name, below in sorted(edges(before) - kept):
            print("%s, %d mm, run %d: %s was on %s, is on %s" % (demo, noise, seed, name, below, ", ".join(after[name].get("on", []))),
                  file=sys.stderr)
    agent.server.stdin.close()
    agent.server.wait()
    ways = [1000 * one["metres"] for one in mended["moved"]]
    far = sum(way > 2 * MEDIAN_LENGTH * noise for way in ways)
    out = {"kept": len(kept), "edges": len(edges(before)), "free": len(free), "unable": len(mended["unable"]),
           "tipped": sum(one["degrees"] > TIPPED for one in mended["moved"]), "true": verdict["ok"], "far": far, "ways": ways, "seconds": seconds}
    if arguments.node:
        out.update(by_mujoco(program, arguments.node, folder, pathlib.Path(folder) / (demo + ".glb"), bad, edges(before)))
    return out


def text_of_ways(ways):
    return "%.1f, %.0f" % (statistics.median(ways), max(ways)) if ways else "-"


def row(arguments, demo, noise, runs):
    total = {key: sum(one[key] for one in runs) for key in runs[0] if not key.endswith("ways")}
    cells = [demo, noise, total["free"], "%d of %d" % (total["kept"], total["edges"]), "%.3f" % (total["kept"] / total["edges"]),
             total["unable"], total["tipped"], "%d of %d" % (total["true"], len(runs)),
             text_of_ways([way for one in runs for way in one["ways"]]), "%.2f" % (1 - total["far"] / total["free"]), "%.3f" % (total["seconds"] / total["free"])]
    if arguments.node:
        cells += ["%.3f" % (total["mj kept"] / total["edges"]), total["mj tipped"],
                  text_of_ways([way for one in runs for way in one["mj ways"]])]
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--demos", nargs="*", default=["breakfast", "office1", "office2"])
    parser.add_argument("--heaps", nargs="*", default=[], type=int, help="objects in each")
    parser.add_argument("--lost", action="store_true")
    parser.add_argument("--scenes", nargs="+", default=[], type=pathlib.Path, help=".glb files written by trivet")
    parser.add_argument("--noise", nargs="+", type=int, default=[1, 5, 20])
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--node", help="folder with node_modules/@mujoco/mujoco and a copy of rest.mjs")
    arguments = parser.parse_args()
    heads = ["scene", "noise, mm", "free", "kept", "share", "no place", "tipped", "true", "moved median, largest, mm", "near", "CPU s an object"]
    if arguments.node:
        heads += ["MuJoCo: share kept", "tipped", "moved median, largest, mm"]
    print("| " + " | ".join(heads) + " |\n|---|" + "--:|" * (len(heads) - 1))
    with tempfile.TemporaryDirectory() as folder:
        for demo in arguments.demos:
            make_demo(arguments.program, demo, folder)
        heaps = [make_heap(arguments.program, size, folder) for size in arguments.heaps]
        for scene in arguments.scenes:
            shutil.copy(scene, folder)
        for name in arguments.demos + heaps + [scene.stem for scene in arguments.scenes]:
            for noise in arguments.noise:
                row(arguments, name, noise, [run(arguments, folder, name, noise, seed) for seed in range(1, arguments.runs + 1)])


if __name__ == "__main__":
    main()
