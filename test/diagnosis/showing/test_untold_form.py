"""A declared form of the drag that is wrong is told as the reason against what is named in its stead."""

from __future__ import annotations

from pathlib import Path

import boats
import pytest
from named_in_vain import case_of

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.showing.case import Case
from cocorosim_ros.diagnosis.showing.untold_form import untold_form

RATIO = 'anisotropic_drag: {sway_ratio: {value: 3, unit: "1", source: made'
FITTED = boats.KNOWN.replace(RATIO, RATIO + ", range: [1, 6]")
TOTAL = boats.Truth(total=True)


def case(folder: Path, truth: boats.Truth, form: str, *, named: str = "") -> Case:
    """A boat that the platform's file knows, in a declared form of drag, with a named effect of no evidence or none."""
    boat = boats.platform(folder, FITTED.replace("own_speed", form))
    base = base_fit(boats.recorded(boat, truth, 120.0, 4))
    if not named:
        return Case(base, (), (), (), {}, base, declared_form=True)
    return case_of(base, named, declared_form=True)


@pytest.mark.parametrize("named", ["torque_bias", ""], ids=["an effect of motion", "nothing"])
def test_a_form_that_explains_more_is_told(tmp_path: Path, named: str) -> None:
    """The boat of total speed, whose file says own speed, with its nats; not where the file is right."""
    (told,) = untold_form(case(tmp_path, TOTAL, "own_speed", named=named))
    assert "'drag_form: total_speed'" in told.sentence
    assert float(told.sentence.partition(", by ")[2].split()[0]) > 10.0
    assert list(untold_form(case(tmp_path, TOTAL, "total_speed", named=named))) == []
    assert list(untold_form(case(tmp_path, boats.Truth(), "own_speed", named=named))) == []


def test_errors_of_readings_are_no_matter_of_drag(tmp_path: Path) -> None:
    """Nothing is asked where readings alone err."""
    assert list(untold_form(case(tmp_path, TOTAL, "own_speed", named="sensor_latency"))) == []


def test_what_a_wrong_form_leaves_is_never_confirmed(tmp_path: Path) -> None:
    """A whole diagnosis of the boat of total speed in the form of own speed: suspected at most, with the reason."""
    boat = boats.platform(tmp_path, FITTED)
    found = diagnose(boats.recorded(boat, TOTAL, 160.0, 1), lambda words, share: None)
    assert found.effects or found.warnings
    assert not any(each.tier == "confirmed" for each in found.effects)
    said = [*found.warnings, *(sentence for each in found.effects for sentence in each.because)]
    assert any("drag_form: total_speed" in sentence for sentence in said)
