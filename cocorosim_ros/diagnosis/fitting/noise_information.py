"""Score and Fisher information of the noise, by full passes of the filter with each noise a step off."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.noise_blocks import in_passes
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.diagnosis.fitting.unknowns import nudged, prior_precision, prior_slope
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track
from cocorosim_ros.foundation.arrays import Floats


def noise_information(fit: Fit, chosen: Sequence[int]) -> tuple[Floats, Floats]:
    """Score (n,) and Fisher information (n, n) of the noise `chosen` by number, by its logarithms, priors included.

    Innovations e are Gaussian with variance s: the log-likelihood L is given by -2 L = sum e^2 / s + log s, and the
    expectation of its second derivatives by sum de_i de_j / s + ds_i ds_j / (2 s^2), where d_i is the derivative by
    noise i.
    """
    unknowns = [fit.noise[index] for index in chosen]
    score, matrix = prior_slope(unknowns, fit.q_noise[chosen]), np.diag(prior_precision(unknowns))

    def of_track(number: int) -> tuple[Floats, Floats]:
        mine = [place for place, unknown in enumerate(unknowns) if number in unknown.tracks]
        moved, swollen = np.zeros((2, len(unknowns), len(fit.passes[number].innovation)))
        for pair in in_passes([unknowns[place].column for place in mine]):
            _write_slopes(fit, number, {mine[place]: chosen[mine[place]] for place in pair}, moved, swollen)
        return _summed(fit.passes[number], moved.T, swollen.T)

    for added_score, added_matrix in of_each_track(of_track, len(fit.tracks)):
        score, matrix = score + added_score, matrix + added_matrix
    return score, matrix


def _write_slopes(fit: Fit, number: int, pair: Mapping[int, int], moved: Floats, swollen: Floats) -> None:
    """Write what one noise, or two of different blocks, change in a track, by one pass with these a step off.

    pair: numbers of the noises in the fit by their rows in `moved` and `swollen`, that of the level block first.
    moved, swollen (n, m): derivatives of the innovations, and of their variances relative to these.
    """
    track, passed = fit.tracks[number], fit.passes[number]
    row = fit.filled[number]
    for index in pair.values():
        row = nudged(row, fit.noise[index], float(fit.q_noise[index]), STEPS.noise_difference)
    other = track.filter.full(row, with_gains=False)
    change = passed.change_to(other, track.timeline.is_angle) / STEPS.noise_difference
    growth = (other.variance - passed.variance) / (STEPS.noise_difference * passed.variance)
    is_upright = track.timeline.is_upright
    blocks = (~is_upright, is_upright) if len(pair) > 1 else (True,)
    for place, is_mine in zip(pair, blocks, strict=True):
        np.copyto(moved[place], change, where=is_mine)
        np.copyto(swollen[place], growth, where=is_mine)


def _summed(passed: Pass, moved: Floats, swollen: Floats) -> tuple[Floats, Floats]:
    """Score (n,) and information (n, n) of noise from the slopes (m, n) of one track, without priors."""
    excess = np.where(passed.believed, passed.innovation**2 / passed.variance - 1.0, 0.0)
    one = np.ones_like(passed.variance)
    score = -weighted_products(moved, passed.innovation[:, None], passed.variance)[:, 0]
    score += 0.5 * weighted_products(swollen, excess[:, None], one)[:, 0]
    matrix = weighted_products(moved, moved, passed.variance)
    return score, matrix + 0.5 * weighted_products(swollen, swollen, one)


def noise_covariance(fit: Fit) -> Floats:
    """Covariance of q_noise (noise, noise): the inverse of its information at the fit."""
    _, matrix = noise_information(fit, range(len(fit.noise)))
    return solve(matrix, np.eye(len(matrix)))
