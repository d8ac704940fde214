"""Variances of fitted numbers whose random force is not known either.

A vehicle that is turned by twice the moment, with twice the inertia and twice the drag, turns alike: only the random
moment then has to be twice as large too, and that is fitted. With the noise held, as fits hold it, such a common factor
looks well known; here it is as unknown as it is. The information on numbers and random forces together follows from
full passes of the filter with each of them a step off.
Source: Fisher information of Gaussian innovations, Ljung, System Identification (1999), chapter 9.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance, slope_step
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown, nudged, prior_precision
from cocorosim_ros.diagnosis.tracks.columns import WATER_NOISE
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_number, of_each_track
from cocorosim_ros.foundation.arrays import Floats


def variances_beside_noise(fit: Fit) -> Floats:
    """Variances (unknowns,) of q, that of the random forces being unknown; never less than those with the noise held.

    Less they would be where the likelihood is rough, as over delays, and its slopes are too steep.
    """
    held = np.diag(covariance(fit))
    forces = [place for place, each in enumerate(fit.noise) if each.column in WATER_NOISE]
    if not forces or not fit.unknowns:
        return held
    every = [*fit.unknowns, *(fit.noise[place] for place in forces)]
    q = np.concatenate([fit.q, fit.q_noise[forces]])
    deviations = np.concatenate([np.sqrt(held), np.ones(len(forces))])
    steps = STEPS.beside_noise * np.minimum(deviations, 1.0)
    filled = fit.filled

    def of_track(number: int) -> Floats:
        mine = [place for place, each in enumerate(every) if number in each.tracks]
        own = _information(fit, number, filled[number], [every[place] for place in mine], q[mine], steps[mine])
        whole = np.zeros((len(every), len(every)))
        whole[np.ix_(mine, mine)] = own
        return whole

    matrix = np.diag(prior_precision(every)) + sum(of_each_track(of_track, len(fit.tracks)))
    found = np.diag(solve(matrix, np.eye(len(matrix))))[: len(fit.unknowns)]
    return np.maximum(held, np.where(np.isfinite(found), found, held))


def _information(fit: Fit, number: int, row: Floats, unknowns: Sequence[Unknown], q: Floats, steps: Floats) -> Floats:
    """Information (n, n) of a track on its unknowns at q (n,), by steps (n,) off them, without priors.

    A dead band, or a delay of readings that count at grid points, changes nothing until a command or a point is passed:
    there the step is that of its slopes.
    """
    track, passed = fit.tracks[number], fit.passes[number]
    moved, swollen = np.zeros((2, len(unknowns), len(passed.innovation)))

    def changed(place: int, step: float) -> bool:
        """Write what changes by a step of an unknown, for a unit of it; tell whether anything does."""
        other = track.filter.full(nudged(row, unknowns[place], float(q[place]), step), with_gains=False)
        with np.errstate(invalid="ignore"):  # of a model that runs away: what is not finite tells nothing
            moved[place] = passed.change_to(other, track.timeline.is_angle) / step
            swollen[place] = (other.variance - passed.variance) / (step * passed.variance)
        return bool(moved[place].any())

    def write(place: int) -> None:
        unknown, at = unknowns[place], float(q[place])
        if not changed(place, unknown.inward_step(at, float(steps[place]))):
            changed(place, slope_step(unknown, at, track))

    of_each_number(write, len(unknowns), len(fit.tracks))
    found = weighted_products(moved.T, moved.T, passed.variance)
    return found + 0.5 * weighted_products(swollen.T, swollen.T, np.ones_like(passed.variance))
