#!/usr/bin/env python3
"""A session by default rules among many boxes on the floor: milliseconds of an answer, by the clock. Markdown.

    perf/session_scale.py TRIVET [--boxes 100 10000 100000]

Loading is from the start of the program to its greeting; the others are medians of 200 answers.
"""
import argparse
import json
import os
import statistics
import subprocess
import tempfile
import time

SPACING = 0.2  # metres
BOX = "".join("v %g %g %g\n" % (x, y, z) for z in (0, 0.1) for y in (-0.05, 0.05) for x in (-0.05, 0.05)) + \
    "".join("f %s\n" % f for f in ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"))


def layout(count, folder):
    """So many boxes in rows, a clearance over the floor, and one out of the scene."""
    with open(os.path.join(folder, "box.obj"), "w") as file:
        file.write(BOX)
    width = int(count ** 0.5) + 1
    height = 2 ** -20 * min(10, SPACING * width * 2 ** 0.5)
    boxes = [{"name": "box_%d" % i, "model": "box.obj", "up": "z",
              "position": [SPACING * (i % width), SPACING * (i // width), height]} for i in range(count)]
    path = os.path.join(folder, "layout.json")
    with open(path, "w") as file:
        json.dump({"trivet": 1, "objects": boxes + [{"name": "new", "model": "box.obj", "up": "z"}]}, file)
    return path


class Session:
    def __init__(self, trivet, path):
        begin = time.perf_counter()
        self.process = subprocess.Popen([trivet, "session", path, "--threads", "1"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True, bufsize=1)
        self.process.stdout.readline()
        self.seconds_to_load = time.perf_counter() - begin

    def ask(self, question):
        begin = time.perf_counter()
        self.process.stdin.write(json.dumps(question) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        milliseconds = 1000 * (time.perf_counter() - begin)
        if answer.get("status", "ok") != "ok":
            raise SystemExit("%s: %s" % (question, answer["reason"]))
        return milliseconds


def measure(trivet, count):
    with tempfile.TemporaryDirectory() as folder:
        session = Session(trivet, layout(count, folder))
        some = ["box_%d" % (count // 2 + i * (count // 2) // 200) for i in range(200)]
        rows = {
            "PUT": [session.ask({"op": "put", "object": "new", "position": [-0.15 - 0.001 * (i % 7), SPACING, 1]})
                    for i in range(200)],
            "PUSH": [session.ask({"op": "push", "object": name, "direction": [1, 0], "distance": 0.0001})
                     for name in some],
            "query": [session.ask({"query": name}) for name in some],
        }
        session.process.stdin.close()
        session.process.wait()
        return session.seconds_to_load, {name: statistics.median(times) for name, times in rows.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("trivet")
    parser.add_argument("--boxes", type=int, nargs="+", default=[100, 10000, 100000])
    options = parser.parse_args()
    print("| boxes | load, s | PUT onto the floor, ms | PUSH, ms | query of one, ms |\n|---|---|---|---|---|")
    for count in options.boxes:
        seconds, medians = measure(options.trivet, count)
        print("| %d | %.2f | %s |" % (count, seconds, " | ".join("%.3f" % medians[k] for k in ("PUT", "PUSH", "query"))),
              flush=True)


if __name__ == "__main__":
    main()
