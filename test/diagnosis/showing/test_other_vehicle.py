"""Numbers of several kinds that differ by a factor at once are told as those of another vehicle.

One kind never is, nor a load or growth.
"""

from __future__ import annotations

from typing import Any

import pytest

from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, Recalibrated
from cocorosim_ros.diagnosis.fitting.base_model import RECALIBRATED
from cocorosim_ros.diagnosis.showing.other_vehicle import (
    _KINDS,
    other_vehicle_sentence,
    other_vehicles,
    under_a_load,
)


def moved(parameter: str, factor: float, width: float = 0.1, robot: str = "boat") -> Recalibrated:
    """A number that was 4 and is so many times that now, known to a share of it."""
    value = 4.0 * factor
    return Recalibrated(parameter, 4.0, Estimate(value, value * (1.0 - width), value * (1.0 + width), "1"), (robot,))


def thruster(name: str, gain: float) -> FoundEffect:
    """A single thruster that differs."""
    numbers = {name: Estimate(gain, 0.95 * gain, 1.05 * gain, "1")}
    return FoundEffect(f"thruster_gain:{name}", "", "", ("boat",), "confirmed", numbers, 50.0)


def fouled_ahead(factor: float) -> FoundEffect:
    """A hull with more drag ahead alone."""
    numbers = {"surge_drag": Estimate(factor, 0.95 * factor, 1.05 * factor, "1")}
    return FoundEffect("surge_drag", "", "", ("boat",), "confirmed", numbers, 50.0)


ONE_VEHICLE: dict[str, Any] = {
    "nothing": ([], []),
    "a weak battery": ([moved("thrust_gain", 0.4)], []),
    "a hull overgrown": ([moved("drag", 2.5), moved("yaw_drag", 3.0)], []),
    "a hull and propellers somewhat overgrown": ([moved("drag", 1.4), moved("thrust_gain", 0.8)], []),
    "a hull and propellers overgrown": ([moved("drag", 1.9), moved("yaw_drag", 1.6), moved("thrust_gain", 0.6)], []),
    "a hull overgrown ahead and a propeller": ([], [fouled_ahead(1.8), thruster("left", 0.6)]),
    "both thrusters weak": ([], [thruster("left", 0.3), thruster("right", 0.5)]),
    "a lost thruster": ([], [thruster("left", 0.0)]),
    "sizes that are badly known": ([moved("drag", 2.5, 0.5), moved("inertia", 2.5, 0.5)], []),
    "two robots": ([moved("drag", 2.5), moved("inertia", 2.5, robot="other")], []),
    "less than speaks for another vehicle": ([moved("thrust_gain", 1.3, 0.01), moved("inertia", 1.3, 0.01)], []),
}
FORM = FoundEffect("hull_lift", "lift of the hull", "", ("boat",), "confirmed", {}, 157.0)
ONE_VEHICLE |= {
    "more drag, and what looks like lift": ([moved("drag", 2.5)], [FORM]),
    "a weak battery, and what looks like lift": ([moved("thrust_gain", 0.4)], [FORM]),
    "lift alone": ([], [FORM]),
}
LOADED: dict[str, Any] = {
    "a load amidships": [moved("thrust_gain", 0.6), moved("drag", 0.62), moved("yaw_drag", 0.58)],
    "a load at the ends": [moved("thrust_gain", 0.55), moved("drag", 0.55), moved("inertia", 0.6)],
}
ANOTHER: dict[str, Any] = {
    "three times the mass": ([moved("thrust_gain", 0.33), moved("drag", 0.33)], [], "thrust gain 0.33, drag 0.33"),
    "a longer hull": ([moved("inertia", 3.0), moved("yaw_drag", 4.0)], [], "inertia 3, yaw drag 4"),
    "other propellers too": ([moved("drag", 1.9)], [thruster("left", 2.0)], "drag 1.9, thrust of left 2"),
    "more drag by far, and less thrust": ([moved("drag", 3.0), moved("thrust_gain", 0.6)], [], "drag 3, thrust gain"),
    "heavier with other inertia": ([moved("drag", 0.5), moved("inertia", 2.5)], [], "drag 0.5, inertia 2.5"),
    "a slender hull": ([moved("thrust_gain", 1.5), moved("inertia", 1.5)], [], "thrust gain 1.5, inertia 1.5"),
    "a tanker for another": ([moved("drag", 0.29, 0.27)], [FORM], "drag 0.29), and so does the form of its hull (lift"),
    "no thrust on one side": ([moved("drag", 0.5)], [thruster("left", 0.0)], "drag 0.5, thrust of left 0"),
}


@pytest.mark.parametrize("case", ONE_VEHICLE, ids=str)
def test_what_happens_to_one_vehicle(case: str) -> None:
    """It is a fault or a use of it, however large."""
    assert other_vehicles(*ONE_VEHICLE[case]) == under_a_load(*ONE_VEHICLE[case]) == ()


@pytest.mark.parametrize("case", LOADED, ids=str)
def test_a_load_is_told_as_one(case: str) -> None:
    """All forces are smaller alike, since they are known relative to mass: a warning, and names stay suspected."""
    assert other_vehicles(LOADED[case], []) == ()
    (found,) = under_a_load(LOADED[case], [])
    assert "as under a load" in found.sentence and (found.robots, found.effect) == (("boat",), None)


@pytest.mark.parametrize("case", ANOTHER, ids=str)
def test_another_vehicle(case: str) -> None:
    """One sentence with the factors, about this robot; it is no load."""
    numbers, effects, told = ANOTHER[case]
    (found,) = other_vehicles(numbers, effects)
    assert found.robot == "boat"
    assert f"(times what they were: {told}" in other_vehicle_sentence(found)
    assert under_a_load(numbers, effects) == ()


def test_every_number_of_a_platform_is_of_a_kind() -> None:
    """Names are those under which differences are told."""
    assert {name for name, _ in RECALIBRATED.values()} == set(_KINDS)
