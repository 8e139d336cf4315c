#!/usr/bin/env bash
# Runs all tests on a fresh Debian 12: installs missing packages, builds, tests.
#   tests/run.sh [--asan|--tsan|--release|--nightly] [options of ctest]
# Without an option, tests the preset dev: optimised, with assertions, and the long random tests
# with TRIVET_TEST_EFFORT, by default 0.4. --nightly does everything with effort 1, and makes
# packages and uses them in bare systems. For a single test see README.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=dev
tests=""
effort=0.4
case "${1:-}" in
  --asan | --tsan | --release)
    preset="${1#--}"
    shift
    ;;
  --nightly)
    tests=nightly
    effort=1
    .ci/install-packages.sh packages
    shift
    ;;
  --help | -h)
    sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
esac

.ci/install-packages.sh build editor cad convex exr serve python docs tests
.ci/build.sh "$preset"
export TRIVET_TEST_EFFORT="${TRIVET_TEST_EFFORT:-$effort}"
# One more than cores: some wait for windows, clusters and processes that are to be killed.
ctest --preset "${tests:-$preset}" --parallel "$(($(nproc) + 1))" --no-tests=error "$@"
