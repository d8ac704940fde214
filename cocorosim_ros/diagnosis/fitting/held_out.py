"""Held-out gain: the nats that an addition to a model gains on blocks of the recordings that its fit did not see.

The recordings are cut into blocks. The estimate without a block follows from the fit by one Newton step with the
block's share of score and information taken out. The likelihood of the block at this estimate, with the addition and
without, differs by what the addition foretold. Where that step leaves the range of its slopes, the filter is run
again, as far along it as the other readings allow. The moment of an event that happens once is kept from the whole
fit, because no other block tells of it.
Source: leave-future-out and block validation for dependent data, Roberts et al., Ecography 40 (2017) 913; one-step
leave-out after Pregibon, Annals of Statistics 9 (1981) 705.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from scipy.stats import wilcoxon

from cocorosim_ros.diagnosis.criteria.fitting import HELD_OUT
from cocorosim_ros.diagnosis.fitting.climbing import STEP_HALVINGS
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, information
from cocorosim_ros.diagnosis.fitting.solving import clipped, solve
from cocorosim_ros.foundation.arrays import Flags, Floats


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
        parts = fit.tracks[place].timeline.parts(HELD_OUT.blocks)
        for number in range(HELD_OUT.blocks):
            block = Block(place, parts == number)
            innovation, variance = passed.innovation[block.readings], passed.variance[block.readings]
            moved = slope[block.readings][:, loose]
            nats = _nats(innovation, variance)
            if loose.any():
                weighted = moved / variance[:, None]
                score = known_score + weighted.T @ innovation
                shift = solve(matrix - moved.T @ weighted, score)
                foretold = _nats(innovation + moved @ shift, variance)
                nats = foretold if nats - foretold < HELD_OUT.curved else _stepped(fit, block, loose, shift)
            found.append(nats)
    return np.array(found)


class Block(NamedTuple):
    """Readings of a block, as marks (m,) of all readings of a track."""

    track: int
    readings: Flags

    def nats(self, fit: Fit) -> float:
        """Log-likelihood of the block under a fit [nats], up to a constant."""
        passed = fit.passes[self.track]
        return _nats(passed.innovation[self.readings], passed.variance[self.readings])


def _nats(innovation: Floats, variance: Floats) -> float:
    return -0.5 * float(np.sum(innovation**2 / variance + np.log(variance)))


def _stepped(fit: Fit, block: Block, loose: Flags, shift: Floats) -> float:
    """Log-likelihood of a block after a step that is halved until all other readings are explained better by it.

    A number that this block alone tells moves so far without it that slopes do not hold on the way, so that the filter
    is run again. Where no half of the step helps the others, the block is foretold by the fit itself.
    """
    step = np.zeros(len(fit.q))
    step[loose] = shift
    others = fit.objective - block.nats(fit)
    for halving in range(STEP_HALVINGS):
        moved = evaluated(replace(fit, q=clipped(fit.unknowns, fit.q + step / 2.0**halving)))
        if moved.objective - block.nats(moved) > others:
            return block.nats(moved)
    return block.nats(fit)
