"""Leaps out of local optima of the noise, one noise or a few at a time.

Where a model is much in error, either of two sensors that disagree may be taken for the noisy one, and the likelihood
has several summits; scoring climbs the nearest. A leap of a noise by a factor of e or e^2 may land on the slope of a
higher one (coordinate search: Nocedal and Wright, Numerical Optimization, 2006, section 9.3).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import CONVERGENCE, RECALIBRATION, STEPS
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.solving import clipped
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE, WATER_NOISE
from cocorosim_ros.foundation.arrays import Flags


def leapt(fit: Fit, rounds: int) -> Fit:
    """Leap and settle (at most `rounds` each time) until no leap gains enough, `most_leaps` times at most."""
    for _ in range(RECALIBRATION.most_leaps):
        best = fit
        for moved in _moving_together(fit):
            best = _best_leap(best, moved)
        if best is fit:
            break
        fit = settled(best, rounds)
    return fit


def _moving_together(fit: Fit) -> Iterator[Flags]:
    """Choices (noise,) of noise to leap together: all of a column, all random forces, all readings, each alone."""
    columns = np.array([unknown.column for unknown in fit.noise])
    for column in dict.fromkeys(columns):
        yield columns == column
    yield np.isin(columns, WATER_NOISE[:3])
    yield np.isin(columns, READING_NOISE)
    yield from np.eye(len(columns), dtype=bool)


def _best_leap(fit: Fit, moved: Flags) -> Fit:
    """Try all leaps of the chosen noise; return the best fit, or `fit` itself if no leap gains enough."""
    best = fit
    for leap in STEPS.leaps:
        trial = evaluated(replace(fit, q_noise=clipped(fit.noise, fit.q_noise + leap * moved)))
        if trial.objective > best.objective + CONVERGENCE.worth:
            best = trial
    return best
