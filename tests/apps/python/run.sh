#!/usr/bin/env bash
# Tests of Python's package.
#   tests/apps/python/run.sh PYTHON PACKAGE_FOLDER test_NAME.py [options of pytest]
# Status 77: a prerequisite is missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
python="$1"
folder="$2"
shift 2
if [ -z "$python" ]; then
  echo "Skipped: the package was not built; install pybind11-dev, python3-dev and python3-numpy"
  exit 77
fi
if ! "$python" -c "import pytest" 2>/dev/null; then
  echo "Skipped: pytest is missing; install python3-pytest"
  exit 77
fi
if [ -n "${TRIVET_PROGRAM:-}" ] && [ ! -x "$TRIVET_PROGRAM" ]; then
  if [ -z "${TRIVET_ASAN_LIBRARIES:-}" ]; then
    echo "TRIVET_PROGRAM: $TRIVET_PROGRAM was not built"
    exit 1
  fi
  unset TRIVET_PROGRAM # .ci/sanitize.sh builds the module alone: tests beside the program are skipped
fi
if [ -n "${TRIVET_ASAN_LIBRARIES:-}" ]; then
  # Python keeps objects to its end, which count as leaks; by malloc(), so that they are watched, too.
  export LD_PRELOAD="$TRIVET_ASAN_LIBRARIES" ASAN_OPTIONS=detect_leaks=0 PYTHONMALLOC=malloc
  export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
fi
export PYTHONPATH="$folder${PYTHONPATH:+:$PYTHONPATH}" PYTHONDONTWRITEBYTECODE=1
exec "$python" -m pytest -q -p no:cacheprovider -W error::pytest.PytestUnhandledThreadExceptionWarning -rs "$@"
