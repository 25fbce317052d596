#!/bin/bash
# Runs a campaign in SHARDS parts with GNU Parallel, on this machine or on several, and joins the parts.
#
#   parallel.sh CONFIG.cfg FOLDER SHARDS [OPTIONS OF GNU PARALLEL...]
#
# FOLDER gets part-I.log for each part, the joblog, and campaign.log in the end. Called again, it goes on where it was
# stopped: finished parts are not started again, unfinished ones only make the runs that they miss.
# For several machines: --sshlogin 2/alpha,2/beta (FOLDER, CONFIG and the program have to be there under the same
# paths, as on a shared file system). One part a time and machine (--jobs 1) measures best.
# OMPL_MFA names the program, if it is not in the PATH.
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
