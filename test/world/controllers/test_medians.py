"""Medians of vectors against NumPy's."""

from __future__ import annotations

import numpy as np
import pytest


@pytest.mark.parametrize("count", [*range(1, 15), 64])
def test_coordinate_median_is_numpys(count: int) -> None:
    """Of random rows with equal numbers among them; the numbers of each coordinate are sorted on their own."""
    from cocorosim_ros.world.controllers.medians import LANES, coordinate_median

    rows = np.round(np.random.default_rng(count).normal(size=(count, LANES)), 1)
    median = np.full(3, np.nan)
    coordinate_median(rows, count, median)
    assert median.tolist() == np.median(rows[:, :3], axis=0).tolist()


def test_the_median_of_nothing_changes_nothing() -> None:
    """Without a row the result stays."""
    from cocorosim_ros.world.controllers.medians import LANES, coordinate_median

    median = np.array([1.0, 2.0, 3.0])
    coordinate_median(np.zeros((1, LANES)), 0, median)
    assert median.tolist() == [1.0, 2.0, 3.0]


def test_velocities_alone_count() -> None:
    """Of five messages two are no velocities: the median is that of the other three."""
    from cocorosim_ros.world.controllers.boids_rules import median_heard_velocity
    from cocorosim_ros.world.state.radio import MESSAGE_SIZE

    messages = np.zeros((5, MESSAGE_SIZE))
    messages[:, 0] = [3.0, 2.0, 3.0, 3.0, 3.0]
    messages[:, 1:4] = [[3, 0, 9], [50, 50, 50], [1, 5, 7], [np.nan, 60, 60], [2, 4, 8]]
    velocity = np.zeros(3)
    assert median_heard_velocity(messages, 5, velocity) == 3
    assert velocity.tolist() == [2.0, 4.0, 8.0]
