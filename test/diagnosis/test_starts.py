"""Where the fit of a candidate begins."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.starts import best_start

LATENCY = next(entry for entry in ENTRIES if entry.id == "sensor_latency" and entry.topic == "imu")
DRAG = next(entry for entry in ENTRIES if entry.id == "linear_drag")


def rough(summit: float) -> Any:
    """A hill with small hills on it: at 0 the slope leads to the next of them, and no further."""

    def at(q: np.ndarray) -> Any:
        return SimpleNamespace(
            q=q, objective=float(-np.sum((q - summit) ** 2) + 0.005 * np.sum(np.cos(40.0 * math.pi * q)))
        )

    return at


@pytest.mark.parametrize("summit", [0.3, 1.2, 1.97, 3.6])
def test_a_delay_of_many_steps_is_found_where_the_slope_leads_nowhere(summit: float) -> None:
    """For one robot and for three, which begin at the same delay."""
    for robots in (1, 3):
        candidate = Candidate(LATENCY, tuple("abc"[:robots]), tuple((number,) for number in range(robots)))
        found: Any = best_start(rough(summit), np.full(robots, 0.05), candidate)
        assert found.q == pytest.approx(np.full(robots, summit), abs=0.1)


def test_what_the_slope_promises_is_kept_where_it_is_best() -> None:
    """The search only adds to it; and it is gone towards with caution if the whole of it is too much."""
    candidate = Candidate(LATENCY, ("a",), ((0,),))
    assert best_start(rough(0.4), np.array([0.4]), candidate).q == pytest.approx([0.4])
    steep = Candidate(DRAG, ("a",), ((0,),))
    promised = np.array([1.0, 0.0, 0.0, 0.0])
    assert best_start(lambda q: SimpleNamespace(q=q, objective=-abs(q[0] - 0.3)), promised, steep).q[0] == 0.3


def test_nothing_is_searched_for_amplitudes_that_the_base_model_has() -> None:
    """Their shapes and numbers are known, and slopes start from there."""
    calls = []

    def at(q: np.ndarray) -> Any:
        calls.append(q)
        return SimpleNamespace(q=q, objective=0.0)

    best_start(at, np.array([0.1]), Candidate(LATENCY, ("a",), ((0,),), known=((0.2,),)))
    assert len(calls) == 2


@pytest.mark.parametrize("entry", [entry for entry in ENTRIES if any(part.searched for part in entry.amplitudes)],
                         ids=lambda entry: f"{entry.id}-{entry.topic}")  # fmt: skip
def test_values_that_are_searched_ascend_from_nothing(entry: Any) -> None:
    """Halving the way to the value before them needs that; and one number is all that a search moves."""
    (part,) = entry.amplitudes
    assert list(part.searched) == sorted(part.searched)
    assert part.searched[0] > 0.0
