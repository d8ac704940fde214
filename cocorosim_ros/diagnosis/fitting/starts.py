"""Starts for the fit of a candidate: the amplitudes that its slope promises, a part of them, or those of a search.

The slope at zero tells where a small fault leads. The likelihood of a delay is rough, because readings pass from one
grid point, and from one command, to the next, and so a delay of several steps is seen only from near it. For delays a
grid of values is tried, then half, a quarter, ... of its spacing around the best (compass search: Kolda, Lewis and
Torczon, SIAM Review 45 (2003) 385). Nor is the likelihood of a dead band smooth: it is level between one command and
the next larger one. So the search stays where it is unless it gains.

The likelihood of a scale is flat where exact readings lie beyond the filter's gate, and its summit is narrow. It is
found from readings that count as if they were far less exact, of which none lies beyond the gate, and by degrees more
exact.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.filter.layout import KINDS_OF_STREAM
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.climbing import improved
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE_OF_KIND
from cocorosim_ros.foundation.arrays import Floats

SPACING_HALVINGS = 4


def best_start(at: Callable[[Floats], Fit], promised: Floats, candidate: Candidate) -> Fit:
    """Find the start with the greatest objective.

    at: makes and evaluates a fit with these amplitudes (n,), in q; promised: the amplitudes that the screening found.
    """
    best = max((at(promised), at(STEPS.cautious * promised)), key=lambda fit: fit.objective)
    grid = candidate.searched()
    return best if not grid else max(best, _found(at, grid), key=lambda fit: fit.objective)


def by_softer_readings(fit: Fit, topic: str, first: int, count: int) -> Floats:
    """Amplitudes (count,) of an error of a topic that climbs from a fit find, its readings softer at first.

    first: place of the first amplitude in the fit's q.
    """
    own = {f"reading.{READING_NOISE_OF_KIND[kind]}" for kind in KINDS_OF_STREAM[topic]}
    soft = np.array([math.log(STEPS.softest) if unknown.column in own else 0.0 for unknown in fit.noise])
    climbed = fit
    for share in STEPS.softer:
        climbed = improved(evaluated(replace(climbed, q_noise=fit.q_noise + share * soft)), STEPS.soft_rounds)
    return climbed.q[first : first + count]


def _found(at: Callable[[Floats], Fit], grid: Sequence[Floats]) -> Fit:
    """Find the best point of an ascending grid, then of steps to both sides of it that are halved each time."""
    fits = [at(point) for point in grid]
    heights = [fit.objective for fit in fits]
    place = heights.index(max(heights))
    level = STEPS.level * np.ptp(heights)
    best, middle = fits[place], grid[place]
    width = middle - grid[place - 1] if place > 0 else middle
    for _ in range(SPACING_HALVINGS):
        width = 0.5 * width
        around = [(at(point), point) for point in (middle - width, middle + width)]
        better, point = max(around, key=lambda pair: pair[0].objective)
        if better.objective > best.objective + level:
            best, middle = better, point
    return best
