"""Light in the water: a background and lamps around each of which it fades as a bell curve.

E(x) = background + sum over lamps of peak * exp(-|x - x_lamp|^2 / (2 width^2)), in lux. A cue for aggregation; not
a model of how water absorbs and scatters.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel


class Lamps(NamedTuple):
    """All light there is."""

    background: float  # lx
    lamp: Floats  # (lamps, 5) x, y, z [m; world], illuminance at the lamp [lx], width [m]


def darkness() -> Lamps:
    """No light at all."""
    return Lamps(0.0, np.zeros((0, 5)))


@kernel
def illuminance_at(lamps: Lamps, place: Floats) -> float:
    """Illuminance [lx] at `place` (3,) [m; world]."""
    total = lamps.background
    for index in range(lamps.lamp.shape[0]):
        lamp = lamps.lamp[index]
        squared = 0.0
        for axis in range(3):
            squared += (place[axis] - lamp[axis]) ** 2
        total += lamp[3] * math.exp(-0.5 * squared / lamp[4] ** 2)
    return total
