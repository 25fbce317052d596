"""table.csv, tests.csv, ranks.csv, to_1_percent.csv and the tables of docs/paper.md, from the runs of ompl_mfa_paper_study.

tables.py FOLDER [--docs docs/paper.md]
"""

import csv
import math
import os
import re
import sys
from collections import defaultdict
from itertools import combinations

import numpy
from scipy import stats

from runs import ABLATIONS, ALGORITHMS, feasible_costs, merit, read, runs_of, scenes_of

PAPER_TABLE = {"ga": (29.83, 31.19), "fa": (29.58, 30.84), "mfa": (28.46, 29.82)}
PAPER_SCENES = ["paper_1", "paper_2", "paper_3", "paper_4"]
COLUMNS = ["runs", "shortest", "mean", "median", "worst", "sd", "feasible_share", "evaluations", "optimum"]
# Only this file contains wall times, as medians: all others are reproducible.
COLUMNS_TO_1_PERCENT = ["share_to_1_percent", "evaluations_to_1_percent", "seconds_to_1_percent"]


def holm(p_values):
    """Holm's step-down correction."""
    order = numpy.argsort(p_values)
    corrected = numpy.empty(len(p_values))
    largest = 0.0
    for rank, index in enumerate(order):
        largest = max(largest, min(1.0, (len(p_values) - rank) * p_values[index]))
        corrected[index] = largest
    return corrected


def compare(a, b):
    """Mann-Whitney's two-sided p, and Vargha and Delaney's A: the probability that a run of a is better than one of
    b."""
    a, b = [merit(run) for run in a], [merit(run) for run in b]
    if set(a) == set(b) and len(set(a)) == 1:
        return 1.0, 0.5
    greater, p = stats.mannwhitneyu(b, a, alternative="two-sided", method="asymptotic")
    return p, greater / (len(a) * len(b))


def summary(runs, optimum):
    costs = feasible_costs(runs)
    reached = [run for run in runs if run["evaluations_to_target"] > 0]
    nan = math.nan
    return {
        "runs": len(runs),
        "shortest": min(costs) if costs else nan,
        "mean": numpy.mean(costs) if costs else nan,
        "median": numpy.median(costs) if costs else nan,
        "worst": max(costs) if costs else nan,
        "sd": numpy.std(costs, ddof=1) if len(costs) > 1 else nan,
        "feasible_share": len(costs) / len(runs),
        "evaluations": numpy.median([run["evaluations"] for run in runs]),
        "optimum": optimum,
        "share_to_1_percent": len(reached) / len(runs),
        "evaluations_to_1_percent": numpy.median([run["evaluations_to_target"] for run in reached]) if reached else nan,
        "seconds_to_1_percent": numpy.median([run["seconds_to_target"] for run in reached]) if reached else nan,
    }


def write_csv(path, header, rows):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        for row in rows:
            writer.writerow([f"{x:.6g}" if isinstance(x, float) else x for x in row])


