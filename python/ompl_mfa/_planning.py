"""Planning: configs, and validity checkers in Python."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np

from . import _core

_POSE = ("x", "y", "z", "theta")


@dataclass
class PlanResult:
    """What a planner found.

    status: OMPL's words for how the run ended, such as 'Exact solution' or 'Timeout'.
    exact: whether the path leads to the goal; otherwise it is the best approximate one, or empty.
    cost: of the path, by the objective; infinite without a path.
    time: seconds that solving took.
    costs: shape (k, 2): seconds since the start, and the cost of the best exact path from then on. Planners that do not
        publish improvements have only their final path.
    path: shape (n, d): a state a row. SE(2): x, y, yaw. SE(3): x, y, z and a unit quaternion x, y, z, w.
    """
    status: str
    exact: bool
    cost: float
    time: float
    costs: np.ndarray
    path: np.ndarray

    @property
    def first_solution_time(self) -> Optional[float]:
        """Seconds to the first exact path; None without one."""
        return float(self.costs[0, 0]) if len(self.costs) else None


def _result(result: Any) -> PlanResult:
    return PlanResult(result.status, result.exact, result.cost, result.time, result.costs, result.path)


def _parameters(params: Optional[Mapping[str, Any]]) -> list[tuple[str, str]]:
    def text(value: Any) -> str:
        return str(int(value)) if isinstance(value, bool) else str(value)
    return [(name, text(value)) for name, value in (params or {}).items()]


def _config_text(keys: Mapping[str, Any]) -> str:
    """The section [problem] of a config for keyword arguments."""
    lines = ["[problem]"]
    for name, value in keys.items():
        key = name.replace("__", ".")
        if value is None:
            continue
        if name in ("start", "goal"):
            values = [float(each) for each in value] if not isinstance(value, Mapping) else None
            if values is None:
                pairs = [(str(part).replace("__", "."), each) for part, each in value.items()]
            elif len(values) == 2:
                pairs = list(zip(("x", "y"), values))
            elif len(values) == 3:
                pairs = list(zip(("x", "y", "theta"), values))
            elif len(values) == 7:
                pairs = list(zip(("x", "y", "z", "axis.x", "axis.y", "axis.z", "theta"), values))
            else:
                raise _core.InputError(f"{name} has {len(values)} values; accepted are 2 (x, y), 3 (x, y, yaw), 7 (x, y, z, "
                                       "axis x, y, z, angle) or a mapping of coordinates")
            lines += [f"{name}.{part} = {each!r}" for part, each in pairs]
        elif name == "bounds":
            for axis, (low, high) in zip("xyz", value):
                lines += [f"volume.min.{axis} = {float(low)!r}", f"volume.max.{axis} = {float(high)!r}"]
        else:
            lines.append(f"{key} = {os.fspath(value) if isinstance(value, os.PathLike) else value}")
    return "\n".join(lines + ["[benchmark]", "[planner]", "mfa =", ""])


def plan(config: Union[str, os.PathLike, None] = None, *, planner: str = "mfa", time: float = 1.0, seed: int = 1,
         iterations: int = 0, params: Optional[Mapping[str, Any]] = None, **problem: Any) -> PlanResult:
    """Solve a problem once.

    The problem is that of a benchmark config (.cfg), or is given by keywords: start and goal (2, 3 or 7 numbers: x, y;
    x, y, yaw; x, y, z, axis, angle), world and robot (files as in a config, or robot='point'), bounds (pairs of low and
    high for x, y and z), and any other key of the section [problem] with '__' for a dot, such as robot__radius=0.3 or
    objective='length'.

    planner: one of planner_names(); params: its parameters.
    time: seconds. iterations: how often the planner may ask whether to stop; 0: no limit. With the same seed and an
    iteration limit 'mfa' returns the same path again; planners of OMPL do so only in the first call of a process.

    Raises InputError (a ValueError) for anything that is not accepted, KeyboardInterrupt at Ctrl-C.
    """
    if (config is None) == (not problem):
        raise TypeError("plan() needs either a config or the keywords of a problem")
    text = _config_text(problem) if config is None else ""
    file = os.path.join(os.getcwd(), "arguments of plan()") if config is None else os.fspath(config)
    return _result(_core.plan_config(text, file, planner, _parameters(params), _core.Limits(time, iterations), seed))


def solve(is_valid: Callable[[np.ndarray], Any], bounds: Sequence[Sequence[float]], start: Sequence[float],
          goal: Sequence[float], time: float = 1.0, *, space: str = "real", vectorized: bool = False,
          resolution: float = 0.01, turning_radius: float = 1.0, planner: str = "mfa", seed: int = 1,
          iterations: int = 0, params: Optional[Mapping[str, Any]] = None) -> PlanResult:
    """Find a short path among states for which a Python function is true.

    is_valid: takes a state of shape (d,) and returns whether it is valid; if vectorized, takes states of shape (k, d)
        and returns k truth values, which is much faster: a whole motion is checked by one call.
    bounds: pairs (low, high), for 'real' of every coordinate, otherwise of x and y (and z).
    start, goal: states of the space.
    space: 'real'; 'se2', 'dubins', 'reedsshepp' (x, y, yaw); 'se3' (x, y, z and a unit quaternion x, y, z, w).
    resolution: a motion is checked at steps of this fraction of the space's extent.
    turning_radius: of 'dubins' and 'reedsshepp'.
    planner, time, seed, iterations, params: as for plan(). The objective is the path's length.

    An exception of is_valid ends the search and is raised. Other threads run between its calls.
    """
    limits = _core.Limits(time, iterations)
    return _result(_core.solve(is_valid, space.lower(), np.atleast_2d(np.asarray(bounds, dtype=float)),
                               [float(value) for value in start], [float(value) for value in goal], vectorized,
                               resolution, turning_radius, planner, _parameters(params), limits, seed))
