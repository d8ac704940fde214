"""Recordings whose commands are sticks: the evidence is that of what these drive."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.gather import gather_recording
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

Record = Callable[..., Path]
ROW = '    - {actuator: %s, weights: {value: [1, 0, 0, 0, 0, %s], unit: "1", source: made}}\n'
STEERED = "based_on: lily\nname: steered\ndescription: Lily by sticks\n%s" % (
    "mixing:\n  form: table\n  rows:\n" + ROW % ("left", "-1") + ROW % ("right", "1")
)
MAP = """\
name: joystick
format: csv
tables:
  - files: a.csv
    time: {column: t, unit: s}
    robot: lily_01
    streams:
      pose: {x: {column: x, unit: m}, y: {column: y, unit: m}, z: {fixed: -1 m}, yaw: {column: yaw, unit: rad}}
      thruster_command:
        surge: {column: X, unit: N, stop: 0 N, forward: 20 N, reverse: -20 N}
        yaw: {column: N, unit: N m, stop: 0 N m, forward: 4 N m, reverse: -4 N m}
"""


@pytest.fixture
def steered(tmp_path: Path) -> Platform:
    """Lily with the sticks surge and yaw, its pump by itself."""
    (tmp_path / "steered.yaml").write_text(STEERED)
    return load_platform(tmp_path / "steered.yaml")


def by_sticks(circle: dict[str, Any]) -> dict[str, Any]:
    """The recording with sticks for its two thrusters: surge is their mean, yaw half of right less left."""
    commands = circle["/lily_01/thruster_command"]
    left, right, pump = commands.numbers.T
    numbers = np.column_stack([(left + right) / 2, (right - left) / 2, pump])
    return {
        **circle,
        "/lily_01/thruster_command": commands.changed(numbers=numbers, names=("surge", "yaw", "buoyancy")),
    }


def test_the_same_as_by_actuators(record: Record, circle: Any, steered: Platform) -> None:
    """Commands, readings and remarks of both recordings are alike."""
    by_name = gather_recording(record(circle, "names"), steered)
    mixed = gather_recording(record(by_sticks(circle), "sticks"), steered)
    np.testing.assert_allclose(mixed.robots[0].command, by_name.robots[0].command, atol=1e-15)
    np.testing.assert_array_equal(mixed.robots[0].command_time, by_name.robots[0].command_time)
    assert mixed.remarks == by_name.remarks


def test_a_log_of_forces_needs_no_arithmetic(tmp_path: Path, steered: Platform) -> None:
    """10 N of 20 and 1 N m of 4 are half and a quarter: left 1/4, right 3/4; the platform alone says so."""
    (tmp_path / "map.yaml").write_text(MAP)
    rows = "".join(f"{0.1 * row:.1f},{0.01 * row:.2f},0,0,10,1\n" for row in range(100))
    (tmp_path / "a.csv").write_text(f"t,x,y,yaw,X,N\n{rows}")
    convert(load_map(tmp_path / "map.yaml"), tmp_path / "a.csv", tmp_path / "bag")
    found = gather_recording(tmp_path / "bag", steered)
    np.testing.assert_allclose(found.robots[0].command, np.tile([0.25, 0.75, 0.0], (100, 1)), atol=1e-15)
    assert any("buoyancy is never commanded" in remark for remark in found.remarks)


def test_remarks_on_sticks(record: Record, circle: Any, steered: Platform, is_said: Any) -> None:
    """One that nothing moves rests; one beyond its end is at its end."""
    topics = by_sticks(circle)
    commands = topics["/lily_01/thruster_command"]
    alone = commands.changed(numbers=2.0 * commands.numbers[:, :1], names=("surge",))
    found = gather_recording(record({**topics, "/lily_01/thruster_command": alone}), steered)
    assert is_said(found.remarks, "the stick yaw is never commanded and rests")
    assert is_said(found.remarks, "messages command more than the maximum", "cut")
    np.testing.assert_allclose(found.robots[0].command[:, 0], np.clip(alone.numbers[:, 0], -1.0, 1.0))


def test_sticks_beside_what_they_drive(record: Record, circle: Any, steered: Platform) -> None:
    """Nobody can tell which of them the vehicle followed."""
    commands = circle["/lily_01/thruster_command"].changed(names=("left", "surge", "buoyancy"))
    with pytest.raises(
        CocorosimError, match=r"commands sticks \(surge, yaw\) and what they drive \(left, right\) in 400"
    ):
        gather_recording(record({**circle, "/lily_01/thruster_command": commands}), steered)


def test_sticks_without_a_mixing(record: Record, circle: Any, lily_platform: Platform) -> None:
    """The way out is named."""
    commands = circle["/lily_01/thruster_command"]
    sticks = commands.changed(numbers=commands.numbers[:, :2], names=("surge", "yaw"))
    with pytest.raises(CocorosimError, match=r"the sticks surge, yaw, and the platform does not say .* add 'mixing'"):
        gather_recording(record({**circle, "/lily_01/thruster_command": sticks}), lily_platform)
