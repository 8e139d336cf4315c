#!/usr/bin/env bash
# Builds the pages of Python's documentation; warnings are errors.
#   tests/apps/python/sphinx.sh PYTHON PACKAGE_FOLDER OUTPUT_FOLDER
# Status 77: a prerequisite is missing.
set -euo pipefail
docs="$(cd "$(dirname "${BASH_SOURCE[0]}")/../../../apps/python/docs" && pwd)"
python="$1" package="$2" output="$3"
if [ -z "$python" ]; then
  echo "Skipped: the package was not built; install pybind11-dev, python3-dev and python3-numpy"
  exit 77
fi
if ! "$python" -c "import sphinx, numpydoc" 2>/dev/null; then
  echo "Skipped: Sphinx or numpydoc is missing; install python3-sphinx and python3-numpydoc"
  exit 77
fi
rm -rf "$output"
PYTHONPATH="$package${PYTHONPATH:+:$PYTHONPATH}" PYTHONDONTWRITEBYTECODE=1 \
  "$python" -m sphinx -q -W --keep-going -b html -d "$output/doctrees" "$docs" "$output/html"
for page in index tutorial examples cookbook notebooks faq report api; do
  grep -q "<h1>" "$output/html/$page.html"
done
# All that is public has an entry.
"$python" - "$output/html/api.html" "$package" <<'END'
import sys
sys.path.insert(0, sys.argv[2])
import trivet
page = open(sys.argv[1], encoding="utf-8").read()
missing = [name for name in trivet.__all__
           if name not in ("__version__", "CAUSES", "FLOOR") and f'id="trivet.{name}"' not in page]
missing += [f"Scene.{name}" for name in ("check", "render", "labels", "view") if f'id="trivet.Scene.{name}"' not in page]
sys.exit(f"not on the page: {missing}" if missing else 0)
END
