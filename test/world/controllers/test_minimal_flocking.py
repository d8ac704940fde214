"""Flocking without communication: which reading leads to which turn."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from cocorosim_ros.world.controllers.request import DIVE, HEADING, SPEED

LEFT, RIGHT, BACK, UP, DOWN = range(5)
STEP = math.radians(15.0)
# range, separation, cohesion, cohesion behind, turn, speed, alone, dive, gain
SETTINGS = (0.5, 0.5, 0.6, 0.8, STEP, 0.01, 0.1, 0.01, 3.0)
Make = Callable[..., Any]


@pytest.mark.parametrize(
    ("ranges", "turn"),
    [
        ({LEFT: 0.24}, -STEP),  # too near: away
        ({RIGHT: 0.24}, STEP),
        ({LEFT: 0.31}, STEP),  # too far: towards
        ({RIGHT: 0.31}, -STEP),
        ({LEFT: 0.27, RIGHT: 0.29}, 0.0),  # in between: straight on
        ({BACK: 0.39}, 0.0),  # behind, farther than 0.6 but not than 0.8 of the range
        ({BACK: 0.41}, STEP),
        ({BACK: 0.1}, 0.0),  # who is close behind is left behind
        ({LEFT: 0.2, RIGHT: 0.1}, STEP),  # the nearest decides
        ({LEFT: 0.4, RIGHT: 0.45}, -STEP),  # the farthest decides
        ({LEFT: 0.45, RIGHT: 0.2}, STEP),  # separation goes first
    ],
)
def test_turns(decide_once: Make, ranges: dict[int, float], turn: float) -> None:
    """Thresholds at 0.25, 0.3 and (behind) 0.4 m; one turn is 15 degrees from the present heading."""
    request = decide_once("minimal_flocking", SETTINGS, ranges=ranges, compass=1.0)
    if turn == 0.0:
        assert math.isnan(request[HEADING])  # never asked for another heading
    else:
        assert request[HEADING] == pytest.approx(1.0 + turn)
    assert request[SPEED] == 0.01


@pytest.mark.parametrize(
    ("ranges", "climb"),
    [({UP: 0.2}, -0.01), ({DOWN: 0.2}, 0.01), ({UP: 0.35}, 0.01), ({DOWN: 0.35}, -0.01), ({UP: 0.27}, 0.0)],
)
def test_dives(decide_once: Make, ranges: dict[int, float], climb: float) -> None:
    """Too near above: down; too far above: up; and the other way round below."""
    assert decide_once("minimal_flocking", SETTINGS, ranges=ranges)[DIVE] == climb


def test_alone_it_swims_ten_times_faster(decide_once: Make) -> None:
    """10 % of the thrust, straight on."""
    request = decide_once("minimal_flocking", SETTINGS)
    assert request[SPEED] == 0.1
    assert math.isnan(request[HEADING])


def test_the_shoal_stays_together() -> None:
    """Four runs of 20 minutes: on average fewer than two shoals, where the ported numbers give more than four."""
    from dataclasses import replace

    from cocorosim_ros.scenario.parts.controller_file import load_controller
    from cocorosim_ros.study.experiments.batch import run_batch
    from cocorosim_ros.study.metrics import COLUMN
    from cocorosim_ros.world.checks.loading import load_scenario

    shoals = {}
    for name in ("minimal_flocking", "minimal_flocking_ported"):
        scenario = replace(load_scenario("minimal_flock"), duration_ns=1_200_000_000_000)
        swarm = (replace(scenario.swarm[0], controller=load_controller(name)),)
        shoals[name] = run_batch(replace(scenario, swarm=swarm), 0, 4).mean[:, COLUMN["shoals"]].mean()
    assert shoals["minimal_flocking"] < 2.0 and shoals["minimal_flocking_ported"] > 4.0
