#!/usr/bin/env python3
"""Engines start from given poses: test_starts.py SCENE.xml SECONDS PROGRAM...

The program is one that rest.mjs describes, without its arguments. The scene stands on the floor; a
metre aside and a millimetre up it falls, and comes to rest a metre aside.
"""
import json
import os
import subprocess
import sys
import tempfile

ASIDE, UP, NEAR = 1.0, 1e-3, 1e-3  # metres


def run(program, seconds, scene, worlds):
    with tempfile.TemporaryDirectory() as folder:
        starts = os.path.join(folder, "starts.jsonl")
        with open(starts, "w") as file:
            file.writelines(json.dumps(world) + "\n" for world in worlds)
        return subprocess.run([*program, seconds, "--starts", starts, scene], capture_output=True, text=True)


def main():
    scene, seconds, *program = sys.argv[1:]
    first = run(program, "0.01", scene, [{}])
    assert first.returncode == 0, first.stderr
    rest = {o["name"]: o for o in json.loads(first.stdout)["objects"]}
    assert len(rest) == 2, rest
    moved = {name: {"position": [o["position"][0] + ASIDE, o["position"][1], o["position"][2] + UP],
                    "rotation": o["rotation"]} for name, o in rest.items()}
    lines = [json.loads(line) for line in run(program, seconds, scene, [moved, {}]).stdout.splitlines()]
    assert len(lines) == 2, lines
    for shift, line in zip((ASIDE, 0), lines):
        for o in line["objects"]:
            for k, offset in enumerate((shift, 0, 0)):
                assert abs(o["position"][k] - rest[o["name"]]["position"][k] - offset) < NEAR, (shift, o)
            assert o["moved"] < 2 * UP and (o["moved"] > UP / 2) == (shift > 0), (shift, o)
    unknown = run(program, seconds, scene, [{"no such body": rest["spoon"]}])
    assert unknown.returncode != 0 and "no such body" in unknown.stderr, unknown


main()
