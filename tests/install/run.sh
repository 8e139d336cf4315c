#!/usr/bin/env bash
# Installs a build, then builds and runs projects that use only the installation.
#   tests/install/run.sh BUILD_DIR WORK_DIR [options of cmake's configuration]
set -euo pipefail
source_dir="$(dirname "${BASH_SOURCE[0]}")"
build_dir="$1"
work_dir="$(realpath -m "$2")"
shift 2

rm -rf "$work_dir"
cmake --install "$build_dir" --prefix "$work_dir/prefix" >/dev/null
cmake -S "$source_dir" -B "$work_dir/build" -DCMAKE_PREFIX_PATH="$work_dir/prefix" "$@"
cmake --build "$work_dir/build"
"$work_dir/build/box_on_floor"

# Geometry alone links no reader of files.
cmake -S "$source_dir" -B "$work_dir/geometry" -DCMAKE_PREFIX_PATH="$work_dir/prefix" -DONLY_GEOMETRY=ON "$@"
cmake --build "$work_dir/geometry"
"$work_dir/geometry/fall"
if grep -rE 'assimp|nlohmann|tinyxml2|libccd|libtrivet_io' "$work_dir/geometry" \
  --include=build.ninja --include=link.txt; then
  echo "trivet::geometry must not need these"
  exit 1
fi

[ -s "$work_dir/prefix/share/trivet/layout.schema.json" ]
if [ -e "$work_dir/prefix/bin/trivet" ]; then
  "$work_dir/prefix/bin/trivet" --version
fi

# Python's package, with the importer of the same prefix.
package="$(dirname "$(find "$work_dir/prefix" -path '*/trivet/_trivet*.so' | head -1)" 2>/dev/null || true)"
if [ -n "$package" ] && [ "$package" != . ]; then
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' >"$work_dir/solid.obj"
  for python in python3 /usr/bin/python3; do
    if "$python" -c "import numpy" 2>/dev/null; then
      PYTHONPATH="$(dirname "$package")" "$python" -c "
import sys, trivet
scene = trivet.Scene()
scene.add('solid', trivet.Shape.load(sys.argv[1])).put([0, 0, 2])
assert scene.check().ok" "$work_dir/solid.obj"
      break
    fi
  done
fi
