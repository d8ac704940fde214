"""A vehicle with rudders and stern planes in the filter: the simulator's course, a fin's gain, a recorded pitch."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import ships

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.diagnosis.report.changed_vehicle import as_platform
from cocorosim_ros.diagnosis.report.model_file import Origin, model_yaml
from cocorosim_ros.diagnosis.report.words import check_words
from cocorosim_ros.diagnosis.showing.estimates import fitted, recalibrated
from cocorosim_ros.diagnosis.tracks.actuation import Actuation
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.platform import load_platform

NOISE = np.array([0.005, 0.005, 0.005, 0.001])  # m, m, m, rad
LARGEST = math.radians(20.0)


def fin(name: str, direction: str, gain: float, more: str = "") -> str:
    """A fin at the stern."""
    return f"""  - name: {name}
    kind: fin
    position: {{value: [-3, 0, 0], unit: m, {ships.SOURCE}}}
    direction: {{value: {direction}, unit: "1", {ships.SOURCE}}}
    area: {ships.number(0.04, "m^2")}
    lift_slope: {ships.number(3.0, "1/rad")}
    largest_angle: {ships.number(20, "deg")}
    gain: {ships.number(gain, "1", more)}
"""


def torpedo(folder: Path, gain: float, ranges: bool) -> Any:
    """A propeller, rudders, and stern planes of this gain."""
    folder.mkdir(exist_ok=True)
    planes = fin("planes", "[0, 0, 1]", gain, "range: [0.3, 2], " if ranges else "")
    return ships.ship(folder, ships.PROPELLER + fin("rudders", "[0, 1, 0]", 1.0) + planes)


def driven(ticks: int) -> Any:
    """(ticks, 3) commands: the propeller in steps, rudders and planes to and fro at paces of their own."""
    tick = np.arange(ticks)
    rudders = 0.4 * np.sign(np.sin(2.0 * np.pi * tick / 70.0))
    planes = 0.6 * np.sign(np.sin(2.0 * np.pi * tick / 46.0))
    return np.column_stack([np.where(tick % 150 < 100, 0.9, 0.5), rudders, planes])


def recorded(given: Any, truth: Any, ticks: int = 400) -> Evidence:
    """Evidence of a true vehicle, poses every half second, for a given platform."""
    commands = driven(ticks)
    rows = ships.run(truth, commands, start=(0.8, 0.0, 0.0))[:, :4]
    value = rows + NOISE * np.random.default_rng(20261126).standard_normal(rows.shape)
    log = RobotLog("ship", 0.5 * np.arange(ticks), commands, {"pose": Stream(0.5 * np.arange(ticks + 1), value, NOISE)})
    return Evidence(given, (RecordingLog("made", 0.5 * ticks, (log,)),))


def test_the_filter_runs_the_simulators_vehicle(tmp_path: Path) -> None:
    """A free run of the filter's model from the true start follows the simulator to the error of its midpoint steps."""
    truth = torpedo(tmp_path, 0.8, ranges=False)
    track = first_fit(recorded(truth, truth, 120)).tracks[0]
    rows = ships.run(truth, driven(120), start=(0.8, 0.0, 0.0))
    grid = track.timeline.grid
    path = track.filter.free_run(track.vehicle.row, rows[0, :8], 0, grid.points)
    seen = np.column_stack([np.interp(grid.moments, 0.5 * np.arange(121), rows[:, column]) for column in range(8)])
    at_ticks = np.isclose(grid.moments % 0.5, 0.0) | np.isclose(grid.moments % 0.5, 0.5)
    np.testing.assert_allclose(path[at_ticks], seen[at_ticks], atol=2e-3)
    assert np.abs(rows[-1, 3]) > 0.1 and np.ptp(rows[:, 2]) > 0.1


def test_a_stern_plane_is_recalibrated(tmp_path: Path) -> None:
    """A true gain of 0.8 lies within the interval of a fit that begins at 1."""
    truth, given = torpedo(tmp_path / "true", 0.8, ranges=False), torpedo(tmp_path, 1.0, ranges=True)
    every, _ = recalibrated(fitted(settled(first_fit(recorded(given, truth)), 6)))
    (gain,) = [each.estimate for each in every if each.parameter == "actuators.planes.gain"]
    assert gain.value == pytest.approx(0.8, rel=0.1)
    assert gain.holds(0.8)


