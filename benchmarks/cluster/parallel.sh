#!/bin/bash
# Runs a campaign in SHARDS shards with GNU Parallel, on this machine or on several, and joins them.
#
#   parallel.sh CONFIG.cfg FOLDER SHARDS [OPTIONS OF GNU PARALLEL...]
#
# Writes part-I.log for each shard, the joblog, and finally campaign.log to FOLDER. Called again, it continues: finished
# shards are not started again, unfinished ones only make the missing runs. For several machines: --sshlogin
# 2/alpha,2/beta (FOLDER, CONFIG and the program need the same paths everywhere, as on a shared file system). One shard
# at a time per machine (--jobs 1) gives the most accurate times. OMPL_MFA names the program, if it is not in the PATH.
set -euo pipefail

if [ $# -lt 3 ] || [ ! -f "$1" ] || ! [ "$3" -gt 0 ] 2>/dev/null; then
    echo "usage: parallel.sh CONFIG.cfg FOLDER SHARDS [OPTIONS OF GNU PARALLEL...]" >&2
    exit 2
fi
program=$(command -v "${OMPL_MFA:-ompl_mfa}") || { echo "parallel.sh: no ompl_mfa; set OMPL_MFA" >&2; exit 2; }
program=$(realpath "$program")
config=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
shards=$3
shift 3

seq 1 "$shards" |
    parallel --joblog "$folder/joblog" --resume-failed --jobs 1 "$@" \
        "$program" benchmark "$config" --output "$folder/part-{}.log" --shard "{}/$shards" --resume --quiet
"$program" merge "$folder"/part-*.log --output "$folder/campaign.log"
