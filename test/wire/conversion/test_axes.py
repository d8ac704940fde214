"""Axes: the cases that can be seen with two hands."""

from __future__ import annotations

import math

import numpy as np
import pytest

from cocorosim_ros.wire.conversion import axes
from cocorosim_ros.wire.conversion.rows import times_factor
from cocorosim_ros.wire.conversion.streams import heading_of_travel, stream_rows

QUARTER = math.pi / 2


def pose(**numbers: float) -> np.ndarray:
    """The position and attitude of one NED pose."""
    columns = {name: np.array([value]) for name, value in numbers.items()}
    return stream_rows("pose", columns, north_east_down=True).values[0]


def turned(quaternion: np.ndarray, vector: list[float]) -> np.ndarray:
    """A body vector in the world, by the rotation matrix of a quaternion x y z w."""
    x, y, z, w = quaternion
    matrix = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return np.array(matrix) @ vector


def test_north_east_down_position() -> None:
    """1 m north, 2 m east, 3 m down is x 2, y 1, z -3."""
    np.testing.assert_array_equal(pose(x=1, y=2, z=3, yaw=0)[:3], [2, 1, -3])


@pytest.mark.parametrize(("yaw", "forward"), [(0, [0, 1, 0]), (QUARTER, [1, 0, 0]), (math.pi, [0, -1, 0])])
def test_north_east_down_heading(yaw: float, forward: list[float]) -> None:
    """Yaw 0 looks north, which is +y; 90 degrees looks east, +x; up stays up."""
    attitude = pose(x=0, y=0, z=0, yaw=yaw)[3:]
    np.testing.assert_allclose(turned(attitude, [1, 0, 0]), forward, atol=1e-15)
    np.testing.assert_allclose(turned(attitude, [0, 0, 1]), [0, 0, 1], atol=1e-15)


def test_nose_up_and_right_side_down() -> None:
    """In forward-right-down, positive pitch lifts the nose, positive roll lowers the right side, so lifts the left."""
    nose = turned(pose(x=0, y=0, z=0, yaw=0, pitch=0.3)[3:], [1, 0, 0])
    left = turned(pose(x=0, y=0, z=0, yaw=0, roll=0.3)[3:], [0, 1, 0])
    np.testing.assert_allclose(nose, [0, math.cos(0.3), math.sin(0.3)], atol=1e-15)
    np.testing.assert_allclose(left, [-math.cos(0.3), 0, math.sin(0.3)], atol=1e-15)


def test_euler_angles_turn_yaw_first() -> None:
    """Yaw 90 degrees, then pitch in the turned axes: forward is +y and down, by the right hand about body left."""
    level = np.zeros(1)
    attitude = axes.quaternion(level, level + 0.3, level + QUARTER)[0]
    np.testing.assert_allclose(turned(attitude, [1, 0, 0]), [0, math.cos(0.3), -math.sin(0.3)], atol=1e-15)


def test_body_vectors_and_compass() -> None:
    """Forward-right-down rates and velocities change sign in y and z; a compass of 90 degrees (east) reads 0."""
    one = {name: np.array([1.0]) for name in ("rate_x", "rate_y", "rate_z")}
    speed = {name: np.array([2.0]) for name in ("x", "y", "z", "yaw_rate")}
    np.testing.assert_array_equal(stream_rows("imu", one, north_east_down=True).values, [[1, -1, -1]])
    np.testing.assert_array_equal(stream_rows("velocity", speed, north_east_down=True).values, [[2, -2, -2, -2]])
    east = stream_rows("compass", {"heading": np.array([QUARTER])}, north_east_down=True).values
    np.testing.assert_array_equal(east, [[0.0]])


def test_angles_are_wrapped() -> None:
    """-pi becomes pi, 270 degrees become -90, and what is in (-pi, pi] keeps every bit."""
    np.testing.assert_array_equal(axes.wrap(np.array([-math.pi, math.pi, 0.1, -3.0])), [math.pi, math.pi, 0.1, -3.0])
    np.testing.assert_allclose(axes.wrap(np.array([3 * QUARTER, -5 * QUARTER])), [-QUARTER, -QUARTER], atol=1e-15)
    assert axes.wrap(np.array([3 * QUARTER]))[0] != 3 * QUARTER


@pytest.mark.parametrize(
    ("number", "factor", "si"),
    [(57.0, "0.01", 0.57), (1.1, "1", 1.1), (90.0, "0.01745329251994329576923690768", QUARTER), (2.0, "1000", 2000.0)],
)
def test_units_give_the_nearest_double(number: float, factor: str, si: float) -> None:
    """57 cm are 0.57 m and not its neighbour."""
    assert times_factor(np.array([number]), factor)[0] == si


def test_heading_of_travel() -> None:
    """East, rest, north, and the last one as before; one that never moves looks along +x."""
    places = np.array([[0, 0, 0], [1, 0, 0], [1, 0, 0], [1, 2, 0.0]])
    np.testing.assert_array_equal(heading_of_travel(places), [0, QUARTER, QUARTER, QUARTER])
    np.testing.assert_array_equal(heading_of_travel(places[1:3]), [0, 0])
