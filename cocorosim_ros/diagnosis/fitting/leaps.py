"""A way out of local optima of the noise: leaps, one noise or a few at a time.

Where a model is much in error, it doubts one reading or another as the noise has it, and the likelihood has several
summits; scoring climbs the one it stands on. A leap by a factor of e or its square may land on a higher one (coordinate
search: Nocedal and Wright, Numerical Optimization, 2006, section 9.3).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import CONVERGENCE
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.solving import clipped
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE, WATER_NOISE
from cocorosim_ros.foundation.arrays import Flags

LEAPS = (-2.0, -1.0, 1.0, 2.0)  # of a logarithm
MOST_TURNS = 4


def leapt(fit: Fit, rounds: int) -> Fit:
    """The fit settled (at most so many rounds) after every turn of leaps, until none is worth it."""
    for _ in range(MOST_TURNS):
        best = fit
        for moved in _moving_together(fit):
            best = _best_leap(best, moved)
        if best is fit:
            break
        fit = settled(best, rounds)
    return fit


def _moving_together(fit: Fit) -> Iterator[Flags]:
    """Which noise leaps together: all of a column, all random forces, all readings, each alone."""
    columns = np.array([unknown.column for unknown in fit.noise])
    for column in dict.fromkeys(columns):
        yield columns == column
    yield np.isin(columns, WATER_NOISE[:3])
    yield np.isin(columns, READING_NOISE)
    yield from np.eye(len(columns), dtype=bool)


def _best_leap(fit: Fit, moved: Flags) -> Fit:
    """The best of the leaps of these, or the fit itself."""
    best = fit
    for leap in LEAPS:
        trial = evaluated(replace(fit, q_noise=clipped(fit.noise, fit.q_noise + leap * moved)))
        if trial.objective > best.objective + CONVERGENCE.worth:
            best = trial
    return best
