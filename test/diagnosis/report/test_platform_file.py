"""The model of a vehicle whose platform has six degrees of freedom is a platform in four."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.library.diagnose import diagnose
from cocorosim_ros.library.diagnosis_result import DiagnosisResult
from cocorosim_ros.library.record import record
from cocorosim_ros.scenario.parts.in_four_degrees import in_four_degrees
from cocorosim_ros.scenario.parts.platform import load_platform

SCENARIO = """\
name: rov
description: an ROV that does nothing
seed: 1
tick: 0.1 s
duration: 5 s
tank: {size: [20 m, 20 m, 10 m]}
integrator: {name: rk4, step: 0.05 s, contact: inelastic}
swarm:
  - {platform: bluerov2_heavy, prefix: rov, controller: idle, start: {poses: [[0 m, 0 m, -5 m, 30 deg]]}}
"""
RANGES = """\
based_on: bluerov2_heavy
name: own
description: with another number of its own
mass: {value: 13.6, unit: kg, range: [13.4, 13.8], source: scales}
robots:
  rov_02: {mass: {value: 14, unit: kg, source: scales}}
"""


@pytest.fixture(scope="module")
def bag(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording that says next to nothing."""
    folder = tmp_path_factory.mktemp("rov")
    (folder / "rov.yaml").write_text(SCENARIO)
    return record(folder / "rov.yaml", folder / "bag").path


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A platform that is based on one with six_degrees, with a range and a heavier robot."""
    path = tmp_path_factory.mktemp("own") / "own.yaml"
    path.write_text(RANGES)
    return path


def test_model_has_four_degrees(bag: Path, own: Path, tmp_path: Path) -> None:
    """Read back it is what the platform is in four degrees of freedom, with ranges, robots and sources."""
    result: DiagnosisResult = diagnose(bag, own, out=tmp_path / "found")
    model, given = load_platform(tmp_path / "found" / "model.yaml"), in_four_degrees(load_platform(own))
    assert model.six_degrees is None and model.drag_form == "own_speed"
    for one, other in ((model, given), (model.of_robot("rov_02"), given.of_robot("rov_02"))):
        numbers = [(each.mass, each.yaw_inertia, each.drag, each.yaw_drag) for each in (one, other)]
        assert numbers[0] == pytest.approx(numbers[1], rel=1e-11)
        assert one.effects == {name: pytest.approx(part, rel=1e-11) for name, part in other.effects.items()}
        assert one.ranges.keys() == other.ranges.keys()
    assert "six_degrees of own.yaml" in (tmp_path / "found" / "model.yaml").read_text()
    assert [remark for remark in result.remarks if "is diagnosed in surge, sway, heave and yaw" in remark] == [
        *given.told
    ]


def test_diagnosis_with_its_model_says_no_more_of_it(bag: Path, tmp_path: Path) -> None:
    """The model has nothing that is left out."""
    diagnose(bag, "bluerov2_heavy", out=tmp_path / "found")
    again = diagnose(bag, tmp_path / "found" / "model.yaml")
    assert not any("is diagnosed in surge" in remark for remark in again.remarks)
