"""The controllers of all robots, laid out for compiled loops."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats, Integers


class Crew(NamedTuple):
    """Controllers with leading axis (robots,); the same in every run."""

    code: Integers  # (robots,) CONTROLLER_CODE
    settings: Floats  # (robots, settings) in the order of each controller's `settings`
    settings_count: Integers  # (robots,)
    system: Floats  # (robots, numbers) operating_system.SYSTEM_NUMBERS
    actuator: Integers  # (robots, 3) columns of left, right, buoyancy in a command; -1 where a robot lacks one
    sensor_axis: Floats  # (robots, sensors, 3) cone axes [body]
    sensor_count: Integers  # (robots,)
