"""A range in a platform's file is a limit: no fitted number leaves it."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.fitting.base_model import base_unknowns
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.ranges import Range


def bounds(swim: Any, ranges: dict[str, Range]) -> dict[str, tuple[float, float]]:
    """Bounds of the fitted numbers over the platform's, by name, for a Lily with these ranges."""
    lily = replace(load_platform("lily"), ranges=ranges)
    unknowns = base_unknowns(make_tracks(swim(load_platform("lily"), 20.0, base=lily)))
    return {each.owner.parameter: (math.exp(each.bounds[0]), math.exp(each.bounds[1])) for each in unknowns}


def test_bounds_are_the_range(swim: Any) -> None:
    """By hand: 1.7778 kg/m between 1.5 and 2; thrusters of 5 mN, of which one may have 4 to 20 mN, one 1 to 6 mN."""
    found = bounds(
        swim,
        {
            "drag": Range(1.5, 2.0, "kg/m"),
            "actuators.left.maximum": Range(0.004, 0.02, "N"),
            "actuators.right.maximum": Range(0.001, 0.006, "N"),
        },
    )
    assert found["drag"] == pytest.approx((1.5 / 1.7778, 2.0 / 1.7778), rel=1e-4)
    assert found["thrust_gain"] == pytest.approx((0.8, 1.2))
    assert found["yaw_torque_gain"] == pytest.approx((0.8, 1.2))
    assert found["yaw_drag"] == pytest.approx((math.exp(-4.0), math.exp(4.0)))


def test_a_number_beyond_its_range_stays_at_the_end_and_is_said(swim: Any) -> None:
    """A Lily with half as much drag again as the file allows: the fit ends at 1.9 kg/m, with a warning."""
    from cocorosim_ros.diagnosis.diagnose import diagnose

    lily = load_platform("lily")
    base = replace(lily, ranges={"drag": Range(1.6, 1.9, "kg/m")})
    diagnosis = diagnose(swim(replace(lily, drag=2.7), 100.0, seed=41, base=base), lambda words, share: None)
    (drag,) = [each for each in diagnosis.all_recalibrated if each.parameter == "drag"]
    assert drag.estimate.value == pytest.approx(1.9)
    assert any("drag of lily_01 stands at the end of its range" in said for said in diagnosis.warnings)
    assert all(each.tier == "suspected" and each.because for each in diagnosis.effects)
