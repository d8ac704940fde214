"""From the description of robots to their crew: all that a controller node needs of the model."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.controller_file import ControllerDescription
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers import CONTROLLER_CODE, CONTROLLERS
from cocorosim_ros.world.controllers.crew import Crew
from cocorosim_ros.world.controllers.operating_system import SYSTEM_NUMBERS

STEERING_ACTUATORS = ("left", "right", "buoyancy")


def build_crew(robots: Sequence[RobotDescription]) -> Crew:
    """The controllers of the robots."""
    count = len(robots)
    settings = [controller_settings(robot.controller) for robot in robots]
    axes = [[cone_axis(sensor) for sensor in robot.platform.sensors.blss] for robot in robots]
    crew = Crew(
        code=np.array([CONTROLLER_CODE[robot.controller.behaviour] for robot in robots]),
        settings=np.zeros((count, max(1, *(len(row) for row in settings)))),
        settings_count=np.array([len(row) for row in settings]),
        system=np.array([system_numbers(robot.platform) for robot in robots]),
        actuator=np.array([_steering_columns(robot.platform) for robot in robots]),
        sensor_axis=np.zeros((count, max(1, *(len(row) for row in axes)), 3)),
        sensor_count=np.array([len(row) for row in axes]),
    )
    for robot in range(count):
        crew.settings[robot, : len(settings[robot])] = settings[robot]
        crew.sensor_axis[robot, : len(axes[robot])] = np.array(axes[robot]).reshape(-1, 3)
    return crew


def controller_settings(description: ControllerDescription) -> list[float]:
    """The numbers of a controller file in the order in which the behaviour wants them.

    Raises CocorosimError if the behaviour does not exist or the file's parameters are not its settings.
    """
    if description.behaviour not in CONTROLLERS:
        raise CocorosimError(
            f"{description.origin}: 'behaviour' has '{description.behaviour}', which does not exist; "
            f"allowed: {', '.join(CONTROLLERS)}."
        )
    wanted = CONTROLLERS[description.behaviour].settings
    if set(wanted) != set(description.parameters):
        raise CocorosimError(
            f"{description.origin}: the parameters of behaviour '{description.behaviour}' are "
            f"{', '.join(wanted) or 'none'}; found {', '.join(description.parameters) or 'none'}."
        )
    return [description.parameters[name].value for name in wanted]


def system_numbers(platform: Platform) -> list[float]:
    """The numbers of a platform's operating system in the order of SYSTEM_NUMBERS; zeros for one without."""
    system = platform.operating_system
    if system is None:
        return [0.0] * len(SYSTEM_NUMBERS)
    return [
        system.wall_threshold,
        system.floor_threshold,
        system.surface_depth,
        system.depth_margin,
        system.avoidance_thrust,
        system.avoidance_gain,
        system.heading_proportional,
        system.heading_damping,
        system.vertical_proportional,
        system.vertical_damping,
        system.depth_proportional,
        system.dive_limit,
        system.command_full_scale,
        system.units_per_volt * system.full_voltage,
        platform.water_density,
        platform.gravity,
    ]


def cone_axis(sensor: BlueLightSensor, offset: float = 0.0) -> tuple[float, float, float]:
    """Unit vector [body] of a sensor's axis, turned by `offset` [rad] in azimuth."""
    azimuth, level = sensor.azimuth + offset, math.cos(sensor.elevation)
    return level * math.cos(azimuth), level * math.sin(azimuth), math.sin(sensor.elevation)


def _steering_columns(platform: Platform) -> list[int]:
    names = platform.actuator_names
    return [names.index(name) if name in names else -1 for name in STEERING_ACTUATORS]
