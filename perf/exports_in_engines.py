#!/usr/bin/env python3
"""A sample of a batch's simulator files in engines: how many load, and how far free objects move within a second.

    perf/exports_in_engines.py TRIVET FILES NODE_MODULES [STEP]

FILES is the folder of `trivet batch export --as mjcf,sdf,usd`; every STEPth scene (50) is taken.
MJCF by MuJoCo of npm (@mujoco/mujoco), USD by three's reader, SDF by `trivet check`. NODE_MODULES has both packages.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
MOVED = 0.01  # metres


def alone(file, folder):
    """The MJCF file with the meshes it names in one folder, as the engine's file system wants it."""
    text = file.read_text().replace('"../../meshes/"', '"meshes/"')
    meshes = file.parent.parent.parent / "meshes"
    (folder / "meshes").mkdir(parents=True)
    for name in set(re.findall(r'file="([^"]+)"', text)):
        shutil.copy(meshes / name, folder / "meshes" / name)
    (folder / "scene.xml").write_text(text)
    return folder / "scene.xml"


def in_mujoco(files, work, modules):
    script = work / "rest.mjs"
    shutil.copy(HERE / "rest.mjs", script)
    (work / "node_modules").symlink_to(modules)
    scenes = [alone(file, work / file.stem) for file in files]
    done = subprocess.run(["node", str(script), "1", *map(str, scenes)], capture_output=True, text=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def in_three(file, work, modules):
    """The scene and all it names, as a package."""
    text = file.read_text()
    package = work / (file.stem + ".usdz")
    with zipfile.ZipFile(package, "w", zipfile.ZIP_STORED) as out:
        out.writestr("scene.usda", text.replace("../../meshes/", "meshes/"))
        for name in set(re.findall(r"meshes/([\w.-]+)", text)):
            out.write(file.parent.parent.parent / "meshes" / name, "meshes/" + name)
    reader = modules / "three/examples/jsm/loaders/USDLoader.js"
    done = subprocess.run(["node", str(HERE.parent / "tests/apps/read_usd.mjs"), str(reader), str(package)], capture_output=True, text=True)
    return sum(node["meshes"] > 0 for node in json.loads(done.stdout)) if done.returncode == 0 else 0


def sdf_is_read(program, file):
    done = subprocess.run([program, "check", str(file), "--json"], capture_output=True, text=True)
    return done.returncode in (0, 1) and bool(done.stdout.strip())


def main():
    program, files, modules = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]).resolve()
    step = int(sys.argv[4]) if len(sys.argv) > 4 else 50
    mjcf = sorted(files.rglob("*.xml"))[::step]
    with tempfile.TemporaryDirectory() as place:
        work = pathlib.Path(place)
        answers = in_mujoco(mjcf, work, modules)
        loaded = [answer for answer in answers if "error" not in answer]
        moved = [max(answer["moved"].values(), default=0) for answer in loaded]
        print("MJCF: %d of %d load in MuJoCo %s; in %d of them nothing moves by a centimetre within a second" % (
            len(loaded), len(mjcf), loaded[0]["version"] if loaded else "", sum(m < MOVED for m in moved)))
        for answer in answers:
            if "error" in answer:
                print("  ", answer["file"], answer["error"])
        usd = [file.with_suffix(".usda") for file in mjcf]
        print("USD: %d of %d are read by three" % (sum(in_three(file, work, modules) > 0 for file in usd), len(usd)))
    sdf = [file.with_suffix(".sdf") for file in mjcf]
    print("SDF: %d of %d are read" % (sum(sdf_is_read(program, file) for file in sdf), len(sdf)))


if __name__ == "__main__":
    main()
