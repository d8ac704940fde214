"""A number that is another in each part of the recordings is told with by how much; one that is the same is not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.showing.unsteady_numbers import unsteady_numbers
from cocorosim_ros.scenario.parts.platform import Platform, load_platform


def weaker(share: float) -> Platform:
    """A Lily whose thrusters have so much of their thrust."""
    lily = load_platform("lily")
    return replace(
        lily,
        actuators=tuple(
            replace(each, maximum=share * each.maximum) if each.name in ("left", "right") else each
            for each in lily.actuators
        ),
    )


@pytest.mark.parametrize(("shares", "told"), [((1.0, 1.0), False), ((1.2, 0.6), True)])
def test_thrust_that_changes_is_told(swim: Callable[..., Any], shares: tuple[float, float], told: bool) -> None:
    """By hand: 1.2 and 0.6 of the thrust in halves of the recordings have a standard deviation of a third."""
    both = [swim(weaker(share), 100.0, seed=seed, base=load_platform("lily")) for seed, share in enumerate(shares, 1)]
    evidence = replace(
        both[0], recordings=tuple(replace(each.recordings[0], origin=str(k)) for k, each in enumerate(both))
    )
    sentences = unsteady_numbers(base_fit(evidence))
    assert bool(sentences) == told
    if told:
        (thrust,) = (each for each in sentences if each.startswith("Thrust gain of lily_01 differs by "))
        assert int(thrust.split()[6].removesuffix("%")) == pytest.approx(100.0 / 3.0, abs=12.0)
