"""Other people's recordings compared: halves of one vehicle are alike, an altered log and another vehicle are not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

DATA = Path(__file__).resolve().parents[4] / "shared" / "data"
pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the recordings of others are not on this machine")
DAY = "2019-04-16"
Runs = Callable[[str], list[Path]]


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> Runs:
    """Give the recordings of a folder of a data set, converted by the map of the set's name."""
    from cocorosim_ros.scenario.reading.config_files import find_config
    from cocorosim_ros.wire.conversion.conversion import convert
    from cocorosim_ros.wire.conversion.map_file import load_map

    made: dict[str, list[Path]] = {}

    def given(name: str) -> list[Path]:
        if name not in made:
            out = tmp_path_factory.mktemp("bags") / "made"
            found = convert(load_map(find_config("maps", name.partition("/")[0])), DATA / name, out)
            made[name] = sorted(each.folder for each in found)
        return made[name]

    return given


def evidence_of(bags: list[Path], platform: str) -> Any:
    """The evidence of recordings."""
    from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
    from cocorosim_ros.scenario.parts.platform import load_platform

    return gather_evidence(bags, load_platform(platform))


def compared(bad: Any, good: Any) -> Any:
    """The diagnosis of evidence against that of the vehicle when it was well."""
    from cocorosim_ros.diagnosis.diagnose_against import diagnose_against

    return diagnose_against(bad, good, lambda words, share: None)


def test_halves_of_a_hovercrafts_day_are_alike(runs: Runs) -> None:
    """25 nats spoke for a thruster that pushes 8 % more in one half, and free runs with it erred by a half more."""
    bags = [bag for bag in runs("hovercraft_epfl") if DAY in bag.name]
    good, bad = (evidence_of(bags[half:6:2], "hovercraft_epfl") for half in (0, 1))
    found = compared(bad, good)
    assert (found.effects, found.recalibrated) == ((), ())


def test_a_hovercraft_is_no_lily(runs: Runs) -> None:
    """Neither by itself nor as the sound vehicle has anything a name: the model does not follow its readings.

    A thrust gain of 48 had been told of it, and a centre of mass that differs with 92 %.
    """
    from cocorosim_ros.diagnosis.diagnose import diagnose

    (bag, *_) = runs("hovercraft_epfl")
    stranger = evidence_of([bag], "lily")
    for found in (diagnose(stranger, lambda words, share: None), compared(stranger, stranger)):
        assert (found.verdict, found.effects, found.recalibrated, found.manoeuvres) == ("insufficient", (), (), ())
        assert "does not follow" in found.sentence
        assert all("Check that the platform's file is of this vehicle" in each for each in found.reasons)


def test_a_gyroscope_that_is_off_is_named_with_its_number(runs: Runs) -> None:
    """Eight dives of a small AUV with 0.06 rad/s more differ in that alone from the eight between them."""
    from cocorosim_ros.diagnosis.evidence.streams.stream_columns import TURN_RATE

    reference = runs("haizhe_auv/reference")[:16]
    good, bad = (evidence_of(reference[half::2], "haizhe_auv") for half in (0, 1))

    def altered(robot: Any) -> Any:
        stream = robot.streams["imu"]
        value = stream.value.copy()
        value[:, TURN_RATE] += 0.06
        return replace(robot, streams={**robot.streams, "imu": replace(stream, value=value)})

    off = tuple(replace(each, robots=tuple(map(altered, each.robots))) for each in bad.recordings)
    found = compared(replace(bad, recordings=off), good)
    assert [each.id for each in found.effects] == ["imu_bias"] and found.recalibrated == ()
    # Its own offset differs by 0.003 rad/s between the two eights as they were recorded.
    assert found.effects[0].parameters["gyro_z"].value == pytest.approx(0.06, abs=0.005)
    assert found.effects[0].parameters["gyro_z"].low > 0.05
