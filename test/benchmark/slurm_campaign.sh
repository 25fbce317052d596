#!/bin/bash
# slurm_campaign.sh PROGRAM SOURCE_DIR: a campaign as a job array on a Slurm cluster of this one machine, made for the
# test and taken down after it. Exit status 77 where Slurm (slurm-wlm) is not installed.
set -euo pipefail
PATH=$PATH:/usr/sbin
for program in munged slurmctld slurmd sbatch; do
    command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: slurmd needs root"; exit 77; }
export OMPL_MFA=$1
source=$2
config=$source/test/benchmark/cluster_campaign.cfg
work=$(mktemp -d)
chmod 755 "$work"
stop() {
    for daemon in slurmctld slurmd munged; do
        [ ! -f "$work/$daemon.pid" ] || kill "$(cat "$work/$daemon.pid")" 2>/dev/null || true
    done
    sleep 0.5
    rm -rf "$work"
}
trap stop EXIT

ports=$(python3 -c '
import socket
free = [socket.socket() for _ in range(2)]
for s in free: s.bind(("", 0))
print(*[s.getsockname()[1] for s in free])')
mkdir "$work/state" "$work/spool"
head -c 128 /dev/urandom >"$work/munge.key"
chmod 400 "$work/munge.key"
munged --force --socket="$work/munge.socket" --key-file="$work/munge.key" --pid-file="$work/munged.pid" \
    --log-file="$work/munged.log" --seed-file="$work/munge.seed" 2>/dev/null
host=$(hostname -s)
cat >"$work/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
SlurmctldPort=${ports% *}
SlurmdPort=${ports#* }
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$work/slurm.conf
slurmctld -f "$SLURM_CONF"
slurmd -f "$SLURM_CONF"
for _ in $(seq 60); do
    sinfo -h -t idle 2>/dev/null | grep -q main && break
    sleep 0.5
done

cd "$work"
submitted=$(sbatch --parsable --array=1-3 --output="$work/task-%a.out" "$source/benchmarks/cluster/slurm.sh" "$config" "$work/parts")
sbatch --wait --dependency=afterok:"$submitted" --output="$work/merge.out" "$source/benchmarks/cluster/slurm_merge.sh" "$work/parts" ||
    { cat "$work"/*.out "$work"/*.log; exit 1; }
cat "$work"/merge.out
# A task that is submitted again has no runs left.
before=$(md5sum <"$work/parts/part-2.log.journal")
sbatch --wait --array=1-3 --output="$work/again-%a.out" "$source/benchmarks/cluster/slurm.sh" "$config" "$work/parts"
[ "$before" = "$(md5sum <"$work/parts/part-2.log.journal")" ] || { echo "a finished part was made again"; exit 1; }

"$OMPL_MFA" benchmark "$config" --output "$work/whole.log" --quiet >/dev/null
rows() {
    grep -cE '^[0-9]+; ' "$1"
}
[ "$(rows "$work/parts/campaign.log")" = "$(rows "$work/whole.log")" ]
grep -q '8 runs of 2 planners from 3 parts' "$work/merge.out"
echo passed
