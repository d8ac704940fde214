"""What the likelihood says of each noise: passes beside a known one, against full passes of the filter."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.fitting import noise_information as information
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.unknowns import nudged
from cocorosim_ros.diagnosis.tracks.agitation import Agitation
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.scenario.parts.platform import load_platform

DOUBTED = 1e-2  # of the readings; more than STEPS.most_doubted


@pytest.fixture(scope="module")
def fit(swim: Callable[..., Any]) -> Fit:
    """The recalibrated model of a Lily, with noise that is not quite the most likely one."""
    found = base_fit(swim(load_platform("lily"), 120.0, 3))
    return evaluated(replace(found, q_noise=found.q_noise + 0.1))


def rows_of(fit: Fit) -> Any:
    """Rows with each noise a step off."""
    row = fit.filled[0]
    return np.array(
        [nudged(row, each, float(q), STEPS.noise_difference) for each, q in zip(fit.noise, fit.q_noise, strict=True)]
    )


def told_both_ways(fit: Fit, monkeypatch: pytest.MonkeyPatch) -> list[tuple[Any, Any]]:
    """Score and information beside the known pass, then by full passes."""
    found = []
    for most in (1.0, -1.0):
        monkeypatch.setattr(information, "STEPS", replace(STEPS, most_doubted=most))
        found.append(information.noise_information(fit, range(len(fit.noise))))
    return found


def test_the_known_noise_gives_the_known_pass(fit: Fit) -> None:
    """To rounding."""
    passed = fit.passes[0]
    innovation, variance = fit.tracks[0].filter.beside(fit.filled[0], fit.filled, passed)
    np.testing.assert_allclose(variance[0], passed.variance, rtol=1e-9)
    np.testing.assert_allclose(innovation[0], passed.innovation, atol=1e-9 * float(np.abs(passed.innovation).max()))


def test_score_and_information_are_those_of_full_passes(fit: Fit, monkeypatch: pytest.MonkeyPatch) -> None:
    """The score to a fifth of what it is uncertain by, the information to a few percent."""
    assert fit.passes[0].believed.all()
    (score, matrix), (full_score, full_matrix) = told_both_ways(fit, monkeypatch)
    uncertain = np.sqrt(np.diag(full_matrix))
    np.testing.assert_array_less(np.abs(score - full_score), 0.2 * uncertain)
    np.testing.assert_array_less(np.abs(matrix - full_matrix), 0.05 * np.outer(uncertain, uncertain))
    assert np.abs(score).max() > 5.0 * uncertain.min()  # there is something to be told


def test_the_score_is_the_slope_of_the_likelihood(fit: Fit) -> None:
    """By central differences of the likelihood itself, for each noise; the prior is flat beside it."""
    score, matrix = information.noise_information(fit, range(len(fit.noise)))
    step = 0.005
    for place, each in enumerate(fit.noise):
        ahead, back = (
            evaluated(replace(fit, q_noise=fit.q_noise + sign * step * (np.arange(len(fit.noise)) == place)))
            for sign in (1.0, -1.0)
        )
        slope = (ahead.objective - back.objective) / (2.0 * step)
        bias = 0.5 * STEPS.noise_difference * matrix[place, place]  # of a difference to one side
        assert score[place] == pytest.approx(slope, abs=0.2 * float(np.sqrt(matrix[place, place])) + bias), each.column


def test_the_order_of_the_rows_moves_no_bit(fit: Fit) -> None:
    """Rows share a vector with others, and each gets what it would get alone."""
    rows, passed, beside = rows_of(fit), fit.passes[0], fit.tracks[0].filter.beside
    together = beside(fit.filled[0], rows, passed)
    backwards = beside(fit.filled[0], rows[::-1].copy(), passed)
    alone = beside(fit.filled[0], rows[5:6], passed)
    for first, second, third in zip(together, backwards, alone, strict=True):
        np.testing.assert_array_equal(first, second[::-1])
        np.testing.assert_array_equal(first[5], third[0])


def test_errors_that_last_and_forces_that_grow(fit: Fit, monkeypatch: pytest.MonkeyPatch) -> None:
    """Their noise is told as full passes tell it, too."""
    track = fit.tracks[0]
    moments = track.timeline.grid.moments
    growth = np.column_stack([np.sin(moments) ** 2, np.zeros(len(moments))])
    agitated = replace(track, filter=track.filter.agitated(Agitation(moments, growth)))
    rows = fit.rows.copy()
    rows[0, COLUMN["memory.compass"]] = np.log(0.4)
    rows[0, COLUMN["random.with_speed"]] = np.log(2.0)
    memory, speed = (
        replace(fit.noise[0], column=column, base=float(rows[0, COLUMN[column]]), logarithmic=False, scale=1.0)
        for column in ("memory.compass", "random.with_speed")
    )
    noise = (*fit.noise, memory, speed)
    lasting = evaluated(
        replace(fit, tracks=(agitated,), rows=rows, noise=noise, q_noise=np.append(fit.q_noise, [0.0, 0.0]))
    )
    (score, matrix), (full_score, full_matrix) = told_both_ways(lasting, monkeypatch)
    uncertain = np.sqrt(np.diag(full_matrix))
    assert np.isfinite(uncertain).all() and (uncertain[-2:] > 1.0).all()
    np.testing.assert_array_less(np.abs(score - full_score), 0.2 * uncertain)
    np.testing.assert_array_less(np.abs(matrix - full_matrix), 0.05 * np.outer(uncertain, uncertain))


def test_a_track_with_doubted_readings_is_run_through(fit: Fit, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the model loses what it is shown, first order is not enough."""
    asked: list[int] = []
    track, passed = fit.tracks[0], fit.passes[0]
    full = track.filter.full
    monkeypatch.setattr(track.filter, "full", lambda row, with_gains=True: asked.append(1) or full(row, with_gains))
    information.noise_information(fit, range(2))
    assert not asked
    believed = np.arange(len(passed.believed)) >= DOUBTED * len(passed.believed)
    information.noise_information(replace(fit, passes=(replace(passed, believed=believed),)), range(2))
    assert len(asked) == 2
