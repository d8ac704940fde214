"""Sorting by comparisons that are laid down: they sort everything, written out in compiled code, too."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from cocorosim_ros.foundation.compiling.sorting import comparisons, lines_that_sort, ordered


@pytest.mark.parametrize("count", range(1, 13))
def test_what_is_compared_sorts_everything(count: int) -> None:
    """Rows of zeros and ones in every order end up ascending, and so do then all rows (Knuth's theorem Z)."""
    for row in itertools.product((0, 1), repeat=count):
        found = list(row)
        for one, other in comparisons(count):
            found[one], found[other] = sorted((found[one], found[other]))
        assert found == sorted(row)


@pytest.mark.parametrize("count", [1, 2, 11, 28, 55, 100])
def test_lines_sort_what_they_are_given(count: int) -> None:
    """The text, run as it is, leaves random numbers with equal ones among them in ascending names."""
    rows = np.round(np.random.default_rng(count).normal(size=count), 1).tolist()
    names: dict[str, float] = {}
    exec("\n".join(lines_that_sort(count)), {"rows": rows, "ordered": ordered}, names)
    assert [names[f"row_{place}"] for place in range(count)] == sorted(rows)
