#!/bin/bash
# A Slurm job array that runs a campaign, one part a task.
#
#   sbatch --array=1-8 slurm.sh CONFIG.cfg FOLDER
#   sbatch --dependency=afterok:JOB slurm_merge.sh FOLDER
#
# FOLDER, on a file system that all nodes share, gets part-I.log for each part. Submitted again, or requeued, a task
# makes only the runs that its part misses. OMPL_MFA names the program, if it is not in the PATH.
# Ask for as much memory as the config's mem_limit and 1 GB more: a run beyond its limit is ended by the program, and
# only a whole task beyond its own by Slurm.
#SBATCH --job-name=ompl_mfa
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@60
set -euo pipefail

if [ $# -ne 2 ] || [ -z "${SLURM_ARRAY_TASK_ID:-}" ]; then
    echo "usage: sbatch --array=1-N slurm.sh CONFIG.cfg FOLDER" >&2
    exit 2
fi
mkdir -p "$2"
# exec: the program, and not a shell, gets Slurm's SIGTERM, and closes its log before the time is over.
exec "${OMPL_MFA:-ompl_mfa}" benchmark "$1" --output "$2/part-$SLURM_ARRAY_TASK_ID.log" \
    --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --resume --quiet
