"""How many runs make chance small: the procedure of Read et al. 2011, section 4.3.2, on runs that differ by chance.

Twenty sets of n runs each of the very same settings; the first is compared with each of the others by A, folded
to >= 0.5. n is enough when the largest of the 19 scores, over all responses, stays below 0.56, a small effect.
For one continuous response the scores are distribution-free, and no simulation is needed; ties make them smaller,
several responses make the largest of them larger. Once through, the procedure's outcome is itself a matter of chance:
here it is repeated.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy import stats

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.study.results.effect_size import SMALL
from cocorosim_ros.study.results.results import Results

SETS = 20
SIZES = (1, 5, 10, 50, 100, 200, 300, 400, 500)
"""Runs in a set, as the released analysis of the paper's model tries them."""
REPETITIONS = 100


@dataclass(frozen=True)
class Consistency:
    """What the procedure gives at one sample size."""

    runs: int
    each: tuple[float, ...]
    """Median, over many repetitions of the procedure, of the largest score of each response."""
    median_of_largest: float
    """The same of the largest score over all responses."""
    enough: float
    """Share of repetitions in which the largest score over all responses stays below a small effect."""
    repetitions: int

    @property
    def enough_interval(self) -> tuple[float, float]:
        """Wilson's 95 % interval of that share."""
        test = stats.binomtest(round(self.enough * self.repetitions), self.repetitions)
        low, high = test.proportion_ci(0.95, "wilson")
        return float(low), float(high)


def consistency_scores(sets: Floats) -> Floats:
    """Folded scores (len(sets) - 1,) of the first of `sets` (sets, runs) against each other."""
    first, others = np.sort(sets[0]), np.sort(sets[1:], axis=1)  # searching is faster in order
    twice = np.searchsorted(first, others, "left").sum(axis=1) + np.searchsorted(first, others, "right").sum(axis=1)
    scores = twice / (2 * first.size**2)
    folded: Floats = np.maximum(scores, 1.0 - scores)
    return folded


def consistency_by_chance(runs: int, repetitions: int, random: np.random.Generator) -> Consistency:
    """The procedure on one continuous response that nothing influences."""
    largest = [[consistency_scores(random.random((SETS, runs))).max()] for _ in range(repetitions)]
    return _summed_up(runs, np.array(largest))


@lru_cache
def median_by_chance(runs: int) -> float:
    """Median of the largest score of one continuous response that nothing influences; the draws are always the same."""
    return consistency_by_chance(runs, REPETITIONS, np.random.default_rng(0)).median_of_largest


def consistency_of(
    values: Floats, runs: int, random: np.random.Generator, repetitions: int = REPETITIONS
) -> Consistency:
    """The procedure on sets that are drawn, with replacement, from the runs of one group.

    Args:
        values: (responses, runs there), without NaN; a run that is drawn brings all its responses, as they depend on
            each other.
        runs: in each set.
        random: what draws.
        repetitions: of the procedure.
    """
    largest = np.empty((repetitions, len(values)))
    for row in largest:
        drawn = random.integers(values.shape[1], size=(SETS, runs))
        row[:] = [consistency_scores(response[drawn]).max() for response in values]
    return _summed_up(runs, largest)


def _summed_up(runs: int, largest: Floats) -> Consistency:
    """Of the largest scores (repetitions, responses)."""
    overall = largest.max(axis=1)
    each = tuple(float(median) for median in np.median(largest, axis=0))
    return Consistency(runs, each, float(np.median(overall)), float(np.mean(overall < SMALL)), len(largest))


def baseline_consistency(results: Results, numerics: str, metrics: Sequence[str]) -> list[Consistency]:
    """The procedure on the metrics of the baseline's runs, for every size of a set of which there are enough runs.

    Runs in which a metric is undefined are left out. The draws are the same every time.
    """
    values = np.stack([results.values(numerics, results.baseline, metric) for metric in metrics])
    known = values[:, ~np.isnan(values).any(axis=0)]
    random = np.random.default_rng(0)
    return [consistency_of(known, size, random) for size in SIZES if size <= known.shape[1]]
