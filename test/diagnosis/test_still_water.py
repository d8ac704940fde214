"""Water that does not push: the fit finds that out, however far it begins."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

# Rough sea of short memory, from which a plain scoring step goes astray.
ASTRAY = {"force": 2e-4, "heave_force": 1.5e-4, "moment": 1.7e-6, "correlation": 0.5, "smoothness": 1.0}


def test_exact_readings_of_the_very_model_accuse_nobody(swim: Any) -> None:
    """As of a simulation with perfect sensors: what the filter's steps are off by is no physics."""
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform

    found = diagnose(swim(load_platform("lily"), 200.0, seed=5, disturbance=0.0, blur=1e-6), lambda words, share: None)
    assert found.verdict in ("consistent", "insufficient")
    assert found.effects == () and found.recalibrated == ()


def test_a_number_that_holds_the_nominal_has_not_moved() -> None:
    """Where only all numbers together are clear, the one that is named is off by its own interval."""
    from cocorosim_ros.diagnosis.diagnose import _strongest
    from cocorosim_ros.diagnosis.findings import Estimate, Recalibrated

    holds = Recalibrated("drag", 1.7778, Estimate(1.8, 1.77, 1.83, "kg/m"), ("lily_01",))
    leaves = Recalibrated("thrust_gain", 1.0, Estimate(1.02, 1.001, 1.039, "1"), ("lily_01",))
    assert _strongest([holds]) == ()
    assert _strongest([holds, leaves]) == (leaves,)


def test_random_forces_that_are_not_there_are_fitted_away(swim: Any) -> None:
    """The most likely noise is found again from a state in which each plain step makes it worse."""
    from cocorosim_ros.diagnosis.fitting.climbing import with_noise
    from cocorosim_ros.diagnosis.fitting.fit import evaluated
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.scenario.parts.platform import load_platform

    best = base_fit(swim(load_platform("lily"), 200.0, seed=4, disturbance=0.0))
    q = best.q_noise.copy()
    for place, unknown in enumerate(best.noise):
        name = unknown.column.removeprefix("random.")
        q[place] = math.log(ASTRAY[name]) - unknown.base if name in ASTRAY else q[place]
    astray = evaluated(replace(best, q_noise=q))
    assert astray.objective < best.objective - 100.0
    assert with_noise(astray, 20).objective == pytest.approx(best.objective, abs=3.0)
