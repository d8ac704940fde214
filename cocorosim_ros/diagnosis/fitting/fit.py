"""Maximum likelihood of the filter: laws by Gauss-Newton with the filter's gains held, noise by Fisher scoring.

With the gains held, the innovations are a smooth function of the laws and cost a tenth of a full pass; each step is
accepted by the full likelihood alone. Terms of the score that come from the change of the gains have expectation zero.
Source: Ljung, System Identification (1999), chapter 7; Kristensen, Madsen and Jorgensen, Automatica 40 (2004) 225.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.diagnosis.criteria.fitting import CONVERGENCE
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown, nudged, prior_centre, prior_precision, write_values
from cocorosim_ros.diagnosis.tracks.track import Pass, Track
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track
from cocorosim_ros.foundation.arrays import Floats

LARGEST_NOISE_STEP = 1.0  # of a logarithm
NOISE_STEP = 0.02
HALVINGS = 4
DAMPINGS = (0.0, 0.3, 3.0, 30.0, 300.0)  # of the curvature of each noise


@dataclass(frozen=True)
class Fit:
    """A model fitted to the tracks: q of the unknown laws and of the unknown noise, and the passes there."""

    tracks: tuple[Track, ...]
    rows: Floats  # (tracks, columns) what is not fitted
    laws: tuple[Unknown, ...]
    noise: tuple[Unknown, ...]
    q: Floats  # (laws,)
    q_noise: Floats  # (noise,)
    passes: tuple[Pass, ...]

    @property
    def log_likelihood(self) -> float:
        """Of all readings of all tracks."""
        return sum(part.log_likelihood for part in self.passes)

    @property
    def objective(self) -> float:
        """Log-likelihood and log prior; minus infinity where the model ran away."""
        whole = self.log_likelihood + _log_prior(self.laws, self.q) + _log_prior(self.noise, self.q_noise)
        return whole if math.isfinite(whole) else -math.inf

    @property
    def filled(self) -> Floats:
        """(tracks, columns) the rows with all fitted values."""
        return write_values(write_values(self.rows, self.laws, self.q), self.noise, self.q_noise)

    @cached_property
    def information(self) -> Information:
        """What the recordings tell of its laws."""
        return _information(self)


def _log_prior(unknowns: Sequence[Unknown], q: Floats) -> float:
    return -0.5 * float(np.sum(prior_precision(unknowns) * (q - prior_centre(unknowns)) ** 2))


def make_fit(tracks: Sequence[Track], rows: Floats, laws: Sequence[Unknown], noise: Sequence[Unknown]) -> Fit:
    """The model at the centres of the priors, evaluated."""
    return evaluated(Fit(tuple(tracks), rows, tuple(laws), tuple(noise), prior_centre(laws), prior_centre(noise), ()))


def evaluated(fit: Fit) -> Fit:
    """The fit with the passes at its q."""
    filled = fit.filled
    passes = of_each_track(lambda number: fit.tracks[number].full(filled[number]), len(fit.tracks))
    return replace(fit, passes=tuple(passes))


def slopes(fit: Fit, laws: Sequence[Unknown], q: Floats) -> tuple[Floats, ...]:
    """Per track (m, laws): derivative of the innovations by each of `laws` at q, gains held; 0 where not believed.

    At q the laws must leave the model as the fit has it: its own, or new ones that are still neutral.
    """
    filled = write_values(fit.filled, laws, q)
    steps = [law.step if law.clipped(place + law.step) == place + law.step else -law.step
             for law, place in zip(laws, q, strict=True)]  # fmt: skip

    def of_track(number: int) -> Floats:
        part = fit.passes[number]
        found = np.zeros((len(laws), len(part.innovation)))
        for law, place, step, slope in zip(laws, q, steps, found, strict=True):
            if number in law.tracks:
                fit.tracks[number].slope(nudged(filled[number], law, float(place) + step), part, step, slope)
        return found.T

    return tuple(of_each_track(of_track, len(fit.tracks)))


def _shorter(change: Floats, track: Track) -> Floats:
    """Changes of angles by the shorter way."""
    return np.where(track.is_angle, change - 2.0 * np.pi * np.round(change / (2.0 * np.pi)), change)


@dataclass(frozen=True)
class OfTrack:
    """The laws that a track feels, and their slopes alone (m, those): the others' are nothing but zeros to multiply."""

    laws: list[int]
    slopes: Floats

    @property
    def block(self) -> tuple[NDArray[np.intp], ...]:
        """Where they meet in a matrix of all laws."""
        return np.ix_(self.laws, self.laws)


