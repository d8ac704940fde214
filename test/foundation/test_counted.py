"""Counts in sentences."""

from __future__ import annotations

from cocorosim_ros.foundation.counted import counted, either


def test_one_and_many() -> None:
    """One alone is in the singular."""
    assert [counted(number, "row") for number in (0, 1, 2)] == ["0 rows", "1 row", "2 rows"]
    assert [either(number, "was", "were") for number in (0, 1, 2)] == ["were", "was", "were"]
