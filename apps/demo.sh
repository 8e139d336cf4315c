#!/usr/bin/env bash
# From a fresh Debian 12 to a breakfast table: installs missing packages, builds the program (no editor, server,
# Python, CAD formats or OpenGL, less optimised) and lays out a demo, by default BREAKFAST.
#   apps/demo.sh [spoon-saucer|breakfast|office1|office2]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
demo="${1:-breakfast}"

.ci/install-packages.sh build
TRIVET_TARGET="trivet trivet-import" .ci/build.sh release \
  -DTRIVET_TESTS=OFF -DTRIVET_EDITOR=OFF -DTRIVET_OCCT=OFF -DTRIVET_SERVE=OFF -DTRIVET_PYTHON=OFF \
  -DTRIVET_GPU=OFF -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG"
mkdir -p out
build/release/apps/trivet demo "$demo" -o "out/$demo.glb" --report "out/$demo.json" \
  --picture "out/$demo.png"
cat <<END

The results are in $PWD/out:
  $demo.glb    the scene, for any program that reads glTF
  $demo.json   the report: poses, contacts, what rests on what
  $demo.png    the picture
The program is build/release/apps/trivet; see its --help. For everything:
  .ci/install-packages.sh editor cad convex exr serve && .ci/build.sh release -DTRIVET_TESTS=OFF
END
