"""What a run without ROS records of messages: what each controller really decided by."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest

from cocorosim_ros.graph.runs.body_side import BodySide
from cocorosim_ros.graph.runs.under_way import longest_under_way
from cocorosim_ros.scenario.parts.controller_file import load_controller
from cocorosim_ros.wire.cdr.radio_messages import RadioMessage
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.observations import ObservationDecoder
from cocorosim_ros.wire.topics.topics import robot_topic
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.radio import HEARING_LIMIT, read_payload
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.deciding import observe
from cocorosim_ros.world.tick.simulation import Simulation

COUNTED = {
    "heard": "heard_count",
    "light": "light_count",
    "sound": "sound_count",
    "neighbour_offset": "neighbour_count",
    "neighbour_velocity": "neighbour_count",
}


@pytest.mark.parametrize(
    ("scenario_name", "controller"),
    [
        *itertools.product(
            ["eleven_lilys", "noisy_lilys"],
            ["boids_blt", "boids_vanilla", "boids_blc", "boids_na", "minimal_flocking", "beeclust", "plume_tracking"],
        ),
        ("acoustic_slots", "depth_agreement"),
    ],
)
def test_a_node_sees_what_a_batch_sees(scenario_name: str, controller: str) -> None:
    """The observation decoded from a robot's topics is that of the batch, field by field, bit for bit."""
    scenario = load_scenario(scenario_name)
    swarm = tuple(replace(group, controller=load_controller(controller)) for group in scenario.swarm)
    scenario = replace(scenario, swarm=swarm)
    bodies = [describe_body(robot) for robot in scenario.robots]
    side = BodySide(bodies, longest_under_way(scenario))
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    decoders = [ObservationDecoder(body, HEARING_LIMIT) for body in bodies]
    for _ in range(15):
        messages = dict(side.tick(simulation))
        moment = simulation.time_ns * 1e-9
        for robot, (body, decoder) in enumerate(zip(bodies, decoders, strict=True)):
            latest = {name: messages[robot_topic(body.name, name)] for name in body.topics}
            seen, meant = (
                decoder.observation(moment, latest),
                observe.py_func(moment, simulation.perception, 0, robot, np.empty(3)),
            )
            for name, limit in COUNTED.items():
                count = getattr(meant, limit)
                np.testing.assert_array_equal(getattr(seen, name)[:count], getattr(meant, name)[:count])
            for name in set(seen._fields) - COUNTED.keys():
                np.testing.assert_array_equal(getattr(seen, name), getattr(meant, name), err_msg=name)
        simulation.decide()
        for robot, body in enumerate(bodies):
            if body.speaks:
                payload = read_payload(simulation.said[0, robot])
                side.say(robot, RadioMessage(simulation.time_ns, body.frame, body.name, payload))
        simulation.advance()


def test_topics_exist_for_whom_they_matter() -> None:
    """Usual robots have none of the extra topics; each controller that needs one has that one."""
    scenario = load_scenario("eleven_lilys")
    robot = scenario.robots[0]
    usual = describe_body(robot)
    for name, extra, talk in (
        ("boids_vanilla", ("neighbours",), "radio_tx"),
        ("boids_blc", ("blue_light_rx",), "blue_light_tx"),
        ("beeclust", ("illuminance",), "radio_tx"),
        ("plume_tracking", ("concentration",), "radio_tx"),
        ("boids_blt", (), "radio_tx"),
        ("depth_agreement", ("acoustic_rx",), "acoustic_tx"),
    ):
        body = describe_body(replace(robot, controller=load_controller(name), acoustic=True))
        assert body.topics == (*usual.topics, *extra)
        assert body.talk == talk
