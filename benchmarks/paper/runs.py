"""Reads the tables of ompl_mfa_paper_study."""

import csv
import math
import os
from collections import defaultdict

ALGORITHMS = {
    "ga": "GA (pagmo sga)",
    "fa": "FA",
    "mfa": "MFA",
    "fa_yang": "FA, Yang's shrinking alpha",
    "fa_linear": "FA, linear alpha",
    "fa_long": "FA, gamma 0.005",
    "pso": "PSO",
    "de": "DE",
    "sade": "SADE",
    "cmaes": "CMA-ES",
    "abc": "ABC",
    "gwo": "GWO",
    "mfa_default": "planner MFA, all its parts",
}
ABLATIONS = {
    "no_eq8": "without eq. 8",
    "no_eq9": "without eq. 9",
    "no_eq10": "without eq. 10",
    "no_eq11": "without eq. 11",
    "no_eq12": "without eq. 12",
    "no_trials": "without eqs. 6-12",
    "no_eq13": "without eq. 13 (alpha constant)",
    "no_eq14": "without eq. 14 (beta0 constant)",
}


def read(folder, name):
    """The rows of a table, followed by those of the table of the planner's runs, if there is one."""
    rows = []
    for prefix in ("", "planner_"):
        path = os.path.join(folder, prefix + name)
        if os.path.exists(path):
            with open(path, newline="") as file:
                rows += list(csv.DictReader(file))
    return rows


def runs_of(folder):
    """(scene, algorithm) -> list of runs with cost, violation, evaluations, evaluations_to_target, seconds_to_target."""
    seconds = {
        (row["scene"], row["algorithm"], row["run"]): float(row["seconds_to_target"]) for row in read(folder, "times.csv")
    }
    runs = defaultdict(list)
    for row in read(folder, "runs.csv"):
        runs[row["scene"], row["algorithm"]].append(
            {
                "cost": float(row["cost"]),
                "violation": float(row["violation"]),
                "evaluations": int(row["evaluations"]),
                "evaluations_to_target": int(row["evaluations_to_target"]),
                "seconds_to_target": seconds[row["scene"], row["algorithm"], row["run"]],
            }
        )
    return runs


def scenes_of(folder):
    """scene -> its exact optimum, the optimum over the slices, and the number of obstacles."""
    return {
        row["scene"]: {
            "optimum": float(row["optimum"]),
            "slice_optimum": float(row["slice_optimum"]),
            "obstacles": int(row["obstacles"]),
        }
        for row in read(folder, "scenes.csv")
    }


def merit(run):
    """A number to rank runs by: every collision-free path before every colliding one, then by length."""
    if run["violation"] == 0.0 and math.isfinite(run["cost"]):
        return run["cost"]
    return 1e6 + min(run["violation"], 1e6)


def feasible_costs(runs):
    return [run["cost"] for run in runs if merit(run) < 1e6]
