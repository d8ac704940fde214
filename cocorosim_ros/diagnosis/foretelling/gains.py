"""Gains of free runs: how much better a model foretells unseen readings than another, in logarithms of the error.

Both models run through the same windows, and the gain of a window is the sum over the channels that readings show of

    1/2 log((before^2 + floor^2) / (after^2 + floor^2)),

with the errors of both models and that of the noise floor. So channels of other units count alike, what lies below the
noise counts for nothing, and the spread over the windows tells how sure the mean is.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.stats import norm
from scipy.stats import t as student

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUN_GAINS
from cocorosim_ros.diagnosis.fitting.fit import Fit, information
from cocorosim_ros.diagnosis.fitting.solving import clipped, not_held, solve
from cocorosim_ros.diagnosis.fitting.unknowns import write_values
from cocorosim_ros.diagnosis.foretelling.held_out_parts import Split
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS, against, errors_of_readings
from cocorosim_ros.diagnosis.foretelling.unseen import (
    Model,
    Unseen,
    path_of,
    rows_at_start,
    starts_under,
    with_errors_of,
)
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.track_filter import NO_PUSH
from cocorosim_ros.foundation.arrays import Flags, Floats

SURE = 0.975  # quantile at the upper end of a 95 % interval


class Gain(NamedTuple):
    """Mean gain over the windows [logarithm of the error], the standard deviation of that mean, and how many there are.

    The standard deviation is as wide for few windows as makes a normal 95 % interval of Student's.
    """

    mean: float
    spread: float
    windows: int

    @property
    def is_clear(self) -> bool:
        """Tell whether a gain is material and no chance."""
        return self.mean > max(FREE_RUN_GAINS.material, FREE_RUN_GAINS.sure * self.spread)

    @property
    def is_likely(self) -> bool:
        """Tell whether a gain is material and, where the windows are enough to tell, rather no chance; one never is."""
        doubt = FREE_RUN_GAINS.doubt * self.spread if self.windows >= FREE_RUN_GAINS.fewest else 0.0
        return self.windows > 1 and self.mean > max(FREE_RUN_GAINS.material, doubt)

    @property
    def is_loss(self) -> bool:
        """Tell whether unseen data are foretold worse, and rather not by chance."""
        return self.mean < -max(FREE_RUN_GAINS.material, FREE_RUN_GAINS.doubt * self.spread)

    @property
    def is_sure_loss(self) -> bool:
        """Tell whether unseen data are foretold worse, and not by chance."""
        return self.mean < -max(FREE_RUN_GAINS.material, FREE_RUN_GAINS.sure * self.spread)


def gain(before: Floats, after: Floats, floor: Floats) -> Gain:
    """Gain from mean squared errors `before` (windows, channels) to `after`; floor (channels,): of the noise floor.

    A channel without readings in a window is NaN there in both, and does not count.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        each = 0.5 * np.log((before + floor) / (after + floor))
    each = np.where(np.isfinite(before) & (floor > 0.0), each, 0.0)
    found = np.clip(
        np.nan_to_num(each, nan=-FREE_RUN_GAINS.most).sum(axis=1), -FREE_RUN_GAINS.most, FREE_RUN_GAINS.most
    )
    return Gain(float(found.mean()) if len(found) else 0.0, _spread_of_mean(found), len(found))


def _spread_of_mean(found: Floats) -> float:
    if len(found) < 2:
        return math.inf
    wider = float(student.ppf(SURE, len(found) - 1) / norm.ppf(SURE))
    return wider * float(found.std(ddof=1)) / math.sqrt(len(found))


