"""A log over ground in a current: what is carried along is told as the current, on whichever side it comes from.

The swims are the simulator's, in water that moves as a platform's `steady_current` says; the platform of the diagnosis
knows nothing of it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of

SECONDS = 60.0
CURRENT = (0.012, -0.02)  # m/s; a Lily makes 0.075 m/s at most


def carried(swim_with_logs: Any, seed: int, *topics: str) -> Any:
    """Evidence of a swim in CURRENT, with these streams alone."""
    plain = load_platform("lily")
    current = {name: Quantity(value, "m/s", dimension_of("m/s")) for name, value in zip("xy", CURRENT, strict=True)}
    platform = replace(plain, effect_quantities={"steady_current": current})
    evidence = swim_with_logs(platform, SECONDS, seed, plain, CURRENT)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    robots = (replace(log, streams={topic: log.streams[topic] for topic in topics}),)
    return replace(evidence, recordings=(replace(recording, robots=robots),))


@pytest.mark.parametrize(
    "topics",
    [
        ("pose", "compass", "imu", "ground_velocity"),  # a Doppler log with bottom track
        ("compass", "imu", "velocity", "ground_velocity"),  # both logs, no place: their difference is the current
    ],
    ids=["bottom track beside poses", "both logs without poses"],
)
def test_the_current_is_named(swim_with_logs: Any, topics: tuple[str, ...]) -> None:
    """It alone, each part with its sign and inside its interval, which is narrower than half of the part."""
    found = diagnose(carried(swim_with_logs, 41, *topics), lambda words, share: None)
    assert [effect.id for effect in found.effects] == ["steady_current"]
    for name, true in zip("xy", CURRENT, strict=True):
        estimate = found.effects[0].parameters[name]
        assert estimate.holds(true), (name, estimate)
        assert estimate.high - estimate.low < 0.5 * abs(true)
