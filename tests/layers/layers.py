#!/usr/bin/env python3
"""Checks that includes point downwards, between the top level folders and between those of core and ops; that
geometry needs no POSIX; and that no file repeats the name of its folder.

Usage: layers.py [--graph]     --graph: prints the edges between the folders of core and ops for Graphviz
"""
import collections
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
# Each may include itself and those before it; raster and gpu never see each other.
TOP = ["core", "raster", "gpu", "ops", "apps"]
APART = {("raster", "gpu"), ("gpu", "raster")}
ROOMS = {
    "core": ["base", "mesh", "motion", "index", "contact", "exact", "candidates", "model", "flex",
             "scene", "convex", "io", "picture"],
    "ops": ["base", "detect", "placement", "settle", "stability", "free_places", "operations",
            "check", "arrange", "mend", "files", "session", "simulation"],
}
# Geometry is for every system: no header of POSIX.
PORTABLE = {"base", "mesh", "motion", "index", "contact", "exact", "candidates", "model", "flex",
            "scene"}
POSIX = re.compile(r"^#include <(unistd|fcntl|poll|pthread|dlfcn|sys/.*|linux/.*)(\.h)?>", re.M)
# The field's own words begin with the name of their room.
WORDS = {"contact_ends", "contact_face", "contact_memory", "contact_points", "contact_summary",
         "motion_boxes", "motion_depths", "settle_problem", "stable_poses"}
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def sources(folder):
    for path, _, names in os.walk(os.path.join(ROOT, folder)):
        for name in names:
            if name.endswith((".h", ".cpp")):
                file = os.path.join(path, name)
                yield os.path.relpath(file, ROOT), open(file, encoding="utf-8").read()


def check_edge(top, file, header, edges):
    to = header.split("/")[0]
    if to in TOP and (TOP.index(to) > TOP.index(top) or (top, to) in APART):
        return "%s includes %s: %s is not below %s" % (file, header, to, top)
    if top != to or top not in ROOMS:
        return None
    rooms, here, there = ROOMS[top], file.split("/")[1], header.split("/")[1]
    edges[top + "/" + here, top + "/" + there] += here != there
    if here not in rooms or there not in rooms:
        return "%s: not in a folder of %s that has a place" % (file, top)
    if rooms.index(there) > rooms.index(here):
        return "%s includes %s: %s/%s is above %s/%s" % (file, header, top, there, top, here)
    return None


def check_file(top, file, text):
    folder, name = os.path.split(file)
    stem, room = os.path.splitext(name)[0], os.path.basename(folder)
    if top != "apps" and stem.startswith(room + "_") and stem not in WORDS:
        yield "%s: repeats the name of its folder" % file
    if top == "core" and file.split("/")[1] in PORTABLE and POSIX.search(text):
        yield "%s: geometry and scenes do without POSIX" % file


def main():
    wrong, edges = [], collections.Counter()
    for top in TOP:
        for file, text in sources(top):
            wrong += check_file(top, file, text)
            found = [check_edge(top, file, header, edges) for header in INCLUDE.findall(text)]
            wrong += [line for line in found if line]
    if "--graph" in sys.argv:
        print("digraph rooms {")
        for (here, there), count in sorted(edges.items()):
            if count:
                print('  "%s" -> "%s" [label=%d]' % (here, there, count))
        print("}")
    for line in wrong:
        print(line)
    print("%d findings" % len(wrong))
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
