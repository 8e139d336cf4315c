#!/usr/bin/env bash
# Packs a root file system of root_fs.sh as an OCI image of two layers, the system and Trivet: for podman load, skopeo copy.
#   image.sh ROOT VERSION OUT.oci.tar      needs umoci and SOURCE_DATE_EPOCH
set -euo pipefail
root="$1" version="$2" out="$3"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
date="$(date -u -d "@$SOURCE_DATE_EPOCH" +%Y-%m-%dT%H:%M:%SZ)"
image="$work/oci:$version"
pack() { tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" "$@"; }

umoci init --layout "$work/oci"
umoci new --image "$image"
pack -C "$root" --exclude=./opt/trivet -cf "$work/system.tar" .
pack -C "$root" -cf "$work/trivet.tar" ./opt/trivet
for layer in system trivet; do
  umoci raw add-layer --image "$image" --history.created "$date" --history.comment "$layer" "$work/$layer.tar"
  rm "$work/$layer.tar"
done
umoci config --image "$image" --created "$date" --history.created "$date" --architecture amd64 --os linux \
  --config.entrypoint /opt/trivet/bin/trivet --config.user 1000:1000 --config.workingdir /tmp \
  --config.env PATH=/usr/local/bin:/usr/bin:/bin \
  --config.env NVIDIA_VISIBLE_DEVICES=all --config.env NVIDIA_DRIVER_CAPABILITIES=graphics,utility \
  --config.label org.opencontainers.image.title=trivet --config.label "org.opencontainers.image.version=$version" \
  --config.label org.opencontainers.image.licenses=MIT
umoci gc --layout "$work/oci" >/dev/null
pack -C "$work/oci" -cf "$out" .
