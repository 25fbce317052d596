"""The tables of a campaign as CSV files: one row a world and planner, a world, a comparison, and a time of a curve.

Times are in ms, costs in % above the best one known. `inf` is a median (or an end of its interval) that was not reached,
an empty cell something that is not known."""

import csv
import math
import re

from cost_over_time import TARGETS, median, order_statistic_interval

# Worlds whose cost over time is drawn: one of each kind, and own_slalom, where MFA is behind for most of the time.
TELLING = ["circles_narrow_2d_7", "double_enclosure_2d_1", "random_boxes_8d_2", "arm_7_1", "own_slalom",
           "omplapp_Barriers"]
POINTS_A_DECADE = 16
EARLIEST = 1e-4


def number(value):
    """The value as text: six digits, empty if unknown."""
    if isinstance(value, float):
        return "" if math.isnan(value) else f"{value:.6g}"
    return "" if value is None else str(value)


def excess(cost, best):
    return 100 * (cost / best - 1)


def speedup_cells(row, target):
    value, bound = row.speedup(target) or (None, "")
    return {f"{target}_speedup": value, f"{target}_speedup_bound": bound}


def remarks(row):
    parts = []
    if row.failed:
        parts.append(f"{len(row.failed)} {'/'.join(sorted(set(row.failed)))}")
    if row.invalid:
        parts.append(f"{row.invalid} fail check()")
    if row.lax:
        parts.append(f"{row.lax} invalid at 8 times the resolution")
    if row.overrun:
        parts.append(f"{row.overrun} over time")
    return ", ".join(parts)


def planner_record(row):
    record = {"world": row.world, "planner": row.planner, "runs": len(row.runs), "successes": row.successes}
    for target in TARGETS:
        low, high, _ = order_statistic_interval(row.times[target])
        record |= {f"{target}_ms": 1000 * row.median[target], f"{target}_low_ms": 1000 * low,
                   f"{target}_high_ms": 1000 * high}
    low, high, coverage = order_statistic_interval([run.cost for run in row.runs])
    return {**record, "final_pct": excess(row.cost, row.best), "final_low_pct": excess(low, row.best),
            "final_high_pct": excess(high, row.best), "interval_coverage_pct": 100 * coverage,
            "kchecks": row.checks / 1000, "1pct_over_floor": row.floors_to_1pct(), **speedup_cells(row, "1pct"),
            **speedup_cells(row, "01pct"), "remarks": remarks(row)}


def world_record(row, clock):
    return {"world": row.world, "best_cost": row.best, "floor_ms": 1000 * row.floor, "time_limit_s": row.limit,
            "clock": clock}


def comparison_record(row):
    """Comparison of one variant of MFA with the best peer of a world. A peer that does not reach the target has no
    name."""
    record = {"world": row.world, "planner": row.planner}
    for target in ("1pct", "01pct"):
        peer = row.best_peer(target)
        record |= {f"{target}_ms": 1000 * row.median[target], f"{target}_peer_ms": 1000 * peer.median[target],
                   f"{target}_peer": peer.planner if math.isfinite(peer.median[target]) else "",
                   **speedup_cells(row, target)}
    return {**record, "final_pct": excess(row.cost, row.best),
            "peer_final_pct": excess(min(peer.cost for peer in row.peers), row.best), "first_ratio": row.first_ratio(),
            "success_pct": 100 * row.success, "peer_success_pct": 100 * max(peer.success for peer in row.peers)}


def cost_at(run, time):
    """Cost of the best path of a run at a time."""
    return min((cost for reached, cost in run.curve if reached <= time), default=math.inf)


def curve_records(row):
    """Median cost over time with its interval, at logarithmically spaced times."""
    steps = math.floor(POINTS_A_DECADE * math.log10(row.limit / EARLIEST))
    times = [row.limit * 10 ** (-k / POINTS_A_DECADE) for k in range(steps, -1, -1)]
    for time in times:
        costs = [cost_at(run, time) for run in row.runs]
        low, high, _ = order_statistic_interval(costs)
        # times at which even the lower end of the interval is infinite are left out
        if math.isfinite(low):
            yield {"world": row.world, "planner": row.planner, "time_ms": 1000 * time,
                   "median_pct": excess(median(costs), row.best), "low_pct": excess(low, row.best),
                   "high_pct": excess(high, row.best)}


def write_records(records, path):
    """Writes one CSV file of records with the same keys. Without records an existing file is removed."""
    path.unlink(missing_ok=True)
    if not records:
        return
    with open(path, "w", encoding="utf-8", newline="") as out:
        writer = csv.DictWriter(out, records[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: number(value) for key, value in record.items()} for record in records)


def read_records(path):
    """The rows of such a file as text; empty if there is no file."""
    if not path.exists():
        return []
    with open(path, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


def value_of(text):
    return float(text) if text else math.nan


def write_results(rows, own, folder, clock, curves="|".join(TELLING)):
    """Writes all tables of a campaign: planners.csv, worlds.csv, summary.csv, and curves.csv of the selected worlds."""
    folder.mkdir(parents=True, exist_ok=True)
    write_records([planner_record(row) for row in rows], folder / "planners.csv")
    first_rows = {row.world: row for row in reversed(rows)}
    write_records([world_record(first_rows[world], clock) for world in dict.fromkeys(row.world for row in rows)],
                  folder / "worlds.csv")
    write_records([comparison_record(row) for row in own], folder / "summary.csv")
    write_records([record for row in rows if re.search(curves, row.world) for record in curve_records(row)],
                  folder / "curves.csv")
