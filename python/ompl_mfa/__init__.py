"""Motion planning with OMPL and the Modified Firefly Algorithm.

plan() solves a problem given by an OMPL benchmark config or by keywords, solve() one whose validity is a Python
function, benchmark() and read_results() run campaigns and read them, minimize() and FireflyOptimizer minimise any
function over a box.
"""
from ._core import FireflyOptimizer, InputError, __version__, ompl_version, planner_names, set_verbose
from ._optimize import minimize
from ._planning import PlanResult, plan, solve
from ._results import Results, benchmark, read_results

__all__ = ["FireflyOptimizer", "InputError", "PlanResult", "Results", "__version__", "benchmark", "minimize",
           "ompl_version", "plan", "planner_names", "read_results", "set_verbose", "solve"]
