"""Information on errors of readings, against the curvature of the likelihood itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.fit import Fit, slopes
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.scenario.parts.platform import load_platform

BLUR = 0.1  # of the usual noise, as in a capture hall: the filter then follows each reading
ROUGH = 0.3  # of full thrust


class Compared(NamedTuple):
    """Information on a number by the slopes, and minus the second derivative of the log-likelihood."""

    information: float
    curvature: float


def compared(fit: Fit, column: str, neutral: float, step: float, over: float) -> Compared:
    """Compare both at the neutral value. step: of the slope; over: of the second difference."""
    effect, _, number = column.partition(".")
    unknown = Unknown(Owner(effect, ("lily_01",), number, "1"), column, (0,), base=neutral, step=step)
    (slope,) = slopes(fit, (unknown,), np.zeros(1))

    def likelihood(change: float) -> float:
        row = fit.filled[0].copy()
        row[COLUMN[column]] = neutral + change
        return float(fit.tracks[0].filter.full(row).log_likelihood)

    curvature = (2.0 * likelihood(0.0) - likelihood(over) - likelihood(-over)) / over**2
    return Compared(float(np.sum(slope[:, 0] ** 2 / fit.passes[0].variance)), curvature)


def test_of_a_latency(swim: Callable[..., Any]) -> None:
    """By second differences over a step of the grid; slopes over less than a step told 44 % more."""
    fit = base_fit(swim(load_platform("lily"), 120.0, 3, 0.05))
    found = compared(fit, "sensor_latency.pressure", 0.0, 0.015, fit.tracks[0].timeline.grid.step)
    assert found.information == pytest.approx(found.curvature, rel=0.1)


@pytest.mark.parametrize(
    ("column", "neutral", "step"),
    [("camera_scale.scale", 1.0, 2e-3), ("pose_lever.ahead", 0.0, 1e-4)],
)
def test_of_numbers_by_which_a_reading_depends_otherwise_on_the_state(
    swim: Callable[..., Any], column: str, neutral: float, step: float
) -> None:
    """Of poses alone in rough water; with gains held a camera's scale had 2.3 times as much."""
    evidence = swim(load_platform("lily"), 120.0, 3, ROUGH, blur=BLUR)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    poses = replace(recording, robots=(replace(log, streams={"pose": log.streams["pose"]}),))
    found = compared(base_fit(replace(evidence, recordings=(poses,))), column, neutral, step, step)
    assert found.information == pytest.approx(found.curvature, rel=0.12)
