"""Main effects of all factors on one response, with the margin beyond which an effect is more than noise.

A screening has few runs in each setting; how much effects vary by chance is taken from the effects themselves, most of
which are noise: Lenth's pseudo standard error, from the main effects and from all contrasts that are left.
Source: Lenth 1989, Quick and easy analysis of unreplicated factorials, Technometrics 31:469-473; Montgomery 2013,
Design and Analysis of Experiments, section 6.5.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import stats

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.study.experiments.fraction import contrasts


@dataclass(frozen=True)
class MainEffects:
    """What each factor does to one response."""

    effects: Floats
    """(factors,) mean at the upper level less that at the lower one."""
    margin: float
    """Half of a 95 % interval of one of them."""

    def beyond(self, factor: int) -> bool:
        """Whether an effect is more than noise."""
        return bool(abs(self.effects[factor]) > self.margin)


def main_effects(responses: Floats, factors: int) -> MainEffects:
    """Of responses (settings,) of a folded screening; a setting without a response counts as the mean of the others."""
    filled = np.where(np.isnan(responses), np.nanmean(responses), responses)
    mains, left = (weights @ filled for weights in contrasts(factors))
    return MainEffects(mains, lenth_margin(np.concatenate([mains, left])))


def lenth_margin(effects: Floats) -> float:
    """Lenth's margin of error of orthogonal contrasts (n,)."""
    sizes = np.abs(effects)
    first = 1.5 * np.median(sizes)
    small = sizes[sizes < 2.5 * first] if first > 0.0 else sizes
    return float(stats.t.ppf(0.975, sizes.size / 3) * 1.5 * np.median(small))
