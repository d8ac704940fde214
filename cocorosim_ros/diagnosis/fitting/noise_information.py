"""Score and Fisher information of the noise, by full passes of the filter with each noise a step off."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.diagnosis.fitting.unknowns import nudged, prior_precision, prior_slope
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_number, of_each_track
from cocorosim_ros.foundation.arrays import Floats


def noise_information(fit: Fit, chosen: Sequence[int]) -> tuple[Floats, Floats]:
    """Score (n,) and Fisher information (n, n) of the noise `chosen` by number, by its logarithms, priors included.

    Innovations e are Gaussian with variance s: the log-likelihood L is given by -2 L = sum e^2 / s + log s, and the
    expectation of its second derivatives by sum de_i de_j / s + ds_i ds_j / (2 s^2), where d_i is the derivative by
    noise i.
    """
    unknowns = [fit.noise[index] for index in chosen]
    score, matrix = prior_slope(unknowns, fit.q_noise[chosen]), np.diag(prior_precision(unknowns))
    filled = fit.filled

    def of_track(number: int) -> tuple[Floats, Floats]:
        row = filled[number]
        others = [
            nudged(row, unknown, float(fit.q_noise[index]), STEPS.noise_difference)
            if number in unknown.tracks
            else None
            for index, unknown in zip(chosen, unknowns, strict=True)
        ]
        return _of_track(fit.tracks[number], fit.passes[number], others, len(fit.tracks))

    for added_score, added_matrix in of_each_track(of_track, len(fit.tracks)):
        score, matrix = score + added_score, matrix + added_matrix
    return score, matrix


def _of_track(track: Track, passed: Pass, rows: Sequence[Floats | None], tracks: int) -> tuple[Floats, Floats]:
    """Score (n,) and information (n, n) of noise from one of so many tracks, without priors.

    rows: for each noise the track's row with that noise a step off; None for noise that is not of this track.
    """
    mean, relative = np.zeros((2, len(rows), len(passed.innovation)))

    def write(column: int) -> None:
        row = rows[column]
        if row is None:
            return
        other = track.filter.full(row, with_gains=False)
        growth = relative[column]  # written in place: these arrays are large
        np.divide(passed.change_to(other, track.timeline.is_angle), STEPS.noise_difference, out=mean[column])
        np.subtract(other.variance, passed.variance, out=growth)
        growth /= STEPS.noise_difference
        growth /= passed.variance

    of_each_number(write, len(rows), tracks)
    excess = np.where(passed.believed, passed.innovation**2 / passed.variance - 1.0, 0.0)
    one = np.ones_like(passed.variance)
    moved, swollen = mean.T, relative.T
    score = -weighted_products(moved, passed.innovation[:, None], passed.variance)[:, 0]
    score += 0.5 * weighted_products(swollen, excess[:, None], one)[:, 0]
    matrix = weighted_products(moved, moved, passed.variance)
    return score, matrix + 0.5 * weighted_products(swollen, swollen, one)


def noise_covariance(fit: Fit) -> Floats:
    """Covariance of q_noise (noise, noise): the inverse of its information at the fit."""
    _, matrix = noise_information(fit, range(len(fit.noise)))
    return solve(matrix, np.eye(len(matrix)))
