#!/usr/bin/env python3
"""Measures the cost of the module beside C++.

    PYTHONPATH=build/dev/apps/python perf/python/bench.py build/dev/apps/trivet build/dev/perf/trivet_python_bench

Prints one line for each figure: CPU time of the process, the least of several runs, so that other work on the machine
counts little.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

import trivet

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tests/apps/python"))
from shapes import at, box, table_with_cup, torus, torus_arrays  # noqa: E402
from test_examples import bin_shape  # noqa: E402


def least(function, runs=5):
    """CPU seconds of the cheapest call."""
    times = []
    for _ in range(runs):
        start = time.process_time()
        function()
        times.append(time.process_time() - start)
    return min(times)


def per_call(function, number=5000):
    def loop():
        for _ in range(number):
            function()
    return least(loop) / number


def calls():
    scene = table_with_cup()
    cup, low, key = scene["cup"], scene._scene, scene["cup"]._key
    for name, function in [
            ("a Python function that does nothing", lambda: None), ("len(scene)", lambda: len(scene)),
            ("_trivet: state of an object", lambda: low.state(key, "cup")),
            ("object.state", lambda: cup.state), ("object.pose", lambda: cup.pose), ("scene['cup']", lambda: scene["cup"]),
            ("shape.vertices", lambda s=box(): s.vertices)]:
        print(f"{name}: {1e9 * per_call(function):.0f} ns")
    print(f"scene.contacts(), {len(scene.contacts())} points: {1e6 * per_call(scene.contacts, 2000):.1f} us")
    print(f"scene.support_graph(): {1e6 * per_call(scene.support_graph, 2000):.1f} us")

    times = []
    for _ in range(2000):
        start = time.perf_counter()
        result = cup.put([0.1, 0.1, 1.0])
        times.append((time.perf_counter() - start, result.seconds))
    whole, inside = np.min(times, axis=0)
    print(f"put of 480 faces on a table: {1e6 * whole:.0f} us, {1e6 * inside:.0f} us of it the operation")


def big_shape(program, folder):
    vertices, faces = torus_arrays(1000, 500)
    faces = faces.astype(np.int32)
    vertices.tofile(os.path.join(folder, "vertices"))
    faces.tofile(os.path.join(folder, "faces"))
    out = subprocess.run([program, os.path.join(folder, "vertices"), os.path.join(folder, "faces"), "5"], check=True,
                         capture_output=True, text=True).stdout.split()
    here = least(lambda: trivet.Shape(vertices, faces))
    print(f"Shape of {len(faces)} faces: {1e3 * here:.0f} ms; C++: {float(out[1]):.0f} ms, {float(out[0]):.0f} of it merging; "
          f"ratio {1e3 * here / float(out[1]):.3f}")


def write_obj(path, shape):
    with open(path, "w") as file:
        file.writelines("v %r %r %r\n" % tuple(v) for v in shape.vertices.tolist())
        file.writelines("f %d %d %d\n" % tuple(f) for f in (shape.faces + 1).tolist())


def fill_bin(program, folder, number=50):
    """The puts of a bin, refused ones too, by Python and by `trivet run`."""
    shapes = {"bin": bin_shape(), "ring": torus(radius=0.03, thickness=0.01), "slab": box(0.02, 0.03, 0.01),
              "stick": box(0.005, 0.005, 0.06)}
    for name, shape in shapes.items():
        write_obj(os.path.join(folder, name + ".obj"), shape)
    shapes = {name: trivet.Shape.load(os.path.join(folder, name + ".obj")) for name in shapes}
    kinds = list(shapes)[1:]
    operations = []

    def lay_out():
        operations.clear()
        rng = np.random.default_rng(7)
        scene = trivet.Scene()
        scene.add("bin", shapes["bin"], pose=at(0, 0, 1e-5), fixed=True)
        for i in range(number):
            part = scene.add(f"part{i}", shapes[kinds[i % 3]])
            done = False
            while not done:
                position, wxyz = [*rng.uniform(-.15, .15, 2).tolist(), 1.2], trivet.random_rotation(rng)
                operations.append({"op": "put", "object": part.name, "position": position, "rotation": wxyz})
                start = time.perf_counter()
                done = bool(part.try_put(position, wxyz))
                seconds.append(time.perf_counter() - start)
        return scene

    objects = [{"name": "bin", "model": "bin.obj", "fixed": True, "position": [0, 0, 1e-5]}]
    objects += [{"name": f"part{i}", "model": kinds[i % 3] + ".obj"} for i in range(number)]
    totals, inside = [], []
    for _ in range(5):
        seconds = []
        scene = lay_out()
        totals.append(sum(seconds))
        with open(os.path.join(folder, "bin.json"), "w") as file:
            json.dump({"trivet": 1, "objects": objects, "operations": operations}, file)
        subprocess.run([program, "run", "bin.json", "--report", "report.json", "-o", "bin.glb"], cwd=folder,
                       capture_output=True, check=False)
        with open(os.path.join(folder, "report.json")) as file:
            report = json.load(file)
        inside.append(sum(one["milliseconds"] for one in report["operations"] if one["op"] == "put") / 1e3)
    poses = {one["name"]: one["world_from_file"] for one in report["objects"]}
    same = all(one.matrix.ravel().tolist() == poses[one.name] for one in scene)
    print(f"{number} objects into a bin, {len(operations)} puts: {1e3 * min(totals):.0f} ms; the same by `trivet run`: "
          f"{1e3 * min(inside):.0f} ms, {'the same bits' if same else 'OTHER BITS'}; ratio {min(totals) / min(inside):.3f}")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        calls()
        big_shape(os.path.abspath(sys.argv[2]), temporary)
        fill_bin(os.path.abspath(sys.argv[1]), temporary)
