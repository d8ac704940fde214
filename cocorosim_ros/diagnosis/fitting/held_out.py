"""Held-out gain: the nats that an addition to a model gains on blocks of the recordings that its fit did not see.

The recordings are cut into blocks. The estimate without a block follows from the fit by one Newton step with the
block's share of score and information taken out. The likelihood of the block at this estimate, with the addition and
without, differs by what the addition foretold. The moment of an event that happens once is kept from the whole fit,
because no other block tells of it.
Source: leave-future-out and block validation for dependent data, Roberts et al., Ecography 40 (2017) 913; one-step
leave-out after Pregibon, Annals of Statistics 9 (1981) 705.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

import numpy as np
from scipy.stats import wilcoxon

from cocorosim_ros.diagnosis.criteria.fitting import HELD_OUT
from cocorosim_ros.diagnosis.fitting.fit import Fit, information
from cocorosim_ros.diagnosis.fitting.solving import solve
from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class HeldOutGain:
    """Gain of an addition on each block, nats (blocks,), and p of no gain by Wilcoxon's signed-rank test."""

    nats: Floats
    p: float

    @property
    def total(self) -> float:
        """Gain on all blocks together [nats]."""
        return float(self.nats.sum())


def held_out_gain(
    base: Fit, more: Fit, kept: Collection[str] = (), among: Collection[int] | None = None
) -> HeldOutGain:
    """Measure how much better `more` foretells held-out blocks than `base`, both fitted to the same tracks.

    kept: columns of unknowns that stay at their values from the whole fit. among: numbers of the tracks of which blocks
    are held out; None: all.
    """
    tracks = range(len(base.tracks)) if among is None else sorted(among)
    nats = _foretold(more, kept, tracks) - _foretold(base, kept, tracks)
    p = 1.0 if np.allclose(nats, 0.0) else float(wilcoxon(nats, alternative="greater").pvalue)
    return HeldOutGain(nats, p)


def _foretold(fit: Fit, kept: Collection[str], tracks: Iterable[int]) -> Floats:
    """Log-likelihood of each block under the fit to all others [nats], up to a constant: (tracks * blocks,).

    tracks: numbers of those whose blocks are meant.
    """
    known = information(fit)
    loose = np.array([unknown.column not in kept for unknown in fit.unknowns], dtype=bool)
    matrix, known_score = known.matrix[np.ix_(loose, loose)], known.score[loose]
    found = []
    for place in tracks:
        passed, slope = fit.passes[place], known.slopes[place]
        block = fit.tracks[place].timeline.parts(HELD_OUT.blocks)
        for number in range(HELD_OUT.blocks):
            chosen = block == number
            innovation, variance = passed.innovation[chosen], passed.variance[chosen]
            moved = slope[chosen][:, loose]
            if loose.any():
                weighted = moved / variance[:, None]
                score = known_score + weighted.T @ innovation
                shift = solve(matrix - moved.T @ weighted, score)
                innovation = innovation + moved @ shift
            found.append(-0.5 * float(np.sum(innovation**2 / variance + np.log(variance))))
    return np.array(found)
