"""A camera that alone shows where the vehicle is: its scale is told by how far the learned vehicle comes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose_against import diagnose_against
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.scenario.parts.platform import load_platform

SECONDS = 90.0
GOOD, BAD = (1, 2, 3), (11, 12)  # seeds of recordings


def seen(swim: Callable[..., Any], seeds: tuple[int, ...], scale: float = 1.0) -> Evidence:
    """Recordings of a Lily by poses alone, the lengths of which are wrong by a factor."""
    lily, found = load_platform("lily"), []
    for seed in seeds:
        (one,) = swim(lily, SECONDS, seed=seed).recordings
        (log,) = one.robots
        pose = log.streams["pose"]
        pose = replace(pose, value=pose.value * np.array([scale, scale, scale, 1.0]))
        found.append(replace(one, origin=f"recording {seed}", robots=(replace(log, streams={"pose": pose}),)))
    return Evidence(lily, tuple(found))


@pytest.mark.parametrize("scale", [0.88, 1.12])
def test_the_scale_of_the_only_camera_is_named(swim: Callable[..., Any], scale: float) -> None:
    """Twelve per cent, with the truth in its interval and no drag or thrust in its place."""
    found = diagnose_against(seen(swim, BAD, scale), seen(swim, GOOD), lambda words, share: None)
    assert [effect.id for effect in found.effects] == ["camera_scale"] and not found.recalibrated
    estimate = found.effects[0].parameters["scale"]
    assert estimate.holds(scale) and estimate.high - estimate.low < 0.1


def test_alike_recordings_differ_in_no_length(swim: Callable[..., Any]) -> None:
    """The same camera, in other recordings."""
    found = diagnose_against(seen(swim, BAD), seen(swim, GOOD), lambda words, share: None)
    assert (found.verdict, found.effects, found.recalibrated) == ("consistent", (), ())
