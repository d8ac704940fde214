"""From the description of robots to their crew: all that a controller node needs of the model."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.controller_choice import AnyController
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.scenario.reading.entry import nearest
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers import CONTROLLER_CODE
from cocorosim_ros.world.controllers.crew import Crew
from cocorosim_ros.world.controllers.operating_system import SYSTEM_NUMBERS
from cocorosim_ros.world.controllers.sensor_axes import cone_axis
from cocorosim_ros.world.controllers.traits import behaviour_of

STEERING_ACTUATORS = ("left", "right", "buoyancy")
NO_BEHAVIOUR = -1  # nothing of CONTROLLERS is called: somebody else has written the request and the message


def build_crew(robots: Sequence[RobotDescription]) -> Crew:
    """The controllers of the robots; those in plain Python (controllers.plain) have the code of no behaviour."""
    count = len(robots)
    settings = [controller_settings(robot.controller) for robot in robots]
    axes = [[cone_axis(sensor) for sensor in robot.platform.sensors.directed] for robot in robots]
    crew = Crew(
        code=np.array([_code(robot.controller) for robot in robots]),
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


def _code(controller: AnyController) -> int:
    if isinstance(controller, PythonController):
        return NO_BEHAVIOUR
    return CONTROLLER_CODE[controller.behaviour]


def controller_settings(description: AnyController) -> list[float]:
    """The numbers of a controller file in the order in which the behaviour wants them; none for plain Python.

    Raises CocorosimError if the behaviour does not exist or the file's parameters are not its settings.
    """
    if isinstance(description, PythonController):
        return []
    wanted, given = behaviour_of(description).settings, description.parameters
    for name in wanted:
        if name not in given:
            raise CocorosimError(
                f"{description.origin}: 'parameters' lacks '{name}', which behaviour '{description.behaviour}' needs; "
                "add it."
            )
    for name in given:
        if name not in wanted:
            raise CocorosimError(
                f"{description.origin}: 'parameters.{name}' is no parameter of behaviour '{description.behaviour}'"
                f"{nearest(name, wanted)}."
            )
    return [given[name].value for name in wanted]


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
        float(system.avoidance_readings == "previous_tick"),
    ]


def _steering_columns(platform: Platform) -> list[int]:
    names = platform.actuator_names
    return [names.index(name) if name in names else -1 for name in STEERING_ACTUATORS]
