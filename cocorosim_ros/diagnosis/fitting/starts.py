"""Starts for the fit of a candidate: the amplitudes that its slope promises, a part of them, or those of a search.

The slope at zero tells where a small fault leads. The likelihood of a delay is rough, because readings pass from one
grid point, and from one command, to the next, and so a delay of several steps is seen only from near it. Of a scale it
is flat where all readings lie beyond the gate. For these a grid of values is tried, then half, a quarter, ... of its
spacing around the best (compass search: Kolda, Lewis and Torczon, SIAM Review 45 (2003) 385).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.foundation.arrays import Floats

SPACING_HALVINGS = 4


def best_start(at: Callable[[Floats], Fit], promised: Floats, candidate: Candidate) -> Fit:
    """Find the start with the greatest objective.

    at: makes and evaluates a fit with these amplitudes (n,), in q; promised: the amplitudes that the screening found.
    """
    best = max((at(promised), at(STEPS.cautious * promised)), key=lambda fit: fit.objective)
    grid = candidate.starts()
    return best if not grid else max(best, _found(at, grid), key=lambda fit: fit.objective)


def _found(at: Callable[[Floats], Fit], grid: Sequence[Floats]) -> Fit:
    """Find the best point of an ascending grid, then of steps to both sides of it that are halved each time."""
    fits = [at(point) for point in grid]
    place = max(range(len(grid)), key=lambda index: fits[index].objective)
    best, middle = fits[place], grid[place]
    width = middle - grid[place - 1] if place > 0 else middle
    for _ in range(SPACING_HALVINGS):
        width = 0.5 * width
        around = [(at(point), point) for point in (middle - width, middle + width)]
        best, middle = max([(best, middle), *around], key=lambda pair: pair[0].objective)
    return best
