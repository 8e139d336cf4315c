#!/usr/bin/env bash
# Packages: what installations hold, and every kind of package used in a bare Debian.
#
#   tests/packages/run.sh components|make|deb|editor|dev|wheel|blender|tarball|image|squashfs BUILD_DIR WORK_DIR
#   tests/packages/run.sh made BUILD_DIR WORK_DIR PACKAGES_DIR
#
# components: what a build installs, by component; seconds
# make:       apps/packages/make.sh, for the others; of BUILD_DIR if that is of the preset package, else it builds one
# made:       takes packages that were made of BUILD_DIR instead of making some
# deb:        lintian; installed by apt in a bare Debian, used, and removed
# editor:     the steps of its tutorial by mouse and keys, in a bare Debian with Xvfb
# dev:        a project built in a bare Debian with libtrivet-dev, and run with the shared library alone
# wheel:      in a Debian with Python and NumPy only
# blender:    the extension in a Debian with Blender, by the program of the package trivet alone, then by python3-trivet; in
#             the next Debian's, by the program of the tarball
# tarball:    in bare Debians, this one and the next
# image, squashfs: unpacked or mounted, as the user of the image
#
# All but `components` are tests of the label nightly, need root, debootstrap and what .ci/install-packages.sh packages brings,
# and are skipped (status 77) without. Bare systems are kept in WORK_DIR/roots.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source_dir="$(cd "$here/../.." && pwd)"
job="$1" build="$(realpath "$2")"
mkdir -p "$3"
base="$(realpath "$3")" work="$(realpath "$3")/$1" roots="$(realpath "$3")/roots" made="$(realpath "$3")/made"
packages="${4:-}"

say() { printf '%s %s\n' "$(date +%T)" "$*"; }
skip() {
  say "skipped: $*"
  exit 77
}
fail() {
  say "FAILED: $*"
  exit 1
}
. "$here/roots.sh"

need_tools() {
  local tool
  [ "$(id -u)" = 0 ] || skip "not root"
  for tool in debootstrap unshare "$@"; do
    PATH="$PATH:/usr/sbin:/sbin" command -v "$tool" >/dev/null || skip "no $tool; .ci/install-packages.sh packages"
  done
  unshare --mount --pid --fork true 2>/dev/null || skip "namespaces are not allowed"
}
made_file() { # PATTERN
  [ -e "$made/program" ] || skip "packages_make has not made packages"
  local files=("$made"/$1)
  [ -e "${files[0]}" ] || fail "no $1 in $made: the test packages_make makes it"
  echo "${files[0]}"
}
cache() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

# --- What programs have to do, here and there ---

# A folder with BREAKFAST, a recipe and a Python program, and their results as the program of the build gives them.
reference() {
  [ ! -e "$base/job/done" ] || return 0
  rm -rf "$base/job"
  mkdir -p "$base/job"
  [ -e "$made/program" ] || skip "packages_make has not made packages"
  local program
  program="$(sed -n 1p "$made/program")"
  (
    cd "$base/job"
    "$program" demo breakfast --export . -o breakfast.glb --quiet >/dev/null
    cat >recipe.json <<'END'
{"trivet_recipe": 1,
 "groups": [{"name": "heap", "models": [{"model": "cup.glb"}, {"model": "apple.glb"}], "count": [3, 6],
             "rotation": "any", "heap": {"radius": 0.1, "height": 0.5, "rise": 0.2}}]}
END
    printf 'no model' >bad.step
    cp "$here/use.py" .
    PATH="$(dirname "$program"):$PATH" sh -euc "$(do_jobs here)"
    PYTHONPATH="$(sed -n 2p "$made/program")" "$(sed -n 3p "$made/program")" use.py cup.glb >poses.here
    touch done
  )
}
# The shell commands that a trivet on the path has to do, with results by the name $1.
do_jobs() {
  cat <<END
trivet doctor --out /tmp >doctor.$1
trivet run layout.json -o scene.$1.glb --quiet
trivet check scene.$1.glb --quiet >check.$1
trivet batch recipe.json --count 8 --per-tar 4 --out batch.$1 --quiet >/dev/null
trivet info bad.step >cad.$1 2>&1 || true
END
}
same_results() { # NAME
  local name="$1" tars
  cmp "$base/job/scene.here.glb" "$base/job/scene.$name.glb" || fail "$name lays out other bytes"
  cmp "$base/job/check.here" "$base/job/check.$name" || fail "$name checks otherwise"
  cmp "$base/job/cad.here" "$base/job/cad.$name" || fail "$name has another importer of CAD: $(cat "$base/job/cad.$name")"
  tars="$(cd "$base/job/batch.$name" && find . -name 'scenes-*.tar' | sort | xargs sha256sum)"
  [ "$(grep -c . <<<"$tars")" = 2 ] || fail "$name made another number of units"
  [ "$tars" = "$(cd "$base/job/batch.here" && find . -name 'scenes-*.tar' | sort | xargs sha256sum)" ] ||
    fail "$name makes other batches"
  grep -q 'ok *importer' "$base/job/doctor.$name" || fail "doctor in $name: $(cat "$base/job/doctor.$name")"
  say "$name: doctor is content; scene, check and batch are the bytes of the build"
}
clean_results() { rm -rf "$base/job"/{doctor,check,cad,poses,batch}."$1" "$base/job/scene.$1.glb"; }

