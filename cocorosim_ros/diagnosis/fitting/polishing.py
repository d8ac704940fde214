"""Last steps to the most likely numbers, by the exact slopes of the likelihood and for unknowns and noise together.

A climb takes slopes with the filter's gains held; the terms left out have expectation zero for a model that is right.
For a model that is much in error they do not vanish, and the climb ends on a flank: on the recordings of a glider 273
nats below the summit. Exact slopes cost one pass of the filter for each unknown, so they come last.
Source: Nocedal and Wright, Numerical Optimization (2006), section 6.1 (BFGS, started from the information matrix).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import POLISHING, STEPS
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, information
from cocorosim_ros.diagnosis.fitting.noise_information import noise_information
from cocorosim_ros.diagnosis.fitting.solving import clipped, step_within
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown, nudged, prior_slope
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_number, of_each_track
from cocorosim_ros.foundation.arrays import Floats


def polished(fit: Fit) -> Fit:
    """Step to the maximum of the objective until a step promises or gains too little, or none gains.

    A fit whose slopes or curvature are not finite, as of a model that runs away from its readings, stays as it is.
    """
    curvature = _curvature(fit)
    if not np.isfinite(curvature).all():
        return fit
    before: _Place | None = None
    for _ in range(POLISHING.most_steps):
        place = _Place(_numbers(fit), _slope(fit, curvature))
        if not np.isfinite(place.slope).all():
            return fit
        curvature = curvature if before is None else _updated(curvature, before, place)
        if place.slope @ step_within(curvature, place.slope, _all(fit), place.q) < 2.0 * POLISHING.worth:
            return fit
        better = next((trial for trial in _trials(fit, place, curvature) if trial.objective > fit.objective), None)
        if better is None:
            return fit
        gain, fit, before = better.objective - fit.objective, better, place
        if gain < POLISHING.worth:
            return fit
    return fit


@dataclass(frozen=True)
class _Place:
    """Numbers q (n,) of unknowns and noise, and the slope (n,) of the objective there."""

    q: Floats
    slope: Floats


def _all(fit: Fit) -> tuple[Unknown, ...]:
    return (*fit.unknowns, *fit.noise)


def _numbers(fit: Fit) -> Floats:
    return np.concatenate([fit.q, fit.q_noise])


def _curvature(fit: Fit) -> Floats:
    """Fisher information (n, n) of unknowns and noise, which tell nothing of each other to first order."""
    count = len(fit.unknowns)
    matrix = np.zeros((count + len(fit.noise),) * 2)
    matrix[:count, :count] = information(fit).matrix
    matrix[count:, count:] = noise_information(fit, range(len(fit.noise)))[1]
    return matrix


def _slope(fit: Fit, curvature: Floats) -> Floats:
    """Slope (n,) of the objective, by passes of the filter with each number a small part of its width off."""
    unknowns, q, filled = _all(fit), _numbers(fit), fit.filled
    widths = 1.0 / np.sqrt(np.maximum(np.diag(curvature), POLISHING.least_curvature))
    wanted = POLISHING.difference * np.clip(widths, POLISHING.least_width, 1.0)
    steps = np.array([unknown.inward_step(*at) for unknown, *at in zip(unknowns, q, wanted, strict=True)])

    def of_track(number: int) -> Floats:
        track, known = fit.tracks[number], fit.passes[number].log_likelihood

        def slope(index: int) -> float:
            unknown, step = unknowns[index], float(steps[index])
            if number not in unknown.tracks:
                return 0.0
            row = nudged(filled[number], unknown, float(q[index]), step)
            return (track.filter.full(row, with_gains=False).log_likelihood - known) / step

        return np.array(of_each_number(slope, len(unknowns), len(fit.tracks)))

    of_tracks = np.sum(of_each_track(of_track, len(fit.tracks)), axis=0)
    return np.asarray(of_tracks + prior_slope(unknowns, q))


def _updated(curvature: Floats, before: _Place, now: _Place) -> Floats:
    """Curvature (n, n) after a step, by the change of the slope along it; as it was where that shows no summit."""
    step, change = now.q - before.q, before.slope - now.slope
    bent = curvature @ step
    if step @ change <= STEPS.no_information * np.linalg.norm(step) * np.linalg.norm(change) or step @ bent <= 0.0:
        return curvature
    return np.asarray(curvature - np.outer(bent, bent) / (step @ bent) + np.outer(change, change) / (step @ change))


def _trials(fit: Fit, place: _Place, curvature: Floats) -> Iterator[Fit]:
    """Steps from a place, more and more damped (Levenberg)."""
    unknowns, count = _all(fit), len(fit.unknowns)
    for damping in STEPS.dampings:
        step = step_within(curvature + damping * np.diag(np.diag(curvature)), place.slope, unknowns, place.q)
        q = clipped(unknowns, place.q + np.clip(step, -POLISHING.largest_step, POLISHING.largest_step))
        yield evaluated(replace(fit, q=q[:count], q_noise=q[count:]))
