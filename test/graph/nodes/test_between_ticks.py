"""--smooth: time and transforms between the ticks of a run by the wall clock, as an independent reader finds them."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.highlevel import AnyReader

TICKS, STEPS = 6, 10
TICK_NS = 500_000_000
AT_20_HZ = ("--rate", 0.5, "--smooth", 20)
Messages = list[tuple[int, Any]]


def read(bag: Path, topic: str) -> Messages:
    """Log time [ns] and message of everything on a topic."""
    with AnyReader([bag]) as reader:
        chosen = [connection for connection in reader.connections if connection.topic == topic]
        return [(at, reader.deserialize(data, kind.msgtype)) for kind, at, data in reader.messages(chosen)]


def place(pose: Any) -> list[float]:
    """x, y, z and yaw of a pose or a transform."""
    where, turn = (getattr(pose, name) for name in pose.__dataclass_fields__ if name in {*FIRST, *SECOND})
    return [where.x, where.y, where.z, 2.0 * math.atan2(turn.z, turn.w)]


FIRST, SECOND = ("position", "translation"), ("orientation", "rotation")


def test_the_clock_shows_every_step_and_transforms_lie_between_the_poses(
    begin: Callable[..., tuple[Any, Path]],
) -> None:
    """Every 50 ms of simulated time; each transform on the line from the pose before it to the one after it."""
    run, bag = begin(2, TICKS, options=AT_20_HZ)
    assert run.finish() == 0, run.output
    clock = [message.clock.sec * 10**9 + message.clock.nanosec for _, message in read(bag, "/clock")]
    assert clock == [step * TICK_NS // STEPS for step in range(TICKS * STEPS)]
    poses = {at: np.array(place(message.pose)) for at, message in read(bag, "/lily_02/pose")}
    assert sorted(poses) == [tick * TICK_NS for tick in range(TICKS)]
    shown = {at: place(message.transforms[1].transform) for at, message in read(bag, "/tf")}
    assert shown.keys() <= set(clock)
    assert len(shown) > TICKS, "ticks take a second here; in none of them have both robots answered in time"
    for at, found in shown.items():
        tick, rest = divmod(at, TICK_NS)
        before = poses[tick * TICK_NS]
        after = poses.get((tick + 1) * TICK_NS)
        if after is not None:
            assert found == pytest.approx(before + rest / TICK_NS * (after - before), abs=1e-9)


def test_a_command_stamped_by_the_finer_clock_is_an_answer(
    begin: Callable[..., tuple[Any, Path]], paced: Callable[..., Any]
) -> None:
    """A controller that stamps what it says with the time that /clock shows by then is not taken for a prophet."""
    run, _ = begin(1, TICKS, "lily_01", options=AT_20_HZ)
    paced(run, "lily_01", "late", 0.5).say(*["shortly"] * TICKS)
    assert run.finish() == 0, run.output
    assert "from the future" not in run.output


def test_lock_step_shows_no_time_between_ticks(begin: Callable[..., tuple[Any, Path]]) -> None:
    """One sentence and status 2 before anything begins."""
    run, bag = begin(1, TICKS, options=("--smooth", 20))
    assert run.finish() == 2, run.output
    assert "the run is in lock-step" in run.output
    assert not bag.exists()
