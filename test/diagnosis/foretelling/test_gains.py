"""Gains of free runs: their unit, their sureness, and models that have not seen what is held out."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUN_GAINS
from cocorosim_ros.diagnosis.fitting.candidate import expand
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance, information
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.screening import Screen
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.foretelling import gains
from cocorosim_ros.diagnosis.foretelling.gains import FreeRuns, Gain, gain, rows_without_held_out
from cocorosim_ros.diagnosis.foretelling.unseen import unseen_parts
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of

TORQUE = 1e-5  # N m


@pytest.fixture(scope="module")
def swum(swim: Any) -> Fit:
    """The recalibrated model, without the torque, of a Lily that something turns with TORQUE."""
    plain = load_platform("lily")
    truth = replace(plain, effect_quantities={"torque_bias": {"torque": Quantity(TORQUE, "N m", dimension_of("N m"))}})
    return base_fit(swim(truth, 150.0, seed=12, base=plain))


def squares(*errors: tuple[float, ...]) -> Any:
    """Mean squared errors (windows, channels) of these errors."""
    return np.array(errors) ** 2


def test_a_gain_is_the_logarithm_of_the_error() -> None:
    """Half of the error is log 2 far above the noise floor and nothing below it; channels and their units add up."""
    far = gain(squares((8.0,), (8.0,)), squares((4.0,), (4.0,)), np.array([1e-12]))
    assert far.mean == pytest.approx(math.log(2.0)) and far.spread == pytest.approx(0.0, abs=1e-12)
    near = gain(squares((0.02,), (0.02,)), squares((0.01,), (0.01,)), np.array([1.0]))
    assert abs(near.mean) < 2e-4
    both = gain(squares((8.0, 0.2)), squares((4.0, 0.4)), np.array([1e-12, 1e-12]))
    assert both.mean == pytest.approx(0.0, abs=1e-9)


def test_a_channel_without_readings_counts_for_nothing() -> None:
    """Neither in a window, nor where its noise floor is unknown; what has run away counts as much as is allowed."""
    one = gain(squares((2.0, math.nan)), squares((1.0, math.nan)), np.array([1e-12, 1.0]))
    assert one.mean == pytest.approx(math.log(2.0))
    away = gain(squares((1.0,), (1.0,)), squares((math.inf,), (math.nan,)), np.array([0.1]))
    assert away.mean == pytest.approx(-FREE_RUN_GAINS.most)


def test_how_sure_a_gain_is_follows_from_its_spread_over_windows() -> None:
    """Two windows that gain alike are clear; two of which one loses are not; a single window never is."""
    floor = np.array([1e-12])
    assert gain(squares((2.0,), (2.1,)), squares((1.0,), (1.0,)), floor).is_clear
    mixed = gain(squares((2.0,), (1.0,)), squares((1.0,), (1.5,)), floor)
    assert not mixed.is_clear and not mixed.is_loss
    alone = gain(squares((9.0,)), squares((1.0,)), floor)
    assert not alone.is_clear and not alone.is_likely and alone.mean > 2.0
    assert Gain(-0.1, 0.05, 8).is_loss and not Gain(-0.1, 0.2, 8).is_loss and not Gain(-0.01, 0.001, 8).is_loss


def test_the_right_model_gains_over_a_wrong_one_and_not_over_itself(swum: Fit) -> None:
    """Twice the thrust is foretold worse, clearly and in the unit of the noise floor; the same rows gain nothing."""
    runs = FreeRuns(unseen_parts(swum), swum.filled)
    assert runs.channels == ["position", "heading", "depth"]
    right = runs.errors(swum.filled)
    wrong = swum.filled.copy()
    wrong[:, COLUMN["thrust_gain"]] *= 2.0
    assert runs.gain(right, right)[:2] == (0.0, 0.0)
    assert runs.gain(runs.errors(wrong), right).is_clear
    assert runs.gain(right, runs.errors(wrong)).is_loss


def test_the_model_that_a_screening_promises_foretells_better(swum: Fit) -> None:
    """The torque that is hidden, by the linear step alone: nearly its size, and free runs clearly better."""
    (entry,) = (each for each in ENTRIES if each.id == "torque_bias")
    (candidate,) = expand([entry], swum.tracks, swum.rows)
    screen = Screen(swum, scene_of(swum.tracks, smoothed_tracks(swum)))
    rows = screen.stepped(screen.test(candidate))
    assert rows[0, COLUMN["torque_bias.torque"]] == pytest.approx(TORQUE, rel=0.2)
    runs = FreeRuns(unseen_parts(swum), swum.filled)
    assert runs.gain(runs.errors(swum.filled), runs.errors(rows)).is_clear


def test_one_step_forgets_what_is_held_out(swum: Fit) -> None:
    """It ends where a fit to the rest alone ends, within a fraction of how well the numbers are known at all."""
    unseen = unseen_parts(swum)
    whole, once, anew = (
        np.array([row[0, each] for each in _columns(swum)])
        for row in (swum.filled, rows_without_held_out(swum, unseen.splits), unseen.rows)
    )
    known = np.sqrt(np.diag(covariance(swum))) * np.abs(
        [each.slope(float(q)) for each, q in zip(swum.unknowns, swum.q, strict=True)]
    )
    assert (np.abs(once - anew) < 0.5 * known).all()
    assert (np.abs(once - whole) > 0.05 * known).any()
    kept = rows_without_held_out(swum, unseen.splits, [each.column for each in swum.unknowns])
    np.testing.assert_array_equal(kept, swum.filled)


def test_a_model_that_runs_away_makes_no_step(swum: Fit, monkeypatch: pytest.MonkeyPatch) -> None:
    """Slopes whose squares no number holds: the numbers stay, and no warning comes of it."""
    known = information(swum)
    away = replace(known, slopes=tuple(1e200 * each for each in known.slopes))
    monkeypatch.setattr(gains, "information", lambda fit: away)
    np.testing.assert_array_equal(rows_without_held_out(swum, unseen_parts(swum).splits), swum.filled)


def _columns(fit: Fit) -> list[int]:
    return [COLUMN[each.column] for each in fit.unknowns]


def test_two_windows_do_not_tell_how_far_a_gain_is_chance() -> None:
    """Many windows that differ make a gain doubtful; two that do leave it likely, though never clear."""
    from cocorosim_ros.diagnosis.foretelling.gains import Gain

    assert not Gain(1.8, 6.7, 8).is_likely
    assert Gain(1.8, 6.7, 2).is_likely and not Gain(1.8, 6.7, 2).is_clear
    assert not Gain(-0.1, 6.7, 2).is_likely
