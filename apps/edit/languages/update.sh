#!/bin/bash
# Brings the translations up to date with the sources: new texts are added as unfinished, unused ones go.
cd "$(dirname "$0")/../../.." || exit 1
exec "${LUPDATE:-/usr/lib/qt6/bin/lupdate}" -no-obsolete -locations none -I . apps/edit -ts apps/edit/languages/*.ts
