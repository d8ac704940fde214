"""Poses that come in anyhow make the moments that they were taken at."""

from __future__ import annotations

import random
from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as some

from cocorosim_ros.graph.runs.pose_moments import SILENCE, Moment, PoseMoments

HALF = 500_000_000  # ns


def name(robot: int, stamp: int) -> bytes:
    """Something that stands for a pose."""
    return f"{robot} at {stamp}".encode()


@given(some.integers(1, 4), some.integers(1, 30), some.sampled_from([1, 40_000_000, HALF, 3 * HALF]), some.randoms())
def test_shared_stamps_in_any_order(robots: int, ticks: int, interval: int, chance: random.Random) -> None:
    """Robots with equal stamps are measured at each of them, however late, bunched and interleaved poses come in."""
    moments = PoseMoments(robots, HALF)
    waiting = [list(range(ticks)) for _ in range(robots)]
    found: list[Moment] = []
    while any(waiting):
        robot = chance.choice([robot for robot in range(robots) if waiting[robot]])
        for _ in range(chance.randint(1, 6)):
            if waiting[robot]:
                stamp = waiting[robot].pop(0) * interval
                moments.add(robot, stamp, name(robot, stamp), now=0.0)
        if chance.random() < 0.3:
            found += moments.take(now=0.0)
    found += moments.take(now=0.0)
    stamps = [tick * interval for tick in range(ticks)]
    assert found == [Moment(stamp, [name(robot, stamp) for robot in range(robots)]) for stamp in stamps]
    assert moments.late == 0


def feed(moments: PoseMoments, robot: int, stamps: range, now: float = 0.0) -> None:
    """Give the poses of a robot."""
    for stamp in stamps:
        moments.add(robot, stamp, name(robot, stamp), now)


def test_lost_pose() -> None:
    """A stamp that one robot lacks is no moment; the next one is."""
    moments = PoseMoments(2, HALF)
    feed(moments, 0, range(0, 4 * HALF, HALF))
    for stamp in (0, HALF, 3 * HALF):
        moments.add(1, stamp, name(1, stamp), 0.0)
    assert [moment.stamp_ns for moment in moments.take(0.0)] == [0, HALF, 3 * HALF]


def test_robot_that_falls_silent() -> None:
    """It is waited for, and then it is absent at all moments after its last pose."""
    moments = PoseMoments(2, HALF)
    feed(moments, 0, range(0, 10 * HALF, HALF), now=10.0)
    feed(moments, 1, range(0, 2 * HALF, HALF), now=10.0)
    assert [moment.stamp_ns for moment in moments.take(10.0)] == [0, HALF]
    assert moments.take(10.0 + SILENCE) == []
    rest = moments.take(10.1 + SILENCE)
    assert rest == [Moment(stamp, [name(0, stamp), None]) for stamp in range(2 * HALF, 10 * HALF, HALF)]


def test_robot_that_is_never_seen() -> None:
    """It is absent from the first moment on."""
    moments = PoseMoments(2, HALF)
    feed(moments, 1, range(0, 5 * HALF, HALF), now=0.0)
    assert moments.take(1.0) == []
    assert moments.take(SILENCE + 0.1)[0] == Moment(0, [None, name(1, 0)])


def test_slow_pace_is_no_silence() -> None:
    """When all robots are slow together nobody is absent, however long it takes on the wall clock."""
    moments = PoseMoments(2, HALF)
    for tick in range(5):
        now = 60.0 * tick
        moments.add(0, tick * HALF, name(0, tick * HALF), now)
        assert moments.take(now) == []
        moments.add(1, tick * HALF, name(1, tick * HALF), now + 0.1)
        assert moments.take(now + 0.1) == [Moment(tick * HALF, [name(0, tick * HALF), name(1, tick * HALF)])]


def test_stamps_that_never_coincide() -> None:
    """At 10 Hz each, 50 ms apart, there is a moment every 0.5 s, with the latest pose of each robot before it."""
    moments, found = PoseMoments(2, HALF), []
    for stamp in range(0, 5_000_000_000, 50_000_000):
        robot = stamp // 50_000_000 % 2
        moments.add(robot, stamp, name(robot, stamp), stamp / 1e9)
        found += moments.take(stamp / 1e9)
    assert [later.stamp_ns - moment.stamp_ns for moment, later in pairwise(found)] == [HALF] * 8
    for stamp, poses in found:
        ages = [stamp - int(pose.decode().split()[-1]) for pose in poses if pose]
        assert sorted(ages) == [0, 50_000_000]


def test_poses_of_the_past() -> None:
    """What comes again from the beginning is counted and makes no moment."""
    moments = PoseMoments(1, HALF)
    feed(moments, 0, range(0, 5 * HALF, HALF))
    assert len(moments.take(0.0)) == 5
    feed(moments, 0, range(0, 5 * HALF, HALF))
    assert (moments.take(0.0), moments.late) == ([], 5)
