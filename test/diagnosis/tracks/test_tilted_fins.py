"""What roll and pitch add to the forces of fins: against the lift of each fin in its own flow, turned by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.filter.records import Drive, Grid
from cocorosim_ros.diagnosis.tracks.actuation import Actuation
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel, vehicle_model
from cocorosim_ros.scenario.parts.in_four_degrees import in_four_degrees
from cocorosim_ros.scenario.parts.platform import load_platform

GRID = Grid(0.0, 0.1, 100)
AHEAD, SIDEWAYS, UPWARDS, TURNING = 1.4, 0.1, -0.05, 0.12  # m/s along the hull, and rad/s of the heading
RUDDER, PLANES = 0.5, -0.3  # of their largest angles
COEFFICIENT = 0.5 * 1030.0 * 0.00665 * 2.8148  # kg/m, Prestero's Y_uudr
STOP = math.radians(13.6)
BEHIND = -0.638  # m


@pytest.fixture(scope="module")
def torpedo() -> VehicleModel:
    """The REMUS in four degrees of freedom."""
    return replace(vehicle_model(in_four_degrees(load_platform("remus100"))), tilts=True)


def turned(roll: float, pitch: float) -> np.ndarray:
    """The rotation from the hull's axes to level ones, as a product of two."""
    about_x = np.array(
        [[1, 0, 0], [0, math.cos(roll), -math.sin(roll)], [0, math.sin(roll), math.cos(roll)]], dtype=float
    )
    about_y = np.array(
        [[math.cos(pitch), 0, math.sin(pitch)], [0, 1, 0], [-math.sin(pitch), 0, math.cos(pitch)]], dtype=float
    )
    return np.asarray(about_y @ about_x)


def drive_of(torpedo: VehicleModel, roll: float, pitch: float, *, velocity: bool = True) -> Drive:
    """What acts while it goes steadily at an attitude, as recorded."""
    time = np.arange(0.0, 10.0, 0.05)
    level = turned(roll, pitch) @ [AHEAD, SIDEWAYS, UPWARDS]
    imu = np.full((len(time), 4), np.nan)
    imu[:, 0] = TURNING
    streams = {"imu": Stream(time, imu, np.zeros(4))}
    if velocity:
        streams["velocity"] = Stream(time, np.tile(level, (len(time), 1)), np.zeros(3))
    attitude = Attitude(time, np.full(len(time), roll), np.full(len(time), pitch))
    log = RobotLog("auv", np.zeros(1), np.array([[0.0, RUDDER, PLANES]]), streams, attitude=attitude)
    return Actuation(torpedo, log, GRID).drive(torpedo.row)


def lifts_of_hull(roll: float, pitch: float) -> tuple[float, float]:
    """Lift of rudder and planes [N], in the water that the tilted hull meets."""
    about_own_axis = TURNING * math.cos(roll) * math.cos(pitch)
    rudder = COEFFICIENT * AHEAD * (AHEAD * RUDDER * STOP - SIDEWAYS - BEHIND * about_own_axis)
    return rudder, COEFFICIENT * AHEAD * (AHEAD * PLANES * STOP - UPWARDS)


def lifts_of_model(torpedo: VehicleModel, drive: Drive, roll: float, pitch: float) -> np.ndarray:
    """Wrench (4,) of both fins of the level model at the recorded motion, with the angles that it is driven by."""
    u, v, w = turned(roll, pitch) @ [AHEAD, SIDEWAYS, UPWARDS]
    rudder = COEFFICIENT * abs(u) * (u * drive.force[50, 1] - v - BEHIND * TURNING)
    planes = COEFFICIENT * abs(u) * (u * drive.force[50, 2] - w)
    return np.array([0.0, rudder, planes, BEHIND * rudder])


@pytest.mark.parametrize(("roll", "pitch"), [(0.0, 0.25), (0.2, 0.0), (-0.15, -0.3)])
def test_the_fins_of_a_tilted_hull_push_along_its_own_axes(torpedo: VehicleModel, roll: float, pitch: float) -> None:
    """Those of the level model, with what is added, are the lifts that the hull feels, turned."""
    drive, level = drive_of(torpedo, roll, pitch), turned(roll, pitch)
    bare = replace(torpedo, fin_normal=np.zeros((3, 3)))
    of_hull = drive_of(bare, roll, pitch).force[50, 3:]
    rudder, planes = lifts_of_hull(roll, pitch)
    expected = np.append(level @ [0.0, rudder, planes], BEHIND * rudder)
    found = lifts_of_model(torpedo, drive, roll, pitch) + drive.force[50, 3:] - of_hull
    np.testing.assert_allclose(found, expected, atol=1e-9)
    assert abs(expected[0]) > 0.05 or pitch == 0.0


def test_level_fins_have_nothing_added(torpedo: VehicleModel) -> None:
    """Nor have those whose speed through the water is not known."""
    assert np.abs(drive_of(torpedo, 0.0, 0.0).force[:, 3:]).max() < 1e-12
    assert not drive_of(torpedo, 0.0, 0.2, velocity=False).force[:, 3:].any()


def test_a_gain_of_the_fins_changes_what_is_added(torpedo: VehicleModel) -> None:
    """In proportion: twice the gain, twice the force ahead; and the first again after that."""
    time = np.arange(0.0, 10.0, 0.05)
    level = turned(0.0, 0.25) @ [AHEAD, 0.0, 0.0]
    streams = {"velocity": Stream(time, np.tile(level, (len(time), 1)), np.zeros(3))}
    log = RobotLog("auv", np.zeros(1), np.array([[0.0, RUDDER, PLANES]]), streams)
    tilted = replace(log, attitude=Attitude(time, np.zeros(len(time)), np.full(len(time), 0.25)))
    actuation, bare = (
        Actuation(each, tilted, GRID) for each in (torpedo, replace(torpedo, fin_normal=np.zeros((3, 3))))
    )
    row, double = torpedo.row, torpedo.row
    double[[COLUMN["fin_1.gain"], COLUMN["fin_2.gain"]]] *= 2.0
    once, twice, again = (
        actuation.drive(each).force[50, 3:] - bare.drive(each).force[50, 3:] for each in (row, double, row)
    )
    assert abs(once[0]) > 0.1
    np.testing.assert_allclose(twice, 2.0 * once, atol=1e-9)
    np.testing.assert_array_equal(again, once)
