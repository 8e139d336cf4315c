#!/usr/bin/env bash
# Builds the reference of the C++ libraries by Doxygen; a warning is an error.
#   docs/doxygen/reference.sh [OUTPUT_FOLDER]      default: build/reference; open its html/index.html
# Status 77: Doxygen is missing.
set -euo pipefail
mkdir -p "${1:-build/reference}"
output="$(realpath "${1:-build/reference}")"
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
command -v doxygen >/dev/null || { echo "skipped: no doxygen (Debian: doxygen)"; exit 77; }
# Headers that are not installed are named in the CMakeLists.txt of their libraries.
private=()
for room in core raster gpu ops; do
  mapfile -t names < <(tr '\n' ' ' < $room/CMakeLists.txt | grep -oE 'PRIVATE_HEADERS[^)]*' | grep -oE '[a-z0-9_*]+\.h')
  [ ${#names[@]} -gt 0 ]
  private+=("${names[@]/#/*/$room/*/}")
done
rm -rf "$output/html"
{
  cat docs/doxygen/Doxyfile
  echo "OUTPUT_DIRECTORY = \"$output\""
  echo "EXCLUDE_PATTERNS = ${private[*]}"
} | doxygen -
echo "$(find "$output/html" -name '*_8h.html' | wc -l) headers: $output/html/index.html"
