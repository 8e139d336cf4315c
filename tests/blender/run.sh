#!/usr/bin/env bash
# Tests of the add-on for Blender.
#   tests/blender/run.sh logic|reading|cases|rounds|put|operators|window PYTHON MODULE_FOLDER TRIVET WORK_FOLDER
# logic runs without Blender. Status 77: a prerequisite is missing.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
addon="$here/../../apps/blender"
job="$1" python="$2" module="$3" trivet="$4" work="$5/$1"

skip() {
  echo "Skipped: $*"
  exit 77
}

[ -n "$python" ] || skip "Python's package was not built; install pybind11-dev, python3-dev and python3-numpy"
export PYTHONDONTWRITEBYTECODE=1
rm -rf "$work"
mkdir -p "$work"
if [ "$job" = logic ]; then
  cd "$here"
  PYTHONPATH="$addon:$module" TRIVET_PROGRAM="$trivet" exec "$python" -m unittest -v test_logic test_zip
fi
command -v blender >/dev/null || skip "Blender is missing; install blender"
# Settings of the user stay out of it, and are not touched.
zip="$work/trivet_addon.zip"
"$python" "$addon/make_zip.py" "$zip"
export HOME="$work" XDG_CONFIG_HOME="$work" BLENDER_USER_CONFIG="$work/config" BLENDER_USER_SCRIPTS="$work/scripts"
if [ "$job" = window ]; then
  mkdir "$work/pictures"
  export LIBGL_ALWAYS_SOFTWARE=1
  exec bash "$here/../support/virtual_screen.sh" 1280x800x24 timeout 900 blender --factory-startup --enable-event-simulate -p 0 0 1280 800 \
    -P "$here/test_window.py" -- "$zip" "$module" "$trivet" "$work/pictures"
fi
exec blender -b --factory-startup --python-exit-code 9 -P "$here/test_$job.py" -- "$zip" "$module" "$trivet"
