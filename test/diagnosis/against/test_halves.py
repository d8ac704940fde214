"""A vehicle that changed halfway through its recordings is told by the numbers of their halves; a well one is not."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import boats
import numpy as np
import pytest
from scipy.stats import ttest_ind

from cocorosim_ros.diagnosis.against.comparable import in_parts
from cocorosim_ros.diagnosis.against.halves import changed_halfway, difference_of
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit

SECONDS = 120.0


@pytest.mark.parametrize("seed", [5, 6])
@pytest.mark.parametrize("share", [1.0, 0.5])
def test_a_propeller_damaged_halfway(tmp_path: Path, seed: int, share: float) -> None:
    """The left one, with half of its thrust from the middle on, is told first; an undamaged one is not at all."""
    boat = boats.platform(tmp_path, boats.KNOWN)

    def damaged(commands: Any) -> Any:
        shares = np.ones_like(commands)
        shares[len(commands) // 2 :, 0] = share
        return shares * commands

    drive = boats.recorded(boat, boats.Truth(), SECONDS, seed, damaged)
    found = changed_halfway(base_fit(in_parts(drive)))
    if share == 1.0:
        assert found == ()
    else:
        told = {each.name: each.factor for each in found}
        assert told["thrust of left"] == pytest.approx(share, rel=0.3)
        assert "thrust of right" not in told
        assert {each.robot for each in found} == {"boat"}


def test_parts_that_are_known_alike_are_compared_as_always() -> None:
    """Student's test of two samples, where the scatter is more than what the parts themselves are known to."""
    rng = np.random.default_rng(1)
    first, second = rng.normal(0.0, 0.1, 4), rng.normal(0.3, 0.1, 3)
    known = [np.full(len(each), 1e6) for each in (first, second)]
    found = difference_of(first, known[0], second, known[1])
    assert found.size == pytest.approx(second.mean() - first.mean())
    assert found.chance == pytest.approx(ttest_ind(first, second).pvalue)


def test_parts_that_agree_by_chance_are_known_no_better_than_each_is() -> None:
    """Two parts of 0 and two of 1, each known to 2: the difference is half a standard deviation."""
    found = difference_of(np.zeros(2), np.full(2, 0.25), np.ones(2), np.full(2, 0.25))
    t = 1.0 / math.sqrt(2.0 + 2.0)
    assert found.chance == pytest.approx(1.0 - t / math.sqrt(2.0 + t**2))  # Student's, with two degrees of freedom
