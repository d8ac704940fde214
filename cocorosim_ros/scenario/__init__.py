"""What is asked for: scenarios, platforms and controllers, as frozen records read from YAML."""

from cocorosim_ros.scenario.parts.controller_file import ControllerDescription, Parameter, load_controller
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.scenario import RobotDescription, Scenario

__all__ = [
    "ControllerDescription",
    "Parameter",
    "Platform",
    "RobotDescription",
    "Scenario",
    "load_controller",
    "load_platform",
]
