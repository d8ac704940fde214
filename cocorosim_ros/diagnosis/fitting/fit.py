"""A model fitted to tracks: unknowns, noise, the filter's passes under them, and the information on the unknowns.

With the filter's gains held, the innovations are a smooth function of the unknowns and cost a third of a full pass.
Terms of the score that come from the change of the gains have expectation zero. Gains follow where a number changes how
a reading depends on the state, as the scale of a camera does.
Source: Ljung, System Identification (1999), chapter 7; Kristensen, Madsen and Jorgensen, Automatica 40 (2004) 225.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.diagnosis.fitting.unknowns import (
    Unknown,
    log_prior,
    nudged,
    prior_centre,
    prior_slope,
    prior_weights,
    write_values,
)
from cocorosim_ros.diagnosis.tracks.columns import LATENCY
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_number, of_each_track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors.errors import SEEN_OTHERWISE

GAINS_FOLLOW = frozenset((*SEEN_OTHERWISE, *LATENCY))
"""Columns of numbers whose slopes are those with the gains that a step of the number makes."""


@dataclass(frozen=True)
class Fit:
    """A model fitted to the tracks: q of its unknowns and of its noise, and the filter's pass over each track there."""

    tracks: tuple[Track, ...]
    rows: Floats  # (tracks, columns) numbers of the model, SI units; those that are fitted are replaced by `filled`
    unknowns: tuple[Unknown, ...]
    noise: tuple[Unknown, ...]
    q: Floats  # (unknowns,)
    q_noise: Floats  # (noise,)
    passes: tuple[Pass, ...]

    @property
    def log_likelihood(self) -> float:
        """Log-likelihood of all readings of all tracks [nats]."""
        return sum(passed.log_likelihood for passed in self.passes)

    @property
    def objective(self) -> float:
        """Log-likelihood plus log prior [nats], up to a constant; minus infinity where the model ran away."""
        whole = self.log_likelihood + log_prior(self.unknowns, self.q) + log_prior(self.noise, self.q_noise)
        return whole if math.isfinite(whole) else -math.inf

    @property
    def filled(self) -> Floats:
        """Rows (tracks, columns) with all fitted values in them."""
        return write_values(write_values(self.rows, self.unknowns, self.q), self.noise, self.q_noise)

    @cached_property
    def information(self) -> Information:
        """Slopes, Fisher information and score of the unknowns at the fit, computed when first asked for."""
        return _information(self)


def make_fit(tracks: Sequence[Track], rows: Floats, unknowns: Sequence[Unknown], noise: Sequence[Unknown]) -> Fit:
    """Make a fit with all unknowns and noise at the centres of their priors, and evaluate it."""
    centre, centre_of_noise = prior_centre(unknowns), prior_centre(noise)
    return evaluated(Fit(tuple(tracks), rows, tuple(unknowns), tuple(noise), centre, centre_of_noise, ()))


def evaluated(fit: Fit) -> Fit:
    """Run the filter over every track at the fit's q, and return the fit with these passes."""
    filled = fit.filled
    passes = of_each_track(lambda number: fit.tracks[number].filter.lately(filled[number]), len(fit.tracks))
    return replace(fit, passes=tuple(passes))


def slopes(fit: Fit, unknowns: Sequence[Unknown], q: Floats) -> tuple[Floats, ...]:
    """Derivatives of the innovations by each unknown at q: (m, unknowns) for each track.

    Gains are held, but for numbers by which a reading depends otherwise on the state, and for delays, by which readings
    pass one another. The derivatives are 0 for readings beyond the gate. At q the unknowns must leave the model as the
    fit has it: they are those of the fit, or new ones that are still neutral.
    """
    filled = fit.filled if unknowns is fit.unknowns else write_values(fit.filled, unknowns, q)

    def of_track(number: int) -> Floats:
        passed, passing = fit.passes[number], fit.tracks[number].filter
        found = np.zeros((len(unknowns), len(passed.innovation)))
        moving = [index for index, unknown in enumerate(unknowns) if number in unknown.tracks]

        def write(place: int) -> None:
            index = moving[place]
            unknown, at = unknowns[index], float(q[index])
            step = slope_step(unknown, at, fit.tracks[number])
            slope_of = passing.slope_with_gains if unknown.column in GAINS_FOLLOW else passing.slope
            slope_of(nudged(filled[number], unknown, at, step), passed, step, found[index])

        of_each_number(write, len(moving), len(fit.tracks))
        return found.T

    return tuple(of_each_track(of_track, len(fit.tracks)))


def slope_step(unknown: Unknown, q: float, track: Track) -> float:
    """Step of q for a slope on a track; of a latency it is a whole step of the grid.

    By less than that, readings come to lie otherwise between grid points, which makes the likelihood rough: such slopes
    have an information that is far too great.
    """
    is_latency = unknown.column in LATENCY
    return unknown.inward_step(q, track.timeline.grid.step / abs(unknown.scale) if is_latency else None)


@dataclass(frozen=True)
class FeltByTrack:
    """The unknowns that act on a track, by number, and their slopes (m, n) alone: those of all others are zeros."""

    unknowns: list[int]
    slopes: Floats

    @property
    def block(self) -> tuple[NDArray[np.intp], ...]:
        """Index of the rows and columns of these unknowns in a matrix of all unknowns."""
        return np.ix_(self.unknowns, self.unknowns)


@dataclass(frozen=True)
class Information:
    """Slopes of the unknowns, their Fisher information and their score, all by q and the last two with the prior.

    slopes: (m, unknowns) for each track; matrix: (unknowns, unknowns); score: (unknowns,), the derivative of the
    objective.
    """

    slopes: tuple[Floats, ...]
    matrix: Floats
    score: Floats
    own: tuple[FeltByTrack, ...]  # by track


def information(fit: Fit) -> Information:
    """Slopes, Fisher information and score of the unknowns of a fit; computed once for each fit."""
    return fit.information


def _information(fit: Fit) -> Information:
    by_track = slopes(fit, fit.unknowns, fit.q)
    matrix, score = np.diag(prior_weights(fit.unknowns, fit.q)), prior_slope(fit.unknowns, fit.q)
    own = tuple(_felt(fit, number, slope) for number, slope in enumerate(by_track))
    for passed, felt in zip(fit.passes, own, strict=True):
        matrix[felt.block] += weighted_products(felt.slopes, felt.slopes, passed.variance)
        score[felt.unknowns] -= weighted_products(felt.slopes, passed.innovation[:, None], passed.variance)[:, 0]
    return Information(by_track, matrix, score, own)


def _felt(fit: Fit, number: int, slopes: Floats) -> FeltByTrack:
    """Select, of the slopes (m, unknowns) of a track, those of the unknowns that act on it."""
    moving = [index for index, unknown in enumerate(fit.unknowns) if number in unknown.tracks]
    return FeltByTrack(moving, slopes if len(moving) == len(fit.unknowns) else slopes.T[moving].T)


def covariance(fit: Fit) -> Floats:
    """Covariance of q (unknowns, unknowns): the inverse of the information at the fit, noise held."""
    matrix = information(fit).matrix
    return solve(matrix, np.eye(len(matrix)))


def finite(fit: Fit) -> bool:
    """Tell whether the filter could be run with this model: whether its likelihood is a number."""
    return math.isfinite(fit.log_likelihood)
