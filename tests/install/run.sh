#!/usr/bin/env bash
# Installs a build, then builds and runs projects that use only the installation.
#   tests/install/run.sh BUILD_DIR WORK_DIR [options of cmake's configuration]
set -euo pipefail
source_dir="$(realpath "$(dirname "${BASH_SOURCE[0]}")")"
build_dir="$(realpath "$1")"
work_dir="$(realpath -m "$2")"
shift 2

rm -rf "$work_dir"
cmake --install "$build_dir" --prefix "$work_dir/prefix" >/dev/null
readme="$(realpath "$source_dir/../../README.md")"
cmake -S "$source_dir" -B "$work_dir/build" -DCMAKE_PREFIX_PATH="$work_dir/prefix" -DREADME="$readme" "$@"
cmake --build "$work_dir/build"
cd "$work_dir"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' >cup.obj
build/box_on_floor
build/first
[ -s scene.glb ]

# The umbrella is small: lines as preprocessed.
lines="$(echo '#include <trivet/trivet.h>' | "${CXX:-c++}" -std=c++20 -I prefix/include -E -P -x c++ - | wc -l)"
all="$(echo '#include <trivet/trivet.h>' | "${CXX:-c++}" -std=c++20 -I prefix/include -E -x c++ - | wc -l)"
echo "trivet.h: $all lines as preprocessed, $lines without blank ones"
[ "$all" -lt 60000 ] || { echo "trivet.h has $all lines as preprocessed; accepted: below 60,000"; exit 1; }

# The shared library shows its interface and nothing else.
library="$(find prefix -name 'libtrivet.so' | head -1)"
others="$(nm -D --defined-only --demangle "$library" | grep -vE ' (V|W|B|u) ' | grep -vE ' [A-Z] (trivet::v0::|typeinfo|vtable)' || true)"
[ -z "$others" ] || [[ "$*" == *fsanitize* ]] || { echo "symbols beyond the interface:"; head -20 <<<"$others"; exit 1; }

for with in geometry static; do
  cmake -S "$source_dir" -B "$with" -DCMAKE_PREFIX_PATH="$work_dir/prefix" -DWITH=$with "$@"
  cmake --build "$with"
done
geometry/fall
static/box_on_floor
# Geometry alone links no reader of files.
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
  for python in python3 /usr/bin/python3; do
    if "$python" -c "import numpy" 2>/dev/null; then
      PYTHONPATH="$(dirname "$package")" "$python" -c "
import sys, trivet
scene = trivet.Scene()
scene.add('solid', trivet.Shape.load(sys.argv[1])).put([0, 0, 2])
assert scene.check().ok" "$work_dir/cup.obj"
      break
    fi
  done
fi
