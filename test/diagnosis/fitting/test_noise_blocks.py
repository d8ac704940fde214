"""Two noises of different blocks in one pass: information and score as of one pass for each."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting import noise_information as by_passes
from cocorosim_ros.diagnosis.fitting.noise_blocks import LEVEL_NOISE, UPRIGHT_NOISE, in_passes
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.scenario.parts.platform import load_platform

ROUGH = 0.05  # of full thrust


def test_blocks_of_noises() -> None:
    """Of Lily's: those whose readings are all of one block; accelerometers are of both, and share a number."""
    assert {"random.heave_force", "reading.pressure", "reading.pose_z"} <= UPRIGHT_NOISE
    assert {"random.force", "random.moment", "reading.pose_xy", "reading.gyro_z", "reading.compass"} <= LEVEL_NOISE
    assert not UPRIGHT_NOISE & LEVEL_NOISE
    assert not {"reading.accel", "random.correlation", "random.smoothness", "random.with_speed"} & (
        UPRIGHT_NOISE | LEVEL_NOISE
    )


def test_every_noise_has_one_pass() -> None:
    """A level noise with an upright one, as long as there are both; the others alone."""
    columns = ["random.force", "random.heave_force", "random.moment", "random.correlation", "reading.pressure"]
    assert in_passes(columns) == [(0, 1), (2, 4), (3,)]
    assert in_passes(["random.heave_force", "reading.pressure"]) == [(0,), (1,)]
    assert in_passes([]) == []


def test_information_as_by_one_pass_for_each(swim: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """Differences are small beside the score's own spread, the square root of the information."""
    fit = base_fit(swim(load_platform("lily"), 120.0, 3, ROUGH))
    numbers = range(len(fit.noise))
    assert len(in_passes([unknown.column for unknown in fit.noise])) < len(numbers) - 2
    score, matrix = by_passes.noise_information(fit, numbers)
    monkeypatch.setattr(by_passes, "in_passes", lambda columns: [(place,) for place in range(len(columns))])
    score_alone, matrix_alone = by_passes.noise_information(fit, numbers)
    spread = np.sqrt(np.diag(matrix_alone))
    assert np.abs((score - score_alone) / spread).max() < 0.1
    assert np.abs((matrix - matrix_alone) / np.outer(spread, spread)).max() < 0.02
    assert np.abs(matrix - matrix_alone).max() > 0.0
