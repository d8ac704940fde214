"""The random force of the water: a stationary process between Ornstein-Uhlenbeck and Matern-3/2.

    df = (-a f + c g) dt,   dg = -b g dt + sqrt(2 b) dW,   c = sqrt(a (a + b))

Force f and gust g have variance 1 and covariance a / c. The correlation time is T = 1/a + 1/b, the integral of the
autocorrelation; the smoothness p = 4 a b / (a + b)^2 is 1 for Matern-3/2 and goes to 0 for Ornstein-Uhlenbeck, whose
force jumps. Under a force of the wrong smoothness, a lag that is not there seems to explain readings.
Source: Hartikainen and Sarkka, IEEE MLSP (2010) 379; Rasmussen and Williams (2006), eq. 4.17 and B.27.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.foundation.compiling.kernel import kernel

EQUAL = 1e-3  # difference of the two rates times the step; below it a series replaces a quotient


class Fading(NamedTuple):
    """Transition of force and gust, both of variance 1, over a step of the grid."""

    kept: float  # force of force
    fed: float  # force of gust
    gust: float  # gust of gust
    common: float  # covariance of both
    new_force: float  # new variance of the force
    new_common: float
    new_gust: float


@kernel
def fading(step: float, correlation: float, smoothness: float) -> Fading:
    """Transition over `step` [s], for a correlation time [s] and a smoothness in (0, 1]."""
    middle = 2.0 / (smoothness * correlation)
    half = middle * math.sqrt(max(1.0 - smoothness, 0.0))
    slow, fast = middle - half, middle + half
    drive = math.sqrt(slow * 2.0 * middle)
    kept, gust = math.exp(-slow * step), math.exp(-fast * step)
    if half * step > EQUAL:
        fed = drive * (kept - gust) / (2.0 * half)
    else:
        fed = drive * step * math.exp(-middle * step) * (1.0 + (half * step) ** 2 / 6.0)
    common = slow / drive
    ahead = kept * common + fed
    new_force = 1.0 - kept * kept - 2.0 * kept * fed * common - fed * fed
    return Fading(kept, fed, gust, common, new_force, common - gust * ahead, 1.0 - gust * gust)
