#!/usr/bin/env bash
# Writes the manual pages of the programs, of what they say themselves by --help: trivet.1, trivet-VERB.1, trivet-edit.1.
#   manual_pages.sh OUT_DIR VERSION TRIVET [TRIVET_EDIT]
# Needs help2man. Dates are of SOURCE_DATE_EPOCH.
set -euo pipefail
out="$1" version="$2" trivet="$3" edit="${4:-}"
export QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
rm -rf "$out"

# page FOLDER NAME SUMMARY SEE COMMAND...: help2man takes the page's name from that of the program
page() {
  local folder="$1" name="$2" summary="$3" see="$4" words
  shift 4
  printf -v words '%q ' "$@"
  printf '#!/bin/sh\nexec %s "$@"\n' "$words" >"$work/$name"
  chmod +x "$work/$name"
  printf '[SEE ALSO]\n%s\n' "$see" >"$work/see"
  mkdir -p "$out/$folder"
  help2man --no-info --version-string="$version" --name="$summary" --include="$work/see" "$work/$name" |
    gzip -9n >"$out/$folder/$name.1.gz"
}
# The first sentence that a verb says of itself, as the summary of a page.
summary() { "$@" --help | sed '/^Usage:/,$d' | tr '\n' ' ' | sed 's/^\(.\)/\L\1/;s/[:;.(].*//;s/ *$//'; }

mapfile -t verbs < <("$trivet" --help |
  awk '/^Subcommands:/ { on = 1; next } on && !/^ / { exit } on && /^  [a-z]/ { print $1 }')
if [ ${#verbs[@]} -lt 10 ]; then
  echo "$0: only ${#verbs[@]} verbs found in $trivet --help" >&2
  exit 1
fi
see=""
for verb in "${verbs[@]}"; do
  page trivet "trivet-$verb" "$(summary "$trivet" "$verb")" '.BR trivet (1)' "$trivet" "$verb"
  see+=".BR trivet-$verb (1),"$'\n'
done
page trivet trivet "lay out 3D objects without interpenetration, at rest" "$see.BR trivet-edit (1)" "$trivet"
[ -z "$edit" ] ||
  page edit trivet-edit "edit layouts of 3D objects by mouse" '.BR trivet (1)' "$edit"
