"""Reads every model file that Debian packages bring, with Trivet and a second reader, and compares.

    corpus.py TRIVET FOLDER

Box, area, volume of solids and number of triangles must agree. The second reader is reader.py for OBJ, STL, PLY and
OFF, three.js for glTF, Collada, FBX, 3DS, LightWave, AMF and 3MF (three_reader.mjs; FOLDER has node_modules),
OpenSceneGraph for AC3D and DirectX. Whatever disagrees must be in explained.tsv, and whatever is there must disagree.
Archives are unpacked below FOLDER. Prints a table by formats, and one by readers (further.py, further.tsv).
"""
import fnmatch
import json
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import further  # noqa: E402
import reader  # noqa: E402

PACKAGES = ["assimp-testmodels", "sweethome3d-furniture", "morse-simulator-data"]
THREE = {".gltf", ".glb", ".dae", ".fbx", ".3ds", ".lwo", ".amf", ".3mf"}
SCENEGRAPH = {".ac", ".x"}
OTHERS = {".x3d", ".ms3d", ".b3d", ".dxf", ".ase", ".md2", ".md3", ".mdl", ".blend", ".nff", ".cob", ".smd", ".raw", ".q3o",
          ".ply", ".zae", ".m3d"}
LEAST = 500
NAMES = {".gltf": "glTF", ".glb": "glTF", ".dae": "Collada", ".fbx": "FBX", ".3ds": "3DS", ".lwo": "LightWave", ".amf": "AMF",
         ".3mf": "3MF", ".obj": "OBJ", ".stl": "STL", ".ply": "PLY", ".off": "OFF", ".ac": "AC3D", ".x": "DirectX"}


def extension_of(path):
    return os.path.splitext(path)[1].lower()


def is_model(path):
    return extension_of(path) in reader.READERS.keys() | THREE | SCENEGRAPH | OTHERS


def files_of(package, folder):
    """Model files of a package, by a name that does not depend on this machine."""
    listed = subprocess.run(["dpkg", "-L", package], capture_output=True, text=True)
    for path in listed.stdout.splitlines() if listed.returncode == 0 else []:
        if extension_of(path) == ".sh3f":
            yield from unpacked(package, path, folder / package / Path(path).stem)
        elif is_model(path) and os.path.isfile(path):
            yield package + "/" + os.path.basename(os.path.dirname(path)) + "/" + os.path.basename(path), path


def unpacked(package, archive, folder):
    with zipfile.ZipFile(archive) as packed:
        packed.extractall(folder)
    for path in sorted(folder.rglob("*")):
        if extension_of(path) in reader.READERS:
            yield package + "/" + folder.name + "/" + path.relative_to(folder).as_posix(), str(path)


def by_trivet(program, path):
    run = subprocess.run([program, "info", path, "--json"], capture_output=True, text=True, timeout=600)
    try:
        found = json.loads(run.stdout)
    except ValueError:
        return None, "stopped with status %d: %s" % (run.returncode, run.stderr.strip())
    if run.returncode != 0:
        return None, found["error"]["message"].replace(path, os.path.basename(path))
    return found, ""


def by_three(folder, paths):
    """Asks three.js about all files at once. Returns its answer by file."""
    run = subprocess.run(["node", "three_reader.mjs"], input="\n".join(paths) + "\n", cwd=folder, capture_output=True, text=True,
                         timeout=1200)
    lines = [line for line in run.stdout.splitlines() if line.startswith("{\"file\"")]  # loaders print, too
    return {found["file"]: found for found in map(json.loads, lines)}


def by_scenegraph(path):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "m.obj"
        subprocess.run(["osgconv", path, str(out)], capture_output=True, timeout=60, check=True)
        return reader.read_obj(out.read_bytes())


def surface_of(found):
    surface = reader.Surface()
    if "error" in found:
        raise ValueError(found["error"])
    surface.triangles, surface.area, surface.volume = found["triangles"], found["area"], found["volume"]
    if surface.triangles:
        surface.lower, surface.upper = found["lower"], found["upper"]
    return surface


def by_second(path, three):
    extension = extension_of(path)
    try:
        if extension in THREE:
            return surface_of(three[path]), ""
        if extension in SCENEGRAPH:
            return by_scenegraph(path), ""
        return reader.READERS[extension](Path(path).read_bytes()), ""
    except Exception as error:  # of a reader that trusts its files
        return None, "%s: %s" % (type(error).__name__, error)


def differs(a, b, within):
    return abs(a - b) > within


def disagreement(found, second, path, exact, scaled=(".dae", ".zae")):
    """Empty: they agree. @param exact  reader.py; others turn axes and read float32. @param scaled  what the other one has in metres."""
    unit = found["metres_per_unit"] if extension_of(path) in scaled else 1
    size = max(max(abs(x) for x in second.lower + second.upper), 1e-300)
    if found["triangles"] != second.triangles:
        return "triangles %d, not %d" % (found["triangles"], second.triangles)
    if exact:
        pairs = list(zip(found["box"]["lower"] + found["box"]["upper"], list(second.lower) + list(second.upper)))
    else:
        pairs = list(zip(sorted(unit * x for x in found["size"]), sorted(b - a for a, b in zip(second.lower, second.upper))))
    if any(differs(a, b, (1e-9 if exact else 1e-5) * size) for a, b in pairs):
        return "box %r" % (pairs,)
    # Twelve digits are printed; bent polygons have an area by their triangles only.
    if not second.bent and differs(unit * unit * found["area"], second.area, (1e-6 if exact else 1e-4) * max(second.area, 1e-300)):
        return "area %r, not %r" % (unit * unit * found["area"], second.area)
    within = (1e-6, 1e-9) if exact else (1e-3, 1e-5)
    if is_plain_solid(found) and not second.bent and differs(
            unit ** 3 * found["volume"], abs(second.volume), within[0] * abs(second.volume) + within[1] * size ** 3):
        return "volume %r, not %r" % (unit ** 3 * found["volume"], abs(second.volume))
    return ""


