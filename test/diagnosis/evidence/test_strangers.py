"""Recordings made by others, where they are on this machine: what is taken of them before any physics is fitted."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
from cocorosim_ros.diagnosis.evidence.intake import Intake, take_in
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

DATA = Path(__file__).resolve().parents[4] / "shared" / "data"

pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the recordings of others are not on this machine")


def taken(name: str, files: list[str], folder: Path) -> Intake:
    """The intake of some files of a data set, by the map and the platform of its name."""
    bags = []
    for file in files:
        convert(load_map(find_config("maps", name)), DATA / name / file, folder / file)
        bags.append(folder / file)
    return take_in(gather_evidence(bags, load_platform(name)))


def test_flights_of_constant_thrust_tell_enough_together(tmp_path: Path) -> None:
    """One alone is refused, as nothing varies in it; two of other thrusts are taken, in the axes that they have."""
    (reason,) = taken("rgblimp", ["data_021.csv"], tmp_path / "one").reasons
    assert "blimp has the same commands throughout (left 0.147, right 0.6615), so that" in reason
    both = taken("rgblimp", ["data_021.csv", "data_011.csv", "data_071.csv"], tmp_path / "all")
    assert (both.reasons, both.mixups) == ((), ())
    assert [len(recording.robots) for recording in both.evidence.recordings] == [1, 1, 1]


def test_a_spiral_is_no_quarter_turn(tmp_path: Path) -> None:
    """Flights whose poses were once turned by 90 degrees, because wings were not reckoned with."""
    files = [f"data_{number}.csv" for number in ("001", "022", "051", "062", "091")]
    assert taken("rgblimp", files, tmp_path).mixups == ()


def test_a_glider_lies_at_the_surface(tmp_path: Path) -> None:
    """Nine minutes between two dives, at half a metre by its gauge, with the pump out."""
    intake = taken("slocum_glider", ["glider_A.csv"], tmp_path)
    (robot,) = intake.evidence.recordings[0].robots
    ((begin, end),) = robot.afloat
    assert (begin, end) == (pytest.approx(652.0, abs=10.0), pytest.approx(1192.0, abs=15.0))
    assert sorted(robot.streams) == ["pressure"] and robot.attitude is not None
