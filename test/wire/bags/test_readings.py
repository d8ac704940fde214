"""The readings of every topic of numbers, from messages whose numbers are known."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.units.unit_algebra import powers_of
from cocorosim_ros.wire.bags.readings import READABLE, topic_readings
from cocorosim_ros.wire.cdr.type_store import build, serialize
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS

AXES = ("x", "y", "z")
BLSS = {"readings": [{"sensor": "up", "neighbour_range": math.inf, "obstacle_range": 0.25}]}
# Topic, the message's content, and its columns.
CASES: dict[str, tuple[dict[str, Any], dict[str, float]]] = {
    "compass": ({"heading": 1.5, "variance": 0.01}, {"heading": 1.5, "variance": 0.01}),
    "pressure": ({"fluid_pressure": 105000.0, "variance": 4.0}, {"pressure": 105000.0, "variance": 4.0}),
    "imu": (
        {
            "orientation": dict(zip((*AXES, "w"), (0.1, 0.2, 0.3, 0.9), strict=True)),
            "orientation_covariance": [-1.0, *[7.0] * 8],
            "angular_velocity": dict(zip(AXES, (1.0, 2.0, 3.0), strict=True)),
            "angular_velocity_covariance": [8.0] * 9,
            "linear_acceleration": dict(zip(AXES, (4.0, 5.0, 9.81), strict=True)),
        },
        {f"angular_rate_{axis}": value for axis, value in zip(AXES, (1.0, 2.0, 3.0), strict=True)}
        | {f"specific_force_{axis}": value for axis, value in zip(AXES, (4.0, 5.0, 9.81), strict=True)},
    ),
    "velocity": (
        {
            "twist": {
                "linear": dict(zip(AXES, (0.1, 0.2, 0.3), strict=True)),
                "angular": dict(zip(AXES, (0.4, 0.5, 0.6), strict=True)),
            }
        },
        dict(zip("uvwpqr", (0.1, 0.2, 0.3, 0.4, 0.5, 0.6), strict=True)),
    ),
    "blss": (BLSS, {"up.neighbour_range": math.inf, "up.obstacle_range": 0.25}),
    "illuminance": ({"illuminance": 300.0, "variance": 9.0}, {"illuminance": 300.0, "variance": 9.0}),
    "concentration": ({"concentration": 0.002, "variance": 0.0}, {"concentration": 0.002, "variance": 0.0}),
    "thruster_command": (
        {"name": ["left", "buoyancy"], "command": [-0.5, 1.0]},
        {"left": -0.5, "buoyancy": 1.0},
    ),
    "actuator_feedback": (
        {"name": ["left.rotation", "left.current", "rudder.angle"], "value": [40.0, 1.5, -0.25]},
        {"left.rotation": 40.0, "left.current": 1.5, "rudder.angle": -0.25},
    ),
}
CASES["ground_velocity"] = CASES["velocity"]


def message(topic: str, values: dict[str, Any], seconds: int) -> bytes:
    """The bytes of a message of this topic."""
    header = {"stamp": {"sec": seconds, "nanosec": 250_000_000}, "frame_id": "boat/base_link"}
    return serialize(build(ROBOT_TOPICS[topic].type_name, {"header": header, **values}))


@pytest.mark.parametrize("topic", READABLE)
def test_columns_are_the_numbers_of_the_message(topic: str) -> None:
    """By name, at the stamp of the header, in a unit that can be taken apart; what is cut short is counted."""
    values, columns = CASES[topic]
    whole = message(topic, values, 7)
    readings = topic_readings("boat", topic, [whole, whole[:20], message(topic, values, 6)])
    assert readings.stamp_ns.tolist() == [7_250_000_000, 6_250_000_000]
    assert readings.time.tolist() == [7.25, 6.25]
    assert dict(zip(readings.columns, readings.values[0].tolist(), strict=True)) == columns
    np.testing.assert_array_equal(readings.values[0], readings.values[1])
    assert readings.unreadable == 1
    assert len(readings.units) == len(readings.columns)
    assert all(set(powers_of(unit)) <= {"m", "s", "rad", "kg", "Pa", "lx", "A"} for unit in readings.units)


@pytest.mark.parametrize("topic", READABLE)
def test_no_message_gives_no_row(topic: str) -> None:
    """The arrays are empty, with as many columns as are known."""
    readings = topic_readings("boat", topic, [])
    assert readings.values.shape == (0, len(readings.columns))
    assert (readings.stamp_ns.size, readings.unreadable) == (0, 0)


def test_a_sensor_without_a_layout_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of each robot, in a sentence: nothing that was recorded is left out in silence."""
    from cocorosim_ros.wire.bags import readings
    from cocorosim_ros.wire.bags.bag_reader import read_bag

    bag = read_bag(Path(__file__).parents[3] / "bags" / "five_lilys" / "bag")
    assert readings.readable_topics(bag)[1] == []
    compass = ROBOT_TOPICS["compass"].type_name
    numbers_of = readings.numbers_of
    monkeypatch.setattr(readings, "numbers_of", lambda type_name: () if type_name == compass else numbers_of(type_name))
    findings = readings.readable_topics(bag)[1]
    assert len(findings) == 5
    assert findings[0].startswith("/lily_01/compass is left out: cocorosim_msgs/msg/Compass is more than numbers")


def test_each_quantity_of_an_actuator_has_its_unit() -> None:
    """Rotations in rad/s, angles in rad, currents in A, voltages in V, fractions of the maximum without one."""
    names = [f"left.{quantity}" for quantity in ("fraction", "rotation", "angle", "current", "voltage")]
    values = {"name": names, "value": [0.5, 1.0, 2.0, 3.0, 4.0]}
    readings = topic_readings("boat", "actuator_feedback", [message("actuator_feedback", values, 1)])
    assert dict(zip(readings.columns, readings.units, strict=True)) == dict(
        zip(names, ("1", "rad/s", "rad", "A", "V"), strict=True)
    )
