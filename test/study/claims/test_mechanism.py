"""S22: both offsets to the shoal's centre, against vectors done by hand."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.study.claims.mechanism import (
    PerceivedCentre,
    exact_length,
    mechanism_answer,
    perceived_length,
    run_by_run,
)
from cocorosim_ros.world.state.state import YAW


def test_the_exact_offset() -> None:
    """Two of three others are within 0.5 m: the median of (0.3, 0, 0) and (0.1, 0.2, 0) is (0.2, 0.1, 0)."""
    state = np.zeros((1, 4, 11))
    state[0, :, :3] = [[0, 0, -1], [0.3, 0, -1], [0.1, 0.2, -1], [2.0, 0, -1]]
    length = exact_length(state)
    assert length[0, 0] == pytest.approx(math.hypot(0.2, 0.1))
    assert math.isnan(length[0, 3])


def test_the_median_is_taken_in_the_body() -> None:
    """Turned by 45 deg, the three offsets (1, 0), (0, 1), (0.7, 0.7) tenths have another coordinate-wise median."""
    state = np.zeros((1, 4, 11))
    state[0, :, :2] = [[0, 0], [0.1, 0], [0, 0.1], [0.07, 0.07]]
    state[0, 0, YAW] = 0.25 * math.pi
    # Along the bow 0.0707, 0.0707, 0.0990; to the left -0.0707, 0.0707, 0.
    assert exact_length(state)[0, 0] == pytest.approx(0.1 * math.sqrt(0.5))


def test_the_perceived_offset() -> None:
    """0.4 m ahead and 0.3 m to the left are 0.5 m away; 0.48 m is beyond trust, nothing is 0."""
    axes = np.array([[[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]] * 2)
    simulation = SimpleNamespace(world=SimpleNamespace(crew=SimpleNamespace(sensor_axis=axes)))
    ranges = np.array([[[0.4, 0.3, 0.48], [np.inf, np.inf, np.inf]]])
    np.testing.assert_allclose(perceived_length(simulation, ranges, 0.475), [[0.5, 0.0]])  # type: ignore[arg-type]


def test_offsets_are_summed_up_run_by_run() -> None:
    """Moments without a neighbour (NaN, or 0 perceived) are left out, and so is a run that has no others."""
    exact = np.array([[1.0, 3.0, math.nan], [2.0, 2.0, 4.0], [math.nan, 1.0, 1.0]])
    perceived = np.array([[2.0, 2.0, 5.0], [1.0, 0.0, 3.0], [1.0, 0.0, 0.0]])
    found = run_by_run(exact, perceived)
    assert (found.exact.tolist(), found.perceived.tolist(), found.nearer.tolist()) == ([2, 3], [2, 2], [0.5, 1.0])


@pytest.mark.parametrize(
    ("nearer_by", "runs", "verdict"),
    [
        ((0.02, 0.04), 20, "reproduced"),
        ((-0.04, -0.02), 20, "not reproduced"),
        ((-0.05, 0.06), 20, "not decidable"),  # nearer on average, but as often not
        ((0.02, 0.04), 5, "not decidable"),
        ((0.02, 0.04), 0, "no runs"),
    ],
)
def test_the_verdict_follows_from_the_spread_of_runs(nearer_by: tuple[float, float], runs: int, verdict: str) -> None:
    """Runs that agree decide; runs that do not, or too few of them, leave it open."""
    gap = np.resize(nearer_by, runs).astype(float)
    found = PerceivedCentre(np.full(runs, 0.16), 0.16 - gap, 0.5 + gap)
    answer = mechanism_answer(found, "paper")
    assert answer.verdict == verdict
    assert runs == 0 or f"nearer by {gap.mean():.3f} m (" in answer.ours
