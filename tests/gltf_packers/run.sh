#!/usr/bin/env bash
# Models packed by glTF-Transform and gltfpack are the unpacked ones within the quantum: run.sh TRIVET WORK_FOLDER
# Status 77: node, npm or its packages are missing.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
trivet="$1" work="$2"

skip() {
  echo "skipped: $*"
  exit 77
}

command -v python3 >/dev/null || skip "no python3"
command -v node >/dev/null && command -v npm >/dev/null || skip "no node, no npm (Debian: nodejs, npm)"
rm -rf "$work"
mkdir -p "$work"
cp "$here/package.json" "$work"
(cd "$work" && npm install --no-audit --no-fund --ignore-scripts > npm.log 2>&1) ||
  { cat "$work/npm.log"; skip "the packages of package.json cannot be had"; }
python3 -B "$here/check.py" "$trivet" "$work"
