"""Calibration from a recording: known numbers come back, with intervals that hold them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.run_record import RunRecord
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.parts.steering import Rudder
from cocorosim_ros.study.calibration.calibration_run import CalibrationRun, read_calibration_run
from cocorosim_ros.study.calibration.fit import fit_platform
from cocorosim_ros.study.calibration.free_run import ACCURATE, free_run
from cocorosim_ros.study.calibration.platform_file import write_platform
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles

TRUE = {
    "thrust_gain": 1.13,
    "drag": 1.9,
    "yaw_drag": 9.5e-4,
    "inertia": 2.4e-3,
    "buoyancy_gain": 0.9,
    "buoyancy_trim": -0.004,
}


def altered(jeff: Platform) -> Platform:
    """Jeff with the true numbers of this test."""
    volume = (jeff.mass + TRUE["buoyancy_trim"] / jeff.gravity) / jeff.water_density
    actuators: list[Any] = []
    for part in jeff.actuators:
        if part.kind == "thruster":
            actuators.append(replace(part, maximum=part.maximum * TRUE["thrust_gain"]))
        else:
            gain = TRUE["buoyancy_gain"]
            actuators.append(replace(part, neutral_volume=volume, volume_range=part.volume_range * gain))
    return replace(
        jeff,
        drag=TRUE["drag"],
        yaw_drag=TRUE["yaw_drag"],
        yaw_inertia=TRUE["inertia"],
        actuators=tuple(actuators),
    )


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The bag of the altered Jeff's calibration run, simulated; in a deep tank, as its trim makes it sink."""
    scenario = load_scenario("calibration_run_jeff")
    swarm = tuple(replace(group, platform=altered(group.platform)) for group in scenario.swarm)
    deep = replace(scenario.tank, size=(40.0, 40.0, 40.0))
    scenario = replace(scenario, swarm=swarm, tank=deep)
    folder = tmp_path_factory.mktemp("run") / "bag"
    record = RunRecord(folder, [describe_body(robot) for robot in scenario.robots], {})
    with record.writer:
        run_in_process(scenario, record)
    return folder


def test_known_numbers_come_back(recording: Path) -> None:
    """All six altered numbers within 0.1 % (trim: 0.1 % of the pump) from a run without noise."""
    jeff = load_platform("jeff")
    fit = fit_platform(jeff, read_calibration_run(recording, jeff))
    assert [number.name for number in fit.numbers] == list(TRUE)
    for number in fit.numbers:
        tolerance = 1.6e-4 if number.name == "buoyancy_trim" else 1e-3 * abs(TRUE[number.name])
        assert number.value == pytest.approx(TRUE[number.name], abs=tolerance)
    assert max(fit.scatter[:3]) < 2e-3


def noisy(run: CalibrationRun, seed: int) -> CalibrationRun:
    """The run as cameras with 5 mm and 0.02 rad of noise see it."""
    draw = np.random.default_rng(seed)
    poses = run.poses + draw.normal(size=run.poses.shape) * [0.005, 0.005, 0.005, 0.02]
    return replace(run, poses=np.vstack([run.poses[:1], poses[1:]]))


def test_intervals_hold_the_truth(recording: Path) -> None:
    """Of 6 numbers in 8 noisy runs about 46 of 48 intervals hold the truth; fewer than 40 would be a wrong width."""
    jeff = load_platform("jeff")
    clean = read_calibration_run(recording, jeff)
    inside = [
        number.low <= TRUE[number.name] <= number.high
        for seed in range(8)
        for number in fit_platform(jeff, noisy(clean, seed)).numbers
    ]
    assert sum(inside) >= 40


def test_the_written_platform_is_the_fitted_one(recording: Path, tmp_path: Path) -> None:
    """The file loads, has the fitted numbers, keeps everything else, and is not overwritten unasked."""
    jeff, out = load_platform("jeff"), tmp_path / "jeff_fitted.yaml"
    fit = fit_platform(jeff, read_calibration_run(recording, jeff))
    write_platform(out, jeff, fit, "a bag")
    fitted = load_platform(out)
    expected = altered(jeff)
    assert fitted.drag == pytest.approx(expected.drag, rel=1e-3)
    assert fitted.yaw_inertia == pytest.approx(expected.yaw_inertia, rel=1e-3)
    np.testing.assert_allclose(fitted.actuator_limits(), expected.actuator_limits(), rtol=1e-3)
    np.testing.assert_array_equal(fitted.actuator_wrenches(), jeff.actuator_wrenches())
    assert fitted.sensors == jeff.sensors
    before = out.read_bytes()
    with pytest.raises(CocorosimError, match="exists already"):
        write_platform(out, jeff, fit, "another bag")
    assert out.read_bytes() == before


def test_what_was_not_tried_is_not_fitted(recording: Path) -> None:
    """Without pump commands the pump's gain is reported as not shown, the others are found."""
    jeff = load_platform("jeff")
    run = read_calibration_run(recording, jeff)
    straight = run.measured < np.searchsorted(run.moments, 90.0)
    early = replace(run, measured=run.measured[straight], poses=run.poses[straight])
    fit = fit_platform(jeff, early)
    assert fit.not_shown == ("buoyancy_gain",)
    assert {number.name for number in fit.numbers} == set(TRUE) - {"buoyancy_gain"}


def test_a_robot_that_is_not_there(recording: Path) -> None:
    """The sentence names the robots that are."""
    with pytest.raises(CocorosimError, match="no poses of 'lily_01'; it has jeff_01"):
        read_calibration_run(recording, load_platform("jeff"), "lily_01")


def test_a_weaker_thruster_turns_no_rudder_less() -> None:
    """A rudder's largest angle is no thrust: a Lily with one, of 0.8 times the thrust, is found so within 0.1 %."""
    lily = load_platform("lily")
    rudder = Rudder("rudder", (-0.06, 0.0, 0.0), area=0.001, aspect_ratio=1.5, largest_angle=0.5)
    nominal = replace(lily, actuators=(*lily.actuators, rudder))
    weaker: list[Any] = [replace(part, gain=0.8) if part.kind == "thruster" else part for part in nominal.actuators]
    moments = np.arange(0.0, 60.0, 0.5)
    commands = np.zeros((len(moments), 4))
    commands[:80, :2], commands[20:50, 3], commands[50:80, 3], commands[80:90, 0] = 1.0, 1.0, -0.5, 1.0
    path = free_run(
        build_vehicles([replace(nominal, actuators=tuple(weaker))]), np.zeros(4), moments, commands, ACCURATE
    )
    fit = fit_platform(nominal, CalibrationRun("lily", moments, commands, np.arange(len(moments)), path))
    found = {number.name: number for number in fit.numbers}
    assert found["thrust_gain"].value == pytest.approx(0.8, rel=1e-3)
    for name in ("drag", "yaw_drag", "inertia"):
        assert found[name].value == pytest.approx(found[name].nominal, rel=1e-3)
