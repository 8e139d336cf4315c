#!/usr/bin/env bash
# Builds and runs a share of the tests under the sanitizers; everything: tests/run.sh --asan, --tsan.
#   .ci/sanitize.sh asan|tsan|python [options of ctest]
# asan: programs that hold, read or write most, labelled `memory` in tests/CMakeLists.txt; tsan: those with
# threads, labelled `threads`; python: Python's module with asan, all its tests of bad input, threads and Ctrl+C.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset="$1"
target=""
shift
case "$preset" in
  asan) share=memory ;;
  tsan)
    share=threads
    export TRIVET_TEST_EFFORT="${TRIVET_TEST_EFFORT:-0.2}" # ten times slower, and races need no repetition
    ;;
  python)
    preset=asan
    share=python
    target=trivet_python
    ;;
  *)
    echo "$0: '$preset' is no sanitizer; try asan, tsan or python" >&2
    exit 2
    ;;
esac

TRIVET_TARGET="${target:-trivet_tests_$share}" .ci/build.sh "$preset" \
  -DTRIVET_EDITOR=OFF -DTRIVET_OCCT=OFF -DTRIVET_GPU=OFF
ctest --preset "$preset" --label-regex "$share" --parallel "$(nproc)" --no-tests=error --quiet \
  --output-log "build/$preset/$share.log" "$@" || {
  cat "build/$preset/$share.log"
  exit 1
}
tail -n 4 "build/$preset/$share.log"
