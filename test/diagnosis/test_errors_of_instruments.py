"""Errors of speed logs, poses and compasses, put into readings by NumPy: named with their number, and only there.

The swims are the simulator's, the errors follow from geometry alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.scenario.parts.platform import load_platform

SECONDS = 100.0
Alter = Callable[[Any], Any]


def altered(evidence: Any, topic: str, change: Callable[[Any, Any], Any]) -> Any:
    """Evidence of the same swim, in which the values of one stream are what `change` makes of them and of the log."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    stream = log.streams[topic]
    streams = {**log.streams, topic: replace(stream, value=change(stream.value.copy(), log))}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def scaled(value: Any, log: Any) -> Any:
    """A log that shows 6 % too much."""
    return 1.06 * value


def turned(value: Any, log: Any) -> Any:
    """A log whose axes are turned by 0.1 rad to the left: what goes straight ahead seems to go to the right."""
    ahead, left = value[:, 0].copy(), value[:, 1].copy()
    value[:, 0], value[:, 1] = (
        ahead * math.cos(0.1) + left * math.sin(0.1),
        left * math.cos(0.1) - ahead * math.sin(0.1),
    )
    return value


def aside(value: Any, log: Any) -> Any:
    """A log 0.03 m before the origin, and 0.012 m to the right of it; the gyroscope comes with every other pose."""
    rate = np.interp(log.streams["velocity"].time, log.streams["imu"].time, log.streams["imu"].value[:, 0])
    value[:, 0] += 0.012 * rate
    value[:, 1] += 0.03 * rate
    return value


def askew(value: Any, log: Any) -> Any:
    """A marker that shows 4.1 degrees too much of heading."""
    value[:, 3] += math.radians(4.1)
    return value


def apart(value: Any, log: Any) -> Any:
    """A marker 0.03 m before the origin, and 0.012 m to the right of it."""
    yaw = value[:, 3].copy()
    value[:, 0] += 0.03 * np.cos(yaw) + 0.012 * np.sin(yaw)
    value[:, 1] += 0.03 * np.sin(yaw) - 0.012 * np.cos(yaw)
    return value


def disturbed(value: Any, log: Any) -> Any:
    """A compass that full thrust of both motors turns by 0.08 rad."""
    tick = np.searchsorted(log.command_time, log.streams["compass"].time + 1e-9, side="right") - 1
    value[:, 0] += 0.08 * np.abs(log.command[np.clip(tick, 0, len(log.command) - 1), :2]).mean(axis=1)
    return value


@pytest.mark.parametrize(
    ("identifier", "topic", "change", "numbers"),
    [
        ("speed_log_scale", "velocity", scaled, {"scale": 1.06}),
        ("speed_log_misalignment", "velocity", turned, {"angle": 0.1}),
        ("speed_log_lever", "velocity", aside, {"ahead": 0.03, "left": -0.012}),
        ("pose_heading", "pose", askew, {"offset": math.radians(4.1)}),
        ("pose_lever", "pose", apart, {"ahead": 0.03, "left": -0.012}),
        ("motor_field", "compass", disturbed, {"field": 0.08}),
    ],
)
def test_it_is_named_with_its_number(
    swim_with_log: Any, identifier: str, topic: str, change: Callable[[Any, Any], Any], numbers: dict[str, float]
) -> None:
    """It alone, and the truth lies in the 95 % interval of each number, which is narrower than the error itself."""
    evidence = altered(swim_with_log(load_platform("lily"), SECONDS, 31), topic, change)
    found = diagnose(evidence, lambda words, share: None)
    assert [effect.id for effect in found.effects] == [identifier]
    for name, true in numbers.items():
        estimate = found.effects[0].parameters[name]
        assert estimate.holds(true), (name, estimate)
        assert estimate.high - estimate.low < abs(true - (identifier == "speed_log_scale")), (name, estimate)


@pytest.mark.parametrize(
    ("identifier", "change", "number", "true"),
    [
        ("ground_log_scale", scaled, "scale", 1.06),
        ("ground_log_misalignment", turned, "angle", 0.1),
        ("ground_log_lever", aside, "ahead", 0.03),
    ],
)
def test_of_two_logs_the_one_over_ground_is_named(
    swim_with_logs: Any, identifier: str, change: Callable[[Any, Any], Any], number: str, true: float
) -> None:
    """In water at rest both should show the same; poses say which one does not."""
    evidence = altered(swim_with_logs(load_platform("lily"), SECONDS, 31), "ground_velocity", change)
    (found,) = diagnose(evidence, lambda words, share: None).effects
    assert (found.id, found.topic) == (identifier, "ground_velocity")
    assert found.parameters[number].holds(true)


def test_nothing_is_named_of_good_instruments(swim_with_log: Any) -> None:
    """The same swim as it was recorded."""
    found = diagnose(swim_with_log(load_platform("lily"), SECONDS, 31), lambda words, share: None)
    assert [effect.id for effect in found.effects] == []
