"""The learned vehicle has a curve for each thruster: what differs is told beside curves that the platform lacks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.diagnose_against import diagnose_against
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.parts.thrust_curve import ThrustCurve

SECONDS = 60.0
GOOD, BAD = (1, 2, 3, 4), (11, 12, 13)  # seeds of recordings


def vehicle(left: float = 1.0) -> Platform:
    """A Lily whose left thruster follows a square law and has so much of its thrust; the file has straight lines."""
    lily = load_platform("lily")
    square = ThrustCurve("square")
    actuators = (
        replace(each, curve=square, maximum=left * each.maximum) if each.name == "left" else each
        for each in lily.actuators
    )
    return replace(lily, actuators=tuple(actuators))


def recordings(swim: Callable[..., Any], platform: Platform, seeds: tuple[int, ...]) -> Evidence:
    """Recordings of a vehicle, one for each seed, beside the platform's file."""
    found = []
    for seed in seeds:
        (one,) = swim(platform, SECONDS, seed=seed).recordings
        found.append(replace(one, origin=f"recording {seed}"))
    return Evidence(load_platform("lily"), tuple(found))


@pytest.fixture(scope="module")
def good(swim: Callable[..., Any]) -> Evidence:
    """Recordings of the well vehicle."""
    return recordings(swim, vehicle(), GOOD)


def test_a_curve_that_the_file_lacks_is_learned_and_no_difference(swim: Callable[..., Any], good: Evidence) -> None:
    """Its name is among what was learned, and other recordings of the vehicle differ in nothing."""
    found = diagnose_against(recordings(swim, vehicle(), BAD), good, lambda words, share: None)
    assert found.against is not None and "thruster_curve:left" in found.against.learned
    assert (found.verdict, found.effects, found.recalibrated) == ("consistent", (), ())


def test_a_weaker_thruster_is_told_beside_its_curve(swim: Callable[..., Any], good: Evidence) -> None:
    """A quarter of its thrust is gone; the number is that, although the file's line is not its curve."""
    found = diagnose_against(recordings(swim, vehicle(0.75), BAD), good, lambda words, share: None)
    assert [effect.id for effect in found.effects] == ["thruster_asymmetry"]
    told = found.effects[0].parameters["left"]
    assert told.holds(0.75) and told.high - told.low < 0.04  # four spreads of 1 %: thrusters are not quite alike
    assert not found.recalibrated
