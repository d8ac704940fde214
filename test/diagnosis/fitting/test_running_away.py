"""Noise of a model that runs away from its recordings."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting import climbing
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.scenario.parts.platform import load_platform


def test_information_beyond_all_numbers_moves_no_noise(
    swim: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nor does NumPy warn, whose warnings are errors here: a step undamped would multiply infinity by zero."""
    fit = first_fit(swim(load_platform("lily"), 20.0))

    def boundless(fit: Any, chosen: Sequence[int]) -> tuple[Any, Any]:
        return np.zeros(len(chosen)), np.full((len(chosen), len(chosen)), np.inf)

    monkeypatch.setattr(climbing, "noise_information", boundless)
    assert climbing.with_noise(fit, 3) is fit
