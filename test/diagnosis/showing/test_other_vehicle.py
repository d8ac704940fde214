"""Numbers of several kinds that differ by a factor at once are told as those of another vehicle; one kind never is."""

from __future__ import annotations

from typing import Any

import pytest

from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, Recalibrated
from cocorosim_ros.diagnosis.fitting.base_model import RECALIBRATED
from cocorosim_ros.diagnosis.showing.other_vehicle import _KINDS, as_another_vehicle


def moved(parameter: str, factor: float, width: float = 0.1, robot: str = "boat") -> Recalibrated:
    """A number that was 4 and is so many times that now, known to a share of it."""
    value = 4.0 * factor
    return Recalibrated(parameter, 4.0, Estimate(value, value * (1.0 - width), value * (1.0 + width), "1"), (robot,))


def thruster(name: str, gain: float) -> FoundEffect:
    """A single thruster that differs."""
    numbers = {name: Estimate(gain, 0.95 * gain, 1.05 * gain, "1")}
    return FoundEffect(f"thruster_gain:{name}", "", "", ("boat",), "confirmed", numbers, 50.0)


ONE_VEHICLE: dict[str, Any] = {
    "nothing": ([], []),
    "a weak battery": ([moved("thrust_gain", 0.4)], []),
    "a hull overgrown": ([moved("drag", 2.5), moved("yaw_drag", 3.0)], []),
    "a hull and propellers somewhat overgrown": ([moved("drag", 1.4), moved("thrust_gain", 0.8)], []),
    "both thrusters weak": ([], [thruster("left", 0.3), thruster("right", 0.5)]),
    "sizes that are badly known": ([moved("drag", 2.5, 0.5), moved("inertia", 2.5, 0.5)], []),
    "two robots": ([moved("drag", 2.5), moved("inertia", 2.5, robot="other")], []),
}
ANOTHER: dict[str, Any] = {
    "twice the mass": ([moved("thrust_gain", 0.5), moved("drag", 0.5)], [], "thrust gain 0.5, drag 0.5"),
    "a longer hull": ([moved("inertia", 3.0), moved("yaw_drag", 4.0)], [], "inertia 3, yaw drag 4"),
    "other propellers too": ([moved("drag", 1.9)], [thruster("left", 2.0)], "drag 1.9, thrust of left 2"),
}


@pytest.mark.parametrize("case", ONE_VEHICLE, ids=str)
def test_what_happens_to_one_vehicle(case: str) -> None:
    """It is a fault or a use of it, however large."""
    assert as_another_vehicle(*ONE_VEHICLE[case]) == ()


@pytest.mark.parametrize("case", ANOTHER, ids=str)
def test_another_vehicle(case: str) -> None:
    """One sentence with the factors, against all that differs in this robot."""
    numbers, effects, told = ANOTHER[case]
    (found,) = as_another_vehicle(numbers, effects)
    assert f"(times what they were: {told})" in found.sentence
    assert (found.robots, found.effect) == (("boat",), None)
    assert all(found.concerns(each) for each in effects)


def test_every_number_of_a_platform_is_of_a_kind() -> None:
    """Names are those under which differences are told."""
    assert {name for name, _ in RECALIBRATED.values()} == set(_KINDS)
