"""The control: how much a candidate explains in each recording that should be like the others.

Each track of the learned vehicle in turn is treated as the one to be judged, by Rao's score test: its score and its
information on the candidate's amplitudes, orthogonal to all learned numbers. The sum of score' information^-1 score
over the tracks has a chi-squared distribution if they differ by their noise alone; what is beyond it is their spread.
By that spread evidence from other recordings is divided, as variances are in quasi-likelihood, and by more where the
recordings to be judged have more information each. Where the learned vehicle has no number of the candidate's kind, the
difference of two amplitudes is asked for, and the one of the learned vehicle is known no better than its recordings
tell.
Source: McCullagh and Nelder, Generalized Linear Models (1989), section 9.2; DerSimonian and Laird, Controlled Clinical
Trials 7 (1986) 177.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy.stats import chi2

from cocorosim_ros.diagnosis.criteria.against import ALIKE
from cocorosim_ros.diagnosis.filter.products import weighted_products
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.screening import Screen, Screened
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.tracks.columns import OF_TIME
from cocorosim_ros.foundation.arrays import Floats


class Told(NamedTuple):
    """Information of one track alone on a candidate's n amplitudes, and their score."""

    matrix: Floats  # (n, n) information
    score: Floats  # (n,)


class Alike:
    """The tracks of a learned vehicle, which should be alike, as a measure of evidence found in others."""

    def __init__(self, learned: Fit) -> None:
        self._fit = learned
        self._screen = Screen(learned, scene_of(learned.tracks, smoothed_tracks(learned), drag_form_of(learned)))
        self._over = frozenset(unknown.column for unknown in learned.unknowns)

    def weighed(self, screened: Sequence[Screened]) -> tuple[Screened, ...]:
        """Divide the evidence of the best screened candidates by their spread, and order all of them anew."""
        best = [self._weighed(each) for each in screened[: ALIKE.weighed]]
        parted = [_by_its_part(each, best) for each in best]
        return tuple(sorted((*parted, *screened[ALIKE.weighed :]), key=lambda each: -each.nats))

    def all_weighed(self, screened: Sequence[Screened]) -> tuple[Screened, ...]:
        """Divide the evidence of all screened candidates by their spread, and keep their order.

        What is asked of the best is whether they may be named; what is asked of all is from what size on they would be.
        """
        known = [each if each.candidate.spread > 1.0 else self._weighed(each) for each in screened]
        pairs = zip(known, screened, strict=True)
        return tuple(each if each is before else _by_its_part(each, known) for each, before in pairs)

    def _weighed(self, screened: Screened) -> Screened:
        spread = self.spread(screened)
        candidate = replace(screened.candidate, spread=spread)
        nats = screened.nats / spread if screened.nats > 0.0 else screened.nats
        return replace(screened, candidate=candidate, nats=nats)

    def spread(self, screened: Screened) -> float:
        """Divisor, at least 1, of the evidence of a candidate that was screened on other tracks.

        A candidate of which the learned vehicle's recordings tell nothing has the evidence of its own side alone, less
        what the prior of the other amplitude leaves open.
        """
        candidate = screened.candidate
        told = self._by_track(candidate, screened.values)
        count = len(candidate.amplitudes())
        own = float(np.trace(screened.information)) / max(count, 1)
        mine = [float(np.trace(matrix)) / len(matrix) for matrix, _ in told]
        unknown_there = 0.0 if self._is_shared(candidate) else own / (sum(mine) + 1.0)
        tracks = len(candidate.everybody) / max(len(candidate.sharers), 1)
        if not told or not sum(mine) > ALIKE.told:
            return 1.0 + unknown_there + self._within_a_step(screened) / tracks
        differing = overdispersion(told)
        return 1.0 + unknown_there + (differing - 1.0) * (own / tracks) / (sum(mine) / len(mine))

    def _is_shared(self, candidate: Candidate) -> bool:
        """Tell whether all of the candidate's numbers are fitted for the learned vehicle too."""
        return all(each.factor or each.column in self._over for each in candidate.entry.amplitudes)

    def _by_track(self, candidate: Candidate, values: dict[str, float]) -> list[Told]:
        """List what each track tells of the candidate's amplitudes, as if it were alone."""
        return list(self.told_by_track(candidate, values).values())

    def told_by_track(self, candidate: Candidate, values: dict[str, float]) -> dict[int, Told]:
        """Map the number of each track to what it tells of the candidate's amplitudes, as if it were alone.

        values: shapes of the candidate, by column.
        """
        numbers = self._having(candidate)
        if not numbers:
            return {}
        whole = _as_one(candidate, numbers)
        moved = self._screen.slopes(whole, values, whole.amplitudes())
        found = {number: self._orthogonal(number, moved[number]) for number in numbers}
        return {
            number: each
            for number, each in found.items()
            if np.isfinite(each.matrix).all() and np.isfinite(each.score).all()
        }

    def _within_a_step(self, screened: Screened) -> float:
        """Nats twice over that a delay of a step of the filter would yield, by what a delay that was tried yields.

        Alike recordings are taken to differ by so much in a delay of which theirs tell nothing: below a step it follows
        from how readings fall on the grid. 0 for a candidate that is no delay.
        """
        if not _is_delay(screened.candidate) or not screened.nats > 0.0 or not screened.q.any():
            return 0.0
        step = max(track.timeline.grid.step for track in self._fit.tracks) / screened.candidate.amplitudes()[0].scale
        return 2.0 * screened.nats * step**2 / float(np.max(screened.q**2))

    def _having(self, candidate: Candidate) -> list[int]:
        """List the numbers of the tracks that have readings of a candidate's stream."""
        return [number for number, track in enumerate(self._fit.tracks) if _has(candidate, track.log.streams)]

    def _orthogonal(self, number: int, moved: Floats) -> Told:
        """Compute what slopes (m, n) on one track tell, the learned numbers' part taken out."""
        known, passed = self._screen.known, self._fit.passes[number]
        felt = known.own[number]
        cross = np.zeros((len(known.matrix), moved.shape[1]))
        cross[felt.unknowns] = weighted_products(felt.slopes, moved, passed.variance)
        absorbed = solve(known.matrix, cross)
        matrix = weighted_products(moved, moved, passed.variance) - cross.T @ absorbed
        score = (
            -weighted_products(moved, passed.innovation[:, None], passed.variance).ravel() - absorbed.T @ known.score
        )
        return Told(0.5 * (matrix + matrix.T), score)


