#!/usr/bin/python3
"""Statistics of the runs that ompl_mfa_anytime made: tables on the terminal, anytime.csv, and Markdown for the docs."""

import argparse
import csv
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
FIRST_ONLY = {"rrtconnect"}
REFERENCES = pathlib.Path(__file__).with_name("references.csv")


def order_statistic_interval(sample, confidence=0.95):
    """The narrowest symmetric pair of order statistics that covers the median with the given confidence, whatever the
    distribution, and its coverage. Below six values there is none: then it is the range, which covers less."""
    ordered = sorted(sample)
    n = len(ordered)
    rank = 1
    while rank + 1 <= n - rank and 1 - 2 * binom.cdf(rank, n, 0.5) >= confidence:
        rank += 1
    return ordered[rank - 1], ordered[n - rank], 1 - 2 * binom.cdf(rank - 1, n, 0.5)


class Run:
    """One run: its cost over time on the chosen clock, and its path."""

    def __init__(self, record, clock):
        self.world = record["world"]
        self.planner = record["planner"]
        self.seed = record["seed"]
        self.limit = record["time_limit"]
        self.status = record["status"]
        # a run whose planner crashed, never returned or returned a path that fails its check has found nothing
        self.success = self.status == "returned" and record["solved"] and record["valid"]
        self.invalid = self.status == "returned" and record["solved"] and not record["valid"]
        self.overrun = record[clock] > 1.1 * self.limit + 0.05
        self.cost = record["cost"] if self.success else math.inf
        self.checks = record["checks"]
        self.path_check = record["path_check"]
        column = 1 if clock == "cpu" else 0
        self.curve = []
        if self.success:
            # what a planner claims to have counts as far as the path that it returns bears it out
            self.curve = [(entry[column], max(entry[2], self.cost)) for entry in record["improvements"]]
            self.curve.append((record[clock], self.cost))
            self.curve = [(time, cost) for time, cost in self.curve if time <= 1.1 * self.limit + 0.05]

    def time_to(self, cost):
        return next((time for time, reached in self.curve if reached <= cost), math.inf)


class Row:
    """One world and planner."""

    def __init__(self, runs, best):
        self.world = runs[0].world
        self.planner = runs[0].planner
        self.runs = runs
        self.best = best
        self.limit = max(run.limit for run in runs)
        self.times = {"first": [run.curve[0][0] if run.curve else math.inf for run in runs]}
        for level, above in LEVELS.items():
            self.times[level] = [run.time_to(best * (1 + above)) for run in runs]
        self.median = {name: median(times) for name, times in self.times.items()}
        self.success = sum(run.success for run in runs) / len(runs)
        self.cost = median([run.cost for run in runs])
        self.checks = median([run.checks for run in runs])
        self.invalid = sum(run.invalid for run in runs)
        self.failed = sum(run.status != "returned" for run in runs)
        self.overrun = sum(run.overrun for run in runs)
        self.floor = math.nan
        self.peer = {}
        self.speedup = {}


def median(sample):
    """The lower middle value of an even number when the upper is infinite would flatter: take the higher then."""
    ordered = sorted(sample)
    middle = len(ordered) // 2
    if len(ordered) % 2:
        return ordered[middle]
    return math.inf if math.isinf(ordered[middle]) else statistics.mean(ordered[middle - 1:middle + 1])


