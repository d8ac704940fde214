"""Halves of other people's recordings, compared with each other: the vehicle is the same, so nothing is named."""

from __future__ import annotations

from pathlib import Path

import pytest

DATA = Path(__file__).resolve().parents[4] / "shared" / "data"
DAY = "2019-04-16"


@pytest.mark.skipif(not DATA.is_dir(), reason="the recordings of others are not on this machine")
def test_halves_of_a_hovercrafts_day_are_alike(tmp_path: Path) -> None:
    """25 nats spoke for a thruster that pushes 8 % more in one half, and free runs with it erred by a half more."""
    from cocorosim_ros.diagnosis.diagnose_against import diagnose_against
    from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.config_files import find_config
    from cocorosim_ros.wire.conversion.conversion import convert
    from cocorosim_ros.wire.conversion.map_file import load_map

    made = convert(load_map(find_config("maps", "hovercraft_epfl")), DATA / "hovercraft_epfl", tmp_path / "bags")
    runs = sorted(each.folder for each in made if DAY in each.folder.name)
    good, bad = (gather_evidence(runs[half:6:2], load_platform("hovercraft_epfl")) for half in (0, 1))
    found = diagnose_against(bad, good, lambda words, share: None)
    assert (found.effects, found.recalibrated) == ((), ())
