"""A vehicle whose drag goes by each axis' own speed, and numbers that its platform declares with a range."""

from __future__ import annotations

from pathlib import Path

import boats
import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.diagnose_against import diagnose_against
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.diagnosis.report.changed_vehicle import as_platform
from cocorosim_ros.diagnosis.report.model_file import Origin, model_yaml
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.vehicle_model.platform_effects import check_platform

DECLARED = """
drag_form: own_speed
effects:
  anisotropic_drag: {sway_ratio: {value: 2, unit: "1", range: [1, 6], source: made}}
  thruster_lag: {time_constant: {value: 0.2, unit: s, range: [0.05, 1], source: made}}
  linear_drag: {yaw: {value: 0.1, unit: N m s, range: [0, 1], source: made}}
"""


def test_a_boat_with_drag_by_axis_is_read_to_the_digit(tmp_path: Path) -> None:
    """The form that the file leaves open is found, then lag, ratio and linear drag, and no more."""
    boat = boats.platform(tmp_path)
    found = diagnose(boats.recorded(boat, boats.Truth(), 160.0, 1), lambda words, share: None)
    assert found.drag_form == "own_speed"
    assert any("drag_form" in remark for remark in found.remarks)
    numbers = {effect.id: effect.parameters for effect in found.effects}
    assert set(numbers) == {"thruster_lag", "anisotropic_drag", "linear_drag"}
    assert numbers["thruster_lag"]["time_constant"].value == pytest.approx(0.35, rel=0.01)
    assert numbers["anisotropic_drag"]["sway_ratio"].value == pytest.approx(3.0, rel=0.03)
    assert numbers["linear_drag"]["yaw"].value == pytest.approx(0.3, rel=0.01)
    drag = next(each for each in found.all_recalibrated if each.parameter == "drag")
    assert drag.estimate.value == pytest.approx(8.0, rel=0.02)


@pytest.mark.parametrize(
    ("truth", "form", "effects"),
    [
        (boats.Truth(sway=8.0), "own_speed", {"thruster_lag", "linear_drag"}),
        (boats.Truth(total=True), "", {"thruster_lag", "anisotropic_drag", "linear_drag"}),
    ],
    ids=["as much to the side as ahead", "by the whole speed"],
)
def test_boats_of_either_form_are_read_to_the_digit(
    tmp_path: Path, truth: boats.Truth, form: str, effects: set[str]
) -> None:
    """No sway ratio where there is none; where drag goes by the whole speed no form is found beside a simulation's."""
    found = diagnose(boats.recorded(boats.platform(tmp_path), truth, 160.0, 1), lambda words, share: None)
    assert found.drag_form == form
    numbers = {effect.id: effect.parameters for effect in found.effects}
    assert set(numbers) == effects
    assert numbers["thruster_lag"]["time_constant"].value == pytest.approx(0.35, rel=0.01)
    assert numbers["linear_drag"]["yaw"].value == pytest.approx(0.3, rel=0.02)
    if "anisotropic_drag" in effects:
        assert numbers["anisotropic_drag"]["sway_ratio"].value == pytest.approx(3.0, rel=0.03)
    drag = next(each for each in found.all_recalibrated if each.parameter == "drag")
    assert drag.estimate.value == pytest.approx(8.0, rel=0.02)


def test_the_form_that_a_comparison_learned_is_told(tmp_path: Path) -> None:
    """Its model file has the numbers of the learned vehicle, which hold in this form and with this step alone."""
    boat = boats.platform(tmp_path)
    good, bad = (boats.recorded(boat, boats.Truth(), 60.0, seed) for seed in (5, 6))
    found = diagnose_against(bad, good, lambda words, share: None)
    assert found.drag_form == "own_speed"
    robots = tuple(log.name for log in bad.recordings[0].robots)
    path = tmp_path / "model.yaml"
    path.write_text(model_yaml(as_platform(found, boat), Origin(boat, ("made",), robots, 60.0)), encoding="utf-8")
    assert load_platform(path).drag_form == "own_speed"


def test_what_a_platform_declares_is_fitted_and_not_missing(tmp_path: Path) -> None:
    """With ranges for ratio, lag and linear drag the base finds all three within them."""
    boat = boats.platform(tmp_path, DECLARED)
    base = settled(first_fit(boats.recorded(boat, boats.Truth(), 120.0, 2)), 10)
    numbers = {each.column: each.value(float(q)) for each, q in zip(base.unknowns, base.q, strict=True)}
    assert numbers["anisotropic_drag.sway_ratio"] == pytest.approx(3.0, rel=0.05)
    assert numbers["thruster_lag.time_constant"] == pytest.approx(0.35, rel=0.02)
    assert numbers["linear_drag.yaw"] == pytest.approx(0.3, rel=0.02)
    assert numbers["drag"] == pytest.approx(8.0, rel=0.03)


def test_no_fit_leaves_a_declared_range(tmp_path: Path) -> None:
    """A true ratio of 3 outside a range that ends at 2.5 is fitted at its end."""
    boat = boats.platform(tmp_path, DECLARED.replace("[1, 6]", "[1, 2.5]"))
    base = settled(first_fit(boats.recorded(boat, boats.Truth(), 60.0, 3)), 10)
    ratio = next(each.value(float(q)) for each, q in zip(base.unknowns, base.q, strict=True) if "sway" in each.column)
    assert ratio == pytest.approx(2.5)


def test_a_form_that_an_effect_contradicts_is_refused(tmp_path: Path) -> None:
    """An effect that adds to the drag by total speed does not fit a drag by each axis' own."""
    more = DECLARED.replace("{sway_ratio:", '{form: {value: 1, unit: "1", source: made}, sway_ratio:')
    with pytest.raises(CocorosimError, match=r"anisotropic_drag\.form' has 'added_own_speed'.*drag_form: own_speed"):
        check_platform(boats.platform(tmp_path, more))
