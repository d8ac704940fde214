"""The fraction of all settings: balanced, main effects clear of interactions of two, nothing of a response lost."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from cocorosim_ros.study.experiments.fraction import contrasts, folded_settings

some_factors = pytest.mark.parametrize("factors", [1, 2, 3, 7, 8, 16, 17])


@some_factors
def test_settings_begin_with_the_lower_levels_and_come_with_their_opposites(factors: int) -> None:
    """No setting stands twice; each has its opposite; the first changes nothing."""
    settings = folded_settings(factors)
    assert settings[0] == (False,) * factors
    assert len(set(settings)) == len(settings)
    assert {tuple(not level for level in setting) for setting in settings} == set(settings)


@some_factors
def test_main_effects_are_balanced_and_clear_of_two_factor_interactions(factors: int) -> None:
    """Resolution IV: a main effect's column is orthogonal to 1, to every other and to every product of two."""
    signs = np.where(folded_settings(factors), 1, -1)
    assert not signs.sum(axis=0).any()
    assert not (signs.T @ signs - np.eye(factors) * len(signs)).any()
    for one, other in combinations(range(factors), 2):
        assert not (signs.T @ (signs[:, one] * signs[:, other])).any()


@some_factors
def test_contrasts_give_back_an_additive_response(factors: int) -> None:
    """Effects 1, 2, 3, ... in the response are found as such; what is left is zero."""
    settings = np.array(folded_settings(factors), dtype=float)
    mains, left = contrasts(factors)
    response = 5.0 + settings @ np.arange(1.0, factors + 1)
    np.testing.assert_allclose(mains @ response, np.arange(1.0, factors + 1))
    np.testing.assert_allclose(left @ response, 0.0, atol=1e-12)


def test_contrasts_that_are_left_hold_the_interactions() -> None:
    """Of three factors in eight settings all is told: an interaction of two of size 3 is in one contrast alone."""
    signs = np.where(folded_settings(3), 1.0, -1.0)
    mains, left = contrasts(3)
    response = 1.5 * signs[:, 0] * signs[:, 2]
    np.testing.assert_allclose(mains @ response, 0.0, atol=1e-12)
    assert sorted(np.abs(left @ response).round(12)) == [0.0, 0.0, 0.0, 3.0]
