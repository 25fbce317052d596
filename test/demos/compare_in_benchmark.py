#!/usr/bin/env python3
"""compare_in_benchmark.py DEMO: the log of the demo is read by ompl_benchmark_statistics without a warning.

Exit status 77 (skipped) if that program is not installed (Debian: ompl-demos).
"""
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile


def main():
    if shutil.which("ompl_benchmark_statistics") is None:
        print("ompl_benchmark_statistics is not installed")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder, "demo.log")
        database = pathlib.Path(folder, "demo.db")
        subprocess.run([sys.argv[1], log], check=True, capture_output=True, timeout=60)
        converted = subprocess.run(["ompl_benchmark_statistics", log, "-d", database], check=True,
                                   capture_output=True, text=True)
        assert "warning" not in (converted.stdout + converted.stderr).lower(), converted.stdout + converted.stderr
        with sqlite3.connect(database) as connection:
            runs = dict(connection.execute(
                "SELECT plannerConfigs.name, COUNT(*) FROM runs JOIN plannerConfigs"
                " ON runs.plannerid = plannerConfigs.id WHERE runs.solved = 1 GROUP BY plannerConfigs.name"))
            samples, = connection.execute(
                "SELECT COUNT(*) FROM progress JOIN runs ON progress.runid = runs.id JOIN plannerConfigs"
                " ON runs.plannerid = plannerConfigs.id WHERE plannerConfigs.name LIKE '%MFA%'"
                " AND progress.best_cost IS NOT NULL AND progress.share_of_trees IS NOT NULL").fetchone()
    assert {name.split("_")[-1]: count for name, count in runs.items()} == {"MFA": 3, "RRTstar": 3, "PRMstar": 3}, runs
    assert samples > 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
