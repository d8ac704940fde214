"""Rao's score test of every candidate, orthogonal to recalibration, without a fit of any.

The derivative of the innovations by an amplitude (its slope) is projected off the slopes of the unknowns of
the model. The sum of squares of the rest, weighted by the variance of the innovations, is the information I on the
amplitude; its weighted product with the innovations is the score s. The amplitude q, in units of `large`, has a normal
prior with mean 0 and standard deviation 1. So its estimate is q = (I + 1)^-1 s, and its evidence in nats, the
logarithm of the Bayes factor over the model without it, is 1/2 s^T (I + 1)^-1 s - 1/2 log det(I + 1).
Source: Rao, Proc. Camb. Phil. Soc. 44 (1948) 50; Kass and Raftery, JASA 90 (1995) 773.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from cocorosim_ros.diagnosis.criteria.naming import DETECTABILITY
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit, Information, information, slopes
from cocorosim_ros.diagnosis.fitting.solving import clipped, solve
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown, write_values
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.search import Scene


@dataclass(frozen=True)
class Summand:
    """A direction of a weighted sum, by its number, and its weight."""

    number: int
    weight: float


@dataclass(frozen=True)
class Screened:
    """Result of the score test of a candidate, at the point of its grid of shapes with the most evidence."""

    candidate: Candidate
    values: dict[str, float]  # by column: shapes, and numbers that the entry fixes
    q: Floats  # (amplitudes,) estimate by one linear step
    nats: float  # evidence
    information: Floats  # (amplitudes, amplitudes) orthogonal to the model, without prior
    z: Floats  # (amplitudes,) each one's score over its standard deviation
    felt: float = math.nan  # nats that a delay of medium size would yield, as tried; NaN where slopes tell it


class Screen:
    """A score test against one fit, whose information is computed once for all candidates."""

    def __init__(self, fit: Fit, scene: Scene) -> None:
        self.fit, self.scene = fit, scene
        self.known: Information = information(fit)
        self._last: _Tested | None = None
        self._tried: dict[tuple[str, str | None, float], dict[int, float]] = {}  # by candidate and q: gains by track

    def slopes(self, candidate: Candidate, values: dict[str, float], unknowns: Sequence[Unknown]) -> tuple[Floats, ...]:
        """Slopes of the innovations by a candidate's amplitudes at given shapes: (m, unknowns) for each track."""
        neutral = np.zeros(len(unknowns))
        rows = write_values(candidate.write(self.fit.rows, values), unknowns, neutral)
        return slopes(replace(self.fit, rows=rows), unknowns, neutral)

    def stepped(self, screened: Screened) -> Floats:
        """Rows (tracks, columns) after the linear step that a screening promises, the model's own unknowns with it."""
        new = screened.candidate.amplitudes()
        shared = np.zeros((len(self.known.matrix), len(new)))
        moved = self.slopes(screened.candidate, screened.values, new)
        for own, other, passed in zip(self.known.own, moved, self.fit.passes, strict=True):
            shared[own.unknowns] += weighted_products(own.slopes, other, passed.variance)
        q = clipped(self.fit.unknowns, self.fit.q - solve(self.known.matrix, shared) @ screened.q)
        rows = screened.candidate.write(self.fit.rows, screened.values)
        filled = write_values(rows, [*self.fit.unknowns, *new], np.concatenate([q, clipped(new, screened.q)]))
        return write_values(filled, self.fit.noise, self.fit.q_noise)

    def test(self, candidate: Candidate) -> Screened:
        """Test a candidate at all points of its grid of shapes, and return the best.

        The logarithm of the number of points, as odds against one of so many, and the prior's nats are taken off.
        """
        unknowns = candidate.amplitudes()
        if self._last is None or not self._last.covers(candidate):
            self._last = _Tested(self, candidate, unknowns)
        if not self._last.settings:
            return _impossible(candidate, len(unknowns))
        lower = np.array([unknown.bounds[0] for unknown in unknowns])
        best: Screened | None = None
        for values, own, own_score in self._last.of(unknowns):
            q, nats = _evidence(own, own_score, lower)
            if best is None or nats > best.nats:
                z = own_score / np.sqrt(np.maximum(np.diag(own), 1e-300))
                best = Screened(candidate, values, q, nats, own, z)
        assert best is not None
        return replace(best, nats=best.nats - math.log(len(self._last.settings)) - candidate.entry.prior_nats)

    def searched(self, screened: Screened) -> Screened:
        """Evidence of a candidate at further starts of its fit, where that is more than its slope promises.

        The likelihood of a delay is so rough that its slope at zero may promise nothing of a delay of many steps. It is
        also broad, so that every second start is enough. Where the model runs away along the slope, nothing is told.
        """
        candidate, grid = screened.candidate, further_starts(screened)[1::2]
        if not grid or not np.isfinite(screened.information).all():
            return screened
        gains = [self._gain_at(screened, point) - 0.5 * float(point @ point) for point in grid]
        best = int(np.argmax(gains))
        volume = float(np.linalg.slogdet(screened.information + np.eye(len(grid[best])))[1])
        odds = math.log(len(grid)) + candidate.entry.prior_nats
        nats = (gains[best] - 0.5 * volume - odds) / candidate.spread
        return screened if not nats > screened.nats else replace(screened, q=grid[best], nats=nats)

    def felt(self, screened: Screened) -> Screened:
        """Try by how much a delay of medium size is felt, where a candidate is one.

        The slope by a delay goes with the noise of the readings too, so that its information promises too much. Where
        the recordings have a delay, as `searched` finds it, what is tried is one that is medium larger or smaller. A
        slope that points away from delays says as little: then one twice as large tells how the likelihood is bent.
        """
        if not further_starts(screened):
            return screened
        medium = np.full(len(screened.q), DETECTABILITY.medium)
        found = self._gain_at(screened, screened.q) if screened.q.any() else 0.0
        if found > 0.0:
            lowest = np.array([unknown.bounds[0] for unknown in screened.candidate.amplitudes()])
            around = [q for q in (screened.q + medium, screened.q - medium) if (q >= lowest).all()]
            left = float(np.mean([self._gain_at(screened, q) for q in around]))
            return replace(screened, felt=max(0.0, found - left))
        score, near = screened.z * np.sqrt(np.diag(screened.information)), self._gain_at(screened, medium)
        felt = float(score @ medium) - near
        if not felt > 0.0:
            felt = near - 0.5 * self._gain_at(screened, 2.0 * medium)
        return replace(screened, felt=max(0.0, felt))

    def _gain_at(self, screened: Screened, point: Floats) -> float:
        return sum(self.gains_at(screened.candidate, screened.values, point))

    def gains_at(self, candidate: Candidate, values: dict[str, float], point: Floats) -> list[float]:
        """Gains of the log likelihood with a candidate of one number at q (n,), the same for all robots, noise held.

        values: its shapes, by column. One for each of the candidate's tracks, in their order.
        """
        new = (*self.fit.unknowns, *candidate.amplitudes())
        rows = candidate.write(self.fit.rows, values)
        filled = replace(self.fit, rows=rows, unknowns=new, q=np.concatenate([self.fit.q, point])).filled
        own = self._tried.setdefault((candidate.entry.id, candidate.entry.topic, float(point[0])), {})
        # A candidate for one robot alone has the same rows there as the one for all robots.
        left = [number for number in candidate.everybody if number not in own]
        tracks, passes = self.fit.tracks, self.fit.passes

        def of_track(place: int) -> Pass:
            return tracks[left[place]].filter.full(filled[left[place]], with_gains=False)

        found = of_each_track(of_track, len(left))
        for number, passed in zip(left, found, strict=True):
            own[number] = passed.log_likelihood - passes[number].log_likelihood
        return [own[number] for number in candidate.everybody]


