#!/usr/bin/env bash
# Makes Trivet's packages.
#
#   apps/packages/make.sh [deb|wheel|tarball|image|squashfs|blender]... --output DIR [--build DIR]
#
#   deb        trivet, trivet-edit, trivet-cad, libtrivet-dev and its shared library, python3-trivet
#   wheel      Python's package with all its libraries
#   tarball    trivet-VERSION-linux-x86_64.tar.zst, which runs wherever it is unpacked
#   image      an OCI image, without a registry: trivet-VERSION-image.oci.tar
#   squashfs   the same file system for Apptainer and mount: trivet-VERSION.squashfs
#   blender    the extension, by apps/blender
#
# Without a kind: all. The build (--build, by default build/package, of the preset `package`) is made or brought up to date
# first; --no-build takes it as it is. Debian's packages that are needed: .ci/install-packages.sh packages.
# Dates are of SOURCE_DATE_EPOCH, by default the last commit's.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source_dir="$(cd "$here/../.." && pwd)"

fail() {
  echo "$0: $*" >&2
  exit 2
}
# need PROGRAM PACKAGE
need() { command -v "$1" >/dev/null || fail "$1 is missing; Debian: apt-get install $2"; }
cache() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
size() { echo "$(du -k "$1" | cut -f1) kB  $1"; }

kinds=() output="" build="$source_dir/build/package" build_first=1
while [ $# -gt 0 ]; do
  case "$1" in
    deb | wheel | tarball | image | squashfs | blender) kinds+=("$1") ;;
    --output | --build)
      [ $# -ge 2 ] || fail "$1 needs a folder"
      [ "$1" = --output ] && output="$2" || build="$(realpath -m "$2")"
      shift
      ;;
    --no-build) build_first=0 ;;
    --help | -h)
      sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    *) fail "unknown: $1; accepted: deb, wheel, tarball, image, squashfs, blender, --output DIR, --build DIR, --no-build" ;;
  esac
  shift
done
[ -n "$output" ] || fail "--output DIR is missing"
if [ ${#kinds[@]} -eq 0 ]; then
  kinds=(deb wheel tarball image squashfs)
  [ ! -e "$source_dir/apps/blender/make_zip.py" ] || kinds+=(blender)
fi
mkdir -p "$output"
output="$(cd "$output" && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
umask 022
export LC_ALL=C.UTF-8
SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(git -C "$source_dir" log -1 --format=%ct 2>/dev/null ||
  stat -c %Y "$source_dir/CHANGELOG.md")}"
export SOURCE_DATE_EPOCH

build() {
  need cmake cmake
  need ninja ninja-build
  need help2man help2man
  local unity=() launcher=()
  [ -e "$build/CMakeCache.txt" ] || unity=(-DTRIVET_UNITY=ON) # a whole build is faster so
  ! command -v ccache >/dev/null || launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  (cd "$source_dir" && cmake --preset package -B "$build" "${unity[@]}" "${launcher[@]}" >"$work/configure.log") || {
    cat "$work/configure.log" >&2
    fail "the configuration failed"
  }
  cmake --build "$build" --parallel "${JOBS:-$(nproc)}"
}

# install PREFIX COMPONENT...
install_to() {
  local prefix="$1" component
  shift
  for component in "$@"; do
    cmake --install "$build" --prefix "$prefix" --component "$component" --strip >/dev/null
  done
}

make_deb() {
  need dpkg-shlibdeps dpkg-dev
  need xz xz-utils
  (cd "$work" && cpack --config "$build/CPackConfig.cmake" -B "$work/cpack" >"$work/cpack.log" 2>&1) || {
    cat "$work/cpack.log" >&2
    fail "cpack failed"
  }
  mv "$work"/cpack/*.deb "$output"
}

make_wheel() {
  need patchelf patchelf
  need readelf binutils
  local python
  python="$(cache TRIVET_PYTHON_EXECUTABLE)"
  [ -n "$python" ] || fail "$build is without Python's package; Debian: pybind11-dev python3-dev python3-numpy"
  "$python" -c "import wheel" 2>/dev/null || fail "$python has no module wheel; Debian: apt-get install python3-wheel"
  install_to "$work/python" trivet python
  "$python" "$here/wheel.py" "$work/python" "$output"
}

# The relocatable folder, which the image has, too.
lay_out() {
  [ ! -e "$work/$name" ] || return 0
  need patchelf patchelf
  need readelf binutils
  install_to "$work/prefix" trivet cad
  mkdir -p "$work/$name"
  python3 "$here/tarball.py" "$work/prefix" "$work/$name"
}

make_tarball() {
  need zstd zstd
  lay_out
  tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" --mode=u=rwX,go=rX \
    -C "$work" -cf - "$name" | zstd -q -12 -T0 -f -o "$output/$name.tar.zst"
}

# The image's file system, made once for both kinds.
root_fs() {
  [ ! -e "$work/root" ] || return 0
  lay_out
  "$here/root_fs.sh" "$work/$name" "$work/root"
}

make_image() {
  need umoci umoci
  root_fs
  "$here/image.sh" "$work/root" "$version" "$output/trivet-$version-image.oci.tar"
}

make_squashfs() {
  need mksquashfs squashfs-tools
  root_fs
  mksquashfs "$work/root" "$output/trivet-$version.squashfs" -noappend -quiet -no-progress -all-root \
    -comp zstd -Xcompression-level 9 >/dev/null
}

make_blender() {
  local maker="$source_dir/apps/blender/make_zip.py"
  [ -e "$maker" ] || fail "$maker is missing: this Trivet has no extension for Blender"
  python3 "$maker" "$output/trivet-blender-$version.zip"
}

[ $build_first = 0 ] || build
[ -e "$build/CMakeCache.txt" ] || fail "$build is no build; without --no-build it is made"
[ "$(cache CMAKE_INSTALL_PREFIX)" = /usr ] && [ "$(cache TRIVET_PACKAGES)" = ON ] ||
  fail "$build is not of the preset package: CMAKE_INSTALL_PREFIX=/usr and TRIVET_PACKAGES=ON are needed"
version="$(cache CMAKE_PROJECT_VERSION)"
name="trivet-$version-linux-x86_64"
for kind in "${kinds[@]}"; do
  SECONDS=0
  touch "$work/before"
  "make_$kind"
  echo "$kind, $SECONDS s:"
  find "$output" -maxdepth 1 -type f -newer "$work/before" | sort | while read -r file; do size "$file"; done
done
