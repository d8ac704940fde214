"""What is no path, no text and no whole number is refused by a sentence that names the argument."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import cocorosim_ros as cocorosim
from cocorosim_ros.foundation.errors import CocorosimError

NO_PATHS = (None, 5, [], {})


@pytest.mark.parametrize("wrong", NO_PATHS, ids=repr)
@pytest.mark.parametrize(
    ("argument", "call"),
    [
        ("source", lambda wrong, out: cocorosim.load_scenario(wrong)),
        ("path", lambda wrong, out: cocorosim.read_recording(wrong)),
        ("map", lambda wrong, out: cocorosim.convert(wrong, "logs", out)),
        ("source", lambda wrong, out: cocorosim.convert("haizhe_auv", wrong, out)),
        ("out", lambda wrong, out: cocorosim.record("one_lily", wrong)),
        ("design", cocorosim.run_design),
        ("out", lambda wrong, out: cocorosim.run_design("smoke", wrong)),
        ("bags", lambda wrong, out: cocorosim.diagnose([wrong] if wrong == [] else wrong, "lily")),
        ("platform", lambda wrong, out: cocorosim.diagnose("bag", wrong)),
    ],
)
def test_what_is_no_path(argument: str, call: Callable[[Any, Path], Any], wrong: Any, tmp_path: Path) -> None:
    """The sentence names the argument and what it has, and nothing is written."""
    with pytest.raises(CocorosimError, match=f"'{argument}' has") as raised:
        call(wrong, tmp_path / "out")
    assert repr(wrong) in str(raised.value)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("wrong", [0, -1, 1.5, "2", float("nan"), True], ids=repr)
def test_what_is_no_number_of_runs(wrong: Any, tmp_path: Path) -> None:
    """For a design as a record: as the design's own file would be refused, before a folder is made."""
    design = cocorosim.load_design("smoke")
    with pytest.raises(CocorosimError, match="'replicates' has"):
        cocorosim.run_design(design, tmp_path / "out", replicates=wrong)
    assert not (tmp_path / "out").exists()


def test_a_pattern_is_one_text() -> None:
    """Not a list of letters."""
    scenario = cocorosim.load_scenario("eleven_lilys", external="lily_*")
    assert all(robot.external for robot in scenario.robots)
