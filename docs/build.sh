#!/usr/bin/env bash
# Builds the documentation site; a warning is an error.
#   docs/build.sh [BUILD_FOLDER [OUTPUT_FOLDER]]     default: build/dev build/site; open its index.html
# Needs a build with Python (its package and program are documented from themselves), and the packages of
# `.ci/install-packages.sh docs`. Status 77: a prerequisite is missing.
set -euo pipefail
build="$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../build/dev}")"
output="$(realpath -m "${2:-$build/../site}")"
cd "$(dirname "${BASH_SOURCE[0]}")"
python="${PYTHON:-/usr/bin/python3}"
if ! "$python" -c "import sphinx, numpydoc, myst_parser, furo" 2>/dev/null; then
  echo "Skipped: install python3-sphinx, python3-numpydoc, python3-myst-parser and furo (.ci/install-packages.sh docs)"
  exit 77
fi
export PYTHONPATH="$build/apps/python${PYTHONPATH:+:$PYTHONPATH}" PYTHONDONTWRITEBYTECODE=1
export TRIVET_PROGRAM="$build/apps/trivet"
if ! "$python" -c "import trivet" 2>/dev/null; then
  echo "Skipped: Python's package is not in $build/apps/python; install pybind11-dev, python3-dev and python3-numpy, and build"
  exit 77
fi
rm -rf "$output"
"$python" -m sphinx -q -W --keep-going -b html -d "$output/.doctrees" . "$output"
rm -rf "$output/.doctrees"
if [ -d /usr/share/javascript/mathjax ]; then cp -rL /usr/share/javascript/mathjax "$output/_static/mathjax"; fi
echo "$(find "$output" -name '*.html' | wc -l) pages: $output/index.html"
