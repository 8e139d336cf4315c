#!/bin/bash
# Runs the program of this folder in a window of a virtual screen. Status 77: no virtual screen.
# Usage: run.sh PROGRAM FOLDER [TEST...]
if ! command -v xvfb-run > /dev/null; then
  echo "skipped: no xvfb-run (Debian: xvfb, xauth)"
  exit 77
fi
mkdir -p "$2" && cd "$2" || exit 1
export QT_QPA_PLATFORM=xcb XDG_RUNTIME_DIR="$2" HOME="$2"
chmod 700 "$2"
exec xvfb-run -a -s "-screen 0 2560x1600x24" "$1" "${@:3}"
