"""Free runs on what no fit saw choose the effects: what holds in the fitted parts alone is not named."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.foretelling.unseen import unseen_parts
from cocorosim_ros.diagnosis.naming.choice import Choice

WIDTH, SECONDS, BLOCKS, FITTED = 0.09, 240.0, 4, 0.6
# What a platform says that knows the boat but for its drag in proportion to the turn rate.
WITHOUT_LINEAR = """
drag_form: own_speed
effects:
  anisotropic_drag: {sway_ratio: {value: 3, unit: "1", source: made}}
  thruster_lag: {time_constant: {value: 0.35, unit: s, source: made}}
"""


def beyond(command: Any) -> Any:
    """Shares of the full force: what exceeds the dead band."""
    return np.sign(command) * np.maximum(np.abs(command) - WIDTH, 0.0)


@pytest.fixture(scope="module")
def caught(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Evidence of a boat with a dead band in rough water, which drags a weed in the parts alone that are fitted.

    The weed turns it with 2 N m, a fifth of what its propellers can.
    """
    boat = boats.platform(tmp_path_factory.mktemp("boat"), boats.KNOWN)
    time = np.arange(round(SECONDS / boats.TICK)) * boats.TICK
    fitted = time % (SECONDS / BLOCKS) < FITTED * SECONDS / BLOCKS
    truths = [boats.Truth(weed=2.0 if each else 0.0, rough=1.0) for each in fitted]
    return boats.recorded(boat, truths, SECONDS, 1, beyond)


@pytest.fixture(scope="module")
def first(caught: Any) -> Any:
    """What a diagnosis finds."""
    from cocorosim_ros.library.diagnosis_result import DiagnosisResult

    return DiagnosisResult(diagnose(caught, lambda words, share: None), caught)


def test_what_holds_in_the_fitted_parts_alone_is_not_named(caught: Any, first: Any) -> None:
    """The evidence for the weed's moment is far above what is needed, and the likelihood alone would name it."""
    (split,) = unseen_parts(base_fit(caught)).splits
    assert len(split.held) == BLOCKS
    evidence = {each.id: each.nats for each in first.diagnosis.screened}
    assert evidence["torque_bias"] > 2.0 * NAMING.threshold
    assert [effect.id for effect in first.effects] == ["thruster_deadband"]
    assert first.effects[0].parameters["width"].value == pytest.approx(WIDTH, abs=0.02)


def test_a_linear_drag_of_many_nats_loses_to_the_dead_band_that_foretells(tmp_path: Path) -> None:
    """The same boat, braked in its turns by 0.6 N m s where it is fitted, and by nothing elsewhere.

    Evidence for a linear drag is five times as much as a name needs: on a real ROV such evidence was taken, and the
    dead band of its thrusters, by which free runs gained, was not. Here what is fitted, and so the yaw drag of the
    platform, is itself wrong elsewhere: nothing may be more than suspected.
    """
    boat = boats.platform(tmp_path, WITHOUT_LINEAR)
    braked = np.arange(round(SECONDS / boats.TICK)) * boats.TICK % (SECONDS / BLOCKS) < FITTED * SECONDS / BLOCKS
    truths = [boats.Truth(linear=0.6 if each else 0.0, rough=1.0) for each in braked]
    found = diagnose(boats.recorded(boat, truths, SECONDS, 1, beyond), lambda words, share: None)
    assert {each.id: each.nats for each in found.screened}["linear_drag"] > 5.0 * NAMING.threshold
    assert [(effect.id, effect.tier) for effect in found.effects] == [("thruster_deadband", "suspected")]
    assert found.effects[0].parameters["width"].value == pytest.approx(WIDTH, abs=0.02)
    assert "linear_drag" not in {each.found.id for each in found.passed_over if each.stands}


def test_the_found_model_finds_nothing_though_little_else_could_be_seen(
    caught: Any, first: Any, tmp_path: Path
) -> None:
    """Rough water hides much of the catalogue, but recordings that show what the model has do tell something."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    (tmp_path / "model.yaml").write_text(first.model_yaml, encoding="utf-8")
    model = load_platform(str(tmp_path / "model.yaml"))
    second = diagnose(replace(caught, platform=model), lambda words, share: None)
    assert (second.verdict, second.effects) == ("consistent", ())


def test_beside_found_effects_no_name_without_a_gain(
    caught: Any, first: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The platform's file itself has effects too, which nobody has found."""
    from cocorosim_ros.diagnosis.naming import naming
    from cocorosim_ros.scenario.parts.platform import load_platform

    asked: list[bool] = []
    monkeypatch.setattr(naming, "best_addition", lambda *given: asked.append(given[-1].must_gain))
    monkeypatch.setattr(naming, "_best_by_slopes", lambda *given: None)
    (tmp_path / "model.yaml").write_text(first.model_yaml, encoding="utf-8")
    for platform in (caught.platform, load_platform(str(tmp_path / "model.yaml"))):
        base = base_fit(replace(caught, platform=platform))
        assert naming.name_effects(base, lambda words, share: None, unseen_parts(base)).known
    assert asked == [False, True]


def test_a_comparison_names_nothing_that_free_runs_do_not_gain_by() -> None:
    """A small loss may be chance, and forbids no name; recordings of a sound vehicle differ by as much."""
    entry = next(each for each in ENTRIES if each.id == "thruster_asymmetry")
    candidate, likely_chance = Candidate(entry, ("boat",), ((0,),)), Gain(-0.1, 0.2, 8)
    of_diagnosis, of_comparison = (Choice(Any, Any, must_gain=each) for each in (False, True))
    assert not of_diagnosis.refuses(candidate, likely_chance)
    assert of_comparison.refuses(candidate, likely_chance)
    assert not of_comparison.refuses(candidate, likely_chance._replace(mean=0.1))
    assert not of_comparison.refuses(candidate, likely_chance._replace(mean=-1e-4))  # free runs do not feel it
    assert of_comparison.refuses(candidate, Gain(0.0, math.inf, 0))  # there are none
