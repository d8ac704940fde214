"""What is asked for: scenarios, platforms and controllers, as frozen records read from YAML."""

from cocorosim_ros.scenario.checks.seeding import generator, start_poses
from cocorosim_ros.scenario.parts.controller_file import ControllerDescription, Parameter, load_controller
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.scenario import RobotDescription, Scenario, load_scenario, parse_scenario

__all__ = [
    "ControllerDescription",
    "Parameter",
    "Platform",
    "RobotDescription",
    "Scenario",
    "generator",
    "load_controller",
    "load_platform",
    "load_scenario",
    "parse_scenario",
    "start_poses",
]
