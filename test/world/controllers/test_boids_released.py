"""The boids of the released model: each of their rules against what is worked out by hand, and the shipped files."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.controllers.boids_rules import SETTINGS
from cocorosim_ros.world.controllers.request import (
    DIVE,
    DIVE_MODE,
    DIVE_TO_DEPTH,
    HEADING,
    REQUEST_SIZE,
    SPEED,
    TURN_GAIN,
)

LEFT, RIGHT, BACK, UP, DOWN = range(5)
Make = Callable[..., Any]
OWN = {"blt": (), "blc": (), "na": ("keep_divisor", "halt_unseen"), "vanilla": ("cone_of_view", "body_median")}
every_group = pytest.mark.parametrize("group", OWN)


def settings_of(lily: SimpleNamespace, group: str, **changed: float) -> list[float]:
    """The paper's numbers with the rules of the released model on, some of them replaced."""
    names = (*SETTINGS, "present_course", *OWN[group])
    usual = dict(zip(names, (*lily.boids, 1.0, 1.0, 1.0), strict=False)) | {
        "observe_backwards": 0.0,
        "body_median": 0.0,
    }
    return [(usual | changed)[name] for name in names]


def off(group: str) -> dict[str, float]:
    """Every rule of the released model off."""
    rules = {"present_course": 0.0, "halt_unseen": 0.0, "cone_of_view": 0.0}
    return {name: value for name, value in rules.items() if name in ("present_course", *OWN[group])}


def avoiding() -> Any:
    """A request that avoidance of the floor has left behind: heading 2 rad, to a depth of 1.7 m."""
    request = np.zeros(REQUEST_SIZE)
    request[[HEADING, SPEED, TURN_GAIN, DIVE_MODE, DIVE]] = (2.0, 0.5, 15.0, DIVE_TO_DEPTH, 1.7)
    return request


@every_group
def test_alone_it_asks_for_its_present_heading_and_keeps_its_dive_mode(
    decide_once: Make, lily: SimpleNamespace, group: str
) -> None:
    """At 0.4 rad, with 2 rad and a depth asked for before: 0.4 rad at 8 % and gain 3, the depth as it was."""
    request = decide_once(f"boids_{group}_released", settings_of(lily, group), avoiding(), compass=0.4)
    assert request[[HEADING, SPEED, TURN_GAIN]].tolist() == [0.4, 0.08, 3.0]
    assert request[[DIVE_MODE, DIVE]].tolist() == [DIVE_TO_DEPTH, 1.7]


@every_group
def test_with_its_rules_off_it_is_the_variant_of_the_paper(
    decide_once: Make, lily: SimpleNamespace, group: str
) -> None:
    """Alone, and among others: the same request to the last bit as boids_X with the same numbers."""
    own = settings_of(lily, group, **off(group))
    extra = own[len(SETTINGS) + 1 :][:1] if group == "na" else []
    for seen in (
        {},
        {
            "ranges": {LEFT: 0.3, BACK: 0.2, UP: 0.1},
            "heard": [(0.01, 0.02, 0.003)],
            "light": [(0.02, 0.01, 0.0)],
            "places": [(0.2, 0.1, 0.05), (-0.3, 0.05, 0.2)],
            "velocities": [(0.01, 0.0, 0.0), (0.0, 0.02, 0.01)],
        },
    ):
        ours = decide_once(f"boids_{group}_released", own, avoiding(), compass=0.4, **seen)
        paper = decide_once(f"boids_{group}", [*own[: len(SETTINGS)], *extra], avoiding(), compass=0.4, **seen)
        assert np.array_equal(ours, paper)


def test_rules_that_sum_to_zero_are_no_request(decide_once: Make, lily: SimpleNamespace) -> None:
    """BLT hears a robot at rest and sees nobody: no thrust, the present heading, the dive mode as it was."""
    request = decide_once("boids_blt_released", settings_of(lily, "blt"), avoiding(), compass=0.4, heard=[(0, 0, 0)])
    assert request[[HEADING, SPEED]].tolist() == [0.4, 0.0]
    assert request[[DIVE_MODE, DIVE]].tolist() == [DIVE_TO_DEPTH, 1.7]


