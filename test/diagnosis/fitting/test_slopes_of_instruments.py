"""Information on errors of instruments by which a reading depends otherwise on the state, against the likelihood."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.fit import slopes
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.scenario.parts.platform import load_platform

BLUR = 0.1  # of the usual noise, as in a capture hall: the filter then follows each reading
ROUGH = 0.3  # of full thrust


@pytest.mark.parametrize(
    ("column", "neutral", "step"),
    [("camera_scale.scale", 1.0, 2e-3), ("pose_lever.ahead", 0.0, 1e-4)],
)
def test_information_is_the_curvature_of_the_likelihood(
    swim: Callable[..., Any], column: str, neutral: float, step: float
) -> None:
    """By second differences, of poses alone in rough water; with gains held a camera's scale had 2.3 times as much."""
    evidence = swim(load_platform("lily"), 120.0, 3, ROUGH, blur=BLUR)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    poses = replace(recording, robots=(replace(log, streams={"pose": log.streams["pose"]}),))
    fit = base_fit(replace(evidence, recordings=(poses,)))
    effect, _, number = column.partition(".")
    unknown = Unknown(Owner(effect, ("lily_01",), number, "1"), column, (0,), base=neutral, step=step)
    (slope,) = slopes(fit, (unknown,), np.zeros(1))
    information = float(np.sum(slope[:, 0] ** 2 / fit.passes[0].variance))

    def likelihood(change: float) -> float:
        row = fit.filled[0].copy()
        row[COLUMN[column]] = neutral + change
        return float(fit.tracks[0].filter.full(row).log_likelihood)

    curvature = (2.0 * likelihood(0.0) - likelihood(step) - likelihood(-step)) / step**2
    assert information == pytest.approx(curvature, rel=0.12)
