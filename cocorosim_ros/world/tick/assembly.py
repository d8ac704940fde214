"""From a scenario to the arrays of a world: the one place where names become numbers.

Rows are padded where robots differ in actuators or sensors: a padded actuator gives no force, a padded sensor
sees nothing.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Flags
from cocorosim_ros.scenario.parts.acoustic import Acoustic
from cocorosim_ros.scenario.parts.light import Light
from cocorosim_ros.scenario.parts.tank import Box, Sphere
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor
from cocorosim_ros.scenario.scenario import RobotDescription, Scenario
from cocorosim_ros.world.controllers.crew_assembly import build_crew
from cocorosim_ros.world.controllers.plain.plain_controller import plain_of
from cocorosim_ros.world.controllers.sensor_axes import cone_axis
from cocorosim_ros.world.controllers.traits import traits_of
from cocorosim_ros.world.links.acoustic_channel import Channel, acoustic_channel
from cocorosim_ros.world.links.blue_light import DELIVERY_CODE
from cocorosim_ros.world.motion.contact import CONTACT_CODE
from cocorosim_ros.world.motion.integrators import INTEGRATOR_CODE
from cocorosim_ros.world.motion.motion import Stepping
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.instruments import Instruments
from cocorosim_ros.world.six_degrees.assembly import build_school
from cocorosim_ros.world.surroundings.lamps import Lamps
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.tick.wants import Wants
from cocorosim_ros.world.tick.water_assembly import build_water
from cocorosim_ros.world.tick.world import World
from cocorosim_ros.world.vehicle_model.platform_effects import build_delays, build_faults
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles


def build_world(scenario: Scenario, runs: int = 1, first_run: int = 0) -> World:
    """The world of a scenario, for `runs` runs that differ in their start and their random numbers only.

    first_run: the number of the first of them, which with the scenario's seed decides their random numbers.
    """
    platforms = [robot.platform for robot in scenario.robots]
    return World(
        names=tuple(robot.name for robot in scenario.robots),
        tick_ns=scenario.tick_ns,
        tank=build_tank(scenario),
        stepping=_stepping(scenario),
        vehicles=build_vehicles(platforms, runs),
        school=build_school(platforms),
        instruments=build_instruments(scenario.robots),
        faults=build_faults(platforms),
        command_delay=build_delays(platforms),
        crew=build_crew(scenario.robots),
        radio_range=np.array([platform.sensors.radio_range for platform in platforms]),
        wants=build_wants(scenario.robots),
        lamps=build_lamps(scenario.light),
        light_delivery=DELIVERY_CODE[scenario.blue_light.delivery],
        channel=None if scenario.acoustic is None else _channel(scenario, scenario.acoustic),
        instant_radio=scenario.radio.latency == "none",
        corruption=scenario.corruption,
        seed=scenario.seed,
        first_run=first_run,
        water=build_water(scenario, first_run),
        plain={number: robot for number, robot in enumerate(scenario.robots) if plain_of(robot) is not None},
    )


def build_wants(robots: Sequence[RobotDescription]) -> Wants:
    """What the controllers of the robots ask for."""
    controllers = [traits_of(robot.controller) for robot in robots]

    def who(topic: str) -> Flags:
        return np.array([topic in controller.needs for controller in controllers])

    def speaks(medium: str) -> Flags:
        return np.array([controller.medium == medium for controller in controllers])

    return Wants(who("neighbours"), who("blue_light_rx"), speaks("blue_light"), who("acoustic_rx"), speaks("acoustic"))


def build_lamps(light: Light) -> Lamps:
    """The light in the tank."""
    rows = [[*lamp.position, lamp.illuminance, lamp.width] for lamp in light.lamps]
    return Lamps(light.background, np.array(rows, dtype=np.float64).reshape(-1, 5))


def build_tank(scenario: Scenario) -> Tank:
    """The tank with its obstacles."""
    spheres = [[*part.centre, part.radius] for part in scenario.tank.obstacles if isinstance(part, Sphere)]
    boxes = [part.corners() for part in scenario.tank.obstacles if isinstance(part, Box)]
    return Tank(
        lower=np.array(scenario.tank.lower_corner()),
        upper=np.array(scenario.tank.upper_corner()),
        spheres=np.array(spheres, dtype=np.float64).reshape(-1, 4),
        boxes=np.array(boxes, dtype=np.float64).reshape(-1, 6),
    )


def build_instruments(robots: Sequence[RobotDescription]) -> Instruments:
    """The instruments of the robots."""
    platforms = [robot.platform for robot in robots]
    sensors = max(1, *(len(platform.sensors.directed) for platform in platforms))
    rays = max([1, *(len(part.obstacle_rays) for platform in platforms for part in platform.sensors.directed)])
    count = len(platforms)
    instruments = Instruments(
        axis=np.zeros((count, sensors, 3)),
        cosine_half_angle=np.ones((count, sensors)),
        neighbour_range=np.full((count, sensors), -1.0),
        obstacle_range=np.full((count, sensors), -1.0),
        ray=np.zeros((count, sensors, rays, 3)),
        ray_count=np.zeros((count, sensors), dtype=np.int64),
        water_density=np.array([platform.water_density for platform in platforms]),
        gravity=np.array([platform.gravity for platform in platforms]),
        measured=np.array([_measured(robot) for robot in robots]),
    )
    for robot, platform in enumerate(platforms):
        for index, sensor in enumerate(platform.sensors.directed):
            _place_sensor(instruments, robot, index, sensor)
    return instruments


def _measured(robot: RobotDescription) -> list[bool]:
    """Which sensors of the table a robot measures with."""
    sensors, needs = robot.platform.sensors, traits_of(robot.controller).needs
    return [sensor.for_all or sensor.is_on(sensors, needs) for sensor in SENSORS.values()]


def _channel(scenario: Scenario, acoustic: Acoustic) -> Channel:
    return acoustic_channel(acoustic, scenario.tick_ns, scenario.tank.depth / 2)


def _stepping(scenario: Scenario) -> Stepping:
    step_ns = scenario.integrator.step_ns
    return Stepping(
        integrator=INTEGRATOR_CODE[scenario.integrator.name],
        steps=scenario.tick_ns // step_ns,
        step=step_ns * 1e-9,
        contact=CONTACT_CODE[scenario.integrator.contact],
    )


def _place_sensor(instruments: Instruments, robot: int, index: int, sensor: BlueLightSensor) -> None:
    instruments.axis[robot, index] = cone_axis(sensor)
    instruments.cosine_half_angle[robot, index] = math.cos(sensor.cone_angle / 2)
    # Zero sees nothing, not even what the robot touches.
    instruments.neighbour_range[robot, index] = sensor.neighbour_range or -1.0
    instruments.obstacle_range[robot, index] = sensor.obstacle_range or -1.0
    instruments.ray_count[robot, index] = len(sensor.obstacle_rays)
    for ray, offset in enumerate(sensor.obstacle_rays):
        instruments.ray[robot, index, ray] = cone_axis(sensor, offset)
