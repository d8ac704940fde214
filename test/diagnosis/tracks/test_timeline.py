"""Readings on the grid of the filter."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL
from cocorosim_ros.diagnosis.tracks.grid import grid_begin, grid_step
from cocorosim_ros.diagnosis.tracks.timeline import Timeline, Timing


def gyro(values: list[float], every: float = 0.02) -> RobotLog:
    """A robot whose yaw rate alone is read."""
    time = every * np.arange(len(values))
    numbers = np.full((len(values), 4), np.nan)
    numbers[:, 0] = values
    return RobotLog("lily_01", np.zeros(1), np.zeros((1, 3)), {"imu": Stream(time, numbers, np.full(4, 0.01))})


def test_readings_between_two_grid_points_are_averaged() -> None:
    """Five readings around a grid point become their mean, five times as certain; missing ones do not count."""
    log = gyro([0.0] * 3 + [1.0, 2.0, np.nan, 4.0, 5.0] + [0.0] * 3)
    timeline = Timeline(log, 0.1, 0.0, 0.2)
    point = np.rint(timeline.stamp / 0.1).astype(int)
    chosen = point == 1
    assert timeline.value[chosen] == pytest.approx([3.0])
    assert timeline.share[chosen] == pytest.approx([0.25])


def test_a_late_stream_tells_of_earlier_moments() -> None:
    """With a latency of 0.25 s and a clock that gains 1 %, a stamp of 5 s is about (5 - 0.25) / 1.01 s."""
    timeline = Timeline(gyro([0.0] * 101, every=0.1), 0.1, 0.0, 10.0)
    moved = timeline.readings(Timing({"imu": 0.25}, {"imu": 0.01}))
    points = np.repeat(np.arange(len(moved.first) - 1), np.diff(moved.first))
    moments = points * 0.1 + moved.after
    row = int(np.argmin(np.abs(moved.stamp - 5.0)))
    assert moments[row] == pytest.approx((5.0 - 0.25) / 1.01)


def test_an_average_knows_on_which_side_of_the_grid_point_it_was() -> None:
    """Fifty readings from 0.03 s before to 0.07 s after a grid point: mean distance and mean sign as counted."""
    every = 0.002
    offsets = every * np.arange(50) - 0.03
    timeline = Timeline(gyro([1.0] * 50, every=every), 0.2, 0.03, 0.1)
    moved = timeline.readings()
    assert len(moved.after) == 1  # those before 0 of the grid are in its average too
    assert moved.after[0] == pytest.approx(offsets.mean())
    assert moved.apart[0] == pytest.approx(np.abs(offsets).mean(), rel=0.01)
    assert moved.side[0] == pytest.approx(np.sign(offsets).mean(), abs=0.03)


@pytest.mark.parametrize(("first", "begin"), [(0.0, 4.9), (0.04, 4.94), (0.93, 4.93)])
def test_the_grid_begins_where_commands_change(first: float, begin: float) -> None:
    """Commands every half second from `first` on: the last multiple of 0.1 s from there at or before 4.98 s."""
    assert grid_begin(first + 0.5 * np.arange(20), 0.1, 4.98) == pytest.approx(begin)


@pytest.mark.parametrize(
    ("linear", "turning", "step"), [(0.02, 0.6, 0.1), (0.8, 0.0, 0.1), (3.2, 0.0, 0.05), (0.0, 16.0, 0.05)]
)
def test_fast_vehicles_get_small_steps(linear: float, turning: float, step: float) -> None:
    """a h^2 / 8 stays below 1 mm and 5 mrad: 3.2 m/s^2 needs 0.05 s, and so do 16 rad/s^2."""
    assert grid_step(linear, turning) == pytest.approx(step)


@pytest.mark.parametrize(("coasting", "step"), [(3.3, 0.1), (16.3, 0.27), (600.0, 1.0)])
def test_slow_vehicles_have_longer_steps(coasting: float, step: float) -> None:
    """A sixtieth of the coasting time, not below that of a Lily, not beyond a second."""
    assert grid_step(0.0, 0.0, coasting) == pytest.approx(step)
    assert grid_step(10.0, 0.0, coasting) == grid_step(10.0, 0.0)


def two_streams() -> RobotLog:
    """Poses at 0, 0.5 and 1 s, the second without x; pressures at 0.1 and 0.52 s."""
    pose = np.array([[1.0, 2.0, -1.0, 0.1], [np.nan, 2.1, -1.1, 0.2], [1.2, 2.2, -1.2, 0.3]])
    streams = {
        "pose": Stream(np.array([0.0, 0.5, 1.0]), pose, np.full(4, 0.01)),
        "pressure": Stream(np.array([0.1, 0.52]), np.array([[1e5], [1.1e5]]), np.array([8.0])),
    }
    return RobotLog("lily_01", np.zeros(1), np.zeros((1, 3)), streams)


def test_readings_stand_in_the_order_of_grid_points_moments_and_kinds() -> None:
    """By hand, on a grid of 0.5 s: 4 poses and the early pressure, 3 poses and the late one, 4 poses."""
    timeline = Timeline(two_streams(), 0.5, 0.0, 1.0)
    found = timeline.readings()
    assert timeline.grid.points == 3
    assert found.first.tolist() == [0, 5, 9, 13]
    assert found.value.tolist() == [1.0, 2.0, -1.0, 0.1, 1e5, 2.1, -1.1, 0.2, 1.1e5, 1.2, 2.2, -1.2, 0.3]
    assert found.after[[4, 8]] == pytest.approx([0.1, 0.02])
    assert found.origin.tolist() == list(range(13))


def test_a_wrong_clock_moves_readings_and_says_where_they_were() -> None:
    """Pressures 0.4 s late are of -0.3 (clipped to the first point) and 0.12 s: both of the first grid point."""
    timeline = Timeline(two_streams(), 0.5, 0.0, 1.0)
    row = NEUTRAL.copy()
    row[COLUMN["sensor_latency.pressure"]] = 0.4
    found = timeline.under(row)
    assert found.first.tolist() == [0, 6, 9, 13]
    assert found.value[:6].tolist() == [1e5, 1.0, 2.0, -1.0, 0.1, 1.1e5]
    assert found.after[[0, 5]] == pytest.approx([-0.3, 0.12])
    np.testing.assert_array_equal(timeline.value[found.origin], found.value)
    np.testing.assert_array_equal(timeline.stamp[found.origin], found.stamp)


def test_a_part_stands_on_the_same_grid() -> None:
    """Two of three grid points: the readings of 0 to 0.5 s alone, or of 0.5 to 1 s."""
    whole = Timeline(two_streams(), 0.5, 0.0, 1.0)
    part = whole.between(0, 2)
    assert part.grid == (0.0, 0.5, 2)
    assert part.value.tolist() == [1.0, 2.0, -1.0, 0.1, 1e5, 2.1, -1.1, 0.2]
    later = whole.between(1, 2)
    assert later.grid == (0.5, 0.5, 2)
    assert later.stamp.min() >= 0.5 and len(later.value) < len(whole.value)


def test_a_stream_can_be_left_out() -> None:
    """Without the pressure, the poses stay as they were."""
    whole = Timeline(two_streams(), 0.5, 0.0, 1.0)
    part = whole.without_stream("pressure")
    assert part.grid == whole.grid
    assert part.value.tolist() == [value for value in whole.value.tolist() if value < 1e4]


def test_only_kinds_that_were_read_are_seen() -> None:
    """x and pressure are, the compass is not; the yaw of the camera alone is an angle."""
    timeline = Timeline(two_streams(), 0.5, 0.0, 1.0)
    assert timeline.sees("compass", "pressure") and not timeline.sees("compass", "gyro_z")
    assert timeline.value[timeline.is_angle].tolist() == [0.1, 0.2, 0.3]