def markdown(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "|".join(["---"] * len(header)) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def number(value, digits=2):
    return "-" if value is None or math.isnan(value) else f"{value:.{digits}f}"


def p_text(p):
    return "< 0.001" if p < 0.001 else f"{p:.3f}"


class Study:
    def __init__(self, folder):
        self.folder = folder
        self.runs = runs_of(folder)
        self.scenes = scenes_of(folder)
        self.contenders = [a for a in ALGORITHMS if ("paper_1", a) in self.runs]
        self.summaries = {
            (scene, algorithm): summary(runs, self.scenes[scene]["optimum"])
            for (scene, algorithm), runs in self.runs.items()
        }
        self.tests = self.pairwise()
        self.ranks, self.critical_difference, self.friedman_p = self.rank()

    def excess(self, scene, algorithm):
        return self.summaries[scene, algorithm]["mean"] - self.scenes[scene]["optimum"]

    def pairwise(self):
        """(scene, a, b) -> (Holm-corrected p, A); corrected over all pairs of a scene."""
        tests = {}
        for scene in self.scenes:
            pairs = list(combinations(self.contenders, 2))
            results = [compare(self.runs[scene, a], self.runs[scene, b]) for a, b in pairs]
            for (a, b), p, (_, effect) in zip(pairs, holm([p for p, _ in results]), results):
                tests[scene, a, b] = (p, effect)
                tests[scene, b, a] = (p, 1.0 - effect)
        return tests

    def rank(self):
        """Average ranks over all scenes by mean merit; Nemenyi's critical difference at 5 %; Friedman's p."""
        table = numpy.array(
            [
                [numpy.mean([min(merit(run), 1e3) for run in self.runs[scene, a]]) for a in self.contenders]
                for scene in self.scenes
            ]
        )
        k, n = len(self.contenders), len(self.scenes)
        ranks = stats.rankdata(table, axis=1).mean(axis=0)
        q = stats.studentized_range.ppf(0.95, k, 1e6) / math.sqrt(2.0)
        difference = q * math.sqrt(k * (k + 1) / (6.0 * n))
        return dict(zip(self.contenders, ranks)), difference, stats.friedmanchisquare(*table.T).pvalue

    def write(self):
        for name, columns in (("table.csv", COLUMNS), ("to_1_percent.csv", COLUMNS_TO_1_PERCENT)):
            write_csv(
                os.path.join(self.folder, name),
                ["scene", "algorithm"] + columns,
                [[scene, a] + [float(s[column]) for column in columns] for (scene, a), s in self.summaries.items()],
            )
        write_csv(
            os.path.join(self.folder, "tests.csv"),
            ["scene", "a", "b", "p_holm", "effect"],
            [
                [scene, a, b, float(self.tests[scene, a, b][0]), float(self.tests[scene, a, b][1])]
                for scene in self.scenes
                for a, b in combinations(self.contenders, 2)
            ],
        )
        write_csv(
            os.path.join(self.folder, "ranks.csv"),
            ["algorithm", "average_rank", "critical_difference"],
            [[a, float(rank), float(self.critical_difference)] for a, rank in self.ranks.items()],
        )

    def table_paper(self):
        straight = math.hypot(20.0 - 0.3, 20.0 - 2.2)
        rows = []
        for a, (shortest, mean) in PAPER_TABLE.items():
            s = self.summaries["paper_1", a]
            rows.append(
                [ALGORITHMS[a], number(shortest), number(mean), number(s["shortest"]), number(s["mean"])]
                + [number(mean / straight, 3), number(s["mean"] / straight, 3), number(self.excess("paper_1", a))]
            )
        header = ["algorithm", "paper: shortest (m)", "paper: average (m)", "here: shortest (m)", "here: average (m)"]
        return markdown(
            header + ["paper: average / straight line", "here: average / straight line", "here: mean excess (m)"], rows
        )

    def table_scene(self):
        rows = []
        for a in sorted(self.contenders, key=lambda a: self.ranks_on("paper_1", a)):
            s = self.summaries["paper_1", a]
            rows.append(
                [ALGORITHMS[a]]
                + [number(s[key]) for key in ("shortest", "mean", "median", "worst", "sd")]
                + [f"{100 * s['feasible_share']:.0f} %", number(s["evaluations"], 0)]
                + [f"{100 * s['share_to_1_percent']:.0f} %", number(s["evaluations_to_1_percent"], 0)]
                + [number(1000 * s["seconds_to_1_percent"], 0)]
            )
        header = ["algorithm", "shortest", "mean", "median", "worst", "sd", "collision-free", "evaluations"]
        return markdown(header + ["runs to 1 %", "evaluations to 1 %", "ms to 1 %"], rows)

    def ranks_on(self, scene, algorithm):
        return numpy.mean([merit(run) for run in self.runs[scene, algorithm]])

    def table_tests(self):
        rows = []
        mfa = self.excess("paper_1", "mfa")
        for a in self.contenders:
            if a != "mfa":
                p, effect = self.tests["paper_1", "mfa", a]
                other = self.excess("paper_1", a)
                rows.append([ALGORITHMS[a], number(other), number(mfa / other), p_text(p), number(effect)])
        header = ["against", "its mean excess (m)", "MFA's excess / its excess", "p (Holm)", "A: MFA better"]
        return markdown(header, rows)

    def table_starts(self):
        header = ["algorithm"] + [f"start {i}" for i in range(1, 5)]
        rows = [["optimum (m)"] + [number(self.scenes[s]["optimum"]) for s in PAPER_SCENES]]
        rows.append(
            ["best over the slices"]
            + [number(self.scenes[s]["slice_optimum"] - self.scenes[s]["optimum"]) for s in PAPER_SCENES]
        )
        for a in self.contenders:
            rows.append([ALGORITHMS[a]] + [self.excess_text(scene, a) for scene in PAPER_SCENES])
        return markdown(header, rows)

    def excess_text(self, scene, algorithm):
        share = self.summaries[scene, algorithm]["feasible_share"]
        text = number(self.excess(scene, algorithm))
        return text if share == 1.0 else f"{text} ({100 * (1 - share):.0f} % collide)"

    def table_ranks(self):
        seeded = [scene for scene in self.scenes if scene.startswith("seeded")]
        rows = []
        for a in sorted(self.contenders, key=self.ranks.get):
            percent = [100 * self.excess(s, a) / self.scenes[s]["optimum"] for s in seeded]
            share = numpy.mean([self.summaries[s, a]["feasible_share"] for s in seeded])
            wins = sum(
                1 for b in self.contenders for s in self.scenes if b != a and self.tests[s, a, b][0] < 0.05
                and self.tests[s, a, b][1] > 0.5
            )
            losses = sum(
                1 for b in self.contenders for s in self.scenes if b != a and self.tests[s, a, b][0] < 0.05
                and self.tests[s, a, b][1] < 0.5
            )
            rows.append(
                [ALGORITHMS[a], number(self.ranks[a]), number(numpy.nanmean(percent)), f"{100 * share:.1f} %"]
                + [str(wins), str(losses)]
            )
        header = ["algorithm", "average rank", "mean excess, seeded (%)", "collision-free, seeded"]
        table = markdown(header + ["significant wins", "losses"], rows)
        return table + (
            f"\n\nFriedman p {p_text(self.friedman_p)} over {len(self.scenes)} scenes; ranks closer than Nemenyi's critical "
            f"difference of {self.critical_difference:.2f} do not differ at the 5 % level."
        )

    def table_ablation(self):
        rows = [["MFA, whole"] + [self.excess_text(s, "mfa") for s in PAPER_SCENES] + ["", ""]]
        pooled = {a: self.pooled(a) for a in ["mfa"] + list(ABLATIONS)}
        results = {a: stats.wilcoxon(pooled[a], pooled["mfa"]) for a in ABLATIONS}
        corrected = dict(zip(ABLATIONS, holm([results[a].pvalue for a in ABLATIONS])))
        for a, label in ABLATIONS.items():
            change = numpy.mean(pooled[a]) - numpy.mean(pooled["mfa"])
            rows.append(
                [label]
                + [self.excess_text(s, a) for s in PAPER_SCENES]
                + [f"{change:+.2f}", p_text(corrected[a])]
            )
        header = ["variant"] + [f"start {i}" for i in range(1, 5)]
        return markdown(header + ["change of the mean (m)", "p (Wilcoxon, Holm)"], rows)

    def pooled(self, algorithm):
        """Excess length of every run on the paper's scenes; a colliding path counts as 10 m."""
        return numpy.array(
            [
                min(10.0, merit(run) - self.scenes[scene]["optimum"])
                for scene in PAPER_SCENES
                for run in self.runs[scene, algorithm]
            ]
        )

    def table_slices(self):
        rows = read(self.folder, "slices.csv")
        optimum = self.scenes["paper_1"]["optimum"]
        groups = defaultdict(list)
        best = {}
        for row in rows:
            groups[int(row["slices"]), row["algorithm"]].append(
                {"cost": float(row["cost"]), "violation": float(row["violation"])}
            )
            best[int(row["slices"])] = float(row["slice_optimum"])
        algorithms = list(dict.fromkeys(row["algorithm"] for row in rows))
        lines = []
        for slices in best:
            cells = []
            for a in algorithms:
                costs = feasible_costs(groups[slices, a])
                share = len(costs) / len(groups[slices, a])
                mean = number(numpy.mean(costs) - optimum) if costs else "-"
                cells.append(mean if share == 1.0 else f"{mean} ({100 * (1 - share):.0f} % collide)")
            lines.append([str(slices), number(best[slices] - optimum)] + cells)
        return markdown(["slices", "best possible"] + [ALGORITHMS[a] for a in algorithms], lines)

    def function_errors(self):
        errors = defaultdict(list)
        for row in read(self.folder, "functions.csv"):
            key = (row["function"], int(row["dimension"]), row["moved"] == "1", row["algorithm"])
            errors[key].append(float(row["error"]))
        return {key: numpy.median(values) for key, values in errors.items()}

    def table_functions(self):
        errors = self.function_errors()
        algorithms = list(dict.fromkeys(key[3] for key in errors if key[2]))
        rows, table = [], []
        for function, dimension in dict.fromkeys((key[0], key[1]) for key in errors):
            values = [errors[function, dimension, True, a] for a in algorithms]
            table.append([max(v, 1e-8) for v in values])
            best = min(max(v, 1e-8) for v in values)
            cells = [f"**{v:.1e}**" if max(v, 1e-8) == best else f"{v:.1e}" for v in values]
            rows.append([function, str(dimension)] + cells)
        ranks = stats.rankdata(numpy.array(table), axis=1).mean(axis=0)
        rows.append(["average rank", ""] + [number(rank) for rank in ranks])
        return markdown(["function", "d"] + algorithms, rows)

    def table_moved(self):
        errors = self.function_errors()
        rows = []
        for function, dimension in dict.fromkeys((key[0], key[1]) for key in errors):
            cells = [
                f"{errors[function, dimension, moved, a]:.1e}" for a in ("mfa", "fa", "de") for moved in (False, True)
            ]
            rows.append([function, str(dimension)] + cells)
        header = ["function", "d"] + [f"{a}, {place}" for a in ("MFA", "FA", "DE") for place in ("in place", "moved")]
        return markdown(header, rows)

    def table_populations(self):
        shares = defaultdict(dict)
        for row in read(self.folder, "populations.csv"):
            shares[row["algorithm"]][row["run"]] = float(row["share"])
        rows = [
            [a.upper(), f"{100 * numpy.median(list(s.values())):.1f} %", f"{100 * min(s.values()):.1f} %"]
            for a, s in shares.items()
        ]
        return markdown(["algorithm", "share within 0.5 of the maximum, median of 30 runs", "worst run"], rows)


def update_docs(study, path):
    with open(path) as file:
        text = file.read()

    def fill(match):
        return f"<!-- {match[1]} -->\n{getattr(study, match[1])()}\n<!-- end -->"

    text = re.sub(r"<!-- (table_\w+) -->\n.*?<!-- end -->", fill, text, flags=re.DOTALL)
    with open(path, "w") as file:
        file.write(text)


def main():
    study = Study(sys.argv[1])
    study.write()
    if "--docs" in sys.argv:
        update_docs(study, sys.argv[sys.argv.index("--docs") + 1])
    for name in ("paper", "scene", "tests", "starts", "ranks", "ablation", "slices", "functions", "moved", "populations"):
        print(f"\n== {name}\n{getattr(study, 'table_' + name)()}")


if __name__ == "__main__":
    main()
