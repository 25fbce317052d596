#!/usr/bin/python3
"""The statistics of benchmarks/anytime against values worked out by hand."""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

ANYTIME = pathlib.Path(__file__).resolve().parents[2] / "benchmarks" / "anytime"
sys.path.insert(0, str(ANYTIME))

import ablation  # noqa: E402
import cost_over_time  # noqa: E402


def record(planner, seed, improvements, cost, **changes):
    """A run of 1 s; improvements as (cpu seconds, cost), half as slow again on the wall."""
    run = {"world": "w", "planner": planner, "seed": seed, "time_limit": 1.0, "status": "returned", "solved": True,
           "valid": True, "cost": cost, "wall": 1.5, "cpu": 1.0, "checks": 1000, "path_check": 0.001, "path_checks": 50,
           "path": [[0.0], [1.0]], "improvements": [[1.5 * t, t, c, 10] for t, c in improvements]}
    return {**run, **changes}


def row_of(records, references=None):
    runs = [cost_over_time.Run(entry, "cpu") for entry in records]
    return {row.planner: row for row in cost_over_time.make_rows(runs, references or {})}


class Intervals(unittest.TestCase):
    def test_ranks_of_the_binomial_table(self):
        # P(4th <= median <= 12th of 15) = 1 - 2 (1 + 15 + 105 + 455) / 2^15
        low, high, coverage = cost_over_time.order_statistic_interval(list(range(15, 0, -1)))
        self.assertEqual((low, high), (4, 12))
        self.assertAlmostEqual(coverage, 1 - 2 * 576 / 2 ** 15)

    def test_six_values_are_the_fewest(self):
        self.assertAlmostEqual(cost_over_time.order_statistic_interval([1, 2, 3, 4, 5, 6])[2], 1 - 2 / 64)
        low, high, coverage = cost_over_time.order_statistic_interval([3, 1, 2, 5, 4])
        self.assertEqual((low, high), (1, 5))
        self.assertAlmostEqual(coverage, 1 - 2 / 32)

    def test_runs_that_never_arrive_are_infinite(self):
        self.assertEqual(cost_over_time.median([1, math.inf, 2]), 2)
        self.assertEqual(cost_over_time.median([1, 2, math.inf, math.inf]), math.inf)
        self.assertEqual(cost_over_time.order_statistic_interval([1.0] * 9 + [math.inf] * 6)[1], math.inf)


class Runs(unittest.TestCase):
    def test_times_to_each_level(self):
        run = record("a", 1, [(0.1, 2.0), (0.2, 1.04), (0.3, 1.0005)], 1.0)
        row = row_of([run], {"w": {"cost": 1.0, "path": []}})["a"]
        self.assertEqual([row.median[target] for target in cost_over_time.TARGETS], [0.1, 0.2, 0.2, 0.3, 0.3])

    def test_claims_count_as_far_as_the_path_bears_them_out(self):
        row = row_of([record("a", 1, [(0.1, 1.0)], 1.2)], {"w": {"cost": 1.0, "path": []}})["a"]
        self.assertTrue(math.isinf(row.median["10pct"]))
        self.assertEqual(row.median["first"], 0.1)

    def test_crashed_invalid_and_late_runs_found_nothing(self):
        rows = row_of([record("a", 1, [(0.1, 1.0)], 1.0, status="signal SEGV", solved=False),
                       record("b", 1, [(0.1, 0.5)], 0.5, valid=False),
                       record("c", 1, [(1.4, 1.0)], 1.0, cpu=1.4),
                       record("d", 1, [(0.5, 1.5)], 1.5)])
        self.assertEqual([rows[planner].success for planner in "abcd"], [0, 0, 1, 1])
        self.assertTrue(all(math.isinf(rows[planner].median["first"]) for planner in "abc"))
        self.assertEqual((rows["b"].invalid, rows["c"].overrun, len(rows["a"].failed)), (1, 1, 1))
        self.assertEqual(rows["d"].best, 1.0, "the cost of a path that fails its check is not the best")

    def test_the_exact_optimum_is_the_best_cost_though_paths_cut_corners(self):
        run = record("a", 1, [(0.1, 0.999)], 0.999)
        self.assertEqual(row_of([run], {"w": {"cost": 1.0, "path": []}})["a"].best, 1.0)
        self.assertEqual(row_of([run], {"w": {"cost": 1.0, "path": [[0.0]]}})["a"].best, 0.999)

    def test_the_floor_is_the_check_of_paths_near_the_best(self):
        rows = row_of([record("a", 1, [(0.1, 1.0)], 1.0, path_check=0.002),
                       record("b", 1, [(0.1, 3.0)], 3.0, path_check=0.009)])
        self.assertEqual(rows["a"].floor, 0.002)
        self.assertEqual(rows["a"].floors_to_1pct(), 50)


