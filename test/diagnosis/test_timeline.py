"""Readings on the grid of the filter."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.tracks.timeline import Timing, TrackReadings, grid_begin, grid_step


def gyro(values: list[float], every: float = 0.02) -> RobotLog:
    """A robot whose yaw rate alone is read."""
    time = every * np.arange(len(values))
    numbers = np.full((len(values), 4), np.nan)
    numbers[:, 0] = values
    return RobotLog("lily_01", np.zeros(1), np.zeros((1, 3)), {"imu": Stream(time, numbers, np.full(4, 0.01))})


def test_readings_between_two_grid_points_are_averaged() -> None:
    """Five readings around a grid point become their mean, five times as certain; missing ones do not count."""
    log = gyro([0.0] * 3 + [1.0, 2.0, np.nan, 4.0, 5.0] + [0.0] * 3)
    readings = TrackReadings(log, 0.1, 0.0, 0.2)
    point = np.rint(readings.stamp / 0.1).astype(int)
    chosen = point == 1
    assert readings.value[chosen] == pytest.approx([3.0])
    assert readings.share[chosen] == pytest.approx([0.25])


def test_a_late_stream_tells_of_earlier_moments() -> None:
    """With a latency of 0.25 s and a clock that gains 1 %, a stamp of 5 s is about (5 - 0.25) / 1.01 s."""
    readings = TrackReadings(gyro([0.0] * 101, every=0.1), 0.1, 0.0, 10.0)
    moved = readings.timeline(Timing({"imu": 0.25}, {"imu": 0.01}))
    points = np.repeat(np.arange(len(moved.first) - 1), np.diff(moved.first))
    moments = points * 0.1 + moved.after
    row = int(np.argmin(np.abs(moved.stamp - 5.0)))
    assert moments[row] == pytest.approx((5.0 - 0.25) / 1.01)


def test_an_average_knows_on_which_side_of_the_grid_point_it_was() -> None:
    """Fifty readings from 0.03 s before to 0.07 s after a grid point: mean distance and mean sign as counted."""
    every = 0.002
    offsets = every * np.arange(50) - 0.03
    readings = TrackReadings(gyro([1.0] * 50, every=every), 0.2, 0.03, 0.1)
    moved = readings.timeline()
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
