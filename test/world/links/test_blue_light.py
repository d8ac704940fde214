"""Blue light as a link: who hears whom when only the nearest in a cone does."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

Make = Callable[..., Any]
# On a line along x, all looking along +x: 0 - 0.2 m - 1 - 0.3 m - 2. Ahead is the limit of both front cones.
LINE = [(0.0, 0.0, -5.0, 0.0), (0.2, 0.0, -5.0, 0.0), (0.5, 0.0, -5.0, 0.0)]


@pytest.fixture
def heard(make_simulation: Make) -> Make:
    """Function of (start poses, delivery, who speaks, capacity): for each robot the senders that it hears."""
    from cocorosim_ros.world.links.blue_light import DELIVERY_CODE, deliver_light
    from cocorosim_ros.world.state.radio import MESSAGE_SIZE, empty_inbox

    def hear(start: Any, delivery: str, speaks: Any = None, capacity: int = 8) -> list[list[int]]:
        simulation = make_simulation([start])
        simulation.sense()
        robots = len(start)
        said = np.zeros((1, robots, MESSAGE_SIZE))
        said[0, :, 0] = 1.0 if speaks is None else speaks
        said[0, :, 1] = np.arange(robots) + 10
        inbox = empty_inbox(1, robots, capacity)
        deliver_light(said, simulation.nearest, DELIVERY_CODE[delivery], inbox)
        senders = [inbox.sender[0, robot, : inbox.heard[0, robot]].tolist() for robot in range(robots)]
        for robot, row in enumerate(senders):
            assert inbox.message[0, robot, : len(row), 1].tolist() == [sender + 10 for sender in row]
        return senders

    return hear


def test_to_the_nearest_in_each_cone(heard: Make) -> None:
    """0 speaks ahead to 1; 1 ahead to 2 and back to 0; 2 back to 1: 2 is too far for 0 because 1 is nearer."""
    assert heard(LINE, "to_nearest") == [[1], [0, 2], [1]]


def test_the_two_deliveries_differ_where_nearest_is_not_mutual(heard: Make) -> None:
    """Three in a row looking along it: the same. Two ahead of 0, of whom 2 has 1 behind it, nearer than 0: not."""
    start = [(0, 0, -5, 0.0), (0.1, 0.1732, -5, 1.0472), (0.2, 0.3464, -5, 1.0472)]
    # 1 sees 0 behind and 2 ahead; 2 sees 1 behind, nearer than 0.
    assert heard(start, "to_nearest") == heard(start, "from_nearest") == [[1], [0, 2], [1]]
    aside = [(0, 0, -5, 0.0), (0.1, 0.1732, -5, 1.0472), (0.35, 0.0, -5, -0.5)]
    # 0 sees 1 (0.2 m) in front left, 2 in front right; 2 looks away: behind it is 0 (0.35 m) and 1 (0.304 m).
    assert heard(aside, "from_nearest")[0] == [1, 2]
    assert heard(aside, "from_nearest")[2] == [1]
    assert heard(aside, "to_nearest")[2] == [0, 1]


def test_to_and_from_are_each_others_mirror(heard: Make, crowd: Make) -> None:
    """If a robot hears another by one rule, then the other hears it by the other rule."""
    start = crowd(1, 25, seed=5)[0] * [1.5, 1.5, 1.0, 1.0]
    to, back = heard(start, "to_nearest", capacity=24), heard(start, "from_nearest", capacity=24)
    assert {(i, j) for i in range(25) for j in to[i]} == {(j, i) for i in range(25) for j in back[i]}
    assert to != back


def test_the_silent_and_the_distant_are_not_heard(heard: Make) -> None:
    """1 silent: 0 and 2 hear nothing. Everybody 0.6 m apart: nobody hears anything."""
    assert heard(LINE, "to_nearest", speaks=[1, 0, 1]) == [[], [0, 2], []]
    assert heard([(0.6 * k, 0, -5, 0) for k in range(3)], "to_nearest") == [[], [], []]


def test_a_full_inbox_keeps_the_first(heard: Make) -> None:
    """With room for one, 1 keeps 0."""
    assert heard(LINE, "to_nearest", capacity=1)[1] == [0]


def test_boids_speak_over_blue_light_alone(lily: SimpleNamespace) -> None:
    """In a swarm of BLC robots the radio stays empty and blue light carries each sender's velocity."""
    from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario
    from cocorosim_ros.world.seeding.seeding import start_poses
    from cocorosim_ros.world.tick.assembly import build_world
    from cocorosim_ros.world.tick.simulation import Simulation

    scenario = parse_scenario(
        load_scenario("eleven_lilys").to_yaml().replace("behaviour: boids_blt", "behaviour: boids_blc"), "x"
    )
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    for _ in range(20):
        simulation.sense()
        simulation.decide()
        said = simulation.said.copy()
        simulation.advance()
    assert not simulation.inbox.heard.any()
    inbox = simulation.light_inbox
    assert inbox.heard.sum() > 5
    for robot in range(11):
        for slot in range(inbox.heard[0, robot]):
            assert np.array_equal(inbox.message[0, robot, slot], said[0, inbox.sender[0, robot, slot]])
