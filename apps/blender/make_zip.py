#!/usr/bin/env python3
"""Packs the add-on as a zip that Blender installs: make_zip.py OUTPUT.zip

The version is that of include/trivet/version.h. The same zip is an add-on for Blender 3.4 to 4.1 (bl_info) and an
extension from 4.2 on (blender_manifest.toml). The same sources give the same bytes.
"""
import re
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PACKAGE = "trivet_addon"
MANIFEST = """schema_version = "1.0.0"
id = "{package}"
version = "{version}"
name = "Trivet"
tagline = "Objects that never interpenetrate and always lie at rest"
maintainer = "The Trivet authors"
type = "add-on"
blender_version_min = "4.2.0"
license = ["SPDX:MIT"]
tags = ["Object", "Physics"]

[permissions]
files = "Models in a temporary folder, exported scenes"
"""


def version() -> str:
    """Version of Trivet, by its one place."""
    text = (HERE.parent.parent / "include/trivet/version.h").read_text(encoding="utf-8")
    found = re.findall(r"#define TRIVET_VERSION_(?:MAJOR|MINOR|PATCH) ([0-9]+)", text)
    if len(found) != 3:
        raise SystemExit("include/trivet/version.h: no TRIVET_VERSION_MAJOR, _MINOR and _PATCH")
    return ".".join(found)


def files() -> dict:
    """{path in the zip: bytes}"""
    number = version()
    out = {}
    for path in sorted((HERE / PACKAGE).glob("*.py")):
        text = path.read_text(encoding="utf-8")
        if path.name == "__init__.py":
            text, count = re.subn(r'"version": \([0-9, ]+\)', f'"version": ({number.replace(".", ", ")})', text)
            if count != 1:
                raise SystemExit(f"{path}: {count} versions in bl_info; accepted: 1")
        out[f"{PACKAGE}/{path.name}"] = text.encode()
    out[f"{PACKAGE}/blender_manifest.toml"] = MANIFEST.format(package=PACKAGE, version=number).encode()
    out[f"{PACKAGE}/LICENSE"] = (HERE.parent.parent / "LICENSE").read_bytes()
    return out


def main() -> int:
    if len(sys.argv) != 2 or not sys.argv[1].endswith(".zip"):
        print("usage: make_zip.py OUTPUT.zip", file=sys.stderr)
        return 2
    with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files().items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
    print(sys.argv[1])
    return 0


if __name__ == "__main__":
    sys.exit(main())
