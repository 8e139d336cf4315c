#!/usr/bin/env python3
"""Processor seconds of one picture of 640 x 480 against its error, by Trivet's rays and by Blender's Cycles, in one run.

    PYTHONPATH=build/release/apps/python perf/blender/equal_error.py SCENE.glb FOLDER [CONVERGED]

Each renderer is compared with its own picture of CONVERGED samples (256), in steps of 8-bit sRGB: root mean square. Seconds are
those of all threads, from the scene in memory to the pixels, the tree of triangles included. Needs blender and python3-numpy.
"""
import json
import pathlib
import subprocess
import sys
import time

import numpy

import trivet

SIZE = (640, 480)
TRIVET_SAMPLES, CYCLES_SAMPLES = (4, 8, 16, 32), (4, 16, 64)


def rmse(a, b):
    return float(numpy.sqrt(((a.astype(float) - b) ** 2).mean()))


def trivet_rows(scene, camera, converged):
    def picture(samples):
        begin = time.process_time()
        pixels = scene.render(camera, samples=samples)
        return pixels, time.process_time() - begin

    best, _ = picture(converged)
    for samples in TRIVET_SAMPLES:
        pixels, seconds = picture(samples)
        yield samples, seconds, rmse(pixels, best)


def cycles_rows(scene_file, camera, folder, converged):
    (folder / "camera.json").write_text(json.dumps({
        "camera_from_world": numpy.asarray(camera.camera_from_world).tolist(), "K": numpy.asarray(camera.intrinsics).tolist(), "size": SIZE}))
    script = pathlib.Path(__file__).with_name("equal_error_cycles.py")
    done = subprocess.run(["blender", "-b", "--factory-startup", "-P", str(script), "--", str(scene_file), str(folder),
                           str(converged), *map(str, CYCLES_SAMPLES)], capture_output=True, text=True)
    rows = folder / "cycles.json"
    if done.returncode != 0 or not rows.exists():
        sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
    return json.loads(rows.read_text())


def seconds_at(rows, error):
    """Between the measured samples, of the law that the error falls with a power of the time."""
    times, errors = numpy.log([row[1] for row in rows]), numpy.log([row[2] for row in rows])
    slope, offset = numpy.polyfit(errors, times, 1)
    return float(numpy.exp(slope * numpy.log(error) + offset))


def main():
    scene_file, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    converged = int(sys.argv[3]) if len(sys.argv) > 3 else 256
    folder.mkdir(parents=True, exist_ok=True)
    scene = trivet.Scene.load(scene_file)
    camera = scene.camera(SIZE)
    ours = list(trivet_rows(scene, camera, converged))
    theirs = cycles_rows(scene_file.resolve(), camera, folder, converged)
    print("| renderer | samples | CPU s | RMSE |\n|---|--:|--:|--:|")
    for name, rows in (("Trivet, rays, filtered", ours), ("Blender, Cycles", theirs)):
        for samples, seconds, error in rows:
            print("| %s | %d | %.2f | %.2f |" % (name, samples, seconds, error))
    error = ours[2][2]
    print("At an error of %.2f: Trivet %.2f s, Cycles %.1f s" % (error, seconds_at(ours, error), seconds_at(theirs, error)))


if __name__ == "__main__":
    main()
