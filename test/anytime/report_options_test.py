#!/usr/bin/python3
"""The options that ompl_mfa_anytime passes on to report.py: report_options_test.py PROGRAM"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from cost_over_time_test import record, results

PROGRAM = sys.argv.pop(1)


class ReportOptions(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        self.runs = self.path / "runs.jsonl"
        self.runs.write_text("".join(
            json.dumps(record(planner, seed, [(0.1, 1.2), (0.2, 1.0)], 1.0, world=world)) + "\n"
            for world in ("drawn", "other") for planner in ("mfa", "bitstar") for seed in (1, 2, 3)))

    def tearDown(self):
        self.folder.cleanup()

    def report(self, *options):
        return subprocess.run([PROGRAM, "report", "--runs", self.runs, *options], check=False, capture_output=True,
                              text=True)

    def test_results_and_curves(self):
        folder = self.path / "results"
        finished = self.report("--results", folder, "--curves", "^drawn$")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertEqual({path.name for path in folder.iterdir()},
                         {"planners.csv", "worlds.csv", "summary.csv", "curves.csv"})
        self.assertEqual([row["world"] for row in results.read_records(folder / "worlds.csv")], ["drawn", "other"])
        self.assertEqual({row["world"] for row in results.read_records(folder / "curves.csv")}, {"drawn"})

    def test_curves_of_the_default_worlds(self):
        folder = self.path / "results"
        finished = self.report("--results", folder)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertEqual({path.name for path in folder.iterdir()}, {"planners.csv", "worlds.csv", "summary.csv"})

    def test_one_world_on_the_wall_clock(self):
        table, text = self.path / "table.csv", self.path / "table.md"
        finished = self.report("--worlds", "other", "--clock", "wall", "--csv", table, "--markdown", text)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        rows = results.read_records(table)
        self.assertEqual([(row["world"], row["first_ms"]) for row in rows], [("other", "150"), ("other", "150")])
        self.assertIn("wall times", text.read_text())

    def test_curves_need_results(self):
        finished = self.report("--curves", "drawn")
        self.assertNotEqual(finished.returncode, 0)
        self.assertIn("--results", finished.stderr)


if __name__ == "__main__":
    unittest.main()
