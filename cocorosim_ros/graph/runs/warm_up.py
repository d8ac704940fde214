"""Compiles every hot loop and reads every message type that a run needs, before processes are forked from this one."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.graph.runs.body_side import BodySide
from cocorosim_ros.graph.runs.scenery import Scenery
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.metrics.shoal_monitor import ShoalMonitor
from cocorosim_ros.wire.bags.tracks import decode_poses
from cocorosim_ros.wire.cdr.status import end_of_run, read_status
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.observations import ObservationDecoder
from cocorosim_ros.wire.topics.topics import robot_topic
from cocorosim_ros.world.controllers.conduct import blank_memory, conduct_one
from cocorosim_ros.world.controllers.crew_assembly import build_crew
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.radio import HEARING_LIMIT, MESSAGE_SIZE
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation


def compile_everything(scenario: Scenario) -> None:
    """Run one tick of a scenario without ROS, one controller by itself, one measurement, and their messages."""
    start = start_poses(scenario)
    simulation = Simulation(build_world(scenario), start[None])
    messages = dict(BodySide([describe_body(robot) for robot in scenario.robots]).tick(simulation))
    simulation.advance()
    monitor = ShoalMonitor(len(scenario.robots))
    monitor.update(0, *decode_poses([messages[robot_topic(robot.name, "pose")] for robot in scenario.robots]))
    robot = scenario.robots[0]
    blank = ObservationDecoder(describe_body(robot), HEARING_LIMIT).observation(0.0, {})
    command = np.zeros(len(robot.platform.actuators))
    conduct_one(build_crew([robot]), 0, blank, blank_memory(1, 1)[0, 0], command, np.zeros(MESSAGE_SIZE))
    read_status(end_of_run(0, 0, 0))
    Scenery.of(scenario)
