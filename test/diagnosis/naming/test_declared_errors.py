"""Share of nats that errors of declared numbers may explain, against least squares of two regressors written out."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.naming import declared_errors
from cocorosim_ros.diagnosis.naming.declared_errors import share_of_declared_errors

READINGS, SPREAD = 4000, 0.5


def asked(
    monkeypatch: pytest.MonkeyPatch, mine: Any, its: Any, readings: Any, declared: float = 20.0
) -> tuple[float, float]:
    """Nats explained by errors of a declared number, and nats of the candidate alone.

    mine, its: what readings change by a unit of the candidate and of the declared number.
    """
    information = float(mine @ mine) / SPREAD**2
    q = float(mine @ readings) / SPREAD**2 / information
    left = readings - q * mine
    unknown = SimpleNamespace(owner=SimpleNamespace(parameter="fraction"))
    number = SimpleNamespace(value=lambda at: declared + at, slope=lambda at: 1.0)
    fit: Any = SimpleNamespace(
        unknowns=(unknown,),
        q=np.array([q]),
        passes=(SimpleNamespace(innovation=left, variance=np.full(READINGS, SPREAD**2)),),
    )
    candidate: Any = SimpleNamespace(
        entry=SimpleNamespace(amplitudes=(SimpleNamespace(name="fraction"),)), places_among=lambda unknowns: [0]
    )
    other: Any = SimpleNamespace(amplitudes=lambda: [number])
    known = SimpleNamespace(matrix=np.array([[information]]), score=np.zeros(1), slopes=(-mine[:, None],))
    monkeypatch.setattr(declared_errors, "information", lambda _: known)
    monkeypatch.setattr(declared_errors, "slopes", lambda *_: (-its[:, None],))
    own = 0.5 * q**2 * information
    return own * share_of_declared_errors(fit, candidate, other), own


def regressors(likeness: float) -> tuple[Any, Any, Any]:
    """Two regressors with this squared cosine, and noise."""
    rng = np.random.default_rng(4)
    basis, _ = np.linalg.qr(rng.standard_normal((READINGS, 2)))
    mine = 30.0 * basis[:, 0]
    its = 30.0 * (np.sqrt(likeness) * basis[:, 0] + np.sqrt(1.0 - likeness) * basis[:, 1])
    return mine, its, SPREAD * rng.standard_normal(READINGS)


def test_a_candidate_that_acts_otherwise_keeps_its_nats(monkeypatch: pytest.MonkeyPatch) -> None:
    """Regressors at right angles: an error of the one explains nothing of the other."""
    mine, its, noise = regressors(0.0)
    lost, own = asked(monkeypatch, mine, its, 0.3 * mine + noise)
    assert own > 100.0
    assert lost == pytest.approx(0.0, abs=1e-6 * own)


def test_a_candidate_that_is_only_an_error_of_the_declared_number_loses_nearly_all(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What readings show is the declared number's regressor: beside it the candidate is worth what noise is."""
    mine, its, noise = regressors(0.4)
    lost, own = asked(monkeypatch, mine, its, 0.3 * its + noise)
    assert own > 40.0
    assert own - lost < 4.0


def test_what_is_left_is_that_of_least_squares_of_both(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the tolerance is wide beside what readings tell: half the square of a coefficient over its variance."""
    mine, its, noise = regressors(0.4)
    readings = 0.3 * mine + noise
    lost, own = asked(monkeypatch, mine, its, readings, declared=1e5)
    both = np.column_stack([mine, its])
    coefficient = np.linalg.lstsq(both, readings, rcond=None)[0][0]
    variance = SPREAD**2 * np.linalg.inv(both.T @ both)[0, 0]
    assert own - lost == pytest.approx(0.5 * coefficient**2 / variance, rel=1e-6)


def test_a_number_that_is_known_nearly_exactly_explains_little(monkeypatch: pytest.MonkeyPatch) -> None:
    """A hundredth of what the readings would tell of it is its tolerance: it takes up hardly anything."""
    mine, its, noise = regressors(0.4)
    tolerance = 0.01 * SPREAD / 30.0
    lost, own = asked(monkeypatch, mine, its, 0.3 * its + noise, declared=tolerance / NAMING.declared_off)
    assert lost < 0.01 * own


def test_numbers_that_are_not_declared_explain_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """A number at its neutral value is not in the platform's file."""
    mine, its, noise = regressors(0.9)
    assert asked(monkeypatch, mine, its, 0.3 * its + noise, declared=0.0)[0] == 0.0
