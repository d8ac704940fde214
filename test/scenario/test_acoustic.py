"""The sound of a scenario: what it may say, and the sentences for what it may not."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario

SHIPPED = "config/scenarios/acoustic_slots.yaml"


def changed(folder: Path, old: str, new: str) -> Path:
    """The shipped scenario with something else in one place."""
    text = (Path(__file__).parents[2] / SHIPPED).read_text()
    assert text.count(old) == 1
    path = folder / "scenario.yaml"
    path.write_text(text.replace(old, new))
    return path


def test_the_same_after_yaml_and_back() -> None:
    """With and without a slot."""
    scenario = load_scenario("acoustic_slots")
    assert parse_scenario(scenario.to_yaml(), scenario.origin) == scenario
    assert scenario.acoustic is not None
    assert (scenario.acoustic.sound_speed, scenario.acoustic.slot_ns) == (1500.0, 500_000_000)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("range: 50 m", "range: 58 m", "'acoustic.range' has '58 m', farther than the 57.83 m from corner to corner"),
        ("  duration: 100 ms", "  frequency: 50 Hz", "'acoustic.frequency' has '50 Hz', for which no absorption"),
        ("  duration: 100 ms", "  frequency: 2000 kHz", "holds from 0.1 to 1000 kHz"),
        ("  duration: 100 ms", "  temperature: 36 degC", "holds from -6 to 35 degC"),
        ("  duration: 100 ms", "  salinity: 60 g/kg", "holds from 0 to 50 g/kg"),
        ("  duration: 100 ms", "  acidity: 7", "holds from 7.7 to 8.3 (pH)"),
        ("slot: 0.5 s", "slot: 0.7 s", "'acoustic.slot' has '0.7 s', which is not a whole number of ticks"),
        ("duration: 100 ms", "duration: 480 ms", "choose a slot of 0.5133 s or more"),
        ("duration: 100 ms", "sound_speed: 1 mm/s", "more than 1000 ticks"),
        ("duration: 100 ms", "bandwidth: 60 kHz", "reaches below zero"),
        ("duration: 100 ms", "duration: 0 s", "must be greater than zero"),
        ("acoustic:\n  range: 50 m\n  duration: 100 ms\n  slot: 0.5 s\n", "", "which speaks or hears by sound"),
    ],
)
def test_sentences(tmp_path: Path, old: str, new: str, words: str) -> None:
    """A range beyond the tank, numbers outside the law of absorption, slots that do not fit."""
    with pytest.raises(CocorosimError, match=re.escape(words)):
        load_scenario(changed(tmp_path, old, new))


def test_a_class_that_speaks_by_sound_needs_it_too(tmp_path: Path) -> None:
    """A controller in plain Python is told so before a run begins, with its own file and line."""
    from cocorosim_ros.world.controllers.plain.plain_controller import check_plain

    (tmp_path / "own.py").write_text(
        "class Mine:\n    medium = 'acoustic'\n\n    def __call__(self, sensed):\n        return {}\n"
    )
    quiet = changed(tmp_path, "acoustic:\n  range: 50 m\n  duration: 100 ms\n  slot: 0.5 s\n", "")
    with pytest.raises(CocorosimError, match=r"own\.py:4: 'Mine' speaks or hears by sound"):
        check_plain(load_scenario(quiet, controller=f"{tmp_path / 'own.py'}:Mine").robots)
    check_plain(load_scenario("acoustic_slots", controller=f"{tmp_path / 'own.py'}:Mine").robots)
