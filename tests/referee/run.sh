#!/usr/bin/env bash
# Runs the independent referee, which shares no code with Trivet, on scenes laid out by Trivet.
#
#   tests/referee/run.sh build|demos|layouts|edited TRIVET WORK_DIR SHARED_DIR [EDITED_DIR]
#
# build:    builds the referee from a copy of SHARED_DIR/tools/referee
# demos:    the built-in demos
# layouts:  models of SHARED_DIR/data PUT on the floor, on another model and in a pile
#           (campaign.py beside this file runs hundreds)
# edited:   the scene that the test of the editor's window laid out by mouse and saved in EDITED_DIR
#
# Skipped (status 77) without SHARED_DIR or without the referee's build dependencies.
set -euo pipefail
job="$1"
trivet="$2"
work_dir="$3"
shared_dir="$4"
edited_dir="${5-}"
referee="$work_dir/referee/referee"

skip() {
  echo "skipped: $*"
  exit 77
}

build_referee() {
  [ -f "$shared_dir/tools/referee/Makefile" ] || skip "no referee in $shared_dir/tools"
  command -v make >/dev/null || skip "no make"
  local header
  for header in CGAL/intersections.h gmp.h mpfr.h; do
    echo "#include <$header>" | "${CXX:-c++}" -E -x c++ - >/dev/null 2>&1 ||
      skip "no $header (Debian: libcgal-dev)"
  done
  mkdir -p "$work_dir/referee"
  local compiler="${CXX:-c++}"
  ! command -v ccache >/dev/null || compiler="ccache $compiler"
  cp --update --preserve=timestamps "$shared_dir"/tools/referee/{Makefile,*.cpp,*.h} \
    "$work_dir/referee"
  make -C "$work_dir/referee" -j"$(nproc)" CXX="$compiler"
}

judge_edited() {
  [ -f "$edited_dir/report.json" ] || skip "the test of the editor's window saved nothing"
  "$referee" "$edited_dir/report.json" --scene "$edited_dir/scene.glb"
}

# judge LAYOUT SCENE REPORT: prints one line; fails if the scene is not valid.
judge() {
  local name
  name="$(basename "$1" .json)"
  if "$referee" "$3" --layout "$1" --scene "$2" >"${3%.json}.verdict" 2>&1; then
    echo "true   $name"
  else
    echo "FALSE  $name"
    cat "${3%.json}.verdict"
    return 1
  fi
}

judge_demos() {
  local failed=0 demo dir
  for demo in spoon-saucer breakfast office1 office2 kitchen; do
    dir="$work_dir/demos/$demo"
    rm -rf "$dir"
    mkdir -p "$dir"
    "$trivet" demo "$demo" -o "$dir/scene.glb" --report "$dir/report.json" --export "$dir" --quiet
    cp "$dir/layout.json" "$dir/$demo.json"
    judge "$dir/$demo.json" "$dir/scene.glb" "$dir/report.json" || failed=1
  done
  return $failed
}

judge_layouts() {
  local models="$shared_dir/data/models" dir="$work_dir/layouts" mode layout status
  [ -f "$shared_dir/data/models.csv" ] || skip "no models in $shared_dir/data"
  rm -rf "$dir"
  make_layouts() {
    mkdir -p "$dir/$1"
    PYTHONDONTWRITEBYTECODE=1 python3 "$shared_dir/tools/referee/layouts.py" "$models" \
      --csv "$shared_dir/data/models.csv" --absolute --max-triangles 6000 --seed 1 --mode "$1" \
      --out "$dir/$1" --count "$2" "${@:3}"
  }
  make_layouts floor 20
  make_layouts pairs 20
  make_layouts pile 1 --objects 20
  local failed=0 num_refused=0 results
  for layout in "$dir"/*/*.json; do
    results="${layout%.json}.results"
    mkdir "$results"
    status=0
    "$trivet" run "$layout" -o "$results/scene.glb" --report "$results/report.json" --quiet ||
      status=$?
    case $status in
      0) ;;
      1) num_refused=$((num_refused + 1)) ;;
      *)
        echo "FALSE  $layout: trivet ended with status $status"
        failed=1
        continue
        ;;
    esac
    judge "$layout" "$results/scene.glb" "$results/report.json" || failed=1
  done
  echo "$num_refused refused, at most 2 may be"
  [ $num_refused -le 2 ] || failed=1
  return $failed
}

case "$job" in
  build) build_referee ;;
  demos | layouts | edited)
    [ -x "$referee" ] || skip "the referee is not built"
    "judge_$job"
    ;;
  *)
    echo "$0: unknown job '$job'; accepted: build, demos, layouts, edited" >&2
    exit 2
    ;;
esac
