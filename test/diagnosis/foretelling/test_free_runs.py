"""Free runs on made recordings: what a bent course gains, one floor for right and wrong models, one start for all."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.foretelling.free_runs import held_out_free_runs
from cocorosim_ros.diagnosis.foretelling.nameless_force import foretold, turn_back
from cocorosim_ros.diagnosis.foretelling.regimes import QUANTITIES, regimes_along
from cocorosim_ros.diagnosis.foretelling.unseen import unseen_parts
from cocorosim_ros.diagnosis.showing.regimes import unlike_regimes
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
from cocorosim_ros.world.laws.readings import READING_CODE
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE

Swim = Callable[..., Any]


@pytest.fixture(scope="module")
def without_camera(swim: Swim) -> Fit:
    """The recalibrated model of a Lily whose depth the pressure alone shows."""
    evidence = swim(load_platform("lily"), 120.0, seed=3)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    streams = {name: stream for name, stream in log.streams.items() if name != "pose"}
    recording = replace(recording, robots=(replace(log, streams=streams),))
    return base_fit(replace(evidence, recordings=(recording,)))


def with_pressure_law(base: Fit) -> Fit:
    """The same model with a law by which the pressure errs by -9000 Pa per metre of its own depth."""
    rows = base.rows.copy()
    numbers = {"coefficient": -9000.0, "reading": READING_CODE["pressure"], "regressor_1": REGRESSOR_CODE["z"]}
    for name, value in numbers.items():
        rows[:, COLUMN[f"sensor_law_1.{name}"]] = value
    return evaluated(replace(base, rows=rows))


def test_a_law_that_explains_depth_away_gains_nothing(without_camera: Fit) -> None:
    """It leaves a twelfth of the depth to the model's own course; against readings it errs as much or more."""
    bent = with_pressure_law(without_camera)
    (track,) = bent.tracks
    plain, own = (track.filter.smoothed(fit.filled[0]).mean[:, Z] for fit in (without_camera, bent))
    assert np.ptp(own) < 0.25 * np.ptp(plain)
    table, *_ = held_out_free_runs(unseen_parts(without_camera), bent)
    assert table["depth"].against == "readings" and "pressure" not in table
    assert table["depth"].augmented > 0.98 * table["depth"].recalibrated


def test_what_is_not_seen_has_no_row_or_says_that_it_is_a_course(without_camera: Fit) -> None:
    """Without poses there is no position; the heading is the compass's, in the table and in the pictures."""
    table, runs, _ = held_out_free_runs(unseen_parts(without_camera), without_camera)
    assert set(table) == {"heading", "depth", "imu"}
    assert table["heading"].against == "readings" and table["imu"].against == "course"
    for run in runs:
        assert np.isnan(run.measured[:, :2]).all()
        assert np.isfinite(run.measured[:, 3]).any()


def test_a_right_and_a_wrong_model_have_the_same_floor(swim: Swim) -> None:
    """Linear drag that the wrong model lacks: it errs by twice the floor and more, the right one by the floor.

    The learnt force is not exact, hence three parts in ten between the floors; they are 13.7 and 14.4 mm.
    """
    plain = load_platform("lily")
    drag = Quantity(0.04, "N s/m", dimension_of("N s/m"))
    truth = replace(plain, effect_quantities={"linear_drag": {"surge": drag, "sway": drag}})
    rows = []
    for platform in (truth, plain):
        base = base_fit(swim(truth, 300.0, seed=7, disturbance=0.01, base=platform))
        unseen = unseen_parts(base)
        assert unseen.seconds == 20.0
        rows.append(held_out_free_runs(unseen, base).table["position"])
    right, wrong = rows
    assert right.recalibrated < 1.2 * right.noise_floor
    assert wrong.recalibrated > 2.0 * wrong.noise_floor
    assert right.noise_floor / 1.3 < wrong.noise_floor < 1.3 * right.noise_floor


