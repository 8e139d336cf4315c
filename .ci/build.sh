#!/usr/bin/env bash
# Configures and builds a preset on all cores, with ccache where there is one.
#   [TRIVET_TARGET='trivet trivet-import'] .ci/build.sh PRESET [options of cmake's configuration]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset="$1"
shift
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  # Clones share what they compile.
  export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
  # Precompiled headers: https://ccache.dev/manual/4.7.4.html#_precompiled_headers
  export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
fi
# A whole build is faster as a unity build of large units; folders that are configured keep what they have.
unity=()
[ -e "build/$preset/CMakeCache.txt" ] || unity=(-DTRIVET_UNITY=ON)
cmake --preset "$preset" "${unity[@]}" "$@"
read -ra targets <<<"${TRIVET_TARGET:-all}"
cmake --build --preset "$preset" --target "${targets[@]}" --parallel "$(nproc)" -- -k 0
