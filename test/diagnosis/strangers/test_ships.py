"""Ships of others are found once: a ferry with two pods, and models of a small and of a large tanker."""

from __future__ import annotations

from pathlib import Path

from trial.recordings import NLP1, crossings, pond, zigzags

from .conftest import FoundOnce

COLLAPSED, OFF_RANGE = "worse than the platform as given does", "stands at the end of its range"
LEFT, AT_RANDOM = "leaves its readings by more than their noise", "errs not at random"


def test_two_minutes_of_a_ferry(data: Path, found_once: FoundOnce, tmp_path: Path) -> None:
    """Its fitted numbers turn it wrongly; what is named beside them is only suspected."""
    found_once("milliampere_ferry", crossings(data, tmp_path / "bags", *NLP1)[:1], (COLLAPSED,))


def test_zigzags_of_a_small_tanker_in_the_wind(data: Path, found_once: FoundOnce, tmp_path: Path) -> None:
    """The wind is suspected, which an anemometer felt that is not read; the found model has it."""
    first, _ = found_once("esso_osaka", pond(data, tmp_path / "bags", "zigzag")[0:6:2], (OFF_RANGE,))
    assert [each.id for each in first.effects] == ["wind"]


def test_zigzags_of_a_large_tanker(data: Path, found_once: FoundOnce, tmp_path: Path) -> None:
    """Its poses are exact to millimetres, and no course of the model follows them so well."""
    bags = [bag for bag in zigzags(data, tmp_path / "bags") if bag.name in ("Z_20_05", "Z_30_05")]
    found_once("kvlcc2_hsva", bags, (LEFT,))
