#!/usr/bin/env bash
# Runs a command on a virtual screen of its own, which ends with it.
#   virtual_screen.sh WIDTHxHEIGHTxDEPTH COMMAND...
# Xvfb chooses the display and tells it here, when it can be used: xvfb-run waits for a signal instead, and for ever
# when it has missed it. Status 77: no Xvfb.
set -uo pipefail
if ! command -v Xvfb >/dev/null; then
  echo "Skipped: no Xvfb (Debian: xvfb)"
  exit 77
fi
exec 9< <(exec Xvfb -displayfd 1 -screen 0 "$1" -nolisten tcp -noreset 2>/dev/null)
server=$!
trap 'kill "$server" 2>/dev/null; wait "$server" 2>/dev/null' EXIT
if ! read -r -t 120 display <&9; then
  echo "Xvfb did not start"
  exit 1
fi
DISPLAY=":$display" "${@:2}" 9<&-
