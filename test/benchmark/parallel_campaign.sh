#!/bin/bash
# parallel_campaign.sh PROGRAM SOURCE_DIR: a campaign in three parts with GNU Parallel, one of them killed on the way,
# gives the same costs as the undivided campaign. Exit status 77 where GNU Parallel is not installed.
set -euo pipefail
parallel --version 2>/dev/null | grep -q 'GNU parallel' || { echo "skipped: no GNU Parallel"; exit 77; }
export OMPL_MFA=$1
source=$2
config=$source/test/benchmark/cluster_campaign.cfg
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work

# The rows of a log without what depends on time and memory: planner, run, seed, cost, collision checks.
costs() {
    ompl_costs=$(python3 - "$1" <<'PYTHON'
import sys
lines = iter(open(sys.argv[1]).read().split("\n"))
for line in lines:
    if not line.startswith("geometric_"):
        continue
    for _ in range(int(next(lines).split()[0])):
        next(lines)
    names = [next(lines) for _ in range(int(next(lines).split()[0]))]
    for _ in range(int(next(lines).split()[0])):
        run = dict(zip(names, next(lines).split("; ")))
        print(line, *[run[n] for n in ("run INTEGER", "seed INTEGER", "path cost REAL", "collision checks INTEGER")])
PYTHON
    )
    echo "$ompl_costs"
}

"$OMPL_MFA" benchmark "$config" --output "$work/whole.log" --quiet >/dev/null

# The first attempt is interrupted: part 2 fails, as if its machine went down.
cat >"$work/flaky" <<FLAKY
#!/bin/bash
if [[ "\$*" == *"--shard 2/3"* ]] && [ ! -f "$work/failed" ]; then
    touch "$work/failed"
    "$OMPL_MFA" "\$@" >/dev/null &
    sleep 0.1
    kill -9 \$!
    exit 1
fi
exec "$OMPL_MFA" "\$@"
FLAKY
chmod +x "$work/flaky"
if OMPL_MFA=$work/flaky "$source/benchmarks/cluster/parallel.sh" "$config" "$work/parts" 3 --sshlogin 2/: >"$work/out" 2>&1; then
    echo "the attempt with a failing part was called a success"
    exit 1
fi
OMPL_MFA=$work/flaky "$source/benchmarks/cluster/parallel.sh" "$config" "$work/parts" 3 --sshlogin 2/:
[ "$(tail -n +2 "$work/parts/joblog" | cut -f1 | sort -n | uniq | wc -l)" = 3 ] || { cat "$work/parts/joblog"; exit 1; }
diff <(costs "$work/whole.log") <(costs "$work/parts/campaign.log")
[ "$(costs "$work/parts/campaign.log" | wc -l)" = 8 ]
echo passed
