#!/usr/bin/env bash
# Installs what is missing of packages.txt.
#   .ci/install-packages.sh [build|editor|cad|convex|exr|gltf|serve|python|docs|tests|packages|farm|interop|perf|dev]...     without arguments: build
set -euo pipefail
list="$(dirname "${BASH_SOURCE[0]}")/packages.txt"

wanted=()
for group in "${@:-build}"; do
  mapfile -t packages < <(awk -v group="$group" '$1 == group { print $2 }' "$list")
  if [ ${#packages[@]} -eq 0 ]; then
    echo "$0: no packages for '$group' in $list; try build, editor, cad, convex, exr, gltf, serve, python, docs, tests, packages, farm, interop, perf or dev" >&2
    exit 2
  fi
  wanted+=("${packages[@]}")
done

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "This is not Debian, so nothing is installed. Trivet needs what Debian calls:" >&2
  echo "  ${wanted[*]}" >&2
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  status="$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)"
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Packages are missing. As root, run: apt-get update && apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}"
