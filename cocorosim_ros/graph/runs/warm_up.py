"""Calls every hot loop and makes every message that a part of a run needs, so that they are compiled before it begins.

A node that is ready can answer then. `cocorosim run` does it once, before processes are forked; nodes that are started
one by one do their own part, of which one process on a machine compiles while the others wait (compiling.once).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.foundation.compiling.once import compile_once
from cocorosim_ros.graph.runs.body_side import BodySide
from cocorosim_ros.graph.runs.scenery import Scenery
from cocorosim_ros.graph.runs.warm_up_controller import Tell, compile_controller, nobody
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.metrics.shoal_monitor import ShoalMonitor
from cocorosim_ros.wire.bags.tracks import decode_poses
from cocorosim_ros.wire.cdr.status import end_of_run, read_status
from cocorosim_ros.wire.topics.body import BodyDescription, describe_body
from cocorosim_ros.wire.topics.swarm_messages import pose_message
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation


def compile_everything(scenario: Scenario, tell: Tell = nobody) -> None:
    """All that the nodes of a run need; tell(sentence) is told that something is compiled, and how long that takes."""
    compile_physics(scenario, tell)
    compile_controller(scenario.robots[0], tell)
    compile_recorder([describe_body(robot) for robot in scenario.robots], tell)
    Scenery.of(scenario)


def compile_whole_run(scenario: Scenario, tell: Tell = nobody) -> None:
    """All that a run without nodes needs."""
    compile_once("the whole run", _text(scenario), lambda: _tick(scenario, decide=True), tell)
    compile_recorder([describe_body(robot) for robot in scenario.robots], tell)


def compile_physics(scenario: Scenario, tell: Tell = nobody) -> None:
    """What the physics node needs."""
    compile_once("physics", _text(scenario), lambda: _tick(scenario, decide=False), tell)


def compile_recorder(bodies: Sequence[BodyDescription], tell: Tell = nobody) -> None:
    """What the metrics node needs."""
    compile_once("metrics", "", lambda: _measure(bodies), tell)


def _text(scenario: Scenario) -> str:
    """What decides which functions a run calls: everything but seed and length."""
    return replace(scenario, seed=0, duration_ns=scenario.tick_ns).to_yaml()


def _tick(scenario: Scenario, *, decide: bool) -> None:
    """One tick of a scenario without ROS."""
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    dict(BodySide([describe_body(robot) for robot in scenario.robots]).tick(simulation))
    if decide:
        simulation.decide()
    simulation.advance()
    read_status(end_of_run(0, 0, 0))


def _measure(bodies: Sequence[BodyDescription]) -> None:
    """One measurement of a swarm in a heap."""
    poses = pose_message(bodies).encode(0, np.tile([0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0], (len(bodies), 1)))
    ShoalMonitor(len(bodies)).update(0, *decode_poses(poses))
