"""Minimisation by fireflies, with SciPy's conventions."""
from __future__ import annotations

from typing import Any, Callable, Optional, Sequence

import numpy as np

from ._core import FireflyOptimizer

try:
    from scipy.optimize import OptimizeResult
except ImportError:
    class OptimizeResult(dict):  # type: ignore[no-redef]
        """The result of minimize(), where SciPy is not installed: a dictionary whose items are attributes too."""

        def __getattr__(self, name: str) -> Any:
            try:
                return self[name]
            except KeyError as error:
                raise AttributeError(name) from error

        __setattr__ = dict.__setitem__  # type: ignore[assignment]
        __delattr__ = dict.__delitem__  # type: ignore[assignment]


def minimize(f: Callable[[np.ndarray], Any], bounds: Sequence[Sequence[float]], algorithm: str = "mfa", *,
             population: int = 100, generations: int = 50, max_generations: Optional[int] = None,
             max_evaluations: Optional[int] = None, seed: int = 1, vectorized: bool = False,
             x0: Optional[np.ndarray] = None, callback: Optional[Callable[[OptimizeResult], Any]] = None,
             **settings: float) -> OptimizeResult:
    """Minimise f over a box by the firefly algorithm ('fa') or the Modified Firefly Algorithm ('mfa').

    f: takes x of shape (d,) and returns a number; if vectorized, takes x of shape (d, k) and returns k numbers.
    bounds: d pairs (low, high).
    population, generations, and the settings gamma, alpha, eta: as for FireflyOptimizer.
    max_generations: by default one epoch, that is, generations. max_evaluations: no limit by default.
    x0: points of shape (d,) or (k, d) that the initial population contains.
    callback: called after every generation with the present result; a true return value ends the run.

    Returns SciPy's OptimizeResult (or a dictionary with the same attributes): x, fun, nit, nfev, success, message,
    population (population, d) and population_values.
    """
    box = np.asarray(bounds, dtype=float)
    if box.ndim != 2 or box.shape[1] != 2:
        raise ValueError(f"bounds have shape {box.shape}; accepted are pairs (low, high), one a coordinate")
    optimizer = FireflyOptimizer(box[:, 0], box[:, 1], algorithm, population, generations, seed=seed, **settings)
    if x0 is not None:
        for x in np.atleast_2d(np.asarray(x0, dtype=float)):
            optimizer.inject(x)
    limit = generations if max_generations is None else max_generations
    evaluations = 2**64 - 1 if max_evaluations is None else max_evaluations
    message = "the last generation is done"

    def result() -> OptimizeResult:
        return OptimizeResult(x=optimizer.best, fun=optimizer.best_value, nit=optimizer.generation,
                              nfev=optimizer.evaluations, success=bool(np.isfinite(optimizer.best_value)),
                              message=message, population=optimizer.population, population_values=optimizer.values)

    for _ in range(limit + 1):
        if not optimizer.step(f, vectorized, evaluations):
            message = "max_evaluations are reached"
            break
        if callback is not None and callback(result()):
            message = "the callback ended the run"
            break
    return result()
