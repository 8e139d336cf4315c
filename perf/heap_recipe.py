#!/usr/bin/env python3
"""Writes the recipe of a heap of 50 real models of ../shared/data, at most 0.6 m large, for trivet batch.

Usage: heap_recipe.py MODELS_DIR RECIPE.json [TRIES]     MODELS_DIR: ../shared/data/models, beside models.csv
TRIES: starts of each PUT; 12 without it.
"""
import csv
import json
import os
import sys


def main():
    folder, recipe = sys.argv[1:3]
    here = os.path.dirname(os.path.abspath(recipe))
    models = []
    with open(os.path.join(folder, "..", "models.csv"), newline="") as file:
        for row in csv.DictReader(file):
            if max(float(size) for size in row["size_m"].split()) > 0.6:
                continue
            models.append({"model": os.path.relpath(os.path.join(folder, row["file"]), here),
                           "scale": float(row["scale_to_m"]), "up": row["up_axis"]})
    group = {"name": "heap", "models": models, "count": 50, "rotation": "any",
             "heap": {"radius": 0.4, "height": 0.1, "rise": 0.1}}
    if len(sys.argv) > 3:
        group["tries"] = int(sys.argv[3])
    with open(recipe, "w") as file:
        json.dump({"trivet_recipe": 1, "groups": [group]}, file, indent=1)
    print("%d models" % len(models))


if __name__ == "__main__":
    main()
