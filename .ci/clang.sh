#!/usr/bin/env bash
# Compiles the geometry, which is for every system, by clang: gcc compiles all else.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
CC=clang CXX=clang++ cmake -S . -B build/clang -G Ninja -DCMAKE_BUILD_TYPE=Release -DTRIVET_PRECOMPILE=OFF \
  -DTRIVET_WERROR=ON -DTRIVET_TESTS=OFF -DTRIVET_GPU=OFF -DTRIVET_EDITOR=OFF -DTRIVET_OCCT=OFF -DTRIVET_PYTHON=OFF -DTRIVET_SERVE=OFF
cmake --build build/clang --parallel "$(nproc)" --target trivet_geometry trivet_face_geometry