def test_a_sum_straight_up_turns_nowhere(decide_once: Make, lily: SimpleNamespace) -> None:
    """NA sees a robot 0.2 m above alone: it dives at 0.1 * 0.2 / 0.1 / 12 m/s and asks for its present heading."""
    request = decide_once("boids_na_released", settings_of(lily, "na"), avoiding(), compass=0.4, ranges={UP: 0.2},
                          places=[(0.0, 0.0, 0.2)])  # fmt: skip
    assert request[HEADING] == pytest.approx(0.4)
    assert (request[SPEED], request[DIVE]) == (pytest.approx(0.0, abs=1e-15), pytest.approx(0.1 * 2.0 / 12.0))


@pytest.mark.parametrize(("places", "speed"), [([], 0.08), ([(-0.3, 0.0, 0.0)], 0.0)])
def test_na_stands_still_beside_whom_it_does_not_see(
    decide_once: Make, lily: SimpleNamespace, places: Any, speed: float
) -> None:
    """Nobody within 0.5 m: 8 %. Somebody behind, whom the back sensor sees, which is not in use: no thrust."""
    ranges = {BACK: 0.3} if places else {}
    request = decide_once("boids_na_released", settings_of(lily, "na"), avoiding(), places=places, ranges=ranges)
    assert request[SPEED] == speed
    without = settings_of(lily, "na", halt_unseen=0.0)
    assert decide_once("boids_na_released", without, avoiding(), places=places, ranges=ranges)[SPEED] == 0.08


@pytest.mark.parametrize(
    ("place", "in_cone", "in_wedge"),
    [
        ((-0.29, 0.3, 0.0), True, True),  # 134 degrees off the bow
        ((-0.31, 0.3, 0.0), False, False),
        ((-0.02, 0.0, 0.3), True, False),  # above, a little behind: 94 degrees off the bow, azimuth 180
        ((-0.25, 0.24, -0.2), True, False),  # 129 degrees off the bow, azimuth 136
        ((-0.2, -0.21, 0.0), True, True),
    ],
)
def test_vanilla_sees_a_cone_about_the_bow(
    decide_once: Make, lily: SimpleNamespace, place: Any, in_cone: bool, in_wedge: bool
) -> None:
    """Whether it is alone tells whether it saw the robot: 8 % if not."""
    for cone, seen in ((1.0, in_cone), (0.0, in_wedge)):
        settings = settings_of(lily, "vanilla", cone_of_view=cone, speed_cap=0.05)
        request = decide_once(
            "boids_vanilla_released", settings, avoiding(), places=[place], velocities=[(0.0, 0.0, 0.0)]
        )
        assert (request[SPEED] != 0.08) == seen


def test_the_median_of_velocities_is_taken_in_world_or_body_axes(decide_once: Make, lily: SimpleNamespace) -> None:
    """Velocities (0.01, 0.02), (0.03, 0), (0.05, 0.05), at 0.4 rad: (0.03, 0.02) in the world.

    In body axes the median is another vector, which `body_median` follows.
    """
    velocities = np.array([(0.01, 0.02), (0.03, 0.0), (0.05, 0.05)])
    turn = np.array([[math.cos(0.4), -math.sin(0.4)], [math.sin(0.4), math.cos(0.4)]])
    in_body = turn @ np.median(velocities @ turn, axis=0)
    headings = {0.0: math.atan2(0.02, 0.03), 1.0: math.atan2(in_body[1], in_body[0])}
    assert abs(headings[0.0] - headings[1.0]) > 0.01
    for body_median, heading in headings.items():
        request = decide_once(
            "boids_vanilla_released",
            settings_of(lily, "vanilla", cohesion_weight=0.0, alignment_length=1.0, body_median=body_median),
            avoiding(),
            places=[(0.2, 0.0, 0.0), (0.3, 0.0, 0.0), (0.4, 0.0, 0.0)],
            velocities=np.c_[velocities, np.zeros(3)],
            compass=0.4,
        )
        assert request[HEADING] == pytest.approx(heading)


@every_group
def test_shipped_numbers_differ_from_the_papers_by_what_is_known(group: str) -> None:
    """boids_X_released is boids_X but for the units of ranges, the view to the back, and the rules of its own."""
    from cocorosim_ros.scenario.parts.controller_file import load_controller

    paper, released = (load_controller(name).values for name in (f"boids_{group}", f"boids_{group}_released"))
    units = set() if group == "vanilla" else {"cohesion_length"}
    assert {name for name in paper if paper[name] != released[name]} == {"observe_backwards", *units}
    assert released["cohesion_length"] == (0.1 if group == "vanilla" else 1.0)
    rules = {"present_course", *OWN[group]} - {"keep_divisor"}
    assert set(released) - set(paper) == rules
    assert {name for name in rules if not released[name]} == {"body_median"} & rules