@dataclass(frozen=True)
class Information:
    """Slopes of the laws by track, their Fisher information with the prior's, and the score, in q."""

    slopes: tuple[Floats, ...]
    matrix: Floats
    score: Floats
    own: tuple[OfTrack, ...]  # by track


def information(fit: Fit) -> Information:
    """What the recordings tell of the laws of the fit; found once for each fit."""
    return fit.information


def _information(fit: Fit) -> Information:
    parts = slopes(fit, fit.laws, fit.q)
    precision = prior_precision(fit.laws)
    matrix, score = np.diag(precision), -precision * (fit.q - prior_centre(fit.laws))
    own = tuple(_of_track(fit, number, each) for number, each in enumerate(parts))
    for part, each in zip(fit.passes, own, strict=True):
        matrix[each.block] += weighted_products(each.slopes, each.slopes, part.variance)
        score[each.laws] -= weighted_products(each.slopes, part.innovation[:, None], part.variance)[:, 0]
    return Information(parts, matrix, score, own)


def _of_track(fit: Fit, number: int, slopes: Floats) -> OfTrack:
    laws = [index for index, law in enumerate(fit.laws) if number in law.tracks]
    return OfTrack(laws, slopes if len(laws) == len(fit.laws) else slopes.T[laws].T)


def solve(matrix: Floats, right: Floats) -> Floats:
    """matrix^-1 right for a symmetric matrix that may be singular: directions without information stay 0."""
    if not (np.isfinite(matrix).all() and np.isfinite(right).all()):
        return np.zeros_like(right)
    scale = 1.0 / np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    values, vectors = np.linalg.eigh(matrix * scale[:, None] * scale)
    inverse = np.where(values > 1e-10, 1.0 / np.maximum(values, 1e-300), 0.0)
    shaped = right * (scale if right.ndim == 1 else scale[:, None])
    result = vectors @ ((vectors.T @ shaped).T * inverse).T
    return np.asarray(result * (scale if right.ndim == 1 else scale[:, None]))


