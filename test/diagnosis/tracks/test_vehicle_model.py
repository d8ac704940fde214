"""From a row of numbers to the body that the simulator moves, and back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL, PHYSICS
from cocorosim_ros.diagnosis.tracks.surroundings import OPEN_WATER
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel, vehicle_model
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
from cocorosim_ros.world.terms.moment import NEIGHBOUR_SIZE
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PARAMETER_COLUMNS


@pytest.fixture(scope="module")
def lily() -> VehicleModel:
    """A Lily of the shipped platform file, alone."""
    return vehicle_model(load_platform("lily"))


@pytest.mark.parametrize("name", PARAMETER_COLUMNS)
def test_each_number_reaches_the_body_under_its_name_and_comes_back(lily: VehicleModel, name: str) -> None:
    """What stands in the row by name stands in the body at the simulator's place of that name, and there alone."""
    row = lily.row
    row[COLUMN[name]] += 0.25
    body = lily.body(row)
    (changed,) = np.flatnonzero(body.parameters != lily.nominal)
    assert changed == PARAMETER_COLUMNS[name]
    back = lily.row
    back[PHYSICS] = body.parameters
    np.testing.assert_array_equal(back, row)


@pytest.mark.parametrize("effect", ["linear_drag", "thruster_lag", "steady_current", "law_1"])
def test_a_number_that_is_not_neutral_switches_its_effect_on(lily: VehicleModel, effect: str) -> None:
    """And no other one; a neutral row switches on nothing."""
    assert not lily.body(lily.row).active & EFFECT_BIT[effect]
    column = next(name for name in PARAMETER_COLUMNS if name.startswith(f"{effect}."))
    row = lily.row
    row[COLUMN[column]] = 0.1
    assert lily.body(row).active == lily.active | EFFECT_BIT[effect]


def test_a_body_is_its_own_copy(lily: VehicleModel) -> None:
    """The filter writes random forces into the body; the next pass begins without them."""
    lily.body(lily.row).parameters[:] = 7.0
    np.testing.assert_array_equal(lily.body(lily.row).parameters, lily.nominal)


def test_the_row_holds_what_the_platform_says_of_its_sensors() -> None:
    """A compass offset of the platform's file is the row's; everything else beyond the physics is neutral."""
    said = {
        "compass_distortion": {"offset": Quantity(0.3, "rad", dimension_of("rad"))},
        "sensor_latency": {"pose": Quantity(0.2, "s", dimension_of("s"))},
    }
    row = vehicle_model(replace(load_platform("lily"), effect_quantities=said)).row
    other = np.flatnonzero(row != NEUTRAL)
    beyond = {name for name, column in COLUMN.items() if column in other and name not in PARAMETER_COLUMNS}
    assert beyond == {"compass_distortion.offset", "sensor_latency.pose"}
    assert row[COLUMN["compass_distortion.offset"]] == 0.3


def test_full_thrust_is_that_of_the_platform(lily: VehicleModel) -> None:
    """Two thrusters of 5 mN ahead [N], on levers that turn; a pump of 10 cm^3 that lifts 98.1 mN in fresh water."""
    platform = load_platform("lily")
    forward = sum(2 * [0.005])
    assert lily.force_scale[0] == pytest.approx(forward, rel=0.01)
    assert lily.force_scale[2] == pytest.approx(platform.water_density * platform.gravity * 10e-6, rel=1e-9)


def test_a_robot_among_others_feels_as_many(lily: VehicleModel) -> None:
    """Working space for three robots of whom it is the second; in open water there is none."""
    among = replace(lily, surroundings=OPEN_WATER._replace(around=np.zeros((9, 3, NEIGHBOUR_SIZE)), own=1))
    body = among.body(among.row)
    assert (body.neighbours.shape, body.own) == ((3, NEIGHBOUR_SIZE), 1)
    alone = lily.body(lily.row)
    assert (alone.neighbours.shape, alone.own) == ((0, NEIGHBOUR_SIZE), -1)
