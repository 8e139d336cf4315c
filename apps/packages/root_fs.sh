#!/usr/bin/env bash
# The file system of Trivet's image: the fewest of Debian's packages, unpacked without apt or dpkg, and the relocatable folder.
#   root_fs.sh FOLDER ROOT      FOLDER: of tarball.py; ROOT is made
# TRIVET_IMAGE_PACKAGES adds packages, for example libgl1-mesa-dri, with which OpenGL draws on the processor, too.
# Needs mmdebstrap, and root or user namespaces. Debian comes from the sources of this machine.
set -euo pipefail
folder="$(realpath "$1")" root="$(realpath -m "$2")"
command -v mmdebstrap >/dev/null || {
  echo "$0: mmdebstrap is missing; Debian: apt-get install mmdebstrap" >&2
  exit 2
}
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
packages=base-files,libc6,libc-bin,dash,coreutils,grep,libstdc++6,libgcc-s1
# Loaders of OpenGL: an engine brings the driver of the graphics hardware into the container.
packages+=,libegl1,libopengl0${TRIVET_IMAGE_PACKAGES:+,$TRIVET_IMAGE_PACKAGES}
suite="$(. /etc/os-release && echo "$VERSION_CODENAME")"
mode=auto
[ "$(id -u)" != 0 ] || mode=root
mmdebstrap --mode="$mode" --variant=extract --include="$packages" \
  --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/locale/*' \
  --dpkgopt='path-exclude=/usr/share/doc/*' --dpkgopt='path-include=/usr/share/doc/*/copyright' \
  "$suite" "$work/root.tar" >"$work/log" 2>&1 || {
  tail -n 20 "$work/log" >&2
  echo "$0: mmdebstrap failed" >&2
  exit 3
}
mkdir -p "$root"
tar -xpf "$work/root.tar" -C "$root" --exclude='./dev/*' --exclude='./var/cache/*' --exclude='./var/lib/*' \
  --exclude='./var/log/*' --exclude='./etc/apt/*'

# Maintainers' scripts were not run, so what they make is made here.
mkdir -p "$root"/{opt,usr/local/bin,tmp,proc,sys,dev,root}
chmod 1777 "$root/tmp"
[ -e "$root/bin/sh" ] || ln -s dash "$root/bin/sh"
printf 'root:x:0:0::/root:/bin/sh\ntrivet:x:1000:1000::/tmp:/bin/sh\n' >"$root/etc/passwd"
printf 'root:x:0:\ntrivet:x:1000:\n' >"$root/etc/group"
cp -a "$folder" "$root/opt/trivet"
ln -s /opt/trivet/bin/trivet "$root/usr/local/bin/trivet"
ldconfig -r "$root"
rm -f "$root/var/cache/ldconfig/aux-cache"
chmod -R u=rwX,go=rX "$root/opt/trivet"
find "$root" -newermt "@$SOURCE_DATE_EPOCH" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} +
