"""Thrusters with a curve and a gain of their own: the filter's forces are the simulator's, and gains are found."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.diagnosis.report.model_file import Origin, model_tree
from cocorosim_ros.diagnosis.showing.estimates import fitted as numbers_of
from cocorosim_ros.diagnosis.showing.estimates import recalibrated
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import Platform, load_platform, read_platform_file
from cocorosim_ros.scenario.reading.yaml_file import yaml_text

DECLARED = """
drag_form: own_speed
effects:
  anisotropic_drag: {sway_ratio: {value: 3, unit: "1", source: made}}
  thruster_lag: {time_constant: {value: 0.35, unit: s, source: made}}
  linear_drag: {yaw: {value: 0.3, unit: N m s, source: made}}
"""
GAIN = """maximum: {value: 20, unit: N, source: made, confidence: estimate}
    curve: {form: square, dead_band: {value: 0.1, unit: "1", source: made, confidence: estimate}}
    gain: {value: 1, unit: "1", range: [0.5, 1.5], source: made, confidence: estimate}"""
GAINS = np.array([0.8, 1.1])


def curved(tmp_path: Path) -> Platform:
    """The made boat with curves, and a range for the gain of each thruster."""
    boats.platform(tmp_path, DECLARED)
    path = tmp_path / "boat.yaml"
    path.write_text(path.read_text().replace("maximum: {value: 20, unit: N, source: made, confidence: estimate}", GAIN))
    return read_platform_file(path)


def thrust(commands: Any) -> Any:
    """The true shares of the full force: g sign(c) ((|c| - 0.1) / 0.9)^2."""
    return GAINS * np.sign(commands) * (np.maximum(np.abs(commands) - 0.1, 0.0) / 0.9) ** 2


@pytest.fixture(scope="module")
def fitted(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """The boat, and the fit of its platform to a drive with the true gains."""
    boat = curved(tmp_path_factory.mktemp("curved"))
    return boat, settled(first_fit(boats.recorded(boat, boats.Truth(), 120.0, 4, thrust)), 10)


def test_own_gains_are_found(fitted: Any) -> None:
    """0.8 and 1.1 within their intervals; no gain of all thrusters is left beside them."""
    every, _ = recalibrated(numbers_of(fitted[1]))
    found = {each.parameter: each.estimate for each in every}
    assert not {"thrust_gain", "yaw_torque_gain"} & set(found)
    for name, true in zip(("left", "right"), GAINS, strict=True):
        estimate = found[f"actuators.{name}.gain"]
        assert estimate.value == pytest.approx(true, rel=0.03)
        assert estimate.holds(true)
    assert found["drag"].value == pytest.approx(8.0, rel=0.04)


def test_the_model_has_the_gains(fitted: Any, tmp_path: Path) -> None:
    """The file that the diagnosis writes is a platform with these gains, their ranges and the same curves."""
    from cocorosim_ros.diagnosis.findings import Diagnosis

    boat, fit = fitted
    every, _ = recalibrated(numbers_of(fit))
    told = Diagnosis("recalibrate", "", every, (), (), (), (), {}, every)
    path = tmp_path / "model.yaml"
    path.write_text(yaml_text(model_tree(told, Origin(boat, ("made",), ("boat",), 120.0))))
    model = load_platform(path)
    value = {each.parameter: each.estimate.value for each in every}
    for before, after in zip(boat.actuators, model.actuators, strict=True):
        key = f"actuators.{before.name}.gain"
        assert after.gain == value[key]
        assert after.curve == before.curve
        assert (model.ranges[key].low, model.ranges[key].high) == (0.5, 1.5)


def test_a_platform_with_a_gain_is_the_start_of_the_fit(tmp_path: Path) -> None:
    """A declared gain of 0.8 is what the model begins with, not a factor on top of it."""
    boat = curved(tmp_path)
    path = Path(boat.origin)
    path.write_text(path.read_text().replace("gain: {value: 1,", "gain: {value: 0.8,", 1))
    other = read_platform_file(path)
    vehicles = [vehicle_model(each) for each in (boat, other)]
    assert vehicles[1].row[COLUMN["own_gain.1"]] == 0.8
    limits = [vehicle.body(vehicle.row).actuator_limit for vehicle in vehicles]
    np.testing.assert_allclose(limits[1], limits[0] * [[0.8], [1.0]], rtol=1e-14)