def is_plain_solid(found):
    """Its volume is that of its triangles as they are wound."""
    parts = found["parts"]
    closed = found["closed"] and found["oriented"] and found["manifold"] and found["mass_rule"] == "volume"
    return closed and not any(p["cavity"] for p in parts) and len({p["turned"] for p in parts}) == 1


def verdict(name, path, three, own):
    found, why = own
    if found is None and ("stopped with" in why or "longer than" in why):
        return name, path, "fault", why
    if extension_of(path) not in reader.READERS.keys() | THREE | SCENEGRAPH:
        return name, path, "read" if found else "refused", why
    second, fault = by_second(path, three)
    if found is None or second is None or second.triangles == 0:
        alike = found is None and (second is None or second.triangles == 0)
        return name, path, "both refuse" if alike else "differs", "Trivet: %s; second: %s" % (
            why or "reads it", fault or "reads %d triangles" % (second.triangles if second else 0))
    text = disagreement(found, second, path, extension_of(path) in reader.READERS)
    return name, path, "differs" if text else "agrees", text


def further_verdict(answer, own):
    """Compares another reader's answer about a file with Trivet's."""
    path, (found, _) = answer["file"], own
    try:
        other = surface_of(answer)
    except ValueError:
        other = None
    if other is None or other.triangles == 0:
        return "does not read" if found else "both refuse", ""
    if found is None:
        return "reads alone", "Trivet refuses"
    blender = answer["reader"] == "Blender"
    # Triangles of bent polygons are the reader's own choice.
    other.bent = answer.get("bent", blender or answer["reader"] == "three.js")
    text = disagreement(found, other, path, False, (".dae", ".zae", ".fbx") if blender else ())
    return "differs" if text else "agrees", text


def further_failures(files, owns, folder):
    """Prints the table of further readers. @return what is not explained."""
    names, table = {path: name for name, path in files}, {}
    kinds = ["agrees", "both refuse", "differs", "does not read", "reads alone"]
    explained, failures, used, asked = explanations("further.tsv"), [], set(), set()
    for answer in further.all_answers([path for _, path in files], extension_of, folder):
        path, reader_name = answer["file"], answer["reader"]
        kind, text = further_verdict(answer, owns[path])
        row = table.setdefault((reader_name, NAMES.get(extension_of(path), "X3D")), dict.fromkeys(kinds, 0))
        row[kind] += 1
        asked.add(reader_name)
        if kind not in ("differs", "reads alone"):
            continue
        key = reader_name + ":" + names[path]
        pattern = next((p for p in explained if fnmatch.fnmatchcase(key, p)), None)
        used.add(pattern)
        if pattern is None:
            failures.append("%s %s: %s" % (kind, key, text))
    print("| reader | format | " + " | ".join(kinds) + " |\n|---|---|" + "--:|" * len(kinds))
    for key in sorted(table):
        print("| %s | %s | %s |" % (*key, " | ".join(str(table[key][k]) for k in kinds)))
    return failures + ["explained, but nothing differs: " + p for p in explained if p not in used and p.split(":")[0] in asked]


def explanations(file):
    lines = (HERE / file).read_text().splitlines()
    return dict(line.split("\t", 1) for line in lines if line and not line.startswith("#"))


def print_table(results):
    kinds = ["agrees", "both refuse", "differs", "fault", "read", "refused"]
    table = {}
    for _, path, kind, _ in results:
        row = table.setdefault(NAMES.get(extension_of(path), "others"), dict.fromkeys(kinds, 0))
        row[kind] += 1
    print("| format | files | " + " | ".join(kinds) + " |\n|---|" + "--:|" * (len(kinds) + 1))
    for name in sorted(table):
        print("| %s | %d | %s |" % (name, sum(table[name].values()), " | ".join(str(table[name][k]) for k in kinds)))


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    files = sorted({file for package in PACKAGES for file in files_of(package, folder)})
    if len(files) < LEAST:
        print("skipped: %d model files; install %s" % (len(files), " ".join(PACKAGES)))
        return 77
    if not shutil.which("osgconv"):
        files = [f for f in files if extension_of(f[1]) not in SCENEGRAPH]
    three = by_three(folder, [path for _, path in files if extension_of(path) in THREE])
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        owns = dict(zip((path for _, path in files), pool.map(lambda f: by_trivet(program, f[1]), files)))
    results = [verdict(name, path, three, owns[path]) for name, path in files]
    explained, failures, used = explanations("explained.tsv"), [], set()
    for name, _, kind, text in results:
        pattern = next((p for p in explained if fnmatch.fnmatchcase(name, p)), None)
        if kind not in ("differs", "fault"):
            continue
        used.add(pattern)
        if pattern is None:
            failures.append("%s %s: %s" % (kind, name, text))
    failures += ["explained, but nothing differs: " + p for p in explained if p not in used]
    print_table(results)
    failures += further_failures(files, owns, folder)
    for failure in failures:
        print(failure)
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
