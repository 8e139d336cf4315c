#!/usr/bin/env bash
# Installs a build, then builds and runs a project that uses only the installation.
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
[ -s "$work_dir/prefix/share/trivet/layout.schema.json" ]
if [ -e "$work_dir/prefix/bin/trivet" ]; then
  "$work_dir/prefix/bin/trivet" --version
fi
