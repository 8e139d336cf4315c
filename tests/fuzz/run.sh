#!/usr/bin/env bash
# Fuzzes with mutated model files: run.sh FUZZ_IMPORT TRIVET_IMPORT WORK_FOLDER [COUNT [SEED
# [MAKE_CAD]]], or run.sh FUZZ_READERS - WORK_FOLDER [COUNT [SEED]]
# COUNT times TRIVET_TEST_EFFORT files. MAKE_CAD may be "others": formats that assimp reads. With MAKE_CAD, that program generates the STEP, IGES and BREP files; "none": it was not built.
set -euo pipefail
here="$(dirname "${BASH_SOURCE[0]}")"
mkdir -p "$3/corpus"
if [ "${6:-}" = none ]; then
  echo "skipped: this build has no Open CASCADE"
  exit 77
elif [ "${6:-}" = others ]; then
  command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
  python3 -B "$here/make_corpus.py" "$3/corpus" others
elif [ -n "${6:-}" ]; then
  "$6" "$3/corpus"
else
  command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
  python3 -B "$here/make_corpus.py" "$3/corpus"
fi
count="$(awk -v count="${4:-300}" -v effort="${TRIVET_TEST_EFFORT:-1}" 'BEGIN { printf "%.0f", count * effort }')"
importer=("$2")
[ "$2" != - ] || importer=()
"$1" "${importer[@]}" "$3/corpus" "$count" "${5:-1}" "$3/kept"
