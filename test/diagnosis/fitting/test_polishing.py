"""Exact slopes lead to the summit where slopes with held gains end on a flank."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.fit import evaluated
from cocorosim_ros.diagnosis.fitting.polishing import _curvature, _slope, polished
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.scenario.parts.platform import load_platform


@pytest.fixture(scope="module")
def first(swim: Any) -> Any:
    """A minute of a Lily with half as much drag again as its file says."""
    lily = load_platform("lily")
    return first_fit(swim(replace(lily, drag=1.5 * lily.drag), 60.0, seed=61, base=lily))


def test_the_slope_is_that_of_the_objective(first: Any) -> None:
    """Beside central differences of whole evaluations, of every number, within a hundredth of its width."""
    slope = _slope(first, _curvature(first))
    count = len(first.unknowns)
    for index in range(len(slope)):
        step = np.zeros(len(slope))
        step[index] = 1e-4
        ends = [
            evaluated(replace(first, q=first.q + sign * step[:count], q_noise=first.q_noise + sign * step[count:]))
            for sign in (1.0, -1.0)
        ]
        central = (ends[0].objective - ends[1].objective) / 2e-4
        assert slope[index] == pytest.approx(central, rel=0.05, abs=1.0)


def test_it_climbs_back_to_the_summit(first: Any) -> None:
    """From a flank, numbers a tenth and noise a third off, to the summit of the climb, which is right for such a model.

    Held gains are no help: the slope is the objective's own.
    """
    summit = settled(first, 10)
    signs = np.where(np.arange(len(summit.q_noise)) % 2, 1.0, -1.0)
    flank = evaluated(replace(summit, q=summit.q + 0.1, q_noise=summit.q_noise + 0.3 * signs))
    found = polished(flank)
    assert flank.objective < summit.objective - 20.0
    assert found.objective == pytest.approx(summit.objective, abs=2.0)


def test_a_summit_is_left_as_it_is(first: Any) -> None:
    """Bit by bit: once polished, no step promises anything."""
    summit = polished(settled(first, 10))
    assert polished(summit) is summit
