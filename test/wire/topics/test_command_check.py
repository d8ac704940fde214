"""Commands of actuators and of sticks, as the physics node hears them."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.command_check import CommandReader

STEERED = """\
based_on: lily
name: steered
description: Lily by sticks, its pump by itself
mixing:
  form: table
  rows:
    - {actuator: left, weights: {value: [1, 0, 0, 0, 0, -1], unit: "1", source: made}}
    - {actuator: right, weights: {value: [1, 0, 0, 0, 0, 1], unit: "1", source: made}}
"""


@pytest.fixture
def steered(tmp_path: Path) -> Platform:
    """Lily with the sticks surge and yaw."""
    (tmp_path / "steered.yaml").write_text(STEERED)
    return load_platform(tmp_path / "steered.yaml")


def reader(platform: Platform) -> CommandReader:
    """That of a robot of this platform."""
    names = platform.actuator_names
    return CommandReader(BodyDescription("lily_01", (), names, (), speaks=False, mixing=platform.stick_mixing()))


def message(**commands: float) -> bytes:
    """The bytes of a command by names."""
    content = {"name": list(commands), "command": [0.0] * len(commands)}
    template = build("cocorosim_msgs/msg/ThrusterCommand", content)
    return PackedMessage([template], [f"command[{name}]" for name in commands]).encode(0, list(commands.values()))[0]


@pytest.mark.parametrize(
    ("asked", "fractions"),
    [
        ({"surge": 0.5, "yaw": 0.25, "buoyancy": -0.5}, [0.25, 0.75, -0.5]),
        ({"buoyancy": -0.5, "yaw": 1.0, "surge": 1.0}, [0.0, 1.0, -0.5]),
        ({"left": 0.25, "right": 0.75, "buoyancy": -0.5}, [0.25, 0.75, -0.5]),
    ],
)
def test_sticks_and_actuators(steered: Platform, asked: dict[str, float], fractions: list[float]) -> None:
    """In any order; what no stick drives is commanded by its own name beside them."""
    found, complaint = reader(steered).read(message(**asked))
    assert (found.tolist(), complaint) == (fractions, "")


def test_sticks_that_are_missing_or_too_far_out_are_said(steered: Platform) -> None:
    """They rest, or are at their end, as actuators are off or at their limit."""
    found, complaint = reader(steered).read(message(surge=1.5, buoyancy=0.0))
    assert found.tolist() == [1.0, 1.0, 0.0]
    assert complaint == "'surge' is 1.5, beyond -1..1, and is cut; 'yaw' is not a number or not given, so it is off"


@pytest.mark.parametrize("asked", [{"surge": 1.0, "left": 1.0}, {"roll": 1.0}, {"surge": 1.0, "rudder": 1.0}])
def test_what_cannot_be_followed_turns_all_off(steered: Platform, asked: dict[str, float]) -> None:
    """A stick beside what it drives, a stick that there is not, an actuator that there is not."""
    found, complaint = reader(steered).read(message(**asked))
    assert found.tolist() == [0.0, 0.0, 0.0]
    assert "its command is not used, all actuators are off" in complaint
    assert "names sticks, or in their place what they drive, 'left' and 'right'." in complaint


def test_without_mixing_there_are_no_sticks() -> None:
    """As ever: a name that the robot does not have turns all off."""
    found, complaint = reader(load_platform("lily")).read(message(surge=1.0))
    assert found.tolist() == [0.0, 0.0, 0.0]
    assert "'surge'" in complaint and "stick" not in complaint
    told = reader(load_platform("lily")).read(message(left=1.0, right=0.5, buoyancy=0.0))
    assert (told[0].tolist(), told[1]) == ([1.0, 0.5, 0.0], "")
