#!/usr/bin/env bash
# Mutated model files: run.sh FUZZ_IMPORT TRIVET_IMPORT WORK_FOLDER [COUNT [SEED]]
set -euo pipefail
here="$(dirname "${BASH_SOURCE[0]}")"
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
python3 -B "$here/make_corpus.py" "$3/corpus"
"$1" "$2" "$3/corpus" "${4:-300}" "${5:-1}" "$3/kept"
