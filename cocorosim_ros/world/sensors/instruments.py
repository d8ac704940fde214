"""The numbers of every robot's instruments, laid out for compiled loops."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers


class Instruments(NamedTuple):
    """Instruments with leading axis (robots,); the same in every run.

    Sensors that a robot lacks have a range of zero: they never see anything.
    """

    axis: Floats  # (robots, sensors, 3) cone axis, unit vector [body]
    cosine_half_angle: Floats  # (robots, sensors) of the cone
    neighbour_range: Floats  # (robots, sensors) [m]
    obstacle_range: Floats  # (robots, sensors) [m]
    ray: Floats  # (robots, sensors, rays, 3) unit vectors [body]
    ray_count: Integers  # (robots, sensors)
    water_density: Floats  # (robots,) [kg/m^3], by which the pressure sensor is calibrated
    gravity: Floats  # (robots,) [m/s^2]
    measured: Flags  # (robots, sensors of the table SENSORS) whose readings there are
