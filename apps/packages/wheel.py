#!/usr/bin/env python3
"""Makes a self-contained wheel of Python's package.

    wheel.py PREFIX OUT_DIR      PREFIX: an installation of the components trivet and python; needs patchelf, binutils

The libraries lie in trivet.libs under hashed names, so that they never meet other copies in a process; trivet-import
in trivet/_bin. STEP, IGES and BREP are left out, as Open CASCADE would double the size.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from bundle import COMPILER, GLIBC, bundle, copy_licences, highest_version

WHEEL = """Wheel-Version: 1.0
Generator: trivet apps/packages/wheel.py
Root-Is-Purelib: false
Tag: {tag}
"""


def gather(prefix: Path, root: Path) -> Path:
    """The package's files from the installation; the folder .dist-info of it."""
    sites = [path.parent for path in prefix.glob("lib/python3*/*-packages/trivet")]
    if len(sites) != 1:
        sys.exit(f"{prefix}: has {len(sites)} Python packages of trivet; accepted: 1, of the component python")
    shutil.copytree(sites[0], root, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
    (root / "trivet/_bin").mkdir()
    shutil.copy(prefix / "bin/trivet-import", root / "trivet/_bin/trivet-import")
    (root / "trivet/_paths.py").write_text(
        '"""Where the package\'s programs are; written by apps/packages/wheel.py."""\n'
        'IMPORTER = "_bin/trivet-import"\n')
    info, = root.glob("trivet-*.dist-info")
    return info


def make(prefix: Path, out: Path) -> None:
    with tempfile.TemporaryDirectory() as work:
        root = Path(work) / "wheel"
        info = gather(prefix, root)
        module, = (root / "trivet").glob("_trivet.cpython-*.so")
        files = [module, root / "trivet/_bin/trivet-import"]
        copies = bundle(files, root / "trivet.libs", leave=f"{GLIBC}|{COMPILER}")
        copy_licences(list(copies.values()), info / "licences")
        shutil.copy(Path(__file__).parents[2] / "LICENSE", info / "LICENSE")
        python = "cp" + re.search(r"cpython-(\d+)", module.name)[1]
        glibc = highest_version([*files, *copies], "GLIBC").replace(".", "_")
        (info / "WHEEL").write_text(WHEEL.format(tag=f"{python}-{python}-manylinux_{glibc}_x86_64"))
        # Writes RECORD; its bytes are the same for the same SOURCE_DATE_EPOCH.
        packed = subprocess.run([sys.executable, "-m", "wheel", "pack", str(root), "--dest-dir", str(out)],
                                capture_output=True, text=True)
        if packed.returncode != 0:
            sys.exit(f"python3 -m wheel pack: {packed.stderr.strip()}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    make(Path(sys.argv[1]), Path(sys.argv[2]))
