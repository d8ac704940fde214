"""Chemical sensor: the concentration of the plume's substance at the robot's centre, exact and without delay."""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.kernel import kernel


@kernel
def measure_concentration(present: Floats, wanted: Flags, reading: Floats) -> None:
    """Write the concentration `present` (runs, robots) [kg/m^3] of those who are `wanted` (robots,) into `reading`."""
    for run in range(reading.shape[0]):
        for robot in range(reading.shape[1]):
            reading[run, robot] = present[run, robot] if wanted[robot] else math.nan
