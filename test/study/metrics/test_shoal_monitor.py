"""The streaming monitor."""

from __future__ import annotations

import json

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.study.metrics.shoal_monitor import ShoalMonitor

from .swarm_poses import STEP_NS, Poses, aligned, measured, two_clusters, wandering


def watched(poses: Poses, stamps: list[int] | None = None) -> ShoalMonitor:
    """A monitor that has seen all ticks."""
    monitor = ShoalMonitor(poses.yaw.shape[1])
    for tick in range(poses.yaw.shape[0]):
        stamp = 7 + tick * STEP_NS if stamps is None else stamps[tick]
        monitor.update(stamp, poses.position[tick], poses.yaw[tick], poses.present[tick])
    return monitor


def test_stream_gives_the_bits_of_the_kernel() -> None:
    """Tick by tick with stamps from anywhere equals the kernel's values."""
    poses = wandering(1)
    assert watched(poses).series.tobytes() == measured(poses).tobytes()


def test_stream_grows_beyond_its_first_room() -> None:
    """Three thousand ticks are kept, with their stamps."""
    monitor = watched(wandering(2, ticks=3000, robots=2))
    assert monitor.series.shape == (3000, len(METRICS))
    np.testing.assert_array_equal(monitor.stamps_ns, 7 + STEP_NS * np.arange(3000))


def test_speed_uses_the_stamps() -> None:
    """The aligned swarm moves 0.05 m: at 1 s between the stamps that is 0.05 m/s."""
    summary = watched(aligned(), [0, 10**9]).summary()
    assert summary["metrics"]["shoal_speed"]["value"] == pytest.approx(0.05, abs=1e-13)


def test_summary_is_json_and_says_units() -> None:
    """The summary survives strict JSON, and undefined numbers are null."""
    summary = json.loads(json.dumps(watched(two_clusters()).summary(), allow_nan=False))
    assert summary["metrics"]["separation"]["unit"] == "m"
    assert summary["metrics"]["separation"]["value"] == pytest.approx(1.05)
    assert [name for name, entry in summary["metrics"].items() if entry["paper"]] == list(PAPER_METRICS)
    both = two_clusters()
    one = watched(Poses(both.position[:, :1], both.yaw[:, :1], both.present[:, :1])).summary()
    assert one["metrics"]["separation"]["value"] is None


def test_absent_robots_and_bad_poses_are_counted_and_said() -> None:
    """A robot is absent at tick 2, another has a NaN at tick 5: two such ticks, one such pose, two notes."""
    poses = wandering(3)
    poses.present[2, 1] = False
    poses.position[5, 0, 0] = np.nan
    summary = watched(poses).summary()
    assert (summary["ticks"], summary["robots"]) == (12, 11)
    assert summary["ticks_with_absent_robots"] == 2
    assert summary["poses_not_finite"] == 1
    assert len(summary["notes"]) == 2


def test_a_stamp_that_does_not_grow_is_refused() -> None:
    """A repeated stamp would be a speed of infinity."""
    monitor = watched(two_clusters())
    with pytest.raises(CocorosimError, match="stamps must grow"):
        monitor.update(7 + STEP_NS, two_clusters().position[0], two_clusters().yaw[0])


def test_reset_starts_a_new_run() -> None:
    """After a reset the same poses give the same values, and earlier stamps are welcome."""
    poses = wandering(4)
    monitor = watched(poses)
    first = monitor.series
    monitor.reset()
    for tick in range(12):
        monitor.update(tick * STEP_NS, poses.position[tick], poses.yaw[tick])
    assert monitor.series.tobytes() == first.tobytes()


def test_returned_values_are_the_callers_own() -> None:
    """Changing a returned array does not change the run."""
    poses = wandering(5)
    monitor = ShoalMonitor(11)
    monitor.update(0, poses.position[0], poses.yaw[0])[:] = -1.0
    assert (monitor.series != -1.0).any()
