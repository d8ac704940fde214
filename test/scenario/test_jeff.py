"""Jeff: what is known of it, and how the rest is marked."""

from __future__ import annotations

import math

import pytest

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.scenario.reading.yaml_file import load_yaml

ESTIMATED = ("mass", "yaw_inertia", "drag", "yaw_drag")


def test_known_numbers() -> None:
    """25 x 12 x 5 cm, six blue-light sensors of 120 degrees and 50 cm, radio 50 cm."""
    jeff = load_platform("jeff")
    assert (jeff.hull.length, jeff.hull.width, jeff.hull.height) == (0.25, 0.12, 0.05)
    assert jeff.sensors.radio_range == 0.5
    axes = {
        sensor.name: (round(math.degrees(sensor.azimuth)), round(math.degrees(sensor.elevation)))
        for sensor in jeff.sensors.blss
    }
    assert axes == {
        "front": (0, 0),
        "left": (90, 0),
        "back": (180, 0),
        "right": (-90, 0),
        "up": (0, 90),
        "down": (0, -90),
    }
    assert all(sensor.cone_angle == pytest.approx(math.radians(120.0)) for sensor in jeff.sensors.blss)
    assert all(sensor.neighbour_range == 0.5 for sensor in jeff.sensors.blss)


def test_estimates_are_marked_and_follow_from_lily() -> None:
    """Each estimate says so and gives its reasoning; the numbers are those that the reasoning leads to."""
    entries = load_yaml(find_config("platforms", "jeff")).mapping()
    for name in ESTIMATED:
        section = entries[name].mapping()
        assert section["confidence"].value == "estimate"
        assert section["note"].text()
    jeff, lily = load_platform("jeff"), load_platform("lily")
    assert jeff.mass == pytest.approx(0.44 * 1500 / 910, rel=0.01)
    assert jeff.drag == pytest.approx(lily.drag * 60 / 70, rel=0.01)
    assert jeff.yaw_drag == pytest.approx(lily.yaw_drag * 5 * 25**4 / (7 * 13**4), rel=0.01)
    spread = (0.25**2 + 0.12**2) / (0.13**2 + 0.10**2)
    assert jeff.yaw_inertia == pytest.approx(lily.yaw_inertia * jeff.mass / lily.mass * spread, rel=0.01)


def test_it_is_neutral() -> None:
    """The pump's neutral volume carries the mass."""
    jeff = load_platform("jeff")
    pump = next(part for part in jeff.actuators if part.kind == "buoyancy")
    assert pump.neutral_volume * jeff.water_density == pytest.approx(jeff.mass)
