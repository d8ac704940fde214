"""A hovercraft and two AUVs of others, whose numbers lie far from those of their files, are found once.

The hovercraft's drives of 2019-04-11 are no case: late commands and late poses explain them as well, so that rounding,
which differs from one processor to the next, decides which is named, and what is found once more.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from trial.recordings import dives, hovercraft, minutes_in_the_pool

from .conftest import FoundOnce

LEFT, AT_RANDOM = "leaves its readings by more than their noise", "errs not at random"
OFF_RANGE, FILLED_IN = "stands at the end of its range", "were interpolated or repeated"


@pytest.mark.parametrize(("half", "stops"), [(0, (LEFT,)), (1, ())])
def test_every_second_drive_of_a_hovercraft(
    data: Path, found_once: FoundOnce, tmp_path: Path, half: int, stops: tuple[str, ...]
) -> None:
    """In one half the course leaves its readings; in the other nothing speaks against a centre of mass."""
    drives = [bag for bag in hovercraft(data, tmp_path / "bags") if "2019-04-16" in bag.name][half::2]
    found_once("hovercraft_epfl", drives, stops)


def test_dives_of_a_small_auv(data: Path, found_once: FoundOnce, tmp_path: Path) -> None:
    """Its thrust gain stands at the end of its range: a law of its gauge had been confirmed all the same."""
    found_once("haizhe_auv", dives(data, tmp_path / "bags", "reference")[0:16:2], (OFF_RANGE,))


def test_a_minute_of_an_auv_with_eight_thrusters(data: Path, found_once: FoundOnce, tmp_path: Path) -> None:
    """Its log was interpolated, so that noise was judged too small and everything was sure."""
    found_once("tauv_pool", minutes_in_the_pool(data, tmp_path / "bags")[1:2], (FILLED_IN, AT_RANDOM))
