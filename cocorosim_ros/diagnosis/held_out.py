"""What an addition to a model gains on stretches of the recordings that its fit did not see.

The recordings are cut into blocks. The estimate without a block follows from the fit by one Newton step with the
block's share of score and information taken out; the likelihood of the block there, with and without the addition,
differs by what the addition foretold. Source: leave-future-out and block validation for dependent data, Roberts et al.,
Ecography 40 (2017) 913; one-step leave-out after Pregibon, Annals of Statistics 9 (1981) 705.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import wilcoxon

from cocorosim_ros.diagnosis.fit import Fit, information, solve

Floats = NDArray[np.float64]
BLOCKS = 10  # of each recording


@dataclass(frozen=True)
class HeldOutGain:
    """nats (blocks,) that the addition gains on each block; p of no gain by the signed-rank test."""

    nats: Floats
    p: float

    @property
    def total(self) -> float:
        """Of all blocks."""
        return float(self.nats.sum())


def held_out_gain(base: Fit, more: Fit) -> HeldOutGain:
    """What `more` foretells better than `base`, both fitted to the same tracks."""
    nats = _foretold(more) - _foretold(base)
    p = 1.0 if np.allclose(nats, 0.0) else float(wilcoxon(nats, alternative="greater").pvalue)
    return HeldOutGain(nats, p)


def _foretold(fit: Fit) -> Floats:
    """(blocks,) log-likelihood of each block under the fit to all others."""
    known = information(fit)
    found = []
    for track, part, slope in zip(fit.tracks, fit.passes, known.slopes, strict=True):
        begin, length = track.readings.begin, track.readings.step * track.readings.points
        block = np.minimum(((track.readings.stamp - begin) / length * BLOCKS).astype(np.int64), BLOCKS - 1)
        for number in range(BLOCKS):
            chosen = block == number
            innovation, variance, moved = part.innovation[chosen], part.variance[chosen], slope[chosen]
            if len(fit.laws):
                weighted = moved / variance[:, None]
                score = known.score + weighted.T @ innovation
                shift = solve(known.matrix - moved.T @ weighted, score)
                innovation = innovation + moved @ shift
            found.append(-0.5 * float(np.sum(innovation**2 / variance + np.log(variance))))
    return np.array(found)
