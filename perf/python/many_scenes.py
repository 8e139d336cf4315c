#!/usr/bin/env python3
"""Memory over many small scenes, and races on one.

    PYTHONPATH=build/dev/apps/python perf/python/many_scenes.py [SCENES]       # 10,000

A scene is a table, a ring and two boxes, put, pushed, asked for contacts, supports and a snapshot, every tenth checked, drawn
and labelled at 32 x 24 pixels. Prints resident memory and CPU time at every tenth of the way.
"""
import os
import sys
import threading
import time

import numpy as np

import trivet

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tests/apps/python"))
from shapes import box, table_with_cup  # noqa: E402

CUBE = box(0.03, 0.03, 0.03)
SIZE = (32, 24)


def resident_mb():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def use_scene(k):
    rng = np.random.default_rng(k)
    scene = table_with_cup()
    for i in range(2):
        cube = scene.add(f"cube{i}", CUBE if k % 2 else box(0.02, 0.03, 0.04))
        cube.try_put([*rng.uniform(-0.4, 0.4, 2), 1.0], trivet.random_rotation(rng))
    scene["cup"].try_push([1, 0], 0.01)
    scene.contacts(), scene.support_graph(), scene.snapshot(), scene.undo()
    if k % 10 == 0:
        scene.check(), scene.render(size=SIZE, samples=1), scene.labels(size=SIZE)


def memory(count):
    print("scenes  resident MB  CPU ms per scene", flush=True)
    start = time.process_time()
    for k in range(count):
        use_scene(k)
        if (k + 1) % max(count // 10, 1) == 0:
            print(f"{k + 1:6}  {resident_mb():11.1f}  {1e3 * (time.process_time() - start) / (k + 1):16.2f}", flush=True)


def races(runs=20, num_threads=8):
    """Runs in which threads that put, push, read and undo on one scene leave it true and at rest."""
    good = 0
    for run in range(runs):
        scene = table_with_cup()
        names = [f"b{i}" for i in range(num_threads)]
        for name in names:
            scene.add(name, CUBE)

        def work(name):
            rng = np.random.default_rng([run, names.index(name)])
            for _ in range(3):
                scene[name].try_put([*rng.uniform(-0.3, 0.3, 2), 1.0], trivet.random_rotation(rng))
                scene[name].try_push(rng.uniform(-1, 1, 2), 0.02)
                scene.contacts(), scene.support_graph()
            if rng.random() < 0.3:
                scene.undo()

        threads = [threading.Thread(target=work, args=(name,)) for name in names]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        good += scene.check().ok
    print(f"{num_threads} threads on one scene: {good} of {runs} runs end without a crossing and at rest")


if __name__ == "__main__":
    memory(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000)
    races()