def test_the_floor_knows_nothing_of_the_augmented_model(without_camera: Fit) -> None:
    """Whatever model is judged, the floors and the other models' errors are the same numbers."""
    unseen = unseen_parts(without_camera)
    plain, *_ = held_out_free_runs(unseen, without_camera)
    bent, *_ = held_out_free_runs(unseen, with_pressure_law(without_camera))
    for channel in ("heading", "depth"):
        assert plain[channel].noise_floor == bent[channel].noise_floor
        assert plain[channel].recalibrated == bent[channel].recalibrated


def test_a_start_takes_no_later_readings(without_camera: Fit) -> None:
    """Readings that are changed from a moment on leave the filter's states before it as they were."""
    (track,) = without_camera.tracks
    row = without_camera.filled[0]
    changed = track.piece(0, 600)
    before = changed.filter.filtered(row)
    np.testing.assert_allclose(before, track.filter.filtered(row)[:600], rtol=0.0, atol=1e-12)


def test_a_few_terms_are_learnt_and_noise_is_not() -> None:
    """2 a - b of fifty terms, to a few parts in a hundred; where there is only noise, nothing or nearly nothing."""
    rng = np.random.default_rng(4)
    terms = rng.standard_normal((2000, 50))
    noise = 0.2 * rng.standard_normal(2000)
    law = 2.0 * terms[:, 3] - terms[:, 40]
    assert np.std(foretold(terms, law + noise) - law) < 0.05
    assert np.std(foretold(terms, noise)) < 0.02


def test_a_term_that_stands_in_one_part_alone_teaches_nothing() -> None:
    """Without that part nothing but rounding is left of it, which is no reason to take it, and no division by zero."""
    rng = np.random.default_rng(3)
    wanted = rng.standard_normal(400)
    terms = 1e-9 * rng.standard_normal((400, 20))
    terms[:20, 1:] += 1e6 * rng.standard_normal(20)[:, None]
    terms[:, 0] = wanted
    assert foretold(terms, wanted) == pytest.approx(wanted, abs=1e-6)
    assert foretold(np.zeros((400, 5)), wanted) == pytest.approx(np.zeros(400))


def test_forces_are_turned_and_turned_back() -> None:
    """One newton to the north is one ahead for who looks north."""
    force = np.array([[0.0, 1.0, 2.0, 3.0]])
    turned = turn_back(force, np.array([0.5 * np.pi]))
    assert turned == pytest.approx(np.array([[1.0, 0.0, 2.0, 3.0]]), abs=1e-12)
    assert turn_back(turned, np.array([-0.5 * np.pi])) == pytest.approx(force, abs=1e-12)


def test_parts_of_another_regime_are_said(without_camera: Fit) -> None:
    """Held-out blocks like all others say nothing; when the whole depth there is another, that is said with numbers."""
    unseen = unseen_parts(without_camera)
    (course,), (split,) = unseen.courses, unseen.splits
    alike = replace(course, mean=np.zeros_like(course.mean))
    thrust = f"median {QUANTITIES[2].name}"
    assert all(thrust in remark for remark in unlike_regimes(replace(unseen, courses=(alike,))).values())
    deep = np.zeros_like(course.mean)
    for span in split.held:
        deep[span.first : span.end, Z] = -2.0
    (said,) = (
        remark
        for name, remark in unlike_regimes(replace(unseen, courses=(replace(course, mean=deep),))).items()
        if name == "depth"
    )
    assert "median depth is 2.00 m" in said and "between 0 m and 0 m" in said


def test_thrust_is_that_of_thrusters(without_camera: Fit) -> None:
    """Both of a Lily's at full command are told as 5 mN times the root of two, and her pump, of 98 mN, not at all."""
    (track,) = without_camera.tracks
    along = regimes_along(track, track.filter.smoothed(without_camera.filled[0]))
    thrust = along[:, [quantity.name for quantity in QUANTITIES].index("thrust")]
    assert 0.0 < thrust.max() <= 5e-3 * np.sqrt(2.0) * (1.0 + 1e-9)
