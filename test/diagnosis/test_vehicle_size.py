"""How strong a vehicle is, and what is taken for strong where it has no actuator."""

from __future__ import annotations

import math
import re
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Amplitude
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL, PHYSICS
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.diagnosis.tracks.vehicle_size import (
    LILY_SIZES,
    UNSCALED,
    coasting_time,
    full_forces,
    shortest_coasting,
    sizes,
    slowness,
)
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.quantity import dimension_of, si_unit


def vehicle(*force: float) -> Any:
    """What is asked of a vehicle."""
    return SimpleNamespace(force_scale=np.array(force))


def test_a_lily_is_as_strong_as_its_actuators() -> None:
    """Two thrusters ahead, a lever, a pump."""
    assert full_forces(vehicle(0.01, 0.0, 0.0981, 2.5e-4)) == (0.01, 0.0981, 2.5e-4)


def test_what_cannot_turn_itself_is_turned_all_the_same() -> None:
    """Four propellers downwards: random forces across and in yaw are looked for in the size of these."""
    across, heave, yaw = full_forces(vehicle(0.0, 0.0, 20.0, 0.0))
    assert (across, heave) == (2.0, 20.0) and yaw == pytest.approx(0.04)


def test_what_only_drifts_has_a_lilys_measure() -> None:
    """No actuator at all is no reason for forces of nothing."""
    assert min(full_forces(vehicle(0.0, 0.0, 0.0, 0.0))[::2]) > 0.0


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("slocum_glider", 70.0 / math.sqrt(7.5 * 250e-6 * 1004 * 9.81)),  # its pump alone; no thruster, no turn
        ("lily", 0.44 / math.sqrt(1.7778 * 10e-6 * 1000 * 9.81)),  # the pump brings it to speed sooner than thrusters
        ("tauv_pool", 2.0 / (math.sqrt(4.0 * 30.0) + 2.0)),  # linear drag brakes too
    ],
)
def test_the_shortest_coasting_is_that_of_the_strongest_axis(name: str, expected: float) -> None:
    """m dv/dt = -k v^2 halves the speed v = sqrt(F / k) in m / (k v)."""
    assert shortest_coasting(vehicle_model(load_platform(name))) == pytest.approx(expected, rel=1e-6)


def lily_row(**numbers: float) -> tuple[Any, Any]:
    """The model of a Lily, and its row with these numbers multiplied."""
    vehicle = vehicle_model(load_platform("lily"))
    row = vehicle.row
    for name, factor in numbers.items():
        row[COLUMN[name]] *= factor
    return vehicle, row


def test_coasting_times_follow_from_drag_and_force() -> None:
    """m / sqrt(k F) of 0.44 kg, 1.7778 kg/m, 0.01 N: 3.3 s; a hundredth of the drag takes ten times as long."""
    vehicle, row = lily_row()
    assert coasting_time(vehicle, row) == pytest.approx(0.44 / math.sqrt(1.7778 * 0.01), rel=1e-3)
    assert coasting_time(*lily_row(drag=0.01)) == pytest.approx(10.0 * 0.44 / math.sqrt(1.7778 * 0.01), rel=1e-3)
    assert coasting_time(*lily_row(drag=0.0)) == math.inf


def measured(force: tuple[float, ...], mass: float, inertia: float, drag: tuple[float, float], hull: float) -> Any:
    """A vehicle with these numbers of its platform; drag: along its way and in yaw."""
    row = NEUTRAL.copy()
    for name, value in zip(("mass", "yaw_inertia", "drag", "yaw_drag"), (mass, inertia, *drag), strict=True):
        row[COLUMN[name]] = value
    nominal = row[PHYSICS]
    return SimpleNamespace(
        force_scale=np.array(force), nominal=nominal, row=row, mass=mass, yaw_inertia=inertia, hull=hull
    )


def test_a_lily_has_the_size_of_a_lily() -> None:
    """For every unit; its speed and turn are those of the contract, of three digits."""
    lily = measured((0.01, 0.0, 0.0981, 2.5e-4), 0.44, 4.05e-4, (1.7778, 1.14e-4), 0.13)
    for unit, size in sizes(lily).items():
        assert size == pytest.approx(LILY_SIZES[unit], rel=5e-3), unit


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("lily", 1.0),
        ("lily_paper", 1.0),
        ("jeff", 0.725 / math.sqrt(1.524 * 0.01) / (0.44 / math.sqrt(1.7778 * 0.01))),
        ("bluerov2_heavy", 1.0),  # which stops at once
    ],
)
def test_times_of_a_vehicle_are_those_of_its_coasting(name: str, expected: float) -> None:
    """A Lily's times are exactly the ones that are written down, so that nothing of a Lily depends on them."""
    assert slowness(vehicle_model(load_platform(name))) == pytest.approx(expected, rel=0.0 if expected == 1.0 else 1e-9)


def test_delays_of_quick_vehicles_are_those_of_a_lily() -> None:
    """A hundred times the drag: it stops ten times as soon, a motor does not; and what is not braked has no time."""
    quick = measured((0.01, 0.0, 0.0981, 2.5e-4), 0.44, 4.05e-6, (177.78, 1.14e-4), 0.13)
    assert slowness(quick) == 1.0
    assert sizes(quick)["s"] == 1.0
    assert slowness(measured((0.01, 0.0, 0.0, 0.0), 0.44, 4.05e-4, (0.0, 0.0), 0.13)) == 1.0


def test_sizes_of_a_ship() -> None:
    """As heavy as 1000 Lilys, as strong as 400, with the drag of 100: twice as fast and five times as slow to stop.

    It coasts for m / sqrt(k F), 1000 / sqrt(100 * 400) times as long as a Lily does; sensors are the same.
    """
    speed, turn = math.sqrt(0.01 / 1.7778), math.sqrt(2.5e-4 / 1.14e-4)
    ship = sizes(measured((4.0, 0.0, 39.24, 0.1), 440.0, 0.81, (177.78, 4.56e-2), 1.3))
    twice, as_fast = 2.0 * speed / 0.075, turn / 1.48
    expected = {
        "N": 400.0, "N/s": 80.0, "N/m": 400.0, "N s/m": 400.0 / twice, "kg/m": 400.0 / twice**2, "N m": 400.0,
        "N m/s": 80.0, "N m s": 400.0 / as_fast, "N m s^2": 400.0 / as_fast**2, "kg": 1000.0, "kg m^2": 2000.0,
        "m/s": twice, "1/s": twice, "s/m": 1.0 / twice, "m/s^2": 0.4, "rad/s": as_fast, "m": 10.0, "s": 5.0,
    }  # fmt: skip
    assert {unit: ship[unit] for unit in expected} == pytest.approx(expected, rel=1e-5)
    assert {unit: ship[unit] for unit in ship if unit not in expected} == dict.fromkeys(UNSCALED, 1.0)


def test_a_unit_without_a_size_is_an_error() -> None:
    """Not one in silence."""
    amplitude = Amplitude("tether.stiffness", "stiffness", "N/m^2", 1e-3)
    with pytest.raises(KeyError, match=re.escape("N/m^2")):
        Candidate(ENTRIES[0], ("a",), ((0,),)).large(amplitude)


@pytest.mark.parametrize("unit", LILY_SIZES)
def test_a_platform_file_can_have_every_unit_of_an_amplitude(unit: str) -> None:
    """What a diagnosis may find can be written down: in SI."""
    assert si_unit(dimension_of(unit)) == unit
