"""Sums of products over readings."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.filter.products import CHUNK, weighted_products


@pytest.mark.parametrize("count", [1, 7, CHUNK, 2 * CHUNK + 13])
@pytest.mark.parametrize("columns", [(1, 3), (3, 1), (2, 2)])
def test_they_are_those_of_matrices(count: int, columns: tuple[int, int]) -> None:
    """left^T diag(1 / variance) right, whichever is the wider."""
    rng = np.random.default_rng(count)
    left, right = rng.standard_normal((count, columns[0])), rng.standard_normal((count, columns[1]))
    variance = rng.uniform(0.5, 2.0, count)
    expected = left.T @ np.diag(1.0 / variance) @ right
    np.testing.assert_allclose(weighted_products(left, right, variance), expected, rtol=1e-12, atol=1e-12)


def test_those_of_one_array_with_itself_are_symmetric() -> None:
    """To the bit, and the same as of two arrays."""
    rng = np.random.default_rng(5)
    left, variance = rng.standard_normal((CHUNK + 9, 4)), rng.uniform(0.5, 2.0, CHUNK + 9)
    found = weighted_products(left, left, variance)
    assert (found == found.T).all()
    np.testing.assert_allclose(found, weighted_products(left, left.copy(), variance), rtol=1e-12, atol=1e-12)
