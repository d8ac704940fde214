"""Main effects and Lenth's margin, by hand."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from cocorosim_ros.study.experiments.fraction import folded_settings
from cocorosim_ros.study.figure4.main_effects import lenth_margin, main_effects


def test_lenths_margin_leaves_out_what_is_large() -> None:
    """Of 1, -1, 1, -1 and 100: 1.5 is the first guess, 100 is beyond 2.5 times it, so 1.5 times the t of 5/3."""
    assert lenth_margin(np.array([1.0, -1.0, 1.0, -1.0, 100.0])) == pytest.approx(1.5 * stats.t.ppf(0.975, 5 / 3))
    assert lenth_margin(np.zeros(7)) == 0.0


def test_an_effect_that_is_there_is_beyond_and_noise_is_so_once_in_twenty() -> None:
    """A factor of 16 moves the response by 3, noise has a deviation of 0.3; 200 screenings."""
    settings = np.array(folded_settings(16), dtype=float)
    draw, false = np.random.default_rng(0), 0
    for _ in range(200):
        found = main_effects(3.0 * settings[:, 4] + draw.normal(0.0, 0.3, len(settings)), 16)
        assert found.effects[4] == pytest.approx(3.0, abs=0.5)
        assert found.beyond(4)
        false += sum(found.beyond(factor) for factor in range(16) if factor != 4)
    assert 0.02 < false / (200 * 15) < 0.08


def test_a_setting_without_a_response_does_not_spoil_the_others() -> None:
    """It counts as the mean."""
    responses = np.arange(8.0)
    responses[3] = np.nan
    found = main_effects(responses, 3)
    assert np.isfinite(found.effects).all()
