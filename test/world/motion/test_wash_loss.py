"""Thrust that is lost in the jet of another thruster, by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hidden_effects import hiding

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.parts.steering import Azimuth
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.world.effects.wash_loss import wash_loss
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.vehicle_model.jets import build_jets
from cocorosim_ros.world.vehicle_model.platform_effects import not_simulated
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles

DIAMETER = 0.05
FORE = Thruster("fore", (0.1, 0.0, 0.0), (1.0, 0.0, 0.0), 4.0, diameter=DIAMETER)
AFT = Thruster("aft", (-0.1, 0.0, 0.0), (1.0, 0.0, 0.0), 4.0)
IN_LINE = 0.75 ** (4.0 ** (2.0 / 3.0))  # left of a jet at four diameters


def vehicle(*actuators: Any) -> Any:
    """A Lily with these actuators."""
    return replace(load_platform("lily"), actuators=actuators)


def lost(platform: Any, forces: Any, loss: float = 1.0) -> Any:
    """What the effect takes away at the forces of the actuators: X, Y, Z, N [N, N, N, N m]."""
    vehicles, total = build_vehicles([platform]), np.zeros(4)
    count = len(platform.actuators)
    moment = Moment(
        0.0, np.zeros(4), np.array(forces, dtype=float), vehicles.actuator_wrench[0, 0], np.zeros(count, dtype=bool),
        0.0, 0.0, 1.0, 1.0, 0.5, np.zeros((0, 5)), -1, 0.0, vehicles.jets[0, 0],
    )  # fmt: skip
    wash_loss(np.zeros(26), np.zeros(4), moment, np.array([loss]), total)
    return -total


def test_of_two_equal_thrusts_in_line_the_second_loses_what_abs_says() -> None:
    """Four diameters behind, exp(-0.2877 * 2.520) = 0.4844 of it."""
    assert pytest.approx(0.4844, abs=1e-4) == IN_LINE
    np.testing.assert_allclose(lost(vehicle(FORE, AFT), (2.0, 2.0)), [2.0 * IN_LINE, 0.0, 0.0, 0.0], atol=1e-15)
    np.testing.assert_allclose(lost(vehicle(FORE, AFT), (2.0, 2.0), 0.3), [0.6 * IN_LINE, 0.0, 0.0, 0.0], atol=1e-15)


@pytest.mark.parametrize(
    ("forces", "taken"),
    [
        ((0.5, 2.0), math.sqrt(0.5 * 2.0)),  # half of the jet's speed
        ((0.0, 2.0), 0.0),
        ((2.0, 0.0), 0.0),
        ((-2.0, 2.0), 0.0),  # blows away from it
        ((-2.0, -2.0), 0.0),  # the aft one has no diameter
        ((2.0, -2.0), 0.0),  # jets that meet
    ],
)
def test_it_is_lost_where_the_fore_thruster_blows_into_the_aft_one(forces: Any, taken: float) -> None:
    """The force taken is c sqrt(T_j T), and nothing if either stands still or both push against each other."""
    np.testing.assert_allclose(lost(vehicle(FORE, AFT), forces)[0], taken * IN_LINE, atol=1e-15)


def test_jets_of_reverse_thrust_blow_forwards() -> None:
    """Of an aft propeller with the same diameter, backwards, the fore one loses as much."""
    both = vehicle(FORE, replace(AFT, diameter=DIAMETER))
    np.testing.assert_allclose(lost(both, (-2.0, -2.0)), [-2.0 * IN_LINE, 0.0, 0.0, 0.0], atol=1e-15)


def test_beside_the_jet_less_is_lost_and_it_turns() -> None:
    """As far aside as half the jet is wide there, 1/e is left; the lever is that of the thruster."""
    aside = 0.5 * DIAMETER + 0.107 * 0.2
    found = lost(vehicle(FORE, replace(AFT, position=(-0.1, aside, 0.0))), (2.0, 2.0))
    taken = 2.0 * IN_LINE / math.e
    np.testing.assert_allclose(found, [taken, 0.0, 0.0, -aside * taken], rtol=1e-12, atol=1e-15)


def test_an_azimuth_blows_where_it_points() -> None:
    """A fore thruster that is turned by 90 deg to the right, its azimuth's part being -T, blows to the left.

    There stands one that pushes 60 deg off, and loses half as much, from both parts of its push.
    """
    push = (0.5 * math.sqrt(3.0), -0.5, 0.0)
    left = Thruster("left", (0.1, 0.2, 0.0), push, 4.0)
    platform = vehicle(FORE, Azimuth("turn", "fore", math.pi), left)
    taken = 2.0 * IN_LINE * 0.5
    expected = [taken * push[0], taken * push[1], 0.0, taken * (0.1 * push[1] - 0.2 * push[0])]
    np.testing.assert_allclose(lost(platform, (0.0, -2.0, 2.0)), expected, rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(lost(platform, (2.0, 0.0, 2.0)), 0.0, atol=1e-9)


def test_one_that_an_azimuth_turns_loses_along_its_push() -> None:
    """Both turned to the left behind each other: the whole push of the second, its azimuth's part, is in the jet."""
    second = replace(AFT, position=(0.1, -0.2, 0.0))
    platform = vehicle(FORE, Azimuth("first_turn", "fore", math.pi), second, Azimuth("second_turn", "aft", math.pi))
    found = lost(platform, (0.0, 2.0, 0.0, 2.0))
    np.testing.assert_allclose(found, [0.0, 2.0 * IN_LINE, 0.0, 0.1 * 2.0 * IN_LINE], rtol=1e-12, atol=1e-15)


def test_pairs_are_those_whose_jet_has_a_diameter() -> None:
    """None in a Lily; robots with fewer pairs have rows of zeros, which do nothing."""
    assert build_jets([load_platform("lily")]).shape == (1, 0, 8)
    jets = build_jets([load_platform("lily"), vehicle(AFT, FORE)])
    np.testing.assert_allclose(jets, [[[0.0] * 8], [[0, -1, 1, -1, -0.2, 0, 0, DIAMETER]]], atol=1e-15)


def test_wash_without_a_width_of_jets_is_said_to_do_nothing() -> None:
    """Neither thruster has a diameter: one sentence for the platform; none where one has, or nothing is lost."""
    still = hiding(vehicle(replace(FORE, diameter=None), AFT), {"wash_loss": {"loss": 1.0}})
    blowing = hiding(vehicle(FORE, AFT), {"wash_loss": {"loss": 1.0}})
    (sentence,) = not_simulated({"a": still, "b": still, "c": blowing, "d": load_platform("lily")})
    assert sentence.startswith(f"{still.origin}: 'effects.wash_loss' is thrust lost in jets, and no thruster has")
