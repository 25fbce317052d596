#!/usr/bin/python3
"""What each part of MFA contributes: the runs of its variants that ompl_mfa_anytime made, two tables in Markdown.

The first has median final costs above the best cost known, in %. The second has median times in ms to the nearest of 1, 5 and
10% above it that the median run of the whole planner reaches, or to the first solution. Against the column of the whole
planner, + marks a variant that is better and - one that is worse (Mann-Whitney, two-sided, p < 0.05). The last line has how
often a run of the variant is worse than one of the whole planner, the mean over the worlds (0.5: no difference), and
whether that is by chance (Wilcoxon, signed ranks of the worlds, two-sided)."""

import argparse
import math

from scipy.stats import mannwhitneyu, wilcoxon

from cost_over_time import LEVELS, best_cost, group, median, read_references, read_runs

SIGNIFICANT = 0.05


def finite(values, others):
    """The values, those that are infinite as larger than all others; None where nothing is finite."""
    known = [value for value in [*values, *others] if math.isfinite(value)]
    return [min(value, 2 * max(known) + 1) for value in values] if known else None


def mark(values, whole):
    """How the values of a variant (less is better) compare with those of the whole planner."""
    a, b = finite(values, whole), finite(whole, values)
    if a is None or set(a) == set(b) or mannwhitneyu(a, b, alternative="two-sided").pvalue >= SIGNIFICANT:
        return ""
    return "-" if mannwhitneyu(a, b, alternative="greater").pvalue < SIGNIFICANT / 2 else "+"


def worse_share(values, whole):
    """The share of pairs of a run of the variant and one of the whole planner in which the former is worse."""
    pairs = [(value, other) for value in values for other in whole]
    return sum((value > other) + 0.5 * (value == other) for value, other in pairs) / len(pairs)


def overall(shares):
    """Mean of the shares of all worlds, and p."""
    if not shares:
        return ""
    differences = [share - 0.5 for share in shares if share != 0.5]
    chance = wilcoxon(differences).pvalue if differences else 1.0
    return f"{sum(shares) / len(shares):.2f} (p {f'{chance:.2f}' if chance >= 0.01 else '< 0.01'})"


def final_cost(best, _):
    """Of a run, and how to write it."""
    return lambda run: run.cost, lambda cost: f"{100 * (cost / best - 1):.2f}" if math.isfinite(cost) else "no path"


def time_to_level(best, whole):
    """The same for the time to the nearest level that the median of these runs reaches."""
    costs = [best * (1 + LEVELS[level]) for level in ("1pct", "5pct", "10pct")] + [math.inf]
    level = next((cost for cost in costs if math.isfinite(median([run.time_to(cost) for run in whole]))), math.inf)
    return lambda run: run.time_to(level), lambda time: f"{1000 * time:.4g}" if math.isfinite(time) else "never"


def table(runs, references, whole, quantity):
    """Header and lines of the table, the last two of which sum up each variant."""
    variants = list(dict.fromkeys([whole, *(run.planner for run in runs)]))
    counts = {variant: [0, 0] for variant in variants}
    shares = {variant: [] for variant in variants}
    lines = []
    for world, same in group(runs, lambda run: run.world).items():
        value, text = quantity(best_cost(references.get(world), same), [run for run in same if run.planner == whole])
        values = {variant: [value(run) for run in same if run.planner == variant] for variant in variants}
        line = [world]
        for variant in variants:
            if not values[variant] or not values[whole]:
                line.append("")
                continue
            sign = "" if variant == whole else mark(values[variant], values[whole])
            counts[variant][0] += sign == "-"
            counts[variant][1] += sign == "+"
            shares[variant].append(worse_share(values[variant], values[whole]))
            line.append(text(median(values[variant])) + (sign and " " + sign))
        lines.append(line)
    summary = [f"{worse} worse, {better} better" for worse, better in counts.values()]
    means = [overall(shares[variant]) for variant in variants]
    return ["world", *variants], [*lines, ["worlds", "", *summary[1:]], ["a run is worse", "", *means[1:]]]


def write(header, lines):
    print("| " + " | ".join(f"`{name}`" if name != "world" else name for name in header) + " |")
    print("|---|" + "---:|" * (len(header) - 1))
    for line in lines:
        print("| " + " | ".join(line) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", nargs="+", help="files of runs, one JSON object a line")
    parser.add_argument("--whole", default="mfa", help="the planner that the others are variants of")
    parser.add_argument("--worlds", default=".", help="regular expression that selects worlds")
    options = parser.parse_args()
    runs = read_runs(options.runs, "cpu", options.worlds)
    for title, quantity in (("Final cost, %", final_cost), ("Time, ms", time_to_level)):
        print(f"**{title}**\n")
        write(*table(runs, read_references(), options.whole, quantity))
        print()


if __name__ == "__main__":
    main()
