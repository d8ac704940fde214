"""Curves of the pictures: what an effect or an error does along an axis, computed by its own function."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.effect import Description
from site_builder.axes import Axis

VARIES = 1e-6  # of the largest value: what changes by less along an axis does not depend on it
ROUNDING = 1e-12  # in SI units: less is nothing


class Curve(NamedTuple):
    """Values along an axis, with the numbers of the example and with neutral ones."""

    axis: Axis
    label: str  # of the values, beside their axis
    unit: str
    caption: str
    with_it: Floats  # (POINTS,) [unit]
    without: Floats  # (POINTS,) [unit]

    @property
    def shows(self) -> bool:
        """Tell whether the two differ anywhere."""
        return bool(np.any(np.abs(self.with_it - self.without) > ROUNDING))


def examples(described: Description) -> Floats:
    """(numbers,) of an effect, as in its example."""
    return np.array(
        [number.neutral if number.example is None else number.example.value for number in described.numbers]
    )


def neutrals(described: Description) -> Floats:
    """(numbers,) of an effect, where it does nothing."""
    return np.array([number.neutral for number in described.numbers])


def varies(values: Floats) -> bool:
    """Tell whether values along an axis change."""
    return bool(np.ptp(values) > max(VARIES * np.abs(values).max(), ROUNDING))
