#!/usr/bin/env bash
# Makes everything that a release consists of, and tests it. The tag is left to whoever publishes.
#
#   apps/packages/release.sh --output DIR [--build DIR] [--no-build] [--without-tests]
#   apps/packages/release.sh --notes            prints the notes alone
#
# DIR gets the packages of make.sh, the documents (docs), the sources, NOTES.md out of CHANGELOG.md and
# SHA256SUMS. The version is that of include/trivet/version.h. Nothing may be uncommitted.
# --no-build takes a build of packages as it is (see make.sh). The tests are those of tests/packages, on the
# packages that were made: they need root and debootstrap, and are named when they are skipped.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source_dir="$(cd "$here/../.." && pwd)"
cd "$source_dir"

fail() {
  echo "$0: $*" >&2
  exit 2
}
part() { sed -n "s/^#define TRIVET_VERSION_$1 //p" include/trivet/version.h; }
version="$(part MAJOR).$(part MINOR).$(part PATCH)"

# The version's section of the change log, without its heading.
notes() {
  local text
  text="$(awk -v start="## $version" '
    index($0, "## ") == 1 { inside = index($0 " ", start " ") == 1; next }
    inside' CHANGELOG.md)"
  [ -n "${text//[[:space:]]/}" ] || fail "CHANGELOG.md has no section \"## $version\""
  printf '# Trivet %s\n\n%s\n' "$version" "$text"
}

output="" build="$source_dir/build/package" with_tests=1 how=()
while [ $# -gt 0 ]; do
  case "$1" in
    --notes)
      notes
      exit 0
      ;;
    --output | --build)
      [ $# -ge 2 ] || fail "$1 needs a folder"
      [ "$1" = --output ] && output="$2" || build="$(realpath -m "$2")"
      shift
      ;;
    --no-build) how=(--no-build) ;;
    --without-tests) with_tests=0 ;;
    *) fail "unknown: $1; accepted: --output DIR, --build DIR, --no-build, --without-tests, --notes" ;;
  esac
  shift
done
[ -n "$output" ] || fail "--output DIR is missing"
[ -z "$(git status --porcelain)" ] || fail "there are changes that are not committed"
! git rev-parse --quiet --verify "refs/tags/v$version" >/dev/null || fail "v$version is a tag already"
notes >/dev/null
mkdir -p "$output"
output="$(realpath "$output")"
[ -z "$(ls -A "$output")" ] || fail "$output is not empty"

packed() { tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git log -1 --format=%ct)" -C "$1" -cf - "$2" |
  zstd -q -12 -o "$output/$3.tar.zst"; }

"$here/make.sh" --output "$output" --build "$build" "${how[@]}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
docs/build.sh "$build" "$work/trivet-$version-docs"
packed "$work" "trivet-$version-docs" "trivet-$version-docs"
git archive --prefix="trivet-$version/" HEAD | zstd -q -12 -o "$output/trivet-$version-source.tar.zst"
notes >"$output/NOTES.md"

if [ $with_tests = 1 ]; then
  tests/packages/run.sh made "$build" "$build/release-tests" "$output" >"$work/made.log"
  for job in components deb editor dev wheel blender tarball image squashfs; do
    status=0
    tests/packages/run.sh "$job" "$build" "$build/release-tests" >"$work/$job.log" 2>&1 || status=$?
    case $status in
      0) echo "tested: $job" ;;
      77) echo "not tested: $job: $(tail -n 1 "$work/$job.log")" ;;
      *)
        cat "$work/$job.log"
        fail "the test of $job failed"
        ;;
    esac
  done
fi
(cd "$output" && sha256sum -- * >"$work/sums" && mv "$work/sums" SHA256SUMS)
echo "$output is ready: look at NOTES.md, then git tag -s v$version and publish"
