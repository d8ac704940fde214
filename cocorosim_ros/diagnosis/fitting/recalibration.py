"""Recalibration: the platform's numbers fitted together with the noise, for a model to compare all others with."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import COLOURED, RECALIBRATION
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.base_model import base_rows, base_unknowns, noise_unknowns
from cocorosim_ros.diagnosis.fitting.climbing import settled, with_noise
from cocorosim_ros.diagnosis.fitting.coloured_readings import memories_of, with_obvious_colour, with_quick_colour
from cocorosim_ros.diagnosis.fitting.declared_numbers import declared_unknowns
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, make_fit
from cocorosim_ros.diagnosis.fitting.leaps import leapt
from cocorosim_ros.diagnosis.fitting.polishing import polished
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, READING_COLUMNS, WATER_RANDOM
from cocorosim_ros.diagnosis.tracks.make_tracks import NONE_FOUND, make_tracks
from cocorosim_ros.diagnosis.tracks.track import Track, wanted_step
from cocorosim_ros.foundation.arrays import Floats

INERTIAL = ("reading.gyro_z", "reading.accel")
# By column: how much the logarithm of a noise moves for the second start.
AT_RANDOM = {
    "random.force": RECALIBRATION.at_random,
    "random.heave_force": RECALIBRATION.at_random,
    "random.moment": RECALIBRATION.at_random,
    "random.correlation": -RECALIBRATION.at_random,
}


def first_fit(evidence: Evidence, found: Mapping[str, Floats] = NONE_FOUND) -> Fit:
    """Make tracks of the evidence, and the model with the numbers of the platform's file and a first guess of noise.

    found: as in `make_tracks`.
    """
    tracks = make_tracks(evidence, found)
    rows = base_rows(tracks)
    unknowns = [*base_unknowns(tracks), *declared_unknowns(tracks)]
    return make_fit(tracks, rows, unknowns, noise_unknowns(tracks, rows))


def base_fit(evidence: Evidence) -> Fit:
    """Fit the recalibrated model: the platform's numbers and the noise at their most likely values.

    The steps of the filter are those that the platform's file asks for. If the numbers that are found ask for others,
    as for a ship that brakes in a tenth of the time, the fit is made once more with these. A found model says by which
    steps it was found, since other steps average other readings: with them another diagnosis may find other numbers.
    """
    base = climbed(first_fit(evidence))
    for _ in range(0 if evidence.platform.fitted_step else RECALIBRATION.most_regriddings):
        if all(_has_its_step(track, row) for track, row in zip(base.tracks, base.filled, strict=True)):
            break
        found = {track.name: row for track, row in zip(base.tracks, base.filled, strict=True)}
        base = climbed(evaluated(replace(first_fit(evidence, found), q=base.q)))
    return base


def _has_its_step(track: Track, row: Floats) -> bool:
    """Tell whether the step of a track is about the one that the numbers of a row (columns,) ask for."""
    ratio = track.timeline.grid.step / wanted_step(track.vehicle, row)
    return 1.0 / RECALIBRATION.alike_steps < ratio < RECALIBRATION.alike_steps


def climbed(first: Fit) -> Fit:
    """Fit unknowns and noise to their most likely values, from a first guess that may be far off.

    Under the first guess of the noise, many readings of a sensor may lie beyond the gate. Then much is wrong, and a
    climb may end at a local optimum. So a second climb starts from strong random forces, which explain nearly all
    motion, and a third from inertial sensors that hardly count, because the model leans on them at every step and they
    may be the ones in error. The best of the three goes on by leaps (`leaps`).

    A climb may also begin with the numbers as they are, and fit the noise to them first: of numbers that are right
    already, as those that another diagnosis has found, this is the shortest way.

    If a model is so far off that readings counted for next to nothing until its numbers were found, their noise may not
    come down any more. Then one more climb starts from these numbers, with the first guess of that noise.
    The best of all goes on by leaps (`leaps`), and by exact slopes in the end (`polishing`).

    Where the first climb shows that errors of most instruments last, it begins again with such errors. Their first
    guess is that of a fit, so that further starts are left out if this climb leaves no readings beyond the gate. Where
    the best climb needs water that is far stronger than the actuators, a climb with such errors is tried too, and the
    better of the two is taken.
    """
    opened = _opened(first)
    way = settled(opened, RECALIBRATION.most_rounds)
    coloured = with_obvious_colour(first, way)
    if coloured is not None:
        return climbed(coloured)
    is_simple = opened is first or bool(memories_of(way) and _opened(way) is way)  # no readings lie beyond the gate
    best = way if is_simple else _best_way(first, opened, way)
    shaken = with_quick_colour(first, best)
    if shaken is not None:
        steadier = leapt(climbed(shaken), RECALIBRATION.most_rounds)
        if steadier.objective > best.objective + COLOURED.worth:
            return steadier
    return best if is_simple else polished(leapt(best, RECALIBRATION.most_rounds))


def _best_way(first: Fit, opened: Fit, way: Fit) -> Fit:
    """Climb from other first guesses of the noise too, and return the best; way: the climb from `opened`."""
    starts = [_at_random(first)]
    if any(unknown.column in INERTIAL for unknown in first.noise):
        starts.append(_without_inertial(first))
    ways = [way, *(settled(_opened(start), RECALIBRATION.most_rounds) for start in starts)]
    ways.append(settled(with_noise(opened, RECALIBRATION.most_rounds), RECALIBRATION.most_rounds))
    best = max(ways, key=lambda fit: fit.objective)
    if any(q >= unknown.bounds[1] for unknown, q in zip(best.noise, best.q_noise, strict=True)):
        again = _at_random(evaluated(replace(best, q_noise=first.q_noise)))
        best = max(best, settled(again, RECALIBRATION.most_rounds), key=lambda fit: fit.objective)
    return best


def _at_random(fit: Fit) -> Fit:
    """Start from strong and quick random forces, and from coarse readings for sensors that are mostly not believed."""
    coarse = [RECALIBRATION.coarse if _is_shut(fit, unknown) else 0.0 for unknown in fit.noise]
    moves = np.array([AT_RANDOM.get(unknown.column, other) for unknown, other in zip(fit.noise, coarse, strict=True)])
    return _with_moved_noise(fit, moves)


def _without_inertial(fit: Fit) -> Fit:
    """Start from inertial readings so coarse that they hardly count."""
    return _with_moved_noise(
        fit, np.array([RECALIBRATION.doubt if unknown.column in INERTIAL else 0.0 for unknown in fit.noise])
    )


def _with_moved_noise(fit: Fit, moves: Floats) -> Fit:
    return evaluated(replace(fit, q_noise=fit.q_noise + moves))


def _opened(fit: Fit) -> Fit:
    """Double the noise of readings of which many lie beyond the gate, until few do.

    Otherwise the fit would learn nothing from them. A sensor that is off by many times its noise has no outliers but a
    fault; once this fault is in the model, the fit takes the noise back.
    """
    for _ in range(RECALIBRATION.most_doublings):
        shut = [_is_shut(fit, unknown) for unknown in fit.noise]
        if not any(shut):
            return fit
        fit = _with_moved_noise(fit, math.log(2.0) * np.array(shut))
    return fit


def _is_shut(fit: Fit, noise: Unknown) -> bool:
    """Tell whether many of the readings that have this noise lie beyond the gate, on any of its tracks."""
    kinds = np.flatnonzero(COLUMN[noise.column] == READING_COLUMNS)
    for number in noise.tracks:
        chosen = np.isin(fit.tracks[number].timeline.kind, kinds)
        if chosen.any() and np.mean(fit.passes[number].believed[chosen]) < 1.0 - RECALIBRATION.shut:
            return True
    return False


def nominal_fit(base: Fit) -> Fit:
    """Fit the nominal model: the platform as its file has it, with the random forces that it then needs."""
    start = evaluated(replace(base, q=np.zeros(len(base.unknowns))))
    return with_noise(start, 3, WATER_RANDOM)
