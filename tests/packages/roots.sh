# Bare Debian systems for tests, sourced: made once by debootstrap under $roots, and run in copies on write that are
# thrown away. Needs root, for chroot and overlay mounts.

mirror="${TRIVET_DEBIAN_MIRROR:-http://deb.debian.org/debian}"

# bare_root NAME SUITE [PACKAGES]: makes $roots/NAME if it is not there, whole or not at all
bare_root() {
  local name="$1" suite="$2" include="${3:-}"
  [ ! -d "$roots/$name" ] || return 0
  mkdir -p "$roots"
  rm -rf "$roots/.$name"
  say "debootstrap of $name"
  debootstrap --variant=minbase ${include:+--include="$include"} "$suite" "$roots/.$name" "$mirror" >"$roots/$name.log" 2>&1 || {
    tail -n 5 "$roots/$name.log"
    skip "debootstrap of $suite from $mirror failed"
  }
  mv "$roots/.$name" "$roots/$name"
}

# in_root ROOT FOLDER COMMAND: a shell command in a copy on write of ROOT, with FOLDER as /job; without network, unless
# ONLINE=1. Processes of it end with it.
in_root() {
  local layers
  layers="$(mktemp -d "$work/layers.XXXXXX")"
  mkdir "$layers"/{upper,work,root}
  local net=--net
  [ "${ONLINE:-0}" = 0 ] || net=
  # shellcheck disable=SC2086
  unshare --mount --pid --fork --kill-child $net bash -euc '
    mount --make-rprivate /
    mount -t overlay overlay -o "lowerdir=$1,upperdir=$2/upper,workdir=$2/work" "$2/root"
    mkdir -p "$2/root"/{job,proc,dev,tmp}
    mount --bind "$3" "$2/root/job"
    mount -t proc proc "$2/root/proc"
    mount --rbind /dev "$2/root/dev"
    [ ! -e /etc/resolv.conf ] || [ ! -d "$2/root/etc/apt" ] || cat /etc/resolv.conf >"$2/root/etc/resolv.conf"
    exec chroot ${4:+--userspec="$4"} "$2/root" /bin/sh -euc "cd /job; $5"
  ' _ "$1" "$layers" "$2" "${AS_USER:-}" "export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp; $3"
  local status=$?
  rm -rf "$layers"
  return $status
}
