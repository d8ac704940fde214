"""Thrust lost against the motion and in the jet of another thruster: named with its number, and only where it is.

The swims are the simulator's; what an effect does is compared with closed forms in test/world/motion.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.fitting.vehicle_needs import HAS
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.parts.steering import Azimuth
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster

SECONDS = 150.0


def lily() -> Any:
    """A Lily as she is."""
    return load_platform("lily")


def tandem() -> Any:
    """A Lily with two thrusters in line instead, 0.1 m apart, and one to the side in place of the pump."""
    plain = load_platform("lily")
    fore = Thruster("fore", (0.05, 0.0, 0.0), (1.0, 0.0, 0.0), 0.005, diameter=0.03)
    aft = Thruster("aft", (-0.05, 0.0, 0.0), (1.0, 0.0, 0.0), 0.005, diameter=0.03)
    bow = Thruster("bow", (0.03, 0.0, 0.03), (0.0, 1.0, 0.0), 0.05)
    return replace(plain, actuators=(aft, fore, bow))


CASES = [
    pytest.param(lily, "crashback_loss", {"slope": 6.0}, 31, id="crashback_loss"),
    pytest.param(tandem, "wash_loss", {"loss": 0.8}, 31, id="wash_loss"),
]


@pytest.mark.parametrize(("make", "effect", "numbers", "seed"), CASES)
def test_it_is_named_with_its_number(swim: Any, make: Any, effect: str, numbers: dict[str, float], seed: int) -> None:
    """It alone; the truth lies in the 95 % interval, which is narrower than the number itself."""
    platform = make()
    found = diagnose(
        swim(hiding(platform, {effect: numbers}), SECONDS, seed=seed, base=platform), lambda words, share: None
    )
    assert [each.id for each in found.effects] == [effect]
    for name, true in numbers.items():
        estimate = found.effects[0].parameters[name]
        assert estimate.holds(true) and estimate.high - estimate.low < true, estimate


@pytest.mark.parametrize(
    ("effect", "numbers"),
    [("advance_loss", {"slope": 2.0}), ("reverse_loss", {"loss": 0.15})],
    ids=("advance", "reverse"),
)
def test_other_losses_keep_their_names(swim: Any, effect: str, numbers: dict[str, float]) -> None:
    """Thrust that falls with speed on both sides of rest, or backwards at every speed, is not lost in crashback."""
    found = diagnose(swim(hiding(lily(), {effect: numbers}), SECONDS, seed=31, base=lily()), lambda words, share: None)
    assert [each.id for each in found.effects] == [effect]


@pytest.mark.parametrize(("make", "seed"), [(lily, 31), (tandem, 31)])
def test_nothing_is_named_where_nothing_is_wrong(swim: Any, make: Any, seed: int) -> None:
    """The same swims without the effects."""
    found = diagnose(swim(make(), SECONDS, seed=seed), lambda words, share: None)
    assert [each.id for each in found.effects] == []


def test_wash_is_looked_for_where_a_jet_meets_a_thruster() -> None:
    """In line within some diameters; not side by side, far behind, across, out of an azimuth's reach, or undeclared."""
    fore = Thruster("a", (0.05, 0.0, 0.0), (1.0, 0.0, 0.0), 4.0, diameter=0.03)
    aft = replace(fore, name="b", position=(-0.05, 0.0, 0.0))
    left = replace(aft, position=(0.05, 0.1, 0.0))
    quarter, little = Azimuth("turn", "a", 1.6), Azimuth("turn", "a", 0.3)
    for actuators, met in (
        ((fore, aft), True),
        ((replace(fore, diameter=None), aft), True),  # backwards, the rear one blows forwards
        ((replace(fore, diameter=None), replace(aft, maximum_reverse=0.0)), False),
        ((replace(fore, diameter=None), replace(aft, diameter=None)), False),
        ((fore, left), False),
        ((fore, replace(aft, position=(-2.0, 0.0, 0.0))), False),
        ((fore, replace(aft, direction=(0.0, 1.0, 0.0))), False),
        ((fore, quarter, replace(left, direction=(0.0, 1.0, 0.0))), True),
        ((fore, little, replace(left, direction=(0.0, 1.0, 0.0), diameter=None)), False),
    ):
        assert HAS["thruster_in_a_jet"](vehicle_model(replace(lily(), actuators=actuators))) is met, actuators
