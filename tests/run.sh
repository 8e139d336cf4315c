#!/usr/bin/env bash
# Runs all tests on a fresh Debian 12: installs missing packages, builds, tests.
#   tests/run.sh [--long|--nightly|--asan|--tsan|--release] [options of ctest]
# Without an option, tests the preset dev (optimised, with assertions) but for tests labelled `long`,
# and random tests with TRIVET_TEST_EFFORT 0.2. --long runs those, too, with effort 0.4, as CI does;
# --nightly everything with effort 1, makes packages and uses them in bare systems, and installs
# Slurm for batches on a cluster. For a single test see README.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=dev
tests=""
effort=0.2
case "${1:-}" in
  --asan | --tsan | --release)
    preset="${1#--}"
    shift
    ;;
  --long)
    tests=long
    effort=0.4
    shift
    ;;
  --nightly)
    tests=nightly
    effort=1
    .ci/install-packages.sh packages farm
    shift
    ;;
  --help | -h)
    sed -n '2,7s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit 0
    ;;
esac

.ci/install-packages.sh build editor cad convex exr serve python docs tests
.ci/build.sh "$preset"
export TRIVET_TEST_EFFORT="${TRIVET_TEST_EFFORT:-$effort}"
# Twice as many as cores: half of the long ones wait for windows, clusters and processes that are to be killed.
ctest --preset "${tests:-$preset}" --parallel "$((2 * $(nproc)))" --no-tests=error "$@"
