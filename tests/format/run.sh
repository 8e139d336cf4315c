#!/usr/bin/env bash
# Checks that all sources follow .clang-format and that no file has conflict markers.
#   tests/format/run.sh [--fix]
# Versions of clang-format disagree: one is decisive, without it the test is skipped (status 77).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
version=14

if git grep -nE '^(<{7}|>{7}) ' 2>/dev/null; then
  echo "these lines are conflict markers of a merge"
  exit 1
fi

for program in "clang-format-$version" clang-format; do
  if "$program" --version 2>/dev/null | grep -q "version $version\."; then
    mode=(--dry-run -Werror)
    [ "${1:-}" != --fix ] || mode=(-i)
    find . \( -path ./build -o -path ./out -o -path ./.git \) -prune -o \
      \( -name '*.cpp' -o -name '*.h' \) -print0 | xargs -0 "$program" "${mode[@]}"
    exit
  fi
done
echo "skipped: no clang-format of version $version (Debian 12: clang-format)"
exit 77
