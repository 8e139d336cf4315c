#!/usr/bin/env bash
# Runs all tests on a fresh Debian 12: installs missing packages, builds, tests.
#   tests/run.sh [--asan|--tsan|--release] [options of ctest]
# Without an option, tests the preset dev: optimised, with assertions. For a single test see
# README.md.
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

.ci/install-packages.sh build editor cad convex exr serve python docs tests
.ci/build.sh "$preset"
ctest --preset "$preset" --parallel "$(nproc)" --no-tests=error "$@"