def step_within(matrix: Floats, score: Floats, unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """matrix^-1 score with those that stand at a bound and press against it held there, lest the others give way."""
    step = np.zeros(len(unknowns))
    free = np.array([unknown.clipped(number + push) != number or push == 0.0
                     for unknown, number, push in zip(unknowns, q, np.sign(score) * 1e-9, strict=True)])  # fmt: skip
    step[free] = solve(matrix[np.ix_(free, free)], score[free])
    return step


def improved(fit: Fit, rounds: int) -> Fit:
    """The fit after at most so many Gauss-Newton steps of its laws."""
    for _ in range(rounds):
        if not fit.laws:
            return fit
        better = _laws_step(fit)
        if better is None or better.objective - fit.objective < CONVERGENCE.least_gain:
            return better if better is not None else fit
        fit = better
    return fit


def _laws_step(fit: Fit) -> Fit | None:
    known = information(fit)
    step = step_within(known.matrix, known.score, fit.laws, fit.q)
    return _first_better(
        fit, (replace(fit, q=clipped(fit.laws, fit.q + step / 2.0**halving)) for halving in range(HALVINGS))
    )


def clipped(unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """q (n,) of the unknowns, each within its bounds."""
    return np.array([part.clipped(number) for part, number in zip(unknowns, q, strict=True)])


def _first_better(fit: Fit, trials: Iterable[Fit]) -> Fit | None:
    """The first of these fits, not yet evaluated, that is better; None if none is."""
    better = (trial for trial in map(evaluated, trials) if trial.objective > fit.objective)
    return next(better, None)


def with_noise(fit: Fit, rounds: int, which: Sequence[str] | None = None) -> Fit:
    """The fit after at most so many scoring steps of its noise, of the columns in `which` or all."""
    chosen = [index for index, unknown in enumerate(fit.noise) if which is None or unknown.column in which]
    for _ in range(rounds):
        if not chosen:
            return fit
        better = _noise_step(fit, chosen)
        if better is None:
            return fit
        gain = better.objective - fit.objective
        fit = better
        if gain < CONVERGENCE.least_gain:
            return fit
    return fit


def _noise_step(fit: Fit, chosen: Sequence[int]) -> Fit | None:
    """A scoring step, damped more and more until it is better (Levenberg): at last it goes up the score alone.

    Far from the optimum, as where the water does not push at all, curvatures of the present place say little.
    """
    score, matrix = _noise_information(fit, chosen)
    unknowns = [fit.noise[index] for index in chosen]

    def damped(damping: float) -> Fit:
        step = step_within(matrix + damping * np.diag(np.diag(matrix)), score, unknowns, fit.q_noise[chosen])
        q = fit.q_noise.copy()
        q[chosen] = clipped(unknowns, q[chosen] + np.clip(step, -LARGEST_NOISE_STEP, LARGEST_NOISE_STEP))
        return replace(fit, q_noise=q)

    return _first_better(fit, map(damped, DAMPINGS))


def _noise_information(fit: Fit, chosen: Sequence[int]) -> tuple[Floats, Floats]:
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
        return _noise_of_track(fit.tracks[number], fit.passes[number], others)

    for added_score, added_matrix in of_each_track(of_track, len(fit.tracks)):
        score, matrix = score + added_score, matrix + added_matrix
    return score, matrix


def _noise_of_track(track: Track, part: Pass, rows: Sequence[Floats | None]) -> tuple[Floats, Floats]:
    """Score (n,) and information (n, n) of noise on a track; rows: its own with each one a step off, or none."""
    mean, spread = np.zeros((2, len(rows), len(part.innovation)))
    for column, row in enumerate(rows):
        if row is None:
            continue
        other = track.full(row)
        believed = part.believed & other.believed
        change = _shorter(other.innovation - part.innovation, track)
        mean[column] = np.where(believed, change / NOISE_STEP, 0.0)
        spread[column] = (other.variance - part.variance) / NOISE_STEP
    excess = np.where(part.believed, part.innovation**2 / part.variance - 1.0, 0.0)
    relative = spread / part.variance
    one = np.ones_like(part.variance)
    score = -weighted_products(mean.T, part.innovation[:, None], part.variance)[:, 0]
    score += 0.5 * weighted_products(relative.T, excess[:, None], one)[:, 0]
    matrix = weighted_products(mean.T, mean.T, part.variance)
    return score, matrix + 0.5 * weighted_products(relative.T, relative.T, one)


def settled(fit: Fit, rounds: int) -> Fit:
    """The fit after at most so many turns of noise and laws, until they leave each other alone.

    They do where nothing is left to gain after the first step of a turn.
    """
    for _ in range(rounds):
        stepped = with_noise(fit, 1)
        noisy = with_noise(stepped, 1) if stepped.objective - fit.objective > CONVERGENCE.least_gain else stepped
        fit = improved(noisy, 3)
        if fit.objective - stepped.objective < CONVERGENCE.settled:
            break
    return fit


def covariance(fit: Fit) -> Floats:
    """(laws, laws) of q, by the information at the fit."""
    matrix = information(fit).matrix
    return solve(matrix, np.eye(len(matrix)))


def finite(fit: Fit) -> bool:
    """Whether the model could be evaluated at all."""
    return math.isfinite(fit.log_likelihood)


def noise_covariance(fit: Fit) -> Floats:
    """(noise, noise) of q_noise."""
    _, matrix = _noise_information(fit, range(len(fit.noise)))
    return solve(matrix, np.eye(len(matrix)))
