"""Medians of four runs at once against numpy."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from cocorosim_ros.foundation.compiling.four import LANES, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.four_runs import flags, four_of, numbers, put
from cocorosim_ros.study.metrics.median_of_four import middles, no_filling, put_or_leave_out
from cocorosim_ros.study.metrics.swarms import MOST_AT_ONCE

Floats = NDArray[np.float64]


@kernel
def medians(
    values: Floats, counts: NDArray[np.bool_], runs: NDArray[np.int64], rows: Floats, scratch: Floats, found: Floats
) -> None:
    """The medians of those values (runs, n) that count are in found (runs, 1)."""
    for first in range(0, len(runs), LANES):
        four_runs = four_of(runs, first, len(runs))
        fours, filling = in_fours(rows), no_filling()
        for place in range(values.shape[1]):
            inside = flags(counts, four_runs, place) > 0.0
            filling = put_or_leave_out(fours, place, numbers(values, four_runs, place), inside, filling)
        lower, upper = middles(rows, values.shape[1], filling, four_runs, scratch)
        put(found, four_runs, 0, 0.5 * (lower + upper))


@pytest.mark.parametrize("count", [0, 1, 2, 3, 10, 11, 12, 27, 28, 29, 54, 55, 56, 90])
@pytest.mark.parametrize("runs", [1, 3, 4, 6])
def test_medians_are_numpys(count: int, runs: int) -> None:
    """Of random numbers with equal ones among them, of which each run leaves out some: none, a few, nearly all, all."""
    generator = np.random.default_rng([count, runs])
    for share in (0.0, 0.1, 0.5, 0.95, 1.0):
        values = np.round(generator.normal(size=(runs, count)), 1)
        counts = generator.random((runs, count)) >= share
        rows, found = np.full((max(count, MOST_AT_ONCE), LANES), np.nan), np.zeros((runs, 1))
        medians(np.where(counts, values, np.nan), counts, np.arange(runs), rows, np.zeros(count + 1), found)
        expected = [
            np.median(row[inside]) if inside.any() else np.nan for row, inside in zip(values, counts, strict=True)
        ]
        np.testing.assert_array_equal(found[:, 0], expected)
