"""A log over ground in a current: what is carried along is told as the current, on whichever side it comes from.

The swims are the simulator's, in water that moves as a platform's `steady_current` says; the platform of the diagnosis
knows nothing of it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

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


@pytest.mark.parametrize("topics", [BOTTOM_TRACK, BOTH_LOGS], ids=["bottom track beside poses", "both logs, no poses"])
def test_the_current_is_named(swim_with_logs: Any, topics: tuple[str, ...]) -> None:
    """By a log with bottom track and how the vehicle moves by its commands, or by the difference of two logs."""
    assert_the_current(diagnose(carried(swim_with_logs, (41,), CURRENT, topics), lambda words, share: None))


def test_the_current_differs_from_when_the_water_was_still(swim_with_logs: Any) -> None:
    """Compared with recordings in water at rest, by both logs."""
    good = carried(swim_with_logs, (42, 43), STILL, BOTH_LOGS)
    assert_the_current(diagnose_against(carried(swim_with_logs, (41,), CURRENT, BOTH_LOGS), good, lambda *_: None))
