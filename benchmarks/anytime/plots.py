#!/usr/bin/python3
"""Plots of cost over time in selected worlds, from the tables of report.py: plots.py RESULTS SVG

For a world in curves.csv, lines are median costs and bands their intervals. For others, steps are drawn from
planners.csv: with an odd number of runs the median cost is at most 10% above the best after the median time to 10%, and
so forth; bars are the intervals of these times. Markers on the upper edge are first paths of any cost. Drawn are MFA
and those peers that are the best of the world in one of the measures."""

import argparse
import math
import pathlib

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt

from cost_over_time import FIRST_ONLY, LEVELS, OWN, TARGETS
from results import TELLING, read_records, value_of

COLOURS = {"mfa": "#1b7837", "rrtstar": "#666666", "informedrrtstar": "#d95f02", "prmstar": "#a6761d",
           "bitstar": "#1f77b4", "abitstar": "#7b3294", "aitstar": "#e6ab02", "anytimepathshortening": "#e7298a",
           "restart_simplify": "#66c2a5", "rrtconnect": "#000000"}
NAMES = {"mfa": "MFA", "rrtstar": "RRT*", "informedrrtstar": "Informed RRT*", "prmstar": "PRM*", "bitstar": "BIT*",
         "abitstar": "ABIT*", "aitstar": "AIT*", "anytimepathshortening": "AnytimePathShortening",
         "restart_simplify": "RRT-Connect restarted, simplified", "rrtconnect": "RRT-Connect (first path)"}
LEAST, MOST = 0.03, 300.0
TICKS = [0.1, 1, 5, 10, 100]


def shown(rows):
    """Of the rows of one world, those of MFA and of peers that reach some target first or have the lowest final
    cost."""
    peers = [row for row in rows if not OWN.match(row["planner"])]
    best = set()
    for column in [*(f"{target}_ms" for target in TARGETS), "final_pct"]:
        able = [row for row in peers if column == "first_ms" or row["planner"] not in FIRST_ONLY]
        row = min(able, key=lambda row: value_of(row[column]), default=None)
        if row and math.isfinite(value_of(row[column])):
            best.add(row["planner"])
    return [row for row in rows if row["planner"] == "mfa" or row["planner"] in best]


def steps(row, limit_ms):
    """Corners (ms, %) of the upper bound on the median cost given by the times to each level. The first path may have
    any cost."""
    corners = []
    for target, level in [("first", MOST), *((target, 100 * LEVELS[target]) for target in LEVELS)]:
        time = value_of(row[f"{target}_ms"])
        if math.isfinite(time):
            corners.append((time, level))
    final = value_of(row["final_pct"])
    if corners and math.isfinite(final):
        corners.append((limit_ms, min(max(final, LEAST), corners[-1][1])))
    return corners


def draw_steps(axes, row, limit_ms, style):
    corners = steps(row, limit_ms)
    first_only = row["planner"] in FIRST_ONLY
    if len(corners) > 1 and not first_only:
        # the tables do not give the cost between the first path and the first level reached
        axes.plot(*zip(*corners[:2]), **{**style, "linewidth": 1.0, "linestyle": ":"})
        axes.plot(*zip(*corners[1:]), drawstyle="steps-post", **style)
        axes.plot(*corners[-1], "D", color=style["color"], markersize=4, clip_on=False, zorder=style["zorder"])
    for target, level in [("first", MOST), *((target, 100 * LEVELS[target]) for target in LEVELS)]:
        low, high = value_of(row[f"{target}_low_ms"]), value_of(row[f"{target}_high_ms"])
        if first_only and target != "first" or not math.isfinite(low):
            continue
        mark = {"color": style["color"], "zorder": style["zorder"], "clip_on": False}
        axes.plot([low, min(high, limit_ms)], [level, level], linewidth=3.5, alpha=0.35, solid_capstyle="butt", **mark)
        if math.isfinite(value_of(row[f"{target}_ms"])):
            axes.plot(value_of(row[f"{target}_ms"]), level, "v" if target == "first" else "o", markersize=4, **mark)


def draw_curve(axes, curve, style):
    times = [value_of(point["time_ms"]) for point in curve]
    # costs are clamped to the lower edge; infinite ones lie beyond the upper edge
    low, middle, high = ([min(max(value_of(point[column]), LEAST), 10 * MOST) for point in curve]
                         for column in ("low_pct", "median_pct", "high_pct"))
    axes.plot(times, middle, **style)
    axes.fill_between(times, low, high, color=style["color"], alpha=0.15, linewidth=0)


def draw_world(axes, world, rows, curves):
    limit_ms = 1000 * value_of(world["time_limit_s"])
    for row in rows:
        planner = row["planner"]
        own = bool(OWN.match(planner))
        style = {"color": COLOURS.get(planner, "#999999"), "linewidth": 2.4 if own else 1.2, "zorder": 4 if own else 3}
        curve = [point for point in curves if point["planner"] == planner]
        if curve and planner not in FIRST_ONLY:
            draw_curve(axes, curve, style)
        else:
            draw_steps(axes, row, limit_ms, style)
    earliest = min(value_of(row["first_low_ms"]) for row in rows)
    axes.set(xscale="log", yscale="log", xlim=(0.7 * min(earliest, limit_ms / 10), 1.1 * limit_ms), ylim=(LEAST, MOST),
             title=world["world"])
    axes.set_yticks(TICKS, [f"{tick:g}%" for tick in TICKS])
    axes.set_yticks([], minor=True)
    axes.grid(axis="y", color="#dddddd", linewidth=0.7)


def draw(results, names):
    """A figure with a panel per world; None if the tables contain none of them."""
    worlds = {row["world"]: row for row in read_records(results / "worlds.csv")}
    planners, curves = read_records(results / "planners.csv"), read_records(results / "curves.csv")
    names = [name for name in names if name in worlds]
    if not names:
        return None
    columns = min(3, len(names))
    figure, panels = plt.subplots(math.ceil(len(names) / columns), columns, squeeze=False, layout="constrained",
                                  figsize=(4.2 * columns, 3.4 * math.ceil(len(names) / columns)))
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1)
    drawn = {}
    for axes, name in zip(panels.flat, names):
        rows = shown([row for row in planners if row["world"] == name])
        draw_world(axes, worlds[name], rows, [point for point in curves if point["world"] == name])
        drawn |= dict.fromkeys(row["planner"] for row in rows)
    for axes in panels.flat[len(names):]:
        axes.set_visible(False)
    for axes in panels[:, 0]:
        axes.set_ylabel("cost above the best known")
    for axes in panels[-1]:
        axes.set_xlabel(f"{worlds[names[0]]['clock']} time [ms]")
    order = [planner for planner in NAMES if planner in drawn]
    figure.legend([plt.Line2D([], [], color=COLOURS[planner], linewidth=0 if planner in FIRST_ONLY else 2,
                              marker="v" if planner in FIRST_ONLY else None) for planner in order],
                  [NAMES[planner] for planner in order], loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=pathlib.Path, help="folder of planners.csv and worlds.csv, and of curves.csv")
    parser.add_argument("svg", type=pathlib.Path, help="file to write")
    parser.add_argument("--worlds", default=",".join(TELLING), help="names of the worlds to draw")
    options = parser.parse_args()
    plt.rcParams["svg.hashsalt"] = "ompl_mfa"
    figure = draw(options.results, options.worlds.split(","))
    if figure is None:
        parser.error(f"{options.results}: no results of {options.worlds}")
    figure.savefig(options.svg, bbox_inches="tight", metadata={"Date": None})


if __name__ == "__main__":
    main()
