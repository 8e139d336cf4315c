#!/usr/bin/env bash
# Builds the documentation site, and looks at its pages and links; warnings are errors.
#   tests/apps/python/sphinx.sh PYTHON PACKAGE_FOLDER OUTPUT_FOLDER
# Status 77: a prerequisite is missing.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)"
python="$1" package="$2" output="$3"
if [ -z "$python" ]; then
  echo "Skipped: the package was not built; install pybind11-dev, python3-dev and python3-numpy"
  exit 77
fi
status=0
PYTHON="$python" "$root/docs/build.sh" "$package/../.." "$output/html" || status=$?
[ $status -eq 0 ] || exit $status
for page in index tutorial/index guide/index reference/index python/index python/tutorial python/examples python/cookbook \
  python/notebooks python/faq reference/report python/api; do
  grep -q "<h1>" "$output/html/$page.html"
done
"$python" "$root/tests/prose/links.py" --site "$output/html"
"$python" "$root/tests/prose/pages.py" "$output/html" "$output/pictures" || [ $? -eq 77 ]
# All verbs have their help there, those of other verbs, too.
for verb in info mcp schema batch batch-merge; do
  grep -q "id=\"trivet-$verb\"" "$output/html/reference/command-line.html"
done
# All that is public has an entry.
"$python" - "$output/html/python/api.html" "$package" <<'END'
import sys
sys.path.insert(0, sys.argv[2])
import trivet
page = open(sys.argv[1], encoding="utf-8").read()
missing = [name for name in trivet.__all__
           if name not in ("__version__", "CAUSES", "FLOOR") and f'id="trivet.{name}"' not in page]
missing += [f"Scene.{name}" for name in ("check", "render", "labels", "view") if f'id="trivet.Scene.{name}"' not in page]
sys.exit(f"not on the page: {missing}" if missing else 0)
END
