#!/usr/bin/python3
"""Contribution of each part of MFA: two Markdown tables of the runs of its variants by ompl_mfa_anytime.

The first has median final costs above the best known cost, in %. The second has median times in ms to the lowest of 1,
5 and 10% above it that the median run of the whole planner reaches, or to the first solution. + marks a variant that is
better and - one that is worse than the whole planner (Mann-Whitney, two-sided, p < 0.05). The last lines are the
probability that a run of the variant is worse than one of the whole planner, averaged over the worlds (0.5: no
difference), and its significance (Wilcoxon, signed ranks of the worlds, two-sided). --results writes both tables as CSV
files."""

import argparse
import math
import pathlib

from scipy.stats import mannwhitneyu, wilcoxon

from cost_over_time import LEVELS, best_cost, group, median, read_references, read_runs
from results import write_records

SIGNIFICANT = 0.05


def finite(values, others):
    """The values with infinite ones replaced by a number larger than all others; None if none is finite."""
    known = [value for value in [*values, *others] if math.isfinite(value)]
    return [min(value, 2 * max(known) + 1) for value in values] if known else None


def mark(values, whole):
    """Comparison of the values of a variant (lower is better) with those of the whole planner."""
    a, b = finite(values, whole), finite(whole, values)
    if a is None or set(a) == set(b) or mannwhitneyu(a, b, alternative="two-sided").pvalue >= SIGNIFICANT:
        return ""
    return "-" if mannwhitneyu(a, b, alternative="greater").pvalue < SIGNIFICANT / 2 else "+"


def worse_share(values, whole):
    """Fraction of the pairs of a run of the variant and one of the whole planner in which the former is worse."""
    pairs = [(value, other) for value in values for other in whole]
    return sum((value > other) + 0.5 * (value == other) for value, other in pairs) / len(pairs)


def mean_share(shares):
    """Mean of these fractions over all worlds, and p."""
    differences = [share - 0.5 for share in shares if share != 0.5]
    return sum(shares) / len(shares), wilcoxon(differences).pvalue if differences else 1.0


def overall(shares):
    """The result of mean_share() as text."""
    if not shares:
        return ""
    mean, chance = mean_share(shares)
    return f"{mean:.2f} (p {f'{chance:.2f}' if chance >= 0.01 else '< 0.01'})"


def final_cost(best, _):
    """A quantity of a run and its format."""
    return lambda run: run.cost, lambda cost: f"{100 * (cost / best - 1):.2f}" if math.isfinite(cost) else "no path"


def time_to_level(best, whole):
    """As above, for the time to the lowest level that the median of these runs reaches."""
    costs = [best * (1 + LEVELS[level]) for level in ("1pct", "5pct", "10pct")] + [math.inf]
    level = next((cost for cost in costs if math.isfinite(median([run.time_to(cost) for run in whole]))), math.inf)
    return lambda run: run.time_to(level), lambda time: f"{1000 * time:.4g}" if math.isfinite(time) else "never"


class Comparison:
    """The variants' medians of one quantity in each world, and how they compare with the whole planner's."""

    def __init__(self, runs, references, whole, quantity):
        self.whole = whole
        self.variants = list(dict.fromkeys([whole, *(run.planner for run in runs)]))
        # per world, a median and a mark for each variant; None if it has no runs
        self.cells = {}
        self.texts = {}
        self.shares = {variant: [] for variant in self.variants}
        for world, same in group(runs, lambda run: run.world).items():
            value, self.texts[world] = quantity(best_cost(references.get(world), same),
                                                [run for run in same if run.planner == whole])
            values = {variant: [value(run) for run in same if run.planner == variant] for variant in self.variants}
            self.cells[world] = {variant: self.compare(variant, values) for variant in self.variants}

    def compare(self, variant, values):
        if not values[variant] or not values[self.whole]:
            return None
        self.shares[variant].append(worse_share(values[variant], values[self.whole]))
        return median(values[variant]), "" if variant == self.whole else mark(values[variant], values[self.whole])

    def count(self, variant, sign):
        return sum(cells[variant] is not None and cells[variant][1] == sign for cells in self.cells.values())


def table(comparison):
    """Header and rows of the table; the last two rows summarise each variant."""
    lines = []
    for world, cells in comparison.cells.items():
        lines.append([world, *("" if cell is None else " ".join([comparison.texts[world](cell[0]), cell[1]]).strip()
                               for cell in cells.values())])
    others = comparison.variants[1:]
    summary = [f"{comparison.count(variant, '-')} worse, {comparison.count(variant, '+')} better" for variant in others]
    means = [overall(comparison.shares[variant]) for variant in others]
    return ["world", *comparison.variants], [*lines, ["worlds", "", *summary], ["a run is worse", "", *means]]


def write_results(final, time, folder):
    """ablation.csv with a row per world and variant, and ablation_summary.csv with a row per variant."""
    words = {"": "", "-": "worse", "+": "better"}
    records = []
    for world, cells in final.cells.items():
        for variant, cell in cells.items():
            if cell is not None:
                cost = final.texts[world](cell[0])
                late = time.cells[world][variant]
                records.append({"world": world, "planner": variant, "final_pct": "inf" if cost == "no path" else cost,
                                "final_mark": words[cell[1]], "time_ms": 1000 * late[0], "time_mark": words[late[1]]})
    sums = []
    for variant in final.variants[1:]:
        if not final.shares[variant]:
            continue
        record = {"planner": variant}
        for name, comparison in (("final", final), ("time", time)):
            mean, chance = mean_share(comparison.shares[variant])
            record |= {f"{name}_worse": comparison.count(variant, "-"),
                       f"{name}_better": comparison.count(variant, "+"), f"{name}_worse_share": mean, f"{name}_p": float(chance)}
        sums.append(record)
    folder.mkdir(parents=True, exist_ok=True)
    write_records(records, folder / "ablation.csv")
    write_records(sums, folder / "ablation_summary.csv")


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
    parser.add_argument("--results", type=pathlib.Path,
                        help="write ablation.csv and ablation_summary.csv to this folder")
    options = parser.parse_args()
    runs = read_runs(options.runs, "cpu", options.worlds)
    final, time = (Comparison(runs, read_references(), options.whole, quantity)
                   for quantity in (final_cost, time_to_level))
    for title, comparison in (("Final cost, %", final), ("Time, ms", time)):
        print(f"**{title}**\n")
        write(*table(comparison))
        print()
    if options.results:
        write_results(final, time, options.results)


if __name__ == "__main__":
    main()
