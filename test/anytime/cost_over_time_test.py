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
import plots  # noqa: E402
import results  # noqa: E402


def record(planner, seed, improvements, cost, **changes):
    """A run of 1 s; improvements as (cpu seconds, cost); wall time is 1.5 times as long."""
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

    def test_paths_that_fail_at_a_finer_resolution_count_as_not_found(self):
        rows = row_of([record("a", 1, [(0.1, 0.5)], 0.5, strict=False), record("b", 1, [(0.1, 1.0)], 1.0, strict=True),
                       record("c", 1, [(0.1, 2.0)], 2.0)])
        self.assertEqual([rows[planner].success for planner in "abc"], [0, 1, 1])
        self.assertEqual((rows["a"].lax, rows["a"].invalid, rows["b"].lax), (1, 0, 0))
        self.assertEqual(rows["b"].best, 1.0)
        self.assertEqual(results.remarks(rows["a"]), "1 invalid at 8 times the resolution")

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
        self.assertEqual((rows[0]["1pct_ms"], rows[0]["1pct_low_ms"], rows[0]["1pct_high_ms"]), ("200", "100", "300"))
        self.assertEqual(rows[0]["1pct_over_floor"], "200")
        self.assertIn("| mfa | 3/3 |", text.read_text())

    def test_best_costs_of_further_worlds(self):
        runs, optima, table = self.path / "runs.jsonl", self.path / "optima.jsonl", self.path / "anytime.csv"
        runs.write_text(json.dumps(record("mfa", 1, [(0.1, 1.0)], 1.0)) + "\n")
        optima.write_text(json.dumps({"world": "w", "cost": 0.8, "source": "exact", "path": []}) + "\n")
        for references, excess in ([], 0.0), (["--references", optima], 25.0):
            subprocess.run(["/usr/bin/python3", ANYTIME / "report.py", runs, *references, "--csv", table],
                           check=True, stdout=subprocess.DEVNULL)
            self.assertAlmostEqual(float(results.read_records(table)[0]["final_pct"]), excess)


BEST = {"w": {"cost": 1.0, "path": []}}


