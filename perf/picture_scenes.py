#!/usr/bin/env python3
"""Writes layouts of real models of ../shared/data for trivet_perf_pictures: a heap of 50, and 1,000 objects in rows.

Usage: picture_scenes.py MODELS_DIR FOLDER     writes FOLDER/heap.json and FOLDER/thousand.json, to be run by `trivet run`
"""
import csv
import json
import math
import os
import random
import sys

HEAPED = ("ycb_mug.obj", "ycb_bowl.obj", "ycb_banana.obj", "gso_screwdriver.obj", "gso_silver_tape.obj",
          "sh3d_by_spoon.obj", "sh3d_c0_woodToy.obj", "sh3d_by_rubix2.obj", "sh3d_s_cup.obj", "gso_hammer.obj")
IN_ROWS = ("libero_plate.obj", "gazebo_plastic_cup.obj", "sh3d_by_knife.obj", "sh3d_by_spoon.obj", "sh3d_c0_woodToy.obj",
           "sh3d_c0_cissors_swap.obj", "gso_silver_tape.obj", "sh3d_c0_bread.obj", "sh3d_s_pencil1.obj", "ripc_nut-big.obj")
COLUMNS, SPACING = 40, 0.3


def numbers(text):
    return [float(part) for part in text.split()]


def described(folder, name, model):
    return {"name": name, "model": os.path.join(os.path.abspath(folder), model["file"]),
            "scale": float(model["scale_to_m"]), "up": model["up_axis"]}


def any_rotation(source):
    """Even over all rotations, by the normal distribution."""
    q = [source.gauss(0, 1) for _ in range(4)]
    return [x / math.sqrt(sum(y * y for y in q)) for x in q]


def heap(folder, models):
    source = random.Random(1)
    objects, operations = [], []
    for i in range(50):
        name = "object_%d" % i
        objects.append(described(folder, name, models[HEAPED[i % len(HEAPED)]]))
        operations.append({"op": "put", "object": name, "rotation": any_rotation(source),
                           "position": [source.uniform(-.15, .15), source.uniform(-.15, .15), 0.5 + 0.02 * i]})
    return {"trivet": 1, "objects": objects, "operations": operations}


def rows(folder, models):
    objects = []
    for i in range(1000):
        model = models[IN_ROWS[i * 7 % len(IN_ROWS)]]
        scale, least = float(model["scale_to_m"]), numbers(model["bbox_min"])
        most = numbers(model["bbox_max"])
        # y up becomes z up: (x, -z, y).
        if model["up_axis"] == "y":
            least, most = [least[0], -most[2], least[1]], [most[0], -least[2], most[1]]
        middle = [(a + b) / 2 * scale for a, b in zip(least, most)]
        entry = described(folder, "object_%d" % i, model)
        entry["position"] = [SPACING * (i % COLUMNS) - middle[0], SPACING * (i // COLUMNS) - middle[1], 1e-5 - least[2] * scale]
        objects.append(entry)
    return {"trivet": 1, "objects": objects, "operations": []}


def main():
    folder, out = sys.argv[1:]
    with open(os.path.join(folder, "..", "models.csv"), newline="") as file:
        models = {row["file"]: row for row in csv.DictReader(file)}
    os.makedirs(out, exist_ok=True)
    for name, make in (("heap", heap), ("thousand", rows)):
        with open(os.path.join(out, name + ".json"), "w") as file:
            json.dump(make(folder, models), file, indent=1)


if __name__ == "__main__":
    main()
