#!/bin/bash
# Runs the program of this folder in a window of a virtual screen. Status 77: no virtual screen.
# Usage: [TRIVET_SCREEN=WIDTHxHEIGHT] run.sh PROGRAM FOLDER [TEST...]
screen="$(cd "$(dirname "${BASH_SOURCE[0]}")/../../support" && pwd)/virtual_screen.sh"
mkdir -p "$2" && cd "$2" || exit 1
export QT_QPA_PLATFORM=xcb XDG_RUNTIME_DIR="$2" HOME="$2"
# ctest's limit counts: Qt's own of 5 minutes a function counts those before it, too, where threads are starved.
export QTEST_FUNCTION_TIMEOUT=3600000
chmod 700 "$2"
exec bash "$screen" "${TRIVET_SCREEN:-2560x1600}x24" "$1" "${@:3}"
