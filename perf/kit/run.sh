#!/usr/bin/env bash
# Measures Trivet on this machine's GPU, without installing anything, within 10 minutes:
#   mkdir kit && tar -xf trivet-kit.tar.gz -C kit && kit/trivet-kit/run.sh OUT [--allow-software] [--minutes 10]
#     [--parts confirm,table1,together,draws,zlists]
# Leaves in the folder OUT: summary.txt, backends.txt and backends.json (devices, self-tests, what `auto` takes), auto.txt (layouts by `auto`
# and by each detector), tests.txt, table1.md, together.md, draws.md, confirm.md, zlists.md, zlists.csv, table.md (layouts, batches and Python
# by each detector), and which.md (which detector for which work, by that). Status 0: done; 1: a test or a measurement failed, or `auto` does not take what is fastest; 3: no hardware renderer
# answers, unless --allow-software is given, for trying the kit where there is none.
set -uo pipefail
kit="$(dirname "$(readlink -f "$0")")"
out="" parts="confirm table1 together draws zlists" allow=0 minutes=10
while [ $# -gt 0 ]; do
  case "$1" in
    --allow-software) allow=1 ;;
    --parts) parts="${2//,/ }"; shift ;;
    --minutes) minutes="$2"; shift ;;
    -*) echo "run.sh: $1 is not accepted; accepted: --allow-software, --minutes, --parts" >&2; exit 2 ;;
    *) out="$1" ;;
  esac
  shift
done
[ -n "$out" ] || { sed -n '2,9s/^# \?//p' "$0"; exit 2; }
mkdir -p "$out" && out="$(readlink -f "$out")" || exit 3
deadline=$((SECONDS + 60 * minutes - 30)) status=0
work="$(mktemp -d)"; trap 'rm -rf "$work"' EXIT
export XDG_CACHE_HOME="$work/cache" HOME="$work"
: >"$out/summary.txt"
say() { echo "$*" | tee -a "$out/summary.txt"; }
left() { local s=$((deadline - SECONDS)); echo $((s > 1 ? s : 1)); }

folders="/usr/lib/x86_64-linux-gnu /lib/x86_64-linux-gnu /usr/lib64 /lib64 /usr/local/lib /usr/lib /lib /usr/local/nvidia/lib64"
given="${LD_LIBRARY_PATH:-}"
given="${given//:/ }"
of_machine() {  # NAME: its path; nothing if the machine has none
  local folder
  for folder in $given $folders; do
    if [ -e "$folder/$1" ]; then echo "$folder/$1"; return; fi
  done
}
if [ -f "$kit/payload.tar.xz" ]; then  # the first time
  { LD_LIBRARY_PATH="$kit/unpack" "$kit/unpack/xz" -dc "$kit/payload.tar.xz" | tar -C "$kit" -xf -; } ||
    { say "FAILED: $kit/payload.tar.xz cannot be unpacked"; exit 3; }
  rm "$kit/payload.tar.xz"
