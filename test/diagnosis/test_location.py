"""Where the evidence is at home."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.findings import Concentration
from cocorosim_ros.diagnosis.showing.location import _where
from cocorosim_ros.diagnosis.tracks.passes import Smoothed

TIME = 0.1 * np.arange(200)


@pytest.mark.parametrize(
    ("deep", "where"),
    [(0.0, None), (1.0, Concentration("deep", 1.0))],
    ids=["one depth alone", "two depths"],
)
def test_a_depth_is_told_where_there_are_two(deep: float, where: Concentration | None) -> None:
    """Evidence of the second half, in which one vehicle swims deeper and the other, on a floor, as deep as ever."""
    mean = np.zeros((200, 12))
    mean[100:, 2] = -deep
    gained = np.where(np.arange(200) < 100, 0.0, 1.0) if deep else np.ones(200)
    part: Any = SimpleNamespace(candidate=SimpleNamespace(everybody=(0,)))
    assert _where(part, TIME, gained, [Smoothed(TIME, mean, mean)]) == where
