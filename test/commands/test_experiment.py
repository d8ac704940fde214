"""`cocorosim experiment`: what its bar tells on the way."""

from __future__ import annotations

import pytest
from rich.console import Console


def test_the_time_left_is_known_between_long_chunks() -> None:
    """Chunks of a long design take more than half a minute each, those of two workers end almost together."""
    from cocorosim_ros.commands.experiment import new_bar

    now = 0.0
    bar, task = new_bar(Console(), "boids", 400, 0, lambda: now)
    for now in (50.0, 50.5, 101.0, 101.5):  # noqa: B007
        bar.advance(task, 45)
    left = bar.tasks[0].time_remaining
    assert left == pytest.approx(101.5 * (400 - 180) / 180, rel=0.02)


def test_the_time_left_of_the_first_chunks_is_no_guess_from_two_that_end_together() -> None:
    """Half a second between the first two says nothing of the rest."""
    from cocorosim_ros.commands.experiment import new_bar

    now = 0.0
    bar, task = new_bar(Console(), "boids", 400, 100, lambda: now)
    for now in (50.0, 50.5):  # noqa: B007
        bar.advance(task, 45)
    assert bar.tasks[0].time_remaining == pytest.approx(50.5 * (300 - 90) / 90, rel=0.02)
