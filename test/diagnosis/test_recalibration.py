"""The honest base: where the first guess of the noise is far off, another way leads to a better fit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis import recalibration
from cocorosim_ros.scenario.platform import load_platform

Swim = Callable[..., Any]


def doubted(evidence: Any, share: float) -> Any:
    """The evidence with noise that is told as a share of what it is."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    streams = {name: replace(stream, noise=share * stream.noise) for name, stream in log.streams.items()}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


@pytest.fixture(scope="module")
def rough(swim: Swim) -> Any:
    """A minute in rough water with readings ten times worse than told."""
    return doubted(swim(load_platform("lily"), 60.0, disturbance=0.3), 0.1)


def test_the_better_of_two_ways_is_taken(rough: Any) -> None:
    """Readings that the first guess shuts out are heeded at the second start, and the base is no worse than by it."""
    first = recalibration.first_fit(rough)
    second = recalibration._at_random(first)
    shut = [[recalibration._is_shut(fit, unknown) for unknown in fit.noise] for fit in (first, second)]
    assert any(shut[0]) and sum(shut[1]) < sum(shut[0])
    ways = [recalibration._settled(recalibration._opened(start)).objective for start in (first, second)]
    assert recalibration.base_fit(rough).objective == pytest.approx(max(ways))


def test_a_tracker_that_was_at_a_loss_once_is_good_elsewhere(swim: Swim) -> None:
    """Two recordings of one robot, one with poses at random: the other's stay as good; its own compass is one."""
    good = swim(load_platform("lily"), 60.0, seed=1)
    (recording,) = swim(load_platform("lily"), 60.0, seed=2).recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    lost = pose.value + [0.1, 0.1, 0.1, 0.0] * np.random.default_rng(3).standard_normal(pose.value.shape)
    worse = replace(log, streams={**log.streams, "pose": replace(pose, value=lost)})
    both = replace(good, recordings=(*good.recordings, replace(recording, robots=(worse,))))
    fit = recalibration.base_fit(both)
    found: dict[str, list[float]] = {}
    for unknown, q in zip(fit.noise, fit.q_noise, strict=True):
        found.setdefault(unknown.column, []).append(float(np.exp(unknown.value(float(q)))))
    assert found["reading.pose_xy"][0] == pytest.approx(0.002, rel=0.1) and found["reading.pose_xy"][1] > 0.03
    assert found["reading.compass"] == [pytest.approx(0.02, rel=0.1)]
