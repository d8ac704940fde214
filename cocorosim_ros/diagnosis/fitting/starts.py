"""Where the fit of a candidate begins: at what its slope promises, more cautiously, or at what a search finds.

A slope at nothing tells where a small fault leads. The likelihood of a delay is rough, as readings pass from one grid
point and one command to the next, and so a delay of several steps is seen only from near it: there a grid of values is
tried, and halves of its spacing around the best (compass search: Kolda, Lewis and Torczon, SIAM Review 45 (2003) 385).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.foundation.arrays import Floats

CAUTIOUS = 0.3
HALVINGS = 4


def best_start(at: Callable[[Floats], Fit], promised: Floats, candidate: Candidate) -> Fit:
    """The best of the fits that begin `at` these amplitudes (n,), in q."""
    best = max((at(promised), at(CAUTIOUS * promised)), key=lambda fit: fit.objective)
    grid = candidate.searched()
    return best if not grid else max(best, _found(at, grid), key=lambda fit: fit.objective)


def _found(at: Callable[[Floats], Fit], grid: Sequence[Floats]) -> Fit:
    """The best point of the grid, its values ascending, and then of halves of the spacing before it."""
    fits = [at(point) for point in grid]
    place = max(range(len(grid)), key=lambda index: fits[index].objective)
    best, middle = fits[place], grid[place]
    width = middle - grid[place - 1] if place > 0 else middle
    for _ in range(HALVINGS):
        width = 0.5 * width
        around = [(at(point), point) for point in (middle - width, middle + width)]
        best, middle = max([(best, middle), *around], key=lambda pair: pair[0].objective)
    return best
