#!/usr/bin/env python3
"""`trivet check` of a scene file of many boxes on the floor, reading included: processor time and memory. Markdown.

    perf/check_scale.py TRIVET [--boxes 8000 32000 100000]
"""
import argparse
import os
import subprocess
import tempfile

from session_scale import layout


def measured(*command):
    """Seconds of processor time, and the largest resident memory in MB, of a command that must succeed."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit("%s: status %d" % (" ".join(command), process.returncode))
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("trivet")
    parser.add_argument("--boxes", type=int, nargs="+", default=[8000, 32000, 100000])
    arguments = parser.parse_args()
    print("| boxes | MB of the file | CPU seconds | memory, MB |\n|--:|--:|--:|--:|")
    for count in arguments.boxes:
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.glb")
            measured(arguments.trivet, "run", layout(count, folder), "-o", scene, "--quiet")
            seconds, megabytes = measured(arguments.trivet, "check", scene, "--threads", "1")
            print("| {:,} | {:.0f} | {:.1f} | {:,.0f} |".format(
                count, os.path.getsize(scene) / 1e6, seconds, megabytes), flush=True)


if __name__ == "__main__":
    main()