@pytest.mark.parametrize("pitch", [-0.12, 0.0, 0.08])
def test_a_recorded_pitch_turns_a_fin_to_the_flow(tmp_path: Path, pitch: float) -> None:
    """Nose down by 0.08 rad, a plane's angle to the level is 0.08 rad less; its lift is that of the turned fin.

    By vectors: V turned into the body, c |V_x| (V_x d - V_n) there, turned back. What is left out goes with the cube of
    small angles: pitch, climb and that of the fin; of the other sign the lift would differ by twice u^2 pitch.
    """
    platform, share, level = torpedo(tmp_path, 1.0, ranges=False), 0.3, np.array([0.9, 0.0, 0.03])
    times = np.array([0.0, 10.0])
    attitude = Attitude(times, np.zeros(2), np.full(2, pitch))
    log = RobotLog("ship", times[:1], np.array([[0.0, share, share]]), {}, attitude=attitude)
    actuation = Actuation(vehicle_model(platform), log, Grid(0.0, 0.5, 3))
    angle = actuation.drive(actuation.vehicle.row).force[0, 1:3]
    assert angle == pytest.approx([share * LARGEST, share * LARGEST - math.sin(pitch)], abs=1e-12)
    turn = np.array([[math.cos(pitch), 0, math.sin(pitch)], [0, 1, 0], [-math.sin(pitch), 0, math.cos(pitch)]])
    flow = turn.T @ level
    lift = (turn @ [0.0, 0.0, abs(flow[0]) * (flow[0] * share * LARGEST - flow[2])])[2]
    small = (abs(pitch) + level[2] / level[0]) ** 2 * (abs(pitch) + share * LARGEST)
    assert abs(level[0]) * (level[0] * angle[1] - level[2]) == pytest.approx(lift, abs=level[0] ** 2 * small)


def test_a_hull_that_pitches_moves_its_fins_through_the_water(tmp_path: Path) -> None:
    """Stern planes 3 m behind the middle go up by 3 q where the nose goes down at q: their angle is that over u less.

    It is known where the speed is, and of planes alone: rudders stand across. Attitude and speed are read each 0.02 s.
    """
    platform, ahead, grid = torpedo(tmp_path, 1.0, ranges=False), 0.9, Grid(2.0, 0.1, 40)
    times, middles = np.arange(0.0, 10.0, 0.02), 2.0 + 0.1 * (np.arange(40) + 0.5)
    attitude = Attitude(times, 0.0 * times, 0.05 * np.sin(times))
    speed = np.tile([ahead, 0.0, 0.0], (len(times), 1))
    angles = {}
    for name, streams in (("resting", {}), ("moving", {"velocity": Stream(times, speed, np.zeros(3))})):
        log = RobotLog("ship", times[:1], np.zeros((1, 3)), streams, attitude=attitude)
        actuation = Actuation(vehicle_model(platform), log, grid)
        angles[name] = actuation.drive(actuation.vehicle.row).force[:, 1:3]
    rudders, planes = (angles["moving"] - angles["resting"]).T
    np.testing.assert_allclose(planes, -3.0 * 0.05 * np.cos(middles) / ahead, rtol=0.02, atol=1e-4)
    assert not rudders.any()


def askew(folder: Path, trim: float) -> Any:
    """The torpedo with rudders that stand askew at command zero, by this angle [rad]; of none its file says nothing."""
    folder.mkdir(exist_ok=True)
    told = f"    trim: {ships.number(trim, 'rad')}\n" if trim else ""
    rudders = fin("rudders", "[0, 1, 0]", 1.0) + told
    return ships.ship(folder, ships.PROPELLER + rudders + fin("planes", "[0, 0, 1]", 1.0))


def test_a_trim_is_an_angle_beside_the_command(tmp_path: Path) -> None:
    """Rudders of a torpedo that are told 0.1 of their largest angle less swim as others that stand askew by as much."""
    commands = driven(60)
    told = commands + np.array([0.0, 0.1, 0.0])
    plain = ships.run(askew(tmp_path / "plain", 0.0), told, start=(0.8, 0.0, 0.0))
    turned = ships.run(askew(tmp_path / "askew", 0.1 * LARGEST), commands, start=(0.8, 0.0, 0.0))
    np.testing.assert_allclose(turned[:, :8], plain[:, :8], rtol=1e-9, atol=1e-9)


def test_rudders_that_stand_askew_are_named_with_their_angle(tmp_path: Path) -> None:
    """Of one of rudders and planes, and nothing else; the model that is written has it, and misses nothing."""
    given, truth = askew(tmp_path / "given", 0.0), askew(tmp_path / "true", 0.05)
    told = diagnose(recorded(given, truth, 720), lambda _words, _share: None)
    (effect,) = told.effects
    assert effect.id == "steering_trim" and set(effect.parameters) == {"rudders"} and check_words(effect.id)
    assert effect.parameters["rudders"].holds(0.05)
    path = tmp_path / "model.yaml"
    origin = Origin(given, ("made",), ("ship",), 360.0)
    path.write_text(model_yaml(as_platform(told, given), origin), encoding="utf-8")
    model = load_platform(path)
    trims = {each.name: each.trim for each in model.actuators if isinstance(each, Fin)}
    assert trims == {"rudders": effect.parameters["rudders"].value, "planes": None}
    again = diagnose(recorded(model, truth, 720), lambda _words, _share: None)
    assert again.effects == ()
