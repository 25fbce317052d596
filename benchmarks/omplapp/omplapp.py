#!/usr/bin/env python3
"""Runs OMPL.app's sample problems and prints a table with the reference; --docs writes it into docs/benchmarks.md.

omplapp.py PROBLEMS OUTPUT [--program PROGRAM] [--planners a,b,c] [--time-limit S] [--runs N] [--table-only] [--docs FILE]

PROBLEMS is the folder with OMPL.app's 2D/ and 3D/ (resources/ of its sources, or OMPL.app's installed one); nothing of it is part
of this project. OUTPUT gets a config, a log and a journal for each problem; called again, it goes on where it stopped.
"""
import argparse
import math
import os
import re
import statistics
import subprocess
import sys

PROBLEMS = ["2D/Barriers", "2D/RandomPolygons_planar", "3D/cubicles", "3D/Easy", "3D/Twistycool"]

# Mean length and mean simplified length of exact solutions of OMPL.app's own ompl_benchmark, 5 s, 5 runs.
REFERENCE = {
    "Barriers": {"BITstar": (733, 718), "PRMstar": (814, 780), "RRTstar": (864, 840)},
    "RandomPolygons": {"RRTstar": (106.0, 105.3), "PRMstar": (110.6, 106.9), "BITstar": (114.2, 106.0)},
    "cubicles": {"BITstar": (1976, 1853), "RRTstar": (2009, 1868), "PRMstar": (2177, 1963)},
    "Easy": {"RRTstar": (205.4, 202.5), "BITstar": (217.6, 202.4)},
}
# Seconds to the first solution of RRT-Connect.
FIRST_SOLUTION = {"Barriers": 0.32, "RandomPolygons": 0.007, "cubicles": 0.37, "Easy": 0.06}


def write_config(problem, arguments):
    """OMPL.app's problem section with other planners and limits."""
    source = os.path.join(arguments.problems, problem + ".cfg")
    with open(source) as file:
        section = file.read().split("[benchmark]")[0]
    folder = os.path.dirname(os.path.abspath(source))
    section = re.sub(r"(?m)^(world|robot)\s*=\s*(\S+)", lambda m: f"{m[1]} = {folder}/{m[2]}", section)
    config = os.path.join(arguments.output, os.path.basename(problem) + ".cfg")
    with open(config, "w") as file:
        file.write(section)
        file.write(f"[benchmark]\ntime_limit = {arguments.time_limit:g}\nmem_limit = 4000\nrun_count = {arguments.runs}\n"
                   f"seed = {arguments.seed}\n[planner]\n")
        file.writelines(f"{name} =\n" for name in arguments.planners.split(","))
    return config


def read_log(path):
    """Name of the experiment, and the runs of each planner as dictionaries."""
    with open(path) as file:
        lines = iter(file.read().split("\n"))
    planners = {}
    experiment = None
    for line in lines:
        if line.startswith("Experiment "):
            experiment = line.split()[1]
        if not line.startswith("geometric_"):
            continue
        for _ in range(int(next(lines).split()[0])):
            next(lines)
        names = [next(lines) for _ in range(int(next(lines).split()[0]))]
        count = int(next(lines).split()[0])
        planners[line[len("geometric_"):]] = [dict(zip(names, next(lines).split("; "))) for _ in range(count)]
    return experiment, planners


def numbers(runs, name):
    values = [float(run[name]) for run in runs if run.get(name)]
    return [value for value in values if math.isfinite(value)]


def mean(values):
    if not values:
        return "-"
    spread = f" ± {statistics.stdev(values):.3g}" if len(values) > 1 else ""
    return f"{statistics.mean(values):.4g}{spread}"


def reference(experiment, planner):
    """The reference's mean length and simplified length, or None."""
    name = planner[1:] if planner.startswith("kBIT") else planner
    return REFERENCE.get(experiment, {}).get(name)


def difference(values, expected):
    return f"{100.0 * (statistics.mean(values) / expected - 1.0):+.1f} %" if values and expected else "-"


def row(experiment, planner, runs):
    solved = [run for run in runs if run.get("solved BOOLEAN") == "1"]
    killed = sum(run["termination ENUM"] != "0" for run in runs)
    first = numbers(solved, "time to first solution REAL")
    lengths = numbers(solved, "path cost REAL")
    pair = reference(experiment, planner)
    if planner == "RRTConnect" and experiment in FIRST_SOLUTION:
        expected = f"first after {FIRST_SOLUTION[experiment]} s"
    else:
        expected = f"{pair[0]:.4g}, {pair[1]:.4g}" if pair else "-"
    return [experiment, planner, f"{len(solved)}/{len(runs)}", str(killed), f"{statistics.median(first):.3g}" if first else "-",
            mean(lengths), mean(numbers(solved, "simplified path cost REAL")), expected,
            difference(lengths, pair and pair[0])]


def table(logs):
    header = ["problem", "planner", "solved", "killed", "first solution [s]", "length", "simplified", "reference",
              "length against it"]
    rows = [header, ["---"] * len(header)]
    for log in logs:
        experiment, planners = read_log(log)
        rows += [row(experiment, planner, runs) for planner, runs in planners.items()]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in rows)


def update_docs(path, text):
    with open(path) as file:
        page = file.read()
    page, count = re.subn(r"(?s)(<!-- omplapp -->\n).*?(\n<!-- end -->)", lambda m: m[1] + text + m[2], page)
    if count != 1:
        sys.exit(f"{path}: expected one <!-- omplapp --> ... <!-- end -->, found {count}")
    with open(path, "w") as file:
        file.write(page)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("problems")
    parser.add_argument("output")
    parser.add_argument("--program", default="ompl_mfa")
    parser.add_argument("--planners", default="rrtstar,prmstar,rrtconnect,bitstar,mfa")
    parser.add_argument("--time-limit", type=float, default=5.0)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--table-only", action="store_true")
    parser.add_argument("--docs", metavar="FILE")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    logs = []
    for problem in PROBLEMS:
        log = os.path.join(arguments.output, os.path.basename(problem) + ".log")
        logs.append(log)
        if not arguments.table_only:
            command = [arguments.program, "benchmark", write_config(problem, arguments), "--output", log, "--resume"]
            status = subprocess.run(command, stdout=subprocess.DEVNULL).returncode
            if status != 0:
                sys.exit(status)
    text = table([log for log in logs if os.path.exists(log)])
    print(text)
    if arguments.docs:
        update_docs(arguments.docs, text)


if __name__ == "__main__":
    main()
