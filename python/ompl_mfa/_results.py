"""Campaigns and their results."""
from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np

from . import _core


def _column(values: list[Any]) -> np.ndarray:
    """Numbers as floats or integers, missing ones as NaN; anything else as objects."""
    known = [value for value in values if value is not None]
    if known and all(isinstance(value, bool) for value in known) and len(known) == len(values):
        return np.array(values, dtype=bool)
    if known and all(isinstance(value, int) for value in known) and len(known) == len(values):
        return np.array(values, dtype=np.int64)
    if all(isinstance(value, (int, float)) for value in known):
        return np.array([np.nan if value is None else value for value in values], dtype=float)
    return np.array(values, dtype=object)


def _columns(rows: list[dict[str, Any]]) -> dict[str, np.ndarray]:
    names = dict.fromkeys(name for row in rows for name in row)
    return {name: _column([row.get(name) for row in rows]) for name in names}


@dataclass
class Results:
    """The runs of a campaign.

    experiment, properties, time_limit, seed, start: of the campaign.
    runs: a column for every property of the runs, such as 'planner', 'run', 'solved', 'time', 'path_cost'.
    progress: columns 'planner', 'run', 'time' and progress properties, such as 'best_cost': a row per sample.
    log: the OMPL log, or the journal that was read.
    """
    experiment: str
    properties: dict[str, Any]
    time_limit: float
    seed: int
    start: str
    runs: dict[str, np.ndarray]
    progress: dict[str, np.ndarray]
    log: str

    def to_pandas(self) -> Any:
        """The runs as a pandas DataFrame. ImportError if pandas is not installed."""
        import pandas  # pylint: disable=import-outside-toplevel
        return pandas.DataFrame(self.runs)


def read_results(file: Union[str, os.PathLike]) -> Results:
    """Read the journal of a campaign, or that beside its log. InputError if it is not a journal."""
    name = os.fspath(file)
    data = _core.read_journal(name)
    return Results(data["experiment"], data["properties"], data["time_limit"], data["seed"], data["start"],
                   _columns(data["runs"]), _columns(data["progress"]), name)


def benchmark(config: Union[str, os.PathLike], output: Union[str, os.PathLike, None] = None, *, jobs: int = 1,
              resume: bool = False, overwrite: bool = False,
              database: Union[str, os.PathLike, None] = None) -> Results:
    """Run the planners of a benchmark config, as `ompl_mfa benchmark` does, and return the results.

    output: the log; by default where the config says. jobs: runs at the same time. resume: make only the missing runs
    of an interrupted campaign; overwrite: discard them. database: an SQLite database to which the runs are added.

    Raises InputError for anything that is not accepted. After Ctrl-C the finished runs are kept, see resume.
    """
    log = _core.log_file(os.fspath(config)) if output is None else os.fspath(output)
    arguments = {"config": os.fspath(config), "log": log, "jobs": jobs, "resume": resume, "overwrite": overwrite,
                 "database": "" if database is None else os.fspath(database)}
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "_campaign.py")
    with subprocess.Popen([sys.executable, script, json.dumps(arguments)], stderr=subprocess.PIPE, text=True) as process:
        try:
            errors: Optional[str] = process.communicate()[1]
        except KeyboardInterrupt:
            process.wait()  # it has received the signal too, and writes the log of the finished runs
            raise
    last = (errors or "").strip().splitlines()
    if process.returncode == 130:
        raise KeyboardInterrupt
    if process.returncode != 0:
        message = last[-1] if last else f"the campaign's process ended with status {process.returncode}"
        raise _core.InputError(message.removeprefix("InputError: ")) if message.startswith("InputError: ") \
            else RuntimeError(message)
    return read_results(log)
