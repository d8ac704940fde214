"""Readings on the grid of the filter."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.timeline import Timing, TrackReadings, grid_step
from cocorosim_ros.evidence.log import RobotLog, Stream


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


@pytest.mark.parametrize(
    ("linear", "turning", "step"), [(0.02, 0.6, 0.1), (0.8, 0.0, 0.1), (3.2, 0.0, 0.05), (0.0, 16.0, 0.05)]
)
def test_fast_vehicles_get_small_steps(linear: float, turning: float, step: float) -> None:
    """a h^2 / 8 stays below 1 mm and 5 mrad: 3.2 m/s^2 needs 0.05 s, and so do 16 rad/s^2."""
    assert grid_step(linear, turning) == pytest.approx(step)
