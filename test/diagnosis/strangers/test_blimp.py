"""Flights of a blimp with wings, each at a constant thrust, are explained once."""

from __future__ import annotations

from pathlib import Path

from trial.recordings import flights

from .conftest import FoundOnce

STOPS = ("stands at the end of its range", "errs not at random", "times as much as with a force without a name")


def test_four_flights_of_a_blimp(data: Path, found_once: FoundOnce, tmp_path: Path) -> None:
    """Its wings have a law that the catalogue lacks: nothing more is named, and that something is missing stays said.

    Half of all flights are `consistent` with their found model: docs/real.md.
    """
    first, second = found_once("rgblimp", flights(data, tmp_path / "bags")[0:8:2], STOPS, "mismatch")
    assert first.beyond_floor == second.beyond_floor == ("position",)
