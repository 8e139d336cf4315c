#!/usr/bin/env python3
"""Checks that includes point downwards: between the top level folders, and between the folders of ops.

Usage: layers.py [--graph]     --graph: prints the edges between the folders of ops for Graphviz
"""
import collections
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
# Each may include itself and those before it; raster and gpu never see each other.
TOP = ["core", "raster", "gpu", "ops", "apps"]
APART = {("raster", "gpu"), ("gpu", "raster")}
OPS = ["base", "detect", "placement", "settle", "stability", "place", "operations", "check", "arrange",
       "files", "session", "simulation"]
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def sources(folder):
    for path, _, names in os.walk(os.path.join(ROOT, folder)):
        for name in names:
            if name.endswith((".h", ".cpp")):
                file = os.path.join(path, name)
                yield os.path.relpath(file, ROOT), open(file, encoding="utf-8").read()


def main():
    wrong, edges = [], collections.Counter()
    for top in TOP:
        for file, text in sources(top):
            for header in INCLUDE.findall(text):
                to = header.split("/")[0]
                if to in TOP and (TOP.index(to) > TOP.index(top) or (top, to) in APART):
                    wrong.append("%s includes %s: %s is not below %s" % (file, header, to, top))
                if top == "ops" and to == "ops":
                    here, there = file.split("/")[1], header.split("/")[1]
                    edges[here, there] += here != there
                    if here not in OPS or there not in OPS:
                        wrong.append("%s: not in a folder of ops that has a place" % file)
                    elif OPS.index(there) > OPS.index(here):
                        wrong.append("%s includes %s: ops/%s is above ops/%s"
                                     % (file, header, there, here))
    if "--graph" in sys.argv:
        print("digraph ops {")
        for (here, there), count in sorted(edges.items()):
            if count:
                print('  "%s" -> "%s" [label=%d]' % (here, there, count))
        print("}")
    for line in wrong:
        print(line)
    print("%d includes point upwards" % len(wrong))
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
