#!/usr/bin/env python3
"""Processor seconds and resident memory of a batch by tenths of its units, while it runs.

    perf/batch_tenths.py trivet batch RECIPE.json --count 100000 --jobs 2 --out DIR

DIR must be new. Looks at the processes twice a second: those of the parent, the zygote below it, and the workers
below that; seconds are those of all, of ended ones, too. A tenth ends when its last unit is published.
"""
import argparse
import os
import subprocess
import sys
import time

TICKS = os.sysconf("SC_CLK_TCK")
KINDS = ["parent", "zygote", "workers"]


def read_processes():
    """Reads of each process: the one above it, processor seconds with those of reaped children, resident MB."""
    out = {}
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/stat") as file:
                fields = file.read().rsplit(")", 1)[1].split()
        except OSError:  # it ended
            continue
        pages = int(fields[21])
        out[int(name)] = int(fields[1]), sum(map(int, fields[11:15])) / TICKS, pages * os.sysconf("SC_PAGE_SIZE") / 1e6
    return out


def children_of(process):
    return [p for p, (above, _, _) in read_processes().items() if above == process]


def look(root):
    """Seconds of all processes from `root` down, and the largest resident memory of each kind."""
    processes = read_processes()
    seconds, memory = 0.0, [0.0] * len(KINDS)
    level, depth = [root], 0
    while level:
        for process in level:
            if process in processes:
                seconds += processes[process][1]
                kind = min(depth, len(KINDS) - 1)
                memory[kind] = max(memory[kind], processes[process][2])
        level = [p for p, (above, _, _) in processes.items() if above in level]
        depth += 1
    return seconds, memory


def num_units(folder):
    return sum(file.startswith("scenes-") for _, _, files in os.walk(folder) for file in files)


def count_of(command, option, otherwise):
    return int(command[command.index(option) + 1]) if option in command else otherwise


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    command = parser.parse_args().command
    folder = command[command.index("--out") + 1]
    units = -(-count_of(command, "--count", 0) // count_of(command, "--per-tar", 1000))
    if units < 10 or os.path.exists(folder):
        sys.exit(f"{folder} must be new, and have ten units or more; it would have {units}")
    print("| tenth | CPU s | " + " | ".join(f"{kind}, MB" for kind in KINDS) + " |\n|--:|--:|--:|--:|--:|")
    batch = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    tenth, before, seconds, memory = 1, 0.0, 0.0, [0.0] * len(KINDS)
    while tenth <= 10:
        ended = batch.poll() is not None
        if not ended:
            seconds, now = look(batch.pid)
            memory = [max(pair) for pair in zip(memory, now)]
        if num_units(folder) * 10 >= tenth * units or ended:
            print(f"| {tenth} | {seconds - before:.1f} | " + " | ".join(f"{m:.1f}" for m in memory) + " |", flush=True)
            tenth, before, memory = tenth + 1, seconds, [0.0] * len(KINDS)
        time.sleep(0.5)
    sys.exit(batch.wait())


if __name__ == "__main__":
    main()
