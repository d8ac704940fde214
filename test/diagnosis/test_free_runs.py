"""How long a free run lasts."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.showing.free_runs import window_length
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.world.state.state import YAW_RATE


@pytest.mark.parametrize(
    ("rates", "seconds"), [([0.0], 20.0), ([1.48], 20.0), ([2.0, 4.0], 5.0), ([-14.0], 2.0), ([99.0], 2.0)]
)
def test_who_turns_fast_is_not_foretold_for_long(rates: list[float], seconds: float) -> None:
    """By no more than thirty radians: a Lily at full turn for twenty seconds, a hovercraft for two."""
    courses = []
    for rate in rates:
        mean = np.zeros((50, 12))
        mean[:, YAW_RATE] = rate
        courses.append(Smoothed(0.1 * np.arange(50), mean, mean))
    assert window_length(courses) == seconds
