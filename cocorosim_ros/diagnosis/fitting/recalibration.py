"""The platform's own numbers fitted together with the random forces of the water: what all models are compared with."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import RECALIBRATION
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.base_model import base_rows, base_unknowns, noise_unknowns
from cocorosim_ros.diagnosis.fitting.climbing import settled, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, make_fit
from cocorosim_ros.diagnosis.fitting.leaps import leapt
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, READING_COLUMNS, WATER_NOISE
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.foundation.arrays import Floats

MOST_DOUBLINGS = 12
MOST_ROUNDS = 10  # of a fit that a good start ends after two or three
INERTIAL = ("reading.gyro_z", "reading.accel")
# By how much the logarithms move for the further starts.
AT_RANDOM = {
    "random.force": math.log(10.0),
    "random.heave_force": math.log(10.0),
    "random.moment": math.log(10.0),
    "random.correlation": -math.log(10.0),
}


def first_fit(evidence: Evidence) -> Fit:
    """The model as the platform's file and the first guess of the noise have it."""
    tracks = make_tracks(evidence)
    rows = base_rows(tracks)
    return make_fit(tracks, rows, base_unknowns(tracks), noise_unknowns(tracks, rows))


def base_fit(evidence: Evidence) -> Fit:
    """The recalibrated model: the platform's numbers and the noise at their most likely values.

    Where the first guess of the noise shuts out readings, much is wrong, and the way from there may end anywhere: then
    a second way begins where hardly anything but chance moves the robot, and a third where its inertial sensors, which
    the model leans on at every step, are doubted before those that see where it is. From the best of them it leaps on.
    """
    first = first_fit(evidence)
    if not any(_is_shut(first, unknown) for unknown in first.noise):
        return settled(first, MOST_ROUNDS)
    starts = [first, _at_random(first)]
    if any(unknown.column in INERTIAL for unknown in first.noise):
        starts.append(_without_inertial(first))
    ways = [settled(_opened(start), MOST_ROUNDS) for start in starts]
    return leapt(max(ways, key=lambda fit: fit.objective), MOST_ROUNDS)


def _at_random(fit: Fit) -> Fit:
    """The fit with strong and quick random forces, and coarse readings: each is then heeded a little."""
    coarse = [RECALIBRATION.coarse if _is_shut(fit, unknown) else 0.0 for unknown in fit.noise]
    moves = np.array([AT_RANDOM.get(unknown.column, other) for unknown, other in zip(fit.noise, coarse, strict=True)])
    return _with_moved_noise(fit, moves)


def _without_inertial(fit: Fit) -> Fit:
    """The fit with inertial readings so coarse that they hardly count."""
    return _with_moved_noise(
        fit, np.array([RECALIBRATION.doubt if unknown.column in INERTIAL else 0.0 for unknown in fit.noise])
    )


def _with_moved_noise(fit: Fit, moves: Floats) -> Fit:
    return evaluated(replace(fit, q_noise=fit.q_noise + moves))


def _opened(fit: Fit) -> Fit:
    """The fit with the noise of those readings raised that are mostly beyond belief, lest nothing be learnt from them.

    A sensor that is off by many times its noise is no outlier; its effect takes the noise back.
    """
    for _ in range(MOST_DOUBLINGS):
        shut = [_is_shut(fit, unknown) for unknown in fit.noise]
        if not any(shut):
            return fit
        fit = _with_moved_noise(fit, math.log(2.0) * np.array(shut))
    return fit


def _is_shut(fit: Fit, noise: Unknown) -> bool:
    """Whether many of the readings of which this is the noise are not believed."""
    kinds = np.flatnonzero(COLUMN[noise.column] == READING_COLUMNS)
    for number in noise.tracks:
        chosen = np.isin(fit.tracks[number].timeline.kind, kinds)
        if chosen.any() and np.mean(fit.passes[number].believed[chosen]) < 1.0 - RECALIBRATION.shut:
            return True
    return False


def nominal_fit(base: Fit) -> Fit:
    """The platform as its file has it, with the random forces that it then needs."""
    start = evaluated(replace(base, q=np.zeros(len(base.unknowns))))
    return with_noise(start, 3, WATER_NOISE)
