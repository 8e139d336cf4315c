"""Reads every model file that Debian packages bring, with Trivet and a second reader, and compares.

    corpus.py TRIVET FOLDER

Box, area and number of triangles of OBJ, STL and PLY must agree; of other formats Trivet must give a model, or a
reason that is no fault of its own. Whatever disagrees must be in explained.tsv, and everything there must disagree
where its package is installed. Archives are unpacked below FOLDER.
"""
import json
import os
import subprocess
import sys
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import reader  # noqa: E402

PACKAGES = ["assimp-testmodels", "sweethome3d-furniture", "morse-simulator-data"]
OTHERS = {".dae", ".fbx", ".3ds", ".off", ".x3d", ".glb", ".gltf", ".3mf", ".ac", ".lwo", ".ms3d", ".b3d"}
LEAST = 500


def files_of(package, folder):
    """Model files of a package, by a name that does not depend on this machine."""
    listed = subprocess.run(["dpkg", "-L", package], capture_output=True, text=True)
    for path in listed.stdout.splitlines() if listed.returncode == 0 else []:
        extension = os.path.splitext(path)[1].lower()
        if extension == ".sh3f":
            yield from unpacked(package, path, folder / package / Path(path).stem)
        elif (extension in reader.READERS or extension in OTHERS) and os.path.isfile(path):
            yield package + "/" + os.path.basename(os.path.dirname(path)) + "/" + os.path.basename(path), path


def unpacked(package, archive, folder):
    with zipfile.ZipFile(archive) as packed:
        packed.extractall(folder)
    for path in sorted(folder.rglob("*")):
        if path.suffix.lower() in reader.READERS:
            yield package + "/" + folder.name + "/" + path.relative_to(folder).as_posix(), str(path)


def by_trivet(program, path):
    run = subprocess.run([program, "info", path, "--json"], capture_output=True, text=True, timeout=600)
    if run.returncode != 0:
        return None, run.stderr.strip().replace(path, os.path.basename(path)).splitlines()[-1]
    return json.loads(run.stdout), ""


def by_second(path):
    try:
        return reader.READERS[os.path.splitext(path)[1].lower()](Path(path).read_bytes()), ""
    except Exception as error:  # of a reader that trusts its files
        return None, "%s: %s" % (type(error).__name__, error)


def disagreement(found, second):
    """Empty: they agree."""
    size = max(max(abs(x) for x in second.lower + second.upper), 1e-300)
    if found["triangles"] != second.triangles:
        return "triangles %d, not %d" % (found["triangles"], second.triangles)
    for side, expected in (("lower", second.lower), ("upper", second.upper)):
        if max(abs(a - b) for a, b in zip(found["box"][side], expected)) > 1e-9 * size:
            return "box %s %r, not %r" % (side, found["box"][side], expected)
    # Twelve digits are printed; bent polygons have an area by their triangles only.
    if not second.bent and abs(found["area"] - second.area) > 1e-6 * max(second.area, 1e-300):
        return "area %r, not %r" % (found["area"], second.area)
    return ""


def verdict(program, name, path):
    found, why = by_trivet(program, path)
    if found is None and ("stopped with" in why or "longer than" in why):
        return name, "fault", why
    if os.path.splitext(path)[1].lower() not in reader.READERS:
        return name, "read" if found else "refused", why
    second, fault = by_second(path)
    if found is None or second is None or second.triangles == 0:
        alike = found is None and (second is None or second.triangles == 0)
        return name, "both refuse" if alike else "differs", "Trivet: %s; second: %s" % (
            why or "reads it", fault or "reads %d triangles" % (second.triangles if second else 0))
    text = disagreement(found, second)
    return name, "differs" if text else "agrees" + (" (but area of bent polygons)" if second.bent else ""), text


def explanations():
    lines = (Path(__file__).resolve().parent / "explained.tsv").read_text().splitlines()
    return dict(line.split("\t", 1) for line in lines if line and not line.startswith("#"))


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    files = [file for package in PACKAGES for file in files_of(package, folder)]
    if len(files) < LEAST:
        print("skipped: %d model files; install %s" % (len(files), " ".join(PACKAGES)))
        return 77
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda f: verdict(program, *f), files))
    counts, explained, failures = {}, explanations(), []
    for name, kind, text in results:
        counts[kind] = counts.get(kind, 0) + 1
        if kind in ("differs", "fault") and name not in explained:
            failures.append("%s %s: %s" % (kind, name, text))
        if kind not in ("differs", "fault") and name in explained:
            failures.append("explained, but %s: %s" % (kind, name))
    for kind in sorted(counts):
        print("%5d %s" % (counts[kind], kind))
    for failure in failures:
        print(failure)
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
