"""Copies the shared libraries of programs and modules beside them, found by relative paths."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

# glibc and its loader are always the machine's: drivers and other libraries of the machine share the process.
GLIBC = r"(ld-linux.*|lib(c|m|dl|pthread|rt|resolv|util|anl|mvec|nsl))\.so\."
# The machine's graphics driver and what loads it, which libepoxy opens when pictures want OpenGL.
DRIVER = r"lib(EGL|GL|GLX|GLdispatch|OpenGL|GLES.*|gbm|drm.*|glapi|LLVM.*)\.so"
COMPILER = r"lib(stdc\+\+|gcc_s)\.so\."
# A header of each library that is compiled in; not every program has all of them.
COMPILED_IN = ("eigen3/Eigen/Core", "nlohmann/json.hpp", "CLI/CLI.hpp", "pybind11/pybind11.h", "boost/version.hpp",
               "stb/stb_image.h")


def run(*command: object) -> str:
    """Output of a command. Ends the program with the command's words if it fails."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in command)}: {done.stderr.strip()}")
    return done.stdout


def needed(file: Path) -> list[str]:
    return re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "-d", file))


def resolved(file: Path) -> dict[str, Path]:
    """Every library that `file` needs, directly or not, and where this machine has it."""
    lines = run("ldd", file)
    missing = re.findall(r"(\S+) => not found", lines)
    if missing:
        sys.exit(f"{file}: not found on this machine: {', '.join(missing)}")
    return {name: Path(path) for name, path in re.findall(r"(\S+) => (\S+) \(", lines)}


def highest_version(files: list[Path], prefix: str) -> str:
    """The newest version of a library's symbols, such as GLIBC_2.36, that any of the files asks for."""
    found = {text for file in files for text in re.findall(prefix + r"_([0-9.]+)", run("readelf", "-V", file))}
    return max(found, key=lambda text: [int(part) for part in text.split(".")], default="0")


def hashed_name(soname: str, file: Path) -> str:
    """A name that no other copy of the library in the same process has."""
    stem, _, rest = soname.partition(".so")
    return f"{stem}-{hashlib.sha256(file.read_bytes()).hexdigest()[:8]}.so{rest}"


def point_to(file: Path, names: dict[str, str], folder: Path) -> None:
    """Makes `file` need libraries by their new names, and look for them in `folder`."""
    replaced = [soname for soname in needed(file) if soname in names]
    if replaced:
        words = [word for soname in replaced for word in ("--replace-needed", soname, names[soname])]
        run("patchelf", *words, file)
    # A call of its own: patchelf 0.14 mixes up different actions of one call, without an error.
    path = "$ORIGIN/" + os.path.relpath(folder, file.parent)
    run("patchelf", "--set-rpath", path, file)
    if set(needed(file)) & set(replaced) or f"[{path}]" not in run("readelf", "-d", file):
        sys.exit(f"{file}: patchelf did not do what it was told")


def bundle(files: list[Path], folder: Path, leave: str) -> dict[Path, Path]:
    """Copies what `files` need into `folder`, but not what matches `leave`, and points all to it.

    Under names of their own, so that neither LD_LIBRARY_PATH nor another library in the process (a graphics driver,
    NumPy) makes one stand for another. Returns the copies, and where each comes from.
    """
    folder.mkdir(parents=True, exist_ok=True)
    sources = {name: path for file in files for name, path in resolved(file).items() if not re.match(leave, name)}
    names = {soname: hashed_name(soname, path) for soname, path in sources.items()}
    copies = {}
    for soname, path in sorted(sources.items()):
        copy = folder / names[soname]
        shutil.copyfile(path.resolve(), copy)
        copy.chmod(0o755)
        run("strip", "--strip-unneeded", copy)
        copies[copy] = path.resolve()
    for copy in copies:
        run("patchelf", "--set-soname", copy.name, copy)
    for file in [*files, *copies]:
        point_to(file, names, folder)
    return copies


def packages_of(files: list[Path]) -> set[str]:
    """The Debian packages that files of this machine come from."""
    # Merged folders: packages list files as /lib/..., not as /usr/lib/...
    names = {variant: file for file in files for variant in (str(file), str(file).removeprefix("/usr"))}
    done = subprocess.run(["dpkg-query", "--search", *names], capture_output=True, text=True)
    found = {names[path]: owners for owners, path in re.findall(r"^(.+): (/.+)$", done.stdout, re.M)}
    unknown = [str(file) for file in files if file not in found]
    if unknown:
        sys.exit(f"{', '.join(unknown)}: of no Debian package, so of unknown licence; accepted: libraries of packages")
    return {owners.split(",")[0].split(":")[0] for owners in found.values()}


def copy_licences(libraries: list[Path], folder: Path) -> None:
    """The copyright files of the packages that the libraries come from, and those that are compiled in."""
    folder.mkdir(parents=True, exist_ok=True)
    headers = [file for file in (Path("/usr/include") / name for name in COMPILED_IN) if file.is_file()]
    for package in sorted(packages_of([*libraries, *headers])):
        source = Path("/usr/share/doc") / package / "copyright"
        if not source.is_file():
            sys.exit(f"{source}: the licence of a bundled library is missing; reinstall {package}")
        shutil.copyfile(source, folder / f"{package}.txt")
