#!/usr/bin/env bash
# Builds the reference of the C++ library by Doxygen; a warning is an error.
#   docs/doxygen/reference.sh [OUTPUT_FOLDER]      default: build/reference; open its html/index.html
# Status 77: Doxygen is missing.
set -euo pipefail
mkdir -p "${1:-build/reference}"
output="$(realpath "${1:-build/reference}")"
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
command -v doxygen >/dev/null || { echo "skipped: no doxygen (Debian: doxygen)"; exit 77; }
rm -rf "$output/html"
{
  cat docs/doxygen/Doxyfile
  echo "OUTPUT_DIRECTORY = \"$output\""
} | doxygen -
echo "$(find "$output/html" -name '*_8h.html' | wc -l) headers: $output/html/index.html"
