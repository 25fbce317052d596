"""Runs of ompl_mfa_anytime and their statistics: medians with intervals, best costs, best peers."""

import json
import math
import pathlib
import re
import statistics
import sys

from scipy.stats import binom

LEVELS = {"10pct": 0.10, "5pct": 0.05, "1pct": 0.01, "01pct": 0.001}
TARGETS = ["first", *LEVELS]
OWN = re.compile(r"^(mfa|fa)(_paper)?(:|$)")
# stops at its first solution
FIRST_ONLY = {"rrtconnect"}
REFERENCES = pathlib.Path(__file__).with_name("references.jsonl")


def median(sample):
    """The median; infinite if one of its middle values is."""
    return statistics.median(sample)


def order_statistic_interval(sample, confidence=0.95):
    """Distribution-free confidence interval of the median: the narrowest symmetric pair of order statistics with the
    given confidence, and its coverage. For fewer than six values it is their range, which has a lower coverage."""
    ordered = sorted(sample)
    n = len(ordered)
    rank = 1
    while rank + 1 <= n - rank and 1 - 2 * binom.cdf(rank, n, 0.5) >= confidence:
        rank += 1
    return ordered[rank - 1], ordered[n - rank], 1 - 2 * binom.cdf(rank - 1, n, 0.5)


def geometric_mean(values):
    return math.exp(statistics.mean(math.log(value) for value in values)) if values else math.nan


class Run:
    """One run, with its cost over time on the chosen clock."""

    def __init__(self, record, clock):
        self.world = record["world"]
        self.planner = record["planner"]
        self.seed = record["seed"]
        self.limit = record["time_limit"]
        self.status = record["status"]
        # a run whose planner crashed, never returned or returned an invalid path has no solution; nor has one whose path
        # is invalid at a finer resolution, which older journals do not tell
        solved = self.status == "returned" and record["solved"]
        self.invalid = solved and not record["valid"]
        self.lax = solved and record["valid"] and not record.get("strict", True)
        self.success = solved and not self.invalid and not self.lax
        self.overrun = record[clock] > self.latest()
        self.cost = record["cost"] if self.success else math.inf
        self.path = record["path"]
        self.checks = record["checks"]
        self.path_check = record["path_check"]
        self.curve = self.read_curve(record, clock) if self.success else []

    def latest(self):
        """Planners overrun their time limit slightly; later improvements do not count."""
        return 1.1 * self.limit + 0.05

    def read_curve(self, record, clock):
        """(time, cost) of each improvement. Reported costs below that of the returned path are replaced by it."""
        column = 1 if clock == "cpu" else 0
        curve = [(entry[column], max(entry[2], self.cost)) for entry in record["improvements"]]
        curve.append((record[clock], self.cost))
        return [(time, cost) for time, cost in curve if time <= self.latest()]

    def time_to(self, cost):
        return next((time for time, reached in self.curve if reached <= cost), math.inf)


class Row:
    """The runs of one planner in one world."""

    def __init__(self, runs, best, floor):
        self.world = runs[0].world
        self.planner = runs[0].planner
        self.runs = runs
        self.best = best
        self.floor = floor
        self.limit = max(run.limit for run in runs)
        self.times = {"first": [run.time_to(math.inf) for run in runs]}
        for level, excess in LEVELS.items():
            self.times[level] = [run.time_to(best * (1 + excess)) for run in runs]
        self.median = {target: median(times) for target, times in self.times.items()}
        self.successes = sum(run.success for run in runs)
        self.success = self.successes / len(runs)
        self.cost = median([run.cost for run in runs])
        self.checks = median([run.checks for run in runs])
        self.invalid = sum(run.invalid for run in runs)
        self.lax = sum(run.lax for run in runs)
        self.failed = [run.status for run in runs if run.status != "returned"]
        self.overrun = sum(run.overrun for run in runs)
        self.peers = []

    def is_own(self):
        return bool(OWN.match(self.planner))

    def floors_to_1pct(self):
        """Time to 1% as a multiple of the time to check the best path once."""
        return self.median["1pct"] / self.floor if math.isfinite(self.floor) else math.nan

    def best_peer(self, target):
        """The peer that reaches the target first; None if no peer counts for this target."""
        peers = [peer for peer in self.peers if target == "first" or peer.planner not in FIRST_ONLY]
        return min(peers, key=lambda peer: peer.median[target], default=None)

    def speedup(self, target):
        """Time of the best peer divided by that of this planner, and "", ">" or "<" if it is exact or a bound: a
        planner that does not reach the target counts with the time limit. None if neither does."""
        peer = self.best_peer(target)
        if peer is None or math.isinf(self.median[target]) and math.isinf(peer.median[target]):
            return None
        bound = ">" if math.isinf(peer.median[target]) else "<" if math.isinf(self.median[target]) else ""
        return min(peer.median[target], peer.limit) / min(self.median[target], self.limit), bound

    def first_ratio(self):
        """Time to the first solution divided by that of the faster of RRT-Connect and BIT*; None if neither has one."""
        quick = [peer.median["first"] for peer in self.peers if peer.planner in ("rrtconnect", "bitstar")]
        fastest = min(quick, default=math.inf)
        return self.median["first"] / fastest if math.isfinite(fastest) else None


def read_lines(path):
    with open(path, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            try:
                yield json.loads(line)
            except json.JSONDecodeError as error:
                sys.exit(f"{path}:{number}: not a JSON object: {error}")


def read_runs(paths, clock, worlds):
    """The runs of journals, whose first lines are headers."""
    runs = [Run(record, clock) for path in paths for record in read_lines(path)
            if "campaign" not in record and re.search(worlds, record["world"])]
    if not runs:
        sys.exit(f"{', '.join(paths)}: no runs of worlds that match '{worlds}'")
    return runs


def read_references(path=REFERENCES):
    """The best known cost of each world: the exact optimum if it is known from geometry, otherwise that of a stored
    path."""
    return {record["world"]: record for record in read_lines(path)} if path.exists() else {}


def update_references(runs, source, path=REFERENCES):
    """Stores the best path of each world without an exact optimum, if it is better than the stored one."""
    references = read_references(path)
    for run in runs:
        known = references.get(run.world)
        if run.success and run.path and (known is None or known["path"] and run.cost < known["cost"]):
            references[run.world] = {"world": run.world, "cost": run.cost,
                                     "source": f"{run.planner}, seed {run.seed}, {run.limit:g} s, {source}",
                                     "path": run.path}
    with open(path, "w", encoding="utf-8") as out:
        for record in references.values():
            out.write(json.dumps(record) + "\n")


def group(runs, key):
    groups = {}
    for run in runs:
        groups.setdefault(key(run), []).append(run)
    return groups


def best_cost(reference, runs):
    """The exact optimum if it is known. A path may be slightly shorter by cutting corners between the checked states,
    and must not become the reference for paths that do not."""
    if reference and not reference["path"]:
        return reference["cost"]
    return min([reference["cost"] if reference else math.inf] + [run.cost for run in runs])


def make_rows(runs, references):
    rows = []
    for world, of_world in group(runs, lambda run: run.world).items():
        best = best_cost(references.get(world), of_world)
        near = [run.path_check for run in of_world if run.success and run.cost <= 1.01 * best]
        floor = median(near) if near else math.nan
        of_planners = [Row(same, best, floor) for same in group(of_world, lambda run: run.planner).values()]
        for row in of_planners:
            row.peers = [other for other in of_planners if other is not row and not other.is_own()]
        rows += of_planners
    return rows
