#!/usr/bin/env bash
# Batches under real engines: every unit has to be the bytes that one process makes.
#
#   tests/farm/run.sh slurm|parallel TRIVET WORK_DIR
#
# slurm:     the printed job file on a cluster of three nodes on this machine (cluster.sh): an array that loses a node, one
#            with a node that goes on working while it is cut off, a task that is told to stop and comes again, a part of an
#            array that is submitted once more; 3 minutes
# parallel:  the printed job file of GNU parallel, killed in the middle, and run again
#
# Skipped (status 77) without the engine (Debian: slurmctld slurmd slurm-client munge procps; parallel); what an engine that
# is there does not do fails.
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
recipe="a recipe.json" # job files have to quote it
cat >"$recipe" <<'END'
{"trivet_recipe": 1,
 "groups": [{"name": "heap", "models": [{"model": "box.obj"}], "count": [3, 6], "scale_range": [0.5, 1.5],
             "rotation": "any", "heap": {"radius": 0.1, "height": 0.5, "rise": 0.2}}]}
END

# Job files call this program.
mkdir bin
ln -s "$trivet" bin/trivet
export PATH="$work/bin:$PATH"

# SHA-256 of all units.
hashes() { (cd "$1" && find . -name 'scenes-*.tar' -not -name '.*' | sort | xargs -r sha256sum); }
units() { find "$1" -name 'scenes-*.tar' -not -name '.*' 2>/dev/null | wc -l; }
batch=(trivet batch "$recipe" --count "$count" --per-tar "$per" --quiet)
make() { "${batch[@]}" "$@" >/dev/null; }
# A job file for a folder, as people get it.
print_job() { # ENGINE OUT
  TRIVET_SHARDS=$shards "${batch[@]}" --scene-seconds 30 --with report --out "$2" --template "$1" >"$1.sh"
}
same() { # FOLDER: has all units, of the right bytes
  [ "$(hashes one)" = "$(hashes "$1")" ] || fail "$1 has other bytes than one process makes"
  trivet batch status "$1" >/dev/null || fail "$1 is not complete"
  say "$1: $(units "$1") units, the same bytes; temporary files left: $(find "$1" -name '.*trivet-tmp*' | wc -l)"
}

try_parallel() {
  command -v parallel >/dev/null || skip "no GNU parallel"
  count=400 # processes are killed at once, a node is not
  batch[4]=$count
  make --with report --out one
  print_job parallel "out of many"
  bash parallel.sh >/dev/null 2>&1 &
  local pid=$!
  for _ in $(seq 300); do [ "$(units "out of many")" -ge 3 ] && break; sleep 0.1; done
  kill -9 $(cat "/proc/$pid/task/$pid/children") $pid 2>/dev/null || true
  wait $pid 2>/dev/null || true
  say "killed with $(units "out of many") of $((count / per)) units"
  [ "$(units "out of many")" -lt $((count / per)) ] || fail "it was done before it was killed"
  bash parallel.sh >parallel.txt 2>&1 || fail "the second run: $(cat parallel.txt)"
  same "out of many"
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
idle() { sinfo -h -N -n "n$1" -o %T | grep -q idle; }
node_down() { sinfo -h -N -n "n$1" -o %T | grep -q down; }

# The printed job file; sbatch's own options come before those in it.
submit() { # OUT [OPTIONS OF SBATCH]
  print_job slurm "$1"
  sbatch --parsable --chdir="$work" --output="$work/$1.%a.txt" "${@:2}" slurm.sh
}
# Number of restarts of a job's tasks.
restarts() { scontrol show job "$1" 2>/dev/null | sed -n 's/.*Restarts=\([0-9]*\).*/\1/p' | awk '{ n += $1 } END { print n + 0 }'; }
begun_again() { [ "$(restarts "$1")" -gt 0 ]; }

lose_a_node() {
  local id
  id=$(submit lost)
  wait_for 30 running_on 2 || fail "no task on n2"
  wait_for 60 all_at_work lost || fail "not all tasks have made a unit"
  "$here/cluster.sh" kill-node 2
  wait_for 60 node_down 2 || fail "n2 is not down"
  wait_for 300 all_gone || fail "the array did not end"
  begun_again "$id" || fail "nothing was requeued"
  say "a lost node: $(restarts "$id") tasks began again"
  same lost
  "$here/cluster.sh" start-node 2
  wait_for 60 idle 2 || fail "n2 did not come back"
}

# Units that these processes are making: one that has its name may have its temporary file for a moment more.
in_progress() { # OUT PID...
  local pid unit
  for pid in "${@:2}"; do
    for unit in $(find "$1" -name ".scenes-*trivet-tmp*.$pid.*" -printf '%f\n' | sed 's/^\.\(.*\)\.trivet-tmp.*/\1/'); do
      [ -e "$1/0000/$unit" ] || echo "$unit"
    done
  done
}
any_exists() { # OUT UNIT...
  local unit
  for unit in "${@:2}"; do [ ! -e "$1/0000/$unit" ] || return 0; done
  return 1
}
any_alive() { kill -0 "$@" 2>/dev/null; }
all_ended() { ! any_alive "$@"; }

# The tasks of a node that is cut off go on, and run a second time elsewhere. They are held until the cluster has noticed,
# and a copy has made what one of them was making; then both work.
split_brain() {
  local id tasks begun
  id=$(submit split)
  wait_for 30 running_on 2 || fail "no task on n2"
  wait_for 60 all_at_work split || fail "not all tasks have made a unit"
  tasks="$("$here/cluster.sh" job-processes 2)"
  [ -n "$tasks" ] || fail "no task is at work on n2 any more"
  # shellcheck disable=SC2086
  kill -STOP $tasks
  # shellcheck disable=SC2046,SC2086
  begun="$(in_progress split $tasks | xargs)"
  [ -n "$begun" ] || fail "no task was at work on n2"
  "$here/cluster.sh" cut-off 2
  wait_for 60 node_down 2 || fail "n2 is not down"
  # shellcheck disable=SC2086
  wait_for 120 any_exists split $begun || fail "no copy of a task on n2 makes $begun again"
  say "split brain: the tasks of n2 were making $begun; with $(units split) of $((count / per)) units they go on"
  # shellcheck disable=SC2086
  kill -CONT $tasks
  wait_for 300 all_gone || fail "the array did not end"
  # shellcheck disable=SC2086
  wait_for 60 all_ended $tasks || fail "tasks on n2 did not end"
  begun_again "$id" || fail "nothing was requeued"
  grep -h 'made twice and dropped' split.*.txt || fail "no unit was made twice"
  same split
  "$here/cluster.sh" start-node 2
  wait_for 60 idle 2 || fail "n2 did not come back"
}

stop_a_task() {
  local id task
  id=$(submit stopped)
  wait_for 60 all_at_work stopped || fail "not all tasks have made a unit"
  task=$(squeue -h -t R -o %K -j "$id" | head -n 1)
  [ -n "$task" ] || fail "no task is running any more"
  scancel --signal=TERM --batch "${id}_$task"
  wait_for 300 all_gone || fail "the array did not end"
  begun_again "$id" || fail "the task that was stopped did not come again: exit 75 is to be requeued"
  same stopped
}

submit_a_part() {
  rm lost/0000/scenes-000001.tar lost/0000/scenes-000006.tar # of shards 1 and 2
  submit lost --array=1-2 >/dev/null
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
  "$here/cluster.sh" up 3 2 || fail "the cluster does not start"
  make --with report --out one
  lose_a_node
  split_brain
  stop_a_task
  submit_a_part
}

"try_$job"
say "passed"
