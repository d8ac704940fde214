"""Intervals of a following, by the scatter of blocks: what is left over hangs together from report to report.

So blocks of the recording that are long beside its memory are left out in turn. By how much the solution moves tells
how sure it is, whatever the colour of the residual (a jackknife by blocks; Tukey 1958, Kuensch 1989). Blocks in which
nothing changes tell nothing of times, so that they give no degrees of freedom.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.stats import t as student

from cocorosim_ros.diagnosis.criteria.following import FOLLOWING
from cocorosim_ros.diagnosis.evidence.following.misfit import Following, blocks_of
from cocorosim_ros.diagnosis.evidence.following.search import DEAD_TIME, GAIN, RATE, TIME_CONSTANT
from cocorosim_ros.foundation.arrays import Floats, Integers


@dataclass(frozen=True)
class Spread:
    """Covariance (4, 4) of delay, time constant, rate and gain; rows of a rate without limit are zero.

    changes, levels: how many blocks of equal weight tell of the times, and of the gain.
    """

    covariance: Floats
    changes: float
    levels: float

    def half_width(self, weights: Floats, blocks: float) -> float:
        """Half of the 95 % interval of a sum with these weights (4,), of which so many blocks tell."""
        quantile = float(student.ppf(0.975, max(blocks - 1.0, 1.0)))
        return quantile * math.sqrt(max(float(weights @ self.covariance @ weights), 0.0))


def spread_of(following: Following, lateness: Floats) -> Spread:
    """The spread of a solution (3,)."""
    line = following.line(lateness)
    interval = float(np.median(np.concatenate([np.diff(each.time) for each in following.stretches])))
    away = line.shown - line.shown.mean()
    late = _change(following, lateness, DEAD_TIME, 0.5 * interval)
    free = [DEAD_TIME, TIME_CONSTANT, *([RATE] if np.isfinite(lateness[RATE]) else []), GAIN]
    slopes = {
        DEAD_TIME: line.gain * late,
        TIME_CONSTANT: line.gain * _change(following, lateness, TIME_CONSTANT, 0.5 * interval),
        GAIN: away,
    }
    if RATE in free:
        slopes[RATE] = line.gain * _change(following, lateness, RATE, 0.01 * lateness[RATE])
    columns = np.column_stack([*(slopes[place] for place in free), np.ones(len(away))])
    shortest = _length_of_blocks(following, lateness, line.left, interval)
    block = blocks_of(following.stretches, shortest)
    covariance = np.zeros((GAIN + 1, GAIN + 1))
    covariance[np.ix_(free, free)] = _jackknife(columns, line.left, block)[: len(free), : len(free)]
    return Spread(covariance, _of_equal_weight(late**2, block), _of_equal_weight(away**2, block))


def _change(following: Following, lateness: Floats, column: int, step: float) -> Floats:
    """(n,) difference quotient of the response by a column of the lateness.

    Over half an interval of the reports: within less than that no report falls on a step of the response.
    """
    high, low = lateness.copy(), lateness.copy()
    high[column] += step
    half = 0.5 * lateness[column]
    low[column] = max(low[column] - step, half)
    return np.asarray((following.response(high) - following.response(low)) / (high[column] - low[column]))


def _length_of_blocks(following: Following, lateness: Floats, left: Floats, interval: float) -> float:
    """Length of the blocks [s]: long beside the memory of what is left over (n,), but enough of them."""
    whole = sum(float(np.ptp(each.time[each.settled])) for each in following.stretches if each.settled.any())
    wanted = max(
        FOLLOWING.shortest_block,
        FOLLOWING.fewest_in_block * interval,
        FOLLOWING.memories * interval * _memory(left),
        FOLLOWING.memories * float(lateness[DEAD_TIME] + lateness[TIME_CONSTANT]),
    )
    return max(FOLLOWING.shortest_block, min(wanted, whole / FOLLOWING.fewest_blocks))


def _memory(left: Floats) -> int:
    """Number of reports after which what is left over (n,) hangs together by less than 1/e."""
    spectrum = np.abs(np.fft.rfft(left, 2 * len(left))) ** 2
    together = np.fft.irfft(spectrum)[: len(left)]
    return int(np.argmax(together < np.exp(-1.0) * together[0]))


def _jackknife(columns: Floats, left: Floats, block: Integers) -> Floats:
    """Covariance (p, p) of the coefficients of columns (n, p) whose residual is `left` (n,), by blocks (n,).

    By how much the coefficients move when a block is left out, each in turn.
    """
    size = np.sqrt((columns**2).sum(axis=0))
    size[size == 0.0] = 1.0
    scaled = columns / size
    count = int(block.max()) + 1
    whole = scaled.T @ scaled
    moved = np.zeros((count, columns.shape[1]))
    for number in range(count):
        rows = scaled[block == number]
        without = np.linalg.pinv(whole - rows.T @ rows, hermitian=True)
        moved[number] = without @ (rows.T @ left[block == number])
    return np.asarray(moved.T @ moved * (count - 1) / count / np.outer(size, size))


def _of_equal_weight(weight: Floats, block: Integers) -> float:
    """The number of blocks of equal weight that tell as much as these; weight (n,) of each report."""
    sums = np.bincount(block, weights=weight)
    total = float(sums @ sums)
    return float(sums.sum()) ** 2 / total if total > 0.0 else 0.0
