#!/usr/bin/python3
"""Tables of the runs that ompl_mfa_anytime made: on the terminal, in Markdown, and as CSV files."""

import argparse
import datetime
import math
import pathlib
import statistics

from cost_over_time import (REFERENCES, TARGETS, geometric_mean, make_rows, order_statistic_interval, read_references, read_runs,
                            update_references)
from results import TELLING, excess, planner_record, remarks, write_records, write_results

TITLES = {"first": "first", "10pct": "10%", "5pct": "5%", "1pct": "1%", "01pct": "0.1%"}


def milliseconds(seconds):
    if not math.isfinite(seconds):
        return "-"
    ms = 1000 * seconds
    return f"{ms:.2f}" if ms < 10 else f"{ms:.1f}" if ms < 100 else f"{ms:.0f}"


def with_interval(row, target):
    low, high, _ = order_statistic_interval(row.times[target])
    if not math.isfinite(low):
        return "-"
    return f"{milliseconds(row.median[target])} [{milliseconds(low)}, {milliseconds(high)}]"


def ratio(value):
    return "" if value is None else f"{value[1]}{value[0]:.3g}x"


def percent_above(row):
    """Median final cost above the best known cost, in %."""
    return f"{excess(row.cost, row.best):.2f}" if math.isfinite(row.cost) else "-"


def world_cells(row, interval):
    """A row of the table of one world."""
    times = [with_interval(row, target) if interval else milliseconds(row.median[target]) for target in TARGETS]
    floors = row.floors_to_1pct()
    return [row.planner, f"{row.successes}/{len(row.runs)}", *times, percent_above(row),
            f"{row.checks / 1000:.3g}", f"{floors:.3g}" if math.isfinite(floors) else "-", ratio(row.speedup("1pct")),
            ratio(row.speedup("01pct")), remarks(row)]


WORLD_HEADER = ["planner", "success", *(TITLES[target] for target in TARGETS), "final +%", "kchecks", "1%/floor",
                "vs peer 1%", "vs peer 0.1%", "remarks"]

SUMMARY_HEADER = ["world", "1%: own", "best peer", "", "speed", "0.1%: own", "best peer", "", "speed",
                  "final +%: own", "best peer's", "first / RRT-Connect or BIT*", "success", "best peer's"]


def summary_cells(row):
    """A row of the table that compares one variant of MFA with the best peer of each world."""
    cells = [row.world]
    for target in ("1pct", "01pct"):
        peer = row.best_peer(target)
        arrives = math.isfinite(peer.median[target])
        cells += [milliseconds(row.median[target]), milliseconds(peer.median[target]),
                  peer.planner if arrives else "", ratio(row.speedup(target))]
    cells += [percent_above(row), percent_above(min(row.peers, key=lambda peer: peer.cost))]
    first = row.first_ratio()
    return [*cells, "" if first is None else f"{first:.2g}x" if math.isfinite(first) else "never",
            f"{row.success:.0%}", f"{max(peer.success for peer in row.peers):.0%}"]


def verdicts(own):
    """Summary of one planner: geometric means of the speed-up, and the worlds in which it is behind."""
    lines = []
    for target in ("1pct", "01pct"):
        known = [(row, row.speedup(target)) for row in own if row.speedup(target)]
        if not known:
            continue
        behind = [row.world for row, value in known if value[0] < 1]
        lines.append(f"{TITLES[target]}: {geometric_mean([value[0] for _, value in known]):.2f}x the speed of each "
                     f"world's best peer (geometric mean over the {len(known)} of {len(own)} worlds where one of the "
                     f"two arrives); behind on {len(behind)}" + (": " + ", ".join(behind) if behind else ""))
    late = [row.world for row in own if row.first_ratio() is not None and row.first_ratio() > 1.5]
    lines.append(f"first solution later than 1.5 times the faster of RRT-Connect and BIT* on {len(late)}"
                 + (": " + ", ".join(late) if late else ""))
    below = [row.world for row in own if row.success < max(peer.success for peer in row.peers)]
    lines.append(f"success rate below the best peer's on {len(below)}" + (": " + ", ".join(below) if below else ""))
    return lines


