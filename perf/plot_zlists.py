#!/usr/bin/env python3
"""Plots the z-lists' part of trivet_perf: time over triangles, and over the resolution of the image.

    trivet_perf --only zlists --out FOLDER && python3 perf/plot_zlists.py FOLDER/*-zlists.csv

Writes the .svg beside the .csv. With --cpu, processor times (of all threads) instead of those on the
wall: for runs on a machine that had other work. Needs python3-matplotlib.
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

MOTIONS = {"drop": "drop", "turn": "quarter turn"}
RESOLUTIONS = (128, 256, 512, 1024)
# Colours distinguishable for the colour-blind [Okabe 2008].
STYLE = {"box trees": ("#000000", "o"), "software, 1 thread": ("#0072B2", "s"),
         "software, 2 threads": ("#56B4E9", "D"), "GPU min/max": ("#E69F00", "^"),
         "GPU lists": ("#D55E00", "v"), "GPU lists, OpenGL 3.3": ("#CC79A7", "<"),  # before 0.2
         "framebuffers, depths": ("#E69F00", "^"), "framebuffers": ("#D55E00", "v"),
         "framebuffers, software lists": ("#009E73", "P"), "compute": ("#CC79A7", "<")}


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for key in row:
            if key not in ("motion", "method"):
                row[key] = float(row[key])
    return rows


def series(rows, x, **wanted):
    found = sorted((row[x], row["time"]) for row in rows
                   if all(row[key] == value for key, value in wanted.items()))
    return [p[0] for p in found], [p[1] for p in found]


def draw(axes, points, method, label, **style):
    if points[0]:
        colour, marker = STYLE[method]
        axes.plot(*points, color=colour, marker=marker, markersize=4, linewidth=1.4, label=label,
                  **style)


def over_triangles(axes, rows, motion):
    for method in STYLE:
        if method.startswith(("GPU", "framebuffers", "compute")):
            at = {128: "-", 1024: ":"}
        else:
            at = {0: "-"}
        for resolution, line in at.items():
            label = method + (f", {resolution} pixels" if resolution else "")
            draw(axes, series(rows, "triangles", method=method, motion=motion,
                              resolution=float(resolution)), method, label, linestyle=line)
    axes.set_xscale("log")
    axes.set_xlabel("triangles in each of the two meshes")
    axes.set_title(MOTIONS[motion], fontsize=11)


def over_resolution(axes, rows, motion, triangles):
    for method in STYLE:
        points = [p for p in zip(*series(rows, "resolution", method=method, motion=motion,
                                         triangles=triangles)) if p[0] > 0]
        draw(axes, tuple(zip(*points)) or ((), ()), method, method)
    for method in ("box trees", "software, 1 thread"):
        own = series(rows, "resolution", method=method, motion=motion, triangles=triangles,
                     resolution=0.0)[1]
        if own:
            axes.axhline(own[0], color=STYLE[method][0], linewidth=0.9, linestyle="--")
    axes.set_xscale("log", base=2)
    axes.set_xticks(RESOLUTIONS, [str(r) for r in RESOLUTIONS])
    axes.set_xlabel(f"pixels along the image, {triangles / 1000:.0f}K triangles\n"
                    "(dashed: box trees, and software with its own choice of pixels)")


def main(path, cpu):
    rows = read(path)
    for row in rows:
        row["time"] = row["cpu_ms" if cpu else "median_ms"]
    plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "trivet", "font.size": 9,
                         "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6})
    figure, grid = plt.subplots(2, 2, figsize=(9.5, 8.6), sharey=True)
    for column, motion in enumerate(MOTIONS):
        over_triangles(grid[0][column], rows, motion)
        over_resolution(grid[1][column], rows, motion, 150000.0)
    for axes in grid.flat:
        axes.set_yscale("log")
        axes.set_axisbelow(True)
    for row in grid:
        row[0].set_ylabel("median CPU ms of a query, all threads" if cpu else "median ms of a query")
    handles, labels = grid[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=3, frameon=False, fontsize=8)
    figure.suptitle("First contact: cost by source of candidate pairs", fontsize=12)
    figure.tight_layout(rect=(0, 0.075, 1, 0.99))
    figure.savefig(os.path.splitext(path)[0] + ".svg", metadata={"Date": None})


if __name__ == "__main__":
    arguments = [a for a in sys.argv[1:] if a != "--cpu"]
    if len(arguments) != 1:
        sys.exit(__doc__)
    main(arguments[0], "--cpu" in sys.argv)
