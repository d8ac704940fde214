"""What the recordings tell of the noise: score and Fisher information, by full passes with each noise a step off."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.diagnosis.fitting.unknowns import nudged, prior_centre, prior_precision
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track
from cocorosim_ros.foundation.arrays import Floats

NOISE_STEP = 0.02  # of a logarithm


def noise_information(fit: Fit, chosen: Sequence[int]) -> tuple[Floats, Floats]:
    """Score (n,) and Fisher information (n, n) of the chosen noise: Gaussian innovations e with variance s.

    -2 L = sum e^2 / s + log s; E[d2] = sum de_i de_j / s + ds_i ds_j / (2 s^2).
    """
    unknowns = [fit.noise[index] for index in chosen]
    precision = prior_precision(unknowns)
    score = -precision * (fit.q_noise[chosen] - prior_centre(unknowns))
    matrix = np.diag(precision)
    filled = fit.filled

    def of_track(number: int) -> tuple[Floats, Floats]:
        row = filled[number]
        others = [
            nudged(row, unknown, float(fit.q_noise[index]) + NOISE_STEP) if number in unknown.tracks else None
            for index, unknown in zip(chosen, unknowns, strict=True)
        ]
        return _of_track(fit.tracks[number], fit.passes[number], others)

    for added_score, added_matrix in of_each_track(of_track, len(fit.tracks)):
        score, matrix = score + added_score, matrix + added_matrix
    return score, matrix


def _of_track(track: Track, passed: Pass, rows: Sequence[Floats | None]) -> tuple[Floats, Floats]:
    """Score (n,) and information (n, n) of noise on a track; rows: its own with each one a step off, or none."""
    mean, spread = np.zeros((2, len(rows), len(passed.innovation)))
    for column, row in enumerate(rows):
        if row is None:
            continue
        other = track.filter.full(row)
        believed = passed.believed & other.believed
        change = _shorter(other.innovation - passed.innovation, track)
        mean[column] = np.where(believed, change / NOISE_STEP, 0.0)
        spread[column] = (other.variance - passed.variance) / NOISE_STEP
    excess = np.where(passed.believed, passed.innovation**2 / passed.variance - 1.0, 0.0)
    relative = spread / passed.variance
    one = np.ones_like(passed.variance)
    score = -weighted_products(mean.T, passed.innovation[:, None], passed.variance)[:, 0]
    score += 0.5 * weighted_products(relative.T, excess[:, None], one)[:, 0]
    matrix = weighted_products(mean.T, mean.T, passed.variance)
    return score, matrix + 0.5 * weighted_products(relative.T, relative.T, one)


def _shorter(change: Floats, track: Track) -> Floats:
    """Changes of angles by the shorter way."""
    return np.where(track.timeline.is_angle, change - 2.0 * np.pi * np.round(change / (2.0 * np.pi)), change)


def noise_covariance(fit: Fit) -> Floats:
    """(noise, noise) of q_noise."""
    _, matrix = noise_information(fit, range(len(fit.noise)))
    return solve(matrix, np.eye(len(matrix)))