def own_planners(rows):
    """The rows of each variant of MFA that has peers to be compared with."""
    names = dict.fromkeys(row.planner for row in rows if row.is_own())
    return {name: own for name in names
            if (own := [row for row in rows if row.planner == name and row.best_peer("1pct")])}


def world_title(row):
    return f"best cost {row.best:.6g}, floor {milliseconds(row.floor)} ms, {row.limit:g} s a run"


def by_world(rows):
    worlds = {}
    for row in rows:
        worlds.setdefault(row.world, []).append(row)
    return worlds.items()


def print_table(header, lines):
    widths = [max(len(line[i]) for line in [header, *lines]) for i in range(len(header))]
    for line in [header, *lines]:
        print("  " + "  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip())


def print_tables(rows, clock):
    print(f"\nmedian {clock} times in ms; the floor is the time to check the best path once")
    for world, same in by_world(rows):
        print(f"\n{world}: {world_title(same[0])}")
        print_table(WORLD_HEADER, [world_cells(row, interval=False) for row in same])
    for name, own in own_planners(rows).items():
        print(f"\n{name} against the best peer of each world")
        print_table(SUMMARY_HEADER, [summary_cells(row) for row in own])
        for line in verdicts(own):
            print("  " + line)


def write_table(out, header, lines):
    out.write("\n| " + " | ".join(header) + " |\n|---|" + "---:|" * (len(header) - 1) + "\n")
    for line in lines:
        out.write("| " + " | ".join(line) + " |\n")


def write_markdown(rows, path, clock):
    counts = [len(row.runs) for row in rows]
    coverage = statistics.median(order_statistic_interval(row.times["first"])[2] for row in rows)
    with open(path, "w", encoding="utf-8") as out:
        seeds = f"{min(counts)} to {max(counts)}" if min(counts) < max(counts) else f"{counts[0]}"
        out.write(f"{datetime.date.today()}; {seeds} seeds a cell; {clock} times, medians in ms "
                  f"with the {100 * coverage:.3g}% interval of their order statistics.\n")
        for name, own in own_planners(rows).items():
            out.write(f"\n`{name}` against the best peer of each world:\n")
            write_table(out, SUMMARY_HEADER, [summary_cells(row) for row in own])
            out.write("\n" + "".join(f"- {line}\n" for line in verdicts(own)))
        for world, same in by_world(rows):
            out.write(f"\n**{world}**: {world_title(same[0])}\n")
            write_table(out, WORLD_HEADER, [world_cells(row, interval=True) for row in same])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", nargs="+", help="files of runs, one JSON object a line")
    parser.add_argument("--clock", choices=["cpu", "wall"], default="cpu")
    parser.add_argument("--worlds", default=".", help="regular expression that selects worlds")
    parser.add_argument("--csv", help="write a row a world and planner to this file")
    parser.add_argument("--markdown", help="write the tables to this file")
    parser.add_argument("--results", type=pathlib.Path,
                        help="write planners.csv, worlds.csv, summary.csv and curves.csv to this folder")
    parser.add_argument("--curves", default="|".join(TELLING),
                        help="regular expression that selects the worlds of curves.csv")
    parser.add_argument("--references", type=pathlib.Path, action="append", default=[],
                        help="best costs of further worlds, as `ompl_mfa_anytime optima --generated` prints them")
    parser.add_argument("--update-references", action="store_true", help="store the best paths found")
    options = parser.parse_args()
    runs = read_runs(options.runs, options.clock, options.worlds)
    if options.update_references:
        update_references(runs, str(datetime.date.today()))
    references = {}
    for path in [*options.references, REFERENCES]:
        references |= read_references(path)
    rows = make_rows(runs, references)
    print_tables(rows, options.clock)
    if options.csv:
        write_records([planner_record(row) for row in rows], pathlib.Path(options.csv))
    if options.results:
        own = [row for same in own_planners(rows).values() for row in same]
        write_results(rows, own, options.results, options.clock, options.curves)
    if options.markdown:
        write_markdown(rows, options.markdown, options.clock)


if __name__ == "__main__":
    main()
