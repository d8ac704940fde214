"""Velocity that swings in time, the same everywhere: (x, y) sin(2 pi t / period + phase)."""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.water.current import Current


@kernel
def tidal(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the amplitude x, y [m/s; world] times the sine of the tide; period [s], phase [rad]."""
    x, y, period, phase = unpack(parameters, 4)
    swing, _ = sine_cosine(2.0 * math.pi * time / period + phase)
    total[0] += x * swing
    total[1] += y * swing


def fastest(parameters: Floats, size: tuple[float, float, float]) -> float:
    """The amplitude [m/s]."""
    x, y, _, _ = parameters
    return math.hypot(x, y)


TIDAL = Current(
    summary="velocity that swings in time, the same everywhere",
    velocity=tidal,
    parameters=("x", "y", "period", "phase"),
    fastest=fastest,
)
