#!/usr/bin/env python3
"""Measures how full containers and heaps get: PUT with one start each, and with several.

    perf/fill_rates.py --trivet build/release/apps/trivet [--tries 1,12] [--seeds 5] [--count 40] [--kinds balls]
        [--shared ../shared [--part 0.2]] [--referee PATH/referee] [--out DIR]

Balls of three sizes, cubes and cans are let go over a box of 0.3 m that is open above, one after another, at places that
a seed draws; 20 fruits over a bowl; 120 mixed things over a box of 0.45 m, twice as many scenes. With --shared 50 bins
of 8 and of 10 real models and 20 heaps of 30 and of 50; --part of these. Default rules. For each kind and number of tries a row:
objects placed, beside the container, scenes that the referee finds true as a whole (and, with a plus, of the others
those that it finds true by the triangles that Trivet wrote: it cuts faces that are not flat in its own way), processor time (user and system)
for an object, the longest PUT and how many took over a second (by the clock, times the share of it that the run had a
processor), and the latest start. Exit status 1 if anything
lies beside its container, a scene is true by neither, or with several tries fewer are placed than the set asks for.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import time

import fill_sets
import own_triangles


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def judged(options, *files):
    return subprocess.run([options.referee, *files, "--mu", "0.5", "--whole"], stdout=subprocess.DEVNULL,
                          check=False).returncode == 0


def run(options, base, layout, tries):
    """The report, processor seconds, share of the clock, and whether the referee finds the scene true, and its triangles."""
    path, scene, report = (f"{base}-{tries}.{end}" for end in ("json", "glb", "report.json"))
    with open(path, "w") as file:
        json.dump({**layout, "operations": [{**o, "tries": tries} for o in layout["operations"]]}, file)
    before, clock = processor_seconds(), time.monotonic()
    subprocess.run([options.trivet, "run", path, "-o", scene, "--report", report, "--threads", "1", "--quiet"],
                   check=False, stdout=subprocess.DEVNULL)
    seconds = processor_seconds() - before
    share = min(1, seconds / (time.monotonic() - clock))
    with open(report) as file:
        result = json.load(file)
    true = by_triangles = True
    if options.referee:
        true = by_triangles = judged(options, report, "--layout", path, "--scene", scene)
        if not true:
            by_triangles = judged(options, own_triangles.written(report, scene, f"{base}-{tries}"))
    return result, seconds, share, true, by_triangles


class Row:
    def __init__(self):
        self.scenes = self.true = self.by_triangles = self.objects = self.placed = self.beside = self.slow = 0
        self.seconds = self.longest = 0.0
        self.latest = 1

    def add(self, result, seconds, share, true, by_triangles, is_inside):
        operations = result["operations"]
        done = {o["object"] for o in operations if o["status"] == "ok"}
        centres = [o["centre_of_mass"] for o in result["objects"] if o["name"] in done]
        self.scenes += 1
        self.true += true
        self.by_triangles += by_triangles
        self.objects += len(operations)
        self.placed += len(done)
        self.beside += sum(not is_inside(c[0], c[1]) for c in centres)
        times = [share * o["milliseconds"] for o in operations]
        self.slow += sum(ms > 1000 for ms in times)
        self.seconds += seconds
        self.longest = max([self.longest] + times)
        self.latest = max([self.latest] + [o.get("try", 1) for o in operations])

    def text(self, name, tries):
        more = f" + {self.by_triangles - self.true}" if self.by_triangles > self.true else ""
        return (f"| {name} | {tries} | {self.placed} of {self.objects} | {self.beside} | {self.true}{more} of {self.scenes} | "
                f"{1e3 * self.seconds / self.objects:.0f} | {self.longest:.0f} | {self.slow} | {self.latest} |")


def measure(options, kind, tries):
    row = Row()
    for base, layout in kind.layouts(options.out):
        row.add(*run(options, base, layout, tries), kind.is_inside)
    print(row.text(kind.name, tries), flush=True)
    return row.beside == 0 and row.by_triangles == row.scenes and (tries == 1 or row.placed >= kind.least * row.objects)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trivet", required=True)
    parser.add_argument("--referee")
    parser.add_argument("--shared", help="folder with real models; default: none")
    parser.add_argument("--part", type=float, default=1, help="of the scenes of real models")
    parser.add_argument("--tries", default="1,12", help="numbers of tries, comma-separated")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--kinds", default="", help="part of a kind's name")
    parser.add_argument("--out", default="out/fill")
    options = parser.parse_args()
    options.out = os.path.abspath(options.out)
    options.shared = options.shared and os.path.abspath(options.shared)
    print("| kind | tries | placed | beside | true | processor ms an object | longest PUT, ms | over 1 s | latest start |\n" +
          "|---" * 9 + "|")
    good = [measure(options, kind, int(tries)) for kind in fill_sets.sets_of(options) if options.kinds in kind.name
            for tries in options.tries.split(",")]
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
