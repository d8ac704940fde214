"""Search for dead time, lag and rate limit with which reports follow their commands best."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np
from scipy.optimize import minimize

from cocorosim_ros.diagnosis.criteria.following import FOLLOWING
from cocorosim_ros.diagnosis.evidence.following.misfit import Following
from cocorosim_ros.foundation.arrays import Floats

DEAD_TIME, TIME_CONSTANT, RATE, GAIN = range(4)
"""Columns of a lateness: delay [s], time constant [s], largest rate [of the command, 1/s]; behind them the gain."""


def best_lateness(following: Following) -> Floats:
    """(3,) the lateness without a limit of the rate that has the least misfit."""
    starts = [
        np.array([delay, time_constant, np.inf])
        for delay, time_constant in itertools.product(FOLLOWING.delays, FOLLOWING.time_constants)
    ]
    begin = min(starts, key=lambda lateness: following.line(lateness).misfit)
    return _polished(following, begin, (DEAD_TIME, TIME_CONSTANT))


def best_limited(following: Following, free: Floats) -> Floats:
    """(3,) the lateness with a limit of the rate that has the least misfit; free (3,): the one without."""
    swiftest = _swiftest(following)
    starts = [
        np.array([delay, time_constant, share * swiftest])
        for share in FOLLOWING.slews
        for delay in (free[DEAD_TIME], 0.5 * free[DEAD_TIME])
        for time_constant in (free[TIME_CONSTANT], math.sqrt(free[TIME_CONSTANT] * FOLLOWING.time_constants[0]))
    ]
    begin = min(starts, key=lambda lateness: following.line(lateness).misfit)
    return _polished(following, begin, (DEAD_TIME, TIME_CONSTANT, RATE))


def _swiftest(following: Following) -> float:
    """Rate of the swiftest reports, in the unit of the command [1/s]."""
    rates = [
        np.abs(np.diff(each.reported[each.settled])) / np.diff(each.time[each.settled]) for each in following.stretches
    ]
    return max(float(np.quantile(np.concatenate(rates), FOLLOWING.swift)), np.finfo(float).tiny)


def _polished(following: Following, begin: Floats, free: Sequence[int]) -> Floats:
    """The lateness with the least misfit near `begin`, by a simplex over the columns that are free."""

    def lateness(point: Floats) -> Floats:
        found = begin.copy()
        for column, value in zip(free, point.tolist(), strict=True):
            found[column] = value if column == DEAD_TIME else np.exp(value)
        return found

    spacing = float(np.median(np.diff(FOLLOWING.delays)))
    start = np.array([begin[column] if column == DEAD_TIME else np.log(begin[column]) for column in free])
    steps = np.diag(
        [FOLLOWING.first_step * spacing if column == DEAD_TIME else FOLLOWING.first_step for column in free]
    )
    ends = np.log([FOLLOWING.time_constants[0], FOLLOWING.time_constants[-1]])
    bounds = {DEAD_TIME: (0.0, FOLLOWING.delays[-1]), TIME_CONSTANT: (ends[0], ends[1]), RATE: (None, None)}
    found = minimize(
        lambda point: following.line(lateness(point)).misfit,
        start,
        method="Nelder-Mead",
        bounds=[bounds[column] for column in free],
        options={"initial_simplex": np.vstack([start, start + steps]), "xatol": 1e-4, "fatol": np.inf, "maxiter": 400},
    )
    return lateness(np.asarray(found.x))
