"""Paths lead to the numbers that they name."""

from __future__ import annotations

import math
from typing import Any

import pytest

from cocorosim_ros.wire.cdr import field_paths
from cocorosim_ros.wire.cdr.type_store import build


def scan() -> Any:
    """A scan of two sensors."""
    readings = [{"sensor": "front", "azimuth": 0.25}, {"sensor": "left", "azimuth": 1.5}]
    return build("cocorosim_msgs/msg/BlssScan", {"readings": readings})


def read(message: Any, path: str) -> float:
    """The number at a path."""
    return field_paths.read(message, field_paths.steps(path))


def test_nested_fields() -> None:
    """Words with dots go from message to message."""
    pose = build("geometry_msgs/msg/PoseStamped", {"pose": {"position": {"y": 2.5}}})
    assert read(pose, "pose.position.y") == 2.5


def test_elements_by_name_and_by_position() -> None:
    """A sensor is found by its name, a command by the name beside it, a payload by its position."""
    assert read(scan(), "readings[left].azimuth") == 1.5
    assert read(scan(), "readings[#0].azimuth") == 0.25
    command = build("cocorosim_msgs/msg/ThrusterCommand", {"name": ["right", "left"], "command": [0.1, 0.2]})
    assert read(command, "command[left]") == 0.2
    radio = build("cocorosim_msgs/msg/RadioMessage", {"sender": "lily_02", "payload": [1.0, 3.0]})
    assert read(radio, "payload[1]") == 3.0


@pytest.mark.parametrize("path", ["readings[back].azimuth", "readings[#7].azimuth"])
def test_what_is_not_there_is_nan(path: str) -> None:
    """An element that the message does not hold reads as NaN."""
    assert math.isnan(read(scan(), path))


@pytest.mark.parametrize("path", ["", ".", "pose.", "pose..x", "a b", "a[b"])
def test_what_is_no_path(path: str) -> None:
    """Broken paths are refused."""
    with pytest.raises(ValueError, match="not a path"):
        field_paths.steps(path)


def test_all_times_are_found() -> None:
    """Every Time in a message is listed, also those inside lists."""
    inbox = build("cocorosim_msgs/msg/RadioInbox", {"messages": [{}, {}]})
    assert field_paths.times_in(inbox) == [
        "header.stamp",
        "messages[#0].header.stamp",
        "messages[#1].header.stamp",
    ]
