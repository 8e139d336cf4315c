#!/usr/bin/env bash
# The steps of docs/tutorial/editor.md by mouse and keys, in the window of a trivet-edit that is installed here. The turn
# is left to tests/apps/edit_window, which does all of them inside the program.
#   use_editor.sh FOLDER     makes FOLDER and leaves breakfast.glb in it, which trivet check accepts; prints the seconds
# Needs Xvfb, xdotool and trivet. Points are pixels of a window of 1280 x 720. PACE: seconds that a step may take.
set -euo pipefail
mkdir -p "$1/models"
folder="$(realpath "$1")" pace="${PACE:-3}"
fail() {
  echo "$*" >&2
  exit 1
}
export HOME="$folder" XDG_RUNTIME_DIR="$folder" QT_QPA_PLATFORM=xcb
chmod 700 "$folder"
exec 9< <(exec Xvfb -displayfd 1 -screen 0 1280x720x24 -nolisten tcp -noreset 2>/dev/null)
server=$!
trap 'kill $(jobs -p) "$server" 2>/dev/null || true' EXIT
read -r -t 60 display <&9
export DISPLAY=":$display"

# The window of this name, when it is there; takes the keyboard.
window() {
  local found="" tries
  for tries in $(seq 120); do
    found="$(xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -n 1)" && [ -n "$found" ] && break
    sleep 0.5
  done
  [ -n "$found" ] || fail "no window \"$1\" after $tries tries"
  sleep 1
  xdotool windowfocus --sync "$found"
  echo "$found"
}
key() { xdotool key "$1" && sleep "$pace"; }
point() { xdotool mousemove $(($1 - 4)) $(($2 - 4)) sleep 0.3 mousemove "$1" "$2" sleep "$pace"; }
click() { point "$1" "$2" && xdotool click 1 && sleep "$pace"; }
drag() { # FROM_X FROM_Y TO_X TO_Y
  local i
  xdotool mousemove "$1" "$2" sleep 0.5 mousedown 1
  for i in 1 2 3 4 5 6; do xdotool mousemove $(($1 + ($3 - $1) * i / 6)) $(($2 + ($4 - $2) * i / 6)) sleep 0.3; done
  sleep "$pace"
  xdotool mouseup 1
  sleep "$pace"
}
import() { # FILE_NAMES [fixed]
  key ctrl+i
  window 'Import models' >/dev/null
  xdotool type --delay 20 "$1"
  xdotool sleep 1 key Return
  local dialog
  dialog="$(window 'Import .*(glb|[0-9])')"
  [ -z "${2:-}" ] || xdotool mousemove --window "$dialog" 22 350 click 1 sleep 1
  xdotool key Return
  sleep "$pace"
  window 'Trivet' >/dev/null
}
choose() { # NAME, not placed yet: by the search field over the tree
  xdotool mousemove 55 92 click 1 sleep 0.5 key ctrl+a type --delay 20 "$1"
  sleep 1
  xdotool mousemove 72 130 click 1 sleep 1
}

SECONDS=0
trivet demo breakfast -o "$folder/demo.glb" --export "$folder/models" --quiet >/dev/null
trivet-edit >"$folder/editor.log" 2>&1 &
window 'Trivet' >/dev/null
key ctrl+n
echo "opened: $SECONDS s"
import "$folder/models/table.glb" fixed # 1
click 810 285                           # 2
import '"plate.glb" "saucer.glb" "cup.glb" "spoon.glb"'
choose saucer && click 850 210 # 3
choose plate && click 770 185
choose cup && click 850 207 # 4
choose spoon && click 851 213
key q # 5
drag 835 207 815 212
key ctrl+d # 7
click 800 170
key ctrl+z # 8
key ctrl+s
window 'Save' >/dev/null
xdotool key ctrl+a type --delay 20 "$folder/breakfast.glb"
xdotool sleep 1 key Return
for _ in $(seq 60); do
  [ ! -s "$folder/breakfast.glb" ] || break
  sleep 0.5
done
[ -s "$folder/breakfast.glb" ] || fail "nothing was saved"
sleep 1
echo "saved: $SECONDS s"

# Judges from the file what stands on what.
supports() { # OBJECT SUPPORT
  trivet check "$folder/breakfast.glb" --object "$1" --quiet | tee "$folder/check.txt" | grep -q "$2" ||
    fail "$1 does not stand on $2: $(cat "$folder/check.txt")"
}
trivet check "$folder/breakfast.glb"
supports saucer table
supports plate table
supports cup saucer
supports spoon saucer
