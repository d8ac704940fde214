"""What the robots' instruments show at one tick, in the units of the topics."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats


class Readings(NamedTuple):
    """One tick of all sensors of all robots; leading axes (runs, robots).

    A NamedTuple and not a dataclass because compiled loops take it as it is.
    """

    compass: Floats  # (runs, robots) heading in (-pi, pi] [rad; world]
    pressure: Floats  # (runs, robots) absolute [Pa]
    angular_rate: Floats  # (runs, robots, 3) [rad/s; body]
    specific_force: Floats  # (runs, robots, 3) [m/s^2; body], +9.81 upwards at rest
    velocity: Floats  # (runs, robots, 4) u v w r through the water [m/s, rad/s; body], NaN where not measured
    neighbour_range: Floats  # (runs, robots, sensors) [m], +inf for none
    obstacle_range: Floats  # (runs, robots, sensors) [m], +inf for none
    illuminance: Floats  # (runs, robots) ambient light [lx], NaN where nobody asks for it
    concentration: Floats  # (runs, robots) of the plume [kg/m^3], NaN where nobody asks for it


def blank_readings(runs: int, robots: int, sensors: int) -> Readings:
    """Readings of the given sizes, NaN everywhere until they are measured."""
    return Readings(
        compass=np.full((runs, robots), np.nan),
        pressure=np.full((runs, robots), np.nan),
        angular_rate=np.full((runs, robots, 3), np.nan),
        specific_force=np.full((runs, robots, 3), np.nan),
        velocity=np.full((runs, robots, 4), np.nan),
        neighbour_range=np.full((runs, robots, sensors), np.nan),
        obstacle_range=np.full((runs, robots, sensors), np.nan),
        illuminance=np.full((runs, robots), np.nan),
        concentration=np.full((runs, robots), np.nan),
    )
