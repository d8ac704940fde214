"""How many runs make chance small: the procedure of Read et al. 2011, section 4.3.2, on runs that differ by chance.

Twenty sets of n runs each of the very same settings; the first is compared with each of the others by A, folded
to >= 0.5. n is enough when the largest of the 19 scores stays below 0.56, a small effect.
For continuous responses the scores are distribution-free: the procedure needs no simulation at all.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.analysis.effect_size import SMALL, vargha_delaney

Floats = NDArray[np.float64]

SETS = 20


@dataclass(frozen=True)
class Consistency:
    """What the procedure gives at one sample size."""

    runs: int
    median_of_largest: float
    """Median, over many repetitions of the procedure, of the largest score."""
    enough: float
    """Share of repetitions in which the largest score stays below a small effect."""


def consistency_scores(sets: Floats) -> Floats:
    """Folded scores (len(sets) - 1,) of the first of `sets` (sets, runs) against each other."""
    scores = np.array([vargha_delaney(sets[0], other) for other in sets[1:]])
    folded: Floats = np.maximum(scores, 1.0 - scores)
    return folded


def consistency_by_chance(runs: int, repetitions: int, random: np.random.Generator) -> Consistency:
    """The procedure repeated on a continuous response that nothing influences."""
    largest = np.array([consistency_scores(random.random((SETS, runs))).max() for _ in range(repetitions)])
    return Consistency(runs, float(np.median(largest)), float(np.mean(largest < SMALL)))


def consistency_of(values: Floats, runs: int, random: np.random.Generator) -> Consistency:
    """The procedure once, on sets drawn with replacement from the runs of one group; for responses with ties."""
    known = values[~np.isnan(values)]
    scores = consistency_scores(random.choice(known, (SETS, runs)))
    return Consistency(runs, float(scores.max()), float(scores.max() < SMALL))
