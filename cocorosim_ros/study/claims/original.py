"""The released CoCoRoSim's own figures beside runs of the design `boids_released`.

Each figure is the median of a few runs of the original. What such a median can be by chance is drawn from our runs: it
agrees when it lies within the middle 95 % of medians of as many of them. The original's figures say neither how they
are taken over time nor, for speeds, of which centre; the columns are those of our readings that fit them best in kind:
medians over time for polarisation, angular momentum and separation, the mean for the number of shoals.
Source: the released model run in NetLogo 3D 4.1.3 beside ours, with the paper's weights (1, 1, 10), 0.15 m, 270
degrees, 6 x 6 x 2.2 m and 25,000 ticks, 4 runs a group; cocorosim-facts 8.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

from cocorosim_ros.study.results.results import Results, Spread

DESIGN = "boids_released"
RUNS_OF_ORIGINAL = 4
_DRAWS = 4000
_MIDDLE = (0.025, 0.975)
_SEED = 2013


@dataclass(frozen=True)
class Figure:
    """One number that the original gave."""

    group: str
    column: str
    """Of the table of results."""
    text: str
    """As it was noted, in the unit of the column."""

    @property
    def value(self) -> float:
        """The number."""
        return float(self.text)

    @property
    def rounding(self) -> float:
        """Half a unit of its last digit."""
        return 0.5 * 10.0 ** int(Decimal(self.text).as_tuple().exponent)


@dataclass(frozen=True)
class Comparison:
    """A figure of the original beside our runs."""

    figure: Figure
    ours: Spread
    low: float
    high: float
    """Between these lie 95 % of the medians of as many of our runs as the original has."""

    @property
    def agrees(self) -> bool:
        """Whether the original's figure, as far as its digits tell, lies within what chance allows."""
        return self.low - self.figure.rounding <= self.figure.value <= self.high + self.figure.rounding


def _figures(group: str, numbers: str) -> tuple[Figure, ...]:
    columns = (
        "polarisation_time_median",
        "angular_momentum_raw_median_centre_time_median",
        "separation_time_median",
        "lost",
        "shoals_time_mean",
    )
    return tuple(Figure(group, column, text) for column, text in zip(columns, numbers.split(), strict=True))


FIGURES: tuple[Figure, ...] = (
    *_figures("Van", "0.12 0.80 0.27 6 1.6"),
    Figure("Van", "shoal_speed_median_centre_time_mean", "0.0223"),
    *_figures("BLT", "0.9995 0.273 0.249 1 1.18"),
    Figure("BLT", "shoal_speed_time_median", "0.02367"),
    *_figures("BLC", "0.81 2.2 0.51 14 2.5"),
    *_figures("NA", "0.14 1.4 2.05 12 3.4"),
    Figure("NA", "shoal_speed_time_median", "0.0011"),
)


def comparisons(results: Results, numerics: str) -> Iterator[Comparison]:
    """Every figure beside the runs of its group; those of groups without runs are left out."""
    draw = np.random.default_rng(_SEED)
    for figure in FIGURES:
        values = results.values(numerics, figure.group, figure.column)
        known = values[~np.isnan(values)]
        if known.size:
            medians = np.median(draw.choice(known, (_DRAWS, RUNS_OF_ORIGINAL)), axis=1)
            low, high = np.quantile(medians, _MIDDLE)
            yield Comparison(figure, results.spread(numerics, figure.group, figure.column), float(low), float(high))
