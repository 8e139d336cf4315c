#!/usr/bin/env bash
# Heaps of convex solids, settled with friction 0.5, rest in MuJoCo: of 20 heaps of 8 at least 95 %
# of the objects move by less than a millimetre in 5 s, 99 % by less than a centimetre.
#
#   tests/ops/simulation/run.sh TRIVET WORK_DIR SHARED_DIR
#
# Skipped (status 77) without SHARED_DIR or without MuJoCo.
set -euo pipefail
trivet="$1"
work_dir="$2"
shared_dir="$3"

skip() {
  echo "skipped: $*"
  exit 77
}

[ -f "$shared_dir/data/models.csv" ] || skip "no models in $shared_dir/data"
mkdir -p "$work_dir"
"$trivet" demo spoon-saucer -o "$work_dir/demo.glb" --quiet
tried="$("$trivet" export "$work_dir/demo.glb" -o "$work_dir/demo.xml" --simulate 0.01 --quiet 2>&1)" ||
  case "$tried" in
    *libmujoco*) skip "$tried" ;;
    *) echo "$tried" && exit 1 ;;
  esac
PYTHONDONTWRITEBYTECODE=1 python3 "$(dirname "$0")/../../referee/campaign.py" --trivet "$trivet" \
  --shared "$shared_dir" --set solid --friction 0.5 --whole --out "$work_dir" --simulate 5 \
  --rest 95,99 --placed 95
