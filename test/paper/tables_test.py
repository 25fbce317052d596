#!/usr/bin/python3
"""The tables of benchmarks/paper against values worked out by hand."""

import csv
import math
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks" / "paper"))

import tables  # noqa: E402

# Costs of the runs; a colliding run is None.
COSTS = {"ga": [13.0, 14.0, 15.0], "fa": [21.0, 22.0, None], "mfa": [10.05, 11.0, 12.0]}


def write(folder, name, header, rows):
    with open(folder / name, "w", newline="") as file:
        csv.writer(file).writerows([header] + rows)


def write_runs(folder):
    scenes = ["paper_1", "seeded_01"]
    write(folder, "scenes.csv", ["scene", "obstacles", "optimum", "slice_optimum"], [[s, 4, 10.0, 10.02] for s in scenes])
    runs, times = [], []
    for scene in scenes:
        for algorithm, costs in COSTS.items():
            for run, cost in enumerate(costs, 1):
                reached = 700 if cost is not None and cost <= 10.1 else 0
                runs.append([scene, algorithm, run, "inf" if cost is None else cost, 0.5 if cost is None else 0, 1000, reached])
                times.append([scene, algorithm, run, 0.5, 0.25 if reached else 0])
    write(folder, "runs.csv",
          ["scene", "algorithm", "run", "cost", "violation", "evaluations", "evaluations_to_target"], runs)
    write(folder, "times.csv", ["scene", "algorithm", "run", "seconds", "seconds_to_target"], times)


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        write_runs(cls.folder)
        cls.study = tables.Study(str(cls.folder))
        cls.study.write()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.reader(file))

    def test_table_has_the_columns_of_the_documentation(self):
        header, *rows = self.rows("table.csv")
        self.assertEqual(header, ["scene", "algorithm", "runs", "shortest", "mean", "median", "worst", "sd",
                                  "feasible_share", "evaluations", "optimum"])
        self.assertEqual(rows[0], ["paper_1", "ga", "3", "13", "14", "14", "15", "1", "1", "1000", "10"])
        self.assertEqual(rows[1], ["paper_1", "fa", "3", "21", "21.5", "21.5", "22", "0.707107", "0.666667", "1000", "10"])
        self.assertEqual(len(rows), 6)

    def test_pairs_are_compared_once_a_scene(self):
        header, *rows = self.rows("tests.csv")
        self.assertEqual(header, ["scene", "a", "b", "p_holm", "effect"])
        self.assertEqual([row[:3] for row in rows[:3]],
                         [["paper_1", "ga", "fa"], ["paper_1", "ga", "mfa"], ["paper_1", "fa", "mfa"]])
        self.assertEqual([row[4] for row in rows[:3]], ["1", "0", "0"], "a colliding path is worse than any other")
        # U = 0 of 9 with 3 and 3 runs: z = (4.5 - 0.5) / sqrt(3 * 3 * 7 / 12), the same for all three pairs.
        p = math.erfc(4.0 / math.sqrt(5.25) / math.sqrt(2.0))
        self.assertAlmostEqual(float(rows[0][3]), 3.0 * p, 5)

    def test_how_soon_runs_come_to_1_percent(self):
        header, *rows = self.rows("to_1_percent.csv")
        self.assertEqual(header, ["scene", "algorithm", "share_to_1_percent", "evaluations_to_1_percent",
                                  "seconds_to_1_percent"])
        self.assertEqual(rows[2], ["paper_1", "mfa", "0.333333", "700", "0.25"])
        self.assertEqual(rows[0], ["paper_1", "ga", "0", "nan", "nan"])

    def test_ranks(self):
        self.assertEqual(self.study.ranks, {"mfa": 1.0, "ga": 2.0, "fa": 3.0})

    def test_holm(self):
        # 0.01 * 3, then 0.02 * 2, then 0.03 * 1 raised to the one before it
        self.assertEqual([round(p, 12) for p in tables.holm([0.03, 0.01, 0.02])], [0.04, 0.03, 0.04])
        self.assertEqual(list(tables.holm([0.9, 0.8])), [1.0, 1.0])


if __name__ == "__main__":
    unittest.main()