# --- Jobs ---

test_components() { "$here/components.sh" "$build" "$work"; }

test_make() {
  need_tools lintian patchelf mmdebstrap umoci mksquashfs zstd help2man
  local options=(--build "$source_dir/build/package")
  if [ "$(cache TRIVET_PACKAGES)" = ON ] && [ "$(cache CMAKE_INSTALL_PREFIX)" = /usr ]; then
    options=(--build "$build" --no-build)
  fi
  rm -rf "$made" "$base/job"
  nice -n 10 "$source_dir/apps/packages/make.sh" "${options[@]}" --output "$made"
  note_program "${options[1]}"
}

# The program, Python's package and Python of the build that packages are of.
note_program() {
  printf '%s\n' "$1/apps/trivet" "$1/apps/python" >"$made/program"
  sed -n 's/^TRIVET_PYTHON_EXECUTABLE:[A-Z]*=//p' "$1/CMakeCache.txt" >>"$made/program"
}

test_made() {
  rm -rf "$made" "$base/job"
  mkdir -p "$made"
  cp "$packages"/*.deb "$packages"/*.whl "$packages"/*.zip "$packages"/trivet-*-linux-*.tar.zst "$packages"/*.oci.tar \
    "$packages"/*.squashfs "$made"
  note_program "$build"
}

test_deb() {
  need_tools lintian
  lintian --fail-on error --tag-display-limit 0 "$made"/*.deb
  bare_root bookworm bookworm
  reference
  clean_results deb
  rm -rf "$base/job/debs"
  mkdir "$base/job/debs"
  cp "$made"/*.deb "$base/job/debs"
  rm -f "$base/job/debs"/libtrivet*
  ONLINE=1 in_root "$roots/bookworm" "$base/job" "
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -q >/dev/null
    apt-get install -q -y --no-install-recommends /job/debs/*.deb >/job/apt.log 2>&1 || { tail -n 20 /job/apt.log; exit 1; }
    $(do_jobs deb)
    python3 use.py cup.glb >poses.deb
    QT_QPA_PLATFORM=offscreen trivet-edit --version
    test -s /usr/share/man/man1/trivet-put.1.gz
    test -s /usr/share/man/man1/trivet-edit.1.gz
    cd /
    apt-get purge -q -y trivet trivet-cad trivet-edit python3-trivet >>/job/apt.log 2>&1
    left=\$(find /usr /etc -iname '*trivet*' -not -path '/usr/share/doc/*')
    test -z \"\$left\" || { echo \"left after removal: \$left\"; exit 1; }" || fail "in the bare Debian"
  same_results deb
  cmp "$base/job/poses.here" "$base/job/poses.deb" || fail "python3-trivet puts otherwise"
}

test_editor() {
  need_tools
  bare_root bookworm bookworm
  rm -rf "$work/job"
  mkdir -p "$work/job"
  cp "$(made_file 'trivet_*.deb')" "$(made_file 'trivet-edit_*.deb')" "$here/use_editor.sh" "$work/job"
  ONLINE=1 in_root "$roots/bookworm" "$work/job" "
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -q >/dev/null
    apt-get install -q -y --no-install-recommends xvfb xdotool >apt.log 2>&1 || { tail -n 20 apt.log; exit 1; }
    before=\$(date +%s)
    apt-get install -q -y --no-install-recommends /job/trivet_*.deb /job/trivet-edit_*.deb >apt.log 2>&1 ||
      { tail -n 20 apt.log; exit 1; }
    echo \"installed: \$((\$(date +%s) - before)) s\"
    bash use_editor.sh /job/tutorial" || fail "the editor's tutorial"
}

test_dev() {
  need_tools
  bare_root bookworm bookworm
  rm -rf "$work/job"
  mkdir -p "$work/job/client"
  cp "$(made_file 'libtrivet-dev_*.deb')" "$(made_file 'libtrivet[0-9]*.deb')" "$work/job"
  cp "$source_dir"/tests/install/{CMakeLists.txt,*.cpp} "$work/job/client"
  ONLINE=1 in_root "$roots/bookworm" "$work/job" "
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -q >/dev/null
    apt-get install -q -y --no-install-recommends g++ cmake ninja-build /job/libtrivet*.deb >/job/apt.log 2>&1 ||
      { tail -n 20 /job/apt.log; exit 1; }
    cmake -G Ninja -S client -B /tmp/build -DCMAKE_BUILD_TYPE=Release >/dev/null
    cmake --build /tmp/build --target box_on_floor
    apt-get purge -q -y libtrivet-dev >>/job/apt.log
    /tmp/build/box_on_floor" || fail "a project with libtrivet-dev"
}

test_wheel() {
  need_tools patchelf
  bare_root numpy bookworm python3-numpy
  reference
  clean_results wheel
  local wheel
  wheel="$(made_file 'trivet-*.whl')"
  rm -rf "$base/job/site"
  "$(sed -n 3p "$made/program")" -m pip install -q --no-index --no-deps --target "$base/job/site" "$wheel" 2>/dev/null ||
    skip "no pip; Debian: python3-pip"
  in_root "$roots/numpy" "$base/job" '
    test ! -e /usr/lib/x86_64-linux-gnu/libtbb.so.12
    PYTHONPATH=/job/site python3 use.py cup.glb >poses.wheel
    PYTHONPATH=/job/site python3 -c "import importlib.metadata as m; print(\"trivet\", m.version(\"trivet\"))"' ||
    fail "in Debian with Python and NumPy"
  cmp "$base/job/poses.here" "$base/job/poses.wheel" || fail "the wheel puts otherwise"
  rm -rf "$base/job/site"
  say "wheel: the bits of the build"
}

test_blender() {
  need_tools zstd
  bare_root blender bookworm blender
  rm -rf "$work/job"
  mkdir -p "$work/job"
  cp "$(made_file 'trivet-blender-*.zip')" "$work/job/addon.zip"
  cp "$(made_file 'trivet_*.deb')" "$(made_file 'python3-trivet_*.deb')" "$here/use_blender.py" "$work/job"
  ONLINE=1 in_root "$roots/blender" "$work/job" "
    export DEBIAN_FRONTEND=noninteractive
    try() { blender -b --factory-startup --python-exit-code 9 -P use_blender.py -- addon.zip \$1 >\$1.log 2>&1 ||
      { tail -n 20 \$1.log; exit 1; }; grep -E '^(Blender|backend|put|operators):' \$1.log; }
    apt-get update -q >/dev/null
    apt-get install -q -y --no-install-recommends /job/trivet_*.deb >apt.log 2>&1 || { tail -n 20 apt.log; exit 1; }
    if (try PROGRAM) >without.log || ! grep -q 'apt install python3-numpy' without.log; then
      tail -n 20 without.log
      exit 1
    fi
    apt-get install -q -y --no-install-recommends python3-numpy >apt.log 2>&1 || { tail -n 20 apt.log; exit 1; }
    try PROGRAM
    apt-get install -q -y --no-install-recommends /job/python3-trivet_*.deb >apt.log 2>&1 || { tail -n 20 apt.log; exit 1; }
    try MODULE" || fail "the extension in Blender"
  # The next Debian's Blender takes it as an extension; its Python is another one, so that the program works.
  bare_root blender-next trixie blender,python3-numpy
  tar -C "$work/job" -xf "$(made_file 'trivet-*-linux-*.tar.zst')"
  in_root "$roots/blender-next" "$work/job" "
    ln -s /job/trivet-*/bin/trivet /usr/local/bin/trivet
    blender -b --factory-startup --python-exit-code 9 -P use_blender.py -- addon.zip PROGRAM >next.log 2>&1 ||
      { tail -n 20 next.log; exit 1; }
    grep -E '^(Blender|backend|put|operators):' next.log" || fail "the extension in the next Debian's Blender"
}

