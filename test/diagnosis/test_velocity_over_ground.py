"""A log over ground in a current: what is carried along is told as the current, on whichever side it comes from.

The swims are the simulator's, in water that moves as a platform's `steady_current` says; the platform of the diagnosis
knows nothing of it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.diagnose_against import diagnose_against
from cocorosim_ros.scenario.parts.platform import load_platform

SECONDS = 60.0
CURRENT = (0.012, -0.02)  # m/s; a Lily makes 0.075 m/s at most
STILL = (0.0, 0.0)
BOTTOM_TRACK = ("pose", "compass", "imu", "ground_velocity")
BOTH_LOGS = ("compass", "imu", "velocity", "ground_velocity")


def carried(swim_with_logs: Any, seeds: tuple[int, ...], current: tuple[float, float], topics: tuple[str, ...]) -> Any:
    """Evidence of a swim for each seed in a current, with these streams alone."""
    plain = load_platform("lily")
    moved = hiding(plain, {"steady_current": dict(zip("xy", current, strict=True))}) if any(current) else plain
    found = []
    for seed in seeds:
        evidence = swim_with_logs(moved, SECONDS, seed, plain, current)
        (recording,) = evidence.recordings
        (log,) = recording.robots
        robots = (replace(log, streams={topic: log.streams[topic] for topic in topics}),)
        found.append(replace(recording, origin=f"recording {seed}", robots=robots))
    return replace(evidence, recordings=tuple(found))


def assert_the_current(diagnosis: Any) -> None:
    """It alone, each part with its sign and inside its interval, which is narrower than half of the part."""
    assert [effect.id for effect in diagnosis.effects] == ["steady_current"]
    for name, true in zip("xy", CURRENT, strict=True):
        estimate = diagnosis.effects[0].parameters[name]
        assert estimate.holds(true), (name, estimate)
        assert estimate.high - estimate.low < 0.5 * abs(true)
    assert_told(diagnosis)


def assert_told(diagnosis: Any) -> None:
    """Velocities over ground and through the water differ by the current that was found, on the course and foretold."""
    current = np.hypot(*(diagnosis.effects[0].parameters[name].value for name in "xy"))
    (course,) = diagnosis.velocities
    assert course.time[-1] - course.time[0] > SECONDS - 1.0
    for velocity in (course.velocity, *(run.velocity for run in diagnosis.free_runs)):
        apart = velocity.over_ground - velocity.through_water
        # Those of free runs have a current of their own, which was fitted without them: within half, as the interval.
        assert np.hypot(apart[:, 0], apart[:, 1]) == pytest.approx(current, rel=0.5)
    apart = course.velocity.over_ground - course.velocity.through_water
    assert np.hypot(apart[:, 0], apart[:, 1]) == pytest.approx(current, rel=1e-9)


def assert_as_the_log_that_was_kept_back(diagnosis: Any, kept: Any) -> None:
    """Speeds ahead and aside through the water are those of a log that the diagnosis was not given.

    Their errors are that of the current, a quarter of its parts at most, and of the log.
    """
    (course,) = diagnosis.velocities
    for place in (0, 1):
        told = np.interp(kept.time, course.time, course.velocity.through_water[:, place])
        off = told - kept.value[:, place]
        assert np.sqrt(np.mean(off**2)) < 0.25 * np.hypot(*CURRENT) + kept.noise[place]


@pytest.mark.parametrize("topics", [BOTTOM_TRACK, BOTH_LOGS], ids=["bottom track beside poses", "both logs, no poses"])
def test_the_current_is_named(swim_with_logs: Any, topics: tuple[str, ...]) -> None:
    """By a log with bottom track and how the vehicle moves by its commands, or by the difference of two logs."""
    diagnosis = diagnose(carried(swim_with_logs, (41,), CURRENT, topics), lambda words, share: None)
    assert_the_current(diagnosis)
    (recording,) = carried(swim_with_logs, (41,), CURRENT, BOTH_LOGS).recordings
    assert_as_the_log_that_was_kept_back(diagnosis, recording.robots[0].streams["velocity"])


def test_the_current_differs_from_when_the_water_was_still(swim_with_logs: Any) -> None:
    """Compared with recordings in water at rest, by both logs."""
    good = carried(swim_with_logs, (42, 43), STILL, BOTH_LOGS)
    assert_the_current(diagnose_against(carried(swim_with_logs, (41,), CURRENT, BOTH_LOGS), good, lambda *_: None))
