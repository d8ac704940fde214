"""Velocity from an ocean model: a table over x, y, z and time, as gridded (water.ocean makes it)."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.water.current import Current
from cocorosim_ros.world.water.currents.gridded import fastest, gridded


@kernel
def ocean(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the interpolated velocity."""
    gridded(place, time, parameters, total)


OCEAN = Current(
    summary="velocity from a file of an ocean model: CMEMS, HYCOM, ROMS", velocity=ocean, parameters=(), fastest=fastest
)
