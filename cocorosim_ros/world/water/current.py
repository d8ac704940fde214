"""What a current is: one small compiled function that says how fast the water moves."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class Current:
    """One field of water velocity.

    `velocity(place, time, parameters, total)` adds the velocity of the water at `place` (3,) [m; world] and `time`
    [s since the start of the run] to `total` (3,) [m/s; world]. `parameters` are the numbers named below in this
    order, SI units; a current with a table of values (gridded) names none and lays them out by itself.
    `fastest(parameters, size)` is a speed [m/s] that the water nowhere exceeds at any time in a tank of `size` x, y,
    depth [m] around the world's origin; integrators take their longest step from it.
    """

    summary: str
    velocity: Callable[..., Any]
    parameters: tuple[str, ...]
    fastest: Callable[[Floats, tuple[float, float, float]], float]
