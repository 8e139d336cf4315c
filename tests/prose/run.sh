#!/usr/bin/env bash
# Checks what can be counted in documents and comments, and their links. Status 77: this is no checkout.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
git -C "$root" rev-parse --git-dir >/dev/null 2>&1 || { echo "skipped: no checkout of git"; exit 77; }
status=0
python3 "$root/tests/prose/prose.py" "$root" || status=1
python3 "$root/tests/prose/links.py" "$root" || status=1
exit $status
