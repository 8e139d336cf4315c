#!/bin/bash
# Brings the translations up to date with the sources: new texts are added as unfinished, unused ones go. English has
# the singular of texts with a number alone.
#   update.sh [FOLDER]      of the .ts files; default: this one
cd "$(dirname "$0")/../../.." || exit 1
folder="${1:-apps/edit/languages}"
update() {
  "${LUPDATE:-/usr/lib/qt6/bin/lupdate}" -silent -no-obsolete -locations none -I . "$@"
}
patterns="$(mktemp -d)"
trap 'rm -r "$patterns"' EXIT
python3 apps/edit/languages/patterns.py "$patterns/patterns.cpp" || exit 1
sources=(apps/edit "$patterns/patterns.cpp")
update "${sources[@]}" -ts "$folder/trivet-edit_de.ts" && update -pluralonly "${sources[@]}" -ts "$folder/trivet-edit_en.ts"