test_tarball() {
  need_tools zstd
  reference
  local suite top
  rm -rf "$base/job/relocated"
  mkdir "$base/job/relocated"
  tar -C "$base/job/relocated" -xf "$(made_file 'trivet-*.tar.zst')"
  top="$(ls "$base/job/relocated")"
  "$here/relocatable.sh" "$base/job/relocated/$top" "$source_dir" "$build"
  for suite in bookworm trixie; do
    bare_root $suite $suite
    clean_results "tarball-$suite"
    in_root "$roots/$suite" "$base/job" "
      ln -s /job/relocated/$top/bin/trivet /usr/local/bin/trivet
      $(do_jobs "tarball-$suite")" || fail "in a bare $suite"
    same_results "tarball-$suite"
  done
  # A machine without libstdc++ takes lib/fallback.
  in_root "$roots/bookworm" "$base/job" "
    rm /usr/lib/x86_64-linux-gnu/libstdc++.so.6
    /job/relocated/$top/bin/trivet run layout.json -o scene.fallback.glb --quiet" || fail "without libstdc++"
  cmp "$base/job/scene.here.glb" "$base/job/scene.fallback.glb" || fail "lib/fallback lays out other bytes"
  rm -rf "$base/job/relocated"
}

test_image() {
  need_tools umoci skopeo
  reference
  clean_results image
  rm -rf "$work/oci" "$work/bundle"
  mkdir -p "$work/oci"
  tar -C "$work/oci" -xf "$(made_file 'trivet-*-image.oci.tar')"
  local version config
  version="$(basename "$made"/trivet-*-image.oci.tar -image.oci.tar)"
  version="${version#trivet-}"
  config="$(skopeo inspect --config "oci:$work/oci:$version")"
  grep -q '"/opt/trivet/bin/trivet"' <<<"$config" || fail "no entry point: $config"
  grep -q '"1000:1000"' <<<"$config" || fail "not for a user without rights: $config"
  umoci unpack --image "$work/oci:$version" "$work/bundle" >/dev/null
  as_user image "$work/bundle/rootfs"
}

test_squashfs() {
  need_tools unsquashfs
  reference
  clean_results squashfs
  local file="" root="$work/root"
  file="$(made_file 'trivet-*.squashfs')"
  rm -rf "$root"
  mkdir -p "$root"
  if mount -t squashfs -o loop,ro "$file" "$root" 2>/dev/null; then
    trap "umount '$root'" EXIT
    say "mounted"
  else
    rmdir "$root"
    unsquashfs -quiet -no-progress -dest "$root" "$file" >/dev/null
    say "cannot be mounted here, so unpacked"
  fi
  as_user squashfs "$root"
}

as_user() { # NAME ROOT
  chmod 777 "$base/job"
  AS_USER=1000:1000 in_root "$2" "$base/job" "$(do_jobs "$1")" || fail "in the file system of $1"
  same_results "$1"
}

mkdir -p "$work"
"test_$job"
