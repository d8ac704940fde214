"""From platforms to the numbers of vehicles, as simulation, filter and calibration take them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import BuoyancyPump
from cocorosim_ros.world.vehicle_model.curves import build_curves
from cocorosim_ros.world.vehicle_model.jets import build_jets
from cocorosim_ros.world.vehicle_model.platform_effects import active_bits, check_platform, parameter_row
from cocorosim_ros.world.vehicle_model.vehicles import Vehicles


def build_vehicles(platforms: Sequence[Platform], runs: int = 1) -> Vehicles:
    """The physical numbers of one robot per platform, repeated for every run.

    Raises CocorosimError if a platform has an effect that does not exist, or that lacks a number.
    """
    actuators = max(len(platform.actuators) for platform in platforms)
    wrench = np.zeros((len(platforms), actuators, 4))
    limit = np.zeros((len(platforms), actuators, 2))
    pump = np.zeros((len(platforms), actuators), dtype=np.bool_)
    for robot, platform in enumerate(platforms):
        wrench[robot, : len(platform.actuators)] = platform.actuator_wrenches()
        limit[robot, : len(platform.actuators)] = platform.actuator_limits()
        pump[robot, : len(platform.actuators)] = [isinstance(part, BuoyancyPump) for part in platform.actuators]
        check_platform(platform)
    parameters = np.array([parameter_row(platform) for platform in platforms])
    active = np.array([active_bits(platform) for platform in platforms], dtype=np.int64)
    parts = (parameters, active, wrench, limit, pump, build_curves(platforms), build_jets(platforms))
    repeated = [np.repeat(part[None], runs, axis=0) for part in parts]
    return Vehicles(*repeated)
