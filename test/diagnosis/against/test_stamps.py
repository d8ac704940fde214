"""Streams on another clock than before are told by the log times, though their stamps were put right."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.against.stamps import other_clocks


def dive(swim: Any, shifted: float) -> Any:
    """A dive of Lily whose compass had to be shifted by so much [s]."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    evidence = swim(load_platform("lily"), 20.0, seed=1)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    streams = {**log.streams, "compass": replace(log.streams["compass"], shifted=shifted)}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


@pytest.mark.parametrize(("bad", "good"), [(-13.0, 0.0), (0.0, 13.0), (-3.0, 10.0)])
def test_a_stream_on_another_clock_is_late(swim: Any, bad: float, good: float) -> None:
    """Stamps that were set 13 s earlier had been 13 s late."""
    (found,) = other_clocks(dive(swim, bad), dive(swim, good))
    assert (found.id, found.topic, found.robots, found.tier) == ("sensor_latency", "compass", ("lily_01",), "confirmed")
    latency = found.parameters["latency"]
    assert (latency.value, latency.unit) == (pytest.approx(13.0), "s") and latency.low < 13.0 < latency.high
    assert found.correction is not None and "13 s later" in found.correction


@pytest.mark.parametrize(("bad", "good"), [(0.0, 0.0), (-13.0, -13.0), (-0.9, 0.0)])
def test_the_same_clock_is_no_difference(swim: Any, bad: float, good: float) -> None:
    """Nor is what a transport may take."""
    assert list(other_clocks(dive(swim, bad), dive(swim, good))) == []


@pytest.mark.parametrize(("bad", "good"), [(1.8, 0.0), (0.0, -1.8), (3.0, 1.2)])
def test_commands_on_another_clock_act_late(swim: Any, bad: float, good: float) -> None:
    """Stamps that were set 1.8 s later had been 1.8 s before the moment at which the commands act."""

    def commanded(shifted: float) -> Any:
        evidence = dive(swim, 0.0)
        (recording,) = evidence.recordings
        (log,) = recording.robots
        return replace(evidence, recordings=(replace(recording, robots=(replace(log, command_shifted=shifted),)),))

    (found,) = other_clocks(commanded(bad), commanded(good))
    assert (found.id, found.topic, found.tier) == ("command_delay", None, "confirmed")
    delay = found.parameters["delay"]
    assert (delay.value, delay.unit) == (pytest.approx(1.8), "s") and delay.low < 1.8 < delay.high
    assert found.correction is not None and "1.8 s earlier" in found.correction
