#!/usr/bin/env bash
# Tries the kit in a bare system without GLVND, where Mesa's llvmpipe is the only driver; as root, on Debian.
#   perf/kit/try.sh trivet-kit.tar.gz OUT [PARTS]
# GTEST_FILTER, if set, is passed on. The kit is unpacked there, must fail where no hardware answers, and run through where llvmpipe is allowed.
set -euo pipefail
kit="$(realpath "$1")" out="$(realpath -m "$2")" parts="${3:-table1}"
seeds="bash coreutils sed grep tar gzip libegl-mesa0 libgl1-mesa-dri"
root="$(mktemp -d)"; trap 'rm -rf "$root"' EXIT
packages="$(apt-cache depends --recurse --installed --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces \
  --no-enhances $seeds | grep '^[a-z]' | sort -u)"
for package in $packages; do dpkg-query -L "$package" 2>/dev/null || true; done |
  grep -E '^/(usr/(bin|lib|lib64|share/glvnd|share/drirc)|bin|lib|lib64)/' | sort -u |
  while read -r file; do if [ -f "$file" ] || [ -L "$file" ]; then echo "$file"; fi; done >"$root.list"
ln -s usr/bin "$root/bin"; ln -s usr/lib "$root/lib"; ln -s usr/lib64 "$root/lib64"
mkdir -p "$root"/{usr/bin,usr/lib,usr/lib64,proc,dev,tmp,out}
# Debian's list says /bin/bash where the file is /usr/bin/bash.
tar -C / -cf - --no-recursion -T "$root.list" 2>/dev/null | tar -C "$root" --keep-directory-symlink -xf -
rm -f "$root.list"
mknod -m 666 "$root/dev/null" c 1 3; mknod -m 666 "$root/dev/urandom" c 1 9
cp "$kit" "$root/tmp/kit.tar"
echo "bare system: $(echo "$packages" | wc -w) packages, $(du -sm "$root/usr" | cut -f1) MB"
inside() { unshare --mount --pid --fork bash -c 'mount -t proc proc "$0/proc"; exec chroot "$0" /usr/bin/env -i PATH=/usr/bin GTEST_FILTER="${GTEST_FILTER:-*}" "${@}"' "$root" "$@"; }

inside tar -C /tmp -xf /tmp/kit.tar
status=0; inside /tmp/trivet-kit/run.sh /out/hardware || status=$?
[ "$status" = 3 ] || { echo "FAILED: status $status without a hardware renderer; 3 was expected" >&2; exit 1; }
status=0; inside /tmp/trivet-kit/run.sh /out/software --allow-software --parts "$parts" || status=$?
mkdir -p "$out"; cp -r "$root/out/." "$out/"
[ "$status" = 0 ] || { echo "FAILED: status $status with llvmpipe allowed" >&2; exit 1; }
echo "the kit fails without hardware, and runs with llvmpipe allowed"
