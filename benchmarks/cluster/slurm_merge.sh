#!/bin/bash
# Joins the shards of slurm.sh in FOLDER into campaign.log: sbatch --dependency=afterok:JOB slurm_merge.sh FOLDER
#SBATCH --job-name=ompl_mfa_merge
#SBATCH --cpus-per-task=1
set -euo pipefail

if [ $# -ne 1 ]; then
    echo "usage: sbatch slurm_merge.sh FOLDER" >&2
    exit 2
fi
"${OMPL_MFA:-ompl_mfa}" merge "$1"/part-*.log --output "$1/campaign.log"
