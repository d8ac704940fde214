"""Length of free runs: some of the times in which the recalibrated vehicle coasts, shorter if it spins."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUNS
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.world.state.state import YAW_RATE


def window_length(coasting: float, courses: Sequence[Smoothed]) -> float:
    """Choose the length of a free run [s]: that of FREE_RUNS.lengths next to the wanted number of coasting times [s].

    It is shorter where the robots would turn by more than FREE_RUNS.most_turned in it.
    """
    turned = np.concatenate([course.mean[:, YAW_RATE] for course in courses])
    rate = float(np.sqrt(np.mean(turned**2)))
    wanted = FREE_RUNS.coasted * coasting
    near = min(FREE_RUNS.lengths, key=lambda seconds: abs(math.log(seconds) - _log(wanted)))
    told = [seconds for seconds in FREE_RUNS.lengths if seconds <= near and seconds * rate <= FREE_RUNS.most_turned]
    return max(told, default=FREE_RUNS.lengths[0])


def _log(seconds: float) -> float:
    """Logarithm of a wanted length [s], that of the shortest or the longest free run where it lies beyond them."""
    return math.log(min(max(seconds, FREE_RUNS.lengths[0]), FREE_RUNS.lengths[-1]))
