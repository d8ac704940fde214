"""Information on errors of readings that a shifted start would not give as well.

A filter starts where the first readings are, so an error that shifts all readings of a place or a heading shifts the
start with them: a pressure that reads too high makes a vehicle that began deeper. The filter knows it where the error
is of the first readings themselves (`tracks.start`); other readings of the same state may be in error as well. So
directions of the innovations that a shift of a track's start makes are taken out before it is told what these
recordings would show.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.screening import Screen, Screened
from cocorosim_ros.diagnosis.naming.detectability import OF_EVERY_STREAM
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import YAW, X, Y, Z


def beyond_starts(screen: Screen, screened: Screened) -> Screened:
    """Copy a screened error of readings, its information without what a shift of each track's start gives as well.

    What is no error of readings is returned as it is, and errors of stamps too, which shift no start.
    """
    candidate = screened.candidate
    if candidate.entry.topic is None or candidate.entry.id in OF_EVERY_STREAM or not screened.information.any():
        return screened
    moved = screen.slopes(candidate, screened.values, candidate.amplitudes())
    left = screened.information.copy()
    for number in candidate.everybody:
        left -= as_well(start_slopes(screen.fit, number), moved[number], screen.fit.passes[number].variance)
    size, direction = np.linalg.eigh(0.5 * (left + left.T))
    return replace(screened, information=(direction * np.maximum(size, 0.0)) @ direction.T)


def as_well(others: Floats, moved: Floats, variance: Floats) -> Floats:
    """Information (n, n) of slopes `moved` (m, n) that slopes `others` (m, k) give as well; variance (m,)."""
    cross = weighted_products(others, moved, variance)
    found: Floats = cross.T @ np.linalg.pinv(weighted_products(others, others, variance), hermitian=True) @ cross
    return found


def start_slopes(fit: Fit, number: int) -> Floats:
    """Slopes (m, 4) of a track's innovations by where it starts, x, y, z and yaw [m, rad], gains held."""
    track, passed, row = fit.tracks[number], fit.passes[number], fit.filled[number]
    filtering, start = track.filter, track.filter.start(row)
    states = (X, Y, Z, YAW)
    found = np.zeros((len(states), len(passed.innovation)))
    for state, slope in zip(states, found, strict=True):
        step = STEPS.start * float(start.spread[state])
        if step > 0.0:
            mean = start.mean.copy()
            mean[state] += step
            elsewhere = filtering.beginning.at(start._replace(mean=mean))
            shifted = filtering.over(filtering.timeline, filtering.actuation, elsewhere)
            shifted.slope(row, passed, step, slope)
    return found.T
