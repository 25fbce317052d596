#!/usr/bin/python3
"""What each part of MFA contributes: the runs of its variants that ompl_mfa_anytime made, a table in Markdown.

A cell is the median final cost above the best cost known, in %. Against the column of the whole planner, + marks a variant
that ends better and - one that ends worse (Mann-Whitney, two-sided, p < 0.05)."""

import argparse
import math

from scipy.stats import mannwhitneyu

from cost_over_time import best_cost, group, median, read_references, read_runs

SIGNIFICANT = 0.05


def mark(costs, whole):
    """How the costs of a variant compare with those of the whole planner; a run without a path costs infinitely much."""
    finite = [cost for cost in [*costs, *whole] if math.isfinite(cost)]
    if not finite or set(costs) == set(whole):
        return ""
    worst = 2 * max(finite)
    a, b = ([min(cost, worst) for cost in sample] for sample in (costs, whole))
    if mannwhitneyu(a, b, alternative="two-sided").pvalue >= SIGNIFICANT:
        return ""
    return "-" if mannwhitneyu(a, b, alternative="greater").pvalue < SIGNIFICANT / 2 else "+"


def table(runs, references, whole):
    """Header and lines of the table, the last of which counts the marks of each variant."""
    variants = list(dict.fromkeys([whole, *(run.planner for run in runs)]))
    counts = {variant: [0, 0] for variant in variants}
    lines = []
    for world, same in group(runs, lambda run: run.world).items():
        best = best_cost(references.get(world), same)
        costs = {variant: [run.cost for run in same if run.planner == variant] for variant in variants}
        line = [world]
        for variant in variants:
            if not costs[variant] or not costs[whole]:
                line.append("")
                continue
            cost = median(costs[variant])
            sign = "" if variant == whole else mark(costs[variant], costs[whole])
            counts[variant][0] += sign == "-"
            counts[variant][1] += sign == "+"
            line.append((f"{100 * (cost / best - 1):.2f}" if math.isfinite(cost) else "no path") + (sign and " " + sign))
        lines.append(line)
    summary = [f"{worse} worse, {better} better" for worse, better in counts.values()]
    return ["world", *variants], [*lines, ["worlds", "", *summary[1:]]]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", nargs="+", help="files of runs, one JSON object a line")
    parser.add_argument("--whole", default="mfa", help="the planner that the others are variants of")
    parser.add_argument("--worlds", default=".", help="regular expression that selects worlds")
    options = parser.parse_args()
    header, lines = table(read_runs(options.runs, "cpu", options.worlds), read_references(), options.whole)
    print("| " + " | ".join(f"`{name}`" if name != "world" else name for name in header) + " |")
    print("|---|" + "---:|" * (len(header) - 1))
    for line in lines:
        print("| " + " | ".join(line) + " |")


if __name__ == "__main__":
    main()
