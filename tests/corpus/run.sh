#!/usr/bin/env bash
# Model files of Debian packages, read by Trivet and by a second reader: run.sh TRIVET WORK_FOLDER
# Status 77: the packages, node, npm or what package.json names are missing. OpenSceneGraph, CGAL, OpenMesh, tinyobjloader and
# Blender are optional; what is missing is named.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
trivet="$(realpath "$1")" work="$2"

skip() {
  echo "skipped: $*"
  exit 77
}

command -v python3 >/dev/null && command -v dpkg >/dev/null || skip "no python3, or no dpkg"
command -v node >/dev/null && command -v npm >/dev/null || skip "no node, no npm (Debian: nodejs, npm)"
mkdir -p "$work"
cp "$here/package.json" "$here/three_reader.mjs" "$work"
(cd "$work" && npm install --no-audit --no-fund --ignore-scripts > npm.log 2>&1) ||
  { cat "$work/npm.log"; skip "the packages of package.json cannot be had"; }
# A minute of compiling.
if [ ! "$work/mesh_readers" -nt "$here/mesh_readers.cpp" ]; then
  openmesh=""
  if pkg-config --exists openmesh; then
    openmesh="-DTRIVET_TEST_OPENMESH $(pkg-config --cflags --libs openmesh)"
  else
    echo "not installed, left out: OpenMesh (Debian: libopenmesh-dev)"
  fi
  # shellcheck disable=SC2086
  c++ -std=c++20 -O1 -w "$here/mesh_readers.cpp" -o "$work/mesh_readers" $openmesh -lgmp -lmpfr > "$work/readers.log" 2>&1 ||
    tail -3 "$work/readers.log"
fi
python3 -B "$here/corpus.py" "$trivet" "$work"
