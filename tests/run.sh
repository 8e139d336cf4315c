#!/usr/bin/env bash
# Runs all tests on a fresh Debian 12: installs missing packages, builds, tests.
#   tests/run.sh [--asan|--tsan|--release|--nightly] [options of ctest]
# Without an option, tests the preset dev: optimised, with assertions; --nightly
# makes packages and uses them in bare systems. For a single test see README.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=dev
tests=""
case "${1:-}" in
  --asan | --tsan | --release)
    preset="${1#--}"
    shift
    ;;
  --nightly)
    tests=nightly
    .ci/install-packages.sh packages
    shift
    ;;
  --help | -h)
    sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
esac

.ci/install-packages.sh build editor cad convex exr serve python docs tests
.ci/build.sh "$preset"
ctest --preset "${tests:-$preset}" --parallel "$(nproc)" --no-tests=error "$@"
