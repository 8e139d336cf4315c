#!/usr/bin/env bash
# Checks Trivet's scenes in third-party programs.
#   run.sh validator|three|usd|blender|agent TRIVET WORK_FOLDER
#   run.sh mujoco|mujoco2|rapier|jolt|bullet TRIVET WORK_FOLDER some|all [PROGRAMS_FOLDER]
# Generates models with every supported feature, lays them out with TRIVET, and BREAKFAST too; then
# opens the scenes. Status 77: the third-party program is missing.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
job="$1" trivet="$2" work="$3/$1${4:-}"

skip() {
  echo "skipped: $*"
  exit 77
}

command -v python3 >/dev/null || skip "no python3"
if [ "$job" = mujoco2 ] || [ "$job" = bullet ]; then
  :
elif [ "$job" = blender ]; then
  command -v blender >/dev/null || skip "no blender (Debian: blender)"
else
  command -v node >/dev/null && command -v npm >/dev/null || skip "no node, no npm (Debian: nodejs, npm)"
fi

# Modules are resolved relative to the scripts.
install_modules() {  # FOLDER, of the packages and the scripts
  cp "$1"/package*.json "$1"/*.mjs "$work"
  (cd "$work" && npm ci --no-audit --no-fund --ignore-scripts > npm.log 2>&1) ||
    { cat "$work/npm.log"; skip "the packages of package.json cannot be had"; }
}

rm -rf "$work"
mkdir -p "$work"
if [ "$job" = usd ]; then
  install_modules "$here"
  TRIVET_PROGRAM="$trivet" TRIVET_NODE_MODULES="$work/node_modules" \
    python3 -B "$here/../apps/test_export.py" Usd Readers
  exit
fi
# An agent with the official client of the Model Context Protocol.
if [ "$job" = agent ]; then
  install_modules "$here/agent"
  "$trivet" demo breakfast -o "$work/breakfast.glb" --export "$work/models" --quiet
  for way in "" http; do
    [ "$way" = "" ] || ! { "$trivet" serve /dev/null 2>&1 || true; } | grep -q "built without" || continue
    rm -f "$work/models/laid by an agent.glb"
    node "$work/agent.mjs" "$trivet" "$work/models" $way
    "$trivet" check "$work/models/laid by an agent.glb" --quiet
  done
  exit
fi
# MuJoCo finds one contact of some edges: exports hold their ends, to within 10 micrometres.
stands_on_edges() {
  python3 -B "$here/simulators/sled.py" "$work/sled"
  "$trivet" run "$work/sled/layout.json" -o "$work/sled/sled.glb" --quiet
  "$trivet" export "$work/sled/sled.glb" -o "$work/sled/sled.xml" --quiet
  (cd "$work" && node ridge.mjs && node rest.mjs mujoco 2 sled/sled.xml > sled/rest.json)
  python3 -c 'import json, sys; exit(json.load(sys.stdin)["objects"][0]["moved"] > 1e-5)' < "$work/sled/rest.json" ||
    { cat "$work/sled/rest.json"; return 1; }
}
# Engines: the small demos, or all with "all" behind the job, and then the folder of programs in C++.
case "$job" in
  mujoco | mujoco2 | rapier | jolt | bullet)
    programs="${5:-}" demos=spoon-saucer,breakfast,office1 seconds=1
    [ "${4:-}" = all ] && demos="" seconds=2
    case "$job" in
      bullet | mujoco2)
        [ -x "$programs/${job}_rest" ] || skip "no ${job}_rest was built (Debian: libbullet-dev, libmujoco-dev)" ;;
      *) install_modules "$here" ;;
    esac
    python3 -B "$here/simulators/matrix.py" --trivet "$trivet" --work "$work" --engines "$job" --bars \
      --seconds "$seconds" ${demos:+--demos "$demos"} --programs "$programs"
    if [ "$job" = mujoco ]; then stands_on_edges; fi
    if [ "$job" = jolt ]; then (cd "$work" && node jolt_corners.mjs); fi
    exit ;;
esac
export PYTHONDONTWRITEBYTECODE=1
python3 "$here/make_models.py" "$work/models"
for kind in glb gltf; do
  "$trivet" run "$work/models/layout.json" -o "$work/scene.$kind" --report "$work/scene.json" \
    --animation "$work/film.glb" --quiet
done
"$trivet" demo breakfast -o "$work/breakfast.glb" --report "$work/breakfast.json" --quiet
"$trivet" put "$work/scene.glb" "$work/models/lamp.gltf" --position 2 2 1 --name "lamp 3" \
  -o "$work/put.glb" --report "$work/put.json" --quiet
for scene in scene breakfast put; do
  "$trivet" check "$work/$scene.glb" --quiet
  python3 "$here/expected.py" "$work/$scene.glb" "$work/$scene.json" > "$work/$scene.expected"
done

if [ "$job" = blender ]; then
  for scene in scene breakfast put; do
    blender -b --factory-startup --python-exit-code 1 -P "$here/blender_check.py" -- \
      "$work/$scene.glb" "$work/$scene.expected" > "$work/blender.log" 2>&1 ||
      { cat "$work/blender.log"; exit 1; }
    grep -h "Blender .*objects" "$work/blender.log"
  done
  exit 0
fi

install_modules "$here"
cd "$work"
case "$job" in
  validator) node validate.mjs scene.glb scene.gltf put.glb breakfast.glb film.glb ;;
  three)
    for scene in scene breakfast put; do node three_check.mjs "$scene.glb" "$scene.expected"; done ;;
esac
