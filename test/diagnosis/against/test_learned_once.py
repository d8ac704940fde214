"""A vehicle is learned once for all recordings that are compared with the same ones."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest


@pytest.fixture
def learning(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """List of the evidence that vehicles were learned from, by a learning that returns just that."""
    from cocorosim_ros.diagnosis.against import learned_once

    learned: list[Any] = []

    def learn(base: Any, progress: Any) -> Any:
        learned.append(base)
        return base

    monkeypatch.setattr(learned_once, "base_fit", lambda evidence: evidence)
    monkeypatch.setattr(learned_once, "learned_vehicle", learn)
    monkeypatch.setattr(learned_once, "_KEPT", learned_once._Kept())
    return learned


def asked(good: Any) -> Any:
    """Vehicle of recordings."""
    from cocorosim_ros.diagnosis.against.learned_once import learned_once

    return learned_once(good, lambda words, share: None)


def dive(swim: Any, seed: int) -> Any:
    """A dive of Lily."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    return swim(load_platform("lily"), 20.0, seed=seed)


def test_the_same_recordings_are_learned_from_once(swim: Any, learning: list[Any]) -> None:
    """Though they were read anew."""
    assert asked(dive(swim, 1)) is asked(dive(swim, 1))
    assert len(learning) == 1


def test_a_single_other_reading_makes_other_recordings(swim: Any, learning: list[Any]) -> None:
    """By the least of changes."""
    good = dive(swim, 1)
    (recording,) = good.recordings
    (log,) = recording.robots
    stream = log.streams["compass"]
    value = stream.value.copy()
    value[len(value) // 2] += 1e-9
    streams = {**log.streams, "compass": replace(stream, value=value)}
    other = replace(good, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))
    asked(good)
    asked(other)
    assert len(learning) == 2


def test_the_platform_counts_too(swim: Any, learning: list[Any]) -> None:
    """The same readings of a heavier vehicle tell other things."""
    good = dive(swim, 1)
    asked(good)
    asked(replace(good, platform=replace(good.platform, mass=2.0 * good.platform.mass)))
    assert len(learning) == 2
