"""The folder of outcomes: what is kept, what is done again, and what is refused."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.diagnosis.fleet.outcome import Outcome, outcome_from
from cocorosim_ros.diagnosis.fleet.recordings import FleetRecording
from cocorosim_ros.diagnosis.fleet.store import FleetStore, Order
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform

LILY = load_platform("lily")
Make = Callable[..., Any]


def order(tmp_path: Path, **other: Any) -> Order:
    """What is asked for."""
    return Order(**{"fleet": tmp_path / "fleet", "platform": LILY, "version": "1"} | other)


def recording(made: Outcome) -> FleetRecording:
    """The recording that an outcome is of."""
    return FleetRecording(made.recording, Path("fleet", made.recording), made.files)


@pytest.fixture
def made(outcome: Make) -> list[Outcome]:
    """Three outcomes."""
    names = ("week_1/a", "week_1/b", "week_2/a.mcap")
    return [replace(outcome(name, "lily_01", 0.0, {"drag": (0.0, 0.01)}), version="1") for name in names]


def test_what_is_kept_is_found_again(made: list[Outcome], tmp_path: Path) -> None:
    """As it was, by another process too; what is half written is nothing."""
    store = FleetStore(tmp_path / "out", order(tmp_path))
    for each in made[:2]:
        store.add(each)
    half = tmp_path / "out" / "outcomes" / "week_2" / "a.mcap.json.new"
    half.parent.mkdir()
    half.write_text('{"recording": "week', "utf-8")
    again = FleetStore(tmp_path / "out", order(tmp_path))
    found = again.found([recording(each) for each in made])
    assert found.outcomes == {each.recording: each for each in made[:2]}
    assert (found.changed, found.again, half.exists()) == ((), (), False)
    assert again.left_over([recording(made[0])]) == 1


def test_what_is_done_again(made: list[Outcome], tmp_path: Path) -> None:
    """A recording that was written since, one whose processes died, one whose outcome is damaged."""
    store = FleetStore(tmp_path / "out", order(tmp_path))
    store.add(made[0])
    store.add(replace(made[1], found={}, problem="It was given up.", again=True))
    (tmp_path / "out" / "outcomes" / "week_2").mkdir()
    (tmp_path / "out" / "outcomes" / "week_2" / "a.mcap.json").write_text("{}", "utf-8")
    changed = replace(recording(made[0]), files=(replace(made[0].files[0], size=2),))
    found = store.found([changed, *map(recording, made[1:])])
    assert (found.outcomes, found.changed, found.again) == ({}, ("week_1/a",), ("week_1/b", "week_2/a.mcap"))


@pytest.mark.parametrize(
    ("other", "words"),
    [
        ({"fleet": Path("elsewhere")}, "of another fleet, .*fleet, not of .*elsewhere"),
        ({"platform": load_platform("jeff")}, "with the platform 'lily', not with 'jeff'"),
        ({"platform": replace(LILY, mass=0.5)}, "with the platform 'lily' as it was: its numbers"),
        ({"version": "2"}, "of version 1 of the program, this is 2"),
    ],
)
def test_outcomes_of_something_else_are_not_mixed(
    made: list[Outcome], tmp_path: Path, other: dict[str, Any], words: str
) -> None:
    """Refused in a sentence, and started again where that is asked for."""
    FleetStore(tmp_path / "out", order(tmp_path)).add(made[0])
    with pytest.raises(CocorosimError, match=f"{words}.*'out', or 'force' to start again"):
        FleetStore(tmp_path / "out", order(tmp_path, **other))
    store = FleetStore(tmp_path / "out", order(tmp_path, **other), force=True)
    assert store.found([recording(made[0])]).outcomes == {}


def test_folders_that_hold_something_else(made: list[Outcome], tmp_path: Path) -> None:
    """Other files, a file in place of a folder, a note that is none: not touched."""
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.tex").write_text("x", "utf-8")
    (tmp_path / "file").write_text("x", "utf-8")
    FleetStore(tmp_path / "out", order(tmp_path))
    (tmp_path / "out" / "fleet.json").write_text("x", "utf-8")
    for name, words in (
        ("mine", "holds 'thesis.tex', which is no part of a fleet's diagnosis"),
        ("file", "is a file, or lies below one"),
        ("out", "does not say which fleet the outcomes beside it belong to"),
    ):
        for force in (False, *((True,) if name != "out" else ())):
            with pytest.raises(CocorosimError, match=words):
                FleetStore(tmp_path / name, order(tmp_path), force=force)
    assert (tmp_path / "mine" / "thesis.tex").read_text("utf-8") == "x"


def test_a_worker_with_other_code(made: list[Outcome], tmp_path: Path) -> None:
    """Its outcome is not kept, and both versions are named."""
    store = FleetStore(tmp_path / "out", order(tmp_path, version="2"))
    with pytest.raises(CocorosimError, match="A worker has version 1 of the program, this is 2"):
        store.add(made[0])
    assert store.found([recording(made[0])]).outcomes == {}


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"files": [], "recording": "a", "colour": 1}', '{"files": 3}'])
def test_texts_that_are_no_outcome(text: str) -> None:
    """Each is a ValueError, by which its recording is diagnosed again."""
    with pytest.raises(ValueError, match=r"no outcome|neither|Expecting"):
        outcome_from(text)
