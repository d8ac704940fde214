"""Waves that move a robot: named with their numbers, and not where the water only swings."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.scenario.parts.platform import load_platform

TRAIN = {"speed": 0.004, "period": 8.0, "direction": 2.0, "phase": 0.5}


def swum(swim: Any, hidden: dict[str, dict[str, float]], seed: int) -> Evidence:
    """Evidence of a swim of three minutes with these effects, by a platform that lacks them."""
    plain = load_platform("lily")
    evidence: Evidence = swim(hiding(plain, hidden), 180.0, seed=seed, base=plain, disturbance=0.01)
    return evidence


def test_a_train_of_waves_is_named_with_its_numbers(swim: Any) -> None:
    """Its numbers lie within twice their intervals, which are narrow, and no other effect is named."""
    from cocorosim_ros.diagnosis.diagnose import diagnose

    diagnosis = diagnose(swum(swim, {"surface_waves": TRAIN}, 11), lambda words, share: None)
    (found,) = diagnosis.effects
    assert found.id == "surface_waves"
    for name, truth in TRAIN.items():
        estimate = found.parameters[name]
        assert abs(estimate.value - truth) <= estimate.high - estimate.low
        assert estimate.high - estimate.low < 0.5


def test_waves_over_a_floor_are_waves(swim: Any) -> None:
    """Which hardly go up and down: on deep water they would be a current that swings within seven seconds."""
    from cocorosim_ros.diagnosis.diagnose import diagnose

    train = {"speed": 0.008, "period": 6.9, "direction": 2.0, "phase": 0.5, "floor": 2.5}
    diagnosis = diagnose(swum(swim, {"surface_waves": train}, 11), lambda words, share: None)
    (found,) = diagnosis.effects
    assert found.id == "surface_waves"
    for name, truth in train.items():
        estimate = found.parameters[name]
        assert abs(estimate.value - truth) <= estimate.high - estimate.low
    assert found.parameters["floor"].high < 5.0


def test_a_swing_of_all_the_water_is_no_wave(swim: Any) -> None:
    """Of twelve seconds, as a wave may have: without its motion up and down it is a current that swings."""
    from cocorosim_ros.diagnosis.diagnose import diagnose

    tide = {"x": -0.004, "y": 0.007, "period": 12.0, "phase": 1.0}
    diagnosis = diagnose(swum(swim, {"tidal_current": tide}, 9), lambda words, share: None)
    assert [(effect.id, effect.ambiguous_with) for effect in diagnosis.effects] == [("tidal_current", ())]


@pytest.mark.parametrize("period", [3.0, 8.0])
def test_periods_are_peaks_of_the_residual(swim: Any, period: float) -> None:
    """The strongest of two is within a fiftieth, and there are no more; below a second none is looked for."""
    train = {"speed": 0.02, "period": period, "direction": math.pi / 3.0, "phase": 0.0}
    fit = base_fit(swum(swim, {"surface_waves": train}, 12))
    found = scene_of(fit.tracks, smoothed_tracks(fit)).periods["waves"]
    assert found[0] == pytest.approx(period, rel=0.02)
    assert len(found) <= 2
    assert min(found) > 1.0


def test_water_that_pushes_at_random_has_no_waves(swim: Any) -> None:
    """No peak of its spectrum stands out, so that nothing is looked for."""
    for seed in (13, 14, 15):
        fit = base_fit(swum(swim, {}, seed))
        assert scene_of(fit.tracks, smoothed_tracks(fit)).periods["waves"] == ()


def test_fast_swings_are_looked_for_as_a_force_and_not_as_a_current(swim: Any) -> None:
    """A force may swing within three seconds; water that does so is a wave."""
    train = {"speed": 0.06, "period": 3.0, "direction": math.pi / 3.0, "phase": 0.0}
    fit = base_fit(swum(swim, {"surface_waves": train}, 12))
    periods = scene_of(fit.tracks, smoothed_tracks(fit)).periods
    assert min(periods["world_y"]) == pytest.approx(3.0, rel=0.02)
    assert min(periods["current"]) >= 5.0