def read_runs(path, clock, worlds):
    runs = []
    with open(path, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            try:
                record = json.loads(line)
            except json.JSONDecodeError as error:
                sys.exit(f"{path}:{number}: not a run: {error}")
            if re.search(worlds, record["world"]):
                runs.append(Run(record, clock))
    if not runs:
        sys.exit(f"{path}: no runs of worlds that match '{worlds}'")
    return runs


def read_references():
    if not REFERENCES.exists():
        return {}
    with open(REFERENCES, encoding="utf-8", newline="") as lines:
        return {row["world"]: float(row["cost"]) for row in csv.DictReader(lines)}


def group(runs, key):
    groups = {}
    for run in runs:
        groups.setdefault(key(run), []).append(run)
    return groups


def compare_with_peers(rows):
    """The best peer of each row at each target. A peer that does not arrive counts as if it did at the time limit,
    which flatters it; where neither arrives there is nothing to compare."""
    for row in rows:
        for target in TARGETS:
            peers = [other for other in rows if other is not row and not OWN.match(other.planner)
                     and (target == "first" or other.planner not in FIRST_ONLY)]
            if not peers:
                continue
            best = min(peers, key=lambda peer: peer.median[target])
            row.peer[target] = best
            own, other = row.median[target], best.median[target]
            if math.isfinite(own) or math.isfinite(other):
                row.speedup[target] = min(other, best.limit) / min(own, row.limit)


def make_rows(runs):
    references = read_references()
    rows = []
    for world, of_world in group(runs, lambda run: run.world).items():
        best = min([references.get(world, math.inf)] + [run.cost for run in of_world])
        near = [run.path_check for run in of_world if run.cost <= 1.01 * best]
        floor = statistics.median(near) if near else math.nan
        of_planner = [Row(same, best) for same in group(of_world, lambda run: run.planner).values()]
        for row in of_planner:
            row.floor = floor
        compare_with_peers(of_planner)
        rows += of_planner
    return rows


def geometric_mean(values):
    return math.exp(statistics.mean(math.log(value) for value in values)) if values else math.nan


def milliseconds(seconds):
    if not math.isfinite(seconds):
        return "-"
    ms = 1000 * seconds
    return f"{ms:.2f}" if ms < 10 else f"{ms:.1f}" if ms < 100 else f"{ms:.0f}"


def excess(row):
    return f"{100 * (row.cost / row.best - 1):.2f}" if math.isfinite(row.cost) else "-"


def remarks(row):
    parts = []
    if row.failed:
        statuses = sorted({run.status for run in row.runs if run.status != "returned"})
        parts.append(f"{row.failed} {'/'.join(statuses)}")
    if row.invalid:
        parts.append(f"{row.invalid} fail check()")
    if row.overrun:
        parts.append(f"{row.overrun} over time")
    return ", ".join(parts)


HEADER = ["planner", "success", "first", "10%", "5%", "1%", "0.1%", "final +%", "kchecks", "1%/floor", "vs peer 1%",
          "0.1%", "remarks"]


def cells(row):
    floor = row.median["1pct"] / row.floor if row.floor else math.inf
    ratios = [f"{row.speedup[target]:.2g}x" if target in row.speedup else "" for target in ("1pct", "01pct")]
    return [row.planner, f"{sum(run.success for run in row.runs)}/{len(row.runs)}",
            *[milliseconds(row.median[target]) for target in TARGETS], excess(row), f"{row.checks / 1000:.0f}",
            f"{floor:.1f}" if math.isfinite(floor) else "-", *ratios, remarks(row)]


def summary(rows):
    """Geometric means over all worlds, for each of our own planners."""
    lines = []
    for planner in sorted({row.planner for row in rows if OWN.match(row.planner)}):
        own = [row for row in rows if row.planner == planner and row.peer]
        for target, name in (("first", "first solution"), ("1pct", "1%"), ("01pct", "0.1%")):
            speedups = [row.speedup[target] for row in own if target in row.speedup]
            if not speedups:
                continue
            behind = [f"{row.world} ({row.speedup[target]:.2g}x, {row.peer[target].planner})" for row in own
                      if row.speedup.get(target, 1.0) < 1.0]
            lines.append(f"{planner}, {name}: {geometric_mean(speedups):.2f}x the best peer's speed (geometric mean "
                         f"over {len(speedups)} of {len(own)} worlds); behind on {len(behind)}"
                         + (": " + ", ".join(behind) if behind else ""))
        lines += first_solutions(planner, rows) + successes(planner, own, rows)
    return lines


def first_solutions(planner, rows):
    ratios = {}
    for world in {row.world for row in rows}:
        first = {row.planner: row.median["first"] for row in rows if row.world == world}
        fastest = min(first.get("rrtconnect", math.inf), first.get("bitstar", math.inf))
        if math.isfinite(fastest) and planner in first:
            ratios[world] = first[planner] / fastest
    over = sorted(f"{world} ({ratio:.2g}x)" for world, ratio in ratios.items() if ratio > 1.5)
    if not ratios:
        return []
    return [f"{planner}: first solution within 1.5x of the faster of RRT-Connect and BIT* on {len(ratios) - len(over)} "
            f"of {len(ratios)} worlds" + ("; not on " + ", ".join(over) if over else "")]


def successes(planner, own, rows):
    below = []
    for row in own:
        best = max(other.success for other in rows if other.world == row.world and not OWN.match(other.planner))
        if row.success < best:
            below.append(f"{row.world} ({row.success:.0%} against {best:.0%})")
    return [f"{planner}: success rate below the best peer's on {len(below)} worlds"
            + (": " + ", ".join(below) if below else "")]


def print_tables(rows, clock):
    table = [(row.world, cells(row)) for row in rows]
    widths = [max(len(line[i]) for line in [HEADER] + [line for _, line in table]) for i in range(len(HEADER))]
    print(f"\nmedian {clock} times in ms; best cost and time to check the best path once (the floor) behind each world")
    world = None
    for row, (name, line) in zip(rows, table):
        if name != world:
            print(f"\n{name}: best {row.best:.6g}, floor {milliseconds(row.floor)} ms, limit {row.limit:g} s")
            print("  " + "  ".join(cell.ljust(width) for cell, width in zip(HEADER, widths)).rstrip())
            world = name
        print("  " + "  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip())
    print()
    for line in summary(rows):
        print(line)


def write_markdown(rows, path, clock):
    with open(path, "w", encoding="utf-8") as out:
        world = None
        for row in rows:
            if row.world != world:
                world = row.world
                out.write(f"\n**{world}**: best cost {row.best:.6g}, floor {milliseconds(row.floor)} ms, "
                          f"{row.limit:g} s ({clock}) a run\n\n| " + " | ".join(HEADER) + " |\n"
                          + "|---|" + "---:|" * (len(HEADER) - 2) + "---|\n")
            out.write("| " + " | ".join(cells(row)) + " |\n")
        out.write("\n")
        for line in summary(rows):
            out.write(f"- {line}\n")


def csv_columns():
    columns = ["world", "planner", "runs", "time_limit_s", "clock", "best_cost", "success_rate", "invalid", "failed",
               "overrun", "final_cost_median", "final_cost_low", "final_cost_high", "checks_median", "floor_s",
               "t1pct_over_floor", "interval_coverage"]
    for target in TARGETS:
        columns += [f"t_{target}_{what}" for what in ("s", "low_s", "high_s", "reached", "best_peer", "best_peer_s",
                                                      "speedup")]
    return columns


def csv_record(row, clock):
    low, high, coverage = order_statistic_interval([run.cost for run in row.runs])
    record = {"world": row.world, "planner": row.planner, "runs": len(row.runs), "time_limit_s": row.limit,
              "clock": clock, "best_cost": row.best, "success_rate": row.success, "invalid": row.invalid,
              "failed": row.failed, "overrun": row.overrun, "final_cost_median": row.cost, "final_cost_low": low,
              "final_cost_high": high, "checks_median": row.checks, "floor_s": row.floor,
              "t1pct_over_floor": row.median["1pct"] / row.floor if row.floor else math.nan,
              "interval_coverage": round(coverage, 4)}
    for target in TARGETS:
        low, high, _ = order_statistic_interval(row.times[target])
        peer = row.peer.get(target)
        record.update({f"t_{target}_s": row.median[target], f"t_{target}_low_s": low, f"t_{target}_high_s": high,
                       f"t_{target}_reached": sum(map(math.isfinite, row.times[target])) / len(row.runs),
                       f"t_{target}_best_peer": peer.planner if peer else "",
                       f"t_{target}_best_peer_s": peer.median[target] if peer else "",
                       f"t_{target}_speedup": row.speedup.get(target, "")})
    return {key: f"{value:.7g}" if isinstance(value, float) else value for key, value in record.items()}


def write_csv(rows, path, clock):
    with open(path, "w", encoding="utf-8", newline="") as out:
        writer = csv.DictWriter(out, csv_columns(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(csv_record(row, clock) for row in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", help="file of runs, one JSON object a line")
    parser.add_argument("--clock", choices=["cpu", "wall"], default="cpu")
    parser.add_argument("--worlds", default=".", help="regular expression that selects worlds")
    parser.add_argument("--csv", help="write a row a world and planner to this file")
    parser.add_argument("--markdown", help="write the tables to this file")
    options = parser.parse_args()
    rows = make_rows(read_runs(options.runs, options.clock, options.worlds))
    print_tables(rows, options.clock)
    if options.csv:
        write_csv(rows, options.csv, options.clock)
    if options.markdown:
        write_markdown(rows, options.markdown, options.clock)


if __name__ == "__main__":
    main()
