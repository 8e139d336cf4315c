#!/usr/bin/env bash
# Compiles core and the pictures by rays against Embree 4 in a Debian 13 and runs their tests there: boxes and rays (index), motion, contact, path tracing.
#   tests/embree4/run.sh SOURCE_DIR WORK_DIR
# A test of the label nightly: root, debootstrap, a mirror of Debian, half an hour of CPU the first time. Skipped (status 77) without. The bare system,
# the build and what was built with stay in WORK_DIR.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source_dir="$(realpath "$1")"
mkdir -p "$2"
work="$(realpath "$2")" roots="$(realpath "$2")/roots"

say() { printf '%s %s\n' "$(date +%T)" "$*"; }
skip() {
  say "skipped: $*"
  exit 77
}
fail() {
  say "FAILED: $*"
  exit 1
}
. "$here/../packages/roots.sh"
[ "$(id -u)" = 0 ] || skip "not root"
PATH="$PATH:/usr/sbin:/sbin" command -v debootstrap >/dev/null || skip "no debootstrap; .ci/install-packages.sh packages"
unshare --mount --pid --fork true 2>/dev/null || skip "namespaces are not allowed"

# Packages of .ci/packages.txt that the libraries and their tests need.
packages="$(awk '$1 == "build" && $2 !~ /mesa|^ccache$|epoxy/ { print $2 }' "$source_dir/.ci/packages.txt" | paste -sd,)"
bare_root trixie trixie "$packages,libgtest-dev"
job="$work/job"
rm -rf "$job/sources"
mkdir -p "$job/sources"
tar -C "$source_dir" --exclude=./build --exclude=./.git -cf - . | tar -C "$job/sources" -xf -

# Warnings are no errors: gcc 14 sees std::sort() go beyond an array of eight, which it does not.
say "compiling"
in_root "$roots/trixie" "$job" '
  cmake -S sources -B build -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2" -DTRIVET_TESTS=ON -DTRIVET_WERROR=OFF \
    -DTRIVET_UNITY=ON -DTRIVET_GPU=OFF -DTRIVET_EDITOR=OFF -DTRIVET_OCCT=OFF -DTRIVET_SERVE=OFF -DTRIVET_PYTHON=OFF >configured.txt 2>&1 ||
    { tail -n 20 configured.txt; exit 1; }
  nice ninja -C build test_core_index test_core_motion test_core_contact test_raster_path >built.txt 2>&1 ||
    { grep -m 20 -A 5 -E "error|FAILED" built.txt; exit 1; }
' || fail "it does not compile"
say "testing"
in_root "$roots/trixie" "$job" '
  for test in index motion contact; do
    ldd build/tests/test_core_$test | grep -o "libembree[^ ]*" | sort -u | sed "s/^/test_core_$test: /"
  done >linked.txt
  grep -q "test_core_index: libembree4" linked.txt || { echo "Embree 4 is not linked:"; cat linked.txt; exit 1; }
  dpkg-query -W -f "\${Package} \${Version}\n" libembree-dev g++ libeigen3-dev
  for test in core_index core_motion core_contact raster_path; do
    build/tests/test_$test >$test.txt 2>&1 || { grep -A 10 FAILED $test.txt | head -n 40; exit 1; }
    echo "$test: $(grep "PASSED" $test.txt), $(grep -c "SKIPPED \] .*(" $test.txt || true) skipped"
  done
' || fail "tests with Embree 4"
say "passed"
