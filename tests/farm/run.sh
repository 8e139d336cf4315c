#!/usr/bin/env bash
# Batches under real engines: every unit has to be the bytes that one process makes.
#
#   tests/farm/run.sh slurm|parallel TRIVET WORK_DIR
#
# slurm:     a cluster of three nodes on this machine (cluster.sh): an array that loses a node, a task that is told to stop and
#            comes again, a part of an array that is submitted once more; 2 to 3 minutes
# parallel:  GNU parallel, killed in the middle, and resumed
#
# Skipped (status 77) without the engine (Debian: slurmctld slurmd slurm-client munge procps; parallel).
set -euo pipefail
job="$1"
trivet="$(realpath "$2")"
work="$3/$1"
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

say() { printf '%s %s\n' "$(date +%T)" "$*"; }
skip() {
  say "skipped: $*"
  exit 77
}
fail() {
  say "FAILED: $*"
  exit 1
}

rm -rf "$work"
mkdir -p "$work"
cd "$work"
count=1600 per=8 shards=4 # some 10 s of work: what interrupts it comes in the middle

# A box of half extents $1 about the origin.
box() {
  local x y z
  for z in -1 1; do for y in -1 1; do for x in -1 1; do
    awk -v h="$1" -v x=$x -v y=$y -v z=$z 'BEGIN { print "v", h * x, h * y, h * z }'
  done; done; done
  printf 'f %s\n' "1 5 7" "1 7 3" "2 4 8" "2 8 6" "1 2 6" "1 6 5" "3 7 8" "3 8 4" "1 3 4" "1 4 2" "5 6 8" "5 8 7"
}
box 0.05 >box.obj
cat >recipe.json <<'END'
{"trivet_recipe": 1,
 "groups": [{"name": "heap", "models": [{"model": "box.obj"}], "count": [3, 6], "scale_range": [0.5, 1.5],
             "rotation": "any", "heap": {"radius": 0.1, "height": 0.5, "rise": 0.2}}]}
END

# SHA-256 of all units.
hashes() { (cd "$1" && find . -name 'scenes-*.tar' -not -name '.*' | sort | xargs -r sha256sum); }
units() { find "$1" -name 'scenes-*.tar' -not -name '.*' 2>/dev/null | wc -l; }
make() { "$trivet" batch recipe.json --count $count --per-tar $per --quiet "$@" >/dev/null; }
same() { # FOLDER: has all units, of the right bytes
  [ "$(hashes one)" = "$(hashes "$1")" ] || fail "$1 has other bytes than one process makes"
  "$trivet" batch status "$1" >/dev/null || fail "$1 is not complete"
  say "$1: $(units "$1") units, the same bytes; temporary files left: $(find "$1" -name '.*trivet-tmp*' | wc -l)"
}

try_parallel() {
  command -v parallel >/dev/null || skip "no GNU parallel"
  count=400 # processes are killed at once, a node is not
  make --out one
  local run=(parallel --will-cite -j 2 --joblog log --resume-failed --retries 3
    "$trivet" batch recipe.json --count $count --per-tar $per --jobs 1 --quiet --shard "{}/$shards" --out many ':::' 0 1 2 3)
  "${run[@]}" >/dev/null 2>&1 &
  local pid=$!
  for _ in $(seq 300); do [ "$(units many)" -ge 3 ] && break; sleep 0.1; done
  kill -9 $(cat "/proc/$pid/task/$pid/children") $pid 2>/dev/null || true
  wait $pid 2>/dev/null || true
  say "killed with $(units many) of $((count / per)) units"
  [ "$(units many)" -lt $((count / per)) ] || fail "it was done before it was killed"
  "${run[@]}" >/dev/null 2>&1 || fail "the second run"
  same many
}

# --- Slurm ---

wait_for() { # SECONDS COMMAND...
  local n=$(($1 * 5))
  shift
  for _ in $(seq "$n"); do "$@" && return 0; sleep 0.2; done
  return 1
}
all_gone() { [ -z "$(squeue -h 2>/dev/null)" ]; }
# The first unit of every shard: all tasks are at work, with most still to do.
all_at_work() { [ "$(find "$1" -name 'scenes-*.tar' -not -name '.*' 2>/dev/null | grep -c "scenes-00000[0-$((shards - 1))]")" = $shards ]; }
running_on() { [ "$(squeue -h -t R -w "n$1" 2>/dev/null | wc -l)" -ge 1 ]; }
node_down() { sinfo -h -N -n "n$1" -o %T | grep -q down; }

submit() { # OUT ARRAY
  cat >job.sh <<END
#!/bin/bash
#SBATCH --requeue --open-mode=append --signal=B:TERM@30
export TRIVET_SHARDS=$shards
echo "task \$SLURM_ARRAY_TASK_ID restart \${SLURM_RESTART_COUNT:-0} node \$SLURMD_NODENAME" >>"$work/$1.log"
exec "$trivet" batch recipe.json --count $count --per-tar $per --jobs 1 --quiet --out "$1"
END
  sbatch --parsable --chdir="$work" --array="$2" --output="$work/$1.%a.txt" job.sh
}

lose_a_node() {
  submit lost 0-$((shards - 1)) >/dev/null
  wait_for 30 running_on 2 || fail "no task on n2"
  wait_for 60 all_at_work lost || fail "not all tasks have made a unit"
  "$here/cluster.sh" kill-node 2
  wait_for 60 node_down 2 || fail "n2 is not down"
  wait_for 300 all_gone || fail "the array did not end"
  grep -q 'restart [1-9]' lost.log || fail "nothing was requeued"
  same lost
  "$here/cluster.sh" start-node 2
}

stop_a_task() {
  local id task
  id=$(submit stopped 0-$((shards - 1)))
  wait_for 60 all_at_work stopped || fail "not all tasks have made a unit"
  task=$(squeue -h -t R -o %K -j "$id" | head -n 1)
  [ -n "$task" ] || fail "no task is running any more"
  scancel --signal=TERM --batch "${id}_$task"
  wait_for 300 all_gone || fail "the array did not end"
  grep -q 'restart [1-9]' stopped.log || fail "the task that was stopped did not come again: exit 75 is to be requeued"
  same stopped
}

submit_a_part() {
  rm lost/0000/scenes-000001.tar lost/0000/scenes-000006.tar # of shards 1 and 2
  submit lost 1-2 >/dev/null
  wait_for 120 all_gone || fail "the array did not end"
  same lost
}

try_slurm() {
  PATH="$PATH:/usr/sbin:/sbin"
  for program in slurmctld slurmd munged sbatch; do
    command -v $program >/dev/null || skip "no $program"
  done
  export FARM_DIR="$work/cluster" SLURM_CONF="$work/cluster/slurm.conf"
  trap '"$here/cluster.sh" down' EXIT
  "$here/cluster.sh" up 3 2 || skip "no cluster can be started here"
  make --out one
  lose_a_node
  stop_a_task
  submit_a_part
}

"try_$job"
say "passed"
