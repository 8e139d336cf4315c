#!/usr/bin/env bash
# Compiles sources alone that may miss an include (alone.py). Then runs clang-tidy on the files that differ from the
# main branch, on those of the last commit where there is none or nothing differs. A header is checked through the
# source of its name, else through one that includes it.
#   .ci/tidy.sh [BASE]     the commit to compare with
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# A file takes 10 to 20 s of CPU time: of more files, those with the most changed lines.
max_files=20

find_base() {
  local base head
  head="$(git rev-parse HEAD)"
  base="$(git merge-base HEAD origin/main 2>/dev/null || true)"
  if [ -z "$base" ] || [ "$base" = "$head" ]; then
    base="$(git rev-parse --verify --quiet HEAD~1 || true)"
  fi
  echo "$base"
}

# Changed C++ files, most changed lines first.
changed_files() {
  git diff --numstat --no-renames --diff-filter=d "$1" -- '*.cpp' '*.h' |
    awk '{ print $1 + $2, $3 }' | sort -k1,1nr -k2 | cut -d' ' -f2
}

# The sources through which they are compiled: those in the compilation database.
sources_of() {
  local file source
  while read -r file; do
    source="${file%.*}.cpp"
    if ! grep -qF "/$source\"" "$database"; then
      source="$(git grep -lF "#include \"$file\"" -- '*.cpp' | head -n 1 || true)"
    fi
    if [ -n "$source" ] && grep -qF "/$source\"" "$database"; then echo "$source"; fi
  done | awk '!seen[$0]++'
}

base="${1:-$(find_base)}"
if [ -z "$base" ]; then
  echo "clang-tidy: no earlier commit to compare with, nothing is checked"
  exit 0
fi
# Configured, not built, and without gcc's precompiled headers, which clang cannot read.
cmake --preset dev -B build/tidy -DTRIVET_PRECOMPILE=OFF >/dev/null
database=build/tidy/compile_commands.json
.ci/alone.py "$base"

mapfile -t files < <(changed_files "$base" | sources_of)
echo "clang-tidy: ${#files[@]} sources differ from $(git rev-parse --short "$base")"
if [ ${#files[@]} -gt "$max_files" ]; then
  echo "clang-tidy: only the $max_files with the most changes are checked"
  files=("${files[@]:0:max_files}")
fi
[ ${#files[@]} -gt 0 ] || exit 0
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" \
  clang-tidy -p build/tidy --quiet --warnings-as-errors='*' 2> >(grep -v 'warnings generated' >&2)
echo "clang-tidy: nothing found"
