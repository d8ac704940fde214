"""Tracks with their own rates, gaps and faults."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.metrics import sampling
from cocorosim_ros.study.metrics.from_tracks import measure_samples, plan_samples, sample_tracks
from cocorosim_ros.study.metrics.shoal_monitor import ShoalMonitor
from cocorosim_ros.world.state.pose_track import PoseTrack

from .swarm_poses import STEP_NS, wandering

SECOND = 1_000_000_000


def straight(stamps: np.ndarray, speed: float = 0.1, side: float = 0.0) -> PoseTrack:
    """A robot that swims along +x at this speed [m/s] and turns 0.5 rad/s counter-clockwise."""
    seconds = np.asarray(stamps) / 1e9
    position = np.column_stack([speed * seconds, np.full(seconds.shape, side), np.full(seconds.shape, -1.0)])
    yaw = np.angle(np.exp(0.5j * seconds))
    return PoseTrack(np.asarray(stamps, np.int64), position, yaw)


def every(milliseconds: float, seconds: float = 10.0, first: float = 0.0) -> np.ndarray:
    """Stamps [ns]."""
    return np.arange(first * 1e9, seconds * 1e9 + 1, milliseconds * 1e6).astype(np.int64)


def test_shared_stamps_give_the_live_bits() -> None:
    """Tracks of a lock-step run give, bit for bit, the values that a live monitor gave."""
    poses = wandering(1, ticks=40)
    stamps = 3 + STEP_NS * np.arange(40)
    live = ShoalMonitor(11)
    for tick in range(40):
        live.update(int(stamps[tick]), poses.position[tick], poses.yaw[tick])
    tracks = {f"lily_{i:02d}": PoseTrack(stamps, poses.position[:, i], poses.yaw[:, i]) for i in range(11)}
    samples = sample_tracks(tracks)
    np.testing.assert_array_equal(samples.stamp_ns, stamps)
    assert samples.findings == ()
    assert measure_samples(samples).series.tobytes() == live.series.tobytes()


def test_different_rates_are_interpolated_exactly_for_straight_lines() -> None:
    """Robots at 10 Hz and 7 Hz with shifted stamps: linear motion and steady turning come out as they are."""
    samples = sample_tracks({"a": straight(every(100)), "b": straight(every(143, first=0.05), side=1.0)})
    seconds = samples.stamp_ns / 1e9
    for robot in range(2):
        there = samples.present[:, robot]
        np.testing.assert_allclose(samples.position[there, robot, 0], 0.1 * seconds[there], atol=1e-12)
        np.testing.assert_allclose(np.exp(1j * samples.yaw[there, robot]), np.exp(0.5j * seconds[there]), atol=1e-9)
    assert "7 to 10 Hz" in samples.findings[0] or "6.99 to 10 Hz" in samples.findings[0]


def test_the_interval_is_the_median_of_the_robots_intervals() -> None:
    """Robots at 100, 200 and 400 ms are sampled every 200 ms, or as asked for."""
    tracks = {name: straight(every(ms)) for name, ms in (("a", 100), ("b", 200), ("c", 400))}
    assert set(np.diff(sample_tracks(tracks).stamp_ns)) == {200_000_000}
    assert set(np.diff(sample_tracks(tracks, interval_ns=50_000_000).stamp_ns)) == {50_000_000}


def test_short_gaps_are_bridged_and_long_ones_are_absences() -> None:
    """At 10 Hz a gap of 0.9 s is interpolated, one of 1.5 s is not, and the finding says so."""
    stamps = every(100)
    seconds = stamps / 1e9
    short = stamps[(seconds <= 2.0) | (seconds >= 2.9)]
    long = stamps[(seconds <= 6.0) | (seconds >= 7.5)]
    samples = sample_tracks({"full": straight(stamps), "long": straight(long), "short": straight(short)})
    t = samples.stamp_ns / 1e9
    assert samples.names == ("full", "long", "short")
    assert samples.present[:, [0, 2]].all()
    np.testing.assert_array_equal(samples.present[:, 1], (t <= 6.0) | (t >= 7.5))
    assert np.isnan(samples.position[~samples.present[:, 1], 1]).all()
    assert any("longest 1.5 s" in sentence for sentence in samples.findings)
    given = sample_tracks({"full": straight(stamps), "long": straight(long)}, gap_limit_ns=2 * SECOND)
    assert given.present.all()


def test_a_slow_robot_is_not_one_long_gap() -> None:
    """A robot with a pose every 2 s among robots at 10 Hz is interpolated by its own median interval."""
    samples = sample_tracks({"fast": straight(every(100)), "slow": straight(every(2000))})
    assert samples.present.all()


def test_before_its_first_and_after_its_last_pose_a_robot_is_absent() -> None:
    """Nothing is extrapolated."""
    samples = sample_tracks({"a": straight(every(100)), "b": straight(every(100, seconds=6.0, first=2.0))})
    t = samples.stamp_ns / 1e9
    np.testing.assert_array_equal(samples.present[:, 1], (t >= 2.0) & (t <= 6.0))
    monitor = measure_samples(samples)
    assert monitor.summary()["ticks_with_absent_robots"] == np.count_nonzero(~samples.present[:, 1])
    assert np.isfinite(monitor.series[1:, 0]).all()


def test_yaw_takes_the_shorter_arc() -> None:
    """Between 170 and -170 degrees lies 180, not 0."""
    yaw = np.radians([170.0, -170.0])
    track = PoseTrack(np.array([0, SECOND]), np.zeros((2, 3)), yaw)
    middle = sample_tracks({"a": track}, interval_ns=SECOND // 2).yaw[1, 0]
    assert abs(middle) == pytest.approx(np.pi)


def test_duplicates_disorder_and_bad_poses_are_left_out_and_said() -> None:
    """The cleaned track gives what the clean one gives, and three sentences tell what was done."""
    clean = straight(every(100))
    order = np.r_[0:20, 22, 21, 20, 23 : clean.stamp_ns.size, 50]
    position, yaw = clean.position[order].copy(), clean.yaw[order].copy()
    stamps = np.insert(clean.stamp_ns[order], 30, clean.stamp_ns[order][29] + 5)
    position = np.insert(position, 30, np.nan, axis=0)
    yaw = np.insert(yaw, 30, 0.0)
    samples = sample_tracks({"a": PoseTrack(stamps, position, yaw)})
    np.testing.assert_array_equal(samples.position[:, 0], clean.position)
    assert sum("not finite" in s for s in samples.findings) == 1
    assert sum("out of order" in s for s in samples.findings) == 1
    assert sum("repeated a stamp" in s for s in samples.findings) == 1


def test_a_robot_without_poses_is_absent_and_named() -> None:
    """An empty track keeps its column."""
    empty = PoseTrack(np.empty(0, np.int64), np.empty((0, 3)), np.empty(0))
    samples = sample_tracks({"a": straight(every(100)), "silent": empty})
    assert not samples.present[:, 1].any()
    assert any(sentence.startswith("silent has no usable pose") for sentence in samples.findings)


def test_nobody_has_poses() -> None:
    """That is an error with a sentence."""
    with pytest.raises(CocorosimError, match="No robot has a usable pose"):
        sample_tracks({})


def test_clocks_that_are_years_apart_are_refused() -> None:
    """One robot in 1970 and one today would be billions of moments."""
    late = straight(every(100))
    late = PoseTrack(late.stamp_ns + 1_700_000_000 * SECOND, late.position, late.yaw)
    with pytest.raises(CocorosimError, match="one clock"):
        sample_tracks({"a": straight(every(100)), "b": late})


def test_an_interval_must_be_positive() -> None:
    """Zero is refused with a sentence."""
    with pytest.raises(CocorosimError, match="must be positive"):
        sample_tracks({"a": straight(every(100))}, interval_ns=0)


def test_a_single_pose_is_one_moment() -> None:
    """A robot seen once gives one tick."""
    samples = sample_tracks({"a": straight(np.array([5]))})
    assert samples.present.tolist() == [[True]]
    assert measure_samples(samples).summary()["ticks"] == 1


@pytest.mark.parametrize("interval_ns", [None, SECOND // 3])
@pytest.mark.parametrize("lock_step", [True, False])
def test_parts_give_what_the_whole_gives(
    monkeypatch: pytest.MonkeyPatch, lock_step: bool, interval_ns: int | None
) -> None:
    """One clock, or gaps and rates of their own, two moments at a time: the same values and findings."""
    other = every(100) if lock_step else np.concatenate([every(143, seconds=4.0), every(143, first=7.0)])
    tracks = {"a": straight(every(100)), "b": straight(other, side=0.3), "c": straight(np.empty(0))}
    whole = sample_tracks(tracks, interval_ns)
    monkeypatch.setattr(sampling, "POSES_AT_ONCE", 6)
    plan = plan_samples(tracks, interval_ns)
    parts = list(plan.parts())
    assert plan.findings == whole.findings and {len(part.stamp_ns) for part in parts} <= {1, 2}
    for name in ("stamp_ns", "position", "yaw", "present"):
        np.testing.assert_array_equal(np.concatenate([getattr(part, name) for part in parts]), getattr(whole, name))
    assert measure_samples(plan).series.tobytes() == measure_samples(whole).series.tobytes()