class Peers(unittest.TestCase):
    def setUp(self):
        self.rows = row_of([record("mfa", 1, [(0.01, 1.0)], 1.0), record("mfa:slices=3", 1, [(0.001, 1.0)], 1.0),
                            record("bitstar", 1, [(0.02, 2.0), (0.05, 1.005)], 1.005),
                            record("rrtconnect", 1, [], 1.0, cpu=0.004)])

    def test_own_variants_and_rrt_connect_are_no_peers(self):
        self.assertEqual(self.rows["mfa"].best_peer("1pct").planner, "bitstar")
        self.assertEqual(self.rows["mfa"].best_peer("first").planner, "rrtconnect")

    def test_speedups_and_their_bounds(self):
        self.assertEqual(self.rows["mfa"].speedup("1pct"), (5.0, ""))
        self.assertEqual(self.rows["mfa"].speedup("01pct"), (100.0, ">"))
        self.assertEqual(self.rows["mfa"].first_ratio(), 2.5)

    def test_nobody_arrives(self):
        rows = row_of([record("mfa", 1, [(0.1, 2.0)], 2.0), record("bitstar", 1, [(0.1, 2.0)], 2.0)],
                      {"w": {"cost": 1.0, "path": []}})
        self.assertIsNone(rows["mfa"].speedup("1pct"))
        self.assertAlmostEqual(cost_over_time.geometric_mean([2.0, 8.0]), 4.0)


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def test_references_keep_exact_costs_and_better_paths(self):
        path = self.path / "references.jsonl"
        path.write_text('{"world": "w", "cost": 0.9, "source": "exact", "path": []}\n')
        better = [cost_over_time.Run(record("a", 1, [], 0.8), "cpu"),
                  cost_over_time.Run(record("a", 1, [], 5.0, world="v"), "cpu")]
        cost_over_time.update_references(better, "today", path)
        cost_over_time.update_references([cost_over_time.Run(record("a", 2, [], 6.0, world="v"), "cpu")], "", path)
        references = cost_over_time.read_references(path)
        self.assertEqual({world: entry["cost"] for world, entry in references.items()}, {"w": 0.9, "v": 5.0})
        self.assertEqual(references["v"]["path"], [[0.0], [1.0]])

    def test_one_csv_row_a_world_and_planner(self):
        runs = self.path / "runs.jsonl"
        header = {"campaign": "ompl_mfa_anytime", "shard": "", "start": "2026-01-02 03:04:05", "description": None}
        runs.write_text(json.dumps(header) + "\n" + "".join(json.dumps(record(planner, seed, [(0.1 * seed, 1.0)], 1.0)) + "\n"
                                for planner in ("mfa", "bitstar") for seed in (1, 2, 3)))
        table, text = self.path / "anytime.csv", self.path / "anytime.md"
        subprocess.run(["/usr/bin/python3", ANYTIME / "report.py", runs, "--csv", table, "--markdown", text],
                       check=True, stdout=subprocess.DEVNULL)
        with open(table, encoding="utf-8", newline="") as lines:
            rows = list(csv.DictReader(lines))
        self.assertEqual([(row["world"], row["planner"], row["runs"]) for row in rows],
                         [("w", "mfa", "3"), ("w", "bitstar", "3")])
        self.assertEqual(float(rows[0]["t_1pct_s"]), 0.2)
        self.assertEqual(rows[0]["t_1pct_best_peer"], "bitstar")
        self.assertEqual(float(rows[0]["t_1pct_over_floor"]), 200)
        self.assertIn("| mfa | 3/3 |", text.read_text())


class Ablation(unittest.TestCase):
    def test_marks_what_ends_worse_or_better(self):
        whole = [1.0, 1.01, 1.02, 1.03, 1.04]
        self.assertEqual(ablation.mark([1.1, 1.11, 1.12, 1.13, 1.14], whole), "-")
        self.assertEqual(ablation.mark([0.9, 0.91, 0.92, 0.93, 0.94], whole), "+")
        self.assertEqual(ablation.mark([0.99, 1.005, 1.015, 1.025, 1.05], whole), "")
        self.assertEqual(ablation.mark([math.inf] * 5, whole), "-")

    def test_the_table_counts_marks(self):
        runs = [record("mfa", seed, [], 1.0 + 0.01 * seed) for seed in range(5)]
        runs += [record("mfa:tightening=0", seed, [], 2.0 + 0.01 * seed) for seed in range(5)]
        header, lines = ablation.table([cost_over_time.Run(entry, "cpu") for entry in runs], {}, "mfa",
                                       ablation.final_cost)
        self.assertEqual(header, ["world", "mfa", "mfa:tightening=0"])
        self.assertEqual(lines, [["w", "2.00", "102.00 -"], ["worlds", "", "1 worse, 0 better"],
                                 ["a run is worse", "", "1.00 (p 1.00)"]])

    def test_times_are_those_to_the_nearest_level_that_the_whole_planner_reaches(self):
        best = {"w": {"cost": 1.0, "path": []}}
        runs = [record("mfa", seed, [(0.1, 1.09), (0.2 + 0.01 * seed, 1.04)], 1.04) for seed in range(5)]
        runs += [record("mfa:guide=none", seed, [(0.1, 1.09)], 1.09) for seed in range(5)]
        _, lines = ablation.table([cost_over_time.Run(entry, "cpu") for entry in runs], best, "mfa",
                                  ablation.time_to_level)
        self.assertEqual(lines[0], ["w", "220", "never -"])

    def test_half_of_the_runs_of_an_equal_variant_are_worse(self):
        self.assertEqual(ablation.worse_share([1, 2, math.inf], [1, 2, math.inf]), 0.5)
        self.assertEqual(ablation.worse_share([3, 4], [1, 4]), 0.625)
        self.assertEqual(ablation.overall([0.5, 0.5]), "0.50 (p 1.00)")
        # 2 of 2^10 sign patterns are as extreme
        self.assertEqual(ablation.overall([0.6 + 0.02 * k for k in range(10)]), "0.69 (p < 0.01)")


if __name__ == "__main__":
    unittest.main()
