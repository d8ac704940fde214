"""Steps between two ticks: how many, and where robots are at each."""

from __future__ import annotations

import math

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.between_ticks import between, steps_of_tick
from cocorosim_ros.world.state.state import YAW, X, Z, row_size


@pytest.mark.parametrize(
    ("smooth", "tick", "steps"), [(0.0, 0.5, 1), (20.0, 0.5, 10), (3.0, 0.5, 2), (30.0, 0.1, 3), (50.0, 0.25, 13)]
)
def test_steps_come_at_least_as_often_as_asked_for(smooth: float, tick: float, steps: int) -> None:
    """The least whole number of steps to a tick that is not slower."""
    assert steps_of_tick(smooth, 1.0, tick) == steps


@pytest.mark.parametrize(
    ("smooth", "rate", "words"),
    [(20.0, 0.0, r"in lock-step.*give a rate"), (2.0, 1.0, r"ticks of 0.5 s come 2 times a second already")],
)
def test_what_would_show_nothing_is_a_sentence(smooth: float, rate: float, words: str) -> None:
    """Lock-step has no time between ticks, and as many steps as ticks are no steps."""
    with pytest.raises(CocorosimError, match=words):
        steps_of_tick(smooth, rate, 0.5)


def test_places_are_on_the_straight_way_and_turns_on_the_shorter() -> None:
    """A quarter of the way from (0, 0, -1) to (1, 2, -3), and of the turn from 170 to -170 degrees, which is 20."""
    before, after = np.zeros((1, row_size(3))), np.full((1, row_size(3)), 7.0)
    before[0, X : Z + 1], after[0, X : Z + 1] = (0.0, 0.0, -1.0), (1.0, 2.0, -3.0)
    before[0, YAW], after[0, YAW] = math.radians(170.0), math.radians(-170.0)
    found = between(before, after, 0.25)
    assert found[0, X : Z + 1].tolist() == [0.25, 0.5, -1.5]
    assert found[0, YAW] == pytest.approx(math.radians(175.0), abs=1e-12)
    assert not np.delete(found[0], [X, X + 1, Z, YAW]).any(), "speeds and the rest are not guessed"
    assert before[0, Z] == -1.0, "what was given stays"
