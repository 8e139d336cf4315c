#!/usr/bin/env python3
"""Lays out a folder of trivet that runs wherever it is unpacked.

    tarball.py PREFIX FOLDER      PREFIX: an installation of the components trivet and cad; needs patchelf, binutils

bin/trivet starts libexec/trivet, which has its libraries in lib and trivet-import beside it. glibc and the graphics
driver stay the machine's. So does libstdc++, unless the machine has none or an older one (then lib/fallback), as its
driver may need a newer one than ours.
"""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from bundle import COMPILER, DRIVER, GLIBC, bundle, copy_licences, highest_version, resolved

STARTER = """#!/bin/sh
# Starts trivet; with lib/fallback where the machine's libstdc++ is missing or older than GLIBCXX_{libstdcxx}.
here=$(readlink -f "$0")
root=${{here%/bin/*}}
for folder in /usr/lib/x86_64-linux-gnu /lib/x86_64-linux-gnu /usr/lib64 /lib64 /usr/lib /lib; do
  if [ -e "$folder/libstdc++.so.6" ]; then
    grep -aqF GLIBCXX_{libstdcxx} "$folder/libstdc++.so.6" && exec "$root/libexec/trivet" "$@"
    break
  fi
done
LD_LIBRARY_PATH="$root/lib/fallback${{LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}}" exec "$root/libexec/trivet" "$@"
"""
README = """Trivet {version} for Linux on x86-64: run bin/trivet, from any folder, also by a link to it.

Needs:    glibc {glibc} or later (Debian 12, Ubuntu 24.04, RHEL 10 and later), /proc, sh, readlink, grep
Takes:    libstdc++ of the machine if it has GLIBCXX_{libstdcxx}, else lib/fallback
Pictures: by rays on the processor; by OpenGL where the machine has libEGL.so.1, libOpenGL.so.0 and a driver
Manual:   man -M share/man trivet
Licences: share/doc
bin/trivet doctor says what a machine lacks.
"""


def lay_out(prefix: Path, folder: Path) -> None:
    programs = []
    for program in sorted((prefix / "bin").iterdir()):
        target = folder / "libexec" / program.name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(program, target)
        programs.append(target)
    shutil.copytree(prefix / "share", folder / "share", symlinks=True)
    fallback = {name: path.resolve() for program in programs for name, path in resolved(program).items()
                if name.startswith(("libstdc++.", "libgcc_s."))}
    copies = bundle(programs, folder / "lib", leave=f"{GLIBC}|{DRIVER}|{COMPILER}")
    (folder / "lib/fallback").mkdir()
    for name, path in fallback.items():
        shutil.copy(path, folder / "lib/fallback" / name)
    copy_licences([*copies.values(), *fallback.values()], folder / "share/doc/trivet/licences")
    write_texts(folder, [*programs, *copies])


def write_texts(folder: Path, files: list[Path]) -> None:
    values = {
        "version": folder.name.split("-")[1],
        "glibc": highest_version([*files, *(folder / "lib/fallback").iterdir()], "GLIBC"),
        "libstdcxx": highest_version(files, "GLIBCXX"),
    }
    starter = folder / "bin/trivet"
    starter.parent.mkdir()
    starter.write_text(STARTER.format(**values))
    starter.chmod(0o755)
    (folder / "README").write_text(README.format(**values))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    lay_out(Path(sys.argv[1]), Path(sys.argv[2]))
