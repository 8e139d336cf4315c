#!/usr/bin/env bash
# A Slurm cluster on one machine, for tests: munged, slurmctld and several slurmd from Debian's packages, no systemd, no
# accounting, no cgroups, nothing outside FARM_DIR, everything ended by its process id.
#
#   FARM_DIR=DIR cluster.sh up NODES CPUS | kill-node N | cut-off N | job-processes N | start-node N | down
#
# kill-node: as if it lost its power, slurmd, its steps and its jobs get SIGKILL. cut-off: as if it lost its network, only
# slurmd does, and its jobs go on. job-processes: ids of what its jobs have started.
set -euo pipefail
FARM_DIR="${FARM_DIR:?}"
export SLURM_CONF="$FARM_DIR/slurm.conf"
PATH="$PATH:/usr/sbin:/sbin"

# The first of some ports in a row that nobody listens on; below those that systems give to clients.
free_port() { # COUNT
  local port p
  for _ in $(seq 100); do
    port=$((10000 + RANDOM % 20000))
    for p in $(seq "$port" $((port + $1 - 1))); do
      { : </dev/tcp/127.0.0.1/"$p"; } 2>/dev/null && continue 2
    done
    echo "$port"
    return
  done
  echo "$0: no free port" >&2
  return 1
}

config() { # NODES CPUS
  local host n port
  port="$(free_port $(($1 + 1)))"
  host="$(hostname -s)"
  mkdir -p "$FARM_DIR"/state
  chmod 0755 "$FARM_DIR"
  (umask 077; head -c 1024 /dev/urandom >"$FARM_DIR/munge.key")
  cat >"$SLURM_CONF" <<END
ClusterName=farm
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
# cred_expire is also how long a requeued job waits before it may start again: 120 s by default
AuthInfo=socket=$FARM_DIR/munge.socket,cred_expire=6
CredType=cred/munge
StateSaveLocation=$FARM_DIR/state
SlurmdSpoolDir=$FARM_DIR/spool.%n
SlurmctldPidFile=$FARM_DIR/slurmctld.pid
SlurmdPidFile=$FARM_DIR/slurmd.%n.pid
SlurmctldLogFile=$FARM_DIR/slurmctld.log
SlurmdLogFile=$FARM_DIR/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
# nodes may claim more CPUs and memory than the machine has
SlurmdParameters=config_overrides
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=2,builtin_interval=2
MaxArraySize=1000001
# a dead node is found within SlurmdTimeout; its jobs are requeued
SlurmdTimeout=5
MessageTimeout=5
SlurmctldTimeout=10
KillWait=5
InactiveLimit=0
JobRequeue=1
RequeueExit=75
ReturnToService=2
MinJobAge=300
END
  for n in $(seq "$1"); do
    echo "NodeName=n$n NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + n)) CPUs=$2 RealMemory=16384 State=UNKNOWN"
  done >>"$SLURM_CONF"
  echo "PartitionName=farm Nodes=ALL Default=YES MaxTime=INFINITE State=UP GraceTime=5" >>"$SLURM_CONF"
}

start_node() { slurmd -N "n$1"; }

up() { # NODES CPUS
  config "$1" "$2"
  munged --force --key-file="$FARM_DIR/munge.key" --socket="$FARM_DIR/munge.socket" --pid-file="$FARM_DIR/munged.pid" \
    --log-file="$FARM_DIR/munged.log" --seed-file="$FARM_DIR/munged.seed" 2>>"$FARM_DIR/munged.err"
  slurmctld -c
  local n
  for n in $(seq "$1"); do start_node "$n"; done
  for _ in $(seq 300); do
    [ "$(sinfo -h -N -t idle 2>/dev/null | wc -l)" = "$1" ] && return
    sleep 0.1
  done
  tail -n 15 "$FARM_DIR"/slurmctld.log
  return 1
}

pid_of() { cat "$FARM_DIR/$1.pid" 2>/dev/null || true; }

# Processes started by jobs of node N: each has SLURMD_NODENAME in its environment. Two calls of
# grep for all: jobs go on meanwhile.
job_processes() {
  local file
  for file in $(grep -lzxF "SLURMD_NODENAME=n$1" /proc/[0-9]*/environ 2>/dev/null |
    xargs -r grep -lzxF "SLURM_CONF=$SLURM_CONF" 2>/dev/null); do
    basename "${file%/environ}"
  done
}

# Every process of node N, daemons first. A slurmstepd overwrites its environment with its title, so it is found as the
# parent of those.
node_processes() {
  local job parent steps="" jobs
  jobs="$(job_processes "$1")"
  for job in $jobs; do
    parent="$(sed -n 's/^PPid:[[:space:]]*//p' "/proc/$job/status" 2>/dev/null)"
    [ "$(cat "/proc/$parent/comm" 2>/dev/null)" = slurmstepd ] && steps="$steps $parent"
  done
  echo "$(pid_of "slurmd.n$1") $steps $jobs"
}

kill_node() { # step daemons die before their jobs, or they report a failure, which is not a lost node
  local pids
  pids="$(node_processes "$1")"
  # shellcheck disable=SC2086
  kill -9 $pids 2>/dev/null || true
}

cut_off() { kill -9 "$(pid_of "slurmd.n$1")"; }

down() {
  [ -e "$SLURM_CONF" ] || return 0
  scancel --user="$(id -un)" 2>/dev/null || true
  for _ in $(seq 50); do [ -z "$(squeue -h -t R,CG 2>/dev/null)" ] && break; sleep 0.1; done
  local n p pids=""
  # Processes left by a node that was cut off, stopped perhaps.
  for n in $(seq "$(grep -c ^NodeName= "$SLURM_CONF")"); do kill_node "$n"; done
  for p in "$FARM_DIR"/slurmd.*.pid "$FARM_DIR"/slurmctld.pid "$FARM_DIR"/munged.pid; do
    [ -s "$p" ] && pids="$pids $(cat "$p")"
  done
  # shellcheck disable=SC2086
  kill $pids 2>/dev/null || true
  for p in $pids; do
    for _ in $(seq 100); do kill -0 "$p" 2>/dev/null || break; sleep 0.1; done
    kill -9 "$p" 2>/dev/null || true
  done
  rm -rf "$FARM_DIR"
}

case "$1" in
  up) up "$2" "$3" ;;
  kill-node) kill_node "$2" ;;
  cut-off) cut_off "$2" ;;
  job-processes) job_processes "$2" ;;
  start-node) start_node "$2" ;;
  down) down ;;
esac