def further_starts(screened: Screened) -> list[Floats]:
    """Further starts of the fit of a candidate without shapes that are fitted; empty for all others."""
    entry = screened.candidate.entry
    settled = entry.fixed.keys() | {shape.column for shape in entry.shapes if shape.fixed}
    has_shapes = not screened.values.keys() <= settled
    return [] if has_shapes else screened.candidate.searched()


class _Tested:
    """Information and scores of a candidate's amplitudes at all points of its grid of shapes.

    They also serve candidates of the same entry with fewer of the robots.
    """

    def __init__(self, screen: Screen, candidate: Candidate, unknowns: Sequence[Unknown]) -> None:
        self._candidate, self._unknowns = candidate, list(unknowns)
        self.settings = list(candidate.settings(screen.scene))
        directions = _Directions(screen, candidate, unknowns)
        sums = [directions.sum_at(values) for values in self.settings]
        products = _Products(screen, directions.slopes)
        self._found = [products.mixed(weighted) for weighted in sums]

    def covers(self, other: Candidate) -> bool:
        """Tell whether another candidate is of the same entry, for robots that are among those of this one."""
        mine = self._candidate
        return other.entry is mine.entry and other.known == mine.known and set(other.robots) <= set(mine.robots)

    def of(self, unknowns: Sequence[Unknown]) -> Iterator[tuple[dict[str, float], Floats, Floats]]:
        """Iterate over points of the grid: the shapes, and information (n, n) and score (n,) of these amplitudes.

        Both are orthogonal to the unknowns of the model.
        """
        chosen = [self._unknowns.index(unknown) for unknown in unknowns]
        for values, (own, score) in zip(self.settings, self._found, strict=True):
            yield values, own[np.ix_(chosen, chosen)], score[chosen]


def _impossible(candidate: Candidate, amplitudes: int) -> Screened:
    """Make the result for a candidate without any point to test: no information, evidence minus infinity."""
    nothing = np.zeros(amplitudes)
    return Screened(candidate, {}, nothing, -math.inf, np.zeros((amplitudes, amplitudes)), nothing)


