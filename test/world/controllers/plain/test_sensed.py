"""What a plain Python controller is given: its robot's readings by name, and nothing that it could change."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers.plain.sensed import Sensed, Senses
from cocorosim_ros.world.state.observation import blank_observation
from cocorosim_ros.world.state.radio import MESSAGE_SIZE

KEEP = "class Mine:\n    def __call__(self, sensed):\n        return {}\n"


@pytest.fixture
def see(robot_with: Callable[..., RobotDescription]) -> Callable[..., Sensed]:
    """Function of what is otherwise than blank: what a Lily's controller is given."""

    def of(platform: str = "lily", **seen: Any) -> Sensed:
        return Senses(robot_with(KEEP, platform=platform)).see(blank_observation(5, 4)._replace(**seen))

    return of


def test_readings_by_name(see: Callable[..., Sensed]) -> None:
    """1.5 m of water are 14715 Pa more than the surface's 101325; ranges and axes go by the sensors' names."""
    seen = see(time=3.5, compass=0.25, pressure=101325.0 + 14715.0, neighbour_range=np.array([0.3, 0.4, 0.2, 0.1, 0.5]))
    assert (seen.robot, seen.time, seen.heading) == ("lily_01", 3.5, 0.25)
    assert seen.depth == pytest.approx(1.5, abs=1e-12)
    names = ["front_left", "front_right", "back", "up", "down"]
    assert dict(seen.neighbour_range) == dict(zip(names, [0.3, 0.4, 0.2, 0.1, 0.5], strict=True))
    assert seen.sensor_axis["front_left"] == pytest.approx((0.5, math.sqrt(0.75), 0.0))
    assert seen.actuators == ("left", "right", "buoyancy")


def test_nothing_known(see: Callable[..., Sensed]) -> None:
    """Instruments that gave nothing show NaN, ranges +inf (also those that are NaN), inboxes are empty."""
    seen = see(obstacle_range=np.array([math.nan, 0.2, math.inf, math.inf, math.inf]))
    assert all(math.isnan(value) for value in (seen.heading, seen.pressure, seen.depth, seen.illuminance))
    assert np.isnan(seen.velocity).all() and np.isnan(seen.angular_rate).all()
    assert list(seen.neighbour_range.values()) == [math.inf] * 5
    assert list(seen.obstacle_range.values()) == [math.inf, 0.2, math.inf, math.inf, math.inf]
    assert (seen.heard, seen.heard_by_light, seen.neighbour_offset.shape) == ((), (), (0, 3))


def test_messages_are_their_numbers(see: Callable[..., Sensed]) -> None:
    """Of each row, as many numbers as its length says; rows behind the count are old."""
    rows = np.zeros((4, MESSAGE_SIZE))
    rows[0, :3], rows[1, :2], rows[2, :2] = (2.0, 0.5, -0.5), (1.0, 7.0), (1.0, 9.0)
    assert see(heard=rows, heard_count=2).heard == ((0.5, -0.5), (7.0,))


def test_an_instrument_that_the_platform_lacks(see: Callable[..., Sensed]) -> None:
    """The floater has neither compass nor IMU: what the simulation knows all the same is not shown."""
    assert not load_platform("floater").sensors.compass
    seen = see("floater", compass=0.3, pressure=101325.0, angular_rate=np.ones(3), specific_force=np.ones(3))
    assert math.isnan(seen.heading) and seen.depth == 0.0
    assert np.isnan(seen.angular_rate).all() and np.isnan(seen.specific_force).all()
    assert not seen.neighbour_range


def test_nothing_can_be_changed(see: Callable[..., Sensed]) -> None:
    """Neither fields nor arrays nor mappings; and what is given once stays when the simulation's arrays change."""
    rate = np.array([0.1, 0.2, 0.3])
    seen = see(angular_rate=rate)
    rate[:] = 9.0
    assert seen.angular_rate.tolist() == [0.1, 0.2, 0.3]
    with pytest.raises(AttributeError):
        seen.heading = 1.0  # type: ignore[misc]
    with pytest.raises(ValueError, match="read-only"):
        seen.velocity[0] = 1.0
    with pytest.raises(TypeError):
        seen.neighbour_range["up"] = 0.1  # type: ignore[index]
