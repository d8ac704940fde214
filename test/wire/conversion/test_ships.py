"""Recordings of two model ships, where they are on this machine: what their maps' comments say of them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

DATA = Path(__file__).resolve().parents[4] / "shared" / "data"
TANKER = DATA / "kvlcc2_hsva" / "HSVA_CPMC_KVLCC2_Z_10_10_P.dat"
POND = DATA / "esso_osaka" / "zigzag" / "zigzag_31-Jul-2020_13_57_45.csv"
Messages = Callable[[Path], dict[str, list[Any]]]

pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the recordings of others are not on this machine")


def test_tanker(tmp_path: Path, messages: Messages) -> None:
    """Velocities in axes of the ship are the derivatives of its places; the rudder to port turns it to the left."""
    convert(load_map(find_config("maps", "kvlcc2_hsva")), TANKER, tmp_path / "bag")
    topics = messages(tmp_path / "bag")
    rows = np.loadtxt(TANKER, skiprows=4, encoding="latin-1")
    pose = [each.content.pose for each in topics["/ship/pose"]]
    place = np.array([[each.position.x, each.position.y] for each in pose])
    yaw = np.unwrap([2.0 * np.arctan2(each.orientation.z, each.orientation.w) for each in pose])
    twist = [each.content.twist for each in topics["/ship/velocity"]]
    rate = np.array([each.content.angular_velocity.z for each in topics["/ship/imu"]])
    speed = np.column_stack([[each.linear.x for each in twist], [each.linear.y for each in twist], rate])
    moved = np.gradient(place, 0.05, axis=0)
    ahead = moved[:, 0] * np.cos(yaw) + moved[:, 1] * np.sin(yaw)
    aside = moved[:, 1] * np.cos(yaw) - moved[:, 0] * np.sin(yaw)
    inner = slice(20, -20)
    assert np.abs(ahead - speed[:, 0])[inner].max() < 0.01
    assert np.abs(aside - speed[:, 1])[inner].max() < 0.01
    assert np.corrcoef(np.gradient(yaw, 0.05)[inner], speed[inner, 2])[0, 1] > 0.99
    command = np.array([each.content.command for each in topics["/ship/thruster_command"]])
    names = list(topics["/ship/thruster_command"][0].content.name)
    np.testing.assert_allclose(command[:, names.index("rudder")], rows[:, 8] / 35.0, atol=1e-12)
    np.testing.assert_allclose(command[:, names.index("propeller")], rows[:, 9] / 12.0, atol=1e-12)
    assert np.corrcoef(command[:-40, names.index("rudder")], np.gradient(speed[:, 2])[:-40])[0, 1] > 0.5


def test_ship_on_a_pond(tmp_path: Path, messages: Messages) -> None:
    """The rudder's sign is turned, and wind and smoothed speeds are not there."""
    convert(load_map(find_config("maps", "esso_osaka")), POND, tmp_path / "bag")
    topics = messages(tmp_path / "bag")
    rows = np.genfromtxt(POND, delimiter=",", skip_header=1)
    assert set(topics) == {"/ship/pose", "/ship/thruster_command"}
    command = np.array([each.content.command for each in topics["/ship/thruster_command"]])
    names = list(topics["/ship/thruster_command"][0].content.name)
    np.testing.assert_allclose(command[:, names.index("rudder")], np.degrees(-rows[:, 8]) / 36.0, atol=1e-9)
    first = topics["/ship/pose"][0].content.pose.position
    assert first.x == pytest.approx(rows[0, 3] + 0.094 * np.sin(rows[0, 5]))  # east
    assert first.y == pytest.approx(rows[0, 1] + 0.094 * np.cos(rows[0, 5]))  # north
