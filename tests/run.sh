#!/usr/bin/env bash
# From a fresh Debian 12 to the verdict of all tests: installs what is missing, builds, runs.
#   tests/run.sh [--asan|--tsan|--release] [options of ctest]
# Without an option the preset dev is tested: optimised, with assertions. For one test see README.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=dev
case "${1:-}" in
  --asan | --tsan | --release)
    preset="${1#--}"
    shift
    ;;
  --help | -h)
    sed -n '2,4s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
esac

.ci/install-packages.sh build editor cad convex tests
.ci/build.sh "$preset"
ctest --preset "$preset" --parallel "$(nproc)" --no-tests=error "$@"