def _by_its_part(weighed: Screened, others: Sequence[Screened]) -> Screened:
    """Weigh what another candidate explains, of which this one is a wider form, by the spread of that other one.

    Where alike recordings differ in their offsets, an offset is no less usual for being called a drift.
    """
    candidate = weighed.candidate
    parts = [each for each in others if candidate.widens(each.candidate) and each.candidate.spread > candidate.spread]
    whole = weighed.nats * candidate.spread
    if not parts or not whole > 0.0:
        return weighed
    part = max(parts, key=lambda each: each.candidate.spread)
    explained = min(max(part.nats * part.candidate.spread, 0.0), whole)
    nats = explained / part.candidate.spread + (whole - explained) / candidate.spread
    return replace(weighed, candidate=replace(candidate, spread=whole / nats), nats=nats)


def overdispersion(told: Sequence[Told]) -> float:
    """Quotient, at least 1, of the spread of amplitudes among tracks and the one that their noise explains.

    told: by track. It is cautious: the spread may be smaller, by ALIKE.quantile.
    """
    squares, freedom = 0.0, 0
    for matrix, score in told:
        seen = np.diag(matrix) > ALIKE.told
        if seen.any():
            squares += float(score[seen] @ solve(matrix[np.ix_(seen, seen)], score[seen]))
            freedom += int(seen.sum())
    if freedom == 0:
        return 1.0
    return max(1.0, squares / float(chi2.ppf(ALIKE.quantile, freedom)))


def _is_delay(candidate: Candidate) -> bool:
    """Tell whether a candidate is one number that is a delay, of which a fit may begin at several."""
    (amplitude, *others) = candidate.entry.amplitudes
    return not others and bool(amplitude.searched) and amplitude.column in OF_TIME


def _as_one(candidate: Candidate, numbers: Sequence[int]) -> Candidate:
    """Copy a candidate, to act on tracks of the learned vehicle as on one robot's."""
    return replace(candidate, robots=("alike",), tracks=(tuple(numbers),), known=candidate.known[:1])


def _has(candidate: Candidate, streams: Collection[str]) -> bool:
    topic = candidate.entry.topic
    return topic is None or topic in streams
