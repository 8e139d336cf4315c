#!/usr/bin/env bash
# Model files of Debian packages, read by Trivet and by a second reader: run.sh TRIVET WORK_FOLDER
set -euo pipefail
command -v python3 >/dev/null && command -v dpkg >/dev/null || { echo "skipped: no python3, or no dpkg"; exit 77; }
mkdir -p "$2"
python3 -B "$(dirname "${BASH_SOURCE[0]}")/corpus.py" "$1" "$2"
