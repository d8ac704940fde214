"""The rules of boids with blue-light triangulation, against sums done by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

LEFT, RIGHT, BACK, UP, DOWN = range(5)
HALF_ROOT_3 = math.sqrt(0.75)
Make = Callable[..., Any]


@pytest.fixture(scope="module")
def decided(make_simulation: Make, lily: SimpleNamespace) -> Make:
    """Function of (ranges by sensor, velocities heard, compass, changed settings): what is asked for."""
    from cocorosim_ros.world.controllers.request import DIVE, HEADING, SPEED

    def ask(ranges: dict[int, float], heard: Any = (), compass: float = 0.0, **changed: float) -> Any:
        names = ("cohesion_weight", "separation_weight", "alignment_weight", "separation_threshold",
                 "neighbour_trust", "observe_backwards", "cohesion_length", "alignment_length")  # fmt: skip
        settings = [changed.get(name, value) for name, value in zip(names, lily.boids, strict=False)]
        simulation = make_simulation(
            np.tile([0.0, 0.0, -5.0, compass], (1, 9, 1)), "boids_blt", (*settings, *lily.boids[8:])
        )
        simulation.sense()
        simulation.readings.neighbour_range[...] = math.inf
        for sensor, distance in ranges.items():
            simulation.readings.neighbour_range[0, 0, sensor] = distance
        simulation.inbox.heard[0, 0] = len(heard)
        for index, velocity in enumerate(heard):
            simulation.inbox.message[0, 0, index, :4] = (3.0, *velocity)
        simulation.decide()
        request = simulation.memory[0, 0]
        return SimpleNamespace(heading=request[HEADING], speed=request[SPEED], dive=request[DIVE])

    return ask


def test_cohesion_goes_to_who_is_seen(decided: Make) -> None:
    """Front left at 0.4 m: towards +60 degrees, with 0.4/0.1/12, capped at 10 %."""
    asked = decided({LEFT: 0.4})
    assert asked.heading == pytest.approx(math.radians(60.0))
    assert asked.speed == pytest.approx(0.1)
    assert decided({LEFT: 0.4}, cohesion_length=1.0).speed == pytest.approx(0.4 / 12.0)


def test_cohesion_adds_the_sensors_up(decided: Make) -> None:
    """0.4 m front left, 0.2 front right, 0.3 behind: (0.2 + 0.1 - 0.3, (0.4 - 0.2) sin 60 degrees)."""
    asked = decided({LEFT: 0.4, RIGHT: 0.2, BACK: 0.3}, cohesion_length=1.0)
    assert asked.heading == pytest.approx(math.radians(90.0))
    assert asked.speed == pytest.approx(0.2 * HALF_ROOT_3 / 12.0)


def test_cohesion_climbs_and_dives(decided: Make) -> None:
    """0.3 m above and 0.2 m below: the dive speed is 0.1 * (0.3 - 0.2) / 0.1 / 12, no horizontal wish."""
    asked = decided({UP: 0.3, DOWN: 0.2}, compass=0.7)
    assert asked.dive == pytest.approx(0.1 / 12.0)
    assert asked.speed == 0.0
    assert asked.heading == pytest.approx(0.7)


def test_separation_pushes_away(decided: Make) -> None:
    """Without cohesion, front left at 0.05 m: (0.15 - 0.05)/0.1/11 away, towards -120 degrees."""
    asked = decided({LEFT: 0.05}, cohesion_weight=0.0)
    assert asked.heading == pytest.approx(math.radians(-120.0))
    assert asked.speed == pytest.approx(1.0 / 11.0)


@pytest.mark.parametrize(("distance", "towards"), [(0.07, -120.0), (0.08, 60.0)])
def test_cohesion_and_separation_balance_at_half_the_threshold(decided: Make, distance: float, towards: float) -> None:
    """d - (0.15 - d) changes sign at 7.5 cm."""
    assert decided({LEFT: distance}).heading == pytest.approx(math.radians(towards))


def test_beyond_the_threshold_nobody_is_pushed(decided: Make) -> None:
    """At 0.2 m the speed is that of cohesion alone."""
    assert decided({LEFT: 0.2}, cohesion_length=1.0).speed == pytest.approx(0.2 / 12.0)


def test_a_reading_near_the_limit_of_range_is_not_trusted(decided: Make) -> None:
    """At 0.48 m, beyond 95 % of range, there is no pull."""
    assert decided({LEFT: 0.48, RIGHT: 0.3}).heading == pytest.approx(math.radians(-60.0))


def test_the_back_sensor_can_be_left_out(decided: Make) -> None:
    """With observe_backwards 0 a robot behind does not count."""
    assert decided({BACK: 0.3, LEFT: 0.3}, observe_backwards=0.0).heading == pytest.approx(math.radians(60.0))
    assert decided({BACK: 0.3}, observe_backwards=0.0).speed == pytest.approx(0.08)


@pytest.mark.parametrize(
    ("heard", "median"),
    [
        ([(0.01, 0.02, 0.004)], (0.01, 0.02, 0.004)),
        ([(0.01, 0.02, 0.0), (0.03, -0.04, 0.002)], (0.02, -0.01, 0.001)),
        ([(0.01, 0.0, 0.001), (0.05, -0.03, 0.003), (0.02, 0.02, 0.0)], (0.02, 0.0, 0.001)),
        ([(0.04, 0, 0), (0.01, 0.03, 0), (0.02, 0.01, 0), (0.03, 0.02, 0)], (0.025, 0.015, 0.0)),
    ],
)
def test_alignment_is_the_coordinate_wise_median(decided: Make, heard: Any, median: Any) -> None:
    """Odd: the middle one; even: the mean of the middle two; each coordinate by itself, times 10 over 12."""
    asked = decided({}, heard, compass=0.3, alignment_length=1.0)
    assert asked.heading == pytest.approx(math.atan2(median[1], median[0]))
    assert asked.speed == pytest.approx(10.0 * math.hypot(median[0], median[1]) / 12.0)
    assert asked.dive == pytest.approx(0.1 * 10.0 * median[2] / 12.0)


def test_rules_are_weighted_and_added(decided: Make) -> None:
    """Heading north, one 0.3 m front right (world +30 degrees), one swimming west with 0.02 m/s."""
    asked = decided({RIGHT: 0.3}, [(-0.02, 0.0, 0.0)], compass=0.5 * math.pi, cohesion_length=1.0, alignment_length=1.0)
    east, north = 0.3 * HALF_ROOT_3 - 10.0 * 0.02, 0.15
    assert asked.heading == pytest.approx(math.atan2(north, east))
    assert asked.speed == pytest.approx(math.hypot(east, north) / 12.0)


def test_speed_is_capped_at_10_percent(decided: Make) -> None:
    """However strong the wish, thrust is 10 %."""
    assert decided({LEFT: 0.4, RIGHT: 0.4}, [(0.07, 0.0, 0.0)]).speed == pytest.approx(0.1)


def test_alone_it_holds_heading_with_8_percent(decided: Make) -> None:
    """Nobody seen, nobody heard: the heading of the first reading, 8 % thrust."""
    asked = decided({}, compass=2.0)
    assert (asked.heading, asked.speed, asked.dive) == (2.0, 0.08, 0.0)


def test_alone_it_keeps_what_it_last_asked_for(make_simulation: Make, lily: SimpleNamespace) -> None:
    """Having lost the others, heading and dive speed of the last request stay."""
    from cocorosim_ros.world.controllers.request import DIVE, HEADING, SPEED

    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.0]]], "boids_blt", lily.boids)
    simulation.sense()
    simulation.readings.neighbour_range[0, 0, [LEFT, UP]] = 0.3
    simulation.decide()
    simulation.sense()
    simulation.decide()
    request = simulation.memory[0, 0]
    assert request[HEADING] == pytest.approx(math.radians(60.0))
    assert request[DIVE] == pytest.approx(0.1 * 3.0 / 12.0)
    assert request[SPEED] == 0.08


def test_it_says_its_velocity_in_world_axes(make_simulation: Make, lily: SimpleNamespace) -> None:
    """Heading north with 0.05 m/s surge, 0.01 m/s sway (west) and 0.02 m/s heave: (-0.01, 0.05, 0.02)."""
    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.5 * math.pi]]], "boids_blt", lily.boids)
    simulation.state[0, 0, 4:7] = (0.05, 0.01, 0.02)
    simulation.sense()
    simulation.decide()
    np.testing.assert_allclose(simulation.said[0, 0, :4], [3.0, -0.01, 0.05, 0.02], rtol=0, atol=1e-15)


@pytest.mark.parametrize("broken", [(math.nan, 0.0, 0.0), (0.0, math.inf, 0.0)])
def test_a_broken_message_is_not_heard(decided: Make, broken: Any) -> None:
    """A message that is no velocity changes nothing."""
    good = [(0.02, 0.01, 0.0)]
    assert decided({}, [*good, broken]) == decided({}, good)
