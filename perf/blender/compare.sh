#!/bin/bash
# Six textured models by Trivet's rays, OpenGL and Blender's Cycles, side by side, and how far apart they are.
#   perf/blender/compare.sh TRIVET FOLDER        needs blender, python3-numpy and python3-pil; writes FOLDER/beside.png
set -e
trivet="$(realpath "$1")"; folder="$(realpath -m "$2")"; here="$(dirname "$(realpath "$0")")"
side="${SIDE:-240}"; samples="${SAMPLES:-64}"
mkdir -p "$folder"/{models,path,opengl,blender}
python3 "$here/six_models.py" "$folder/models"
for model in "$folder"/models/*.gltf; do
  name="$(basename "$model" .gltf)"
  scene="$folder/models/$name.glb"
  echo "{\"trivet\": 1, \"objects\": [{\"name\": \"$name\", \"model\": \"$name.gltf\", \"fixed\": true,
    \"position\": [0, 0, 0.0001]}]}" > "$folder/models/$name.json"
  "$trivet" run "$folder/models/$name.json" -o "$scene" --quiet
  for renderer in path opengl; do
    "$trivet" render "$scene" -o "$folder/$renderer/$name.png" --width "$side" --height "$side" --samples "$samples" \
      --renderer $renderer --camera 0.35 -0.5 0.38 0 0 0.085 --fov 30 --quiet
  done
done
blender -b --factory-startup -P "$here/render.py" -- "$side" "$samples" "$folder/blender" "$folder"/models/*.gltf \
  > "$folder/blender.log" 2>&1
python3 "$here/beside.py" "$folder"
