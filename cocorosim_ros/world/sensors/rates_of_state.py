"""Readings that show a rate of the state itself, such as the turn rate or the velocity over ground."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.pose import Rates, When
from cocorosim_ros.world.terms.blocks import HORIZONTAL

# mypy: disable-error-code="no-any-return"


@kernel
def rate_after(column: int, when: When, row: Floats, rates: Rates) -> float:
    """A rate that stands in a column of the state, at a reading, by a Taylor series of second order."""
    return row[column] + when[1] * rates[0][column] + 0.5 * when[2] * rates[1][column]


@kernel
def by_level_rate(place: int, after: float, slope: float, rates: Floats, seen: Floats) -> None:
    """Add the derivative of a rate of the horizontal block, at a place of it, to `seen`, see sensor.Kind."""
    for column in range(HORIZONTAL):
        seen[column] = slope * (after * rates[place * HORIZONTAL + column])
    seen[place] += slope
