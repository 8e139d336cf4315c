"""Readers of others beside the second one: CGAL and OpenMesh (mesh_readers.cpp), tinyobjloader, three.js and Blender, each where it is
installed. Answers are lines of JSON: the reader, the file, triangles, area, volume and box, or the error.
"""
import json
import os
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
MESHES = {".obj", ".stl", ".ply", ".off"}


def answers(command, paths, folder, **more):
    run = subprocess.run(command, input="\n".join(paths) + "\n", cwd=folder, capture_output=True, text=True, timeout=3000, **more)
    return [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{\"")]


def by_mesh_readers(paths, folder):
    return answers(["./mesh_readers"], paths, folder) if (folder / "mesh_readers").exists() else None


def by_tinyobjloader(paths, folder):
    python = "/usr/bin/python3"  # which Debian's binding is for
    command = [python, "-B", str(HERE / "tinyobj_reader.py")]
    if subprocess.run([python, "-c", "import tinyobjloader"], capture_output=True).returncode:
        return None
    return answers(command, paths, folder)


def by_three(paths, folder):
    return [{"reader": "three.js", **found} for found in answers(["node", "three_reader.mjs"], paths, folder)]


def by_blender(paths, folder):
    if not shutil.which("blender"):
        return None
    (folder / "blender.txt").write_text("\n".join(paths) + "\n")
    subprocess.run(["blender", "-b", "--factory-startup", "--python", str(HERE / "blender_reader.py"), "--", "blender.txt", "blender.json"],
                   cwd=folder, capture_output=True, timeout=3000, env={**os.environ, "HOME": str(folder)})
    return [json.loads(line) for line in (folder / "blender.json").read_text().splitlines()]


# Blender 3.4 of Debian 12 fails on glTF, as its add-on is older than Debian's NumPy.
READERS = {"CGAL, OpenMesh": (by_mesh_readers, MESHES), "tinyobjloader": (by_tinyobjloader, {".obj"}),
           "three.js": (by_three, {".obj", ".stl", ".ply"}), "Blender": (by_blender, {".fbx", ".dae", ".x3d", ".ply", ".stl"})}


def all_answers(paths, extension_of, folder):
    """Answers of all readers that are installed; the others are named."""
    out = []
    for name, (reader, extensions) in READERS.items():
        found = reader([path for path in paths if extension_of(path) in extensions], folder)
        if found is None:
            print("not installed, left out: " + name)
        out += found or []
    return out