class Results(unittest.TestCase):
    """The tables of a campaign as CSV files, and what is drawn of them."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "results"

    def tearDown(self):
        self.folder.cleanup()

    def write(self, records, curves="."):
        rows = row_of(records, BEST)
        results.write_results(list(rows.values()), [rows["mfa"]], self.path, "cpu", curves)
        return rows

    def read(self, name):
        return results.read_records(self.path / f"{name}.csv")

    def campaign(self):
        """MFA is at 2% after 0.01 s and at 0.5% after 0.1 s; BIT* never comes below 10%, and one run of it crashes."""
        runs = [record("mfa", seed, [(0.01, 1.02), (0.1, 1.005)], 1.005) for seed in (1, 2, 3)]
        runs += [record("bitstar", seed, [(0.02, 1.5)], 1.2, cpu=0.9) for seed in (1, 2)]
        runs.append(record("bitstar", 3, [], 1.0, status="signal SEGV", solved=False))
        return [*runs, *(record("rrtconnect", seed, [], 3.0, cpu=0.004) for seed in (1, 2, 3))]

    def test_a_row_a_planner(self):
        self.write(self.campaign())
        mfa, bitstar, _ = self.read("planners")
        self.assertEqual((mfa["world"], mfa["planner"], mfa["runs"], mfa["successes"]), ("w", "mfa", "3", "3"))
        self.assertEqual((mfa["5pct_ms"], mfa["1pct_ms"], mfa["01pct_ms"]), ("10", "100", "inf"))
        self.assertEqual((mfa["1pct_speedup"], mfa["1pct_speedup_bound"]), ("10", ">"))
        self.assertEqual((mfa["01pct_speedup"], mfa["01pct_speedup_bound"]), ("", ""), "neither arrives")
        self.assertEqual((mfa["final_pct"], mfa["kchecks"], mfa["interval_coverage_pct"]), ("0.5", "1", "75"))
        self.assertEqual((bitstar["successes"], bitstar["remarks"]), ("2", "1 signal SEGV"))
        self.assertEqual((bitstar["first_ms"], bitstar["first_low_ms"], bitstar["first_high_ms"]), ("20", "20", "inf"))
        self.assertEqual((bitstar["final_pct"], bitstar["final_high_pct"]), ("20", "inf"))

    def test_a_row_a_world(self):
        self.write(self.campaign())
        self.assertEqual(self.read("worlds"), [{"world": "w", "best_cost": "1", "floor_ms": "1", "time_limit_s": "1",
                                                "clock": "cpu"}])
        self.write([record("mfa", 1, [(0.1, 2.0)], 2.0), record("bitstar", 1, [], 3.0)])
        self.assertEqual(self.read("worlds")[0]["floor_ms"], "", "nobody came near the best path")
        self.assertEqual(self.read("planners")[0]["1pct_over_floor"], "")

    def test_the_summary_names_the_best_peer_where_it_arrives(self):
        self.write(self.campaign())
        summary = self.read("summary")
        self.assertEqual(len(summary), 1)
        self.assertEqual((summary[0]["1pct_peer"], summary[0]["1pct_peer_ms"]), ("", "inf"))
        self.assertEqual((summary[0]["peer_final_pct"], summary[0]["first_ratio"]), ("20", "2.5"))
        self.assertEqual((summary[0]["success_pct"], summary[0]["peer_success_pct"]), ("100", "100"))
        self.write([record("mfa", 1, [(0.1, 1.0)], 1.0), record("bitstar", 1, [(0.4, 1.0)], 1.0)])
        self.assertEqual((self.read("summary")[0]["1pct_peer"], self.read("summary")[0]["1pct_peer_ms"]),
                         ("bitstar", "400"))

    def test_curves_have_the_cost_of_the_best_path_so_far(self):
        self.write(self.campaign())
        curve = {float(point["time_ms"]): point for point in self.read("curves") if point["planner"] == "mfa"}
        self.assertGreaterEqual(min(curve), 10, "before its first path a planner has no cost")
        self.assertEqual(max(curve), 1000)
        self.assertEqual({point["median_pct"] for time, point in curve.items() if time < 100}, {"2"})
        self.assertEqual({point["median_pct"] for time, point in curve.items() if time > 100}, {"0.5"})
        late = [point for point in self.read("curves") if point["planner"] == "bitstar"][-1]
        self.assertEqual((late["median_pct"], late["low_pct"], late["high_pct"]), ("20", "20", "inf"))

    def test_curves_of_the_chosen_worlds_only_and_none_of_an_earlier_campaign(self):
        self.write(self.campaign())
        self.assertTrue((self.path / "curves.csv").exists())
        self.write(self.campaign(), curves="another_world")
        self.assertFalse((self.path / "curves.csv").exists())

    def test_ours_and_the_peers_that_are_best_at_something_are_drawn(self):
        slow = [record("rrtstar", seed, [(0.5, 1.9)], 1.9) for seed in (1, 2, 3)]
        self.write([*self.campaign(), *slow])
        self.assertEqual([row["planner"] for row in plots.shown(self.read("planners"))],
                         ["mfa", "bitstar", "rrtconnect"])

    def test_steps_go_through_the_times_to_each_level(self):
        self.write(self.campaign())
        mfa, bitstar, _ = self.read("planners")
        self.assertEqual(plots.steps(mfa, 1000), [(10, plots.MOST), (10, 10), (10, 5), (100, 1), (1000, 0.5)])
        self.assertEqual(plots.steps(bitstar, 1000), [(20, plots.MOST), (1000, 20)])

    def test_plots_with_and_without_curves(self):
        self.write(self.campaign())
        lines = [len(plots.draw(self.path, ["w"]).axes[0].collections)]
        (self.path / "curves.csv").unlink()
        lines.append(len(plots.draw(self.path, ["w"]).axes[0].collections))
        self.assertEqual(lines, [2, 0], "bands of MFA and BIT* where there are curves")
        self.assertIsNone(plots.draw(self.path, ["another_world"]))

    def test_commands(self):
        runs = self.path.with_name("runs.jsonl")
        runs.write_text("".join(json.dumps(entry) + "\n" for entry in self.campaign()))
        subprocess.run(["/usr/bin/python3", ANYTIME / "report.py", runs, "--results", self.path, "--curves", "w"],
                       check=True, stdout=subprocess.DEVNULL)
        picture = self.path / "picture.svg"
        subprocess.run(["/usr/bin/python3", ANYTIME / "plots.py", self.path, picture, "--worlds", "w"], check=True)
        self.assertIn("<svg", picture.read_text())
        self.assertEqual({path.name for path in self.path.iterdir()},
                         {"planners.csv", "worlds.csv", "summary.csv", "curves.csv", "picture.svg"})

    def test_the_published_tables_belong_together(self):
        published = {path.stem: results.read_records(path) for path in (ANYTIME / "results").glob("*.csv")}
        worlds = [row["world"] for row in published["worlds"]]
        self.assertEqual(len(set(worlds)), len(worlds))
        self.assertEqual(list(dict.fromkeys(row["world"] for row in published["planners"])), worlds)
        self.assertEqual([row["world"] for row in published["summary"]], worlds)
        self.assertLessEqual(set(results.TELLING), set(worlds))
        self.assertEqual(list(published["planners"][0]),
                         list(results.planner_record(row_of(self.campaign(), BEST)["mfa"])))
        ours = {row["world"]: row for row in published["planners"] if row["planner"] == "mfa"}
        for row in published["summary"]:
            self.assertEqual((row["1pct_ms"], row["01pct_ms"], row["final_pct"]),
                             tuple(ours[row["world"]][key] for key in ("1pct_ms", "01pct_ms", "final_pct")))


def compared(records, references, quantity):
    return ablation.Comparison([cost_over_time.Run(entry, "cpu") for entry in records], references, "mfa", quantity)


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
        header, lines = ablation.table(compared(runs, {}, ablation.final_cost))
        self.assertEqual(header, ["world", "mfa", "mfa:tightening=0"])
        self.assertEqual(lines, [["w", "2.00", "102.00 -"], ["worlds", "", "1 worse, 0 better"],
                                 ["a run is worse", "", "1.00 (p 1.00)"]])

    def test_times_are_those_to_the_nearest_level_that_the_whole_planner_reaches(self):
        best = {"w": {"cost": 1.0, "path": []}}
        runs = [record("mfa", seed, [(0.1, 1.09), (0.2 + 0.01 * seed, 1.04)], 1.04) for seed in range(5)]
        runs += [record("mfa:guide=none", seed, [(0.1, 1.09)], 1.09) for seed in range(5)]
        _, lines = ablation.table(compared(runs, best, ablation.time_to_level))
        self.assertEqual(lines[0], ["w", "220", "never -"])

    def test_both_tables_as_csv_files(self):
        runs = [record("mfa", seed, [(0.1, 1.0 + 0.01 * seed)], 1.0 + 0.01 * seed) for seed in range(5)]
        runs += [record("mfa:guide=none", seed, [], 1.0, status="signal SEGV", solved=False) for seed in range(5)]
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            ablation.write_results(compared(runs, BEST, ablation.final_cost),
                                   compared(runs, BEST, ablation.time_to_level), folder)
            whole, without = results.read_records(folder / "ablation.csv")
            summary, = results.read_records(folder / "ablation_summary.csv")
        self.assertEqual(whole, {"world": "w", "planner": "mfa", "final_pct": "2.00", "final_mark": "",
                                 "time_ms": "100", "time_mark": ""})
        self.assertEqual(without, {"world": "w", "planner": "mfa:guide=none", "final_pct": "inf", "final_mark": "worse",
                                   "time_ms": "inf", "time_mark": "worse"})
        self.assertEqual([summary[f"final_{key}"] for key in ("worse", "better", "worse_share")], ["1", "0", "1"])

    def test_half_of_the_runs_of_an_equal_variant_are_worse(self):
        self.assertEqual(ablation.worse_share([1, 2, math.inf], [1, 2, math.inf]), 0.5)
        self.assertEqual(ablation.worse_share([3, 4], [1, 4]), 0.625)
        self.assertEqual(ablation.overall([0.5, 0.5]), "0.50 (p 1.00)")
        # 2 of 2^10 sign patterns are as extreme
        self.assertEqual(ablation.overall([0.6 + 0.02 * k for k in range(10)]), "0.69 (p < 0.01)")


if __name__ == "__main__":
    unittest.main()
