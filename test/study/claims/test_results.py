"""Results: with which group each is compared."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

GROUPS = ("T0", "T5e-4", "T0, no wakes", "T5e-4, no wakes", "T5e-4, lever")


@pytest.mark.parametrize(
    ("group", "against", "a"),
    [
        ("T5e-4", "T0", 1.0),
        ("T5e-4, no wakes", "T0, no wakes", 0.0),
        ("T5e-4, lever", "T0", 1.0),  # there is no "T0, lever"
        ("T0, no wakes", "T0", 1.0),  # what the choice does to the baseline itself
        ("T0", "T0", 0.5),
    ],
)
def test_a_group_under_a_choice(made_up: Callable[..., Any], group: str, against: str, a: float) -> None:
    """The baseline under the same choice, where there is one."""
    numbers = {(name, "lost"): number for name, number in zip(GROUPS, (0.0, 1.0, 3.0, 2.0, 1.0), strict=True)}
    results = made_up("turbulence_choices", GROUPS, numbers)
    assert results.baseline_of(group) == against
    assert results.effect("paper", group, "lost").value == a


def test_a_group_that_is_not_there(made_up: Callable[..., Any]) -> None:
    """It has no values."""
    assert made_up("boids", ("Van",), {}).values("paper", "BLT", "lost").size == 0