@dataclass(frozen=True)
class FreeRuns:
    """Free runs by which models that were fitted to the same tracks are compared.

    They have errors of readings and stamps as `sensors`, rows (tracks, columns), for all models alike.
    """

    unseen: Unseen
    sensors: Floats

    @cached_property
    def channels(self) -> list[str]:
        """Channels of motion that readings show."""
        return [channel for channel in CHANNELS if against(channel, self.unseen.tracks) == "readings"]

    @cached_property
    def floor(self) -> Floats:
        """Mean squared errors (channels,) of the noise floor, never above those of the recalibrated model."""
        plain = self.errors_from_given_starts(self.unseen.rows)
        learnt = self._of(Model(self.unseen.rows, self.unseen.rows, self.unseen.starts, self.unseen.learnt))
        told = np.isfinite(plain).any(axis=0)
        means = np.zeros((2, len(self.channels)))
        means[:, told] = [np.nanmean(each[:, told], axis=0) for each in (plain, learnt)]
        return np.asarray(np.fmin(*means))

    @cached_property
    def _no_push(self) -> list[Floats]:
        return [NO_PUSH] * len(self.unseen.tracks)

    @cached_property
    def _counting(self) -> Floats:
        return with_errors_of(self.unseen, self.sensors)

    @cached_property
    def _starts(self) -> list[Floats]:
        """Starts of all models in which no other water moves."""
        return starts_under(self.unseen, self._counting)

    def errors(self, rows: Floats) -> Floats:
        """Mean squared errors (windows, channels) of a model, rows (tracks, columns), from starts as it reads them."""
        started = rows_at_start(self.unseen, rows, self._counting)
        starts = self._starts if np.array_equal(started, self._counting) else starts_under(self.unseen, started)
        return self._of(Model(rows, self._counting, starts, self._no_push))

    def errors_from_given_starts(self, rows: Floats) -> Floats:
        """Mean squared errors (windows, channels) of a model that begins as the recalibrated one does."""
        return self._of(Model(rows, self.unseen.rows, self.unseen.starts, self._no_push))

    def gain(self, before: Floats, after: Floats) -> Gain:
        """Gain from one model's mean squared errors (windows, channels) to another's."""
        return gain(before, after, self.floor)

    def _of(self, model: Model) -> Floats:
        found = []
        for number, span in self.unseen.windows():
            track, path = self.unseen.tracks[number], path_of(self.unseen.tracks[number], model, number, span)
            squares = (
                errors_of_readings(channel, track, path, model.sensors[number], span).mean_square
                for channel in self.channels
            )
            found.append(list(squares))
        return np.array(found, dtype=np.float64).reshape(len(found), len(self.channels))


def rows_without_held_out(fit: Fit, splits: Collection[Split], kept: Collection[str] = ()) -> Floats:
    """Rows (tracks, columns) of a fit after one Newton step, the held-out readings' part of score and information gone.

    kept: columns of unknowns that stay at their values from the whole fit.
    """
    known = information(fit)
    loose = [place for place, unknown in enumerate(fit.unknowns) if unknown.column not in kept]
    if not loose:
        return fit.filled
    matrix, gone = known.matrix.copy(), np.zeros(len(fit.unknowns))
    for track, split, passed, slope in zip(fit.tracks, splits, fit.passes, known.slopes, strict=True):
        held = _held(track, split)
        with np.errstate(over="ignore", invalid="ignore"):  # a model that runs away makes no step
            weighted = slope[held] / passed.variance[held, None]
            matrix -= slope[held].T @ weighted
            gone += weighted.T @ passed.innovation[held]
    # The fit is taken as finished: what is left of the score would move it as no likelihood did.
    unknowns, q = [fit.unknowns[place] for place in loose], fit.q.copy()
    free = np.array(loose)[not_held((known.score + gone)[loose], unknowns, q[loose])]
    q[free] += solve(matrix[np.ix_(free, free)], gone[free])
    q[loose] = clipped(unknowns, q[loose])
    return write_values(write_values(fit.rows, fit.unknowns, q), fit.noise, fit.q_noise)


def _held(track: Track, split: Split) -> Flags:
    """Flags (m,) of the readings of a track that lie in its held-out parts."""
    grid = track.timeline.grid
    found = np.zeros(len(track.timeline.stamp), dtype=bool)
    for span in split.held:
        begin, end = grid.begin + grid.step * span.first, grid.begin + grid.step * span.end
        found |= (track.timeline.stamp >= begin) & (track.timeline.stamp < end)
    return found
