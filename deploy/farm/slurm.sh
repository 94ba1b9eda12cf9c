#!/usr/bin/env bash
# Runs Slurm on this machine over loopback: nodes n0, n1, ... with one core each, and all files in FOLDER.
# Needs Debian's slurm-wlm and munge. usage: deploy/farm/slurm.sh start FOLDER [NODES] | node FOLDER N | stop FOLDER
# start prints the line that lets `sbatch` and `pelage farm` find it; node restarts a node that has died.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
action=${1:-} folder=${2:-}
case $action in start|node|stop) ;; *) sed -n '3,4s/^# //p' "$0" >&2; exit 2 ;; esac
[ -n "$folder" ] || { echo "$0: name a folder" >&2; exit 2; }
mkdir -p "$folder" && folder=$(cd "$folder" && pwd)
export SLURM_CONF=$folder/slurm.conf PATH=$PATH:/usr/sbin

free_ports() {  # prints $1 free TCP ports, one per line
  python3 -c 'import socket, sys
sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(int(sys.argv[1]))]
print(*(one.getsockname()[1] for one in sockets), sep="\n")' "$1"
}

write_conf() {  # $1: number of nodes
  local ports nodes="" k host
  mapfile -t ports < <(free_ports $(($1 + 1)))
  host=$(hostname -s)
  for ((k = 0; k < $1; ++k)); do
    nodes+="NodeName=n$k NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[k + 1]} CPUs=1 State=UNKNOWN"$'\n'
  done
  local text
  text=$(<"$here/slurm.conf.in")
  text=${text//@FOLDER@/$folder} text=${text//@USER@/$(id -un)} text=${text//@CONTROLLER_PORT@/${ports[0]}}
  text=${text//@DEAD_SECONDS@/${PELAGE_SLURM_DEAD_SECONDS:-30}} text=${text//@NODES@/$nodes}
  printf '%s\n' "$text" > "$SLURM_CONF"
}

background() {  # $1: name of its pid file and log; the rest: a program that does not fork
  local name=$1
  shift
  setsid "$@" > "$folder/log/$name.out" 2>&1 < /dev/null &
  echo $! > "$folder/pids/$name"
}

start_node() {
  mkdir -p "$folder/spool-n$1"
  background "slurmd-n$1" slurmd -D -N "n$1"
}

wait_for() {  # $1: what is waited for; the rest: a command that succeeds once it is there
  local k what=$1
  shift
  for ((k = 0; k < 200; ++k)); do
    "$@" > /dev/null 2>&1 && return
    sleep 0.1
  done
  echo "$0: $what did not start; see $folder/log" >&2
  exit 1
}

start() {
  local k
  mkdir -p "$folder"/{log,pids,state} && mkdir -p -m 700 "$folder/munge"
  write_conf "$1"
  (umask 077 && head -c 128 /dev/urandom > "$folder/munge/key")
  background munged munged --foreground --force --socket="$folder/munge/socket" --key-file="$folder/munge/key" \
    --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" --seed-file="$folder/munge/seed"
  wait_for munged test -S "$folder/munge/socket"
  background slurmctld slurmctld -D -i
  for ((k = 0; k < $1; ++k)); do start_node $k; done
  wait_for Slurm all_idle "$1"
  echo "export SLURM_CONF=$SLURM_CONF"
}

all_idle() { [ "$(sinfo --noheader --Node --format=%T | grep -c idle)" -eq "$1" ]; }

stop() {
  local file pid
  timeout 5 scancel --user="$(id -un)" --quiet 2> /dev/null || true
  for _ in {1..20}; do  # until no task runs any more
    [ -n "$(timeout 5 squeue --noheader --states=running,completing 2> /dev/null)" ] || break
    sleep 0.3
  done
  for file in "$folder"/pids/slurmd-* "$folder"/pids/slurmctld "$folder"/pids/munged; do
    if [ -e "$file" ]; then kill "$(cat "$file")" 2> /dev/null || true; fi
  done
  for file in "$folder"/pids/*; do
    [ -e "$file" ] || continue
    pid=$(cat "$file")
    for _ in {1..30}; do kill -0 "$pid" 2> /dev/null || break; sleep 0.1; done
    kill -9 "$pid" 2> /dev/null || true
    rm -f "$file"
  done
}

case $action in
  start) start "${3:-$(nproc)}" ;;
  node) start_node "${3#n}" ;;
  stop) stop ;;
esac