class _Products:
    """Information and score of directions, orthogonal to the unknowns of the model.

    A direction is the slopes of a candidate at one point of its shapes: (m, n) for each track. Products of two
    directions are computed when first asked for.
    """

    def __init__(self, screen: Screen, directions: Sequence[tuple[Floats, ...]]) -> None:
        self._fit, self._known, self._directions = screen.fit, screen.known, directions
        self._cross = [self._with_unknowns(moved) for moved in directions]
        self._absorbed = [solve(screen.known.matrix, cross) for cross in self._cross]
        self._found: dict[tuple[int, int], Floats] = {}

    def mixed(self, weighted: Sequence[Summand]) -> tuple[Floats, Floats]:
        """Information (n, n) and score (n,) of a weighted sum of directions."""
        pairs = product(weighted, repeat=2)
        own = sum(one.weight * other.weight * self._pair(one.number, other.number) for one, other in pairs)
        score = sum(each.weight * self._score(each.number) for each in weighted)
        return 0.5 * np.asarray(own + np.transpose(own)), np.asarray(score)

    def _score(self, number: int) -> Floats:
        """Score (n,) of one direction, the part along the unknowns of the model taken out."""
        innovations = tuple(passed.innovation[:, None] for passed in self._fit.passes)
        return -self._sum(self._directions[number], innovations)[:, 0] - self._absorbed[number].T @ self._known.score

    def _pair(self, i: int, j: int) -> Floats:
        """Information (n, n) of two directions with each other, the part along the unknowns of the model taken out."""
        if (i, j) not in self._found:
            with np.errstate(over="ignore", invalid="ignore"):  # of a model that runs away: it promises nothing
                own = self._sum(self._directions[i], self._directions[j]) - self._cross[i].T @ self._absorbed[j]
            self._found[i, j], self._found[j, i] = own, own.T
        return self._found[i, j]

    def _with_unknowns(self, moved: tuple[Floats, ...]) -> Floats:
        """Information (unknowns, n) that a direction shares with the unknowns of the model."""
        shared = np.zeros((len(self._known.matrix), moved[0].shape[1]))
        for own, other, passed in zip(self._known.own, moved, self._fit.passes, strict=True):
            shared[own.unknowns] += weighted_products(own.slopes, other, passed.variance)
        return shared

    def _sum(self, left: tuple[Floats, ...], right: tuple[Floats, ...]) -> Floats:
        """Sum of products over all readings of all tracks, each divided by the variance of its innovation."""
        total = np.zeros((left[0].shape[1], right[0].shape[1]))
        for one, other, passed in zip(left, right, self._fit.passes, strict=True):
            total += weighted_products(one, other, passed.variance)
        return total


class _Directions:
    """Slopes of a candidate at a few points of its shapes, of which the slopes at all others are weighted sums.

    A force sin(omega t + phase), for one, is a sum of sin(omega t) and cos(omega t).
    """

    def __init__(self, screen: Screen, candidate: Candidate, unknowns: Sequence[Unknown]) -> None:
        self._screen, self._candidate, self._unknowns = screen, candidate, unknowns
        self._found: dict[tuple[tuple[str, float], ...], int] = {}
        self.slopes: list[tuple[Floats, ...]] = []

    def sum_at(self, values: dict[str, float]) -> list[Summand]:
        """The weighted slopes that add up to the slope at the given shapes."""
        basis = self._candidate.entry.basis
        wanted = basis(values) if basis is not None and values else [(values, 1.0)]
        return [Summand(self._number(shapes), weight) for shapes, weight in wanted]

    def _number(self, values: dict[str, float]) -> int:
        """Number of the slope at the given shapes, computed when first asked for."""
        key = tuple(sorted(values.items()))
        if key not in self._found:
            self._found[key] = len(self.slopes)
            self.slopes.append(self._screen.slopes(self._candidate, values, self._unknowns))
        return self._found[key]


def _evidence(matrix: Floats, score: Floats, lower: Floats) -> tuple[Floats, float]:
    """Estimate q (n,) and evidence [nats] of amplitudes by information (n, n) and score (n,).

    Amplitudes that would pass their `lower` bound (n,) stay at it. Evidence is minus infinity where the model ran away.
    """
    if not (np.isfinite(matrix).all() and np.isfinite(score).all()):
        return np.zeros(len(score)), -math.inf
    free = np.ones(len(score), dtype=bool)
    while True:
        q = np.where(free, 0.0, np.where(lower > 0, lower, 0.0))
        bounded = matrix[np.ix_(free, free)] + np.eye(int(free.sum()))
        q[free] = np.linalg.solve(bounded, score[free]) if free.any() else q[free]
        wrong = free & (q < lower)
        if not wrong.any():
            break
        free &= ~wrong
    if not free.any():
        return np.zeros(len(score)), 0.0
    gain = float(score[free] @ q[free]) - 0.5 * float(q[free] @ bounded @ q[free])
    return q, gain - 0.5 * float(np.linalg.slogdet(bounded)[1])
