#!/usr/bin/env python3
"""A batch by every detector: the same SHA-256 of every tar, also where a worker is killed or a device lost.

    perf/batch_detectors.py trivet RECIPE.json DIR [--counts 1000,100,20,10]

DIR must be new. Counts are those of scenes by BVHs, by software, by either method of a GPU, and of each run that is
disturbed. Two workers, so two contexts of OpenGL at once; five scenes to a tar. Every tar is compared with that by BVHs.
Prints a table; resident memory is the largest of a worker, by quarters of the run. Status 1: a tar differs.
"""
import argparse
import hashlib
import json
import os
import signal
import subprocess
import sys
import time

from batch_tenths import children_of, look, num_units

PER_TAR = 5
LOST_GPU = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "apps", "lost_gpu.c")
LOST_DRAW = 120  # of a worker: in its first scenes, after the self-test


class Run:
    """One batch while it runs, and what it came to."""

    def __init__(self, name, command, folder, count, detector, env=None):
        self.name, self.folder, self.count = name, folder, count
        self.kills = False
        self.seconds, self.memory = 0.0, [0.0] * 4
        self.process = subprocess.Popen(
            [*command, "--count", str(count), "--per-tar", str(PER_TAR), "--jobs", "2", "--detector", detector,
             "--out", folder, "--json", "--quiet"], env={**os.environ, **(env or {})}, stdout=subprocess.PIPE, text=True)

    def watch(self):
        """Looks once; false when it has ended."""
        seconds, memory = look(self.process.pid)
        made = num_units(self.folder) if os.path.isdir(self.folder) else 0
        if self.process.poll() is not None:
            self.totals = json.loads(self.process.stdout.read())
            return False
        self.seconds = seconds
        quarter = min(3, made * PER_TAR * 4 // self.count)
        self.memory[quarter] = max(self.memory[quarter], memory[2])
        if self.kills and made > 0:
            workers = [worker for zygote in children_of(self.process.pid) for worker in children_of(zygote)]
            if workers:
                os.kill(workers[0], signal.SIGKILL)
                self.kills = False
        return True

    def units(self):
        out = {}
        for folder, _, files in os.walk(self.folder):
            for file in files:
                if file.startswith("scenes-") and file.endswith(".tar"):
                    with open(os.path.join(folder, file), "rb") as tar:
                        out[file] = hashlib.sha256(tar.read()).hexdigest()
        return out

    def row(self, truth):
        units, totals = self.units(), self.totals
        same = sum(truth[name] == value for name, value in units.items())
        self.right = same == len(units) == self.count // PER_TAR and totals["failed"] == 0 and not self.kills
        shared = "" if totals["draws"] == 0 else "%d; %d" % (totals["queries"] + totals["early_queries"], totals["draws"])
        memory = ", ".join("%.0f" % m if m else "-" for m in self.memory)
        return (f"| {self.name} | {self.count} | {same} of {self.count // PER_TAR} | {self.count / self.seconds:.2g} | {shared} "
                f"| {memory} | {len(totals['notes'])} |")


def watch_all(runs):
    left = list(runs)
    while left:
        left = [run for run in left if run.watch()]
        time.sleep(0.2)
    return runs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("recipe")
    parser.add_argument("folder")
    parser.add_argument("--counts", default="1000,100,20,10")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder)
    bvh, software, gpu, disturbed = (int(count) for count in arguments.counts.split(","))
    library = os.path.join(arguments.folder, "lost_gpu.so")
    subprocess.run(["cc", "-shared", "-fPIC", LOST_GPU, "-o", library, "-ldl"], check=True)
    lost = {"LD_PRELOAD": library, "LOST_GPU_DRAW": str(LOST_DRAW)}

    def start(name, count, detector, kills=False, **env):
        folder = os.path.join(arguments.folder, "%d" % len(os.listdir(arguments.folder)))
        run = Run(name, [arguments.program, "batch", arguments.recipe], folder, count, detector, env)
        run.kills = kills
        return run

    truth, right = {}, True

    def tell(*runs):
        nonlocal right
        for run in watch_all(runs):
            if not truth:
                truth.update(run.units())
            print(run.row(truth), flush=True)
            right = right and run.right

    print("| detector | scenes | tars as by BVHs | scenes per CPU s | queries; draws | worker's MB by quarters | notes |")
    print("|---|--:|--:|--:|--:|--:|--:|", flush=True)
    tell(start("bvh", bvh, "bvh"))
    tell(start("bvh, a worker killed", min(bvh, 10 * disturbed), "bvh", True))
    tell(start("software", software, "software"))
    for method in ("framebuffer", "compute"):
        tell(start(method, gpu, method))
    tell(start("framebuffer, a worker killed", disturbed, "framebuffer", True))
    tell(start("compute, a device lost for good", disturbed, "compute", LOST_GPU_ONCE=library + ".lost", **lost))
    tell(start("compute, a device lost, a new context", disturbed, "compute", LOST_GPU_ONCE=library + ".again",
               LOST_GPU_AGAIN="1", **lost))
    tell(*(start(method + ", beside the other", disturbed, method) for method in ("framebuffer", "compute")))
    sys.exit(not right)


if __name__ == "__main__":
    main()