fi
# Libraries of the machine where it has them, else ours.
use="$work/lib"; mkdir -p "$use"
symbols="$(sed -n 2p "$kit/NEEDS")"
for library in "$kit"/lib/machine/*; do
  name="$(basename "$library")" machines="$(of_machine "$(basename "$library")")"
  if [ -n "$machines" ] && { [ "$name" != libstdc++.so.6 ] || grep -aq "$symbols" "$machines"; }; then continue; fi
  ln -s "$library" "$use/$name"
done
[ -d /usr/local/nvidia/lib64 ] && use="$use:/usr/local/nvidia/lib64"
export LD_LIBRARY_PATH="$kit/lib:$use${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
# GLVND finds NVIDIA's EGL by a file that containers often lack.
if [ -z "${__EGL_VENDOR_LIBRARY_FILENAMES:-}" ] && [ -n "$(of_machine libEGL_nvidia.so.0)" ] &&
  ! ls /usr/share/glvnd/egl_vendor.d/*nvidia*.json /etc/glvnd/egl_vendor.d/*nvidia*.json >/dev/null 2>&1; then
  echo '{"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_nvidia.so.0"}}' >"$work/10_nvidia.json"
  export __EGL_VENDOR_LIBRARY_FILENAMES="$work/10_nvidia.json"
fi

say "Trivet $(cat "$kit/COMMIT"), $(date -u +%Y-%m-%dT%H:%MZ), $(uname -sr), $(nproc) cores"
if ! "$kit/bin/trivet" --version >/dev/null 2>"$work/why"; then
  say "FAILED: trivet does not start here (needs $(tr '\n' ' ' <"$kit/NEEDS")): $(head -n 1 "$work/why")"
  exit 3
fi
timeout 120 "$kit/bin/trivet" backends --recalibrate --json >"$out/backends.json" 2>"$work/notes" &&
  timeout 60 "$kit/bin/trivet" backends >"$out/backends.txt" 2>>"$work/notes" ||
  { say "FAILED: trivet backends: $(tail -n 1 "$work/notes")"; exit 3; }
cat "$out/backends.txt"
# A key a line: of a GPU source that is on hardware, the next one is why it fails.
hardware=0
if grep -A3 '"name": "gpu' "$out/backends.json" | grep -A1 '"on_cpu": false' | grep -q '"failure": ""'; then
  hardware=1  # for check_auto.sh
  say "hardware: $(sed -n 's/^gpu [a-z]*: //p' "$out/backends.txt" | head -n 1)"
elif [ $allow = 1 ]; then
  say "no hardware renderer, allowed: $(sed -n 's/^gpu [a-z]*: //p' "$out/backends.txt" | head -n 1)"
else
  say "FAILED: no hardware renderer answers; see backends.txt"
  exit 3
fi

# shellcheck source=perf/kit/check_auto.sh
. "$kit/check_auto.sh"
check_table || status=1
# shellcheck source=perf/kit/ways.sh
. "$kit/ways.sh"
check_layouts || status=1
check_batch "$([ $hardware = 1 ] && echo 4 || echo 2)" || status=1
check_python || status=1

: >"$out/tests.txt"
for test in "$kit"/bin/test_gpu_*; do
  (cd "$work" && timeout "$(($(left) < 24 * minutes ? $(left) : 24 * minutes))" "$test" >"$work/test.txt" 2>&1)
  code=$?
  cat "$work/test.txt" >>"$out/tests.txt"
  passed="$(sed -n 's/^\[  PASSED  \] \([0-9]*\) tests*\..*/\1/p' "$work/test.txt")"
  skipped="$(sed -n 's/^\[  SKIPPED \] \([0-9]*\) tests*.*/\1/p' "$work/test.txt")"
  say "$(basename "$test"): status $code, ${passed:-0} passed, ${skipped:-0} skipped"
  if [ $code != 0 ] || { [ "${passed:-0}" = 0 ] && [ "${GTEST_FILTER:-*}" = "*" ]; }; then status=1; fi
done

for part in $parts; do
  (cd "$work" && timeout "$(left)" "$kit/bin/trivet_perf" --only "$part" --out "$work/tables" >"$work/page.md" 2>"$work/rows.txt")
  code=$?
  if [ $code = 0 ]; then
    cp "$work/page.md" "$out/$part.md"
    cp "$work"/tables/*"$part.csv" "$out/$part.csv" 2>/dev/null
  else  # the rows so far
    cp "$work/rows.txt" "$out/$part.md"
    status=1
  fi
  say "trivet_perf --only $part: status $code, $(grep -c '^|' "$out/$part.md") rows, $(grep -c WRONG "$out/$part.md") wrong"
  if grep -q WRONG "$out/$part.md"; then status=1; fi
done
write_table
write_which
say "$([ $status = 0 ] && echo done || echo FAILED) after $SECONDS s"
exit $status
