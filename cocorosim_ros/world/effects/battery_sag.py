"""Thrust that falls as the battery empties: F (1 - fraction_lost t / duration), and no further after `duration`.

Assumes: the charge is used evenly, and the thrust follows it in a straight line.
"""

from __future__ import annotations

from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.effect import Effect, Parameter


@kernel
def battery_sag(fraction: Floats, fitting: Any, time: float, parameters: Floats) -> None:
    """Weaken the thrusters by what is lost by `time` [s]."""
    used = min(max(time / parameters[1], 0.0), 1.0)
    for actuator in range(fraction.shape[0]):
        if not fitting.is_pump[actuator]:
            fraction[actuator] *= 1.0 - parameters[0] * used


BATTERY_SAG = Effect(
    summary="thrust falls as the battery empties",
    command=battery_sag,
    parameters=(
        Parameter("fraction_lost", "1", "of the thrust, at the end"),
        Parameter("duration", "s", "from the start to the end", 600.0, "positive", needed=True),
    ),
)
