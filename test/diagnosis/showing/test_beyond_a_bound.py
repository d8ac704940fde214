"""Evidence beyond a bound is what a fit gains whose number is let through it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.fitting.climbing import improved
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.showing.beyond_a_bound import beyond_a_bound
from cocorosim_ros.scenario.parts.platform import load_platform


@pytest.fixture(scope="module")
def free(swim: Callable[..., Any]) -> Fit:
    """A base fit whose numbers are all within their bounds."""
    return base_fit(swim(load_platform("lily"), 60.0, seed=31))


def bounded(free: Fit, parameter: str, off: float) -> tuple[Fit, int]:
    """The fit with a number that may not come nearer to its best value than `off` in q, the others fitted anew."""
    place = next(index for index, each in enumerate(free.unknowns) if each.owner.parameter == parameter)
    ends = (-1e9, free.q[place] - off) if off > 0.0 else (free.q[place] - off, 1e9)
    unknowns, q = list(free.unknowns), free.q.copy()
    unknowns[place], q[place] = replace(unknowns[place], bounds=ends), free.q[place] - off
    return improved(evaluated(replace(free, unknowns=tuple(unknowns), q=q)), 10), place


@pytest.mark.parametrize(("parameter", "off"), [("drag", 0.05), ("drag", -0.05), ("thrust_gain", 0.05)])
def test_it_is_the_gain_of_the_fit_without_the_bound(free: Fit, parameter: str, off: float) -> None:
    """To a tenth, on either side."""
    fit, place = bounded(free, parameter, off)
    beyond = beyond_a_bound(fit, place)
    assert beyond.nats == pytest.approx(free.objective - fit.objective, rel=0.1)
    assert beyond.value == pytest.approx(free.unknowns[place].value(float(free.q[place])), rel=0.01)


def test_a_number_that_is_not_pressed_has_none(free: Fit) -> None:
    """Within its bounds, and at a bound from which the readings ask it away."""
    assert all(beyond_a_bound(free, place).nats == 0.0 for place in range(len(free.unknowns)))
    place = next(index for index, each in enumerate(free.unknowns) if each.owner.parameter == "drag")
    unknowns, q = list(free.unknowns), free.q.copy()
    q[place] += 0.05
    unknowns[place] = replace(unknowns[place], bounds=(-1e9, q[place]))
    assert beyond_a_bound(evaluated(replace(free, unknowns=tuple(unknowns), q=q)), place).nats == 0.0
