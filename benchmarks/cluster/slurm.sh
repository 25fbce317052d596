#!/bin/bash
# A Slurm job array that runs a campaign, one shard per task.
#
#   sbatch --array=1-8 slurm.sh CONFIG.cfg FOLDER
#   sbatch --dependency=afterok:JOB slurm_merge.sh FOLDER
#
# Writes part-I.log for each shard to FOLDER, which all nodes have to share. Submitted again, or requeued, a task makes
# only the missing runs of its shard. OMPL_MFA names the program, if it is not in the PATH. Request the config's
# mem_limit plus 1 GB of memory: the program kills a run beyond its limit, whereas Slurm kills the whole task.
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
# exec: the program instead of a shell receives Slurm's SIGTERM, and completes its log before the time limit.
exec "${OMPL_MFA:-ompl_mfa}" benchmark "$1" --output "$2/part-$SLURM_ARRAY_TASK_ID.log" \
    --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --resume --quiet
