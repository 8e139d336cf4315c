#!/usr/bin/env bash
# Configures and builds a preset on all cores, with ccache where there is one.
#   [TRIVET_TARGET=trivet] .ci/build.sh PRESET [options of cmake's configuration]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset="$1"
shift
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  # Clones share what they compile.
  export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
fi
cmake --preset "$preset" "$@"
cmake --build --preset "$preset" --target "${TRIVET_TARGET:-all}" --parallel "$(nproc)"
