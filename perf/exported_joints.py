#!/usr/bin/env python3
"""Exported cabinets in MuJoCo: whether their joints and what lies in them stay where they are.

    perf/exported_joints.py NODE_FOLDER [--program trivet] [--seconds 5] [--own]

NODE_FOLDER has node_modules/@mujoco/mujoco and a copy of rest.mjs. The cabinets are those of tests/apps/test_drawers.py, each with
its joints at their lower limits, open by a third, and at their upper limits, with things in and on it. With --own they are placed
in layouts of Trivet. Prints a table in Markdown."""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "tests/apps")]
import test_drawers  # noqa: E402

# Above the parts in which they are to lie when these are open by a third.
ABOVE = {"chest": [(0, -0.2, 0.45), (0.1, 0.1, 0.6), (-0.1, -0.22, 0.45), (-0.1, 0.1, 0.6)],
         "unit": [(0, -0.2, 0.36), (0.1, -0.2, 0.36), (-0.1, 0, 0.5), (0.5, 0.3, 0.1)],
         "wardrobe": [(0, 0, 0.3), (0.08, 0, 0.3), (-0.08, 0, 0.3), (0, 0.1, 0.7)]}
SHARES = {"lower": 0, "third": 1 / 3, "upper": 1}


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(done.stderr)
    return done.stdout


def states(program, body, folder):
    """Files of the cabinet, filled when open by a third."""
    cabinet = test_drawers.Cabinet(body)
    things = [one for one in cabinet.bodies if one.free]
    for thing, at in zip(things, ABOVE[body.name]):
        thing.at = at
    start = folder / "start.xml"
    start.write_text(test_drawers.Cabinet.text_of(body, things))
    joints = [json.loads(line) for line in run(program, "joint", start, "--json").splitlines()]

    def moved(scene, share, name):
        for number, joint in enumerate(joints):
            out = folder / ("%s %d.xml" % (name, number))
            value = joint["lower"] + share * (joint["upper"] - joint["lower"])
            run(program, "joint", scene, joint["joint"], "--to", value, "-o", out)
            scene = out
        return scene

    ajar = moved(start, SHARES["third"], "ajar")
    filled = folder / "filled.xml"
    run(program, "settle", ajar, "-o", filled)
    for name, share in SHARES.items():
        settled = folder / (name + " settled.xml")
        run(program, "settle", moved(filled, share, name), "-o", settled)
        yield name, settled


def own_states(program, body, folder):
    """The same as layouts, which open it by a third, fill it, and move its joints."""
    cabinet = test_drawers.Cabinet(body)
    things = [one for one in cabinet.bodies if one.free]
    (folder / "cabinet.xml").write_text(test_drawers.Cabinet.text_of(body, []))
    joints = [json.loads(line) for line in run(program, "joint", folder / "cabinet.xml", "--json").splitlines()]
    objects = [{"name": "cabinet", "articulation": "cabinet.xml", "position": [0, 0, 0]}]
    for thing in things:
        (folder / (thing.name + ".obj")).write_text(thing.obj())
        objects.append({"name": thing.name, "model": thing.name + ".obj"})

    def moves(share):
        return [{"op": "move_joint", "object": "cabinet/" + joint["links"][0],
                 "to": joint["lower"] + share * (joint["upper"] - joint["lower"])} for joint in joints]

    puts = [{"op": "put", "object": thing.name, "position": at} for thing, at in zip(things, ABOVE[body.name])]
    for name, share in SHARES.items():
        layout = {"trivet": 1, "objects": objects, "operations": moves(SHARES["third"]) + puts + moves(share)}
        (folder / "layout.json").write_text(json.dumps(layout))
        run(program, "run", folder / "layout.json", "-o", folder / (name + ".glb"))
        yield name, folder / (name + ".glb")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("node", type=Path)
    parser.add_argument("--program", default="trivet")
    parser.add_argument("--seconds", type=float, default=5)
    parser.add_argument("--own", action="store_true")
    arguments = parser.parse_args()
    print("| cabinet | joints at | true | free bodies | farthest, mm | joints | most, mm or mrad |")
    print("|---|---|---|--:|--:|--:|--:|")
    for make in (test_drawers.chest, test_drawers.unit, test_drawers.wardrobe):
        body = make()
        with tempfile.TemporaryDirectory() as work:
            folder = Path(work)
            for name, scene in (own_states if arguments.own else states)(arguments.program, body, folder):
                verdict = json.loads(run(arguments.program, "check", scene, "--json"))
                exported = folder / name / "scene.xml"
                exported.parent.mkdir()
                run(arguments.program, "export", scene, "-o", exported)
                done = subprocess.run(["node", arguments.node / "rest.mjs", str(arguments.seconds), exported],
                                      capture_output=True, text=True)
                answer = json.loads(done.stdout)
                moved, joints = answer["moved"].values(), answer["joints"].values()
                print("| %s | %s | %s | %d | %.2f | %d | %.2f |" % (
                    body.name, name, "yes" if verdict["ok"] else "no", len(moved), 1000 * max(moved), len(joints),
                    1000 * max(map(abs, joints))))


if __name__ == "__main__":
    main()
