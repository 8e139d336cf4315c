#!/usr/bin/env bash
# Files that a build installs, by component: every file belongs to one, and programs need no path of
# this machine.
#   components.sh BUILD_DIR WORK_DIR
set -euo pipefail
build="$1" work="$2"
source_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
fail() {
  echo "FAILED: $*"
  exit 1
}
rm -rf "$work"
mkdir -p "$work"

components="$(grep -rhoE 'CMAKE_INSTALL_COMPONENT STREQUAL "[^"]+"' "$build" --include=cmake_install.cmake |
  sed 's/.*"\(.*\)"/\1/' | sort -u | tr '\n' ' ')"
for component in $components; do
  case "$component" in
    trivet | edit | cad | python | lib | dev) ;;
    *) fail "files of the component $component are in no package; accepted: COMPONENT trivet, edit, cad, python, lib or dev" ;;
  esac
  [ "$component" = dev ] || cmake --install "$build" --prefix "$work/$component" --component "$component" >/dev/null
done

has() { # COMPONENT FILE...
  local component="$1" file
  shift
  [[ " $components " == *" $component "* ]] || return 0
  for file in "$@"; do [ -n "$(find "$work/$component" -path "$work/$component/$file")" ] || fail "$component lacks $file"; done
}
has trivet bin/trivet bin/trivet-import share/trivet/layout.schema.json
has edit bin/trivet-edit share/applications/trivet-edit.desktop share/mime/packages/trivet.xml \
  share/icons/hicolor/scalable/apps/trivet-edit.svg
has cad bin/trivet-import-cad
has lib '*/libtrivet.so.*.*'
has python '*/trivet/__init__.py' '*/trivet/_trivet.cpython-*.so' '*/trivet-*.dist-info/METADATA' '*/trivet/py.typed'

find "$work" -type f \( -path '*/bin/*' -o -name '*.so' \) | while read -r file; do
  if readelf -d "$file" | grep -E 'R(UN)?PATH'; then fail "$file looks for libraries by a path"; fi
done

# Opened at run time, where it is there.
if readelf -d "$work/trivet/bin/trivet" | grep -q 'NEEDED.*mujoco'; then fail "trivet does not start without MuJoCo"; fi

version="$("$work/trivet/bin/trivet" --version)"
for file in $(find "$work" -path '*.dist-info/METADATA'); do
  grep -qxF "Version: ${version#trivet }" "$file" || fail "$file has another version than $version"
done
for file in $(find "$work" -name '_paths.py'); do
  importer="$(sed -n 's/^IMPORTER = "\(.*\)"/\1/p' "$file")"
  [ "$(realpath -m --relative-to="$work/python" "$(dirname "$file")/$importer")" = bin/trivet-import ] ||
    fail "$file does not lead to bin/trivet-import"
done
for file in "$work"/edit/share/mime/packages/*.xml "$work"/edit/share/icons/hicolor/scalable/apps/*.svg; do
  [ ! -e "$file" ] || python3 -c "import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])" "$file" || fail "$file"
done
if command -v desktop-file-validate >/dev/null; then
  for file in "$work"/edit/share/applications/*.desktop; do [ ! -e "$file" ] || desktop-file-validate "$file"; done
fi

# make.sh says what is wrong, and what it accepts.
says() { # TEXT ARGUMENTS...
  local text="$1" out
  shift
  if out="$("$source_dir/apps/packages/make.sh" "$@" 2>&1)"; then fail "make.sh $* did not fail"; fi
  grep -qF -- "$text" <<<"$out" || fail "make.sh $* said: $out"
}
says "unknown: rpm; accepted: deb" rpm --output "$work/out"
says "--output DIR is missing" deb
says "is no build" deb --no-build --build "$work/none" --output "$work/out"
rm -rf "$work"
echo "components: $components"

"$source_dir/apps/packages/release.sh" --notes | grep -c '^- ' >/dev/null || fail "the change log has no notes of this version"
